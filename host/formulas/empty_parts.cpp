#include "formulas/empty_parts.h"

#include <algorithm>

namespace formulas {

namespace {

// May a part of it wait? A base without scripts, or a cell of equations one below the other, does
// not.
bool waits(const Node& node, std::size_t child) {
    switch (node.kind) {
    case Kind::fraction:
    case Kind::root:
    case Kind::accent:
    case Kind::bar:
    case Kind::stretch:
    case Kind::arrow:
    case Kind::fenced:
        return true;
    case Kind::scripts:
        return child > 0;
    case Kind::array:
        return node.form == ArrayForm::matrix || node.form == ArrayForm::small ||
               node.form == ArrayForm::cases;
    default:
        return false;
    }
}

} // namespace

std::vector<EmptyPart> emptyParts(const Formula& formula) {
    std::vector<EmptyPart> parts;
    for (const Node& node : formula.nodes)
        for (std::size_t at = 0; at < node.children.size(); ++at) {
            const NodeId child = node.children[at];
            if (child == none || !waits(node, at))
                continue;
            const Node& part = formula.node(child);
            const bool isInBraces = part.end > part.offset;
            if (part.kind == Kind::list && part.children.empty())
                parts.push_back({child, part.offset + (isInBraces ? 1 : 0)});
        }
    std::ranges::sort(parts, {}, &EmptyPart::place);
    return parts;
}

std::optional<std::size_t> nextPlace(const Formula& formula, std::size_t place) {
    for (const EmptyPart& part : emptyParts(formula))
        if (part.place > place)
            return part.place;
    for (const NodeId id : formula.node(formula.root).children)
        if (const Node& node = formula.node(id); node.offset < place && place < node.end)
            return node.end;
    return std::nullopt;
}

std::optional<std::size_t> placeBefore(const Formula& formula, std::size_t place) {
    std::optional<std::size_t> found;
    for (const EmptyPart& part : emptyParts(formula))
        if (part.place < place)
            found = part.place;
    return found;
}

} // namespace formulas
