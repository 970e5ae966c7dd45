#include "reports/acting.h"

#include "run/run.h"
#include "scene/joint_types.h"

#include <algorithm>
#include <cstdio>
#include <map>
#include <set>

namespace simulation {
namespace {

std::string number(double value) {
    char text[40];
    std::snprintf(text, sizeof text, "%.6g", value);
    return text;
}

std::string vectorText(const Vector& v) {
    return "{" + number(v.x()) + " " + number(v.y()) + " " + number(v.z()) + "}";
}

// "x = E, y = E" of what is not 0.
std::string componentsText(const std::array<scene::Expression, 3>& components) {
    static constexpr std::array<const char*, 3> axes = {"x", "y", "z"};
    std::string text;
    for (std::size_t i = 0; i < axes.size(); ++i)
        if (components[i] != "0")
            text += (text.empty() ? "" : ", ") + std::string(axes[i]) + " = " + components[i];
    std::ranges::replace_if(
        text, [](char c) { return c == '\n' || c == '\r' || c == '\t'; }, ' ');
    return text.empty() ? "0" : text;
}

std::string forceText(const scene::Force& force) {
    if (const auto* weight = std::get_if<scene::GravitationalForce>(&force.kind))
        return "gravity " + vectorText(weight->acceleration);
    const std::string what = force.couple ? "a couple" : "a force";
    const std::string where = force.offset ? " at " + vectorText(*force.offset) : "";
    if (const auto* course = std::get_if<scene::TrajectoryForce>(&force.kind))
        return what + " that follows trajectory " + course->trajectory + where;
    const auto& given = std::get<scene::ComponentForce>(force.kind);
    return what + ", " + componentsText(given.components) +
           (given.frame == scene::Frame::body ? ", along its own axes" : "") + where;
}

std::string linkText(const scene::Link& link, const std::string& body) {
    const auto* other = std::get_if<scene::BodyEnd>(&link.second);
    const auto* point = std::get_if<scene::PointEnd>(&link.second);
    std::string to;
    if (other)
        to = other->body == body ? link.first.body : other->body;
    else if (point)
        to = "the point " + componentsText(point->coordinates);
    else
        to = "trajectory " + std::get<scene::TrajectoryEnd>(link.second).trajectory;
    return (link.spring ? "a spring to " : "a link to ") + to +
           (link.spring ? " (stiffness " : " (tightness ") + number(link.tightness) + ")";
}

std::string holdText(const scene::Scene& scene, const scene::Constraint& constraint) {
    static constexpr std::array<const char*, 10> held = {
        "place", "attitude", "velocity", "spin", "x", "y", "z", "dx", "dy", "dz"};
    std::string text = "trajectory " + constraint.trajectory + ", which holds its " +
                       held[static_cast<std::size_t>(constraint.held)];
    const scene::Trajectory* course = scene::findTrajectory(scene, constraint.trajectory);
    if (!course)
        return text;
    // Between curves it holds nothing, unless it is told from when to when it does.
    std::vector<std::pair<double, double>> spans;
    for (const scene::BezierCurve& curve : course->curves) {
        if (!spans.empty() &&
            (curve.from <= spans.back().second || constraint.from || constraint.to))
            spans.back().second = curve.to;
        else
            spans.emplace_back(curve.from, curve.to);
    }
    if (!spans.empty()) {
        spans.front().first = constraint.from.value_or(spans.front().first);
        spans.back().second = constraint.to.value_or(spans.back().second);
    }
    constexpr std::size_t most = 3;
    for (std::size_t i = 0; i < std::min(spans.size(), most); ++i)
        text += std::string(i == 0 ? " from t = " : ", from ") + number(spans[i].first) + " to " +
                number(spans[i].second);
    if (spans.size() > most)
        text += ", and " + std::to_string(spans.size() - most) + " times more until " +
                number(spans.back().second);
    return text;
}

std::string jointText(const scene::Joint& joint, const std::string& body) {
    const std::string other = joint.body1 == body ? joint.body2.value_or("the world") : joint.body1;
    return std::string(scene::traitsOf(joint.type).name) + " joint " + joint.name + " to " + other;
}

std::string ropeText(const scene::Rope& rope, const std::string& body) {
    std::string others;
    for (const scene::Rope::Point& point : rope.points)
        if (point.body && *point.body != body &&
            (" " + others + ",").find(" " + *point.body + ",") == std::string::npos)
            others += (others.empty() ? "" : ", ") + *point.body;
    return "rope " + rope.name + (others.empty() ? "" : " with " + others);
}

class WhatActs {
public:
    WhatActs(const Problem& problem, const Run& run) : problem_(problem), run_(run) {
        for (const scene::Force& force : problem.scene.forces)
            add(force.body, forceText(force));
        for (const scene::Link& link : problem.scene.links) {
            add(link.first.body, linkText(link, link.first.body));
            if (const auto* other = std::get_if<scene::BodyEnd>(&link.second))
                add(other->body, linkText(link, other->body));
        }
        for (const scene::Joint& joint : problem.scene.joints) {
            add(joint.body1, jointText(joint, joint.body1));
            if (joint.body2)
                add(*joint.body2, jointText(joint, *joint.body2));
        }
        for (const scene::Gear& gear : problem.scene.gears)
            for (const std::string& body : bodiesOf(gear))
                add(body, "gear " + gear.name);
        for (const scene::Rope& rope : problem.scene.ropes) {
            std::set<std::string> bodies;
            for (const scene::Rope::Point& point : rope.points)
                if (point.body && bodies.insert(*point.body).second)
                    add(*point.body, ropeText(rope, *point.body));
        }
        for (const scene::Constraint& constraint : problem.scene.constraints)
            add(constraint.body, holdText(problem.scene, constraint));
        addImpacts();
        addSupports();
    }

    [[nodiscard]] std::vector<Acting> result() {
        std::vector<Acting> list;
        for (const scene::Body& body : problem_.scene.bodies)
            if (!body.fixed)
                list.push_back({body.name, std::move(what_[body.name])});
        return list;
    }

private:
    void add(const std::string& body, std::string what) { what_[body].push_back(std::move(what)); }
    [[nodiscard]] const std::string& nameOf(std::size_t body) const {
        return problem_.scene.bodies[body].name;
    }
    [[nodiscard]] std::set<std::string> bodiesOf(const scene::Gear& gear) const {
        std::set<std::string> bodies;
        for (const scene::Gear::Term& term : gear.terms)
            if (const scene::Joint* joint = scene::findJoint(problem_.scene, term.joint)) {
                bodies.insert(joint->body1);
                if (joint->body2)
                    bodies.insert(*joint->body2);
            }
        return bodies;
    }
    void addImpacts() {
        std::map<std::pair<std::size_t, std::size_t>, std::vector<double>> times;
        for (const Impact& impact : run_.impacts)
            for (const auto& [body, other] :
                 {std::pair(impact.first, impact.second), std::pair(impact.second, impact.first)})
                times[{body, other}].push_back(impact.time);
        for (const auto& [pair, when] : times)
            add(nameOf(pair.first),
                when.size() == 1
                    ? "an impact with " + nameOf(pair.second) + " at t = " + number(when[0])
                    : std::to_string(when.size()) + " impacts with " + nameOf(pair.second) +
                          ", the last at t = " + number(*std::ranges::max_element(when)));
    }
    void addSupports() {
        constexpr double still = 1e-9; // of its size, in a unit of time
        for (const auto& [body, supports] : run_.supports) {
            const BodyRecord& record = (*problem_.bodies)[body];
            const BodyState state =
                stateOf(record, *run_.histories, std::min(run_.reached, problem_.finish()));
            const bool slides = state.velocity.norm() > still * record.radius;
            for (const std::size_t support : supports)
                add(nameOf(body),
                    nameOf(support) + (slides ? ", on which it slides at the end, without friction"
                                              : ", on which it rests at the end"));
        }
    }

    const Problem& problem_;
    const Run& run_;
    std::map<std::string, std::vector<std::string>> what_;
};

} // namespace

std::vector<Acting> actingOn(const Problem& problem, const Run& run) {
    return WhatActs(problem, run).result();
}

} // namespace simulation
