#include "source/source_pane.h"

#include "panes/making_room.h"
#include "plain/plain.h"

#include <QMainWindow>
#include <QSettings>
#include <QTextBlock>
#include <QVBoxLayout>

namespace source {

namespace {

constexpr auto areaKey = "source/area", widthKey = "source/width", shownKey = "source/shown";

// The letters of a text that a document has, marked.
std::vector<LineMarks> marksOfLines(const session::OpenDocument& open, const DocumentMirror& mirror,
                                    int line, int count) {
    const sgml::Tree& tree = open.document().tree();
    const std::size_t from = mirror.lineStart(line);
    std::size_t to = from;
    for (int i = 0; i < count; ++i)
        to = lineAfter(tree.bytes(), to);
    const auto isText = [&](std::string_view name) { return open.schemas().isText(name); };
    return lineMarksOf(tree.bytes(), from, count, marksOf(tree, {from, to}, isText));
}

} // namespace

SourcePane::SourcePane(view::DocumentView& view, QMainWindow* parent)
    : QDockWidget(tr("Source"), parent), view_(view), edit_(new SourceEdit(this)),
      place_(plain::label({}, this)),
      mirror_(new DocumentMirror(view.document().document(), *edit_)),
      steps_(new InStep(view, *edit_, *mirror_)) {
    mirror_->setParent(this);
    steps_->setParent(this);
    setObjectName("source");
    setAllowedAreas(Qt::LeftDockWidgetArea | Qt::RightDockWidgetArea);
    edit_->setObjectName("sourceText");
    edit_->setAccessibleName(tr("Source"));
    place_->setObjectName("sourcePlace");
    place_->setMargin(3);
    place_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    auto* inside = new QWidget(this);
    auto* column = new QVBoxLayout(inside);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(edit_, 1);
    column->addWidget(place_);
    setWidget(inside);
    setFocusProxy(edit_);
    new panes::MakingRoom(*this, view_);
    toggleViewAction()->setObjectName("showSource");
    toggleViewAction()->setText(tr("So&urce"));
    toggleViewAction()->setShortcut(QKeySequence("Ctrl+U"));
    edit_->setMarker([this](int line, int count) {
        return mirror_->isComplete() ? marksOfLines(view_.document(), *mirror_, line, count)
                                     : std::vector<LineMarks>{};
    });
    connect(edit_, &SourceEdit::left, steps_, &InStep::goToPages);
    connect(edit_, &SourceEdit::refused, this, &SourcePane::said);
    connect(edit_, &QPlainTextEdit::cursorPositionChanged, this, &SourcePane::tellPlace);
    connect(mirror_, &DocumentMirror::completed, this, &SourcePane::updateWritable);
    connect(&view_, &view::DocumentView::writingChanged, this, &SourcePane::updateWritable);
    connect(toggleViewAction(), &QAction::triggered, this, [this](bool isShown) {
        QSettings().setValue(shownKey, isShown);
        if (isShown)
            edit_->setFocus();
        else
            view_.setFocus();
    });
    connect(this, &QDockWidget::dockLocationChanged, this, [](Qt::DockWidgetArea area) {
        if (area != Qt::NoDockWidgetArea)
            QSettings().setValue(areaKey, static_cast<int>(area));
    });
    updateWritable();
}

// Both look at what goes with the pane.
SourcePane::~SourcePane() {
    delete steps_;
    delete mirror_;
}

void SourcePane::placeIn(QMainWindow& window) {
    const bool isLeft =
        QSettings().value(areaKey).toInt() == static_cast<int>(Qt::LeftDockWidgetArea);
    window.addDockWidget(isLeft ? Qt::LeftDockWidgetArea : Qt::RightDockWidgetArea, this);
    constexpr int usual = 420, least = 120;
    window.resizeDocks({this}, {std::max(least, QSettings().value(widthKey, usual).toInt())},
                       Qt::Horizontal);
    setVisible(QSettings().value(shownKey, false).toBool());
}

void SourcePane::keepWidth() const {
    if (!isFloating())
        QSettings().setValue(widthKey, width());
}

void SourcePane::showEvent(QShowEvent* event) {
    QDockWidget::showEvent(event);
    if (event->spontaneous())
        return;
    mirror_->start();
    steps_->beginAtPages();
}

void SourcePane::hideEvent(QHideEvent* event) {
    QDockWidget::hideEvent(event);
    if (event->spontaneous())
        return;
    keepWidth();
    mirror_->stop();
}

void SourcePane::updateWritable() {
    edit_->setWhyNotWritable(
        !view_.isWriting()
            ? tr("This is a reading view. Edit > Write (Ctrl+E) makes its source writable.")
        : !mirror_->isComplete() ? tr("The source is still being read.")
                                 : QString());
    tellPlace();
}

// "Line 12, column 4", and what is wrong there, or elsewhere.
void SourcePane::tellPlace() {
    const QTextCursor cursor = edit_->textCursor();
    const QString place =
        tr("Line %1, column %2").arg(cursor.blockNumber() + 1).arg(cursor.positionInBlock() + 1);
    QString more = edit_->faultOf(cursor.blockNumber());
    if (more.isEmpty() && !view_.isWriting())
        more = tr("a reading view (Ctrl+E writes)");
    if (const LineFault fault = edit_->firstFault(); more.isEmpty() && fault.line > 0)
        more = tr("line %1: %2").arg(fault.line).arg(fault.sentence);
    place_->setText(more.isEmpty() ? place : tr("%1; %2").arg(place, more));
    place_->setToolTip(plain::tip(more));
}

void SourcePane::setFaults(const std::vector<session::ListedFault>& faults) {
    std::vector<LineFault> lines;
    for (const session::ListedFault& fault : faults)
        if (fault.file.isEmpty())
            lines.push_back(
                {fault.position.line, fault.position.column, fault.isError, fault.message});
    edit_->setFaults(lines);
    tellPlace();
}

void SourcePane::goTo(const text::Position& place) {
    const QTextBlock block = edit_->document()->findBlockByNumber(place.line - 1);
    if (!isVisible() || !block.isValid())
        return;
    QTextCursor cursor(block);
    const int last = block.length() - 1;
    cursor.movePosition(QTextCursor::NextCharacter, QTextCursor::MoveAnchor,
                        std::clamp(place.column - 1, 0, last));
    edit_->setTextCursor(cursor);
    edit_->setFocus();
}

} // namespace source
