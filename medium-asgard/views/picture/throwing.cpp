#include "picture/throwing.h"

#include "gestures/present.h"
#include "gestures/wireframe.h"
#include "picture/scene_display.h"

#include <QMouseEvent>
#include <QPainter>

#include <algorithm>

namespace views {

using geometry::Vector;

namespace {

constexpr double lately = 0.1; // s: how the hand moved before it let go

// What a hand could not take it away from: "led by path way"; "": nothing holds it.
QString holderOf(const scene::Scene& scene, const std::string& body) {
    const auto named = [](const char* kind, const std::string& name) {
        return QObject::tr(kind).arg(QString::fromStdString(name));
    };
    for (const scene::Constraint& one : scene.constraints)
        if (one.body == body)
            return named("led by the path %1", one.trajectory);
    for (const scene::Joint& one : scene.joints)
        if (one.body1 == body || one.body2 == body)
            return named("held by the joint %1", one.name);
    for (const scene::Rope& one : scene.ropes)
        if (std::ranges::find(one.points, body, &scene::Rope::Point::body) != one.points.end())
            return named("held by the rope %1", one.name);
    return {};
}

double secondsOf(const QMouseEvent& event) { return 1e-3 * static_cast<double>(event.timestamp()); }

} // namespace

Throwing::Throwing(SceneDocument& document, SceneDisplay& display)
    : document_(document), display_(display) {
    connect(&document_, &SceneDocument::textChanged, this, [this] {
        if (cancel())
            display_.editing().say(SceneDocument::overtaken());
    });
}

// In the upright or level plane through the body.
Vector Throwing::under(const QPointF& position) const {
    return display_.sight().across(display_.inPixels(position), held_->pose.position);
}

bool Throwing::isOnItsWay(std::size_t body) const {
    const Shown& shown = document_.shown();
    return shown.motion && display_.time() > shown.motion->start() &&
           !shown.scene->bodies[body].fixed && document_.sceneIsCurrent() &&
           !document_.motionIsStale();
}

bool Throwing::takesAtOnce(std::size_t body) const {
    const scene::Scene& scene = *document_.shown().scene;
    return plays_ && isOnItsWay(body) && holderOf(scene, scene.bodies[body].name).isEmpty();
}

bool Throwing::press(std::size_t body, const QPointF& position) {
    const Shown& shown = document_.shown();
    if (!isOnItsWay(body))
        return false;
    const std::string& name = shown.scene->bodies[body].name;
    if (const QString holder = holderOf(*shown.scene, name); !holder.isEmpty()) {
        display_.editing().say(
            tr("%1 is %2: it is neither thrown nor put elsewhere on its way. Its place at the "
               "start can be dragged there.")
                .arg(QString::fromStdString(name), holder));
        return true;
    }
    const double time = gestures::roundMoment(*shown.motion, display_.time());
    display_.keepCamera();
    held_.emplace(Held{document_.ground(),
                       time,
                       body,
                       render::poseOf(*shown.scene, shown.motion.get(), body, time),
                       Vector::Zero(),
                       {}});
    held_->off = held_->pose.position - under(position);
    rate_.reset();
    Q_EMIT grabbed();
    return true;
}

bool Throwing::move(const QMouseEvent& event) {
    if (!held_)
        return false;
    held_->way.push_back({secondsOf(event), under(event.position()) + held_->off});
    Q_EMIT changed();
    return true;
}

Vector Throwing::velocity(double seconds) const {
    const auto& way = held_->way;
    const auto first = std::ranges::find_if(
        way, [&](const Moment& one) { return one.seconds >= seconds - lately; });
    if (first == way.end() || !rate_)
        return Vector::Zero(); // the hand was still
    const Moment& from = first == way.begin() ? *first : *(first - 1);
    const double lasted = std::max(seconds - std::max(from.seconds, seconds - lately), 1e-2);
    return (way.back().place - from.place) / lasted / *rate_;
}

bool Throwing::release(const QMouseEvent& event) {
    if (!held_)
        return false;
    if (event.button() != Qt::LeftButton)
        return true;
    if (held_->way.empty()) {
        cancel();
        return true;
    }
    gestures::Put put{held_->body, held_->way.back().place, std::nullopt,
                      display_.sight().pixelLength(held_->pose.position)};
    if (rate_)
        put.velocity = velocity(secondsOf(event));
    const Held held = *std::exchange(held_, std::nullopt);
    const editing::Answer answer = gestures::startingAt(held.ground, held.time, put);
    const QString name = QString::fromStdString(held.ground.scene->bodies[held.body].name);
    if (answer.possible())
        document_.setText(text::applied(held.ground.text, answer.edits),
                          (rate_ ? tr("Throw %1 at %2 s") : tr("Put %1 Elsewhere at %2 s"))
                              .arg(name)
                              .arg(held.time));
    else
        display_.editing().say(QString::fromStdString(answer.reason));
    Q_EMIT changed();
    Q_EMIT letGo(answer.possible());
    return true;
}

bool Throwing::cancel() {
    if (!held_)
        return false;
    held_.reset();
    Q_EMIT changed();
    Q_EMIT letGo(false);
    return true;
}

QString Throwing::words() const {
    if (!held_)
        return {};
    const QString name = QString::fromStdString(held_->ground.scene->bodies[held_->body].name);
    return rate_ ? tr("Let go to throw %1  ·  Escape: it goes on as it was").arg(name)
                 : tr("Let go to put %1 here, from %2 s on  ·  Escape: it goes on as it was")
                       .arg(name)
                       .arg(held_->time);
}

// The body as it would be, and where it comes from.
void Throwing::paint(QPainter& painter) const {
    if (!held_ || held_->way.empty())
        return;
    const gestures::Sight sight = display_.sight();
    const scene::Scene& scene = *held_->ground.scene;
    const scene::ShapeSet* shape = scene::findShapeSet(scene, scene.bodies[held_->body].shape);
    const Vector place = held_->way.back().place;
    const auto at = [&](const Vector& point) { return display_.fromPixels(sight.pixels(point)); };
    painter.setPen(QPen(QColor(20, 90, 200), 1.5));
    painter.setBrush(Qt::NoBrush);
    if (shape)
        for (const auto& line : gestures::wireframeOf(shape->parts)) {
            QPolygonF drawn;
            for (const Vector& point : line)
                drawn.append(at(place + held_->pose.attitude * point));
            painter.drawPolyline(drawn);
        }
    painter.setPen(QPen(QColor(20, 90, 200), 1.5, Qt::DashLine));
    painter.drawLine(at(held_->pose.position), at(place));
}

} // namespace views
