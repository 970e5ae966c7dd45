#include "editing/fingerprint.h"

#include <bit>
#include <cstdint>

namespace editing {

namespace {

// Values one after another. Texts and lists come with their length, choices with their number, so
// that no two different elements are written alike.
class Writer {
public:
    template <class... Values> Writer& add(const Values&... values) {
        (put(values), ...);
        return *this;
    }
    std::string take() { return std::move(out_); }

private:
    void put(double value) { out_ += std::to_string(std::bit_cast<std::uint64_t>(value)) + ','; }
    void put(bool value) { out_ += value ? "y," : "n,"; }
    void put(int value) { out_ += std::to_string(value) + ','; }
    void put(const std::string& text) { out_ += std::to_string(text.size()) + ':' + text; }
    void put(const scene::Vector& v) { add(v.x(), v.y(), v.z()); }
    void put(const scene::Quaternion& q) { add(q.w(), q.x(), q.y(), q.z()); }
    void put(const scene::Color& c) { add(c.red, c.green, c.blue); }
    void put(const scene::Appearance& a) { add(a.color, a.shininess, a.transparency); }
    void put(const scene::SphereShape& shape) { put(shape.radius); }
    void put(const scene::BoxShape& shape) { put(shape.edges); }
    void put(const scene::HullShape& shape) { put(shape.points); }
    void put(const scene::CylinderShape& shape) { putRound(shape); }
    void put(const scene::ConeShape& shape) { putRound(shape); }
    void put(const scene::CapsuleShape& shape) { putRound(shape); }
    void put(const scene::EllipsoidShape& shape) { put(shape.axes); }
    void put(const scene::PlaneShape&) {}
    void put(const scene::TubeShape& shape) { add(shape.inner, shape.outer, shape.height); }
    void put(const scene::BowlShape& shape) { add(shape.inner, shape.outer); }
    template <class Round> void putRound(const Round& shape) { add(shape.radius, shape.height); }
    void put(const scene::Part& p) {
        add(p.shape, p.position, p.rotation, p.appearance, p.density);
    }
    void put(const scene::ComponentForce& f) { add(f.components, static_cast<int>(f.frame)); }
    void put(const scene::TrajectoryForce& f) { put(f.trajectory); }
    void put(const scene::GravitationalForce& f) { put(f.acceleration); }
    void put(const scene::BodyEnd& end) { add(end.body, end.offset); }
    void put(const scene::PointEnd& end) { put(end.coordinates); }
    void put(const scene::TrajectoryEnd& end) { put(end.trajectory); }
    void put(const scene::SpringLaw& law) { add(law.rest, law.isPullOnly); }
    void put(const scene::JointCoordinate& c) {
        add(c.lower, c.upper, c.limitRestitution, c.motor, c.speed, c.position, c.maxMotor,
            c.stiffness, c.rest, c.damping, c.friction, c.from, c.isGiven);
    }
    void put(const scene::Gear::Term& t) { add(t.joint, static_cast<int>(t.coordinate), t.ratio); }
    void put(const scene::Rope::Point& p) { add(p.body, p.place, p.radius, p.axis); }
    void put(const scene::BezierCurve& c) { add(c.from, c.to, c.control); }
    template <class A, class B> void put(const std::pair<A, B>& p) { add(p.first, p.second); }
    template <class Value> void put(const std::optional<Value>& value) {
        put(value.has_value());
        if (value)
            put(*value);
    }
    template <class Value> void put(const std::vector<Value>& values) {
        put(static_cast<int>(values.size()));
        for (const Value& value : values)
            put(value);
    }
    template <class Value, std::size_t n> void put(const std::array<Value, n>& values) {
        for (const Value& value : values)
            put(value);
    }
    template <class... Kinds> void put(const std::variant<Kinds...>& value) {
        put(static_cast<int>(value.index()));
        std::visit([this](const auto& one) { put(one); }, value);
    }

    std::string out_;
};

void write(Writer& w, const scene::Simulator& s) {
    w.add(s.start, s.finish, s.firstStep, s.accuracy, s.method, s.collisions);
}
void write(Writer& w, const scene::ShapeSet& s) { w.add(s.name, s.parts, s.appearance); }
void write(Writer& w, const scene::Body& b) {
    w.add(b.name, b.shape, b.initialPosition, b.initialAttitude, b.initialVelocity,
          b.initialAngularVelocity, b.mass, b.inertia, b.center, b.density, b.restitution,
          b.friction, b.staticFriction, b.rollingFriction, b.surfaceVelocity, b.fixed,
          b.articulatedBody, b.collisionGroup, b.appearance);
}
void write(Writer& w, const scene::Force& f) {
    w.add(f.body, f.couple, f.offset, f.kind, f.release);
}
void write(Writer& w, const scene::Link& l) {
    w.add(l.name, l.first, l.second, l.tightness, l.damping, l.spring, l.release);
}
void write(Writer& w, const scene::Joint& j) {
    w.add(j.name, static_cast<int>(j.type), j.body1, j.offset1, j.body2, j.offset2, j.axis, j.axis2,
          j.pitch, j.coordinates, j.release);
}
void write(Writer& w, const scene::Gear& g) { w.add(g.name, g.terms, g.release); }
void write(Writer& w, const scene::Rope& r) {
    w.add(r.name, r.points, r.length, r.restitution, r.isClosed, r.release);
}
void write(Writer& w, const scene::Contact& c) {
    w.add(c.name, c.body1, c.body2, c.friction, c.staticFriction, c.rollingFriction, c.restitution,
          c.collides);
}
void write(Writer& w, const scene::Trajectory& t) { w.add(t.name, t.curves, t.points); }
void write(Writer& w, const scene::Constraint& c) {
    w.add(c.body, static_cast<int>(c.held), c.trajectory, c.from, c.to);
}
void write(Writer& w, const scene::LightSource& l) {
    w.add(l.name, l.direction, l.position, l.color);
}
void write(Writer& w, const scene::View& v) {
    w.add(v.name, v.position, v.rotation, v.center, v.scale, v.eye, v.look, v.up);
}
void write(Writer& w, const scene::Parameter& p) {
    w.add(p.name, p.value, p.minimum, p.maximum, p.label, p.unit);
}
void write(Writer& w, const scene::Plot& p) {
    w.add(p.name, p.values, p.labels, p.title, p.beside);
}

template <class List> std::string written(const List& list, std::size_t index) {
    Writer writer;
    write(writer, list.at(index));
    return writer.take();
}

} // namespace

std::string fingerprintOf(const scene::Scene& scene, const Element& element) {
    const std::size_t i = element.index;
    switch (element.kind) {
    case Kind::simulator:
        return written(std::vector{scene.simulator}, 0);
    case Kind::shapeSet:
        return written(scene.shapeSets, i);
    case Kind::body:
        return written(scene.bodies, i);
    case Kind::force:
        return written(scene.forces, i);
    case Kind::link:
        return written(scene.links, i);
    case Kind::joint:
        return written(scene.joints, i);
    case Kind::gear:
        return written(scene.gears, i);
    case Kind::rope:
        return written(scene.ropes, i);
    case Kind::contact:
        return written(scene.contacts, i);
    case Kind::trajectory:
        return written(scene.trajectories, i);
    case Kind::constraint:
        return written(scene.constraints, i);
    case Kind::light:
        return written(scene.lights, i);
    case Kind::view:
        return written(scene.views, i);
    case Kind::parameter:
        return written(scene.parameters, i);
    case Kind::plot:
        break;
    }
    return written(scene.plots, i);
}

std::string bodiesOf(const scene::Scene& scene, const Element& element) {
    switch (element.kind) {
    case Kind::force:
        return scene.forces[element.index].body;
    case Kind::constraint:
        return scene.constraints[element.index].body;
    case Kind::link: {
        const scene::Link& link = scene.links[element.index];
        const auto* other = std::get_if<scene::BodyEnd>(&link.second);
        return link.first.body + " " + (other ? other->body : "");
    }
    case Kind::joint: {
        const scene::Joint& joint = scene.joints[element.index];
        return joint.body1 + " " + joint.body2.value_or("");
    }
    case Kind::rope: {
        std::string bodies;
        for (const scene::Rope::Point& point : scene.ropes[element.index].points)
            bodies += point.body.value_or("") + " ";
        return bodies;
    }
    case Kind::contact:
        return scene.contacts[element.index].body1 + " " + scene.contacts[element.index].body2;
    default:
        return "";
    }
}

} // namespace editing
