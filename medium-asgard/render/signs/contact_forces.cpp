#include "signs/contact_forces.h"

#include "drawing/overlay.h"
#include "drawing/round_numbers.h"
#include "framing/extent.h"
#include "scene/contact_pairs.h"
#include "scene/shape_of.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

namespace render {

namespace {

constexpr std::size_t mostBodies = 60;
constexpr int readings = 7; // of a pair: n, fx, fy, fz, px, py, pz

double reachOf(const scene::Scene& scene, const scene::Body& body) {
    double reach = 0;
    for (const Ball& ball : outlineOf(scene, body))
        reach = std::max(reach, ball.center.norm() + ball.radius);
    const scene::ShapeSet* shape = scene::findShapeSet(scene, body.shape);
    for (const scene::Part& part : shape ? shape->parts : std::vector<scene::Part>{})
        if (std::holds_alternative<scene::PlaneShape>(part.shape))
            return std::numeric_limits<double>::infinity();
    return reach;
}

// The pairs that ever come near each other, one of which moves.
std::vector<std::pair<std::size_t, std::size_t>> nearPairs(const scene::Scene& scene,
                                                           const simulation::Motion& motion) {
    const std::size_t count = std::min({scene.bodies.size(), motion.bodies(), mostBodies});
    std::vector<double> reach;
    for (std::size_t i = 0; i < count; ++i)
        reach.push_back(reachOf(scene, scene.bodies[i]));
    constexpr int times = 60;
    std::vector<std::vector<Vector>> places(count);
    for (int k = 0; k <= times; ++k)
        for (std::size_t i = 0; i < count; ++i)
            places[i].push_back(
                motion
                    .shapePose(i, motion.start() + (motion.computed() - motion.start()) * k / times)
                    .position);
    std::vector<std::pair<std::size_t, std::size_t>> pairs;
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t j = i + 1; j < count; ++j) {
            if (scene.bodies[i].fixed && scene.bodies[j].fixed)
                continue;
            for (int k = 0; k <= times; ++k)
                if ((places[i][static_cast<std::size_t>(k)] -
                     places[j][static_cast<std::size_t>(k)])
                        .norm() <= 1.2 * (reach[i] + reach[j])) {
                    pairs.emplace_back(i, j);
                    break;
                }
        }
    return pairs;
}

// A name for the pair's contact, which gets one where the scene gives none: then `isNew`.
std::string nameOfContact(scene::Scene& scene, const std::string& one, const std::string& other,
                          bool& isNew) {
    const auto found = std::ranges::find_if(scene.contacts, [&](const scene::Contact& contact) {
        return (contact.body1 == one && contact.body2 == other) ||
               (contact.body1 == other && contact.body2 == one);
    });
    scene::Contact& contact =
        found == scene.contacts.end() ? scene.contacts.emplace_back() : *found;
    // As the pair is told here, whichever way the scene has it.
    contact.body1 = one;
    contact.body2 = other;
    if (contact.name.empty()) {
        contact.name = "contact_of_" + std::to_string(&contact - scene.contacts.data());
        isNew = true;
    }
    return contact.name;
}

// A motion keeps the forces of contacts that have names: here all have.
simulation::MotionPointer computedAgain(const scene::Scene& named,
                                        const simulation::Motion& motion) {
    using Clock = std::chrono::steady_clock;
    const auto late = Clock::now() + std::chrono::seconds(2);
    simulation::Options options;
    options.finish = motion.computed();
    return simulation::simulate(named, options, {[late] { return Clock::now() > late; }, {}, {}})
        .motion;
}

// The surface's normal where the force presses on it: of the two bodies that whose face agrees
// better with the normal force.
Vector normalOf(const std::vector<std::optional<geometry::Shape>>& shapes,
                const simulation::Motion& motion, const ContactForce& one, double normalForce,
                double time) {
    const Vector way = one.force.normalized();
    Vector best = way;
    double least = std::numeric_limits<double>::infinity();
    for (const std::size_t body : {one.first, one.second}) {
        const std::optional<geometry::Shape>& shape = shapes[body];
        if (!shape)
            continue;
        const geometry::Pose pose = motion.shapePose(body, time);
        const double side = body == one.first ? -1 : 1; // outwards, from its surface
        const double away = 0.01 * std::min(1.0, geometry::radiusAbout(*shape, Vector::Zero()));
        const auto hit = geometry::castRay(*shape, pose.toLocal(one.point + side * away * way),
                                           pose.attitude.conjugate() * (-side * way));
        if (!hit || hit->distance > 4 * away)
            continue;
        const Vector normal = side * (pose.attitude * hit->normal);
        const double off = std::abs(one.force.dot(normal) - normalForce);
        if (off < least) {
            least = off;
            best = normal;
        }
    }
    return best;
}

} // namespace

void ContactForces::follow(const scene::Scene& scene, const simulation::MotionPointer& motion) {
    of_ = motion;
    quantities_.reset();
    pairs_.clear();
    if (!motion)
        return;
    pairs_ = nearPairs(scene, *motion);
    shapes_.clear();
    for (const scene::Body& body : scene.bodies) {
        const scene::ShapeSet* set = scene::findShapeSet(scene, body.shape);
        shapes_.emplace_back();
        if (set != nullptr)
            if (auto made = scene::shapeOf(*set); auto* shape = std::get_if<geometry::Shape>(&made))
                shapes_.back() = std::move(*shape);
    }
    scene::Scene named = scene;
    std::vector<std::string> expressions;
    bool isNew = false; // the motion has no readings of one of them
    for (const auto& [i, j] : pairs_) {
        const std::string name =
            nameOfContact(named, scene.bodies[i].name, scene.bodies[j].name, isNew);
        for (const char* reading : {".n", ".fx", ".fy", ".fz", ".px", ".py", ".pz"})
            expressions.push_back(name + reading);
    }
    read_ = isNew ? computedAgain(named, *motion) : motion;
    std::vector<std::string> faults;
    if (!expressions.empty() && read_)
        quantities_.emplace(named, simulation::Options{}, read_, expressions, faults);
    double weight = 0, moving = 0;
    for (std::size_t i = 0; i < std::min(scene.bodies.size(), motion->bodies()); ++i)
        if (!scene.bodies[i].fixed && std::isfinite(motion->mass(i))) {
            weight += 9.81 * motion->mass(i);
            ++moving;
        }
    scale_ = roundBelow(weight > 0 ? 0.65 * std::sqrt(moving) / weight : 0.65);
}

std::vector<ContactForce> ContactForces::at(const scene::Scene& scene,
                                            const simulation::MotionPointer& motion, double time) {
    if (of_.lock() != motion || !motion)
        follow(scene, motion);
    const scene::ContactPairs laws(scene);
    std::vector<ContactForce> forces;
    if (!quantities_ || !motion || time > read_->computed())
        return forces;
    const std::vector<double> values =
        quantities_->at(std::clamp(time, read_->start(), read_->computed()));
    for (std::size_t k = 0; k < pairs_.size(); ++k) {
        const double* v = &values[readings * k];
        ContactForce one{pairs_[k].first,          pairs_[k].second, Vector(v[4], v[5], v[6]),
                         Vector(v[1], v[2], v[3]), Vector::Zero(),   0};
        if (!(std::isfinite(v[0]) && v[0] > 0) || !one.point.allFinite() ||
            !one.force.allFinite() || one.force.isZero(0) || one.second >= scene.bodies.size())
            continue;
        one.normal = normalOf(shapes_, *motion, one, v[0], time);
        one.friction = laws.lawOf(one.first, one.second).sticking;
        forces.push_back(one);
    }
    return forces;
}

void addContactForces(Lines& lines, const std::vector<ContactForce>& forces,
                      const scene::Scene& scene, double scale, const Frame& frame,
                      const Display& display) {
    const Ink ink{{0.78F, 0.20F, 0.30F}, 0.95F, frame.stroke(2.2)};
    const double perForce = scale / frame.camera().scale;
    for (const ContactForce& one : forces) {
        const double side = scene.bodies[one.first].fixed ? -1 : 1;
        if (display.contactForces)
            addArrow(lines, frame, one.point, one.point + side * perForce * one.force, ink);
        if (!display.frictionCones || !(one.friction > 0))
            continue;
        constexpr int sides = 40;
        const double height = perForce * one.force.dot(one.normal);
        const Vector axis = side * one.normal, u = axis.unitOrthogonal(), v = axis.cross(u);
        const double radius = height * one.friction;
        Ink faint{{0.85F, 0.55F, 0.15F}, 0.55F, frame.stroke(1.1)};
        Vector last = one.point + height * axis + radius * u;
        for (int i = 1; i <= sides; ++i) {
            const double angle = 2 * M_PI * i / sides;
            const Vector next =
                one.point + height * axis + radius * (std::cos(angle) * u + std::sin(angle) * v);
            lines.add(frame.toView(last), frame.toView(next), faint);
            if (i % 5 == 0)
                lines.add(frame.toView(one.point), frame.toView(next), faint);
            last = next;
        }
    }
}

} // namespace render
