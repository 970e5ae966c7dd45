#include "physics/joint_kinematics.h"

#include "scene/joint_types.h"

#include <algorithm>
#include <numbers>

namespace physics {

using scene::JointType;

JetVector JointKinematics::apart(const JointFrame& frame, const Along& along) {
    return points_.apart(frame.ends[0], frame.ends[1], along);
}

NodeVector JointKinematics::pointOf(std::size_t joint, std::size_t end) {
    return points_.placeOf(frames_[joint].ends[end]);
}

JetVector JointKinematics::turning(const JointFrame& frame, const Along& along) {
    return points_.turning(frame.ends[0], frame.ends[1], along);
}

std::vector<Jet> JointKinematics::conditions(std::size_t joint, const Along& along) {
    const scene::Joint& said = scene_.joints[joint];
    const JointFrame& frame = frames_[joint];
    const auto& [first, second] = frame.ends;
    const JetVector d = apart(frame, along), n1 = carried(first, first.axis, along),
                    n2 = carried(second, second.axis, along),
                    e1 = carried(first, first.across, along),
                    e2 = carried(second, second.across, along),
                    f2 = carried(second, second.third, along);
    std::vector<Jet> made;
    const auto meet = [&] {
        for (std::size_t i = 0; i < 3; ++i)
            made.push_back({d.value[i], d.rate[i], d.second[i]});
    };
    const auto turnAbout = [&](const JetVector& a, const JetVector& b) {
        made.push_back(scaled(g_, frame.size, product(g_, a, b)));
    };
    const auto slide = [&] {
        made.push_back(product(g_, e2, d));
        made.push_back(product(g_, f2, d));
    };
    switch (said.type) {
    case JointType::fixed:
    case JointType::hinge:
    case JointType::ball:
    case JointType::universal:
        meet();
        break;
    case JointType::slider:
    case JointType::cylindrical:
    case JointType::screw:
        slide();
        break;
    case JointType::planar:
        made.push_back(product(g_, n2, d));
        break;
    case JointType::distance:
        if (scene::isRigidDistance(said))
            made.push_back(difference(g_, length(g_, d), constantJet(g_, frame.start[0])));
        return made;
    }
    if (said.type == JointType::ball)
        return made;
    turnAbout(n1, said.type == JointType::universal ? n2 : e2);
    if (said.type == JointType::universal)
        return made;
    turnAbout(n1, f2);
    if (said.type == JointType::fixed || said.type == JointType::slider)
        turnAbout(e1, f2);
    if (said.type == JointType::screw) {
        const double perAngle = said.pitch / (2 * std::numbers::pi);
        const Jet slid = difference(g_, product(g_, n2, d), constantJet(g_, frame.start[0]));
        made.push_back(difference(g_, slid, scaled(g_, perAngle, gone(joint, 0, along))));
    }
    return made;
}

Jet JointKinematics::angleOf(const JointFrame& frame, std::size_t k, const JetVector& axis,
                             const Along& along) {
    const JetVector spin = turning(frame, along);
    const Node q = frame.angles[k];
    Node second = g_.add(dot(g_, axis.rate, spin.value), dot(g_, axis.value, spin.rate));
    // The tie moves the angle without the bodies, and so the conditions that read it.
    if (const auto tie = ties_.find(q.index); along.set && tie != ties_.end())
        second = g_.add(second, tie->second);
    return {q, dot(g_, axis.value, spin.value), second};
}

Jet JointKinematics::coordinate(std::size_t joint, std::size_t k, const Along& along) {
    const auto& said = scene_.joints[joint].coordinates;
    const double from = k < said.size() ? said[k].from : 0;
    return sum(g_, gone(joint, k, along), constantJet(g_, from));
}

Jet JointKinematics::gone(std::size_t joint, std::size_t k, const Along& along) {
    const JointFrame& frame = frames_[joint];
    const JointEnd &first = frame.ends[0], &second = frame.ends[1];
    const auto carriedBySecond = [&](const Vector& v) { return carried(second, v, along); };
    const auto slid = [&](const Vector& direction) {
        return difference(g_, product(g_, carriedBySecond(direction), apart(frame, along)),
                          constantJet(g_, frame.start[k]));
    };
    switch (scene_.joints[joint].type) {
    case JointType::distance:
        return length(g_, apart(frame, along));
    case JointType::ball:
        return ballAngle(frame, along);
    case JointType::universal:
        return angleOf(frame, k,
                       k == 0 ? carried(first, first.axis, along) : carriedBySecond(second.axis),
                       along);
    case JointType::slider:
        return slid(second.axis);
    case JointType::cylindrical:
        if (k == 1)
            return slid(second.axis);
        break;
    case JointType::planar:
        if (k < 2)
            return slid(k == 0 ? second.across : second.third);
        break;
    case JointType::hinge:
    case JointType::screw:
    case JointType::fixed:
        break;
    }
    return angleOf(frame, k, carriedBySecond(second.axis), along);
}

// With a and b the three axes of the first and of the second body, which agree at the start,
//     sin q  axis = sum b x a / 2,     cos q = (sum a.b - 1) / 2.
Jet JointKinematics::ballAngle(const JointFrame& frame, const Along& along) {
    const auto& [first, second] = frame.ends;
    NodeVector axis = constant(g_, Vector::Zero());
    Node trace = g_.constant(-1);
    const std::array<Vector JointEnd::*, 3> axes{&JointEnd::axis, &JointEnd::across,
                                                 &JointEnd::third};
    for (const auto of : axes) {
        const NodeVector a = carried(first, first.*of, along).value,
                         b = carried(second, second.*of, along).value;
        axis = add(g_, axis, cross(g_, b, a));
        trace = g_.add(trace, dot(g_, a, b));
    }
    const Node sine = g_.apply(Op::sqrt, dot(g_, axis, axis));
    const NodeVector spin = turning(frame, along).value;
    const Node zero = g_.constant(0);
    const Node rate =
        g_.apply(Op::select, g_.apply(Op::equal, sine, zero),
                 g_.apply(Op::sqrt, dot(g_, spin, spin)), g_.divide(dot(g_, spin, axis), sine));
    return {g_.apply(Op::atan2, sine, trace), rate, zero};
}

// c sin q - s cos q, where s and c are the sine and the cosine of the angle between the bodies.
Jet JointKinematics::tie(std::size_t joint, std::size_t k, const Along& along) {
    const JointFrame& frame = frames_[joint];
    const auto& [first, second] = frame.ends;
    const JetVector e1 = carried(first, first.across, along),
                    e2 = carried(second, second.across, along);
    Jet sine, cosine;
    if (scene_.joints[joint].type == JointType::universal) {
        const JetVector a1 = carried(first, first.axis, along),
                        a2 = carried(second, second.axis, along);
        cosine = k == 0 ? product(g_, e1, a2) : product(g_, a1, e2);
        sine = k == 0 ? product(g_, e1, cross(g_, a1, a2)) : product(g_, a1, cross(g_, a2, e2));
    } else {
        cosine = product(g_, e1, e2);
        sine = product(g_, e1, carried(second, second.third, along));
    }
    const Node q = frame.angles[k];
    const Node sinQ = g_.apply(Op::sin, q), cosQ = g_.apply(Op::cos, q);
    const Node rateOfQ = g_.add(coordinate(joint, k, along).rate, ties_.at(q.index));
    const auto size = g_.constant(frame.size);
    const Node gap = g_.subtract(g_.multiply(cosine.value, sinQ), g_.multiply(sine.value, cosQ));
    const Node moved = g_.subtract(g_.multiply(cosine.rate, sinQ), g_.multiply(sine.rate, cosQ));
    const Node turned = g_.multiply(
        rateOfQ, g_.add(g_.multiply(sine.value, sinQ), g_.multiply(cosine.value, cosQ)));
    return {g_.multiply(size, gap), g_.multiply(size, g_.add(moved, turned)), {}};
}

} // namespace physics
