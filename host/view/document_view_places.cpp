// The places of the pages of a DocumentView, the part that one reads, and the words that are found.
#include "view/document_view.h"

#include "paragraphs/measure.h"
#include "view/figures.h"
#include "view/folds.h"
#include "view/text_hand.h"

#include <QScrollBar>
#include <algorithm>
#include <cmath>

namespace view {

// --- the pages ---------------------------------------------------------------------------------

PagePlaces DocumentView::places() const {
    return {spread_, pageSize(), pages().pages.size(), viewport()->size()};
}

void DocumentView::scrollBy(double pixels) {
    verticalScrollBar()->setValue(verticalScrollBar()->value() + static_cast<int>(pixels));
}

void DocumentView::setSpread(Spread spread) {
    if (spread == spread_)
        return;
    const std::size_t page =
        pages().pages.empty() ? 0 : pagePointAt({0, 2 * PagePlaces::gap}).first;
    spread_ = spread;
    setScrollBars();
    if (!pages().pages.empty())
        scrollBy(pageTopLeft(page).y() - (spread == Spread::single ? 0 : PagePlaces::gap));
    setZoom(std::min(zoom_, widthZoom()));
    figures_->follow();
    text_->refresh();
    viewport()->update();
}

std::size_t DocumentView::currentPage() const {
    return pages().pages.empty() ? 0 : pagePointAt(viewport()->rect().center()).first;
}

// --- where one reads ---------------------------------------------------------------------------

std::optional<ReadingPlace> DocumentView::readingPlace() const {
    if (pages().pages.empty())
        return std::nullopt;
    const places::Carets carets(pages(), document_.document().tree());
    const auto [page, point] = pagePointAt({viewport()->width() / 2.0, 0});
    const std::optional<places::Caret> caret = carets.at(page, point);
    if (!caret)
        return std::nullopt;
    const QRectF line = inViewport(caret->page, carets.rectOf(*caret));
    return ReadingPlace{carets.placeOf(*caret), line.top() / scale()};
}

void DocumentView::show(const ReadingPlace& place) {
    folds_->reveal(place.place);
    const places::Carets carets(pages(), document_.document().tree());
    const std::optional<places::Caret> caret = carets.of(place.place, currentPage());
    if (caret)
        scrollBy(inViewport(caret->page, carets.rectOf(*caret)).top() - place.below * scale());
}

// `top`: what comes to stand near the top of the view.
void DocumentView::jumpTo(const places::Carets& carets, const places::Caret& caret, double top) {
    Q_EMIT jumping(false);
    choose(document::noSubdocument);
    if (isWriting()) {
        const std::size_t at = carets.placeOf(caret);
        text_->cursor().set({at, at});
    }
    scrollBy(top - 2 * PagePlaces::margin);
    Q_EMIT jumped();
}

void DocumentView::goTo(std::size_t place) {
    settle();
    folds_->reveal(place);
    const places::Carets carets(pages(), document_.document().tree());
    if (const std::optional<places::Caret> caret = carets.of(place, currentPage()))
        jumpTo(carets, *caret, inViewport(caret->page, carets.rectOf(*caret)).top());
}

void DocumentView::goToElement(sgml::NodeId element) {
    settle();
    const sgml::Tree& tree = document_.document().tree();
    if (!tree.holds(element))
        return;
    folds_->reveal(tree.node(element).startTag.to);
    const places::Carets carets(pages(), tree);
    const auto caret = carets.of(tree.node(element).startTag.to, currentPage());
    if (caret)
        jumpTo(carets, *caret, topOf(element, *caret));
}

// A figure's caption stands below its picture.
double DocumentView::topOf(sgml::NodeId element, const places::Caret& caret) const {
    const sgml::Tree& tree = document_.document().tree();
    const places::Carets carets(pages(), tree);
    const QRectF line = carets.rectOf(caret);
    const text::Range all = tree.node(element).range;
    double top = line.top();
    constexpr double nearest = 60 * paragraphs::twipsPerPixel;
    for (const layout::PlacedObject& object : pages().pages[caret.page]->objects) {
        const document::Subdocument* of = document_.document().subdocument(object.subdocument);
        const bool isInside = of ? all.contains(tree.node(of->element).range.from)
                                 : std::abs(line.top() - object.rect.bottom()) < nearest;
        if (isInside)
            top = std::min(top, object.rect.top());
    }
    return inViewport(caret.page, {0, top, 0, 0}).top();
}

std::optional<QRectF> DocumentView::placeOfFormula(sgml::NodeId element) const {
    for (std::size_t page = 0; page < pages().pages.size(); ++page)
        for (const layout::Piece& piece : pages().pages[page]->pieces)
            if (const auto* text = std::get_if<layout::TextPiece>(&piece))
                for (const paragraphs::InlineObject& object :
                     text->paragraph->objectsOf(text->line))
                    if (text->paragraph->block()->runs[object.run].element == element)
                        return inViewport(
                            page,
                            text->paragraph->objectRect(text->line, object).translated(text->at));
    return std::nullopt;
}

void DocumentView::goToPage(std::size_t page) {
    settle();
    if (pages().pages.empty())
        return;
    Q_EMIT jumping(false);
    page = std::min(page, pages().pages.size() - 1);
    scrollBy(pageTopLeft(page).y() - (spread_ == Spread::single ? 0 : PagePlaces::gap));
    Q_EMIT jumped();
}

// --- finding -----------------------------------------------------------------------------------

// Words in folded sections count, too.
void DocumentView::find(const places::Search& search) {
    const session::FoldedPages& pages = folds_->pages();
    if (pages.foldsAny())
        found_.look(search, pages.whole().pages(), &pages_);
    else
        found_.look(search, pages_);
    viewport()->update();
    if (pages_.pages.empty())
        return;
    const auto [page, point] = pagePointAt({0, 0});
    const std::size_t first = found_.firstFrom(page, point.y());
    found_.show(first);
    if (found_.seen(first)) // while one types, no section unfolds
        showFound(static_cast<int>(first));
}

void DocumentView::followFound() {
    const session::FoldedPages& pages = folds_->pages();
    if (pages.foldsAny())
        found_.follow(pages.whole().pages(), &pages_);
    else
        found_.follow(pages_);
}

void DocumentView::showFound(int which) {
    const int count = foundCount();
    if (count == 0)
        return;
    const auto shown = static_cast<std::size_t>((which % count + count) % count);
    found_.show(shown);
    if (!found_.seen(shown))
        folds_->reveal(found_.finder().at(shown));
    const places::Found* one = found_.seen(found_.shown());
    if (!one)
        return;
    const double y = pageTopLeft(one->page).y() + one->parts.front().bottom() * scale();
    constexpr double edge = 40;
    if (y < edge || y > viewport()->height() - edge) {
        Q_EMIT jumping(true);
        scrollBy(y - viewport()->height() / 3.0);
        Q_EMIT jumped();
    }
    viewport()->update();
}

void DocumentView::showFoundFrom(std::size_t place) {
    const places::Finder& finder = found_.onPages();
    const places::Carets carets(pages(), document_.document().tree());
    const std::optional<places::Caret> caret = carets.of(place, currentPage());
    if (!caret || finder.count() == 0)
        return;
    const QPointF at = carets.rectOf(*caret).center();
    std::size_t index = finder.firstFrom(caret->page);
    const auto isBefore = [&](const places::Found& one) {
        const places::Found::Part& part = one.parts.front();
        return part.bottom() <= at.y() ||
               (part.at.y() <= at.y() && part.rect().left() < at.x() - 1);
    };
    for (const places::Found& one : finder.on(caret->page)) {
        if (!isBefore(one))
            break;
        ++index;
    }
    showFound(static_cast<int>(found_.numberOf(index % finder.count())));
}

void DocumentView::paintFound(QPainter& painter, std::size_t page) const {
    const places::Found* shown = found_.seen(found_.shown());
    for (const places::Found& one : found_.onPages().on(page))
        for (const places::Found::Part& part : one.parts)
            painter.fillRect(part.rect(),
                             &one == shown ? QColor(255, 150, 30, 130) : QColor(255, 220, 60, 110));
}

std::pair<std::size_t, std::size_t> DocumentView::seenPages() const {
    const PagePlaces places = this->places();
    const int top = verticalScrollBar()->value();
    return {places.firstAt(top),
            std::min(places.endAbove(top + viewport()->height()), pages().pages.size())};
}

} // namespace view
