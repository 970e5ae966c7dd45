// force, link, spring, simulator, parameter and plot.
#include "script/scene_maker.h"

#include "script/numbers.h"
#include "script/suggestion.h"

#include <cmath>

namespace script {

using geometry::Vector;

namespace {

// Forces and links have no names; messages call them by what they act on.
std::string named(const std::string& before, const std::string& alone, const Call& call,
                  std::string_view option) {
    for (std::size_t i = 1; i + 1 < call.words.size(); i += 2)
        if (call.words[i].text == option && !call.words[i + 1].text.starts_with('-'))
            return before + quoted(call.words[i + 1].text);
    return alone;
}

} // namespace

// -x -y -z as expressions. What is left out is zero, unless all are required.
std::optional<std::array<scene::Expression, 3>> SceneMaker::components(Arguments& arguments,
                                                                       bool allRequired) {
    static constexpr std::array<std::string_view, 3> options = {"-x", "-y", "-z"};
    std::array<scene::Expression, 3> result = {"0", "0", "0"};
    bool any = false;
    for (std::size_t i = 0; i < 3; ++i) {
        any = any || arguments.attempted(options[i]);
        if (const Value* value = arguments.find(options[i]))
            result[i] = expression(arguments, options[i], *value,
                                   allRequired ? scene::Reading::positions : scene::Reading::state);
        else if (arguments.attempted(options[i]))
            arguments.wrong(options[i], arguments.optionRange(options[i]), "an expression",
                            "and nothing follows it");
    }
    if (!any)
        return std::nullopt;
    if (allRequired)
        for (const std::string_view option : options)
            if (!arguments.attempted(option)) {
                arguments.wrongElement("wants all of -x, -y and -z, and has no " +
                                       std::string(option));
                break;
            }
    return result;
}

void SceneMaker::force(Call& call) {
    Arguments arguments(faults_, call, named("the force on body ", "the force", call, "-body"), 1,
                        {"-body", "-torque", "-offset", "-x", "-y", "-z", "-frame", "-trajectory",
                         "-gravitational", "-release"});
    scene::Force force;
    if (!arguments.attempted("-body"))
        arguments.wrongElement("wants -body with the name of what it acts on");
    force.body = reference(arguments, "-body", Kind::body).value_or("");
    force.couple = arguments.flag("-torque").value_or(false);
    force.offset = arguments.vector("-offset");
    force.release = expressionOf(arguments, "-release", scene::Reading::release);

    scene::ComponentForce components;
    if (const auto frame = arguments.name("-frame", "a frame, world or body")) {
        if (*frame == "body")
            components.frame = scene::Frame::body;
        else if (*frame != "world")
            arguments.wrong("-frame", arguments.find("-frame")->range, "world or body",
                            "not " + quoted(*frame));
    }
    int kinds = 0;
    if (const auto xyz = this->components(arguments, false)) {
        components.components = *xyz;
        force.kind = components;
        ++kinds;
    }
    if (arguments.attempted("-trajectory")) {
        force.kind = scene::TrajectoryForce{
            reference(arguments, "-trajectory", Kind::trajectory).value_or("")};
        ++kinds;
    }
    if (arguments.attempted("-gravitational")) {
        force.kind =
            scene::GravitationalForce{arguments.vector("-gravitational").value_or(Vector::Zero())};
        ++kinds;
    }
    if (kinds != 1)
        arguments.wrongElement(kinds == 0 ? "wants one of -x -y -z, -trajectory and -gravitational"
                                          : "has more than one of -x -y -z, -trajectory and "
                                            "-gravitational");
    else if (arguments.attempted("-frame") &&
             !std::holds_alternative<scene::ComponentForce>(force.kind))
        faults_.error(arguments.optionRange("-frame"),
                      "-frame says how -x -y -z are meant, and the force has none");
    if (force.couple && std::holds_alternative<scene::GravitationalForce>(force.kind) && kinds == 1)
        faults_.error(arguments.optionRange("-torque"),
                      "a -gravitational force acts on the mass, and cannot be a couple");
    force.source = call.source;
    made_.scene.forces.push_back(std::move(force));
}

// -body1 -offset1, and one of -body2 -offset2, -x -y -z and -trajectory.
void SceneMaker::ends(Arguments& arguments, std::string_view what, scene::Link& link) {
    const std::string word(what);
    if (!arguments.attempted("-body1"))
        arguments.wrongElement("wants -body1 with the name of what it holds");
    link.first.body = reference(arguments, "-body1", Kind::body).value_or("");
    link.first.offset = arguments.vector("-offset1");
    int ends = 0;
    const auto offset2 = arguments.vector("-offset2");
    if (arguments.attempted("-body2")) {
        const auto name = reference(arguments, "-body2", Kind::body);
        if (name && *name == link.first.body)
            faults_.error(arguments.find("-body2")->range,
                          "a " + word + " cannot join body " + quoted(*name) + " to itself");
        link.second = scene::BodyEnd{name.value_or(""), offset2};
        ++ends;
    } else if (arguments.attempted("-offset2")) {
        faults_.error(arguments.optionRange("-offset2"),
                      "-offset2 is a point of -body2, and the " + word + " has none");
    }
    if (const auto xyz = components(arguments, true)) {
        link.second = scene::PointEnd{*xyz};
        ++ends;
    }
    if (arguments.attempted("-trajectory")) {
        link.second = scene::TrajectoryEnd{
            reference(arguments, "-trajectory", Kind::trajectory).value_or("")};
        ++ends;
    }
    if (ends != 1)
        arguments.wrongElement(ends == 0 ? "wants one of -body2, -x -y -z and -trajectory"
                                         : "has more than one of -body2, -x -y -z and -trajectory");
}

void SceneMaker::link(Call& call) {
    Arguments arguments(faults_, call, named("the link of body ", "the link", call, "-body1"), 1,
                        {"-body1", "-offset1", "-body2", "-offset2", "-x", "-y", "-z",
                         "-trajectory", "-tightness", "-damping", "-release"});
    scene::Link link;
    ends(arguments, "link", link);
    if (!arguments.attempted("-tightness"))
        arguments.wrongElement("wants -tightness, the stiffness of its spring");
    link.tightness = arguments.number("-tightness", Sign::notNegative).value_or(0);
    link.damping = arguments.number("-damping", Sign::notNegative);
    link.release = expressionOf(arguments, "-release", scene::Reading::release);
    link.source = call.source;
    made_.scene.links.push_back(std::move(link));
}

void SceneMaker::spring(Call& call) {
    scene::Link spring;
    std::size_t first = 1;
    spring.name = optionalName(call, Kind::spring, first);
    Arguments arguments(
        faults_, call,
        spring.name.empty() ? named("the spring of body ", "the spring", call, "-body1")
                            : "spring " + quoted(spring.name),
        first,
        {"-body1", "-offset1", "-body2", "-offset2", "-x", "-y", "-z", "-trajectory", "-stiffness",
         "-rest", "-damping", "-pull_only", "-release"});
    ends(arguments, "spring", spring);
    if (!arguments.attempted("-stiffness"))
        arguments.wrongElement("wants -stiffness, its force for each unit of length");
    spring.tightness = arguments.number("-stiffness", Sign::notNegative).value_or(0);
    spring.damping = arguments.number("-damping", Sign::notNegative).value_or(0);
    spring.release = expressionOf(arguments, "-release", scene::Reading::release);
    spring.spring = scene::SpringLaw{arguments.number("-rest", Sign::notNegative),
                                     arguments.flag("-pull_only").value_or(false)};
    spring.source = call.source;
    made_.scene.links.push_back(std::move(spring));
}

void SceneMaker::simulator(Call& call) {
    Arguments arguments(faults_, call, "the simulator", 1,
                        {"-start", "-finish", "-step", "-accuracy", "-method", "-collisions"});
    if (simulatorSeen_) {
        std::string message = "there is a simulator already";
        if (made_.scene.simulator.source && made_.scene.simulator.source->line > 0)
            message += ", at line " + std::to_string(made_.scene.simulator.source->line);
        faults_.error(call.words[0].range, message);
        return;
    }
    simulatorSeen_ = true;
    scene::Simulator& simulator = made_.scene.simulator;
    simulator.start = arguments.number("-start").value_or(0);
    const auto finish = arguments.number("-finish");
    simulator.finish = finish.value_or(10);
    const bool read = (finish || !arguments.attempted("-finish"));
    for (const auto& [option, time] :
         {std::pair("-start", simulator.start), std::pair("-finish", simulator.finish)})
        if (std::abs(time) > 1e100)
            arguments.wrong(option, arguments.find(option)->range, "a number of at most 1e100",
                            "not " + numberText(time, true));
    if (read && !(simulator.finish > simulator.start)) {
        const std::string_view option = arguments.has("-finish") ? "-finish" : "-start";
        faults_.error(arguments.find(option) ? arguments.find(option)->range
                                             : arguments.commandRange(),
                      "the simulator finishes at " + numberText(simulator.finish, true) +
                          ", which is not after its start at " + numberText(simulator.start, true));
    }
    simulator.firstStep = arguments.number("-step", Sign::positive);
    simulator.accuracy = arguments.number("-accuracy", Sign::positive).value_or(1e-4);
    static const std::vector<std::string> methods = {
        "auto",           "forward-euler", "symplectic-euler", "midpoint", "rk4", "trapezoidal",
        "backward-euler", "tsit5",         "dopri5",           "dop853",   "gbs", "tr-bdf2",
        "radau5",         "sdirk4",        "rodas4",           "original"};
    if (const auto method = arguments.name("-method", "a method")) {
        simulator.method = *method;
        if (std::find(methods.begin(), methods.end(), *method) == methods.end())
            faults_.error(arguments.find("-method")->range,
                          "the simulator has no method " + quoted(*method),
                          suggestionFor(*method, methods, "methods", methods.size()));
    }
    simulator.collisions = arguments.flag("-collisions").value_or(true);
    simulator.source = call.source;
}

void SceneMaker::parameter(Call& call) {
    scene::Parameter parameter;
    parameter.name = newName(call, Kind::parameter);
    if (parameter.name.empty())
        return;
    Arguments arguments(faults_, call, "parameter " + quoted(parameter.name), 2,
                        {"-value", "-min", "-max", "-label", "-unit"});
    parameter.minimum = arguments.number("-min");
    parameter.maximum = arguments.number("-max");
    const auto value = arguments.number("-value");
    parameter.value = value.value_or(0);
    parameter.label = arguments.text("-label").value_or("");
    parameter.unit = arguments.text("-unit").value_or("");
    const bool crossed =
        parameter.minimum && parameter.maximum && *parameter.minimum > *parameter.maximum;
    if (crossed)
        faults_.error(arguments.find("-max")->range,
                      arguments.subject() + " has a -max below its -min");
    const auto outside = [&](double v) {
        return (parameter.minimum && v < *parameter.minimum) ||
               (parameter.maximum && v > *parameter.maximum);
    };
    if (value && outside(*value) && !crossed)
        faults_.error(arguments.find("-value")->range,
                      arguments.subject() + " is outside its -min and -max");
    if (const auto given = overrides_.find(parameter.name); given != overrides_.end()) {
        if (outside(given->second) || !std::isfinite(given->second))
            faults_.error({}, arguments.subject() + " cannot be " +
                                  numberText(given->second, true) +
                                  ", which is outside its -min and -max");
        parameter.value = given->second;
    }
    parameter.source = call.source;
    made_.scene.parameters.push_back(std::move(parameter));
}

void SceneMaker::plot(Call& call) {
    scene::Plot plot;
    plot.name = newName(call, Kind::plot);
    if (plot.name.empty())
        return;
    Arguments arguments(faults_, call, "plot " + quoted(plot.name), 2,
                        {"-values", "-labels", "-title", "-beside"});
    constexpr std::string_view wants = "a list of expressions";
    if (const Value* values = arguments.find("-values")) {
        for (const Value& value :
             arguments.listIn("-values", *values, wants).value_or(std::vector<Value>{}))
            plot.values.push_back(
                expression(arguments, "-values", value, scene::Reading::quantities));
        if (plot.values.empty())
            arguments.wrong("-values", values->range, wants, "and gets none");
    } else if (arguments.attempted("-values")) {
        arguments.wrong("-values", arguments.optionRange("-values"), wants,
                        "and nothing follows it");
    } else {
        arguments.wrongElement("wants -values with the expressions to chart");
    }
    if (const Value* labels = arguments.find("-labels")) {
        for (const Value& label :
             arguments.listIn("-labels", *labels, "a list of texts").value_or(std::vector<Value>{}))
            plot.labels.push_back(label.text);
        if (plot.labels.size() != plot.values.size() && !plot.values.empty())
            arguments.wrong("-labels", labels->range,
                            "as many texts as there are -values (" +
                                std::to_string(plot.values.size()) + ")",
                            "and gets " + std::to_string(plot.labels.size()));
    } else if (arguments.attempted("-labels")) {
        arguments.text("-labels");
    }
    plot.title = arguments.text("-title").value_or("");
    plot.beside = arguments.flag("-beside").value_or(false);
    plot.source = call.source;
    made_.scene.plots.push_back(std::move(plot));
}

} // namespace script
