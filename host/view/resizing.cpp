#include "view/resizing.h"

#include "controls/accent.h"

#include "paragraphs/measure.h"
#include "view/document_view.h"
#include "view/text_hand.h"
#include "view/writing.h"

#include <QApplication>
#include <algorithm>
#include <cmath>

namespace view {

namespace {

constexpr double leastWidth = 16; // logical pixels at 100 %

// The pages that are seen, first and behind the last.
std::pair<std::size_t, std::size_t> seenPages(const DocumentView& view) {
    if (view.pages().pages.empty())
        return {0, 0};
    const QRectF seen = view.viewport()->rect();
    return {view.pagePointAt(seen.topLeft()).first, view.pagePointAt(seen.bottomLeft()).first + 1};
}

// Calls `look` for each image and subdocument that is seen, until it says true.
template <class Look> void forObjects(const DocumentView& view, Look look) {
    const auto [first, end] = seenPages(view);
    for (std::size_t page = first; page < end; ++page)
        for (const layout::PlacedObject& object : view.pages().pages[page]->objects)
            if (look(object, view.inViewport(page, object.rect)))
                return;
}

std::optional<text::Range> rangeOf(const sgml::Tree& tree, sgml::NodeId element) {
    if (element == sgml::noNode || !tree.holds(element) || !tree.isElement(element))
        return std::nullopt;
    return tree.node(element).range;
}

} // namespace

std::optional<Sized> sizedUnit(const DocumentView& view) {
    const document::Document& document = view.document().document();
    const document::Subdocument* chosen = document.subdocument(view.chosen());
    const text::Range selected = view.text().cursor().interval();
    std::optional<Sized> found;
    if (!chosen && selected.empty())
        return found;
    forObjects(view, [&](const layout::PlacedObject& object, const QRectF& place) {
        if (chosen && chosen->id == object.subdocument && chosen->classElement != sgml::noNode)
            found = Sized{chosen->classElement, view.placeOf(chosen->id), object.align, true};
        const auto range = chosen ? std::nullopt : rangeOf(document.tree(), object.element);
        if (range && range->from == selected.from && range->to == selected.to)
            found = Sized{object.element, place, object.align};
        return found.has_value();
    });
    return found;
}

sgml::NodeId imageAt(const DocumentView& view, QPointF point) {
    const sgml::Tree& tree = view.document().document().tree();
    sgml::NodeId found = sgml::noNode;
    forObjects(view, [&](const layout::PlacedObject& object, const QRectF& place) {
        if (place.contains(point) && rangeOf(tree, object.element))
            found = object.element;
        return found != sgml::noNode;
    });
    return found;
}

void selectImage(DocumentView& view, sgml::NodeId element) {
    if (const auto range = rangeOf(view.document().document().tree(), element)) {
        view.choose(document::noSubdocument);
        view.text().cursor().set({range->from, range->to});
    }
}

// --- handles -----------------------------------------------------------------------------------

std::vector<Resizing::Handle> Resizing::handlesOf(const Sized& unit) {
    std::vector<Handle> all{Handle::rightCorner, Handle::leftCorner};
    if (unit.hasEdges)
        all.insert(all.end(), {Handle::right, Handle::left, Handle::bottom});
    return all;
}

QPointF Resizing::pointOf(const QRectF& place, Handle handle) {
    switch (handle) {
    case Handle::leftCorner:
        return place.bottomLeft();
    case Handle::left:
        return {place.left(), place.center().y()};
    case Handle::right:
        return {place.right(), place.center().y()};
    case Handle::bottom:
        return {place.center().x(), place.bottom()};
    default:
        return place.bottomRight();
    }
}

QRectF Resizing::rectOf(const QRectF& place, Handle handle) {
    return {pointOf(place, handle) - QPointF(side, side) / 2, QSizeF(side, side)};
}

Resizing::Handle Resizing::handleAt(const Sized& unit, QPointF point) {
    constexpr double slack = 3;
    for (const Handle handle : handlesOf(unit))
        if (rectOf(unit.place, handle).adjusted(-slack, -slack, slack, slack).contains(point))
            return handle;
    return Handle::none;
}

std::optional<Qt::CursorShape> Resizing::cursorAt(QPointF point) {
    const std::optional<Sized> unit = taken_ ? taken_->unit : sizedUnit(view_);
    switch (taken_ ? taken_->handle : unit ? handleAt(*unit, point) : Handle::none) {
    case Handle::leftCorner:
        return Qt::SizeBDiagCursor;
    case Handle::rightCorner:
        return Qt::SizeFDiagCursor;
    case Handle::left:
    case Handle::right:
        return Qt::SizeHorCursor;
    case Handle::bottom:
        return Qt::SizeVerCursor;
    case Handle::none:
        break;
    }
    if (imageAt(view_, point) != sgml::noNode)
        return Qt::ArrowCursor;
    return std::nullopt;
}

void Resizing::take(QPointF point) {
    const std::optional<Sized> unit = sizedUnit(view_);
    const Handle handle = unit ? handleAt(*unit, point) : Handle::none;
    if (handle == Handle::none)
        return selectImage(view_, imageAt(view_, point));
    taken_ = Taken{*unit, handle, point - pointOf(unit->place, handle), unit->place.size()};
}

// That of the page's text.
QSizeF Resizing::mostSize() const {
    const std::shared_ptr<const model::Model> model = view_.model();
    if (!model)
        return view_.viewport()->size();
    const schemas::PageStyle& page = model->page;
    const QSizeF points(page.width - page.marginLeft - page.marginRight,
                        page.height - page.marginTop - page.marginBottom);
    return paragraphs::toPixels(points * paragraphs::twipsPerPoint) * view_.zoom();
}

// The handle follows the pointer, on the side where the unit is not held; one in the middle grows
// to both sides.
void Resizing::drag(QPointF point) {
    if (!taken_)
        return;
    const QRectF& place = taken_->unit.place;
    const Handle handle = taken_->handle;
    const QPointF moved = point - taken_->grip - pointOf(place, handle);
    const bool isCentered = taken_->unit.align == schemas::Align::center;
    const double byX = (isLeft(handle) ? -moved.x() : moved.x()) * (isCentered ? 2 : 1);
    const double byY = moved.y() * place.width() / std::max(place.height(), 1.0);
    const double least = leastWidth * view_.zoom();
    const QSizeF most = mostSize().expandedTo({least, least});
    if (handle == Handle::bottom) {
        taken_->size.setHeight(std::clamp(place.height() + moved.y(), least, most.height()));
        return;
    }
    // At a corner the way of the pointer that is more along the diagonal counts.
    const double by = !isCorner(handle) || std::abs(byX) > std::abs(byY) ? byX : byY;
    const double width = std::clamp(place.width() + by, least, most.width());
    if (isCorner(handle))
        taken_->size = place.size() * (width / place.width());
    else
        taken_->size.setWidth(width);
}

void Resizing::finish() {
    const std::optional<Taken> done = std::exchange(taken_, std::nullopt);
    if (!done)
        return;
    const QSizeF by = done->size - done->unit.place.size();
    if (std::abs(by.width()) >= 1 || std::abs(by.height()) >= 1)
        setSize(done->unit, done->size, !isCorner(done->handle));
}

void Resizing::takeTwice(QPointF point) {
    taken_.reset();
    const std::optional<Sized> unit = sizedUnit(view_);
    if (unit && handleAt(*unit, point) != Handle::none)
        view_.writing().change([&](const authoring::Manuscript& in, authoring::Selection at) {
            return authoring::setAttributes(in, at, unit->element, {{"WIDTH", ""}, {"HEIGHT", ""}},
                                            Writing::tr("Size"));
        });
}

// A height that is given follows; `isFree`: it is given from now on.
void Resizing::setSize(const Sized& unit, QSizeF size, bool isFree) {
    const auto& tree = view_.document().document().tree();
    const QSizeF pixels = size / view_.zoom();
    authoring::Attributes attributes{{"WIDTH", std::to_string(std::lround(pixels.width()))}};
    if (isFree ||
        document::numberIn(tree.attribute(unit.element, "HEIGHT"), 1, document::longestLength))
        attributes.emplace_back("HEIGHT", std::to_string(std::lround(pixels.height())));
    view_.writing().change([&](const authoring::Manuscript& in, authoring::Selection at) {
        return authoring::setAttributes(in, at, unit.element, attributes, Writing::tr("Size"));
    });
}

void Resizing::selectionChanged() {
    const std::optional<Sized> unit = view_.isWriting() ? sizedUnit(view_) : std::nullopt;
    const QRectF place = unit ? unit->place.adjusted(-side, -side, side, side) : QRectF();
    view_.viewport()->update(shown_.united(place).toAlignedRect());
    shown_ = place;
}

// --- painting ----------------------------------------------------------------------------------

void Resizing::paint(QPainter& painter) const {
    const std::optional<Sized> unit = taken_ ? taken_->unit : sizedUnit(view_);
    if (!unit)
        return;
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    QRectF place = unit->place;
    if (taken_) {
        const QSizeF size = taken_->size;
        const double spare = place.width() - size.width();
        const bool isHeldRight = unit->align == schemas::Align::right;
        const double left = unit->align == schemas::Align::center ? spare / 2
                            : isHeldRight                         ? spare
                                                                  : 0;
        place = {place.topLeft() + QPointF(left, 0), size};
    }
    painter.setPen(QPen(controls::accent, 1.5, taken_ ? Qt::DashLine : Qt::SolidLine));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(place);
    painter.setPen(QPen(Qt::white, 1));
    painter.setBrush(controls::accent);
    for (const Handle handle : handlesOf(*unit))
        painter.drawRect(rectOf(place, handle));
    painter.restore();
}

} // namespace view
