#include "random_edit.h"

#include <algorithm>
#include <functional>
#include <set>

namespace edits {
namespace {

using scene::Body;
using scene::Scene;
using scene::Vector;

// A scene and dice.
class Editor {
public:
    Editor(Scene& scene, Random& random) : s(scene), random_(random) {}

    double between(double low, double high) {
        return low + (high - low) * (static_cast<double>(random_() >> 11) * 0x1p-53);
    }
    std::size_t below(std::size_t count) { return static_cast<std::size_t>(random_() % count); }
    bool once(std::size_t in) { return below(in) == 0; }
    Vector vector(double size) {
        const double a = between(-size, size), b = between(-size, size), c = between(-size, size);
        return {a, b, c};
    }
    template <typename Element> Element* any(std::vector<Element>& all) {
        return all.empty() ? nullptr : &all[below(all.size())];
    }
    // Mostly a little, sometimes a lot, sometimes to what it was.
    double scale() { return once(8) ? between(0.2, 4) : between(0.95, 1.05); }
    Vector shift() { return vector(once(4) ? 2 : 0.05); }

    std::string position() {
        Body* body = any(s.bodies);
        if (!body)
            return "";
        body->initialPosition += shift();
        return "position of " + body->name;
    }
    std::string velocity() {
        Body* body = any(s.bodies);
        if (!body)
            return "";
        body->initialVelocity += shift();
        return "velocity of " + body->name;
    }
    std::string turn() {
        Body* body = any(s.bodies);
        if (!body)
            return "";
        if (once(2))
            body->initialAngularVelocity += shift();
        else
            body->initialAttitude =
                (body->initialAttitude * geometry::fromRotationVector(vector(0.2))).normalized();
        return "attitude or spin of " + body->name;
    }
    std::string mass() {
        Body* body = any(s.bodies);
        if (!body)
            return "";
        if (once(3))
            body->density *= scale();
        else if (body->inertia && once(2))
            for (int i = 0; i < 3; ++i)
                (*body->inertia)[static_cast<std::size_t>(i)] *= 1.1;
        else
            body->mass = body->mass.value_or(1) * scale();
        return "mass of " + body->name;
    }
    std::string restitution() {
        Body* body = any(s.bodies);
        if (!body)
            return "";
        body->restitution = once(3) ? 1 : between(0, 1);
        return "restitution of " + body->name;
    }
    std::string group() {
        Body* body = any(s.bodies);
        if (!body)
            return "";
        if (once(2))
            body->collisionGroup.reset();
        else
            body->collisionGroup = static_cast<int>(below(3));
        return "collision group of " + body->name;
    }
    std::string fixed() {
        Body* body = any(s.bodies);
        if (!body || !once(3))
            return "";
        body->fixed = !body->fixed;
        return "fixedness of " + body->name;
    }
    std::string force() {
        scene::Force* force = any(s.forces);
        if (!force)
            return "";
        if (auto* weight = std::get_if<scene::GravitationalForce>(&force->kind))
            weight->acceleration += shift();
        else if (auto* kind = std::get_if<scene::ComponentForce>(&force->kind))
            plus(kind->components[below(3)]);
        else if (force->offset)
            *force->offset += shift();
        return "force on " + force->body;
    }
    std::string addForce() {
        Body* body = any(s.bodies);
        Body* other = any(s.bodies);
        if (!body)
            return "";
        scene::Force& force = s.forces.emplace_back();
        force.body = body->name;
        switch (below(4)) {
        case 0:
            force.kind = scene::GravitationalForce{vector(3)};
            return "add weight of " + body->name;
        case 1:
            force.kind = scene::ComponentForce{{"0.3", "-0.1*" + body->name + ".dy", "0"}};
            return "add drag on " + body->name;
        case 2:
            force.kind = scene::ComponentForce{{"0", "0.2*sin(3*t)", "0"}};
            force.couple = true;
            return "add couple on " + body->name;
        default:
            force.kind = scene::ComponentForce{{"0.1*" + other->name + ".x", "0", "0.05"}};
            return "add force on " + body->name + " by " + other->name;
        }
    }
    std::string removeForce() { return removed(s.forces, "remove force"); }
    std::string link() {
        scene::Link* link = any(s.links);
        if (!link)
            return "";
        switch (below(3)) {
        case 0:
            link->tightness *= scale();
            break;
        case 1:
            link->damping = between(0, 2);
            break;
        default:
            link->first.offset = link->first.offset.value_or(Vector::Zero()) + vector(0.02);
        }
        return "link of " + link->first.body;
    }
    std::string addLink() {
        Body* body = any(s.bodies);
        Body* other = any(s.bodies);
        if (!body || body->fixed || s.links.size() > 30)
            return "";
        scene::Link& link = s.links.emplace_back();
        link.first.body = body->name;
        link.tightness = between(1, 20);
        if (other != body && once(2))
            link.second = scene::BodyEnd{other->name, std::nullopt};
        else
            link.second = scene::PointEnd{{"0", "1", "0.1*t"}};
        return "add link of " + body->name;
    }
    std::string removeLink() { return removed(s.links, "remove link"); }
    std::string shape() {
        scene::ShapeSet* set = any(s.shapeSets);
        scene::Part* part = set ? any(set->parts) : nullptr;
        if (!part)
            return "";
        const double factor = scale();
        if (auto* sphere = std::get_if<scene::SphereShape>(&part->shape))
            sphere->radius *= factor;
        else if (auto* box = std::get_if<scene::BoxShape>(&part->shape))
            box->edges[static_cast<Eigen::Index>(below(3))] *= factor;
        else if (auto* hull = std::get_if<scene::HullShape>(&part->shape))
            for (Vector& point : hull->points)
                point *= factor;
        else if (auto* capsule = std::get_if<scene::CapsuleShape>(&part->shape))
            capsule->height *= factor;
        else if (auto* cylinder = std::get_if<scene::CylinderShape>(&part->shape))
            cylinder->radius *= factor;
        else if (auto* cone = std::get_if<scene::ConeShape>(&part->shape))
            cone->height *= factor;
        else if (auto* ellipsoid = std::get_if<scene::EllipsoidShape>(&part->shape))
            ellipsoid->axes[static_cast<Eigen::Index>(below(3))] *= factor;
        else
            part->position.y() += factor - 1;
        return "shape " + set->name;
    }
    std::string otherShape() {
        Body* body = any(s.bodies);
        scene::ShapeSet* set = any(s.shapeSets);
        if (!body || !set)
            return "";
        body->shape = set->name;
        return "other shape of " + body->name;
    }
    std::string trajectory() {
        scene::Trajectory* trajectory = any(s.trajectories);
        scene::BezierCurve* curve = trajectory ? any(trajectory->curves) : nullptr;
        Vector* point = curve ? any(curve->control) : nullptr;
        if (!point)
            return "";
        *point += shift();
        return "trajectory " + trajectory->name;
    }
    std::string constrain() {
        Body* body = any(s.bodies);
        if (!body || body->fixed)
            return "";
        if (!s.constraints.empty() && once(2))
            return removed(s.constraints, "remove constraint");
        const double start = s.simulator.start, span = s.simulator.finish - start;
        scene::Trajectory& path = s.trajectories.emplace_back();
        path.name = "path" + std::to_string(random_() % 1000000);
        path.curves.push_back({start + between(0, 0.5) * span,
                               start + between(0.5, 1) * span,
                               {body->initialPosition, body->initialPosition + vector(1)}});
        scene::Constraint& constraint = s.constraints.emplace_back();
        constraint.body = body->name;
        constraint.trajectory = path.name;
        constraint.held = once(2) ? scene::Held::position : scene::Held::dx;
        return "add constraint of " + body->name;
    }
    std::string parameter() {
        scene::Parameter* parameter = any(s.parameters);
        if (!parameter)
            return "";
        parameter->value = parameter->value * scale() + (once(5) ? 0.1 : 0);
        return "parameter " + parameter->name;
    }
    std::string add() {
        Body* model = any(s.bodies);
        if (!model || s.bodies.size() > 45)
            return "";
        Body body = *model;
        body.name = "new" + std::to_string(random_() % 1000000);
        body.initialPosition += vector(once(2) ? 20 : 2);
        const auto place = s.bodies.begin() + static_cast<std::ptrdiff_t>(below(s.bodies.size()));
        s.bodies.insert(once(2) ? s.bodies.end() : place, body);
        return "add body " + body.name;
    }
    std::string remove() {
        if (s.bodies.size() < 2 || !once(2))
            return "";
        const auto place = s.bodies.begin() + static_cast<std::ptrdiff_t>(below(s.bodies.size()));
        const std::string name = place->name;
        s.bodies.erase(place);
        std::erase_if(s.forces, [&](const auto& force) { return force.body == name; });
        std::erase_if(s.constraints, [&](const auto& c) { return c.body == name; });
        std::erase_if(s.links, [&](const auto& link) {
            const auto* end = std::get_if<scene::BodyEnd>(&link.second);
            return link.first.body == name || (end && end->body == name);
        });
        return "remove body " + name;
    }
    std::string finish() {
        if (!once(2))
            return "";
        scene::Simulator& simulator = s.simulator;
        const double span = simulator.finish - simulator.start;
        const double factor = once(3) ? between(0.2, 2.2) : once(2) ? 0.9 : 1 / 0.9;
        simulator.finish = simulator.start + span * factor;
        return "end time";
    }
    std::string accuracy() {
        if (!once(4))
            return "";
        s.simulator.accuracy = once(2) ? 1e-4 : 1e-3;
        return "accuracy";
    }
    std::string collisions() {
        if (!once(6))
            return "";
        s.simulator.collisions = !s.simulator.collisions;
        return "collisions";
    }
    std::string colour() {
        Body* body = any(s.bodies);
        if (!body)
            return "";
        body->appearance.color = scene::Color{between(0, 1), 0, 0};
        return "colour of " + body->name;
    }
    std::string lines() {
        const int by = static_cast<int>(below(3)) + 1;
        const std::size_t from = below(s.bodies.size() + 1);
        for (std::size_t b = from; b < s.bodies.size(); ++b)
            s.bodies[b].source.line += by;
        for (auto& force : s.forces)
            force.source.line += by;
        for (auto& link : s.links)
            link.source.line += by;
        return "lines";
    }
    std::string order() {
        if (s.bodies.size() < 2 || !once(3))
            return "";
        std::swap(s.bodies[below(s.bodies.size())], s.bodies[below(s.bodies.size())]);
        if (s.forces.size() > 1)
            std::swap(s.forces[below(s.forces.size())], s.forces[below(s.forces.size())]);
        return "order";
    }

private:
    void plus(std::string& text) {
        // The number that was added before gives way: texts do not grow without end.
        const std::size_t tail = text.rfind(" + 0.0");
        if (text.starts_with("(") && tail != std::string::npos)
            text = text.substr(1, tail - 2);
        text = "(" + text + ") + 0.0" + std::to_string(1 + below(98));
    }
    template <typename Element>
    std::string removed(std::vector<Element>& all, const std::string& kind) {
        if (all.empty() || !once(2))
            return "";
        all.erase(all.begin() + static_cast<std::ptrdiff_t>(below(all.size())));
        return kind;
    }

    Scene& s;
    Random& random_;
};

struct Kind {
    std::string name;
    std::string (Editor::*edit)();
};

const std::vector<Kind>& kinds() {
    static const std::vector<Kind> all{{"position", &Editor::position},
                                       {"velocity", &Editor::velocity},
                                       {"attitude, spin", &Editor::turn},
                                       {"mass", &Editor::mass},
                                       {"restitution", &Editor::restitution},
                                       {"collision group", &Editor::group},
                                       {"fixed", &Editor::fixed},
                                       {"force", &Editor::force},
                                       {"add force", &Editor::addForce},
                                       {"remove force", &Editor::removeForce},
                                       {"link", &Editor::link},
                                       {"add link", &Editor::addLink},
                                       {"remove link", &Editor::removeLink},
                                       {"shape", &Editor::shape},
                                       {"other shape", &Editor::otherShape},
                                       {"trajectory", &Editor::trajectory},
                                       {"constraint", &Editor::constrain},
                                       {"parameter", &Editor::parameter},
                                       {"add body", &Editor::add},
                                       {"remove body", &Editor::remove},
                                       {"end time", &Editor::finish},
                                       {"accuracy", &Editor::accuracy},
                                       {"collisions", &Editor::collisions},
                                       {"colour", &Editor::colour},
                                       {"lines", &Editor::lines},
                                       {"order", &Editor::order}};
    return all;
}

} // namespace

const std::vector<std::string>& kindsOfEdits() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> made;
        for (const Kind& kind : kinds())
            made.push_back(kind.name);
        return made;
    }();
    return names;
}

Made randomEdit(Scene& scene, Random& random, std::optional<std::size_t> mostly) {
    Editor editor(scene, random);
    const std::size_t kind = mostly && editor.once(2) ? *mostly : editor.below(kinds().size());
    return {kind, (editor.*kinds()[kind].edit)()};
}

} // namespace edits
