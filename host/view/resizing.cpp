#include "view/resizing.h"

#include "controls/accent.h"

#include "layout/measure.h"
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
            found = Sized{chosen->classElement, view.placeOf(chosen->id), object.align};
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

// --- corners -----------------------------------------------------------------------------------

QRectF Resizing::handleOf(const Sized& unit, Corner corner) {
    const QPointF at = corner == Corner::left ? unit.place.bottomLeft() : unit.place.bottomRight();
    return {at - QPointF(handle, handle) / 2, QSizeF(handle, handle)};
}

Resizing::Corner Resizing::cornerAt(const Sized& unit, QPointF point) {
    constexpr double slack = 3;
    for (const Corner corner : {Corner::right, Corner::left})
        if (handleOf(unit, corner).adjusted(-slack, -slack, slack, slack).contains(point))
            return corner;
    return Corner::none;
}

std::optional<Qt::CursorShape> Resizing::cursorAt(QPointF point) {
    const std::optional<Sized> unit = taken_ ? taken_->unit : sizedUnit(view_);
    const Corner corner = taken_ ? taken_->corner : unit ? cornerAt(*unit, point) : Corner::none;
    if (corner != Corner::none)
        return corner == Corner::right ? Qt::SizeFDiagCursor : Qt::SizeBDiagCursor;
    if (imageAt(view_, point) != sgml::noNode)
        return Qt::ArrowCursor;
    return std::nullopt;
}

void Resizing::take(QPointF point) {
    const std::optional<Sized> unit = sizedUnit(view_);
    const Corner corner = unit ? cornerAt(*unit, point) : Corner::none;
    if (corner == Corner::none)
        return selectImage(view_, imageAt(view_, point));
    const QPointF at =
        corner == Corner::left ? unit->place.bottomLeft() : unit->place.bottomRight();
    taken_ = Taken{*unit, corner, point - at, unit->place.width()};
}

// That of the page's text.
double Resizing::mostWidth() const {
    const std::shared_ptr<const model::Model> model = view_.model();
    if (!model)
        return view_.viewport()->width();
    const schemas::PageStyle& page = model->page;
    const double points = page.width - page.marginLeft - page.marginRight;
    return layout::toPixels({layout::fromPoints(points), 0}).width() * view_.zoom();
}

// The corner follows the pointer, on the side where the unit is not held; one in the middle grows
// to both sides.
void Resizing::drag(QPointF point) {
    if (!taken_)
        return;
    const QRectF& place = taken_->unit.place;
    const QPointF corner = point - taken_->grip;
    const bool isRight = taken_->corner == Corner::right;
    const QPointF moved = corner - (isRight ? place.bottomRight() : place.bottomLeft());
    const double outward = isRight ? moved.x() : -moved.x();
    const bool isCentered = taken_->unit.align == schemas::Align::center;
    const double byX = outward * (isCentered ? 2 : 1);
    const double byY = moved.y() * place.width() / std::max(place.height(), 1.0);
    // The way of the pointer that is more along the diagonal counts.
    const double by = std::abs(byX) > std::abs(byY) ? byX : byY;
    const double most = std::max(mostWidth(), leastWidth * view_.zoom());
    taken_->width = std::clamp(place.width() + by, leastWidth * view_.zoom(), most);
}

void Resizing::finish() {
    const std::optional<Taken> done = std::exchange(taken_, std::nullopt);
    if (done && std::abs(done->width - done->unit.place.width()) >= 1)
        setWidth(done->unit, done->width);
}

void Resizing::takeTwice(QPointF point) {
    taken_.reset();
    const std::optional<Sized> unit = sizedUnit(view_);
    if (unit && cornerAt(*unit, point) != Corner::none)
        view_.writing().change([&](const authoring::Manuscript& in, authoring::Selection at) {
            return authoring::setAttributes(in, at, unit->element, {{"WIDTH", ""}, {"HEIGHT", ""}},
                                            Writing::tr("Size"));
        });
}

// A height that is given follows.
void Resizing::setWidth(const Sized& unit, double width) {
    const double scale = width / unit.place.width();
    const double pixels = width / view_.zoom();
    const auto& tree = view_.document().document().tree();
    authoring::Attributes attributes{{"WIDTH", std::to_string(std::lround(pixels))}};
    const auto height =
        document::numberIn(tree.attribute(unit.element, "HEIGHT"), 1, document::longestLength);
    if (height)
        attributes.emplace_back(
            "HEIGHT", std::to_string(std::lround(unit.place.height() * scale / view_.zoom())));
    view_.writing().change([&](const authoring::Manuscript& in, authoring::Selection at) {
        return authoring::setAttributes(in, at, unit.element, attributes, Writing::tr("Size"));
    });
}

void Resizing::selectionChanged() {
    const std::optional<Sized> unit = view_.isWriting() ? sizedUnit(view_) : std::nullopt;
    const QRectF place = unit ? unit->place.adjusted(-handle, -handle, handle, handle) : QRectF();
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
        const QSizeF size = place.size() * (taken_->width / place.width());
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
    const Sized shown{unit->element, place, unit->align};
    for (const Corner corner : {Corner::left, Corner::right})
        painter.drawRect(handleOf(shown, corner));
    painter.restore();
}

} // namespace view
