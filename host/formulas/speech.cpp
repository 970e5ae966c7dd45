// A formula in English words. A part of more than one sign is closed by a word of its own ("end
// fraction"), so that two formulas that differ are said differently.
#include "formulas/symbols.h"

#include <algorithm>

namespace formulas {

namespace {

bool isDigit(char32_t c) { return c >= U'0' && c <= U'9'; }

class Speaker {
public:
    explicit Speaker(const Formula& formula) : formula_(formula) {}

    std::string all() {
        list(formula_.node(formula_.root));
        return std::move(said_);
    }

private:
    void say(std::string_view words) {
        if (words.empty())
            return;
        const bool mark = words.front() == ',' || words.front() == ';' || words.front() == ':';
        if (!said_.empty() && !mark)
            said_ += ' ';
        said_ += words;
    }

    [[nodiscard]] bool isSimple(NodeId id) const {
        const Node& node = formula_.alone(id);
        if (node.kind == Kind::symbol || node.kind == Kind::text)
            return true;
        return node.kind == Kind::list && std::ranges::all_of(node.children, [&](NodeId child) {
                   return isDigit(formula_.node(child).letter) ||
                          formula_.node(child).letter == U'.';
               });
    }
    [[nodiscard]] bool is(NodeId id, std::u32string_view signs) const {
        const Node& node = formula_.alone(id);
        if (node.kind == Kind::symbol)
            return signs.size() == 1 && node.letter == signs.front();
        if (node.kind != Kind::list || node.children.size() != signs.size())
            return false;
        for (std::size_t i = 0; i < signs.size(); ++i)
            if (formula_.node(node.children[i]).letter != signs[i])
                return false;
        return true;
    }
    void part(NodeId id, std::string_view end) { // `end` closes what is more than a sign
        node(id);
        if (!isSimple(id))
            say(end);
    }

    void list(const Node& list) {
        bool number = false;
        for (const NodeId child : list.children) {
            const Node& next = formula_.node(child);
            const bool digit = next.kind == Kind::symbol &&
                               (isDigit(next.letter) || (number && next.letter == U'.'));
            if (digit && number)
                append(said_, next.letter);
            else
                node(child);
            number = digit;
        }
    }

    void node(NodeId id);
    void symbol(const Node& node);
    void scripts(const Node& node);
    void ranges(const Node& node);
    void power(NodeId above);
    void fenced(const Node& node);
    void array(const Node& node, std::string_view what);
    void root(const Node& node);
    void fraction(const Node& node);

    const Formula& formula_;
    std::string said_;
};

void Speaker::symbol(const Node& node) {
    if (node.faulty)
        return say("missing");
    if (node.alphabet == Alphabet::bold || node.alphabet == Alphabet::boldItalic)
        say("bold");
    const Symbol* known = symbolOf(node.letter);
    if (known != nullptr && !(known->spoken.empty() && known->name.empty()))
        return say(known->spoken.empty() ? known->name : known->spoken);
    std::string letter;
    append(letter, node.letter);
    say(letter);
}

void Speaker::power(NodeId above) {
    if (is(above, U"2"))
        return say("squared");
    if (is(above, U"3"))
        return say("cubed");
    if (is(above, U"′"))
        return say("prime");
    if (is(above, U"′′"))
        return say("double prime");
    if (is(above, U"∘"))
        return say("degrees");
    if (is(above, U"∗"))
        return say("star");
    say("to the power");
    part(above, "end power");
}

// Of an operator: from, to; of a limit: as.
void Speaker::ranges(const Node& node) {
    this->node(node.children[0]);
    const Node& base = formula_.alone(node.children[0]);
    const bool limit = base.kind == Kind::text;
    if (node.children[1] != none) {
        say(limit ? "as" : node.children[2] != none ? "from" : "over");
        this->node(node.children[1]);
    }
    if (node.children[2] != none) {
        say("to");
        this->node(node.children[2]);
    }
    say("of");
}

void Speaker::scripts(const Node& node) {
    const Node& base = formula_.alone(node.children[0]);
    const bool function = base.kind == Kind::text && base.limits == Limits::never;
    if (base.atom == Atom::operation && base.kind != Kind::stretch && !function)
        return ranges(node);
    this->node(node.children[0]);
    const bool stacked = node.limits == Limits::always;
    if (node.children[1] != none) {
        say(stacked ? "with, below," : "sub");
        part(node.children[1], stacked ? "end below" : "end sub");
    }
    if (node.children[2] == none)
        return;
    if (!stacked)
        return power(node.children[2]);
    say("with, above,");
    part(node.children[2], "end above");
}

void Speaker::fraction(const Node& node) {
    const bool simple = isSimple(node.children[0]) && isSimple(node.children[1]);
    if (node.amount > 0 && !simple)
        say("the fraction");
    this->node(node.children[0]);
    say(node.amount > 0 ? "over" : "choose");
    this->node(node.children[1]);
    if (node.amount > 0 && !simple)
        say("end fraction");
}

void Speaker::root(const Node& node) {
    const NodeId degree = node.children[1];
    if (degree == none) {
        say("the square root of");
    } else if (is(degree, U"3")) {
        say("the cube root of");
    } else {
        say("the root of degree");
        this->node(degree);
        say("of");
    }
    part(node.children[0], "end root");
}

void Speaker::array(const Node& node, std::string_view what) {
    const std::size_t columns = std::max<std::size_t>(1, node.text.size());
    const std::size_t rows = node.children.size() / columns;
    const bool matrix = node.form == ArrayForm::matrix || node.form == ArrayForm::small;
    if (matrix)
        say("the " + std::to_string(rows) + " by " + std::to_string(columns) + " " +
            std::string(what) + ":");
    for (std::size_t r = 0; r < rows; ++r) {
        if (matrix)
            say("row " + std::to_string(r + 1) + ":");
        for (std::size_t c = 0; c < columns; ++c) {
            if (node.children[r * columns + c] == none)
                continue;
            this->node(node.children[r * columns + c]);
            if (c + 1 < columns && node.form != ArrayForm::aligned)
                say(",");
        }
        if (r + 1 < rows)
            say(";");
    }
    if (matrix)
        say("; end " + std::string(what));
}

void Speaker::fenced(const Node& node) {
    const std::u32string& around = node.delimiters;
    const Node& first = formula_.alone(node.children.front());
    if (node.children.size() == 1 && around.size() == 2) {
        if (first.kind == Kind::fraction && first.amount == 0 && around == U"()")
            return this->node(node.children.front());
        if (first.kind == Kind::array && first.form == ArrayForm::cases) {
            say("cases:");
            array(first, "");
            return say("; end cases");
        }
        if (first.kind == Kind::array && (around == U"()" || around == U"[]"))
            return array(first, "matrix");
        if (first.kind == Kind::array && around == U"||")
            return array(first, "determinant");
        if (around == U"||" || around == U"‖‖") {
            const std::string_view what = around == U"||" ? "absolute value" : "norm";
            say("the " + std::string(what) + " of");
            this->node(node.children.front());
            return say("end " + std::string(what));
        }
    }
    for (std::size_t i = 0; i < around.size(); ++i) {
        if (around[i] != U'.') {
            const Symbol* known = symbolOf(around[i]);
            say(known != nullptr ? known->spoken : std::string_view());
        }
        if (i < node.children.size())
            this->node(node.children[i]);
    }
}

void Speaker::node(NodeId id) {
    if (id == none)
        return;
    const Node& node = formula_.node(id);
    switch (node.kind) {
    case Kind::symbol:
    case Kind::delimiter:
        if (node.code != U'.')
            symbol(node);
        else if (node.kind == Kind::symbol)
            say("point");
        break;
    case Kind::text: {
        const Function* known = functionNamed(node.text);
        std::string words = known != nullptr ? std::string(known->spoken) : node.text;
        words.erase(0, words.find_first_not_of(' '));
        words.erase(words.find_last_not_of(' ') + 1);
        say(words);
        break;
    }
    case Kind::list:
        list(node);
        break;
    case Kind::scripts:
        scripts(node);
        break;
    case Kind::fraction:
        fraction(node);
        break;
    case Kind::root:
        root(node);
        break;
    case Kind::accent:
        if (node.code == 0x20D7)
            say("vector");
        part(node.children.front(), ",");
        if (node.code != 0x20D7)
            say(spokenAccent(node.code));
        break;
    case Kind::bar:
        this->node(node.children.front());
        say(node.code == 0x305 ? "bar" : "underlined");
        break;
    case Kind::stretch:
    case Kind::room:
        this->node(node.children.front());
        break;
    case Kind::arrow: {
        const Symbol* known = symbolOf(node.code);
        say(known != nullptr ? known->spoken : std::string_view());
        say("with");
        this->node(node.children[0]);
        say("above");
        break;
    }
    case Kind::fenced:
        fenced(node);
        break;
    case Kind::array:
        array(node, "matrix");
        break;
    case Kind::space:
    case Kind::style:
    case Kind::phantom:
        break;
    }
}

} // namespace

std::string spoken(const Formula& formula) { return Speaker(formula).all(); }

} // namespace formulas
