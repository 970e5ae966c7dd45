// A formula in one line of Unicode. Parentheses stand where one would read it wrongly without.
#include "formulas/atoms.h"
#include "formulas/symbols.h"

#include "text/characters.h"

#include <algorithm>
#include <utility>

namespace formulas {

namespace {

class Writer {
public:
    explicit Writer(const Formula& formula) : formula_(formula) {}

    std::vector<std::string> lines() {
        const Node& array = formula_.alone(formula_.root);
        if (array.kind != Kind::array || !isOfLines(array))
            return {all()};
        std::vector<std::string> lines;
        for (std::size_t i = 0; i < array.children.size(); i += array.text.size()) {
            row(array, i);
            lines.push_back(std::exchange(text_, {}));
        }
        return lines;
    }

    std::string all() {
        list(formula_.root);
        return std::move(text_);
    }

private:
    // Does it need no parentheses? One sign, a number, what has its own.
    [[nodiscard]] bool isOne(NodeId id) const {
        const Node& node = formula_.alone(id);
        if (node.kind == Kind::stretch)
            return isOne(node.children.front());
        if (node.kind != Kind::list)
            return node.kind != Kind::fraction && node.kind != Kind::scripts &&
                   node.kind != Kind::array;
        return std::ranges::all_of(node.children, [&](NodeId child) {
            const char32_t letter = formula_.node(child).letter;
            return (letter >= U'0' && letter <= U'9') || letter == U'.';
        });
    }
    static bool endsFraction(Atom next) {
        return next == Atom::binary || next == Atom::relation || next == Atom::closing ||
               next == Atom::punctuation;
    }
    void blank() {
        if (!text_.empty() && text_.back() != ' ')
            text_ += ' ';
    }
    void grouped(NodeId id) {
        const bool one = isOne(id);
        if (!one)
            text_ += '(';
        node(id);
        if (!one)
            text_ += ')';
    }

    static bool isOfLines(const Node& array) {
        return array.form == ArrayForm::aligned || array.form == ArrayForm::gathered;
    }
    void row(const Node& array, std::size_t first);
    void list(NodeId id);
    void node(NodeId id);
    void script(NodeId id, bool above);
    void limits(const Node& node);
    void fenced(const Node& node);
    void array(const Node& node);
    [[nodiscard]] std::string asScript(NodeId id, bool above) const;

    const Formula& formula_;
    std::string text_;
    bool tight_ = false; // in a script, where signs stand closely
};

void Writer::list(NodeId id) {
    const std::vector<Atom> atoms = atomsOf(formula_, id);
    std::size_t next = 0;
    for (const NodeId child : formula_.node(id).children) {
        const Node& node = formula_.node(child);
        if (node.kind == Kind::style)
            continue;
        if (node.kind == Kind::space) {
            if (node.amount > 0.1)
                blank();
            continue;
        }
        const Atom atom = atoms[next];
        const bool wide = !tight_ && (atom == Atom::binary || atom == Atom::relation);
        const bool sign = text_.ends_with("−") || text_.ends_with("+");
        const bool name =
            atom == Atom::operation && next > 0 && atoms[next - 1] != Atom::opening && !sign;
        const bool afterName = next > 0 && atoms[next - 1] == Atom::operation &&
                               atom != Atom::opening && atom != Atom::inner;
        if (wide || name || afterName)
            blank();
        // A sign right behind a fraction is no part of what is below.
        const bool goesOn = next + 1 < atoms.size() && !endsFraction(atoms[next + 1]);
        const bool split = node.kind == Kind::fraction && node.amount > 0 && goesOn;
        text_ += split ? "(" : "";
        this->node(child);
        text_ += split ? ")" : "";
        if (wide || (atom == Atom::punctuation && !tight_ && next + 1 < atoms.size()))
            blank();
        ++next;
    }
    if (tight_)
        return;
    while (!text_.empty() && text_.back() == ' ')
        text_.pop_back();
}

// In the small signs of Unicode, where it has all of them.
std::string Writer::asScript(NodeId id, bool above) const {
    const Node& node = formula_.alone(id);
    const std::vector<NodeId> single{id};
    std::string text;
    for (const NodeId child : node.kind == Kind::list ? node.children : single) {
        const Node& sign = formula_.alone(child);
        if (sign.kind != Kind::symbol)
            return {};
        const char32_t code = sign.letter == U'′' && above ? sign.letter
                              : above                      ? raised(sign.letter)
                                                           : lowered(sign.letter);
        if (code == 0)
            return {};
        append(text, code);
    }
    return text;
}

void Writer::script(NodeId id, bool above) {
    if (id == none)
        return;
    if (const std::string small = asScript(id, above); !small.empty()) {
        text_ += small;
        return;
    }
    const Node& sign = formula_.alone(id);
    if (above && sign.kind == Kind::symbol && sign.letter == U'∘') {
        text_ += "°";
        return;
    }
    text_ += above ? '^' : '_';
    const bool outer = std::exchange(tight_, true);
    grouped(id);
    tight_ = outer;
}

void Writer::fenced(const Node& node) {
    const Node& first = formula_.alone(node.children.front());
    const bool binomial = first.kind == Kind::fraction && first.amount == 0;
    const bool cases = first.kind == Kind::array && first.form == ArrayForm::cases;
    for (std::size_t i = 0; i < node.delimiters.size(); ++i) {
        const bool own = binomial || (cases && node.delimiters[i] == U'.');
        if (node.delimiters[i] != U'.' && !own)
            append(text_, node.delimiters[i]);
        if (i < node.children.size())
            this->node(node.children[i]);
    }
    if (cases)
        text_ += '}';
}

void Writer::array(const Node& node) {
    for (std::size_t i = 0; i < node.children.size(); i += node.text.size()) {
        if (i > 0)
            text_ += "; ";
        row(node, i);
    }
}

void Writer::row(const Node& array, std::size_t first) {
    for (std::size_t i = first; i < first + array.text.size(); ++i) {
        if (i > first)
            text_ += isOfLines(array) ? " " : ", ";
        if (array.children[i] != none)
            list(array.children[i]);
    }
}

void Writer::node(NodeId id) {
    if (id == none)
        return;
    const Node& node = formula_.node(id);
    const bool letters = node.alphabet == Alphabet::blackboard ||
                         node.alphabet == Alphabet::calligraphic ||
                         node.alphabet == Alphabet::fraktur;
    switch (node.kind) {
    case Kind::symbol:
        append(text_, letters ? node.code : node.letter);
        break;
    case Kind::delimiter:
        if (node.code != U'.')
            append(text_, node.code);
        break;
    case Kind::text:
        text_ += node.text;
        break;
    case Kind::list:
        list(id);
        break;
    case Kind::scripts:
        if (node.limits == Limits::always)
            grouped(node.children[0]);
        else
            this->node(node.children[0]);
        script(node.children[1], false);
        script(node.children[2], true);
        break;
    case Kind::fraction:
        if (node.amount == 0)
            text_ += '(';
        grouped(node.children[0]);
        text_ += node.amount > 0 ? "/" : " choose ";
        grouped(node.children[1]);
        if (node.amount == 0)
            text_ += ')';
        break;
    case Kind::root:
        if (node.children[1] != none)
            script(node.children[1], true);
        text_ += "√";
        grouped(node.children[0]);
        break;
    case Kind::accent:
    case Kind::bar:
        grouped(node.children.front());
        append(text_, node.code);
        break;
    case Kind::stretch:
    case Kind::room:
        this->node(node.children.front());
        break;
    case Kind::arrow:
        append(text_, node.code);
        text_ += '[';
        this->node(node.children[0]);
        text_ += ']';
        break;
    case Kind::fenced:
        fenced(node);
        break;
    case Kind::array:
        array(node);
        break;
    case Kind::space:
    case Kind::style:
    case Kind::phantom:
        break;
    }
}

} // namespace

std::vector<std::string> plainLines(const Formula& formula) { return Writer(formula).lines(); }

std::string plain(const Formula& formula) { return Writer(formula).all(); }

} // namespace formulas
