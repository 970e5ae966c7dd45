// The arguments that each command reads, but for arrays (reader_arrays.cpp).
#include "formulas/reader.h"

#include "text/characters.h"

namespace formulas {

namespace {

struct NamedAlphabet {
    std::string_view name;
    Alphabet alphabet;
};
constexpr NamedAlphabet alphabets[] = {
    {"mathbf", Alphabet::bold},
    {"mathrm", Alphabet::upright},
    {"mathit", Alphabet::italic},
    {"mathbb", Alphabet::blackboard},
    {"mathcal", Alphabet::calligraphic},
    {"mathscr", Alphabet::calligraphic},
    {"mathfrak", Alphabet::fraktur},
    {"mathsf", Alphabet::sans},
    {"mathtt", Alphabet::mono},
    {"mathnormal", Alphabet::normal},
    {"boldsymbol", Alphabet::boldItalic},
    {"bm", Alphabet::boldItalic},
    {"rm", Alphabet::upright},
    {"bf", Alphabet::bold},
    {"it", Alphabet::italic},
    {"text", Alphabet::upright},
    {"textrm", Alphabet::upright},
    {"textbf", Alphabet::bold},
    {"textit", Alphabet::italic},
    {"mbox", Alphabet::upright},
};

struct NamedAmount {
    std::string_view name;
    double amount;
};
// In em.
constexpr NamedAmount spaces[] = {
    {",", 3.0 / 18},
    {"thinspace", 3.0 / 18},
    {":", 4.0 / 18},
    {">", 4.0 / 18},
    {";", 5.0 / 18},
    {"!", -3.0 / 18},
    {"medspace", 4.0 / 18},
    {"quad", 1},
    {"qquad", 2},
    {" ", 0.25},
    {"thickspace", 5.0 / 18},
    {"enspace", 0.5},
    {"\n", 0.25},
    {"negthinspace", -3.0 / 18},
};
// The heights that amsmath gives them.
constexpr NamedAmount bigs[] = {
    {"big", 1.2},  {"bigl", 1.2},  {"bigr", 1.2},  {"bigm", 1.2},  {"Big", 1.8},   {"Bigl", 1.8},
    {"Bigr", 1.8}, {"Bigm", 1.8},  {"bigg", 2.4},  {"biggl", 2.4}, {"biggr", 2.4}, {"biggm", 2.4},
    {"Bigg", 3.0}, {"Biggl", 3.0}, {"Biggr", 3.0}, {"Biggm", 3.0},
};

struct NamedCode {
    std::string_view name;
    char32_t code;
};
constexpr NamedCode stretches[] = {
    {"overbrace", U'⏞'},          {"underbrace", U'⏟'},     {"overbracket", U'⎴'},
    {"underbracket", U'⎵'},       {"overrightarrow", U'→'}, {"overleftarrow", U'←'},
    {"overleftrightarrow", U'↔'},
};
constexpr NamedCode arrows[] = {{"xrightarrow", U'→'}, {"xleftarrow", U'←'}};

struct NamedClass {
    std::string_view name;
    Atom atom;
};
constexpr NamedClass classes[] = {
    {"mathord", Atom::ordinary},      {"mathop", Atom::operation}, {"mathbin", Atom::binary},
    {"mathrel", Atom::relation},      {"mathopen", Atom::opening}, {"mathclose", Atom::closing},
    {"mathpunct", Atom::punctuation}, {"mathinner", Atom::inner},
};

constexpr std::string_view styles[] = {"displaystyle", "textstyle", "scriptstyle",
                                       "scriptscriptstyle"};

template <class Table> const auto& named(const Table& table, std::string_view name) {
    for (const auto& entry : table)
        if (entry.name == name)
            return entry;
    return table[0];
}

std::string withoutEscapes(std::string_view words) {
    std::string shown;
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (words[i] == '\\' && i + 1 < words.size())
            ++i;
        else if (words[i] == '{' || words[i] == '}')
            continue;
        const bool blank = words[i] == '\n' || words[i] == '\r' || words[i] == '\t';
        shown += blank || words[i] == '~' ? ' ' : words[i];
    }
    return shown;
}

} // namespace

const std::unordered_map<std::string_view, Reader::Handler>& Reader::handlers() {
    static const auto table = [] {
        std::unordered_map<std::string_view, Handler> map;
        for (const char* name : {"frac", "dfrac", "tfrac", "cfrac", "binom", "dbinom", "tbinom"})
            map[name] = &Reader::fraction;
        for (const NamedAlphabet& entry : alphabets)
            map[entry.name] = &Reader::alphabet;
        for (const char* name : {"rm", "bf", "it"})
            map[name] = &Reader::switchAlphabet;
        for (const char* name : {"text", "textrm", "textbf", "textit", "mbox"})
            map[name] = &Reader::words;
        for (const NamedAmount& entry : spaces)
            map[entry.name] = &Reader::namedSpace;
        for (const NamedAmount& entry : bigs)
            map[entry.name] = &Reader::bigDelimiter;
        for (const NamedCode& entry : stretches)
            map[entry.name] = &Reader::stretch;
        for (const NamedCode& entry : arrows)
            map[entry.name] = &Reader::arrow;
        for (const NamedClass& entry : classes)
            map[entry.name] = &Reader::classed;
        for (const std::string_view name : styles)
            map[name] = &Reader::styleSwitch;
        for (const char* name : {"overset", "underset", "stackrel"})
            map[name] = &Reader::stacked;
        for (const char* name : {"phantom", "hphantom", "vphantom"})
            map[name] = &Reader::phantom;
        for (const char* name : {"overline", "underline"})
            map[name] = &Reader::bar;
        for (const char* name : {"bmod", "pmod", "mod"})
            map[name] = &Reader::modulo;
        map["sqrt"] = &Reader::root;
        map["operatorname"] = &Reader::operatorName;
        map["left"] = &Reader::fence;
        map["substack"] = &Reader::substack;
        map["not"] = &Reader::negation;
        map["value"] = &Reader::value;
        map["begin"] = &Reader::environment;
        return map;
    }();
    return table;
}

NodeId Reader::fraction(const Token& token) {
    const std::string_view name = token.name();
    const bool binomial = name.ends_with("binom");
    const NodeId id = add(Kind::fraction, token);
    formula_.nodes[id].amount = binomial ? 0 : 1;
    if (name.front() == 'd' || name.front() == 'c' || name.front() == 't') {
        formula_.nodes[id].styled = true;
        formula_.nodes[id].style = name.front() == 't' ? Style::text : Style::display;
    }
    const NodeId above = argument(token, 0, 2);
    const NodeId below = argument(token, 1, 2);
    formula_.nodes[id].children = {above, below};
    finish(id);
    return binomial ? delimited(U'(', id, U')', token) : id;
}

NodeId Reader::delimited(char32_t open, NodeId part, char32_t close, const Token& from) {
    const NodeId id = add(Kind::fenced, from);
    Node& node = formula_.nodes[id];
    node.atom = Atom::inner;
    node.delimiters = {open, close};
    node.children = {part};
    return finish(id);
}

NodeId Reader::root(const Token& token) {
    const NodeId id = add(Kind::root, token);
    NodeId degree = none;
    if (peek().text == "[") {
        const Token open = next();
        const Waiting outer = waiting_;
        waiting_.bracket = true;
        degree = list();
        waiting_ = outer;
        if (peek().text == "]")
            (void)next();
        else
            fault(open, "The [ of \\sqrt has no ] that ends it.");
    }
    const NodeId inside = argument(token, 0, 1);
    formula_.nodes[id].children = {inside, degree};
    return id;
}

NodeId Reader::alphabet(const Token& token) {
    const Alphabet outer = alphabet_;
    alphabet_ = named(alphabets, token.name()).alphabet;
    const NodeId id = argument(token, 0, 1);
    alphabet_ = outer;
    return id;
}

NodeId Reader::switchAlphabet(const Token& token) {
    alphabet_ = named(alphabets, token.name()).alphabet;
    return none;
}

NodeId Reader::words(const Token& token) {
    bool there = false;
    const std::string_view inside = raw(token, there);
    if (!there) {
        fault(token, std::string(token.text) + " needs its words in braces.");
        return missingPart(token);
    }
    if (inside.find('$') != std::string_view::npos)
        fault(token, "There is no formula in " + std::string(token.text) +
                         ": end it before, and begin it again behind.");
    const NodeId id = add(Kind::text, token);
    formula_.nodes[id].text = withoutEscapes(inside);
    formula_.nodes[id].alphabet = named(alphabets, token.name()).alphabet;
    return id;
}

NodeId Reader::operatorName(const Token& token) {
    const bool limits = at_ < source_.size() && source_[at_] == '*';
    if (limits)
        ++at_;
    bool there = false;
    const std::string_view inside = raw(token, there);
    if (!there) {
        fault(token, "\\operatorname needs its name in braces.");
        return missingPart(token);
    }
    const NodeId id = add(Kind::text, token);
    Node& node = formula_.nodes[id];
    for (std::size_t i = 0; i < inside.size(); ++i) {
        if (inside[i] == '\\' && i + 1 < inside.size() && inside[++i] == ',')
            node.text += ' ';
        else if (inside[i] == '-')
            node.text += "\u2010";
        else if (inside[i] != '{' && inside[i] != '}')
            node.text += inside[i];
    }
    node.atom = Atom::operation;
    node.limits = limits ? Limits::byStyle : Limits::never;
    return id;
}

NodeId Reader::function(const Token& token) {
    const Function* known = functionNamed(token.name());
    const NodeId id = add(Kind::text, token);
    Node& node = formula_.nodes[id];
    node.text = known->shown;
    node.atom = Atom::operation;
    node.limits = known->limits ? Limits::byStyle : Limits::never;
    return id;
}

NodeId Reader::accent(const Token& token) {
    const NodeId base = argument(token, 0, 1);
    const NodeId id = add(Kind::accent, token);
    Node& node = formula_.nodes[id];
    node.code = accentNamed(token.name());
    node.amount = token.name().starts_with("wide") ? 1 : 0;
    node.children = {base};
    return id;
}

char32_t Reader::delimiter(const Token& command) {
    const Token token = peek();
    const char32_t code = token.text.empty() ? 0 : delimiterNamed(token.text);
    if (code != 0)
        (void)next();
    else
        fault(command, std::string(command.text) +
                           " needs a delimiter behind it: ( ) [ ] \\{ \\} | or . for none.");
    return code == 0 ? U'.' : code;
}

NodeId Reader::fence(const Token& token) {
    const NodeId id = add(Kind::fenced, token);
    std::u32string delimiters{delimiter(token)};
    std::vector<NodeId> parts;
    for (;;) {
        const Waiting outer = waiting_;
        ++waiting_.fences;
        waiting_.bracket = false;
        parts.push_back(list());
        waiting_ = outer;
        const Token end = peek();
        if (end.text != "\\middle" && end.text != "\\right") {
            fault(token, "\\left has no \\right; \\right. ends it without a sign.");
            delimiters += U'.';
            break;
        }
        (void)next();
        delimiters += delimiter(end);
        if (end.text == "\\right")
            break;
    }
    Node& node = formula_.nodes[id];
    node.atom = Atom::inner;
    node.delimiters = std::move(delimiters);
    node.children = std::move(parts);
    return id;
}

NodeId Reader::bigDelimiter(const Token& token) {
    const char side = token.name().back();
    const char32_t code = delimiter(token);
    const NodeId id = add(Kind::delimiter, token);
    Node& node = formula_.nodes[id];
    node.code = node.letter = code;
    node.amount = named(bigs, token.name()).amount;
    node.atom = side == 'l'   ? Atom::opening
                : side == 'r' ? Atom::closing
                : side == 'm' ? Atom::relation
                              : Atom::ordinary;
    return id;
}

NodeId Reader::bar(const Token& token) {
    const NodeId base = argument(token, 0, 1);
    const NodeId id = add(Kind::bar, token);
    formula_.nodes[id].code = token.name() == "overline" ? 0x305 : 0x332;
    formula_.nodes[id].children = {base};
    return id;
}

NodeId Reader::stretch(const Token& token) {
    const NodeId base = argument(token, 0, 1);
    const NodeId id = add(Kind::stretch, token);
    Node& node = formula_.nodes[id];
    node.code = named(stretches, token.name()).code;
    node.children = {base};
    if (token.name().find("arrow") == std::string_view::npos) {
        node.atom = Atom::operation;
        node.limits = Limits::always;
    }
    return id;
}

NodeId Reader::arrow(const Token& token) {
    NodeId below = none;
    if (peek().text == "[") {
        (void)next();
        const Waiting outer = waiting_;
        waiting_.bracket = true;
        below = list();
        waiting_ = outer;
        if (peek().text == "]")
            (void)next();
    }
    const NodeId above = argument(token, 0, 1);
    const NodeId id = add(Kind::arrow, token);
    Node& node = formula_.nodes[id];
    node.code = named(arrows, token.name()).code;
    node.atom = Atom::relation;
    node.children = {above, below};
    return id;
}

NodeId Reader::stacked(const Token& token) {
    const NodeId script = argument(token, 0, 2);
    const NodeId base = argument(token, 1, 2);
    const NodeId id = add(Kind::scripts, token);
    Node& node = formula_.nodes[id];
    const Node* nucleus = &formula_.nodes[base];
    if (nucleus->kind == Kind::list && nucleus->children.size() == 1)
        nucleus = &formula_.nodes[nucleus->children.front()];
    node.atom = token.name() == "stackrel" ? Atom::relation : nucleus->atom;
    node.limits = Limits::always;
    node.children = {base, none, none};
    node.children[token.name() == "underset" ? 1 : 2] = script;
    return id;
}

NodeId Reader::styleSwitch(const Token& token) {
    const NodeId id = add(Kind::style, token);
    for (std::size_t i = 0; i < std::size(styles); ++i)
        if (styles[i] == token.name())
            formula_.nodes[id].style = static_cast<Style>(i);
    return id;
}

NodeId Reader::namedSpace(const Token& token) {
    return space(token, named(spaces, token.name()).amount);
}

NodeId Reader::phantom(const Token& token) {
    const NodeId base = argument(token, 0, 1);
    const NodeId id = add(Kind::phantom, token);
    const char first = token.name().front();
    formula_.nodes[id].code = first == 'p' ? U'b' : first == 'h' ? U'h' : U'v';
    formula_.nodes[id].children = {base};
    return id;
}

NodeId Reader::negation(const Token& token) {
    const NodeId id = argument(token, 0, 1);
    Node& node = formula_.nodes[id];
    const char32_t struck = negated(node.letter);
    if (struck != 0)
        node.code = node.letter = struck;
    else if (!node.faulty)
        fault(token, "There is no such sign with a stroke through it.");
    return id;
}

NodeId Reader::classed(const Token& token) {
    const NodeId part = argument(token, 0, 1);
    const NodeId id = add(Kind::list, token);
    Node& node = formula_.nodes[id];
    node.children = {part};
    node.atom = named(classes, token.name()).atom;
    node.limits = node.atom == Atom::operation ? Limits::byStyle : Limits::never;
    return id;
}

NodeId Reader::modulo(const Token& token) {
    const NodeId word = add(Kind::text, token);
    formula_.nodes[word].text = "mod";
    if (token.name() == "bmod") {
        formula_.nodes[word].atom = Atom::binary;
        return word;
    }
    const bool fenced = token.name() == "pmod";
    const NodeId part = argument(token, 0, 1);
    const NodeId id = add(Kind::list, token);
    std::vector<NodeId> parts{space(token, fenced ? 1 : 0.6)};
    if (fenced)
        parts.push_back(symbol(token, U'(', Atom::opening));
    parts.insert(parts.end(), {word, space(token, 6.0 / 18), part});
    if (fenced)
        parts.push_back(symbol(token, U')', Atom::closing));
    formula_.nodes[id].children = std::move(parts);
    return id;
}

} // namespace formulas
