// gear.
#include "script/scene_maker.h"

#include "scene/joint_types.h"

#include <algorithm>

namespace script {

void SceneMaker::gear(Call& call) {
    scene::Gear gear;
    gear.name = newName(call, Kind::gear);
    if (gear.name.empty())
        return;
    Arguments arguments(faults_, call, "gear " + quoted(gear.name), 2,
                        {"-joint1", "-joint2", "-ratio", "-joints", "-ratios", "-release"});
    const bool pair = arguments.attempted("-joint1") || arguments.attempted("-joint2") ||
                      arguments.attempted("-ratio");
    const bool list = arguments.attempted("-joints") || arguments.attempted("-ratios");
    if (pair && list)
        arguments.wrongElement("has both -joint1 -joint2 -ratio and -joints -ratios");
    else if (!pair && !list)
        arguments.wrongElement("wants -joint1 -joint2 -ratio, or -joints and -ratios");
    else
        gear.terms = pair ? gearPair(arguments) : gearList(arguments);
    for (std::size_t i = 0; i < gear.terms.size(); ++i)
        for (std::size_t k = 0; k < i; ++k)
            if (gear.terms[i].joint == gear.terms[k].joint &&
                gear.terms[i].coordinate == gear.terms[k].coordinate)
                arguments.wrongElement("has joint " + quoted(gear.terms[i].joint) + " twice");
    gear.release = expressionOf(arguments, "-release", scene::Reading::release);
    gear.source = call.source;
    made_.scene.gears.push_back(std::move(gear));
}

namespace {
constexpr std::string_view ratioWish = "a number other than 0";
}

// J.q = R K.q
std::vector<scene::Gear::Term> SceneMaker::gearPair(Arguments& arguments) {
    std::vector<scene::Gear::Term> terms;
    for (const std::string_view option : {"-joint1", "-joint2", "-ratio"})
        if (!arguments.attempted(option))
            arguments.wrongElement("wants all of -joint1, -joint2 and -ratio, and has no " +
                                   std::string(option));
    const auto ratio = arguments.number("-ratio");
    if (ratio && *ratio == 0)
        arguments.wrong("-ratio", arguments.find("-ratio")->range, ratioWish, "not 0");
    for (const auto& [option, factor] :
         {std::pair("-joint1", 1.0), std::pair("-joint2", -ratio.value_or(1))})
        if (const Value* value = arguments.wanted(option, "the name of a joint"))
            if (const auto term = gearTerm(arguments, option, *value, factor))
                terms.push_back(*term);
    return terms;
}

std::vector<scene::Gear::Term> SceneMaker::gearList(Arguments& arguments) {
    constexpr std::string_view joints = "a list of at least two joints";
    constexpr std::string_view ratios = "as many numbers as there are -joints";
    std::vector<scene::Gear::Term> terms;
    for (const std::string_view option : {"-joints", "-ratios"})
        if (!arguments.attempted(option))
            arguments.wrongElement("wants both -joints and -ratios, and has no " +
                                   std::string(option));
    const Value* named = arguments.wanted("-joints", joints);
    const Value* given = arguments.wanted("-ratios", ratios);
    const auto names = named ? arguments.listIn("-joints", *named, joints) : std::nullopt;
    const auto numbers = given ? arguments.numbersIn("-ratios", *given, ratios) : std::nullopt;
    if (!names || !numbers)
        return terms;
    if (names->size() < 2)
        arguments.wrong("-joints", named->range, joints, "and gets " + quoted(named->text));
    else if (numbers->size() != names->size())
        arguments.wrong("-ratios", given->range, ratios,
                        "and gets " + std::to_string(numbers->size()) + " for " +
                            std::to_string(names->size()));
    for (std::size_t i = 0; i < std::min(names->size(), numbers->size()); ++i) {
        if ((*numbers)[i] == 0)
            arguments.wrong("-ratios", given->range, "numbers other than 0", "and one is 0");
        if (const auto term = gearTerm(arguments, "-joints", (*names)[i], (*numbers)[i]))
            terms.push_back(*term);
    }
    return terms;
}

// "J", or "J.q2" of a joint with several coordinates.
std::optional<scene::Gear::Term> SceneMaker::gearTerm(Arguments& arguments, std::string_view option,
                                                      const Value& value, double ratio) {
    const std::size_t dot = value.text.find('.');
    const std::string name = value.text.substr(0, dot);
    const std::string wanted = dot == std::string::npos ? "" : value.text.substr(dot + 1);
    if (!exists(Kind::joint, name)) {
        faults_.error(value.range, arguments.subject() + ": no joint named " + quoted(name),
                      suggest(Kind::joint, name));
        return std::nullopt;
    }
    const scene::Joint& joint = *scene::findJoint(made_.scene, name);
    const scene::JointTraits& traits = scene::traitsOf(joint.type);
    const std::size_t count = traits.coordinates.size();
    if (count == 0 || joint.type == scene::JointType::ball || scene::isRigidDistance(joint)) {
        arguments.wrong(option, value.range, "joints with a coordinate that turns or slides",
                        "and " + quoted(name) + " is a " + std::string(traits.name) + " joint");
        return std::nullopt;
    }
    for (std::size_t i = 0; i < count; ++i)
        if (wanted == "q" + scene::coordinateSuffix(joint.type, i) ||
            (count == 1 && wanted.empty()))
            return scene::Gear::Term{name, i, ratio};
    std::string choices;
    for (std::size_t i = 0; i < count; ++i)
        choices += (i == 0          ? ""
                    : i + 1 < count ? ", "
                                    : " or ") +
                   name + ".q" + scene::coordinateSuffix(joint.type, i);
    arguments.wrong(option, value.range, "one coordinate of each joint",
                    "not " + quoted(value.text), "write " + choices);
    return std::nullopt;
}

} // namespace script
