// lightsource and view.
#include "script/scene_maker.h"

#include "script/numbers.h"

#include <algorithm>

namespace script {

using geometry::Vector;

void SceneMaker::lightSource(Call& call) {
    scene::LightSource light;
    std::size_t first = 1;
    light.name = optionalName(call, Kind::lightSource, first);
    Arguments arguments(faults_, call,
                        light.name.empty() ? "the light source"
                                           : "light source " + quoted(light.name),
                        first, {"-direction", "-pos", "-color"});
    light.direction = arguments.vector("-direction");
    light.position = arguments.vector("-pos");
    if (light.direction && light.direction->isZero(0))
        arguments.wrong("-direction", arguments.find("-direction")->range, "a direction",
                        "and all its numbers are 0");
    if (!arguments.attempted("-direction") && !arguments.attempted("-pos"))
        arguments.wrongElement("wants -direction, or -pos for a point light");
    light.color = arguments.color("-color").value_or(scene::Color{1, 1, 1});
    light.source = call.source;
    made_.scene.lights.push_back(std::move(light));
}

// Three numbers, three expressions, or the name of a trajectory.
std::optional<scene::VectorValue> SceneMaker::vectorValue(Arguments& arguments,
                                                          std::string_view option) {
    constexpr std::string_view wants = "three numbers, three expressions or a trajectory";
    const Value* value = arguments.find(option);
    if (!value) {
        if (arguments.attempted(option))
            arguments.wrong(option, arguments.optionRange(option), wants, "and nothing follows it");
        return std::nullopt;
    }
    const auto parts = arguments.listIn(option, *value, wants);
    if (!parts)
        return std::nullopt;
    if (parts->size() == 1 && !decimalNumber((*parts)[0].text)) {
        const std::string name = (*parts)[0].text;
        refers(arguments, option, name, Kind::trajectory);
        return scene::VectorValue(name);
    }
    if (parts->size() != 3) {
        arguments.wrong(option, value->range, wants, "and gets " + std::to_string(parts->size()),
                        "an expression with blanks needs braces of its own");
        return std::nullopt;
    }
    Vector numbers;
    bool constant = true;
    for (int i = 0; i < 3 && constant; ++i) {
        const auto number = decimalNumber((*parts)[static_cast<std::size_t>(i)].text);
        constant = number.has_value();
        numbers[i] = number.value_or(0);
    }
    if (constant)
        return scene::VectorValue(numbers);
    std::array<scene::Expression, 3> expressions;
    for (std::size_t i = 0; i < 3; ++i)
        expressions[i] = expression(arguments, option, (*parts)[i]);
    return scene::VectorValue(expressions);
}

std::optional<scene::ScalarValue> SceneMaker::scalarValue(Arguments& arguments,
                                                          std::string_view option) {
    constexpr std::string_view wants = "a positive number, an expression or a trajectory";
    const Value* value = arguments.find(option);
    if (!value) {
        if (arguments.attempted(option))
            arguments.wrong(option, arguments.optionRange(option), wants, "and nothing follows it");
        return std::nullopt;
    }
    if (decimalNumber(value->text)) {
        const auto number = arguments.numberIn(option, *value, Sign::positive, wants);
        return number ? std::optional(scene::ScalarValue(*number)) : std::nullopt;
    }
    if (exists(Kind::trajectory, value->text))
        return scene::ScalarValue(value->text + ".x"); // a trajectory's first component
    return scene::ScalarValue(expression(arguments, option, *value));
}

void SceneMaker::view(Call& call) {
    scene::View view;
    std::size_t first = 1;
    view.name = optionalName(call, Kind::view, first);
    Arguments arguments(faults_, call, view.name.empty() ? "the view" : "view " + quoted(view.name),
                        first, {"-pos", "-rot", "-scale", "-center", "-eye", "-look", "-up"});
    view.position = vectorValue(arguments, "-pos");
    view.rotation = vectorValue(arguments, "-rot");
    view.scale = scalarValue(arguments, "-scale");
    view.center = vectorValue(arguments, "-center");
    view.eye = vectorValue(arguments, "-eye");
    view.look = vectorValue(arguments, "-look");
    view.up = vectorValue(arguments, "-up");
    const bool camera =
        arguments.attempted("-eye") || arguments.attempted("-look") || arguments.attempted("-up");
    for (const std::string_view option : {"-pos", "-rot", "-scale", "-center"})
        if (camera && arguments.attempted(option)) {
            faults_.error(arguments.optionRange(option),
                          arguments.subject() + " is given by -eye -look -up, and " +
                              std::string(option) + " belongs to the other way");
            break;
        }
    if (camera && (!arguments.attempted("-eye") || !arguments.attempted("-look")))
        arguments.wrongElement("wants both -eye and -look");
    view.source = call.source;
    made_.scene.views.push_back(std::move(view));
}

} // namespace script
