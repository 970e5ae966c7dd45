#include "scene/difference.h"

#include <bit>
#include <string_view>
#include <unordered_map>

namespace scene {
namespace {

// Bit for bit: 0 and -0 are two values, and no number is the same as itself.
bool same(double a, double b) {
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}
bool same(const Vector& a, const Vector& b) {
    return same(a.x(), b.x()) && same(a.y(), b.y()) && same(a.z(), b.z());
}
bool same(const Quaternion& a, const Quaternion& b) {
    return same(a.w(), b.w()) && same(a.x(), b.x()) && same(a.y(), b.y()) && same(a.z(), b.z());
}
bool same(const std::string& a, const std::string& b) { return a == b; }
bool same(const SpringLaw& a, const SpringLaw& b);
template <typename Value, std::size_t n>
bool same(const std::array<Value, n>& a, const std::array<Value, n>& b);
template <typename Value> bool same(const std::vector<Value>& a, const std::vector<Value>& b);
template <typename Value> bool same(const std::optional<Value>& a, const std::optional<Value>& b) {
    return a.has_value() == b.has_value() && (!a || same(*a, *b));
}
bool same(const SphereShape& a, const SphereShape& b) { return same(a.radius, b.radius); }
bool same(const BoxShape& a, const BoxShape& b) { return same(a.edges, b.edges); }
bool same(const HullShape& a, const HullShape& b) { return same(a.points, b.points); }
template <typename Round> bool sameRound(const Round& a, const Round& b) {
    return same(a.radius, b.radius) && same(a.height, b.height);
}
bool same(const CylinderShape& a, const CylinderShape& b) { return sameRound(a, b); }
bool same(const ConeShape& a, const ConeShape& b) { return sameRound(a, b); }
bool same(const CapsuleShape& a, const CapsuleShape& b) { return sameRound(a, b); }
bool same(const EllipsoidShape& a, const EllipsoidShape& b) { return same(a.axes, b.axes); }
bool same(const PlaneShape&, const PlaneShape&) { return true; }
bool same(const TubeShape& a, const TubeShape& b) {
    return same(a.inner, b.inner) && same(a.outer, b.outer) && same(a.height, b.height);
}
bool same(const BowlShape& a, const BowlShape& b) {
    return same(a.inner, b.inner) && same(a.outer, b.outer);
}
bool same(const ComponentForce& a, const ComponentForce& b) {
    return a.frame == b.frame && same(a.components, b.components);
}
bool same(const TrajectoryForce& a, const TrajectoryForce& b) {
    return a.trajectory == b.trajectory;
}
bool same(const GravitationalForce& a, const GravitationalForce& b) {
    return same(a.acceleration, b.acceleration);
}
bool same(const BodyEnd& a, const BodyEnd& b) {
    return a.body == b.body && same(a.offset, b.offset);
}
bool same(const PointEnd& a, const PointEnd& b) { return same(a.coordinates, b.coordinates); }
bool same(const TrajectoryEnd& a, const TrajectoryEnd& b) { return a.trajectory == b.trajectory; }
template <typename... Kinds>
bool same(const std::variant<Kinds...>& a, const std::variant<Kinds...>& b) {
    return a.index() == b.index() &&
           std::visit(
               [&b](const auto& value) {
                   return same(value, std::get<std::decay_t<decltype(value)>>(b));
               },
               a);
}
bool same(const Part& a, const Part& b) {
    return same(a.shape, b.shape) && same(a.position, b.position) && same(a.rotation, b.rotation) &&
           same(a.density, b.density);
}
bool same(const Force& a, const Force& b) {
    return a.couple == b.couple && same(a.offset, b.offset) && same(a.kind, b.kind) &&
           same(a.release, b.release);
}
bool same(const SpringLaw& a, const SpringLaw& b) {
    return same(a.rest, b.rest) && a.isPullOnly == b.isPullOnly;
}
bool same(const Link& a, const Link& b) {
    return same(a.first, b.first) && same(a.second, b.second) && same(a.tightness, b.tightness) &&
           same(a.damping, b.damping) && same(a.spring, b.spring) && same(a.release, b.release);
}
bool same(const JointCoordinate& a, const JointCoordinate& b) {
    return same(a.lower, b.lower) && same(a.upper, b.upper) &&
           same(a.limitRestitution, b.limitRestitution) && same(a.motor, b.motor) &&
           same(a.speed, b.speed) && same(a.position, b.position) && same(a.maxMotor, b.maxMotor) &&
           same(a.stiffness, b.stiffness) && same(a.rest, b.rest) && same(a.damping, b.damping) &&
           same(a.friction, b.friction) && same(a.from, b.from) && a.isGiven == b.isGiven;
}
bool same(const Joint& a, const Joint& b) {
    return a.type == b.type && a.body1 == b.body1 && same(a.offset1, b.offset1) &&
           same(a.body2, b.body2) && same(a.offset2, b.offset2) && same(a.axis, b.axis) &&
           same(a.axis2, b.axis2) && same(a.pitch, b.pitch) && same(a.coordinates, b.coordinates) &&
           same(a.release, b.release);
}
bool same(const Gear::Term& a, const Gear::Term& b) {
    return a.joint == b.joint && a.coordinate == b.coordinate && same(a.ratio, b.ratio);
}
bool same(const Gear& a, const Gear& b) {
    return same(a.terms, b.terms) && same(a.release, b.release);
}
bool same(const Rope::Point& a, const Rope::Point& b) {
    return same(a.body, b.body) && same(a.place, b.place) && same(a.radius, b.radius) &&
           same(a.axis, b.axis);
}
bool same(const Rope& a, const Rope& b) {
    return same(a.points, b.points) && same(a.length, b.length) &&
           same(a.restitution, b.restitution) && a.isClosed == b.isClosed &&
           same(a.release, b.release);
}
bool same(const Contact& a, const Contact& b) {
    return a.name == b.name && a.body1 == b.body1 && a.body2 == b.body2 &&
           same(a.friction, b.friction) && same(a.staticFriction, b.staticFriction) &&
           same(a.rollingFriction, b.rollingFriction) && same(a.restitution, b.restitution) &&
           a.collides == b.collides;
}
bool same(const BezierCurve& a, const BezierCurve& b) {
    return same(a.from, b.from) && same(a.to, b.to) && same(a.control, b.control);
}
bool same(const Constraint& a, const Constraint& b) {
    return a.held == b.held && a.trajectory == b.trajectory && same(a.from, b.from) &&
           same(a.to, b.to);
}
bool same(const Body& a, const Body& b) {
    return same(a.initialPosition, b.initialPosition) &&
           same(a.initialAttitude, b.initialAttitude) &&
           same(a.initialVelocity, b.initialVelocity) &&
           same(a.initialAngularVelocity, b.initialAngularVelocity) && same(a.mass, b.mass) &&
           same(a.inertia, b.inertia) && same(a.center, b.center) && same(a.density, b.density) &&
           same(a.restitution, b.restitution) && same(a.friction, b.friction) &&
           same(a.staticFriction, b.staticFriction) && same(a.rollingFriction, b.rollingFriction) &&
           same(a.surfaceVelocity, b.surfaceVelocity) && a.fixed == b.fixed &&
           a.countsTurns == b.countsTurns && a.collisionGroup == b.collisionGroup;
}
template <typename Value, std::size_t n>
bool same(const std::array<Value, n>& a, const std::array<Value, n>& b) {
    for (std::size_t i = 0; i < n; ++i)
        if (!same(a[i], b[i]))
            return false;
    return true;
}
template <typename Value> bool same(const std::vector<Value>& a, const std::vector<Value>& b) {
    if (a.size() != b.size())
        return false;
    for (std::size_t i = 0; i < a.size(); ++i)
        if (!same(a[i], b[i]))
            return false;
    return true;
}

// The element of the same name in the scene before, for each; by place where nothing was added.
template <typename Element>
std::vector<std::size_t> matched(const std::vector<Element>& now,
                                 const std::vector<Element>& before) {
    std::vector<std::size_t> found(now.size(), noElement);
    std::unordered_map<std::string_view, std::size_t> index;
    for (std::size_t i = 0; i < now.size(); ++i) {
        if (i < before.size() && now[i].name == before[i].name) {
            found[i] = i;
            continue;
        }
        if (index.empty())
            for (std::size_t k = 0; k < before.size(); ++k)
                index.try_emplace(before[k].name, k);
        if (const auto place = index.find(now[i].name); place != index.end())
            found[i] = place->second;
    }
    return found;
}

class Comparison {
public:
    Comparison(const Version& before, const Version& after)
        : old_(*before.scene), now_(*after.scene), a_(before.connections), b_(after.connections),
          shapes_(matched(now_.shapeSets, old_.shapeSets)),
          trajectories_(matched(now_.trajectories, old_.trajectories)),
          parameters_(matched(now_.parameters, old_.parameters)),
          joints_(matched(now_.joints, old_.joints)), springs_(matched(now_.links, old_.links)),
          ropes_(matched(now_.ropes, old_.ropes)),
          contacts_(matched(now_.contacts, old_.contacts)) {
        result_.before = matched(now_.bodies, old_.bodies);
        for (std::size_t i = 0; i < shapes_.size(); ++i)
            if (shapes_[i] != noElement &&
                !same(now_.shapeSets[i].parts, old_.shapeSets[shapes_[i]].parts))
                shapes_[i] = noElement;
        for (std::size_t i = 0; i < trajectories_.size(); ++i)
            if (trajectories_[i] != noElement &&
                !same(now_.trajectories[i].curves, old_.trajectories[trajectories_[i]].curves))
                trajectories_[i] = noElement;
        for (std::size_t i = 0; i < parameters_.size(); ++i)
            if (parameters_[i] != noElement &&
                !same(now_.parameters[i].value, old_.parameters[parameters_[i]].value))
                parameters_[i] = noElement;
        for (std::size_t i = 0; i < joints_.size(); ++i)
            if (joints_[i] != noElement && !same(now_.joints[i], old_.joints[joints_[i]]))
                joints_[i] = noElement;
        for (std::size_t i = 0; i < springs_.size(); ++i)
            if (springs_[i] != noElement && !same(now_.links[i], old_.links[springs_[i]]))
                springs_[i] = noElement;
        for (std::size_t i = 0; i < ropes_.size(); ++i)
            if (ropes_[i] != noElement && !same(now_.ropes[i], old_.ropes[ropes_[i]]))
                ropes_[i] = noElement;
        for (std::size_t i = 0; i < contacts_.size(); ++i)
            if (contacts_[i] != noElement && !same(now_.contacts[i], old_.contacts[contacts_[i]]))
                contacts_[i] = noElement;
    }

    Difference find() {
        const std::size_t count = now_.bodies.size();
        result_.after.assign(old_.bodies.size(), noElement);
        result_.changed.resize(count);
        result_.moved.resize(count);
        for (std::size_t b = 0; b < count; ++b) {
            const std::size_t was = result_.before[b];
            if (was != noElement)
                result_.after[was] = b;
            result_.changed[b] = was == noElement || !isSame(b, was);
        }
        // A fixed body that is read elsewhere.
        for (const Mention& mention : b_.mentionList)
            if (mention.kind == Mention::Kind::body && now_.bodies[mention.index].fixed &&
                result_.changed[mention.index])
                result_.changed[mention.reader] = true;
        return std::move(result_);
    }

private:
    bool isSame(std::size_t b, std::size_t was) {
        const Body &body = now_.bodies[b], &old = old_.bodies[was];
        bool moved = body.source.line != old.source.line;
        const bool isSame =
            same(body, old) && hasSameShape(b, was) &&
            areSame(now_.forces, b_.forces.of(b), old_.forces, a_.forces.of(was), moved) &&
            areSame(now_.links, b_.firstEnds.of(b), old_.links, a_.firstEnds.of(was), moved) &&
            areSame(now_.links, b_.secondEnds.of(b), old_.links, a_.secondEnds.of(was), moved) &&
            areSame(now_.joints, b_.joints.of(b), old_.joints, a_.joints.of(was), moved) &&
            areSame(now_.gears, b_.gears.of(b), old_.gears, a_.gears.of(was), moved) &&
            areSame(now_.ropes, b_.ropes.of(b), old_.ropes, a_.ropes.of(was), moved) &&
            areSame(now_.contacts, b_.contacts.of(b), old_.contacts, a_.contacts.of(was), moved) &&
            areSame(now_.constraints, b_.constraints.of(b), old_.constraints,
                    a_.constraints.of(was), moved) &&
            mentionsSame(b, was);
        result_.moved[b] = moved;
        return isSame;
    }

    bool hasSameShape(std::size_t b, std::size_t was) const {
        const std::size_t shape = b_.shapes[b];
        return shape != noElement && shapes_[shape] != noElement &&
               shapes_[shape] == a_.shapes[was];
    }

    template <typename Element>
    static bool areSame(const std::vector<Element>& now, std::span<const std::size_t> elements,
                        const std::vector<Element>& before, std::span<const std::size_t> old,
                        bool& moved) {
        if (elements.size() != old.size())
            return false;
        for (std::size_t i = 0; i < elements.size(); ++i) {
            if (!same(now[elements[i]], before[old[i]]))
                return false;
            moved = moved || now[elements[i]].source.line != before[old[i]].source.line;
        }
        return true;
    }

    // The same words may name something else now.
    bool mentionsSame(std::size_t b, std::size_t was) const {
        const auto now = b_.mentions.of(b), old = a_.mentions.of(was);
        if (now.size() != old.size())
            return false;
        for (std::size_t i = 0; i < now.size(); ++i) {
            const Mention &m = b_.mentionList[now[i]], &n = a_.mentionList[old[i]];
            if (m.kind != n.kind || matchesOf(m.kind)[m.index] != n.index)
                return false;
        }
        return true;
    }

    [[nodiscard]] const std::vector<std::size_t>& matchesOf(Mention::Kind kind) const {
        switch (kind) {
        case Mention::Kind::trajectory:
            return trajectories_;
        case Mention::Kind::parameter:
            return parameters_;
        case Mention::Kind::joint:
            return joints_;
        case Mention::Kind::spring:
            return springs_;
        case Mention::Kind::rope:
            return ropes_;
        case Mention::Kind::contact:
            return contacts_;
        case Mention::Kind::body:
            break;
        }
        return result_.before;
    }

    const Scene &old_, &now_;
    const Connections &a_, &b_;
    // By element: the one before with the same content; noElement: none, or it differs.
    std::vector<std::size_t> shapes_, trajectories_, parameters_, joints_, springs_, ropes_,
        contacts_;
    Difference result_;
};

} // namespace

Difference differenceBetween(const Version& before, const Version& after) {
    return Comparison(before, after).find();
}

bool sameButFinish(const Simulator& a, const Simulator& b) {
    return same(a.start, b.start) && same(a.firstStep, b.firstStep) &&
           same(a.accuracy, b.accuracy) && a.method == b.method && a.collisions == b.collisions;
}

} // namespace scene
