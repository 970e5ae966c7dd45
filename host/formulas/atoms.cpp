#include "formulas/atoms.h"

namespace formulas {

namespace {

bool needsMore(Atom atom) { // can no binary operator follow it?
    return atom == Atom::operation || atom == Atom::binary || atom == Atom::relation ||
           atom == Atom::opening || atom == Atom::punctuation;
}

bool endsTerm(Atom atom) {
    return atom == Atom::relation || atom == Atom::closing || atom == Atom::punctuation;
}

} // namespace

std::vector<Atom> atomsOf(const Formula& formula, NodeId list, bool afterOrdinary) {
    std::vector<Atom> atoms;
    for (const NodeId child : formula.node(list).children) {
        const Node& node = formula.node(child);
        if (node.kind == Kind::space || node.kind == Kind::style)
            continue;
        Atom atom = node.atom;
        const bool alone = atoms.empty() ? !afterOrdinary : needsMore(atoms.back());
        if (atom == Atom::binary && alone)
            atom = Atom::ordinary;
        if (endsTerm(atom) && !atoms.empty() && atoms.back() == Atom::binary)
            atoms.back() = Atom::ordinary;
        atoms.push_back(atom);
    }
    if (!atoms.empty() && atoms.back() == Atom::binary)
        atoms.back() = Atom::ordinary;
    return atoms;
}

} // namespace formulas
