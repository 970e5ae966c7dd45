#include "source/in_step.h"

#include "controls/accent.h"
#include "view/folds.h"
#include "view/text_hand.h"

#include <QApplication>
#include <QPainter>
#include <QScrollBar>
#include <QTextBlock>

namespace source {

using sgml::NodeId, sgml::noNode;

namespace {

// While one scrolls, the source follows that often.
constexpr int pagesMs = 40;

} // namespace

InStep::InStep(view::DocumentView& view, SourceEdit& edit, DocumentMirror& mirror)
    : view_(view), edit_(edit), mirror_(mirror) {
    for (QTimer* timer : {&pagesLead_, &sourceLeads_})
        timer->setSingleShot(true);
    connect(&pagesLead_, &QTimer::timeout, this, &InStep::followPages);
    connect(&sourceLeads_, &QTimer::timeout, this, &InStep::followSource);
    const auto pagesMoved = [this] {
        const bool leads = isBeginning_ || !edit_.hasFocus();
        if (mirror_.isComplete() && leads && !pagesLead_.isActive())
            pagesLead_.start(pagesMs);
    };
    connect(&view_, &view::DocumentView::selectionChanged, this, pagesMoved);
    connect(&view_, &view::DocumentView::laidOut, this, pagesMoved);
    connect(view_.verticalScrollBar(), &QScrollBar::valueChanged, this, pagesMoved);
    connect(&mirror_, &DocumentMirror::completed, this, pagesMoved);
    const auto sourceMoved = [this] {
        if (!edit_.hasFocus() || !mirror_.isComplete() || mirror_.isFollowing())
            return;
        isBeginning_ = false;
        sourceLeads_.start(0);
    };
    connect(&edit_, &QPlainTextEdit::cursorPositionChanged, this, sourceMoved);
    connect(&edit_, &QPlainTextEdit::selectionChanged, this, sourceMoved);
    connect(&mirror_, &DocumentMirror::typed, this, [this] { isTyping_ = true; });
    connect(&view_, &view::DocumentView::laidOut, this, [this] {
        if (edit_.hasFocus() && !marked_.empty())
            markAround(mirror_.selection().caret); // it may stand elsewhere now
    });
    connect(&view_.document().document(), &document::Document::selectionRestored, this,
            [this](const document::Selection& selection) {
                if (edit_.hasFocus() && mirror_.isComplete()) {
                    mirror_.select(selection);
                    isTyping_ = true;
                    sourceLeads_.start(0);
                }
            });
    connect(&view_, &view::DocumentView::paintingPage, this, &InStep::paint);
    connect(qApp, &QApplication::focusChanged, this, [this](QWidget* old, QWidget* now) {
        if (now == &edit_ && mirror_.isComplete() && !isBeginning_)
            sourceLeads_.start(0);
        else if (old == &edit_ && !marked_.empty()) {
            marked_ = {};
            view_.viewport()->update();
        }
    });
}

document::SubdocumentId InStep::figureAt(std::size_t offset) const {
    const document::Document& document = view_.document().document();
    const sgml::Tree& tree = document.tree();
    for (NodeId node = tree.innermostAt(offset); node != tree.root(); node = tree.node(node).parent)
        if (const document::SubdocumentId id = document.subdocumentOf(node);
            id != document::noSubdocument &&
            !view_.document().schemas().isText(document.subdocument(id)->className))
            return id;
    return document::noSubdocument;
}

// --- the pages lead ----------------------------------------------------------------------------

void InStep::followPages() {
    if (!mirror_.isComplete() || (edit_.hasFocus() && !isBeginning_))
        return;
    const document::Document& document = view_.document().document();
    const std::optional<document::Selection> selection = view_.text().cursor().selection();
    const std::optional<QRectF> caret = view_.text().caretRect();
    const QRectF seen = view_.viewport()->rect();
    if (const document::Subdocument* figure = document.subdocument(view_.chosen())) {
        showInSource(document.tree().node(figure->element).range.from);
    } else if (selection && caret && seen.contains(caret->center())) {
        mirror_.select(*selection);
        edit_.setBand(edit_.textCursor().position());
    } else if (const std::optional<view::ReadingPlace> reading = view_.readingPlace()) {
        showInSource(reading->place);
    }
    isBeginning_ = false;
}

// The caret stays where somebody has put it.
void InStep::showInSource(std::size_t place) {
    const int at = mirror_.positionOf(place);
    edit_.setBand(at);
    edit_.scrollToLine(at);
    if (isBeginning_)
        mirror_.select({place, place});
}

void InStep::beginAtPages() {
    isBeginning_ = true;
    if (mirror_.isComplete())
        pagesLead_.start(0);
}

// --- the source leads --------------------------------------------------------------------------

void InStep::followSource() {
    if (!mirror_.isComplete() || !edit_.hasFocus())
        return;
    const document::Selection selection = mirror_.selection();
    edit_.setBand(edit_.textCursor().position());
    view_.settleSoon();
    showInPages(selection);
    markAround(selection.caret);
    isTyping_ = false;
}

// The pages stay where they are while one types in what they show.
void InStep::showInPages(const document::Selection& selection) {
    view_.folds().reveal(selection.caret);
    if (const document::SubdocumentId figure = figureAt(selection.caret);
        figure != document::noSubdocument)
        return view_.scrollTo(figure);
    const places::Carets carets(view_.pages(), view_.document().document().tree());
    const auto placeOf = [&](std::size_t offset) -> std::optional<std::size_t> {
        const std::optional<places::Caret> caret = carets.of(offset, view_.currentPage());
        return caret ? std::optional(carets.placeOf(*caret)) : std::nullopt;
    };
    const std::optional<std::size_t> caret = placeOf(selection.caret);
    const std::optional<std::size_t> anchor =
        selection.isEmpty() ? caret : placeOf(selection.anchor);
    if (!caret || !anchor)
        return;
    view_.choose(document::noSubdocument);
    view_.text().cursor().set({*anchor, *caret});
    view_.text().showCaret();
}

// A caret in text marks that text, one in a tag the element.
void InStep::markAround(std::size_t offset) {
    const document::Document& document = view_.document().document();
    const document::SubdocumentId figure = figureAt(offset);
    const NodeId node = figure == document::noSubdocument ? document.tree().innermostAt(offset)
                                                          : document.subdocument(figure)->element;
    const bool isAll = node == document.tree().root() ||
                       node == document.tree().classElement(document.tree().root());
    marked_ = isAll ? text::Range{} : document.tree().node(node).range;
    view_.viewport()->update();
}

void InStep::paint(QPainter& painter, std::size_t page) const {
    if (marked_.empty())
        return;
    const document::Document& document = view_.document().document();
    const places::Carets carets(view_.pages(), document.tree());
    QColor tint = controls::accent;
    constexpr double faint = 0.12;
    tint.setAlphaF(faint);
    for (const QRectF& rect : carets.selected(page, marked_))
        painter.fillRect(rect, tint);
    constexpr double beside = 40, width = 30; // twips
    painter.setPen(QPen(controls::accent, width));
    painter.setBrush(Qt::NoBrush);
    for (const layout::PlacedObject& object : view_.pages().pages[page]->objects) {
        const document::Subdocument* of = document.subdocument(object.subdocument);
        const NodeId element = of ? of->element : object.element;
        if (element != noNode && document.tree().holds(element) &&
            marked_.contains(document.tree().node(element).range.from))
            painter.drawRect(object.rect.adjusted(-beside, -beside, beside, beside));
    }
}

void InStep::goToPages() {
    view_.setFocus();
    pagesLead_.start(0);
}

} // namespace source
