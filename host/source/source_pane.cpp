#include "source/source_pane.h"

#include "panes/making_room.h"

#include <QMainWindow>
#include <QSettings>

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
    : QDockWidget(tr("Source"), parent), view_(view),
      frame_(new EditFrame(QStringLiteral("source"), tr("Source"), this)), edit_(&frame_->edit()),
      mirror_(new DocumentMirror(view.document().document(), *edit_)),
      steps_(new InStep(view, *edit_, *mirror_)) {
    mirror_->setParent(this);
    steps_->setParent(this);
    setObjectName("source");
    setAllowedAreas(Qt::LeftDockWidgetArea | Qt::RightDockWidgetArea);
    setWidget(frame_);
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
    frame_->setNote(view_.isWriting() ? QString() : tr("a reading view (Ctrl+E writes)"));
}

void SourcePane::setFaults(const std::vector<session::ListedFault>& faults) {
    std::vector<LineFault> lines;
    for (const session::ListedFault& fault : faults)
        if (fault.file.isEmpty())
            lines.push_back(
                {fault.position.line, fault.position.column, fault.isError, fault.message});
    frame_->setFaults(lines);
}

void SourcePane::goTo(const text::Position& place) {
    if (isVisible())
        frame_->goTo(place);
}

} // namespace source
