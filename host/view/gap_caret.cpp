#include "view/gap_caret.h"

#include "manuscript/gaps.h"
#include "manuscript/places.h"
#include "paragraphs/measure.h"
#include "view/text_hand.h"
#include "view/writing.h"

namespace view {

namespace {

using manuscript::Direction;
using paragraphs::fromPoints;
using sgml::NodeId;

// A block on the page that is beside a gap.
struct Side {
    std::size_t page = 0;
    double top = 0, bottom = 0;
    bool isThere = false;
};

void cover(Side& side, std::size_t page, const QRectF& rect) {
    if (!side.isThere)
        side = {page, rect.top(), rect.bottom(), true};
    if (side.page != page)
        return;
    side.top = std::min(side.top, rect.top());
    side.bottom = std::max(side.bottom, rect.bottom());
}

bool isIn(const DocumentView& view, const layout::PlacedObject& object, text::Range range) {
    const sgml::Tree& tree = view.document().document().tree();
    const document::Subdocument* of = view.document().document().subdocument(object.subdocument);
    const NodeId element = of ? of->element : object.element;
    return tree.holds(element) && range.contains(tree.node(element).range.from);
}

// The end of a block that the gap is behind, or the beginning of one that it is before: its text
// and its pictures. LIMIT: a block without text is looked for on all pages.
Side sideOf(const DocumentView& view, NodeId block, bool isEnd) {
    const sgml::Tree& tree = view.document().document().tree();
    const text::Range range = tree.node(block).range;
    const places::Carets carets(view.pages(), tree);
    const auto place = manuscript::place(view.writing().manuscript(), isEnd ? range.to : range.from,
                                         isEnd ? Direction::backward : Direction::forward);
    const auto caret = place && range.contains(*place)
                           ? carets.of(*place, view.text().cursor().page())
                           : std::nullopt;
    Side side;
    if (caret && range.contains(carets.placeOf(*caret)))
        cover(side, caret->page, carets.rectOf(*caret));
    const auto& pages = view.pages().pages;
    const std::size_t first = side.isThere ? side.page : 0;
    for (std::size_t page = first; page < (side.isThere ? first + 1 : pages.size()); ++page)
        for (const layout::PlacedObject& object : pages[page]->objects)
            if (isIn(view, object, range))
                cover(side, page, object.rect);
    for (const layout::PlacedRows& table : pages[side.page]->tables) // its cells end where it does
        if (side.isThere && isEnd && table.top < side.bottom && table.bottom > side.bottom)
            side.bottom = table.bottom;
    return side;
}

std::optional<GapPlace> placeOf(const DocumentView& view, std::size_t gap) {
    if (!view.model() || view.pages().pages.empty())
        return std::nullopt;
    const manuscript::Sides sides = manuscript::sidesOf(view.writing().manuscript(), gap);
    const Side above = sideOf(view, sides.before, true), below = sideOf(view, sides.behind, false);
    if (!above.isThere || !below.isThere)
        return std::nullopt;
    const double left = fromPoints(view.model()->page.marginLeft);
    // At the end of a page it is seen where the next one begins.
    const double top = above.page == below.page ? above.bottom : below.top - fromPoints(10);
    return GapPlace{below.page, std::min(top, below.top), below.top, left};
}

} // namespace

QRectF GapPlace::caret() const {
    constexpr double points = 40;
    return {left, (top + bottom) / 2, fromPoints(points), 0};
}

std::optional<GapPlace> gapOfCaret(const DocumentView& view) {
    const std::optional<document::Selection> at = view.text().cursor().selection();
    if (!view.isWriting() || !at || !at->isEmpty() ||
        !manuscript::isGap(view.writing().manuscript(), at->caret))
        return std::nullopt;
    return placeOf(view, at->caret);
}

bool pressGap(const DocumentView& view, QPointF point) {
    const std::optional<places::Caret> caret = view.text().caretAt(point);
    if (!view.isWriting() || !caret)
        return false;
    const places::Carets carets(view.pages(), view.document().document().tree());
    const auto [page, on] = view.pagePointAt(point);
    const std::size_t nearest = carets.placeOf(*caret);
    for (const Direction direction : {Direction::forward, Direction::backward}) {
        const auto gap = manuscript::gapBeside(view.writing().manuscript(), nearest, direction);
        const auto place = gap ? placeOf(view, *gap) : std::nullopt;
        if (!place || place->page != page || on.y() < place->top || on.y() > place->bottom)
            continue;
        view.text().cursor().set({*gap, *gap});
        return true;
    }
    return false;
}

namespace {

// A block that has no line for a caret, as a figure of an image, is passed: to the gap or the text
// beyond, or behind the block that ends the document.
std::optional<std::size_t> beyondGap(const DocumentView& view, std::size_t gap, Direction to) {
    const manuscript::Manuscript in = view.writing().manuscript();
    const sgml::Tree& tree = view.document().document().tree();
    const bool isBack = to == Direction::backward;
    const manuscript::Sides sides = manuscript::sidesOf(in, gap);
    const text::Range block = tree.node(isBack ? sides.before : sides.behind).range;
    const std::optional<std::size_t> next = manuscript::place(in, gap, to);
    if (!next || !block.contains(*next))
        return next;
    const places::Carets carets(view.pages(), tree);
    const std::size_t end = isBack ? block.from : block.to;
    // The figure itself has no line, its caption has one.
    for (const auto& inside :
         {next, manuscript::place(in, end, isBack ? Direction::forward : Direction::backward)}) {
        const auto caret = carets.of(inside.value_or(end), view.text().cursor().page());
        if (caret && block.contains(carets.placeOf(*caret)))
            return inside;
    }
    if (const auto another = manuscript::gapBeside(in, *next, to))
        return another;
    const auto beyond = manuscript::place(in, end, to);
    if (beyond && !block.contains(*beyond))
        return beyond;
    return isBack ? next : block.to;
}

} // namespace

bool leaveGap(const DocumentView& view, int key) {
    const std::optional<document::Selection> at = view.text().cursor().selection();
    const manuscript::Manuscript in = view.writing().manuscript();
    const bool isBack = key == Qt::Key_Up || key == Qt::Key_Left || key == Qt::Key_Backspace;
    const bool isOn = key == Qt::Key_Down || key == Qt::Key_Right || key == Qt::Key_Delete;
    if (!at || !at->isEmpty() || (!isBack && !isOn) || !manuscript::isGap(in, at->caret))
        return false;
    const Direction to = isBack ? Direction::backward : Direction::forward;
    const bool erases = key == Qt::Key_Backspace || key == Qt::Key_Delete;
    const std::optional<std::size_t> next =
        erases ? manuscript::place(in, at->caret, to) : beyondGap(view, at->caret, to);
    if (next)
        view.text().cursor().set({*next, *next});
    return true;
}

bool enterGap(const DocumentView& view, int key, std::size_t before, std::size_t after) {
    const manuscript::Manuscript in = view.writing().manuscript();
    const bool isSideways = key == Qt::Key_Left || key == Qt::Key_Right;
    // Into or out of a footnote, which stands elsewhere in the document.
    const bool leavesFlow = manuscript::everything(in, before) != manuscript::everything(in, after);
    const bool isForward = isSideways && after != before && !leavesFlow
                               ? after > before
                               : key == Qt::Key_Down || key == Qt::Key_Right;
    const auto gap =
        manuscript::gapBeside(in, before, isForward ? Direction::forward : Direction::backward);
    const bool isPassed =
        gap && (after == before || leavesFlow || (isForward ? after >= *gap : after <= *gap));
    if (isPassed)
        view.text().cursor().set({*gap, *gap});
    return isPassed;
}

} // namespace view
