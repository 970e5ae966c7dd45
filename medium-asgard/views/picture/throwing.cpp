#include "picture/throwing.h"

#include "gestures/wireframe.h"
#include "picture/scene_display.h"

#include <QMouseEvent>
#include <QPainter>

#include <algorithm>
#include <set>

namespace views {

using geometry::Vector;

namespace {

double secondsOf(const QMouseEvent& event) { return 1e-3 * static_cast<double>(event.timestamp()); }

} // namespace

Throwing::Throwing(SceneDocument& document, SceneDisplay& display)
    : document_(document), display_(display) {
    connect(&document_, &SceneDocument::textChanged, this, [this] {
        if (cancel())
            display_.editing().say(SceneDocument::overtaken());
    });
}

double Throwing::moment() const {
    return gestures::roundMoment(*document_.shown().motion, display_.time());
}

// Null: nothing holds it.
std::unique_ptr<gestures::Joined> Throwing::joinedAt(std::size_t body,
                                                     const QPointF& position) const {
    return gestures::joinedAt(document_.ground(), moment(), body, display_.sight(),
                              display_.inPixels(position));
}

const std::string& Throwing::whyHeld(std::size_t body, const QPointF& position) const {
    const auto& motion = document_.shown().motion;
    const bool isKnown = asked_ && asked_->motion == motion && asked_->body == body &&
                         (plays_ || (asked_->moment == moment() && asked_->position == position));
    if (!isKnown) {
        const auto joined = joinedAt(body, position);
        asked_ = {motion, body, moment(), position, joined ? joined->whyNotThrown() : ""};
    }
    return asked_->why;
}

std::optional<QString> Throwing::whyNot(std::size_t body, const QPointF& position) const {
    if (!document_.sceneIsCurrent() || document_.motionIsStale())
        return std::nullopt;
    const auto why = gestures::whyNotTaken(document_.ground(), display_.time(), body);
    if (!why)
        return std::nullopt;
    return QString::fromStdString(why->empty() ? whyHeld(body, position) : *why);
}

bool Throwing::takesAtOnce(std::size_t body, const QPointF& position) const {
    return plays_ && whyNot(body, position) == QString();
}

// Empty: it goes alone, or one of them is not free to go.
gestures::Throw::Poses Throwing::companyOf(std::size_t body, const QPointF& position) const {
    std::vector<std::size_t> taken = display_.editing().companyOf(body);
    if (plays_ || taken.empty())
        return {};
    taken.insert(taken.begin(), body);
    const Shown& shown = document_.shown();
    std::set<std::size_t> all;
    for (const std::size_t one : taken) {
        const auto joined = joinedAt(one, position);
        if (whyNot(one, position) != QString() || (joined && !joined->isLoose()))
            return {};
        all.insert(one);
        if (joined)
            all.insert(joined->bodies().begin(), joined->bodies().end());
    }
    gestures::Throw::Poses company;
    company.reserve(all.size());
    for (const std::size_t one : all)
        company.emplace_back(one, render::poseOf(*shown.scene, shown.motion.get(), one, moment()));
    return company;
}

bool Throwing::press(std::size_t body, const QPointF& position) {
    const auto fault = whyNot(body, position);
    if (!fault)
        return false;
    if (!fault->isEmpty()) {
        display_.editing().say(*fault);
        return true;
    }
    display_.keepCamera();
    held_.emplace(document_.ground(), moment(), body, display_.sight(), display_.inPixels(position),
                  companyOf(body, position));
    rate_.reset();
    Q_EMIT grabbed();
    return true;
}

bool Throwing::move(const QMouseEvent& event) {
    if (!held_)
        return false;
    held_->move(display_.sight(), display_.inPixels(event.position()), secondsOf(event));
    Q_EMIT changed();
    return true;
}

bool Throwing::release(const QMouseEvent& event) {
    if (!held_)
        return false;
    if (event.button() != Qt::LeftButton)
        return true;
    if (!held_->moved()) {
        cancel();
        return true;
    }
    gestures::Throw held = *std::exchange(held_, std::nullopt);
    const editing::Answer answer = held.answer(display_.sight(), rate_, secondsOf(event));
    if (answer.possible()) {
        document_.setText(text::applied(held.ground().text, answer.edits),
                          (rate_ ? tr("Throw %1 at %2 s") : tr("Put %1 Elsewhere at %2 s"))
                              .arg(QString::fromStdString(held.name()))
                              .arg(held.moment()));
        const std::string anew = gestures::countsAnew(held.ground(), held.moment());
        display_.editing().say(QString::fromStdString(anew), false);
    } else {
        display_.editing().say(QString::fromStdString(answer.reason));
    }
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
    const QString name = QString::fromStdString(held_->name());
    return rate_ ? tr("Let go to throw %1  ·  Escape: it goes on as it was").arg(name)
                 : tr("Let go to put %1 here, from %2 s on  ·  Escape: it goes on as it was")
                       .arg(name)
                       .arg(held_->moment());
}

void Throwing::paintBody(QPainter& painter, std::size_t body, const geometry::Pose& pose) const {
    const gestures::Sight sight = display_.sight();
    const scene::Scene& scene = *held_->ground().scene;
    const scene::ShapeSet* shape = scene::findShapeSet(scene, scene.bodies[body].shape);
    if (!shape)
        return;
    for (const auto& line : gestures::wireframeOf(shape->parts)) {
        QPolygonF drawn;
        for (const Vector& point : line)
            drawn.append(display_.fromPixels(sight.pixels(pose.toWorld(point))));
        painter.drawPolyline(drawn);
    }
}

// The body as it would be with what is joined to it, and where it comes from.
void Throwing::paint(QPainter& painter) const {
    if (!held_ || !held_->moved())
        return;
    const gestures::Sight sight = display_.sight();
    painter.setPen(QPen(QColor(20, 90, 200), 1.5));
    painter.setBrush(Qt::NoBrush);
    for (const auto& [body, pose] : held_->poses())
        paintBody(painter, body, pose);
    const auto [from, to] = held_->way();
    painter.setPen(QPen(QColor(20, 90, 200), 1.5, Qt::DashLine));
    painter.drawLine(display_.fromPixels(sight.pixels(from)),
                     display_.fromPixels(sight.pixels(to)));
}

} // namespace views
