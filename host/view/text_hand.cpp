#include "view/text_hand.h"

#include "authoring/table_nodes.h"
#include "clipboard/copying.h"
#include "manuscript/places.h"
#include "view/document_view.h"
#include "view/folds.h"
#include "view/gap_caret.h"
#include "view/writing.h"

#include <QApplication>
#include <QClipboard>
#include <QPointer>
#include <QScrollBar>

namespace view {

namespace {

constexpr int scrollMs = 30;

// The selection, made when somebody asks for it.
class LiveCopy : public QMimeData {
public:
    explicit LiveCopy(const TextHand& hand) : hand_(&hand) {}
    [[nodiscard]] QStringList formats() const override {
        return {QStringLiteral("text/plain"), QStringLiteral("text/html"), fragmentFormat};
    }
    [[nodiscard]] bool hasFormat(const QString& format) const override {
        return formats().contains(format);
    }

protected:
    [[nodiscard]] QVariant retrieveData(const QString& format, QMetaType) const override {
        const std::unique_ptr<QMimeData> copy = hand_ ? hand_->copied() : nullptr;
        if (!copy)
            return {};
        return format == QLatin1String("text/plain") ? QVariant(copy->text())
                                                     : QVariant(copy->data(format));
    }

private:
    QPointer<const TextHand> hand_;
};

} // namespace

TextHand::TextHand(DocumentView& view) : view_(view), cursor_(view.document().document()) {
    connect(&cursor_, &TextCursor::changed, this, &TextHand::refresh);
    scrolling_.setInterval(scrollMs);
    connect(&scrolling_, &QTimer::timeout, this, &TextHand::scrollOn);
}

places::Carets TextHand::carets() const {
    return {view_.pages(), view_.document().document().tree()};
}

std::optional<places::Caret> TextHand::caretAt(QPointF point) const {
    if (view_.pages().pages.empty())
        return std::nullopt;
    const auto [page, on] = view_.pagePointAt(point);
    return carets().at(page, on);
}

// --- the pointer -------------------------------------------------------------------------------

void TextHand::begin(QPointF point, TextCursor::Unit unit, bool extend) {
    view_.settle();
    dragging_ = true;
    at_ = point;
    if (const std::optional<places::Caret> caret = caretAt(point))
        cursor_.press(carets(), *caret, unit, extend);
}

void TextHand::press(const QMouseEvent& event) {
    const bool third =
        twice_.isValid() && twice_.elapsed() < QApplication::doubleClickInterval() &&
        (event.position() - twiceAt_).manhattanLength() < QApplication::startDragDistance();
    twice_.invalidate();
    begin(event.position(), third ? TextCursor::Unit::paragraph : TextCursor::Unit::letter,
          event.modifiers() & Qt::ShiftModifier);
}

void TextHand::pressTwice(const QMouseEvent& event) {
    twice_.start();
    twiceAt_ = event.position();
    begin(event.position(), TextCursor::Unit::word, false);
}

void TextHand::drag(QPointF point) {
    if (!dragging_)
        return;
    at_ = point;
    const QRectF inside = view_.viewport()->rect();
    if (point.y() < inside.top() || point.y() >= inside.bottom())
        scrolling_.start();
    else
        scrolling_.stop();
    if (const std::optional<places::Caret> caret = caretAt(point))
        cursor_.drag(carets(), *caret);
}

// The further away, the faster.
void TextHand::scrollOn() {
    const double above = std::min(0.0, at_.y());
    const double below = std::max(0.0, at_.y() - view_.viewport()->height());
    constexpr double least = 4, most = 80;
    const double by = std::clamp(std::abs(above + below) / 2, least, most);
    QScrollBar* bar = view_.verticalScrollBar();
    bar->setValue(bar->value() + static_cast<int>(above < 0 ? -by : by));
    drag(at_);
}

void TextHand::release() {
    scrolling_.stop();
    if (std::exchange(dragging_, false))
        publish();
}

bool TextHand::isOverText(QPointF point) const {
    if (view_.pages().pages.empty())
        return false;
    const auto [page, on] = view_.pagePointAt(point);
    for (const layout::Piece& piece : view_.pages().pages[page]->pieces)
        if (const auto* text = std::get_if<layout::TextPiece>(&piece)) {
            const double height =
                text->paragraph->lines()[static_cast<std::size_t>(text->line)].height;
            if (QRectF(text->at, QSizeF(text->paragraph->width(), height)).contains(on))
                return true;
        }
    return false;
}

bool TextHand::isSelected(QPointF point) const {
    if (!cursor_.selects() || view_.pages().pages.empty())
        return false;
    const std::pair<std::size_t, QPointF> at = view_.pagePointAt(point);
    const std::vector<QRectF> selected = selectedOn(at.first);
    return std::ranges::any_of(selected,
                               [&](const QRectF& rect) { return rect.contains(at.second); });
}

void TextHand::moveTo(const places::Caret& caret) { cursor_.moveTo(carets(), caret, false); }

// --- keys --------------------------------------------------------------------------------------

bool TextHand::useKey(int key, Qt::KeyboardModifiers modifiers, bool moves) {
    using places::Move;
    const bool extend = modifiers & Qt::ShiftModifier, far = modifiers & Qt::ControlModifier;
    if (!cursor_.selection() || (!extend && !moves) ||
        (modifiers & (Qt::AltModifier | Qt::MetaModifier)))
        return false;
    const auto move = [&](Move by) {
        view_.settle();
        cursor_.move(carets(), by, extend);
        showCaret();
        if (by == Move::documentStart)
            showEdge();
        if (extend)
            publish();
        return true;
    };
    switch (key) {
    case Qt::Key_Left:
        return move(far ? Move::wordLeft : Move::left);
    case Qt::Key_Right:
        return move(far ? Move::wordRight : Move::right);
    case Qt::Key_Up:
        return move(Move::up);
    case Qt::Key_Down:
        return move(Move::down);
    case Qt::Key_Home:
        return move(far ? Move::documentStart : Move::lineStart);
    case Qt::Key_End:
        return move(far ? Move::documentEnd : Move::lineEnd);
    case Qt::Key_PageUp:
    case Qt::Key_PageDown:
        movePage(key == Qt::Key_PageUp ? -1 : 1, extend);
        return true;
    default:
        return false;
    }
}

// A height of the view, less the line that one reads on from.
void TextHand::movePage(int by, bool extend) {
    view_.settle();
    const std::optional<QRectF> from = caretRect();
    if (!from)
        return;
    const double height = view_.viewport()->height() - from->height();
    const auto caret = caretAt(from->center() + QPointF(0, by * height));
    view_.verticalScrollBar()->setValue(view_.verticalScrollBar()->value() +
                                        static_cast<int>(by * height));
    if (caret)
        cursor_.moveTo(carets(), *caret, extend);
    showCaret();
    if (extend)
        publish();
}

void TextHand::selectAll() {
    view_.settle();
    cursor_.selectAll(carets());
    // Also what is folded at the end; the caret is where it is seen.
    if (const std::optional<document::Selection> seen = cursor_.selection()) {
        const document::Selection all =
            manuscript::everything(view_.writing().manuscript(), seen->anchor);
        if (view_.folds().pages().hiding(all.caret) != sgml::noNode)
            cursor_.set({all.caret, seen->anchor});
    }
    publish();
}

std::vector<sgml::NodeId> TextHand::selectedCells() const {
    const std::optional<document::Selection> selection = cursor_.selection();
    if (!selection || selection->isEmpty())
        return {};
    return authoring::selectedCells(view_.writing().manuscript(), *selection);
}

std::vector<QRectF> TextHand::selectedOn(std::size_t page) const {
    const std::vector<sgml::NodeId> cells = selectedCells();
    if (cells.empty())
        return carets().selected(page, cursor_.interval());
    std::vector<QRectF> all;
    const places::Carets places = carets();
    for (const sgml::NodeId cell : cells) {
        const std::vector<QRectF> one =
            places.selected(page, view_.document().document().tree().node(cell).range);
        all.insert(all.end(), one.begin(), one.end());
    }
    return all;
}

// --- the clipboard -----------------------------------------------------------------------------

std::unique_ptr<QMimeData> TextHand::copied() const {
    const std::shared_ptr<const model::Model> model = view_.model();
    if (!cursor_.selects() || !model)
        return nullptr;
    const std::vector<sgml::NodeId> cells = selectedCells();
    const document::Document& document = view_.document().document();
    return cells.empty() ? view::copied(document, *model, cursor_.interval())
                         : view::copied(document, *model, cells);
}

bool TextHand::copy() const {
    view_.settle();
    std::unique_ptr<QMimeData> copy = copied();
    if (!copy)
        return false;
    QApplication::clipboard()->setMimeData(copy.release());
    return true;
}

void TextHand::publish() {
    QClipboard* clipboard = QApplication::clipboard();
    if (clipboard->supportsSelection() && cursor_.selects())
        clipboard->setMimeData(new LiveCopy(*this), QClipboard::Selection);
}

// --- how it looks ------------------------------------------------------------------------------

// Over the text, which stays readable on any paper.
QColor TextHand::tint() const {
    const bool isActive = view_.hasFocus() && view_.isActiveWindow();
    QColor color = view_.palette().color(isActive ? QPalette::Active : QPalette::Inactive,
                                         QPalette::Highlight);
    constexpr double strong = 0.36, faint = 0.22;
    color.setAlphaF(isActive ? strong : faint);
    return color;
}

void TextHand::paintSelection(QPainter& painter, std::size_t page) const {
    if (!cursor_.selects())
        return;
    const QColor color = tint();
    for (const QRectF& rect : selectedOn(page))
        painter.fillRect(rect, color);
}

void TextHand::paintSelection(QPainter& painter, document::SubdocumentId id,
                              const QRectF& place) const {
    const document::Document& document = view_.document().document();
    const document::Subdocument* subdocument = document.subdocument(id);
    if (!cursor_.selects() || !subdocument)
        return;
    const text::Range own = document.tree().node(subdocument->element).range;
    const text::Range all = cursor_.interval();
    if (all.from <= own.from && own.to <= all.to)
        painter.fillRect(place, tint());
}

std::optional<QRectF> TextHand::caretRect() const {
    if (const std::optional<GapPlace> gap = gapOfCaret(view_))
        return view_.inViewport(gap->page, gap->caret());
    const places::Carets all = carets();
    const std::optional<places::Caret> caret = cursor_.caret(all);
    if (!caret)
        return std::nullopt;
    return view_.inViewport(caret->page, all.rectOf(*caret));
}

void TextHand::showCaret() {
    const std::optional<QRectF> rect = caretRect();
    if (rect && showRect(*rect))
        showEdge();
}

bool TextHand::showRect(const QRectF& rect) {
    constexpr double edge = 30;
    const auto show = [](QScrollBar* bar, double from, double to, double length) {
        const int before = bar->value();
        if (from < edge)
            bar->setValue(before + static_cast<int>(std::floor(from - edge)));
        else if (to > length - edge)
            bar->setValue(before + static_cast<int>(std::ceil(to - length + edge)));
        return bar->value() != before;
    };
    const bool down =
        show(view_.verticalScrollBar(), rect.top(), rect.bottom(), view_.viewport()->height());
    const bool across =
        show(view_.horizontalScrollBar(), rect.left(), rect.right(), view_.viewport()->width());
    return down || across;
}

// Beside the first and the last line of the document the edge of its page is seen, where there is
// room for both.
void TextHand::showEdge() {
    const places::Carets all = carets();
    const std::optional<places::Caret> caret = cursor_.caret(all);
    QScrollBar* bar = view_.verticalScrollBar();
    if (!caret)
        return;
    const auto showEnd = [&](places::Move end, int value) {
        const places::Caret last = all.moved(*caret, end);
        const QRectF line = all.rectOf(last), own = all.rectOf(*caret);
        if (last.page != caret->page || std::abs(line.top() - own.top()) > own.height() / 2)
            return;
        const QRectF rect = *caretRect();
        const double by = bar->value() - value;
        if (rect.top() + by >= 0 && rect.bottom() + by <= view_.viewport()->height())
            bar->setValue(value);
    };
    showEnd(places::Move::documentStart, bar->minimum());
    showEnd(places::Move::documentEnd, bar->maximum());
}

bool TextHand::isSeen(std::size_t place) const {
    const document::Document& document = view_.document().document();
    const sgml::Tree& tree = document.tree();
    const QRectF seen = view_.viewport()->rect();
    const auto [first, end] = view_.seenPages();
    for (std::size_t page = first; page < end; ++page)
        for (const layout::PlacedObject& object : view_.pages().pages[page]->objects) {
            const document::Subdocument* of = document.subdocument(object.subdocument);
            const sgml::NodeId element = of ? of->element : object.element;
            if (element != sgml::noNode && tree.holds(element) &&
                tree.node(element).range.contains(place) &&
                view_.inViewport(page, object.rect).intersects(seen))
                return true;
        }
    return false;
}

void TextHand::showPlace(std::size_t place) {
    view_.folds().reveal(place);
    if (isSeen(place))
        return;
    const document::Document& document = view_.document().document();
    for (const document::SubdocumentId id : document.subdocuments())
        if (document.tree().node(document.subdocument(id)->element).range.contains(place) &&
            !view_.placeOf(id).isNull())
            return view_.scrollTo(id);
    const places::Carets all = carets();
    if (const std::optional<places::Caret> caret = all.of(place, view_.currentPage()))
        showRect(view_.inViewport(caret->page, all.rectOf(*caret)));
}

void TextHand::moveIntoView() {
    if (const std::optional<places::Caret> caret = caretAt({0, 0}))
        cursor_.moveTo(carets(), *caret, false);
}

QRegion TextHand::region() const {
    QRegion result;
    const auto add = [&](const QRectF& rect) {
        result += rect.toAlignedRect().adjusted(-2, -2, 2, 2);
    };
    if (const std::optional<QRectF> caret = caretRect())
        add(*caret);
    if (!cursor_.selects())
        return result;
    const auto [first, end] = view_.seenPages();
    for (std::size_t page = first; page < end; ++page)
        for (const QRectF& rect : selectedOn(page))
            add(view_.inViewport(page, rect));
    for (const document::SubdocumentId id : view_.visibleSubdocuments())
        add(view_.placeOf(id));
    return result;
}

void TextHand::refresh() {
    const QRegion now = region();
    view_.viewport()->update(shown_ + now);
    shown_ = now;
}

} // namespace view
