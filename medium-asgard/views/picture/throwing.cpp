#include "picture/throwing.h"

#include "gestures/present.h"
#include "gestures/wireframe.h"
#include "picture/scene_display.h"

#include <QMouseEvent>
#include <QPainter>

#include <algorithm>
#include <set>

namespace views {

using geometry::Vector;

namespace {

constexpr double lately = 0.1; // s: how the hand moved before it let go

// The leader from which no hand could take it: "led by path way"; "": nothing leads it.
QString leaderOf(const scene::Scene& scene, const std::string& body) {
    const auto one = std::ranges::find(scene.constraints, body, &scene::Constraint::body);
    return one == scene.constraints.end()
               ? QString()
               : QObject::tr("led by the path %1").arg(QString::fromStdString(one->trajectory));
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

// In the upright or level plane through a place of the body.
Vector Throwing::under(const QPointF& position, const Vector& through) const {
    return display_.sight().across(display_.inPixels(position), through);
}

double Throwing::moment() const {
    return gestures::roundMoment(*document_.shown().motion, display_.time());
}

// Null: nothing holds it.
std::unique_ptr<gestures::Joined> Throwing::joinedAt(std::size_t body,
                                                     const QPointF& position) const {
    const Shown& shown = document_.shown();
    const Vector place = render::poseOf(*shown.scene, shown.motion.get(), body, moment()).position;
    return gestures::Joined::of(gestures::sceneAt(document_.ground(), moment()), body,
                                under(position, place));
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
    const Shown& shown = document_.shown();
    const scene::Body& one = shown.scene->bodies[body];
    if (!shown.motion || display_.time() <= shown.motion->start() || one.fixed ||
        !document_.sceneIsCurrent() || document_.motionIsStale())
        return std::nullopt;
    if (const QString leader = leaderOf(*shown.scene, one.name); !leader.isEmpty())
        return tr("%1 is %2: it is neither thrown nor put elsewhere on its way. Its place at the "
                  "start can be dragged there.")
            .arg(QString::fromStdString(one.name), leader);
    const std::string why = gestures::whyNotAt(*shown.scene, shown.motion, moment());
    return QString::fromStdString(why.empty() ? whyHeld(body, position) : why);
}

bool Throwing::takesAtOnce(std::size_t body, const QPointF& position) const {
    return plays_ && whyNot(body, position) == QString();
}

// Empty: it goes alone, or one of them is not free to go.
std::vector<std::pair<std::size_t, geometry::Pose>>
Throwing::companyOf(std::size_t body, const QPointF& position) const {
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
    std::vector<std::pair<std::size_t, geometry::Pose>> company;
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
    const Shown& shown = document_.shown();
    display_.keepCamera();
    const geometry::Pose pose = render::poseOf(*shown.scene, shown.motion.get(), body, moment());
    held_.emplace(Held{document_.ground(),
                       moment(),
                       body,
                       pose,
                       pose.position - under(position, pose.position),
                       {},
                       joinedAt(body, position),
                       companyOf(body, position)});
    if (held_->joined)
        held_->joined->keep([limits = gestures::JointLimits(held_->ground, held_->time)](
                                const gestures::Joined& joined) {
            std::vector<gestures::Put> puts;
            for (const std::size_t one : joined.bodies()) {
                const geometry::Pose there = joined.poseOf(one);
                puts.push_back({one, there.position, std::nullopt, 0, there.attitude});
            }
            return limits.areKept(puts);
        });
    rate_.reset();
    Q_EMIT grabbed();
    return true;
}

bool Throwing::move(const QMouseEvent& event) {
    if (!held_)
        return false;
    held_->way.push_back(
        {secondsOf(event), under(event.position(), held_->pose.position) + held_->off});
    if (held_->joined) {
        const Vector way = held_->way.back().place - held_->pose.position;
        held_->joined->isLoose() ? held_->joined->moveAll(way) : held_->joined->pull(way);
    }
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

std::vector<gestures::Put> Throwing::handPuts(Held& held, double resolution,
                                              const std::optional<Vector>& velocity) {
    std::vector<gestures::Put> puts;
    const Vector way = held.way.back().place - held.pose.position;
    for (const auto& [body, pose] : held.company)
        puts.push_back({body, pose.position + way, std::nullopt, resolution});
    if (!puts.empty())
        return puts;
    if (!held.joined)
        return {{held.body, held.way.back().place, velocity, resolution}};
    for (const editing::NewPlace& one : held.joined->thrown(velocity))
        puts.push_back({one.body, one.pose.position, one.velocity->linear, 0, one.pose.attitude,
                        one.velocity->angular});
    return puts;
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
    const double resolution = display_.sight().pixelLength(held_->pose.position);
    const auto thrown = rate_ ? std::optional(velocity(secondsOf(event))) : std::nullopt;
    Held held = *std::exchange(held_, std::nullopt);
    const editing::Answer answer =
        gestures::startingAt(held.ground, held.time, handPuts(held, resolution, thrown));
    const QString name = nameOf(held);
    if (answer.possible()) {
        document_.setText(text::applied(held.ground.text, answer.edits),
                          (rate_ ? tr("Throw %1 at %2 s") : tr("Put %1 Elsewhere at %2 s"))
                              .arg(name)
                              .arg(held.time));
        const std::string anew = gestures::countsAnew(held.ground, held.time);
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

// "b1", "b1 and 2 more".
QString Throwing::nameOf(const Held& held) {
    const QString name = QString::fromStdString(held.ground.scene->bodies[held.body].name);
    return held.company.size() > 1 ? tr("%1 and %2 more").arg(name).arg(held.company.size() - 1)
                                   : name;
}

QString Throwing::words() const {
    if (!held_)
        return {};
    const QString name = nameOf(*held_);
    return rate_ ? tr("Let go to throw %1  ·  Escape: it goes on as it was").arg(name)
                 : tr("Let go to put %1 here, from %2 s on  ·  Escape: it goes on as it was")
                       .arg(name)
                       .arg(held_->time);
}

void Throwing::paintBody(QPainter& painter, std::size_t body, const geometry::Pose& pose) const {
    const gestures::Sight sight = display_.sight();
    const scene::Scene& scene = *held_->ground.scene;
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
    if (!held_ || held_->way.empty())
        return;
    const gestures::Sight sight = display_.sight();
    geometry::Pose there = held_->pose;
    there.position = held_->way.back().place;
    painter.setPen(QPen(QColor(20, 90, 200), 1.5));
    painter.setBrush(Qt::NoBrush);
    if (!held_->company.empty()) {
        for (auto [body, pose] : held_->company) {
            pose.position += there.position - held_->pose.position;
            paintBody(painter, body, pose);
        }
    } else if (!held_->joined) {
        paintBody(painter, held_->body, there);
    } else {
        there = held_->joined->poseOf(held_->body);
        for (const std::size_t body : held_->joined->bodies())
            paintBody(painter, body, held_->joined->poseOf(body));
    }
    painter.setPen(QPen(QColor(20, 90, 200), 1.5, Qt::DashLine));
    painter.drawLine(display_.fromPixels(sight.pixels(held_->pose.position)),
                     display_.fromPixels(sight.pixels(there.position)));
}

} // namespace views
