// Rearranging the pieces of a draft.
#include "authoring/commands.h"

#include "sgml/edit.h"
#include "sgml/escape.h"

#include <algorithm>

namespace authoring {

using sgml::noNode;

namespace {

// Attributes as they are spelled, ` A="b" C="d"`, with that one set, or without it.
std::string withAttribute(std::string spelled, std::string_view name, std::string_view value) {
    const std::string begin = " " + std::string(name) + "=\"";
    const std::string now = value.empty() ? std::string() : " " + sgml::attributeText(name, value);
    const std::size_t at = spelled.find(begin);
    if (at == std::string::npos)
        return spelled + now;
    const std::size_t end = spelled.find('"', at + begin.size());
    return spelled.replace(at, end + 1 - at, now);
}

} // namespace

void Draft::setAttribute(Piece& element, std::string_view name, std::string_view value) const {
    std::string spelled;
    if (element.start != noNode && !element.isRespelled)
        for (const sgml::Attribute& attribute : tree_.attributes(element.start))
            spelled +=
                " " + sgml::attributeText(tree_.text(attribute.name), tree_.text(attribute.value));
    element.attributes = withAttribute(spelled + element.attributes, name, value);
    element.isRespelled = true;
}

std::unique_ptr<Piece> Draft::made(std::string name, std::string attributes) {
    auto piece = std::make_unique<Piece>();
    piece->name = std::move(name);
    piece->attributes = std::move(attributes);
    return piece;
}

std::unique_ptr<Piece> Draft::madeText(std::string_view plain) {
    auto piece = std::make_unique<Piece>();
    piece->kind = Piece::Kind::text;
    piece->fresh = sgml::escaped(plain);
    return piece;
}

Piece& Draft::put(Piece& parent, std::size_t index, std::unique_ptr<Piece> piece) {
    piece->parent = &parent;
    Piece& result = *piece;
    parent.children.insert(parent.children.begin() + static_cast<std::ptrdiff_t>(index),
                           std::move(piece));
    return result;
}

std::unique_ptr<Piece> Draft::take(Piece& piece) {
    Pieces& all = piece.parent->children;
    const std::size_t index = piece.index();
    std::unique_ptr<Piece> taken = std::move(all[index]);
    all.erase(all.begin() + static_cast<std::ptrdiff_t>(index));
    taken->parent = nullptr;
    return taken;
}

void Draft::moveTo(Piece& piece, Piece& parent, std::size_t index) {
    if (piece.parent == &parent && piece.index() < index)
        --index;
    put(parent, index, take(piece));
}

void Draft::putOnLine(Piece& piece, const Piece& like) {
    const std::string blanks = blanksOf(like.gap);
    const std::size_t lineEnd = blanks.rfind('\n');
    piece.gap.kept = {};
    piece.gap.fresh =
        "\n" + (lineEnd == std::string::npos ? std::string{} : blanks.substr(lineEnd + 1));
}

std::string Draft::blanksOf(const Gap& gap) const {
    return gap.kept.empty() ? gap.fresh : std::string(tree_.text(gap.kept));
}

std::string Draft::attributesWithoutId(const Piece& element) const {
    if (element.isRespelled)
        return withAttribute(element.attributes, "ID", {});
    if (element.start == noNode)
        return element.attributes;
    std::string spelled;
    for (const sgml::Attribute& attribute : tree_.attributes(element.start))
        if (tree_.text(attribute.name) != "ID")
            spelled += " " + std::string(tree_.text(attribute.whole));
    return spelled;
}

Piece& Draft::split(Piece& before, Piece& stop) {
    Piece* at = &before;
    while (at->parent != &stop) {
        Piece& left = *at->parent;
        std::unique_ptr<Piece> right = made(left.name, attributesWithoutId(left));
        right->end = left.end;
        right->tail = left.tail;
        left.end = noNode;
        if (!isInlined(left))
            left.tail = {{}, blanksOf(left.tail)};
        while (at->next() != nullptr)
            moveTo(*at->next(), *right, right->children.size());
        moveTo(*at, *right, 0);
        if (left.parent == &stop && !isInlined(left))
            putOnLine(*right, left);
        else if (!isInlined(left))
            right->gap = {{}, blanksOf(left.parent->children.front()->gap)};
        at = &put(*left.parent, left.index() + 1, std::move(right));
    }
    return *at;
}

void Draft::dissolve(Piece& element) {
    Piece& parent = *element.parent;
    std::size_t index = element.index();
    while (!element.children.empty())
        moveTo(*element.children.front(), parent, index++);
    take(element);
}

// Are these the same inlined element twice, so that they can be one?
bool Draft::isAlike(const Piece& one, const Piece& other) const {
    return one.isElement() && other.isElement() && isInlined(one) && one.name == other.name &&
           attributesOf(one).empty() && attributesOf(other).empty();
}

std::string Draft::attributesOf(const Piece& element) const {
    const bool hasId = !attribute(element, "ID").empty();
    return attributesWithoutId(element) + (hasId ? " ID" : "");
}

bool Draft::isPlainText(const Piece& piece) const {
    return piece.isElement() && piece.name == "TEXT" && attributesOf(piece).empty();
}

Piece* Draft::joinedWith(Piece& one, Piece& other) {
    Piece* between = one.next();
    while (between != nullptr && between != &other && (between->isMark() || between->isEmptyText()))
        between = between->next();
    const bool same = one.name == other.name && attributesOf(one) == attributesOf(other);
    if (one.parent != other.parent || between != &other || !same)
        return &other;
    dropEmptyTexts(*one.parent);
    merge(one, other);
    return &one;
}

// Marks between the two come to stand between their children.
void Draft::merge(Piece& left, Piece& right) {
    while (left.next() != &right)
        moveTo(*left.next(), left, left.children.size());
    Piece* const last = left.children.empty() ? nullptr : left.children.back().get();
    while (!right.children.empty())
        moveTo(*right.children.front(), left, left.children.size());
    left.end = right.end;
    left.tail = std::move(right.tail);
    take(right);
    if (last != nullptr)
        (void)mergeAround(*last);
}

// True: what stands on both sides of the place behind `at` has become one.
bool Draft::mergeAround(Piece& at) {
    Piece* left = &at;
    while (left != nullptr && left->isMark())
        left = left->previous();
    Piece* right = at.next();
    while (right != nullptr && (right->isMark() || right->isEmptyText()))
        right = right->next();
    if (left == nullptr || right == nullptr || left == right)
        return false;
    if (isAlike(*left, *right)) {
        dropEmptyTexts(*left->parent);
        merge(*left, *right);
    } else if (left->isText() && isPlainText(*right)) {
        dissolve(*right);
    } else if (right->isText() && isPlainText(*left)) {
        dissolve(*left);
    } else {
        return false;
    }
    return true;
}

// The same of the ends of the elements that the mark is in.
void Draft::mergeBeside(Piece& mark) {
    (void)mergeAround(mark);
    for (Piece* at = mark.parent; isInlined(*at);) {
        Piece* before = at->previous();
        const bool merged = mergeAround(*at) || (before != nullptr && mergeAround(*before));
        at = merged ? mark.parent : at->parent;
    }
}

void Draft::dropEmptyTexts(Piece& element) {
    for (std::size_t i = element.children.size(); i-- > 0;)
        if (element.children[i]->isEmptyText())
            take(*element.children[i]);
}

// Empty texts that are not all of a line.
void Draft::dropNeedlessTexts(Piece& element) {
    const auto beside = [](Piece* piece, bool forward) {
        do
            piece = forward ? piece->next() : piece->previous();
        while (piece != nullptr && piece->isMark());
        return piece;
    };
    for (std::size_t i = element.children.size(); i-- > 0;) {
        Piece* const piece = element.children[i].get();
        if (!piece->isEmptyText())
            continue;
        const Piece* const before = beside(piece, false);
        const Piece* const behind = beside(piece, true);
        if ((before != nullptr && isInlined(*before)) || (behind != nullptr && isInlined(*behind)))
            take(*piece);
    }
}

// Is there nothing else in the mark's line than marks?
bool Draft::isLineEmpty(const Piece& mark) const {
    const Piece* before = mark.previous();
    while (before != nullptr && before->isMark())
        before = before->previous();
    const Piece* behind = mark.next();
    while (behind != nullptr && behind->isMark())
        behind = behind->next();
    return (before == nullptr || !isInLine(*before)) && (behind == nullptr || !isInLine(*behind));
}

void Draft::tidy(Piece& mark) {
    while (isInlined(*mark.parent) && isBlank(*mark.parent)) {
        dropEmptyTexts(*mark.parent);
        Piece& around = *mark.parent;
        if (std::any_of(around.children.begin(), around.children.end(),
                        [](const auto& child) { return !child->isMark(); }))
            break; // an element that was empty before
        dissolve(around);
    }
    if (Piece& block = blockOf(mark); holdsText(block)) {
        openChildren(block);
        dropNeedlessTexts(block);
    }
    openBeside(mark);
    if (!isInlined(*mark.parent) && holdsText(*mark.parent) && isLineEmpty(mark)) {
        put(*mark.parent, mark.index() + 1, madeText({}));
        return;
    }
    dropNeedlessTexts(*mark.parent);
    mergeBeside(mark);
}

void Draft::collapse() {
    Piece& caret = first();
    Piece& other = second();
    moveTo(other, *caret.parent, caret.index() + 1);
}

void Draft::settle(Piece& mark) {
    for (;;) {
        openBeside(mark);
        Piece* before = mark.previous();
        while (before != nullptr && before->isMark())
            before = before->previous();
        Piece* behind = mark.next();
        while (behind != nullptr && behind->isMark())
            behind = behind->next();
        const auto isUseful = [this](const Piece* piece) {
            return piece != nullptr && piece->isElement() && !isUnit(*piece);
        };
        if ((before != nullptr && before->isText()) || (behind != nullptr && behind->isText()))
            return;
        const bool inBlocks = !isInlined(*mark.parent) && isLineEmpty(mark);
        if (isUseful(before) && (isInlined(*before) || (inBlocks && !isUseful(behind))))
            moveTo(mark, *before, before->children.size());
        else if (isUseful(behind) && (isInlined(*behind) || inBlocks))
            moveTo(mark, *behind, 0);
        else
            return standBefore(mark, before, behind);
    }
}

// Beside a unit: the mark stands behind it, or before it and behind the blanks before it.
void Draft::standBefore(Piece& mark, const Piece* before, Piece* behind) const {
    const bool isBehindUnit = before != nullptr && before->isElement() && isUnit(*before);
    if (isBehindUnit || behind == nullptr)
        return;
    Piece* first = &mark;
    while (first->previous() != nullptr && first->previous()->isMark())
        first = first->previous();
    // The gap before the unit, or the one that another mark has from it.
    for (Piece* at = first; at != nullptr; at = at == behind ? nullptr : at->next())
        if (first->gap.kept.empty() && first->gap.fresh.empty())
            std::swap(first->gap, at->gap);
}

} // namespace authoring
