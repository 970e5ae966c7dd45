// Taking a document apart. Changes: draft_changes.cpp; the way back to bytes: draft_writer.cpp.
#include "authoring/draft.h"
#include "manuscript/places.h"

#include "manuscript/leaves.h"

#include <algorithm>

namespace authoring {

using manuscript::documentAround, manuscript::widened;

using sgml::NodeId;
using sgml::NodeKind;
using sgml::noNode;

// --- pieces ---------------------------------------------------------------------------------

thread_local std::size_t Piece::made = 0;

std::size_t Piece::index() const {
    const Pieces& all = parent->children;
    return static_cast<std::size_t>(
        std::find_if(all.begin(), all.end(),
                     [this](const auto& one) { return one.get() == this; }) -
        all.begin());
}

Piece* Piece::next() const {
    const std::size_t at = index() + 1;
    return at < parent->children.size() ? parent->children[at].get() : nullptr;
}

Piece* Piece::previous() const {
    const std::size_t at = index();
    return at > 0 ? parent->children[at - 1].get() : nullptr;
}

// --- opening --------------------------------------------------------------------------------

Draft::Draft(const Manuscript& manuscript, Selection selection)
    : manuscript_(manuscript), tree_(manuscript.document.tree()) {
    selection = widened(manuscript, selection);
    anchorFirst_ = selection.anchor <= selection.caret;
    const std::size_t from = std::min(selection.anchor, selection.caret);
    const std::size_t to = std::max(selection.anchor, selection.caret);
    const NodeId document = documentAround(manuscript, from, to);
    grammar_ = manuscript.grammars.of(tree_.name(document));
    if (tree_.isBroken() || grammar_ == nullptr)
        return;
    root_ = element(tree_.classElement(document));
    putMark(0, selection.anchor, {from, to});
    putMark(1, selection.caret, {from, to});
}

QString Draft::obstacle() const {
    if (root_ != nullptr)
        return {};
    if (tree_.isBroken())
        return QStringLiteral(
            "The document has faults that have to be mended first (View > Faults).");
    return QStringLiteral("No schema says how documents of this class are written.");
}

std::unique_ptr<Piece> Draft::element(NodeId node) const {
    auto piece = std::make_unique<Piece>();
    const sgml::Node& source = tree_.node(node);
    piece->name = tree_.name(node);
    piece->start = piece->end = node;
    const std::size_t end =
        source.lastChild == noNode ? source.startTag.to : tree_.node(source.lastChild).range.to;
    piece->tail.kept = {end, source.endTag.from};
    if (source.firstChild == noNode)
        return piece;
    std::unique_ptr<Piece> child = rest(source.firstChild, source.lastChild);
    child->gap.kept = {source.startTag.to, tree_.node(source.firstChild).range.from};
    if (const NodeId content = tree_.content(node); content == source.firstChild) {
        child->kind = Piece::Kind::text;
        child->kept = tree_.contentRange(content);
    }
    put(*piece, 0, std::move(child));
    return piece;
}

std::unique_ptr<Piece> Draft::rest(NodeId first, NodeId last) const {
    auto piece = std::make_unique<Piece>();
    piece->kind = Piece::Kind::rest;
    piece->node = first;
    piece->last = last;
    return piece;
}

// The rest that holds the child falls into what is before it, the child, and what is behind it.
Piece& Draft::openIn(Piece& parent, NodeId child) {
    for (const auto& piece : parent.children)
        if (piece->isElement() && piece->start == child)
            return *piece;
    for (std::size_t i = 0; i < parent.children.size(); ++i) {
        Piece& whole = *parent.children[i];
        if (whole.kind != Piece::Kind::rest)
            continue;
        NodeId before = noNode, at = whole.node;
        for (; at != child && at != whole.last; at = tree_.node(at).next)
            before = at;
        if (at != child)
            continue;
        return openRest(whole, before, child);
    }
    return parent; // not reached: every child is an element of its own or in a rest
}

Piece& Draft::openRest(Piece& whole, NodeId before, NodeId child) {
    Piece& parent = *whole.parent;
    const std::size_t index = whole.index();
    const NodeId last = whole.last;
    std::unique_ptr<Piece> opened = element(child);
    if (before == noNode)
        opened->gap = whole.gap;
    else
        opened->gap.kept = {tree_.node(before).range.to, tree_.node(child).range.from};
    Piece& result = *opened;
    if (child != last) {
        const NodeId next = tree_.node(child).next;
        std::unique_ptr<Piece> behind = rest(next, last);
        behind->gap.kept = {tree_.node(child).range.to, tree_.node(next).range.from};
        put(parent, index + 1, std::move(behind));
    }
    if (before == noNode) {
        opened->parent = &parent;
        parent.children[index] = std::move(opened);
    } else {
        whole.last = before;
        put(parent, index + 1, std::move(opened));
    }
    return result;
}

bool Draft::isInside(NodeId node) const {
    while (node != noNode && node != root_->start) {
        if (tree_.node(node).kind == sgml::NodeKind::document)
            return false; // a document within this one is its medium's
        node = tree_.node(node).parent;
    }
    return node != noNode;
}

Piece& Draft::opened(NodeId node) {
    std::vector<NodeId> path;
    for (NodeId id = node; id != root_->start; id = tree_.node(id).parent)
        path.push_back(id);
    Piece* piece = root_.get();
    for (std::size_t i = path.size(); i-- > 0;)
        piece = &openIn(*piece, path[i]);
    return *piece;
}

// One piece for each node of the rest, in its place.
void Draft::openRestAll(Piece& whole) {
    Pieces opened;
    for (NodeId id = whole.node, before = noNode;; before = id, id = tree_.node(id).next) {
        opened.push_back(tree_.isElement(id) ? element(id) : rest(id, id));
        Piece& piece = *opened.back();
        piece.parent = whole.parent;
        if (before == noNode)
            piece.gap = whole.gap;
        else
            piece.gap.kept = {tree_.node(before).range.to, tree_.node(id).range.from};
        if (id == whole.last)
            break;
    }
    Pieces& all = whole.parent->children;
    const auto at = all.begin() + static_cast<std::ptrdiff_t>(whole.index());
    all.insert(all.erase(at), std::make_move_iterator(opened.begin()),
               std::make_move_iterator(opened.end()));
}

void Draft::openChildren(Piece& parent) {
    for (std::size_t i = parent.children.size(); i-- > 0;) {
        Piece& whole = *parent.children[i];
        if (whole.kind != Piece::Kind::rest)
            continue;
        if (whole.node != whole.last || tree_.isElement(whole.node)) // one stray node stays a rest
            openRestAll(whole);
    }
}

void Draft::openBeside(Piece& at) {
    const auto isOpen = [](const Piece* piece) {
        return piece != nullptr && (piece->isMark() || piece->isEmptyText());
    };
    Piece* behind = at.next();
    while (isOpen(behind))
        behind = behind->next();
    if (behind != nullptr && behind->kind == Piece::Kind::rest && tree_.isElement(behind->node))
        openRest(*behind, noNode, behind->node);
    Piece* before = at.previous();
    while (isOpen(before))
        before = before->previous();
    if (before == nullptr || before->kind != Piece::Kind::rest || !tree_.isElement(before->last))
        return;
    NodeId ahead = noNode;
    for (NodeId id = before->node; id != before->last; id = tree_.node(id).next)
        ahead = id;
    openRest(*before, ahead, before->last);
}

// --- marks ----------------------------------------------------------------------------------

// A unit is entered only where both ends of the selection are in it, as in a footnote.
bool Draft::isEntered(NodeId node, text::Range selection) const {
    const sgml::Node& source = tree_.node(node);
    if (!tree_.isElement(node))
        return false;
    const Element& known = grammar_->of(tree_.name(node));
    const bool isUnit = known.kind == Kind::unit || known.kind == Kind::blockUnit;
    return !isUnit || (known.display == schemas::Display::footnote &&
                       source.startTag.to <= selection.from && selection.to <= source.endTag.from);
}

void Draft::putMark(std::size_t number, std::size_t offset, text::Range selection) {
    auto mark = std::make_unique<Piece>();
    mark->kind = Piece::Kind::mark;
    mark->mark = number;
    marks_[number] = mark.get();
    Piece* parent = root_.get();
    for (;;) {
        NodeId inside = noNode, before = noNode;
        for (NodeId child = tree_.node(parent->start).firstChild; child != noNode;
             child = tree_.node(child).next) {
            const text::Range range = tree_.node(child).range;
            if (range.from < offset && offset < range.to)
                inside = child;
            if (range.to <= offset)
                before = child;
            if (range.to >= offset)
                break;
        }
        if (inside != noNode && isEntered(inside, selection)) {
            parent = &openIn(*parent, inside);
            continue;
        }
        if (inside != noNode && tree_.node(inside).kind == NodeKind::content)
            return putMarkInText(std::move(mark), *parent, offset);
        return putMarkBehind(std::move(mark), *parent, before);
    }
}

void Draft::putMarkBehind(std::unique_ptr<Piece> mark, Piece& parent, NodeId before) {
    if (before != noNode && tree_.isElement(before))
        openIn(parent, before);
    std::size_t index = 0;
    for (std::size_t i = 0; i < parent.children.size(); ++i) {
        const Piece& child = *parent.children[i];
        const NodeId last = child.isElement()                 ? child.start
                            : child.kind == Piece::Kind::rest ? child.last
                                                              : child.node;
        if ((before != noNode && last == before) || (child.isMark() && i == index))
            index = i + 1;
    }
    put(parent, index, std::move(mark));
}

void Draft::putMarkInText(std::unique_ptr<Piece> mark, Piece& parent, std::size_t offset) {
    const NodeId content = tree_.content(parent.start);
    const sgml::Unescaped text = tree_.unescaped(content);
    offset = text.fileOffset(text.textOffset(offset));
    for (std::size_t i = parent.children.size(); i-- > 0;) {
        Piece& piece = *parent.children[i];
        if (!piece.isText() || piece.kept.from > offset)
            continue;
        auto behind = std::make_unique<Piece>();
        behind->kind = Piece::Kind::text;
        behind->node = content;
        behind->kept = {offset, piece.kept.to};
        piece.kept.to = offset;
        if (!behind->kept.empty())
            put(parent, i + 1, std::move(behind));
        // The anchor stands before the caret where both are at one place.
        while (i + 1 < parent.children.size() && parent.children[i + 1]->isMark())
            ++i;
        put(parent, i + 1, std::move(mark));
        return;
    }
}

// --- looking --------------------------------------------------------------------------------

const Element& Draft::of(const Piece& piece) const { return grammar_->of(piece.name); }

bool Draft::isUnit(const Piece& piece) const {
    if (!piece.isElement())
        return false;
    const Kind kind = of(piece).kind;
    return kind == Kind::unit || kind == Kind::blockUnit;
}

bool Draft::isInlined(const Piece& piece) const {
    return piece.isText() || (piece.isElement() && of(piece).kind == Kind::inlined);
}

bool Draft::isInLine(const Piece& piece) const {
    if (piece.isMark() || isInlined(piece))
        return true;
    return piece.isElement() && of(piece).kind == Kind::unit && holdsText(blockOf(*piece.parent));
}

bool Draft::holdsText(const Piece& element) const { return of(element).holdsText; }

Piece& Draft::blockOf(Piece& piece) const {
    Piece* at = piece.isElement() ? &piece : piece.parent;
    while (at->parent != nullptr && isInlined(*at))
        at = at->parent;
    return *at;
}

Piece& Draft::branch(Piece& piece, const Piece& ancestor) {
    Piece* at = &piece;
    while (at->parent != &ancestor)
        at = at->parent;
    return *at;
}

Piece& Draft::common(Piece& one, Piece& other) {
    std::vector<Piece*> around;
    for (Piece* at = one.parent; at != nullptr; at = at->parent)
        around.push_back(at);
    Piece* at = other.parent;
    while (std::find(around.begin(), around.end(), at) == around.end())
        at = at->parent;
    return *at;
}

bool Draft::isBlank(const Piece& piece) const {
    switch (piece.kind) {
    case Piece::Kind::mark:
        return true;
    case Piece::Kind::text:
        return piece.isEmptyText();
    case Piece::Kind::rest:
        return false;
    case Piece::Kind::element:
        break;
    }
    return !isUnit(piece) && std::all_of(piece.children.begin(), piece.children.end(),
                                         [this](const auto& child) { return isBlank(*child); });
}

bool Draft::isLineBlank(Piece& at, Direction direction) {
    const Piece& block = blockOf(at);
    for (Piece* level = &at; level != &block; level = level->parent) {
        openChildren(*level->parent);
        Piece* beside = level;
        while ((beside = direction == Direction::forward ? beside->next() : beside->previous()) !=
                   nullptr &&
               isInLine(*beside))
            if (!isBlank(*beside))
                return false;
    }
    return true;
}

std::string Draft::attribute(const Piece& element, std::string_view name) const {
    return element.start == noNode ? std::string{}
                                   : std::string(tree_.attribute(element.start, name).value_or(""));
}

} // namespace authoring
