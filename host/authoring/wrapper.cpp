#include "authoring/wrapper.h"

#include "authoring/table_draft.h"

#include <algorithm>

namespace authoring {

Wrapper::Wrapper(Draft& draft, Wanted wanted)
    : draft_(draft), wanted_(std::move(wanted)), passed_(TableDraft(draft).unselected()) {
    collect(draft.root());
}

bool Wrapper::isAllInside() const {
    return std::all_of(texts_.begin(), texts_.end(),
                       [this](const Piece* text) { return wrapperOf(*text) != nullptr; });
}

void Wrapper::unwrap() {
    for (Piece* text : texts_)
        while (Piece* wrapper = wrapperOf(*text)) {
            Piece& alone = isolate(*text, *wrapper->parent);
            Draft::dissolve(alone);
        }
}

void Wrapper::wrap(const std::string& name, const std::string& attributes) {
    for (Piece* text : texts_)
        if (wrapperOf(*text) == nullptr)
            wrap(*text, name, attributes);
    for (std::size_t i = 1; i < made_.size(); ++i)
        made_[i] = draft_.joinedWith(*made_[i - 1], *made_[i]);
}

// The texts between the marks, in order.
void Wrapper::collect(Piece& piece) {
    if (piece.isMark())
        ++marks_;
    if (piece.start != sgml::noNode && passed_.contains(piece.start))
        return;
    if (piece.isText() && marks_ == 1 && !piece.isEmptyText() && isInProse(piece))
        texts_.push_back(&piece);
    if (draft_.isUnit(piece) && marks_ != 0 && !holdsMark(piece))
        return;
    for (std::size_t i = 0; i < piece.children.size() && marks_ < 2; ++i) {
        Piece& child = *piece.children[i];
        if (marks_ == 1 && child.kind == Piece::Kind::rest) {
            draft_.openRestAll(child);
            collect(*piece.children[i]);
        } else {
            collect(child);
        }
    }
}

bool Wrapper::holdsMark(const Piece& piece) {
    return piece.isMark() || std::any_of(piece.children.begin(), piece.children.end(),
                                         [](const auto& child) { return holdsMark(*child); });
}

bool Wrapper::isInProse(Piece& text) const {
    return draft_.of(draft_.blockOf(text)).display != schemas::Display::verbatim;
}

Piece* Wrapper::wrapperOf(const Piece& text) const {
    for (Piece* at = text.parent; at != nullptr && draft_.isInlined(*at); at = at->parent)
        if (wanted_(*at))
            return at;
    return nullptr;
}

void Wrapper::wrap(Piece& text, const std::string& name, const std::string& attributes) {
    Piece* inner = &text;
    // An element TEXT is content in braces: what it had, the new element has.
    if (text.parent->name == "TEXT") {
        inner = &isolate(text, *text.parent->parent);
        if (draft_.isPlainText(*inner)) {
            Draft::dissolve(*inner);
            inner = &text;
        }
    }
    Piece& made = Draft::put(*inner->parent, inner->index(), Draft::made(name, attributes));
    Draft::moveTo(*inner, made, 0);
    made_.push_back(&made);
}

// Splits what is around the piece, up to `stop`, so that it is alone in it.
Piece& Wrapper::isolate(Piece& piece, Piece& stop) {
    Piece* at = &piece;
    while (at->parent != &stop) {
        separate(*at, Direction::backward);
        separate(*at, Direction::forward);
        at = at->parent;
    }
    return *at;
}

void Wrapper::separate(Piece& at, Direction direction) {
    const bool forward = direction == Direction::forward;
    Piece* beside = forward ? at.next() : at.previous();
    while (beside != nullptr && (beside->isMark() || beside->isEmptyText()))
        beside = forward ? beside->next() : beside->previous();
    if (beside != nullptr)
        draft_.split(forward ? *beside : at, *at.parent->parent);
}

} // namespace authoring
