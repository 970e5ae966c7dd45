#include "source/presentation_pane.h"

#include "controls/keyboard.h"
#include "panes/asked_save.h"
#include "panes/making_room.h"
#include "plain/plain.h"
#include "source/letters.h"
#include "source/presentation_marks.h"
#include "source/shown_bytes.h"

#include <QCloseEvent>
#include <QDir>
#include <QMainWindow>
#include <QMessageBox>
#include <QVBoxLayout>

namespace source {

namespace {

// After the last key.
constexpr int pauseMs = 150;

} // namespace

PresentationPane::PresentationPane(view::DocumentView& view, QMainWindow* parent)
    : QDockWidget(tr("Presentation"), parent), view_(view),
      frame_(new EditFrame(QStringLiteral("presentation"), tr("Presentation"), this)),
      whose_(plain::label({}, this)) {
    setObjectName("presentation");
    setAllowedAreas(Qt::LeftDockWidgetArea | Qt::RightDockWidgetArea);
    whose_->setObjectName("presentationWhose");
    whose_->setWordWrap(true);
    whose_->setMargin(4);
    auto* inside = new QWidget(this);
    auto* column = new QVBoxLayout(inside);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(whose_);
    column->addWidget(frame_, 1);
    setWidget(inside);
    setFocusProxy(&edit());
    new panes::MakingRoom(*this, view_);
    pause_.setSingleShot(true);
    pause_.setInterval(pauseMs);
    connect(&pause_, &QTimer::timeout, this, [this] { present(text_); });
    edit().setMarker([this](int line, int count) {
        const auto first = static_cast<std::size_t>(line);
        return first < lines_.size() ? lineMarksOf(text_, lines_[first], count, marks_)
                                     : std::vector<LineMarks>{};
    });
    connect(&edit(), &QPlainTextEdit::textChanged, this, &PresentationPane::read);
    connect(edit().document(), &QTextDocument::modificationChanged, this, &PresentationPane::tell);
    connect(&edit(), &SourceEdit::saveWanted, this, &PresentationPane::save);
    connect(&edit(), &SourceEdit::refused, this, &PresentationPane::said);
    connect(&edit(), &SourceEdit::left, this, [this] { view_.setFocus(); });
    parent->addDockWidget(Qt::RightDockWidgetArea, this);
    hide();
}

bool PresentationPane::open(const schemas::Schemas::File& file) {
    if (!isVisible() || !draft_ || draft_->name() != file.name) {
        if (!mayClose())
            return false;
        path_ = file.path;
        draft_.emplace(file, schemas::Schemas::standardFolders().first());
        fill();
        if (draft_->savedText() != file.text)
            present(text_); // another program has changed it
        else
            pause_.stop();
    }
    if (isHidden() && !isFloating())
        standBeside();
    show();
    raise();
    edit().setFocus();
    return true;
}

// Half of the window is its own, where the source stands there, too.
void PresentationPane::standBeside() {
    auto* window = qobject_cast<QMainWindow*>(parentWidget());
    if (!window)
        return;
    constexpr int usual = 420;
    show();
    window->resizeDocks({this}, {std::max(usual, width())}, Qt::Horizontal);
    window->resizeDocks({this}, {window->height() / 2}, Qt::Vertical);
}

// The file's text, as it was read or saved.
void PresentationPane::fill() {
    const QString letters = shown(draft_->savedText());
    const bool isText = spelled(letters, lineEndOf(draft_->savedText())) == draft_->savedText();
    edit().setWhyNotWritable(
        isText ? QString()
               : tr("This file is no text of UTF-8 and one kind of line end: another program must "
                    "change it."));
    edit().setPlainText(letters);
    edit().document()->setModified(false);
    tell();
}

// The typed text, with its marks, at once.
void PresentationPane::read() {
    text_ = draft_ ? spelled(lettersOf(*edit().document()), lineEndOf(draft_->savedText()))
                   : std::string();
    marks_ = presentationMarks(text_);
    lines_ = {0};
    while (lines_.size() < static_cast<std::size_t>(edit().blockCount()))
        lines_.push_back(lineAfter(text_, lines_.back()));
    std::vector<sgml::Fault> faults;
    (void)schemas::Presentation::parse(text_, faults);
    std::vector<LineFault> lines;
    lines.reserve(faults.size());
    for (const sgml::Fault& fault : faults)
        lines.push_back({fault.position.line, fault.position.column, true,
                         QString::fromStdString(fault.message)});
    frame_->setFaults(lines);
    pause_.start();
}

void PresentationPane::present(const std::string& text) {
    pause_.stop();
    if (draft_)
        Q_EMIT edited(draft_->name(), draft_->isCopy() ? path_ : draft_->path(), text);
}

// The owner of the file, and the place where saving writes.
void PresentationPane::tell() {
    if (!draft_)
        return;
    const QString path = QDir::toNativeSeparators(draft_->path());
    const bool isChanged = edit().document()->isModified();
    setWindowTitle(
        plain::title(isChanged ? tr("%1, not saved").arg(draft_->name()) : draft_->name()));
    whose_->setText(draft_->isCopy()
                        ? tr("This file comes with the program and stays as it is. Ctrl+S writes "
                             "your own copy, which counts for all your documents of this class "
                             "until you delete it: %1")
                              .arg(path)
                        : tr("Your own file, for all your documents of this class: %1").arg(path));
}

bool PresentationPane::save() {
    if (!draft_)
        return false;
    const bool isSaved = panes::saveAsking(this, tr("Save"), [this](files::SaveOptions options) {
        return draft_->save(text_, options);
    });
    if (!isSaved)
        return false;
    edit().document()->setModified(false);
    tell();
    present(text_);
    Q_EMIT said(tr("Saved %1").arg(draft_->path()));
    return true;
}

bool PresentationPane::hasKeyboard() const {
    const QWidget* focus = controls::keyboardWidget();
    return focus && isAncestorOf(focus);
}

QString PresentationPane::fileName() const { return draft_ ? draft_->name() : QString(); }

void PresentationPane::bringSupplied(const QString& name) {
    const auto supplied = schemas::Schemas::suppliedFile(name);
    const bool isShown = fileName() == name;
    if (!supplied || (isShown && !mayClose()))
        return;
    if (const QString why = putOwnPresentationAside(name); !why.isEmpty())
        return Q_EMIT said(tr("%1 stays: %2").arg(ownPresentation(name), why));
    if (isShown) {
        path_ = supplied->path;
        draft_.emplace(*supplied, schemas::Schemas::standardFolders().first());
        fill();
    }
    pause_.stop();
    Q_EMIT edited(name, supplied->path, supplied->text);
    Q_EMIT said(tr("%1 is as it comes with the program. Your own file is kept as %2")
                    .arg(name, ownPresentation(name) + '~'));
}

bool PresentationPane::mayClose() {
    if (!draft_ || !edit().document()->isModified())
        return true;
    const auto answer = plain::Message::ask(
        QMessageBox::Question, this, tr("Close"),
        tr("The presentation %1 has changes that are not saved.").arg(draft_->name()),
        QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, QMessageBox::Save);
    if (answer == QMessageBox::Save)
        return save();
    if (answer != QMessageBox::Discard)
        return false;
    fill(); // the pages look as the file says
    present(text_);
    return true;
}

void PresentationPane::closeEvent(QCloseEvent* event) {
    event->setAccepted(mayClose());
    if (!event->isAccepted())
        return;
    draft_.reset();
    view_.setFocus();
}

} // namespace source
