#include "onpage/text_cursor.h"

namespace view {

using document::Selection;

TextCursor::TextCursor(const document::Document& document) : tracker_(document) {}

std::optional<Selection> TextCursor::selection() const {
    if (!caret_)
        return std::nullopt;
    return Selection{anchor_->offset, caret_->offset};
}

text::Range TextCursor::interval() const {
    if (!caret_)
        return {};
    return {std::min(anchor_->offset, caret_->offset), std::max(anchor_->offset, caret_->offset)};
}

// Text that comes in at an end of what is selected is not selected.
void TextCursor::set(Selection selection) {
    wish_.reset();
    if (this->selection() == selection)
        return;
    const auto gravityOf = [](std::size_t place, std::size_t other) {
        return place > other ? text::Gravity::before : text::Gravity::behind;
    };
    anchor_ = tracker_.track(selection.anchor, gravityOf(selection.anchor, selection.caret));
    caret_ = tracker_.track(selection.caret, gravityOf(selection.caret, selection.anchor));
    Q_EMIT changed();
}

void TextCursor::clear() {
    if (!caret_)
        return;
    anchor_.reset();
    caret_.reset();
    Q_EMIT changed();
}

std::optional<places::Caret> TextCursor::caret(const places::Carets& carets) const {
    const std::optional<places::Caret> found =
        caret_ ? carets.of(caret_->offset, page_) : std::nullopt;
    if (found)
        page_ = found->page;
    return found;
}

void TextCursor::moveTo(const places::Carets& carets, const places::Caret& caret, bool extend) {
    page_ = caret.page;
    const std::size_t place = carets.placeOf(caret);
    set({extend && anchor_ ? anchor_->offset : place, place});
}

// Without extending, left and right go to the end of what is selected first.
void TextCursor::move(const places::Carets& carets, places::Move move, bool extend) {
    using places::Move;
    const std::optional<places::Caret> from = caret(carets);
    if (!from)
        return;
    if (!extend && selects() && (move == Move::left || move == Move::right)) {
        const text::Range all = interval();
        const std::size_t to = move == Move::left ? all.from : all.to;
        return set({to, to});
    }
    const bool isVertical = move == Move::up || move == Move::down;
    const double x = wish_.value_or(carets.rectOf(*from).x());
    moveTo(carets, carets.moved(*from, move, x), extend);
    if (isVertical)
        wish_ = x;
}

void TextCursor::selectAll(const places::Carets& carets) {
    const std::optional<places::Caret> any = carets.at(0, {0, 0});
    if (!any)
        return;
    const places::Caret last = carets.moved(*any, places::Move::documentEnd);
    page_ = last.page;
    set({carets.placeOf(carets.moved(*any, places::Move::documentStart)), carets.placeOf(last)});
}

Selection TextCursor::around(const places::Carets& carets, const places::Caret& at,
                             Unit unit) const {
    if (unit == Unit::letter)
        return {carets.placeOf(at), carets.placeOf(at)};
    const auto [first, last] = unit == Unit::word ? carets.wordAt(at) : carets.paragraphAt(at);
    return {carets.placeOf(first), carets.placeOf(last)};
}

void TextCursor::press(const places::Carets& carets, const places::Caret& at, Unit unit,
                       bool extend) {
    page_ = at.page;
    unit_ = unit;
    pressed_ =
        extend && anchor_ ? Selection{anchor_->offset, anchor_->offset} : around(carets, at, unit);
    if (extend)
        drag(carets, at);
    else
        set(pressed_);
}

// The first word or line stays selected.
void TextCursor::drag(const places::Carets& carets, const places::Caret& at) {
    page_ = at.page;
    const Selection here = around(carets, at, unit_);
    if (here.anchor < pressed_.anchor)
        set({pressed_.caret, here.anchor});
    else
        set({pressed_.anchor, std::max(here.caret, pressed_.caret)});
}

} // namespace view
