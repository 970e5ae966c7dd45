#include "batch/explanation_text.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <map>
#include <string_view>
#include <tuple>

namespace batch {
namespace {

using simulation::Explanation;
using Component = Explanation::Component;

constexpr std::size_t mostNames = 6, mostLines = 13, longestLine = 160;

std::string counted(std::size_t count, const std::string& one, const std::string& many) {
    return std::to_string(count) + " " + (count == 1 ? one : many);
}

struct Word {
    const char *one, *many, *names; // of the unknowns, by the last part of their names
};
constexpr Word kindWords[] = {{"a place", "places", " x y z "},
                              {"a velocity", "velocities", " dx dy dz "},
                              {"an attitude", "attitudes", " qw qx qy qz "},
                              {"a spin", "spins", " w1 w2 w3 wx wy wz "}};

bool isOne(const std::string& unknown, const Word& word) {
    const std::string last = " " + unknown.substr(unknown.rfind('.') + 1) + " ";
    return std::string_view(word.names).find(last) != std::string_view::npos;
}

std::string listOf(const std::vector<std::string>& words, std::size_t most) {
    std::string text;
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (i == most && words.size() > most + 1)
            return text + " and " + std::to_string(words.size() - most) + " more";
        text += (i == 0 ? "" : i + 1 == words.size() ? " and " : ", ") + words[i];
    }
    return text;
}

std::vector<std::string> kindsOf(const Component& component) {
    std::vector<std::string> kinds;
    for (const Word& word : kindWords) {
        const auto count = std::ranges::count_if(component.unknowns,
                                                 [&](const auto& u) { return isOne(u, word); });
        if (count > 0)
            kinds.emplace_back(count == 1 ? word.one : word.many);
    }
    return kinds;
}

using Key =
    std::tuple<std::string, std::string, std::string, std::vector<std::string>, std::size_t>;
using Kind = std::pair<Key, std::vector<const Component*>>;

// In the order in which a component of each comes first.
std::vector<Kind> kindsOf(const Explanation& explanation) {
    std::vector<Kind> kinds;
    for (const Component& c : explanation.components) {
        const Key key{c.model, c.method, c.why, kindsOf(c), c.unknowns.size()};
        auto kind = std::ranges::find(kinds, key, &Kind::first);
        if (kind == kinds.end())
            kind = kinds.insert(kinds.end(), {key, {}});
        kind->second.push_back(&c);
    }
    return kinds;
}

std::string howOf(const Component& c) {
    const std::string by =
        " by " + c.method + (c.order > 0 ? " (order " + std::to_string(c.order) + ")" : "");
    if (c.model == "closed-form")
        return c.method == "exact" ? "solved in closed form" : "evaluated, not integrated";
    if (c.model == "linear")
        return "solved by its matrix exponential";
    if (c.model == "quadrature")
        return "integrated over time alone" + by;
    return "integrated" + by + (c.model == "implicit" ? ", implicitly" : ", explicitly");
}

std::string shortened(const std::string& line) {
    return line.size() <= longestLine ? line : line.substr(0, longestLine - 4) + " ...";
}

std::string paragraph(const std::vector<const Component*>& components) {
    const Component& first = *components.front();
    const std::size_t count = components.size(), unknowns = first.unknowns.size();
    std::size_t steps = 0, evaluations = 0;
    for (const Component* c : components) {
        steps += c->steps;
        evaluations += c->evaluations;
    }
    std::string text = counted(count, "component", "components") + " of " +
                       counted(unknowns, "unknown", "unknowns") + (count == 1 ? "" : " each") +
                       " (" + listOf(kindsOf(first), 5) + "), " + howOf(first) + ": " + first.why +
                       ". " + counted(steps, "step", "steps") + ", " +
                       counted(evaluations, "evaluation", "evaluations") + ".";
    text += count == 1 ? "\n" : " For example:\n";
    for (std::size_t i = 0; i < std::min(first.equations.size(), mostLines); ++i)
        text += "    " + shortened(first.equations[i]) + "\n";
    if (first.equations.size() > mostLines)
        text += "    and " + std::to_string(first.equations.size() - mostLines) + " more\n";
    if (!first.reads.empty())
        text +=
            (count == 1 ? "It reads " : "This one reads ") + listOf(first.reads, mostNames) + ".\n";
    return text;
}

std::string pairsText(const Explanation& explanation) {
    if (explanation.candidates == 0 && explanation.never.empty())
        return "";
    std::string text = counted(explanation.candidates, "pair", "pairs") +
                       " of bodies came near each other, in " +
                       counted(explanation.tested, "test", "tests") + ".\n";
    std::map<std::string, std::vector<std::string>> never; // by reason
    for (const Explanation::Never& pair : explanation.never)
        never[pair.why].push_back(pair.a + "-" + pair.b);
    for (const auto& [why, pairs] : never)
        text += "    never, since " +
                (why == "linked"     ? std::string("a link joins them")
                 : why == "same -ct" ? "they have the same -ct"
                                     : why) +
                ": " + listOf(pairs, mostNames) + "\n";
    return text;
}

} // namespace

std::string explanationText(const Explanation& explanation) {
    std::string text;
    for (const auto& [key, components] : kindsOf(explanation))
        text += (text.empty() ? "" : "\n") + paragraph(components);
    if (!explanation.notModelled.empty()) {
        text += "\nNot modelled:\n";
        for (const Explanation::NotModelled& left : explanation.notModelled)
            text += "    " + left.what + ": " + left.why + "\n";
    }
    const std::string pairs = pairsText(explanation);
    return text + (pairs.empty() ? "" : "\n" + pairs);
}

std::string phasesText(const Explanation& explanation, const std::string& name) {
    std::string text;
    for (const Explanation::Phases& phases : explanation.phases)
        text += (text.empty() ? "" : "\n") + listOf(phases.unknowns, phases.unknowns.size()) +
                "\n\n" + phases.text;
    return text.empty() ? "Nothing of " + name + " is computed: it stays as it is.\n" : text;
}

std::string accuracyText(double accuracy, std::optional<double> estimate) {
    char text[160];
    if (!estimate)
        return "\nThe error of a method that is asked for by name is not estimated.\n";
    std::snprintf(text, sizeof text, "\nAccuracy: %.1g asked; the error is estimated at %.1g%s.\n",
                  accuracy, *estimate,
                  *estimate == 0 ? ", since nothing is integrated" : " of the size of what moves");
    return text;
}

std::string explanationJson(const Explanation& explanation) {
    using Json = nlohmann::ordered_json;
    Json components = Json::array(), left = Json::array(), never = Json::array();
    for (const Component& c : explanation.components)
        components.push_back({{"unknowns", c.unknowns},
                              {"reads", c.reads},
                              {"equations", c.equations},
                              {"model", c.model},
                              {"method", c.method},
                              {"order", c.order},
                              {"steps", c.steps},
                              {"evaluations", c.evaluations},
                              {"why", c.why}});
    for (const Explanation::NotModelled& n : explanation.notModelled)
        left.push_back({{"what", n.what}, {"why", n.why}});
    for (const Explanation::Never& n : explanation.never)
        never.push_back({{"a", n.a}, {"b", n.b}, {"why", n.why}});
    Json json = {{"components", components},
                 {"not_modelled", left},
                 {"pairs",
                  {{"candidates", explanation.candidates},
                   {"tested", explanation.tested},
                   {"never", never}}}};
    for (const Explanation::Phases& phases : explanation.phases)
        json["expressions"].push_back({{"unknowns", phases.unknowns}, {"text", phases.text}});
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace batch
