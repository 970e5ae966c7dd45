#include "language/language_viewer.h"

#include "frame/help_menu.h"
#include "language/completer.h"
#include "language/draft.h"
#include "language/draft_row.h"
#include "language/element_marks.h"
#include "language/elision.h"
#include "language/fault_marks.h"
#include "language/find_bar.h"
#include "language/notice_bar.h"
#include "language/number_drag.h"
#include "language/scene_lexer.h"
#include "plain/plain.h"

#include <QCloseEvent>
#include <QInputDialog>
#include <QListWidget>
#include <QMenuBar>
#include <QPushButton>
#include <QSplitter>
#include <QTimer>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace views {

namespace {

// A key of the window that holds the text; a letter or an arrow is typed.
// In a pane the keys of a command are no shortcuts: the menus of the window have the command, too,
// and of each shortcut a window has one command. paneKey() looks for them.
constexpr const char* paneKeys = "paneKeys";

QList<QKeySequence> keysOf(const QAction& action) {
    const QVariant own = action.property(paneKeys);
    return own.isValid() ? own.value<QList<QKeySequence>>() : action.shortcuts();
}

void name(QAction& action, const QString& label) {
    const bool isLeft = action.property(paneKeys).isValid();
    action.setText(isLeft ? label + '\t' + keysOf(action).front().toString(QKeySequence::NativeText)
                          : plain::ours(label));
}

void leaveKeys(QAction& action) {
    if (action.shortcuts().isEmpty())
        return;
    action.setProperty(paneKeys, QVariant::fromValue(action.shortcuts()));
    action.setShortcuts(QList<QKeySequence>());
    name(action, action.text());
}

bool isCommandOf(const QWidget& window, const QKeyEvent& event) {
    const bool isTyped = !(event.modifiers() & (Qt::ControlModifier | Qt::AltModifier)) &&
                         (event.key() < Qt::Key_F1 || event.key() > Qt::Key_F35);
    const QKeySequence pressed(event.keyCombination());
    return !isTyped && std::ranges::any_of(window.findChildren<QAction*>(), [&](QAction* action) {
        return keysOf(*action).contains(pressed);
    });
}

} // namespace

LanguageViewer::LanguageViewer(SceneDocument& document, Windows windows, int number, Place place)
    : document_(document), windows_(std::move(windows)), number_(number), place_(place),
      editor_(new SceneEditor), messages_(new QListWidget),
      faults_(std::make_unique<FaultMarks>(*editor_, *messages_)),
      elision_(std::make_unique<Elision>(*editor_)),
      draft_(std::make_unique<Draft>(*editor_, document_)),
      elements_(std::make_unique<ElementMarks>(*editor_, document_, *draft_)),
      numbers_(std::make_unique<NumberDrag>(*editor_, document_, *draft_)),
      completer_(std::make_unique<Completer>(*editor_, document_)),
      notice_(new NoticeBar(*editor_, *draft_)), told_(new ToldBar),
      findBar_(new FindBar(*editor_)),
      row_(new DraftRow(document_, *draft_, *editor_,
                        {static_cast<bool>(windows_.save), !isPane()})) {
    setAttribute(Qt::WA_DeleteOnClose, !isPane());
    setObjectName(QStringLiteral("languageViewer%1").arg(number_));
    editor_->setObjectName("text");
    messages_->setObjectName("messages");
    told_->setObjectName("told");
    editor_->setAccessibleName(tr("Text of the scene"));
    editor_->installEventFilter(this);
    auto* whole = new QWidget;
    auto* column = new QVBoxLayout(whole);
    const int margin = isPane() ? 4 : 8;
    column->setContentsMargins(margin, margin, margin, margin);
    column->setSpacing(margin);
    auto* splitter = new QSplitter(Qt::Vertical);
    splitter->addWidget(editor_);
    splitter->addWidget(messages_);
    splitter->setStretchFactor(0, 1);
    splitter->setCollapsible(0, false);
    splitter->setSizes({420, 90});
    column->addWidget(told_);
    column->addWidget(notice_);
    column->addWidget(splitter, 1);
    column->addWidget(findBar_);
    column->addWidget(row_);
    setCentralWidget(whole);
    buildMenus();
    connectParts();
    faults_->expect(true); // one who opens a faulty text sees where
    showDiagnostics();
    followed();
    updateTitle();
    if (isPane())
        menuBar()->hide();
    else
        editor_->setFocus();
    resize(680, 640);
}

LanguageViewer::~LanguageViewer() {
    // Nobody hears of what goes with the window.
    editor_->forgetTools();
    editor_->disconnect();
    draft_->disconnect();
}

void LanguageViewer::connectParts() {
    connect(row_, &DraftRow::updateWanted, this, &LanguageViewer::updateDocument);
    connect(row_, &DraftRow::saveWanted, this, &LanguageViewer::save);
    connect(row_, &DraftRow::revertWanted, this, &LanguageViewer::askToRevert);
    connect(row_, &DraftRow::dismissWanted, this, &QWidget::close);
    const auto show = [this](scene::Range range) { select(range.from, range.to); };
    connect(faults_.get(), &FaultMarks::wanted, this, show);
    connect(faults_.get(), &FaultMarks::appeared, this, &LanguageViewer::showFault);
    connect(notice_, &NoticeBar::wanted, this, show);
    connect(findBar_, &FindBar::wanted, this, [this](scene::Range range) {
        elision_->reveal(range);
        editor_->select(range);
    });
    // What is selected in a picture is shown, and the caret stays where one writes.
    connect(elements_.get(), &ElementMarks::wanted, this,
            [this](scene::Range range) { editor_->reveal(range); });
    connect(draft_.get(), &Draft::changed, this, [this] {
        if (draft_->edited()) {
            faults_->hideNotes();
            faults_->expect(false);
        }
        updateTitle();
    });
    connect(draft_.get(), &Draft::followed, this, &LanguageViewer::followed);
    connect(&document_, &SceneDocument::diagnosticsChanged, this, &LanguageViewer::showDiagnostics);
    connect(&document_, &SceneDocument::sceneChanged, this, &LanguageViewer::showDiagnostics);
    connect(&document_, &SceneDocument::workChanged, this, [this] {
        if (document_.work() == Work::none)
            faults_->expect(false);
    });
    connect(&document_, &SceneDocument::opened, this, [this] { faults_->expect(true); });
    connect(&document_, &SceneDocument::nameChanged, this, &LanguageViewer::updateTitle);
}

void LanguageViewer::buildMenus() {
    QMenu* file = menuBar()->addMenu(isPane() ? tr("&Draft") : tr("&File"));
    if (!isPane()) {
        file->addAction(tr("New &Graphical Viewer"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_G),
                        this, [this] { windows_.openGraphicalViewer(); });
        file->addAction(tr("New &Language Viewer"), QKeySequence(Qt::CTRL | Qt::Key_L), this,
                        [this] { windows_.openLanguageViewer(); });
        file->addSeparator();
    }
    file->addAction(tr("&Update"), QKeySequence(Qt::CTRL | Qt::Key_Return), this,
                    &LanguageViewer::updateDocument);
    if (windows_.save)
        file->addAction(tr("&Save"), QKeySequence::Save, this, &LanguageViewer::save);
    else // the document's file is written by its own window
        file->actions().back()->setShortcuts(
            {QKeySequence(Qt::CTRL | Qt::Key_Return), QKeySequence::Save});
    file->addAction(tr("&Revert"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_R), this,
                    &LanguageViewer::askToRevert);
    if (!isPane())
        file->addAction(tr("&Dismiss"), QKeySequence(Qt::CTRL | Qt::Key_W), this, &QWidget::close);
    buildEditMenu();
    buildViewMenu();
    if (!isPane())
        addHelpMenu(this, QStringLiteral("The text"));
    else
        for (QAction* action : findChildren<QAction*>())
            leaveKeys(*action);
}

void LanguageViewer::buildEditMenu() {
    QMenu* edit = menuBar()->addMenu(tr("&Edit"));
    connect(editor_, &SceneEditor::menuWanted, edit,
            [edit](const QPoint& global) { edit->popup(global); });
    QAction* undo = edit->addAction(tr("&Undo"), QKeySequence::Undo, this, &LanguageViewer::undo);
    QAction* redo = edit->addAction(tr("&Redo"), QKeySequence::Redo, this, &LanguageViewer::redo);
    connect(edit, &QMenu::aboutToShow, this, [this, undo, redo] {
        name(*undo, typingIsUndone() ? tr("&Undo Typing")
                                     : tr("&Undo %1").arg(plain::caption(document_.undoLabel())));
        name(*redo, draft_->canRedo() ? tr("&Redo Typing")
                                      : tr("&Redo %1").arg(plain::caption(document_.redoLabel())));
        undo->setEnabled(typingIsUndone() || document_.canUndo());
        redo->setEnabled(draft_->canRedo() || (!draft_->edited() && document_.canRedo()));
    });
    connect(edit, &QMenu::aboutToHide, this, [undo, redo] { // their keys work at any time
        undo->setEnabled(true);
        redo->setEnabled(true);
    });
    edit->addSeparator();
    edit->addAction(tr("Cu&t"), QKeySequence::Cut, this, [this] {
        elision_->releaseSelected();
        editor_->cut();
    });
    edit->addAction(tr("&Copy"), QKeySequence::Copy, editor_, &QsciScintilla::copy);
    edit->addAction(tr("&Paste"), QKeySequence::Paste, this, [this] {
        elision_->releaseSelected();
        editor_->paste();
    });
    edit->addAction(tr("Select &All"), QKeySequence::SelectAll, this,
                    [this] { editor_->selectAll(); });
    edit->addSeparator();
    edit->addAction(tr("&Find…"), QKeySequence::Find, this, [this] { findBar_->open(false); });
    edit->addAction(tr("Find and R&eplace…"), QKeySequence(Qt::CTRL | Qt::Key_H), this,
                    [this] { findBar_->open(true); });
    edit->addAction(tr("Find &Next"), QKeySequence(Qt::Key_F3), this,
                    [this] { findBar_->findNext(); });
    edit->addAction(tr("Find Pre&vious"), QKeySequence(Qt::SHIFT | Qt::Key_F3), this,
                    [this] { findBar_->findNext(false); });
    edit->addSeparator();
    edit->addAction(tr("C&omplete"), QKeySequence(Qt::CTRL | Qt::Key_Space), this,
                    [this] { completer_->ask(); });
    QMenu* conflicts = edit->addMenu(tr("Con&flicts"));
    conflicts->addAction(tr("&Next"), QKeySequence(Qt::Key_F7), notice_, &NoticeBar::nextConflict);
    conflicts->addAction(tr("&Keep Mine"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_M), notice_,
                         &NoticeBar::keepMine);
    conflicts->addAction(tr("&Take the Scene's"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_T),
                         notice_, &NoticeBar::takeTheirs);
    edit->addAction(tr("&Drop the Draft"), this, &LanguageViewer::dropDraft);
}

void LanguageViewer::buildViewMenu() {
    QMenu* view = menuBar()->addMenu(tr("&View"));
    view->addAction(tr("Show or Hide the &Points Here"), QKeySequence(Qt::Key_F9), this,
                    [this] { elision_->toggle(editor_->caret()); });
    view->addAction(tr("&Show All Points"), elision_.get(), &Elision::openAll);
    view->addAction(tr("&Hide All Points"), QKeySequence(Qt::SHIFT | Qt::Key_F9), elision_.get(),
                    &Elision::hideAll);
    view->addSeparator();
    view->addAction(tr("&Next Message"), QKeySequence(Qt::Key_F8), this,
                    [this] { faults_->next(); });
    view->addAction(tr("&Previous Message"), QKeySequence(Qt::SHIFT | Qt::Key_F8), this,
                    [this] { faults_->next(false); });
    view->addAction(tr("&Go to Line…"), QKeySequence(Qt::CTRL | Qt::Key_G), this,
                    &LanguageViewer::goToLine);
    view->addSeparator();
    view->addAction(tr("&Larger"), QKeySequence::ZoomIn, editor_, [this] { editor_->zoomIn(); });
    view->addAction(tr("S&maller"), QKeySequence::ZoomOut, editor_, [this] { editor_->zoomOut(); });
    view->addAction(tr("As It &Was"), QKeySequence(Qt::CTRL | Qt::Key_0), editor_,
                    [this] { editor_->zoomTo(0); });
}

// --- the draft and the document --------------------------------------------------------------

std::string LanguageViewer::draft() const { return editor_->bytes(); }

bool LanguageViewer::hasDraft() const { return draft_->edited(); }

const std::string& LanguageViewer::draftBase() const { return draft_->base(); }

void LanguageViewer::restoreDraft(const std::string& base, const std::string& text) {
    draft_->restore(base, text);
}

void LanguageViewer::tell(const QString& sentence) { told_->tell(sentence); }

SceneEditor& LanguageViewer::editor() { return *editor_; }

bool LanguageViewer::updateDocument() {
    numbers_->finish();
    if (!draft_->conflicts().empty()) {
        notice_->insist();
        return false;
    }
    if (draft_->edited())
        row_->expectChanges();
    draft_->submit();
    showDiagnostics();
    faults_->expect(true);
    return true;
}

void LanguageViewer::save() {
    const bool any = draft_->edited() || document_.isModified();
    if (any && updateDocument())
        windows_.save();
}

// Undo brings back the scene's text, but no draft.
void LanguageViewer::askToRevert() {
    if (!draft_->edited() ||
        plain::Message::ask(QMessageBox::Question, this, document_.name(),
                            tr("What was typed here and is not the scene's text yet will be lost, "
                               "and Undo does not bring it back. Revert?"),
                            QMessageBox::Yes | QMessageBox::No,
                            QMessageBox::No) == QMessageBox::Yes)
        revert();
}

void LanguageViewer::revert() {
    if (!document_.hasHost()) {
        draft_->drop();
        document_.setText(document_.savedText(), tr("Revert"));
    }
    dropDraft();
}

void LanguageViewer::dropDraft() {
    draft_->drop();
    showDiagnostics();
}

// While there is a draft, undo takes back what was typed; else the scene's last change.
bool LanguageViewer::typingIsUndone() const { return draft_->canUndo(); }

void LanguageViewer::undo() {
    numbers_->finish();
    if (typingIsUndone())
        draft_->undo();
    else if (!draft_->edited())
        document_.undo();
}

void LanguageViewer::redo() {
    numbers_->finish();
    if (draft_->canRedo())
        draft_->redo();
    else if (!draft_->edited())
        document_.redo();
}

void LanguageViewer::followed() {
    elision_->refresh();
    const int digits = static_cast<int>(QString::number(editor_->lines()).size());
    editor_->setMarginWidth(0, QString(std::max(3, digits) + 1, QLatin1Char('9')));
}

// --- what is shown -----------------------------------------------------------------------------

void LanguageViewer::select(std::size_t from, std::size_t to) {
    elision_->reveal({from, to});
    editor_->select({from, to});
    editor_->setFocus();
}

bool LanguageViewer::find(const QString& what, bool forward) {
    return findBar_->find(what, forward);
}

void LanguageViewer::showDiagnostics() {
    faults_->show(document_.diagnostics(), !draft_->edited());
    row_->refresh();
}

// The caret stays where one writes. Its place is known when all marks and the window's parts are.
void LanguageViewer::showFault(scene::Range range) {
    QTimer::singleShot(0, editor_, [this, range] {
        elision_->reveal(range);
        editor_->reveal(range);
    });
}

void LanguageViewer::updateTitle() {
    const QString viewer =
        number_ == 1 ? tr("Language Viewer") : tr("Language Viewer %1").arg(number_);
    setWindowTitle(tr("%1[*] – %2").arg(plain::title(document_.name()), viewer));
    setWindowModified(draft_->edited() || (!document_.hasHost() && document_.isModified()));
    row_->refresh();
    Q_EMIT draftChanged();
}

void LanguageViewer::goToLine() {
    bool chosen = false;
    const int line = QInputDialog::getInt(
        this, tr("Go to Line"), plain::ours(tr("Line (1 to %1):").arg(editor_->lines())),
        editor_->lineOf(editor_->caret()) + 1, 1, editor_->lines(), 1, &chosen);
    if (!chosen)
        return;
    const auto at = static_cast<std::size_t>(editor_->positionFromLineIndex(line - 1, 0));
    select(at, at);
}

// --- events ------------------------------------------------------------------------------------

bool LanguageViewer::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::KeyPress && findBar_->isVisible() &&
        static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape && !editor_->isListActive()) {
        findBar_->close();
        return true;
    }
    // Scintilla has shortcuts of its own for what the menus do; the menus shall have them.
    if (watched == editor_ && event->type() == QEvent::PaletteChange)
        editor_->adaptToPalette();
    if (watched == editor_ && isPane() && paneKey(*event))
        return true;
    if (watched == editor_ && event->type() == QEvent::ShortcutOverride &&
        (isPane() ? isCommandOf(*window(), static_cast<QKeyEvent&>(*event))
                  : commandOf(static_cast<QKeyEvent&>(*event)) != nullptr)) {
        event->ignore();
        return true;
    }
    return QMainWindow::eventFilter(watched, event);
}

QAction* LanguageViewer::commandOf(const QKeyEvent& event) const {
    const QKeySequence pressed(event.keyCombination());
    for (QAction* action : findChildren<QAction*>())
        if (keysOf(*action).contains(pressed))
            return action;
    return nullptr;
}

// In a pane, a key that both this text and the window have is the text's while it has the keyboard.
bool LanguageViewer::paneKey(QEvent& event) {
    const bool asks = event.type() == QEvent::ShortcutOverride;
    if (!asks && event.type() != QEvent::KeyPress)
        return false;
    QAction* command = commandOf(static_cast<QKeyEvent&>(event));
    if (!command)
        return false;
    event.accept();
    if (!asks)
        command->trigger();
    return true;
}

bool LanguageViewer::event(QEvent* event) {
    return (isPane() && paneKey(*event)) || QMainWindow::event(event);
}

bool LanguageViewer::settleDraft() {
    numbers_->finish();
    if (!draft_->edited())
        return true;
    const bool disputed = !draft_->conflicts().empty();
    plain::Message box(QMessageBox::Question, document_.name(),
                       tr("The draft in this viewer was not made the scene's text."),
                       QMessageBox::NoButton, this);
    if (disputed)
        box.setSecondText(tr("Another view has changed some of the same places."));
    QPushButton* update = box.addButton(disputed ? tr("&Update, Keeping Mine") : tr("&Update"),
                                        QMessageBox::AcceptRole);
    QPushButton* drop = box.addButton(tr("&Drop the Draft"), QMessageBox::DestructiveRole);
    box.addButton(QMessageBox::Cancel);
    box.setDefaultButton(update);
    box.exec();
    if (box.clickedButton() == update) {
        draft_->keepAllMine();
        updateDocument();
    } else if (box.clickedButton() == drop)
        dropDraft();
    else
        return false;
    return true;
}

void LanguageViewer::closeEvent(QCloseEvent* event) {
    event->setAccepted(settleDraft() && (!windows_.mayClose || windows_.mayClose(*this)));
}

} // namespace views
