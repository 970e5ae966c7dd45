// Superscripts, subscripts and primes, and the sign that they belong to.
#include "formulas/reader.h"

#include "text/characters.h"

namespace formulas {

bool Reader::isScript(const Token& token) const {
    if (token.text == "^" || token.text == "_" || token.text == "'")
        return true;
    if (token.text.empty() || static_cast<unsigned char>(token.text.front()) < 0x80)
        return false;
    const char32_t code = text::codePoint(token.text);
    return raisedBy(code) != 0 || loweredBy(code) != 0 || code == U'′' || code == U'’';
}

// The scripts of the last part of the list, or of nothing where there is none.
NodeId Reader::scriptsFor(NodeId list, Script& current, const Token& at) {
    if (current.node != none)
        return current.node;
    NodeId nucleus = none;
    auto& children = formula_.nodes[list].children;
    if (!children.empty()) {
        const Kind kind = formula_.nodes[children.back()].kind;
        if (kind != Kind::space && kind != Kind::style) {
            nucleus = children.back();
            children.pop_back();
        }
    }
    if (nucleus == none)
        nucleus = add(Kind::list, {{}, at.offset});
    const NodeId id = add(Kind::scripts, at);
    Node& node = formula_.nodes[id];
    const Node& base = formula_.nodes[nucleus];
    node.offset = base.offset;
    node.atom = base.atom;
    node.limits = base.limits;
    node.children = {nucleus, none, none};
    formula_.nodes[list].children.push_back(id);
    current = {id, false};
    return id;
}

void Reader::attach(NodeId list, Script& current, bool above, NodeId part, const Token& at) {
    NodeId id = scriptsFor(list, current, at);
    const std::size_t slot = above ? 2 : 1;
    if (const NodeId old = formula_.nodes[id].children[slot]; old != none) {
        if (above && current.primes) {
            formula_.nodes[old].children.push_back(part);
            current.primes = false;
            finish(id);
            return;
        }
        fault(at, above ? "A base has one superscript: write {x^a}^b or x^{ab}."
                        : "A base has one subscript: write {x_a}_b or x_{ab}.");
        current = {};
        id = scriptsFor(list, current, at);
    }
    formula_.nodes[id].children[slot] = part;
    finish(id);
}

// All raised, or all lowered signs of Unicode that stand side by side.
void Reader::raisedSigns(NodeId list, Script& current) {
    const Token first = peek();
    const bool above = raisedBy(text::codePoint(first.text)) != 0;
    const NodeId part = add(Kind::list, first);
    for (Token token = first; !token.text.empty(); token = peek()) {
        if (text::characterLength(token.text) != token.text.size())
            break; // a command, or bytes that are no character
        const char32_t code = text::codePoint(token.text);
        const char32_t sign = above ? raisedBy(code) : loweredBy(code);
        if (sign == 0)
            break;
        (void)next();
        const Symbol* known = symbolOf(sign);
        const NodeId id = symbol(token, sign, known != nullptr ? known->atom : Atom::ordinary);
        formula_.nodes[part].children.push_back(id);
    }
    attach(list, current, above, finish(part), first);
}

void Reader::script(NodeId list, Script& current) {
    const Token token = peek();
    if (token.text == "^" || token.text == "_") {
        (void)next();
        attach(list, current, token.text == "^", argument(token, 0, 1), token);
        return;
    }
    const char32_t code = text::codePoint(token.text);
    if (code != U'\'' && code != U'′' && code != U'’')
        return raisedSigns(list, current);
    const NodeId part = add(Kind::list, token);
    for (Token prime = token; prime.text == token.text; prime = peek()) {
        const NodeId sign = symbol(next(), U'′', Atom::ordinary);
        formula_.nodes[part].children.push_back(sign);
    }
    attach(list, current, true, finish(part), token);
    current.primes = true;
}

} // namespace formulas
