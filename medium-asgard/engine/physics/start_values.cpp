#include "physics/start_values.h"

#include "expression/tape.h"
#include "physics/holds.h"

#include <array>
#include <limits>

namespace physics {

StartValues::StartValues(const Graph& g, const scene::Scene& scene, const Scope& scope)
    : g_(g), scene_(scene), scope_(scope) {
    for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
        if (scene.bodies[b].fixed)
            continue;
        for (std::size_t i = 0; i < 3; ++i)
            entries_.emplace(scope.body(b).position[i].index, Entry{b, i});
        for (std::size_t i = 0; i < 4; ++i)
            entries_.emplace(scope.body(b).attitude[i].index, Entry{b, 3 + i});
    }
}

double StartValues::of(Node node) {
    const std::vector<Node> inputs = expression::symbolsOf(g_, std::span(&node, 1));
    std::vector<double> values;
    for (const Node symbol : inputs) {
        const auto entry = entries_.find(symbol.index);
        if (symbol == scope_.time()) {
            values.push_back(scene_.simulator.start);
        } else if (entry == entries_.end()) {
            values.push_back(std::numeric_limits<double>::quiet_NaN());
        } else {
            const geometry::Pose& pose = poseOf(entry->second.body);
            const Quaternion& q = pose.attitude;
            const std::array<double, 7> all{pose.position.x(),
                                            pose.position.y(),
                                            pose.position.z(),
                                            q.w(),
                                            q.x(),
                                            q.y(),
                                            q.z()};
            values.push_back(all[entry->second.index]);
        }
    }
    double value = 0;
    expression::Tape::Scratch scratch;
    expression::Tape(g_, inputs, std::span(&node, 1))
        .evaluate(values, std::span(&value, 1), scratch);
    return value;
}

Vector StartValues::of(const NodeVector& nodes) {
    return {of(nodes[0]), of(nodes[1]), of(nodes[2])};
}

const geometry::Pose& StartValues::poseOf(std::size_t body) {
    if (const auto known = poses_.find(body); known != poses_.end())
        return known->second;
    const scene::Body& written = scene_.bodies[body];
    const Vector& centroid = scope_.mass(body).centroid;
    geometry::Pose pose{Vector::Zero(), written.initialAttitude.normalized()};
    pose.position = written.initialPosition + pose.attitude * centroid;
    std::vector<std::string> told; // by those that make the equations
    HoldSegment held;
    for (const HoldSegment& segment : segmentsOf(scene_, scope_, body, {}, told))
        if (segment.from <= scene_.simulator.start)
            held = segment;
    if (held.angular && !held.angular->isRate)
        pose.attitude = geometry::fromRotationVector(of(held.angular->value));
    const Vector arm = pose.attitude * centroid;
    for (std::size_t i = 0; i < 3; ++i)
        if (held.linear[i] && !held.linear[i]->isVelocity) {
            const int axis = static_cast<int>(i);
            pose.position[axis] = of(held.linear[i]->value) + arm[axis];
        }
    return poses_.emplace(body, pose).first->second;
}

} // namespace physics
