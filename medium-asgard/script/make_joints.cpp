// joint, and what is checked of all joints and gears.
#include "script/scene_maker.h"

#include "script/numbers.h"
#include "script/suggestion.h"

#include "expression/tokens.h"
#include "scene/joint_types.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <unordered_set>

namespace script {

using geometry::Vector;
using scene::Joint;
using scene::JointCoordinate;
using scene::JointTraits;

namespace {

constexpr std::string_view ofJoint[] = {"-type", "-body1", "-offset1", "-body2",  "-offset2",
                                        "-axis", "-axis2", "-pitch",   "-release"};
constexpr std::string_view ofCoordinate[] = {
    "-limits", "-limit_restitution", "-motor",    "-speed", "-position", "-max_motor", "-stiffness",
    "-rest",   "-damping",           "-friction", "-from"};
constexpr std::size_t mostCoordinates = 3;

// Every option that some joint has.
std::span<const std::string_view> jointOptions() {
    static const std::vector<std::string> withDigits = [] {
        std::vector<std::string> made;
        for (std::size_t digit = 1; digit <= mostCoordinates; ++digit)
            for (const std::string_view option : ofCoordinate)
                made.push_back(std::string(option) + std::to_string(digit));
        return made;
    }();
    static const std::vector<std::string_view> all = [] {
        std::vector<std::string_view> made(std::begin(ofJoint), std::end(ofJoint));
        made.insert(made.end(), std::begin(ofCoordinate), std::end(ofCoordinate));
        made.insert(made.end(), withDigits.begin(), withDigits.end());
        return made;
    }();
    return all;
}

std::string nameOf(scene::JointType type) {
    return "a " + std::string(scene::traitsOf(type).name) + " joint";
}

// The type that other programs call so.
std::string typeCalled(std::string_view word) {
    static constexpr std::pair<std::string_view, std::string_view> others[] = {
        {"revolute", "hinge"},      {"pin", "hinge"},        {"pivot", "hinge"},
        {"rotary", "hinge"},        {"prismatic", "slider"}, {"translational", "slider"},
        {"weld", "fixed"},          {"rigid", "fixed"},      {"spherical", "ball"},
        {"socket", "ball"},         {"cardan", "universal"}, {"hooke", "universal"},
        {"rod", "distance"},        {"helical", "screw"},    {"plane", "planar"},
        {"cylinder", "cylindrical"}};
    for (const auto& [other, type] : others)
        if (word == other)
            return "did you mean \"" + std::string(type) + "\"?";
    return "";
}

Range placeOf(const scene::Source& source, std::string_view option) {
    for (const scene::Argument& argument : source.arguments)
        if (argument.option == option)
            return argument.word;
    return source.command;
}

// How strong a spring, a damper or a brake is. One that changes is a motor: -strength * opposes.
double strengthOf(Arguments& arguments, const std::string& option, const std::string& suffix,
                  const std::string& opposes) {
    const Value* value = arguments.find(option + suffix);
    std::string motor;
    if (value && !value->text.empty())
        motor = "one that changes is a motor: -motor" + suffix + " {-(" + value->text + ")*" +
                opposes + "}";
    return arguments.number(option + suffix, Sign::notNegative, std::move(motor)).value_or(0);
}

} // namespace

std::optional<scene::Expression>
SceneMaker::expressionOf(Arguments& arguments, std::string_view option, scene::Reading reading) {
    const Value* value = arguments.wanted(option, "an expression");
    return value ? std::optional(expression(arguments, option, *value, reading)) : std::nullopt;
}

// An expression, or a trajectory, whose first component counts.
std::optional<scene::Expression> SceneMaker::drivenPosition(Arguments& arguments,
                                                            const std::string& option) {
    const Value* value = arguments.wanted(option, "an expression or a trajectory");
    if (value && exists(Kind::trajectory, value->text))
        return value->text + ".x";
    return value ? std::optional(expression(arguments, option, *value, scene::Reading::positions))
                 : std::nullopt;
}

// --- joint ----------------------------------------------------------------------------------

void SceneMaker::joint(Call& call) {
    Joint joint;
    joint.name = newName(call, Kind::joint);
    if (joint.name.empty())
        return;
    Arguments arguments(faults_, call, "joint " + quoted(joint.name), 2, jointOptions());
    const auto names = scene::jointTypeNames();
    bool isKnown = false;
    if (!arguments.attempted("-type"))
        arguments.wrongElement("wants -type with what it leaves free",
                               suggestionFor("", names, "types", names.size()));
    if (const auto type = arguments.name("-type", "a type of joint")) {
        const auto found = std::ranges::find(names, *type);
        isKnown = found != names.end();
        if (isKnown)
            joint.type = static_cast<scene::JointType>(found - names.begin());
        else
            faults_.error(arguments.find("-type")->range,
                          arguments.subject() + ": there is no type of joint " + quoted(*type),
                          typeCalled(*type).empty()
                              ? suggestionFor(*type, names, "types", names.size())
                              : typeCalled(*type));
    }
    jointEnds(arguments, joint);
    if (isKnown) {
        jointAxes(arguments, joint);
        refuseOptions(arguments, joint);
    }
    for (std::size_t i = 0; i < scene::traitsOf(joint.type).coordinates.size(); ++i)
        joint.coordinates.push_back(jointCoordinate(arguments, joint, i));
    joint.release = expressionOf(arguments, "-release", scene::Reading::release);
    joint.source = call.source;
    made_.scene.joints.push_back(std::move(joint));
}

void SceneMaker::jointEnds(Arguments& arguments, Joint& joint) {
    if (!arguments.attempted("-body1"))
        arguments.wrongElement("wants -body1 with the name of what it holds");
    joint.body1 = reference(arguments, "-body1", Kind::body).value_or("");
    joint.offset1 = arguments.vector("-offset1");
    joint.offset2 = arguments.vector("-offset2");
    if (arguments.attempted("-body2")) {
        joint.body2 = reference(arguments, "-body2", Kind::body).value_or("");
        if (!joint.body1.empty() && *joint.body2 == joint.body1)
            faults_.error(arguments.find("-body2")->range,
                          "a joint cannot join body " + quoted(joint.body1) + " to itself");
    } else if (joint.type == scene::JointType::distance && !arguments.attempted("-offset2")) {
        arguments.wrongElement("wants -body2, or -offset2 with the point of the world that its "
                               "distance is to");
    }
}

void SceneMaker::jointAxes(Arguments& arguments, Joint& joint) {
    const JointTraits& traits = scene::traitsOf(joint.type);
    for (const std::string_view option : {"-axis", "-axis2"}) {
        const auto axis = arguments.vector(option);
        if (!traits.hasAxis && arguments.attempted(option))
            faults_.error(arguments.optionRange(option), nameOf(joint.type) + " has no " +
                                                             std::string(option) + ", and " +
                                                             arguments.subject() + " is one");
        else if (axis && axis->isZero(0))
            arguments.wrong(option, arguments.find(option)->range, "a direction",
                            "and all its numbers are 0");
        else if (axis && option == "-axis")
            joint.axis = *axis;
        else if (axis)
            joint.axis2 = *axis;
    }
    if (traits.hasAxis && !arguments.attempted("-axis")) {
        if (traits.isDefaultAxis)
            joint.axis = Vector::UnitZ();
        else
            arguments.wrongElement("wants -axis, a direction in the frame of body 1: " +
                                   nameOf(joint.type) + " has one");
    }
    const bool isScrew = joint.type == scene::JointType::screw;
    const auto pitch = arguments.number("-pitch");
    joint.pitch = pitch.value_or(0);
    if (!isScrew && arguments.attempted("-pitch"))
        faults_.error(arguments.optionRange("-pitch"), "-pitch is of a screw, and " +
                                                           arguments.subject() + " is " +
                                                           nameOf(joint.type));
    else if (isScrew && !arguments.attempted("-pitch"))
        arguments.wrongElement("wants -pitch, how far it slides in one turn");
    else if (pitch && *pitch == 0)
        arguments.wrong("-pitch", arguments.find("-pitch")->range, "a number other than 0",
                        "and a screw of pitch 0 is a hinge");
}

// Options of coordinates that this type does not have.
void SceneMaker::refuseOptions(Arguments& arguments, const Joint& joint) {
    const JointTraits& traits = scene::traitsOf(joint.type);
    for (const std::string_view base : ofCoordinate) {
        const bool has = base == "-from" ? traits.hasFrom : traits.hasDrives;
        const std::size_t count = has ? traits.coordinates.size() : 0;
        for (std::size_t digit = 0; digit <= mostCoordinates; ++digit) {
            const std::string option =
                std::string(base) + (digit == 0 ? "" : std::to_string(digit));
            const bool belongs = count == 1 ? digit == 0 : digit >= 1 && digit <= count;
            if (belongs || !arguments.attempted(option))
                continue;
            std::string suggestion;
            if (count == 1)
                suggestion = "write " + std::string(base);
            else if (count > 1)
                suggestion = "write " + std::string(base) + "1 or " + std::string(base) + "2";
            faults_.error(arguments.optionRange(option),
                          nameOf(joint.type) + " has no " + option + ", and " +
                              arguments.subject() + " is one",
                          suggestion);
        }
    }
}

JointCoordinate SceneMaker::jointCoordinate(Arguments& arguments, const Joint& joint,
                                            std::size_t index) {
    JointCoordinate made;
    const JointTraits& traits = scene::traitsOf(joint.type);
    const std::string suffix = scene::coordinateSuffix(joint.type, index);
    if (traits.hasFrom)
        made.from = arguments.number("-from" + suffix).value_or(0);
    if (!traits.hasDrives)
        return made;
    made.isGiven = std::ranges::any_of(ofCoordinate, [&](std::string_view option) {
        return option != "-from" && arguments.attempted(std::string(option) + suffix);
    });
    jointLimits(arguments, suffix, traits.startsAtZero, made);
    jointDrive(arguments, suffix, made);
    const std::string q = joint.name + ".q" + suffix, dq = joint.name + ".dq" + suffix;
    made.stiffness = strengthOf(arguments, "-stiffness", suffix, q);
    made.rest = arguments.number("-rest" + suffix).value_or(0);
    made.damping = strengthOf(arguments, "-damping", suffix, dq);
    made.friction = strengthOf(arguments, "-friction", suffix, "sign(" + dq + ")");
    if (arguments.attempted("-rest" + suffix) && !arguments.attempted("-stiffness" + suffix))
        faults_.error(arguments.optionRange("-rest" + suffix),
                      "-rest" + suffix + " is where the spring of -stiffness" + suffix +
                          " does not pull, and " + arguments.subject() + " has none");
    return made;
}

void SceneMaker::jointLimits(Arguments& arguments, const std::string& suffix, bool startsAtZero,
                             JointCoordinate& coordinate) {
    const std::string option = "-limits" + suffix, bounce = "-limit_restitution" + suffix;
    constexpr std::string_view wants = "two numbers {lo hi}, one of which may be {}";
    coordinate.limitRestitution = arguments.number(bounce, Sign::unit).value_or(0);
    if (arguments.attempted(bounce) && !arguments.attempted(option))
        faults_.error(arguments.optionRange(bounce),
                      bounce + " is of " + option + ", and " + arguments.subject() + " has none");
    const Value* value = arguments.wanted(option, wants);
    if (!value)
        return;
    const auto parts = arguments.listIn(option, *value, wants);
    if (!parts)
        return;
    if (parts->size() != 2 || ((*parts)[0].text.empty() && (*parts)[1].text.empty())) {
        arguments.wrong(option, value->range, wants, "not " + quoted(value->text));
        return;
    }
    for (const std::size_t i : {0U, 1U})
        if (!(*parts)[i].text.empty())
            (i == 0 ? coordinate.lower : coordinate.upper) =
                arguments.numberIn(option, (*parts)[i], Sign::any, wants);
    const bool isCrossed =
        coordinate.lower && coordinate.upper && !(*coordinate.lower < *coordinate.upper);
    if (isCrossed)
        arguments.wrong(option, value->range, "a lower limit under the upper one",
                        "and " + numberText(*coordinate.lower, true) + " is not under " +
                            numberText(*coordinate.upper, true));
    else if (startsAtZero && (coordinate.lower.value_or(coordinate.from) > coordinate.from ||
                              coordinate.upper.value_or(coordinate.from) < coordinate.from))
        arguments.wrong(
            option, value->range, "a range with " + numberText(coordinate.from, true) + " in it",
            "and the joint's coordinate is " + numberText(coordinate.from, true) + " at the start");
}

// At most one of -motor, -speed and -position.
void SceneMaker::jointDrive(Arguments& arguments, const std::string& suffix,
                            JointCoordinate& coordinate) {
    const std::string motor = "-motor" + suffix, speed = "-speed" + suffix,
                      position = "-position" + suffix, most = "-max_motor" + suffix;
    arguments.atMostOne({motor, speed, position});
    coordinate.motor = expressionOf(arguments, motor, scene::Reading::state);
    coordinate.speed = expressionOf(arguments, speed, scene::Reading::state);
    coordinate.position = drivenPosition(arguments, position);
    coordinate.maxMotor = arguments.number(most, Sign::notNegative);
    if (arguments.attempted(most) && !arguments.attempted(speed) && !arguments.attempted(position))
        faults_.error(arguments.optionRange(most), most + " bounds what " + speed + " or " +
                                                       position + " takes, and " +
                                                       arguments.subject() + " has neither");
}

// --- all joints -----------------------------------------------------------------------------

void SceneMaker::checkJoints() {
    if (made_.scene.joints.empty())
        return;
    std::unordered_set<std::string_view> fixed, idle;
    for (const scene::Body& body : made_.scene.bodies)
        if (body.fixed)
            fixed.insert(body.name);
    for (const Joint& joint : made_.scene.joints) {
        if (!fixed.contains(joint.body1) || (joint.body2 && !fixed.contains(*joint.body2)))
            continue;
        idle.insert(joint.name);
        faults_.warning(placeOf(joint.source, "-body1"),
                        "joint " + quoted(joint.name) + " joins what never moves");
    }
    for (const scene::Gear& gear : made_.scene.gears)
        for (const scene::Gear::Term& term : gear.terms)
            if (idle.contains(term.joint))
                faults_.error(gear.source.command, "gear " + quoted(gear.name) + " moves joint " +
                                                       quoted(term.joint) +
                                                       ", whose bodies never move");
    checkJointCycles();
}

namespace {

// A -speed or -position: what it drives, and the driven coordinates that it reads.
struct Drive {
    const Joint* joint;
    std::string option;
    std::vector<std::size_t> reads;
    enum class Mark { unseen, open, done } mark = Mark::unseen;
};

using DriveIndex = std::map<std::string, std::size_t, std::less<>>; // by "J.q" and "J.dq"

std::vector<Drive> drivesOf(const scene::Scene& scene) {
    std::vector<Drive> drives;
    std::vector<const scene::Expression*> texts;
    DriveIndex byName;
    for (const Joint& joint : scene.joints)
        for (std::size_t i = 0; i < joint.coordinates.size(); ++i) {
            const JointCoordinate& coordinate = joint.coordinates[i];
            if (!coordinate.speed && !coordinate.position)
                continue;
            const std::string suffix = scene::coordinateSuffix(joint.type, i);
            for (const char* quantity : {".q", ".dq"})
                byName.emplace(joint.name + quantity + suffix, drives.size());
            drives.push_back({&joint, (coordinate.speed ? "-speed" : "-position") + suffix, {}});
            texts.push_back(coordinate.speed ? &*coordinate.speed : &*coordinate.position);
        }
    for (std::size_t i = 0; i < drives.size(); ++i)
        for (expression::Tokens tokens(*texts[i]); tokens.now().kind != expression::TokenKind::end;
             tokens.advance())
            if (tokens.now().kind == expression::TokenKind::name)
                if (const auto found = byName.find(tokens.now().text); found != byName.end())
                    drives[i].reads.push_back(found->second);
    return drives;
}

// The first cycle through drives that no earlier search has seen; empty: none.
std::vector<std::size_t> cycleFrom(std::vector<Drive>& drives, std::size_t start) {
    std::vector<std::pair<std::size_t, std::size_t>> path{{start, 0}}; // drive, next of its reads
    drives[start].mark = Drive::Mark::open;
    while (!path.empty()) {
        auto& [at, next] = path.back();
        if (next == drives[at].reads.size()) {
            drives[at].mark = Drive::Mark::done;
            path.pop_back();
            continue;
        }
        const std::size_t read = drives[at].reads[next++];
        if (drives[read].mark == Drive::Mark::open) {
            std::vector<std::size_t> cycle;
            for (const auto& [drive, unused] : path)
                if (drive == read || !cycle.empty())
                    cycle.push_back(drive);
            return cycle;
        }
        if (drives[read].mark == Drive::Mark::unseen) {
            drives[read].mark = Drive::Mark::open;
            path.emplace_back(read, 0);
        }
    }
    return {};
}

} // namespace

// Drives that read each other determine nothing.
void SceneMaker::checkJointCycles() {
    std::vector<Drive> drives = drivesOf(made_.scene);
    for (std::size_t i = 0; i < drives.size(); ++i) {
        if (drives[i].mark != Drive::Mark::unseen)
            continue;
        const std::vector<std::size_t> cycle = cycleFrom(drives, i);
        if (cycle.empty())
            continue;
        const Drive& first = drives[cycle.front()];
        std::string message = first.option + " of joint " + quoted(first.joint->name);
        for (std::size_t k = 1; k < cycle.size(); ++k)
            message += " reads joint " + quoted(drives[cycle[k]].joint->name) + ", whose " +
                       drives[cycle[k]].option;
        faults_.error(placeOf(first.joint->source, first.option),
                      message + " reads joint " + quoted(first.joint->name) +
                          ": a cycle determines no motion");
        return;
    }
}

} // namespace script
