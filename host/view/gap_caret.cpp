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

bool leaveGap(const DocumentView& view, int key) {
    const std::optional<document::Selection> at = view.text().cursor().selection();
    const manuscript::Manuscript in = view.writing().manuscript();
    const bool isBack = key == Qt::Key_Up || key == Qt::Key_Left || key == Qt::Key_Backspace;
    const bool isOn = key == Qt::Key_Down || key == Qt::Key_Right || key == Qt::Key_Delete;
    if (!at || !at->isEmpty() || (!isBack && !isOn) || !manuscript::isGap(in, at->caret))
        return false;
    const auto next =
        manuscript::place(in, at->caret, isBack ? Direction::backward : Direction::forward);
    if (next)
        view.text().cursor().set({*next, *next});
    return true;
}

bool enterGap(const DocumentView& view, int key, std::size_t before, std::size_t after) {
    const bool isSideways = key == Qt::Key_Left || key == Qt::Key_Right;
    const bool isForward = isSideways && after != before
                               ? after > before
                               : key == Qt::Key_Down || key == Qt::Key_Right;
    const auto gap = manuscript::gapBeside(view.writing().manuscript(), before,
                                           isForward ? Direction::forward : Direction::backward);
    const bool isPassed = gap && (after == before || (isForward ? after >= *gap : after <= *gap));
    if (isPassed)
        view.text().cursor().set({*gap, *gap});
    return isPassed;
}

} // namespace view
