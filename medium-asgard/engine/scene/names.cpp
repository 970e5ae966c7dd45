#include "scene/names.h"

#include "expression/nearest_name.h"
#include "scene/joint_types.h"

#include <algorithm>
#include <array>

namespace scene {
namespace {

using expression::nearestName;

std::string quoted(std::string_view text) { return '"' + std::string(text) + '"'; }

std::string didYouMean(const std::string& name) {
    return name.empty() ? "" : "did you mean " + quoted(name) + "?";
}

constexpr std::size_t firstCall = static_cast<std::size_t>(BodyQuantity::px);

const std::vector<std::string>& trajectoryQuantityNames() {
    static const std::vector<std::string> names{"x", "y", "z", "dx", "dy", "dz"};
    return names;
}

const std::vector<std::string>& sceneQuantityNames() {
    static const std::vector<std::string> names{"scene.energy", "scene.px",         "scene.py",
                                                "scene.pz",     "scene.lx",         "scene.ly",
                                                "scene.lz",     "events.collisions"};
    return names;
}

std::optional<std::size_t> indexOf(const std::vector<std::string>& names, std::string_view name) {
    const auto found = std::ranges::find(names, name);
    if (found == names.end())
        return std::nullopt;
    return static_cast<std::size_t>(found - names.begin());
}

bool isVelocity(BodyQuantity q) {
    return (q >= BodyQuantity::dx && q <= BodyQuantity::wz) || q >= BodyQuantity::pdx;
}

std::string listOf(const std::vector<std::string>& names) {
    std::string list;
    for (const std::string& name : names)
        list += ' ' + name;
    return list;
}

constexpr const char* onlyPositions = "positions may be read here, and no velocities";
constexpr const char* ofContact =
    " tells of a contact, which plots, --quantities and -release may read, and no other expression";
constexpr const char* onlyShown =
    " is a force, which plots, --quantities and -release may read, and no other expression";

Named findSceneQuantity(std::string_view name, Reading reading) {
    const auto index = indexOf(sceneQuantityNames(), name);
    if (!index)
        return NameFault{"there is no quantity " + quoted(name),
                         didYouMean(nearestName(name, sceneQuantityNames()))};
    if (reading != Reading::quantities)
        return NameFault{std::string(name) + " can be charted and printed, and is no name in a "
                                             "scene's expressions",
                         ""};
    return SceneName{static_cast<SceneQuantity>(*index)};
}

} // namespace

const std::vector<std::string>& bodyQuantityNames() {
    static const std::vector<std::string> names{
        "x",   "y",   "z",   "dx", "dy", "dz", "wx",   "wy",  "wz",  "qw",
        "qx",  "qy",  "qz",  "rx", "ry", "rz", "mass", "ixx", "iyy", "izz",
        "ixy", "ixz", "iyz", "px", "py", "pz", "pdx",  "pdy", "pdz"};
    return names;
}

std::vector<std::string> jointQuantityNames(JointType type) {
    const JointTraits& traits = traitsOf(type);
    std::vector<std::string> names;
    for (std::size_t i = 0; i < traits.coordinates.size(); ++i) {
        const std::string suffix = coordinateSuffix(type, i);
        names.push_back("q" + suffix);
        names.push_back("dq" + suffix);
        if (traits.hasDrives)
            names.push_back("motor" + suffix);
    }
    for (const char* ofAll : {"fx", "fy", "fz", "tx", "ty", "tz", "px", "py", "pz"})
        names.emplace_back(ofAll);
    return names;
}

const std::vector<std::string>& springQuantityNames() {
    static const std::vector<std::string> names{"length", "force"};
    return names;
}

const std::vector<std::string>& contactQuantityNames() {
    static const std::vector<std::string> names{"n",  "fx", "fy", "fz", "tx",   "ty",
                                                "tz", "px", "py", "pz", "slip", "state"};
    return names;
}

std::size_t spansOf(const Rope& rope) {
    const std::size_t ends = rope.isClosed || rope.points.empty() ? 0 : 1;
    std::size_t wheels = 0;
    for (std::size_t i = ends; i + ends < rope.points.size(); ++i)
        if (rope.points[i].radius != 0)
            ++wheels;
    return std::max<std::size_t>(wheels + ends, 1);
}

std::vector<std::string> ropeQuantityNames(const Rope& rope) {
    std::vector<std::string> names{"length", "tension"};
    for (std::size_t i = 1; i <= spansOf(rope); ++i)
        names.push_back("tension" + std::to_string(i));
    return names;
}

Names::Names(const Scene& scene) {
    for (std::size_t i = 0; i < scene.bodies.size(); ++i)
        owners_.try_emplace(scene.bodies[i].name, Owner{Kind::body, i});
    for (std::size_t i = 0; i < scene.trajectories.size(); ++i)
        owners_.try_emplace(scene.trajectories[i].name, Owner{Kind::trajectory, i});
    for (std::size_t i = 0; i < scene.parameters.size(); ++i)
        owners_.try_emplace(scene.parameters[i].name, Owner{Kind::parameter, i});
    for (std::size_t i = 0; i < scene.joints.size(); ++i) {
        owners_.try_emplace(scene.joints[i].name, Owner{Kind::joint, i});
        joints_.push_back(scene.joints[i].type);
    }
    for (std::size_t i = 0; i < scene.gears.size(); ++i)
        owners_.try_emplace(scene.gears[i].name, Owner{Kind::gear, i});
    for (std::size_t i = 0; i < scene.ropes.size(); ++i) {
        owners_.try_emplace(scene.ropes[i].name, Owner{Kind::rope, i});
        ropes_.push_back(ropeQuantityNames(scene.ropes[i]));
    }
    for (std::size_t i = 0; i < scene.contacts.size(); ++i)
        if (!scene.contacts[i].name.empty())
            owners_.try_emplace(scene.contacts[i].name, Owner{Kind::contact, i});
    for (std::size_t i = 0; i < scene.links.size(); ++i)
        if (!scene.links[i].name.empty())
            owners_.try_emplace(scene.links[i].name, Owner{Kind::spring, i});
}

Named Names::find(std::string_view name, std::optional<std::size_t> arguments,
                  Reading reading) const {
    const std::size_t dot = name.rfind('.');
    const bool isWhole = dot == name.npos;
    const std::string_view owner = name.substr(0, dot);
    const std::string_view quantity = isWhole ? "" : name.substr(dot + 1);
    const auto found = owners_.find(owner);
    const bool isBody = !isWhole && found != owners_.end() && found->second.kind == Kind::body;
    if (arguments && isWhole)
        return NameFault{"there is no function " + quoted(name), ""};
    if (isBody)
        return findOfBody(name, found->second.index, quantity, arguments, reading);
    if (isWhole)
        return findAlone(name);
    if (owner == "scene" || owner == "events")
        return findSceneQuantity(name, reading);
    if (found == owners_.end())
        return unknownOwner(owner, quantity);
    if (found->second.kind == Kind::parameter)
        return NameFault{quoted(owner) + " is a parameter: its name alone is its value", ""};
    if (found->second.kind == Kind::gear)
        return NameFault{quoted(owner) + " is a gear, which has no quantities",
                         "its joints have q and dq"};
    if (arguments)
        return NameFault{std::string(name) + " takes no arguments", ""};
    if (found->second.kind == Kind::joint)
        return findOfJoint(name, found->second.index, quantity, reading);
    if (found->second.kind == Kind::spring)
        return findOfSpring(name, found->second.index, quantity, reading);
    if (found->second.kind == Kind::rope)
        return findOfRope(name, found->second.index, quantity, reading);
    if (found->second.kind == Kind::contact)
        return findOfContact(name, found->second.index, quantity, reading);
    return findOfTrajectory(found->second.index, quantity);
}

Named Names::findAlone(std::string_view name) const {
    if (name == "t")
        return TimeName{};
    const auto found = owners_.find(name);
    if (found != owners_.end() && found->second.kind == Kind::parameter)
        return ParameterName{found->second.index};
    if (found != owners_.end()) {
        static constexpr const char* kinds[] = {"body", "trajectory", "parameter", "joint",
                                                "gear", "spring",     "rope",      "contact"};
        const Owner& owner = found->second;
        const bool isLong = owner.kind == Kind::spring || owner.kind == Kind::rope;
        std::string example = isLong ? "length" : "x";
        if (owner.kind == Kind::contact)
            example = "n";
        if (owner.kind == Kind::joint)
            example = jointQuantityNames(joints_[owner.index]).front();
        return NameFault{quoted(name) + " is a " + kinds[static_cast<std::size_t>(owner.kind)] +
                             ", and an expression reads numbers",
                         owner.kind == Kind::gear ? "its joints have q and dq"
                                                  : "write " + std::string(name) + "." + example +
                                                        ", or another of its quantities"};
    }
    std::vector<std::string> known = expression::functionNames();
    for (const auto& [owner, what] : owners_)
        if (what.kind == Kind::parameter)
            known.push_back(owner);
    return NameFault{"nothing is named " + quoted(name), didYouMean(nearestName(name, known))};
}

Named Names::findOfBody(std::string_view name, std::size_t body, std::string_view quantity,
                        std::optional<std::size_t> arguments, Reading reading) const {
    const auto index = indexOf(bodyQuantityNames(), quantity);
    const std::string full(name);
    if (!index) {
        const std::string near = nearestName(quantity, bodyQuantityNames());
        const std::string owner = full.substr(0, full.size() - quantity.size());
        return NameFault{"a body has no quantity " + quoted(quantity),
                         near.empty()
                             ? "there are x y z dx dy dz wx wy wz rx ry rz qw qx qy qz mass, ..."
                             : didYouMean(owner + near)};
    }
    const bool isPoint = *index >= firstCall;
    if (isPoint && !arguments)
        return NameFault{full + " wants a point of the body", "write " + full + "(ox, oy, oz)"};
    if (!isPoint && arguments)
        return NameFault{full + " takes no arguments", ""};
    if (isPoint && *arguments != 3)
        return NameFault{full + " takes three arguments, not " + std::to_string(*arguments), ""};
    const auto found = static_cast<BodyQuantity>(*index);
    if (reading == Reading::positions && isVelocity(found))
        return NameFault{onlyPositions, ""};
    return BodyName{body, found};
}

Named Names::findOfTrajectory(std::size_t trajectory, std::string_view quantity) const {
    const auto index = indexOf(trajectoryQuantityNames(), quantity);
    if (!index)
        return NameFault{"a trajectory has no quantity " + quoted(quantity),
                         "there are x y z dx dy dz"};
    return TrajectoryName{trajectory, static_cast<int>(*index % 3), *index >= 3};
}

Named Names::findOfJoint(std::string_view name, std::size_t joint, std::string_view quantity,
                         Reading reading) const {
    const JointTraits& traits = traitsOf(joints_[joint]);
    const std::vector<std::string> known = jointQuantityNames(joints_[joint]);
    const auto index = indexOf(known, quantity);
    if (!index)
        return NameFault{"a " + std::string(traits.name) + " joint has no quantity " +
                             quoted(quantity),
                         "there are" + listOf(known)};
    const std::size_t each = traits.hasDrives ? 3 : 2, ofAll = each * traits.coordinates.size();
    const bool isOfAll = *index >= ofAll; // of no coordinate
    const auto found = static_cast<JointQuantity>(
        isOfAll ? static_cast<std::size_t>(JointQuantity::fx) + *index - ofAll : *index % each);
    const bool isForce = found >= JointQuantity::motor && found < JointQuantity::px;
    if (isForce && reading != Reading::quantities && reading != Reading::release)
        return NameFault{std::string(name) + onlyShown, ""};
    if (found == JointQuantity::dq && reading == Reading::positions)
        return NameFault{onlyPositions, ""};
    return JointName{joint, found, isOfAll ? 0 : *index / each};
}

Named Names::findOfSpring(std::string_view name, std::size_t link, std::string_view quantity,
                          Reading reading) {
    const auto index = indexOf(springQuantityNames(), quantity);
    if (!index)
        return NameFault{"a spring has no quantity " + quoted(quantity),
                         "there are length and force"};
    const auto found = static_cast<SpringQuantity>(*index);
    if (found == SpringQuantity::force && reading != Reading::quantities &&
        reading != Reading::release)
        return NameFault{std::string(name) + onlyShown, ""};
    if (reading == Reading::positions)
        return NameFault{"positions may be read here, and no lengths of springs", ""};
    return SpringName{link, found};
}

Named Names::findOfRope(std::string_view name, std::size_t rope, std::string_view quantity,
                        Reading reading) const {
    const auto index = indexOf(ropes_[rope], quantity);
    if (!index)
        return NameFault{"this rope has no quantity " + quoted(quantity),
                         "there are" + listOf(ropes_[rope])};
    const bool isTension = *index > 0;
    if (isTension && reading != Reading::quantities && reading != Reading::release)
        return NameFault{std::string(name) + onlyShown, ""};
    if (reading == Reading::positions)
        return NameFault{"positions may be read here, and no lengths of ropes", ""};
    RopeName made{rope, std::nullopt};
    if (isTension)
        made.span = *index < 2 ? 0 : *index - 2;
    return made;
}

Named Names::findOfContact(std::string_view name, std::size_t contact, std::string_view quantity,
                           Reading reading) {
    const auto index = indexOf(contactQuantityNames(), quantity);
    if (!index)
        return NameFault{"a contact has no quantity " + quoted(quantity),
                         "there are" + listOf(contactQuantityNames())};
    if (reading != Reading::quantities && reading != Reading::release)
        return NameFault{std::string(name) + ofContact, ""};
    return ContactName{contact, static_cast<ContactQuantity>(*index)};
}

NameFault Names::unknownOwner(std::string_view owner, std::string_view quantity) const {
    std::vector<std::string> known;
    for (const auto& [name, what] : owners_)
        if (what.kind != Kind::parameter && what.kind != Kind::gear)
            known.push_back(name);
    const std::string near = nearestName(owner, known);
    return {"nothing is named " + quoted(owner),
            near.empty() ? "" : didYouMean(near + "." + std::string(quantity))};
}

// --- every expression of a scene ------------------------------------------------------------

namespace {

constexpr std::array<const char*, 3> axes{"-x", "-y", "-z"};

class NameCollector {
public:
    void add(const Force& force) {
        if (const auto* kind = std::get_if<ComponentForce>(&force.kind))
            for (std::size_t i = 0; i < 3; ++i)
                places.push_back({&kind->components[i], &force.source, axes[i]});
        add(force.source, force.release, "-release", Reading::release);
    }
    void add(const Link& link) {
        if (const auto* point = std::get_if<PointEnd>(&link.second))
            for (std::size_t i = 0; i < 3; ++i)
                places.push_back(
                    {&point->coordinates[i], &link.source, axes[i], 0, Reading::positions});
        add(link.source, link.release, "-release", Reading::release);
    }
    void add(const Joint& joint) {
        for (std::size_t i = 0; i < joint.coordinates.size(); ++i) {
            const std::string suffix = coordinateSuffix(joint.type, i);
            const JointCoordinate& coordinate = joint.coordinates[i];
            add(joint.source, coordinate.motor, "-motor" + suffix, Reading::state);
            add(joint.source, coordinate.speed, "-speed" + suffix, Reading::state);
            add(joint.source, coordinate.position, "-position" + suffix, Reading::positions);
        }
        add(joint.source, joint.release, "-release", Reading::release);
    }
    void add(const Gear& gear) { add(gear.source, gear.release, "-release", Reading::release); }
    void add(const Rope& rope) { add(rope.source, rope.release, "-release", Reading::release); }
    void add(const View& view) {
        add(view, view.position, "-pos");
        add(view, view.rotation, "-rot");
        add(view, view.center, "-center");
        add(view, view.eye, "-eye");
        add(view, view.look, "-look");
        add(view, view.up, "-up");
        if (view.scale)
            if (const auto* text = std::get_if<Expression>(&*view.scale))
                places.push_back({text, &view.source, "-scale"});
    }
    void add(const Plot& plot) {
        for (std::size_t i = 0; i < plot.values.size(); ++i)
            places.push_back({&plot.values[i], &plot.source, "-values", i, Reading::quantities});
    }

    std::vector<ExpressionPlace> places;

private:
    void add(const Source& source, const std::optional<Expression>& text, std::string option,
             Reading reading) {
        if (text)
            places.push_back({&*text, &source, std::move(option), 0, reading});
    }
    void add(const View& view, const std::optional<VectorValue>& value, const char* option) {
        if (!value)
            return;
        if (const auto* texts = std::get_if<std::array<Expression, 3>>(&*value))
            for (std::size_t i = 0; i < 3; ++i)
                places.push_back({&(*texts)[i], &view.source, option, i});
    }
};

} // namespace

std::vector<ExpressionPlace> expressionsOf(const Scene& scene) {
    NameCollector collector;
    std::ranges::for_each(scene.forces, [&](const Force& f) { collector.add(f); });
    std::ranges::for_each(scene.links, [&](const Link& l) { collector.add(l); });
    std::ranges::for_each(scene.joints, [&](const Joint& j) { collector.add(j); });
    std::ranges::for_each(scene.gears, [&](const Gear& g) { collector.add(g); });
    std::ranges::for_each(scene.ropes, [&](const Rope& r) { collector.add(r); });
    std::ranges::for_each(scene.views, [&](const View& v) { collector.add(v); });
    std::ranges::for_each(scene.plots, [&](const Plot& p) { collector.add(p); });
    return std::move(collector.places);
}

void countTurns(Scene& scene, const std::vector<std::string>& expressions) {
    const Names names(scene);
    expression::Graph graph;
    for (const std::string& text : expressions) {
        const expression::Names meaning = [&](expression::Graph& g, std::string_view name,
                                              std::span<const expression::Node>,
                                              bool isCall) -> expression::Meaning {
            const Named named = names.find(
                name, isCall ? std::optional<std::size_t>(3) : std::nullopt, Reading::quantities);
            const auto* body = std::get_if<BodyName>(&named);
            if (body && isTurn(body->quantity))
                scene.bodies[body->body].countsTurns = true;
            return {g.symbol(name), "", ""};
        };
        (void)expression::parse(graph, text, meaning);
    }
}

std::vector<ExpressionFault> checkExpressions(const Scene& scene) {
    const Names names(scene);
    std::vector<ExpressionFault> faults;
    expression::Graph graph;
    for (const ExpressionPlace& place : expressionsOf(scene)) {
        const expression::Names meaning = [&](expression::Graph& g, std::string_view name,
                                              std::span<const expression::Node> arguments,
                                              bool isCall) -> expression::Meaning {
            const auto count = isCall ? std::optional(arguments.size()) : std::nullopt;
            const Named named = names.find(name, count, place.reading);
            if (const auto* fault = std::get_if<NameFault>(&named))
                return {std::nullopt, fault->message, fault->suggestion};
            return {g.symbol(name), "", ""};
        };
        const auto parsed = expression::parse(graph, *place.text, meaning);
        if (const auto* error = std::get_if<expression::SyntaxError>(&parsed))
            faults.push_back({place, error->from, error->to, error->message, error->suggestion});
    }
    return faults;
}

} // namespace scene
