#include "batch/explanation_text.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstdio>
#include <limits>
#include <map>
#include <set>
#include <string_view>
#include <tuple>

namespace batch {
namespace {

using simulation::Explanation;
using Component = Explanation::Component;

constexpr std::size_t everything = std::numeric_limits<std::size_t>::max();

std::string counted(std::size_t count, const std::string& one, const std::string& many) {
    return std::to_string(count) + " " + (count == 1 ? one : many);
}

struct Word {
    const char *one, *many, *names; // of the unknowns, by the last part of their names
};
constexpr Word kindWords[] = {{"a place", "places", " x y z "},
                              {"a velocity", "velocities", " dx dy dz "},
                              {"an attitude", "attitudes", " qw qx qy qz "},
                              {"a spin", "spins", " w1 w2 w3 wx wy wz "},
                              {"an angle of a joint", "angles of joints", " q q1 q2 q3 "}};

std::string bodyOf(const std::string& unknown) { return unknown.substr(0, unknown.rfind('.')); }
std::string lastOf(const std::string& unknown) { return unknown.substr(unknown.rfind('.') + 1); }

bool isOne(const std::string& unknown, const Word& word) {
    return std::string_view(word.names).find(" " + lastOf(unknown) + " ") != std::string_view::npos;
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

// The four numbers of an attitude are one.
std::vector<std::string> kindsOf(const Component& component) {
    std::vector<std::string> kinds;
    for (const Word& word : kindWords) {
        std::set<std::string> bodies;
        for (const std::string& unknown : component.unknowns)
            if (isOne(unknown, word))
                bodies.insert(bodyOf(unknown));
        if (!bodies.empty())
            kinds.emplace_back(bodies.size() == 1 ? word.one : word.many);
    }
    const auto others = std::ranges::count_if(component.unknowns, [](const std::string& unknown) {
        return std::ranges::none_of(kindWords,
                                    [&](const Word& word) { return isOne(unknown, word); });
    });
    if (others > 0) // of joints, gears and ropes: what keeps them, and when they are released
        kinds.push_back(counted(static_cast<std::size_t>(others), "condition", "conditions"));
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
    if (c.method.empty()) // it stopped before a method was chosen
        return "not solved: its motion stopped where it would have begun";
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

bool isNamed(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '.' ||
           static_cast<unsigned char>(c) >= 0x80;
}

// Where the name or number ends that begins at `at`; `at` when none does.
std::size_t endOfWord(const std::string& text, std::size_t at) {
    const bool isNumber = at < text.size() && std::isdigit(static_cast<unsigned char>(text[at]));
    std::size_t end = at;
    while (end < text.size() &&
           (isNamed(text[end]) || (isNumber && end > at && text[end - 1] == 'e' &&
                                   (text[end] == '-' || text[end] == '+'))))
        ++end;
    return end;
}

// Numbers with ten digits: what rounding leaves in the others is no part of a law.
std::string rounded(const std::string& equation) {
    std::string text;
    for (std::size_t at = 0; at < equation.size();) {
        const std::size_t end = std::max(endOfWord(equation, at), at + 1);
        const std::string word = equation.substr(at, end - at);
        at = end;
        if (std::isdigit(static_cast<unsigned char>(word[0])) == 0 || word.size() <= 11) {
            text += word;
            continue;
        }
        double value = 0; // one too small for a double stays as it is written
        const auto read = std::from_chars(word.data(), word.data() + word.size(), value);
        char digits[40];
        std::snprintf(digits, sizeof digits, "%.10g", value);
        text += read.ec == std::errc() ? digits : word;
    }
    return text;
}

enum class Numbers { any, same };

// Equations with other names: the same law. Names become their order; where any numbers will do,
// numbers but 0 a sign.
std::string lawOf(const std::vector<std::string>& equations, Numbers numbers) {
    std::string law;
    std::map<std::string, std::size_t> names;
    for (const std::string& equation : equations) {
        for (std::size_t at = 0; at < equation.size();) {
            std::size_t end = endOfWord(equation, at);
            const std::string word = equation.substr(at, end - at);
            if (word.empty())
                law += equation[end++];
            else if (std::isdigit(static_cast<unsigned char>(word[0])) != 0)
                law += word == "0" || numbers == Numbers::same ? word : "#";
            else if (word.find('.') == std::string::npos)
                law += word; // a function, or the time
            else
                law += "$" + std::to_string(names.try_emplace(word, names.size()).first->second);
            at = end;
        }
        law += '\n';
    }
    return law;
}

class Writer {
public:
    Writer(const Explanation& explanation, Detail detail) : explanation_(explanation) {
        if (detail == Detail::all)
            mostNames_ = mostLines_ = longestLine_ = mostBodies_ = mostLaws_ = longestPart_ =
                everything;
    }
    [[nodiscard]] std::string text() const;

private:
    [[nodiscard]] std::string shortened(const std::string& line) const;
    [[nodiscard]] std::string more(std::size_t count, const std::string& what) const {
        return "    and " + std::to_string(count) + " more" + what + " (--all shows all)\n";
    }
    [[nodiscard]] std::string sentenceOf(const std::vector<std::string>& parts) const;
    [[nodiscard]] std::string acting() const;
    [[nodiscard]] std::string laws(const std::vector<const Component*>& components) const;
    [[nodiscard]] std::string equations(const Component& component) const;
    [[nodiscard]] std::string paragraph(const std::vector<const Component*>& components) const;
    [[nodiscard]] std::string notModelled() const;
    [[nodiscard]] std::string notation() const;
    [[nodiscard]] std::string pairs() const;

    const Explanation& explanation_;
    std::size_t mostNames_ = 6, mostLines_ = 13, longestLine_ = 160, mostBodies_ = 12,
                mostLaws_ = 8, longestPart_ = 80;
};

std::string Writer::shortened(const std::string& line) const {
    constexpr std::string_view cut = " ... (--all shows all)";
    return line.size() <= longestLine_
               ? line
               : line.substr(0, longestLine_ - cut.size()) + std::string(cut);
}

// Each part cut where it is too long, so that a long one hides no other.
std::string Writer::sentenceOf(const std::vector<std::string>& parts) const {
    std::string text = parts.empty() ? "nothing" : "";
    bool isCut = parts.size() > mostLines_;
    for (std::size_t i = 0; i < std::min(parts.size(), mostLines_); ++i) {
        const bool isLong = parts[i].size() > longestPart_;
        isCut = isCut || isLong;
        text += (i == 0 ? "" : "; ") + parts[i].substr(0, longestPart_) + (isLong ? " ..." : "");
    }
    if (parts.size() > mostLines_)
        text += "; and " + std::to_string(parts.size() - mostLines_) + " more";
    return text + (isCut ? " (--all shows all)" : "");
}

// Bodies on which the same acts are told together, in the order of the scene.
std::string Writer::acting() const {
    std::vector<std::pair<std::vector<std::string>, std::vector<std::string>>> groups;
    for (const simulation::Acting& acting : explanation_.acting) {
        const std::vector<std::string>& what = acting.what;
        auto group = std::ranges::find(groups, what, [](const auto& g) { return g.first; });
        if (group == groups.end())
            group = groups.insert(groups.end(), {what, {}});
        group->second.push_back(acting.body);
    }
    if (groups.empty())
        return "No body moves: all are fixed, or there is none.\n";
    std::string text = "What acts:\n";
    std::size_t told = 0;
    for (std::size_t i = 0; i < std::min(groups.size(), mostBodies_); ++i) {
        const std::vector<std::string>& what = groups[i].first;
        text += "    " + listOf(groups[i].second, mostNames_) + ": " + sentenceOf(what) + "\n";
        told += groups[i].second.size();
    }
    if (groups.size() > mostBodies_)
        text += more(explanation_.acting.size() - told, " bodies");
    return text;
}

std::string Writer::equations(const Component& component) const {
    std::string text;
    const std::size_t count = component.equations.size();
    for (std::size_t i = 0; i < std::min(count, mostLines_); ++i)
        text += shortened("    " + rounded(component.equations[i])) + "\n";
    if (count > mostLines_)
        text += more(count - mostLines_, count - mostLines_ == 1 ? " equation" : " equations");
    for (std::size_t i = 0; i < std::min(component.earlier.size(), mostLines_); ++i)
        text += shortened("    before: " + rounded(component.earlier[i])) + "\n";
    if (component.earlier.size() > mostLines_)
        text += more(component.earlier.size() - mostLines_, " that ended");
    return text;
}

// Each law once, with how many follow it; all of them where everything is to be told.
std::string Writer::laws(const std::vector<const Component*>& components) const {
    struct Law {
        std::string form, numbers;
        const Component* first;
        std::vector<std::string> same, alike; // with the same numbers, and with others
    };
    std::vector<Law> laws;
    for (const Component* c : components) {
        std::vector<std::string> all = c->equations;
        all.insert(all.end(), c->earlier.begin(), c->earlier.end());
        std::string numbers = lawOf(all, Numbers::same);
        std::string form = mostLaws_ == everything ? numbers : lawOf(all, Numbers::any);
        const std::string name = c->unknowns.size() == 1 ? c->unknowns[0] : bodyOf(c->unknowns[0]);
        const auto known = std::ranges::find(laws, form, &Law::form);
        if (known == laws.end())
            laws.push_back({std::move(form), std::move(numbers), c, {}, {}});
        else
            (known->numbers == numbers ? known->same : known->alike).push_back(name);
    }
    std::string text;
    for (std::size_t i = 0; i < std::min(laws.size(), mostLaws_); ++i) {
        text += equations(*laws[i].first);
        if (!laws[i].same.empty())
            text += "    likewise " + listOf(laws[i].same, mostNames_) + "\n";
        if (!laws[i].alike.empty())
            text += "    with other numbers " + listOf(laws[i].alike, mostNames_) + "\n";
    }
    if (laws.size() > mostLaws_)
        text += more(laws.size() - mostLaws_, " laws of other forms");
    return text;
}

std::string Writer::paragraph(const std::vector<const Component*>& components) const {
    const Component& first = *components.front();
    const std::size_t count = components.size(), unknowns = first.unknowns.size();
    std::size_t steps = 0, evaluations = 0;
    for (const Component* c : components) {
        steps += c->steps;
        evaluations += c->evaluations;
    }
    std::string text = counted(count, "component", "components") + " of " +
                       counted(unknowns, "unknown", "unknowns") + (count == 1 ? "" : " each") +
                       " (" + listOf(kindsOf(first), 5) + "), " + howOf(first) +
                       (first.why.empty() ? "" : ": " + first.why) + ". " +
                       counted(steps, "step", "steps") + ", " +
                       counted(evaluations, "evaluation", "evaluations") + ".\n" + laws(components);
    return text;
}

// "b2.y, b2.z" of one body -> "y, z of b2"; bodies of which the same is left out are told together.
std::string Writer::notModelled() const {
    if (explanation_.notModelled.empty())
        return "";
    std::vector<std::tuple<std::string, std::string, std::vector<std::string>>> lines;
    for (const Explanation::NotModelled& left : explanation_.notModelled) {
        std::string what = left.what;
        const std::string body =
            what.find('.') == std::string::npos ? "" : what.substr(0, what.find('.'));
        if (!body.empty())
            for (auto at = what.find(body + "."); at != std::string::npos;
                 at = what.find(body + ".", at))
                what.erase(at, body.size() + 1);
        auto line = std::ranges::find_if(lines, [&](const auto& l) {
            return std::get<0>(l) == what && std::get<1>(l) == left.why;
        });
        if (line == lines.end())
            line = lines.insert(lines.end(), {what, left.why, {}});
        if (!body.empty())
            std::get<2>(*line).push_back(body);
    }
    std::string text = "\nNot modelled:\n";
    for (const auto& [what, why, bodies] : lines)
        text += "    " + what + (bodies.empty() ? "" : " of " + listOf(bodies, mostNames_)) + ": " +
                why + "\n";
    return text;
}

// Names that authors do not write.
std::string Writer::notation() const {
    for (const Component& c : explanation_.components)
        for (const std::string& unknown : c.unknowns)
            if (const std::string last = lastOf(unknown);
                last == "w1" || last == "w2" || last == "w3")
                return "\nw1, w2, w3 are a body's spin along its own axes; wx, wy, wz along the "
                       "world's.\n";
    return "";
}

std::string Writer::pairs() const {
    if (explanation_.candidates == 0 && explanation_.never.empty())
        return "";
    std::string text = "\n" + counted(explanation_.candidates, "pair", "pairs") +
                       " of bodies came near each other, in " +
                       counted(explanation_.tested, "test", "tests") + ".\n";
    std::map<std::string, std::vector<std::string>> never; // by reason
    for (const Explanation::Never& pair : explanation_.never)
        never[pair.why].push_back(pair.a + "-" + pair.b);
    const std::map<std::string, std::string> sentences{{"linked", "a link joins them"},
                                                       {"joined", "joints join them"},
                                                       {"geared", "a gear couples them"},
                                                       {"same -ct", "they have the same -ct"}};
    for (const auto& [why, pairs] : never) {
        const auto known = sentences.find(why);
        text += "    never, since " + (known != sentences.end() ? known->second : why) + ": " +
                listOf(pairs, mostNames_) + "\n";
    }
    if (explanation_.neverLeftOut > 0)
        text += "    never: " + std::to_string(explanation_.neverLeftOut) +
                " pairs beyond these, which are not listed\n";
    return text;
}

std::string Writer::text() const {
    std::string text = acting();
    for (const auto& [key, components] : kindsOf(explanation_))
        text += "\n" + paragraph(components);
    return text + notation() + notModelled() + pairs();
}

} // namespace

std::string explanationText(const Explanation& explanation, Detail detail) {
    return Writer(explanation, detail).text();
}

std::string phasesText(const Explanation& explanation, const std::string& name) {
    std::string text;
    for (const Explanation::Phases& phases : explanation.phases)
        text += (text.empty() ? "" : "\n") + listOf(phases.unknowns, phases.unknowns.size()) +
                "\n\n" + phases.text;
    return text.empty() ? "Nothing of " + name + " is computed: it stays as it is.\n" : text;
}

namespace {

// Two runs that differ in nothing: of what does not depend on how it is integrated.
std::string whyNoError(const Explanation& explanation) {
    if (explanation.impacts == 0 && !explanation.isAnyResting)
        return ", since nothing is integrated";
    return std::string("; nothing is integrated") +
           (explanation.impacts > 0 ? ", impacts are exact to rounding" : "") +
           (explanation.isAnyResting
                ? ", gaps of resting bodies are within a hundredth of the accuracy"
                : "");
}

} // namespace

std::string accuracyText(const Explanation& explanation, double accuracy,
                         std::optional<double> estimate) {
    if (!estimate)
        return "\nThe error of a method that is asked for by name is not estimated.\n";
    char numbers[120];
    std::snprintf(numbers, sizeof numbers, "\nAccuracy: %.1g asked; the error is estimated at %.1g",
                  accuracy, *estimate);
    return numbers +
           (*estimate == 0 ? whyNoError(explanation) : std::string(" of the scene's size")) + ".\n";
}

std::string explanationJson(const Explanation& explanation) {
    using Json = nlohmann::ordered_json;
    Json components = Json::array(), left = Json::array(), never = Json::array();
    for (const Component& c : explanation.components)
        components.push_back({{"unknowns", c.unknowns},
                              {"reads", c.reads},
                              {"equations", c.equations},
                              {"earlier", c.earlier},
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
    Json acting = Json::array();
    for (const simulation::Acting& a : explanation.acting)
        acting.push_back({{"body", a.body}, {"what", a.what}});
    Json json = {{"acting", acting},
                 {"components", components},
                 {"not_modelled", left},
                 {"pairs",
                  {{"candidates", explanation.candidates},
                   {"tested", explanation.tested},
                   {"left_out", explanation.neverLeftOut},
                   {"never", never}}}};
    for (const Explanation::Phases& phases : explanation.phases)
        json["expressions"].push_back({{"unknowns", phases.unknowns}, {"text", phases.text}});
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace batch
