#include "script/scene_maker.h"

#include "script/commands.h"
#include "script/suggestion.h"

#include "expression/parse.h"

#include <algorithm>
#include <set>

namespace script {

namespace {

constexpr std::string_view kindNames[] = {"shape set", "body",         "trajectory", "parameter",
                                          "joint",     "gear",         "rope",       "contact",
                                          "spring",    "light source", "view",       "plot"};
constexpr std::string_view kindLists[] = {
    "shape sets here", "bodies here",        "trajectories here", "parameters here",
    "joints here",     "gears here",         "ropes here",        "contacts here",
    "springs here",    "light sources here", "views here",        "plots here"};

template <typename Kind> std::string_view nameOf(Kind kind) {
    return kindNames[static_cast<std::size_t>(kind)];
}

bool startsName(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' ||
           static_cast<unsigned char>(c) >= 0x80;
}

bool continuesName(char c) { return startsName(c) || (c >= '0' && c <= '9'); }

} // namespace

SceneMaker::SceneMaker(std::string_view text, const std::map<std::string, double>& parameters,
                       MadeScene& made)
    : text_(text), overrides_(parameters), made_(made), places_(text),
      faults_(places_, made.diagnostics) {}

void SceneMaker::make(Call& call) {
    const Range known = call.source.command.known() ? call.source.command : call.words[0].range;
    if (known.known()) {
        const text::Position place = places_.at(known.from);
        call.source.line = place.line;
        call.source.column = place.column;
    }
    using Maker = void (SceneMaker::*)(Call&);
    static const std::map<std::string_view, Maker> makers = {
        {"simulator", &SceneMaker::simulator},
        {"shape_set", &SceneMaker::shapeSet},
        {"body", &SceneMaker::body},
        {"instance", &SceneMaker::body},
        {"force", &SceneMaker::force},
        {"link", &SceneMaker::link},
        {"joint", &SceneMaker::joint},
        {"gear", &SceneMaker::gear},
        {"rope", &SceneMaker::rope},
        {"contact", &SceneMaker::contact},
        {"spring", &SceneMaker::spring},
        {"trajectory", &SceneMaker::trajectory},
        {"constrain", &SceneMaker::constrain},
        {"lightsource", &SceneMaker::lightSource},
        {"view", &SceneMaker::view},
        {"parameter", &SceneMaker::parameter},
        {"plot", &SceneMaker::plot}};
    const auto maker = makers.find(call.words[0].text);
    if (maker != makers.end())
        (this->*maker->second)(call);
}

// --- names ----------------------------------------------------------------------------------

namespace {

bool isSymbol(std::string_view kind) {
    return kind == "body" || kind == "trajectory" || kind == "parameter" || kind == "joint" ||
           kind == "gear" || kind == "rope" || kind == "contact" || kind == "spring";
}

std::string keyOf(std::string_view kind, const std::string& name) {
    return (isSymbol(kind) ? std::string("symbol") : std::string(kind)) + "\n" + name;
}

} // namespace

bool SceneMaker::exists(Kind kind, const std::string& name) const {
    if (!isSymbol(nameOf(kind)))
        return defined_.contains(keyOf(nameOf(kind), name));
    const auto found = symbols_.find(name);
    return found != symbols_.end() && found->second == kind;
}

std::string SceneMaker::suggest(Kind kind, const std::string& name) {
    constexpr int mostSuggestions = 300;
    constexpr std::size_t mostNames = 1000;
    if (++suggestions_ > mostSuggestions)
        return "";
    const std::vector<std::string>& all = others_[kind];
    return suggestionFor(name, std::span(all).first(std::min(all.size(), mostNames)),
                         kindLists[static_cast<std::size_t>(kind)]);
}

void SceneMaker::registerName(const std::string& name, const Value& word, Kind kind) {
    const bool symbol = isSymbol(nameOf(kind));
    const std::string key = keyOf(nameOf(kind), name);
    if (const auto found = defined_.find(key); found != defined_.end()) {
        const Kind before = symbol ? symbols_.at(name) : kind;
        std::string message =
            "there is a " + std::string(nameOf(before)) + " " + quoted(name) + " already";
        if (found->second.known())
            message += ", at line " + std::to_string(places_.at(found->second.from).line);
        faults_.error(word.range, std::move(message),
                      symbol && before != kind
                          ? "bodies, trajectories, parameters, joints, gears, "
                            "ropes, contacts and springs share one set of names"
                          : "");
        return;
    }
    defined_[key] = word.range;
    if (symbol)
        symbols_[name] = kind;
    others_[kind].push_back(name);
}

// Names that expressions can read.
bool SceneMaker::validSymbol(const std::string& name, const Value& word, Kind kind) {
    static constexpr std::string_view taken[] = {"t", "pi", "scene", "events"};
    const auto& functions = expression::functionNames();
    // A function's name before a dot is clear (floor.y), alone it is not.
    const bool function = kind == Kind::parameter &&
                          std::find(functions.begin(), functions.end(), name) != functions.end();
    if (function || std::find(std::begin(taken), std::end(taken), name) != std::end(taken)) {
        faults_.error(word.range, "a " + std::string(nameOf(kind)) + " cannot be called " +
                                      quoted(name) + ": expressions use that name");
        return false;
    }
    if (!startsName(name[0]) || !std::all_of(name.begin(), name.end(), continuesName)) {
        faults_.error(word.range, "the name of a " + std::string(nameOf(kind)) +
                                      " is letters, digits and _, " + "and starts with no digit; " +
                                      quoted(name) + " could not be read in expressions");
        return false;
    }
    return true;
}

std::string SceneMaker::newName(Call& call, Kind kind) {
    const std::string command = call.words[0].text;
    if (call.words.size() < 2) {
        faults_.error(call.words[0].range, command + " wants a name, and nothing follows it");
        return "";
    }
    const Value& word = call.words[1];
    if (word.text.empty() || word.text.starts_with('-')) {
        faults_.error(word.range, command + " wants a name first, not " + quoted(word.text));
        return "";
    }
    call.source.arguments.push_back({"", word.range, word.exact});
    if (isSymbol(nameOf(kind)))
        validSymbol(word.text, word, kind);
    registerName(word.text, word, kind);
    return word.text;
}

std::string SceneMaker::optionalName(Call& call, Kind kind, std::size_t& first) {
    first = 1;
    if (call.words.size() < 2 || call.words[1].text.starts_with('-') || call.words[1].text.empty())
        return "";
    first = 2;
    return newName(call, kind);
}

bool SceneMaker::refers(Arguments& arguments, std::string_view option, const std::string& name,
                        Kind kind) {
    if (exists(kind, name))
        return true;
    const Value* value = arguments.find(option);
    faults_.error(value ? value->range : arguments.commandRange(),
                  arguments.subject() + ": no " + std::string(nameOf(kind)) + " named " +
                      quoted(name),
                  suggest(kind, name));
    return false;
}

std::optional<std::string> SceneMaker::reference(Arguments& arguments, std::string_view option,
                                                 Kind kind) {
    auto name = arguments.name(option, "a " + std::string(nameOf(kind)));
    if (name)
        refers(arguments, option, *name, kind);
    return name;
}

// --- the whole ------------------------------------------------------------------------------

void SceneMaker::finish(bool finished) {
    checkHolds();
    checkPlanes();
    checkJoints();
    if (finished)
        checkExpressions();
    if (finished && made_.diagnostics.empty())
        warnOfUnusedParameters();
    checkOverrides(finished);
}

namespace {

bool isNamed(std::string_view text, std::size_t at, std::string_view name) {
    const std::size_t end = at + name.size();
    return (at == 0 || !continuesName(text[at - 1])) &&
           (end >= text.size() || !continuesName(text[end]));
}

} // namespace

// A parameter that moves nothing is most likely misspelt where it should.
void SceneMaker::warnOfUnusedParameters() {
    constexpr std::size_t mostSearched = 100;
    if (made_.scene.parameters.size() > mostSearched)
        return;
    for (const scene::Parameter& parameter : made_.scene.parameters) {
        const Range own = parameter.source.command;
        if (!own.known() || parameter.source.arguments.empty())
            continue;
        bool used = false;
        for (auto at = text_.find(parameter.name); at != std::string_view::npos && !used;
             at = text_.find(parameter.name, at + 1))
            used = (at < own.from || at >= own.to) && isNamed(text_, at, parameter.name);
        if (!used)
            faults_.warning(parameter.source.arguments[0].word,
                            "parameter " + quoted(parameter.name) +
                                " is read by no expression and no script");
    }
}

void SceneMaker::checkOverrides(bool finished) {
    if (!finished)
        return;
    for (const auto& [name, value] : overrides_) {
        const auto found = std::find_if(
            made_.scene.parameters.begin(), made_.scene.parameters.end(),
            [&, wanted = name](const scene::Parameter& p) { return p.name == wanted; });
        if (found == made_.scene.parameters.end())
            faults_.error({}, "the scene has no parameter " + quoted(name),
                          suggest(Kind::parameter, name));
    }
}

std::string SceneMaker::expression(Arguments& arguments, std::string_view option,
                                   const Value& value, scene::Reading reading) {
    const std::string subject = std::string(option) + " of " + arguments.subject();
    if (value.text.find_first_not_of(" \t\r\n") == std::string::npos) {
        arguments.wrong(option, value.range, "an expression", "not an empty one");
        return "0";
    }
    expressions_.push_back({value, subject, reading});
    return value.text;
}

MadeScene makeScene(std::string_view text, const Structure& structure, const Recording& recording,
                    bool finished, const std::map<std::string, double>& parameters) {
    MadeScene made;
    std::map<std::uint64_t, int> runs;
    for (const RecordedCommand& command : recording.commands)
        ++runs[command.offset];
    SceneMaker maker(text, parameters, made);
    for (const RecordedCommand& command : recording.commands) {
        Call call = callOf(text, structure, command);
        if (command.offset != noOffset)
            call.source.runs = runs[command.offset];
        maker.make(call);
    }
    maker.finish(finished);
    return made;
}

} // namespace script
