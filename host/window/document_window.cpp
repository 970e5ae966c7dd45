#include "window/document_window.h"
#include "window/file_bar.h"

#include "paper/paper.h"
#include "plain/plain.h"
#include "text/characters.h"
#include "view/icons.h"
#include "view/writing.h"
#include "window/application.h"
#include "window/faults_pane.h"
#include "window/find_bar.h"
#include "window/format_menu.h"
#include "window/link.h"
#include "window/manual.h"
#include "window/medium_commands.h"

#include <QApplication>
#include <QClipboard>
#include <QCloseEvent>
#include <QDesktopServices>
#include <QFileDialog>
#include <QFileInfo>
#include <QMimeData>
#include <QPrintDialog>
#include <QPrinter>
#include <QProgressDialog>
#include <QPushButton>
#include <QSaveFile>
#include <QScreen>
#include <QScrollBar>
#include <QStatusBar>
#include <QTimer>
#include <QVBoxLayout>

namespace window {

namespace {

constexpr double paperDpi = 300;

QString filter() { return DocumentWindow::tr("Documents (*.ens);;All files (*)"); }

// Where to write; "": nowhere. The ending is put behind a name that has none before it is asked
// whether a file is to be replaced.
QString askForFile(QWidget* parent, const QString& title, const QString& proposed,
                   const QString& filters, const QString& ending) {
    const QFileInfo file(proposed);
    QFileDialog dialog(parent, title, file.absolutePath(), filters);
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix(ending);
    dialog.selectFile(file.fileName());
    return dialog.exec() == QDialog::Accepted ? dialog.selectedFiles().value(0) : QString();
}

QLabel* makeBanner(QWidget* parent) {
    auto* banner = plain::label({}, parent);
    banner->setWordWrap(true);
    banner->setMargin(8);
    banner->setStyleSheet("background:#fdf3d7;color:#5c4813;border-bottom:1px solid #ecdcae");
    banner->hide();
    return banner;
}

} // namespace

DocumentWindow::DocumentWindow(Application& application,
                               std::shared_ptr<session::OpenDocument> document)
    : application_(application), document_(std::move(document)), banner_(makeBanner(this)),
      view_(new view::DocumentView(*document_)), find_(new FindBar(*view_, this)),
      faults_(new FaultsPane(*document_, this)), tools_(new QToolBar(tr("Tools"), this)),
      pageLabel_(plain::label({}, this)), zoomLabel_(plain::label({}, this)) {
    setAttribute(Qt::WA_DeleteOnClose);
    setObjectName("documentWindow");
    banner_->setObjectName("banner");
    view_->setObjectName("pages");
    pageLabel_->setObjectName("page");
    zoomLabel_->setObjectName("zoom");
    setAcceptDrops(true);
    auto* middle = new QWidget(this);
    auto* column = new QVBoxLayout(middle);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(banner_);
    column->addWidget(new FileBar(document_->followFile(), this));
    column->addWidget(view_, 1);
    column->addWidget(find_);
    setCentralWidget(middle);
    addDockWidget(Qt::BottomDockWidgetArea, faults_);
    constexpr int faultsHeight = 130;
    resizeDocks({faults_}, {faultsHeight}, Qt::Vertical);
    faults_->hide();
    buildFileMenu();
    buildEditMenu();
    buildViewMenu();
    menuBar()->addAction((new FormatMenu(*view_, this))->menuAction());
    buildHelpMenu();
    buildTools();
    commands_ =
        new MediumCommands(*document_, *view_, *menuBar(), menuBar()->actions().last(), *tools_);
    commands_->setParent(this);
    statusBar()->addPermanentWidget(pageLabel_);
    statusBar()->addPermanentWidget(zoomLabel_);
    statusBar()->setSizeGripEnabled(false);

    document::Document* of = &document_->document();
    connect(of, &document::Document::modifiedChanged, this, &DocumentWindow::updateTitle);
    connect(of, &document::Document::fileNameChanged, this, &DocumentWindow::updateTitle);
    connect(view_, &view::DocumentView::laidOut, this, &DocumentWindow::updateTitle);
    connect(of, &document::Document::undoChanged, this, &DocumentWindow::updateUndo);
    connect(document_.get(), &session::OpenDocument::message, this,
            [this](const QString& text) { statusBar()->showMessage(text, 8000); });
    connect(faults_, &FaultsPane::countChanged, this, &DocumentWindow::updateFaults);
    connect(faults_, &FaultsPane::activated, view_, &view::DocumentView::scrollTo);
    connect(view_, &view::DocumentView::linkActivated, this, &DocumentWindow::openLink);
    connect(view_, &view::DocumentView::contextMenuWanted, this,
            [this](document::SubdocumentId id, const QPoint& at) {
                commands_->refresh();
                if (QMenu* menu = commands_->menuOf(id))
                    menu->popup(at);
            });
    connect(view_, &view::DocumentView::textMenuWanted, this, &DocumentWindow::showTextMenu);
    connect(view_, &view::DocumentView::selectionChanged, this, &DocumentWindow::updateSelection);
    connect(view_, &view::DocumentView::writingChanged, this, &DocumentWindow::updateSelection);
    connect(&view_->writing(), &view::Writing::refused, this,
            [this](const QString& why) { statusBar()->showMessage(why, 8000); });
    connect(view_, &view::DocumentView::unhandledKey, this, &DocumentWindow::useShortcut);
    const auto showPlace = [this] {
        zoomLabel_->setText(tr("%1 %").arg(qRound(view_->zoom() * 100)));
        const auto pages = static_cast<int>(view_->pages().pages.size());
        const QScrollBar* bar = view_->verticalScrollBar();
        const double part = bar->maximum() > 0 ? double(bar->value()) / bar->maximum() : 0;
        pageLabel_->setText(tr("Page %1 of %2").arg(qRound(part * (pages - 1)) + 1).arg(pages));
    };
    connect(view_, &view::DocumentView::zoomChanged, this, showPlace);
    connect(view_, &view::DocumentView::laidOut, this, showPlace);
    connect(view_->verticalScrollBar(), &QScrollBar::valueChanged, this, showPlace);
    showPlace();
    updateTitle();
    updateUndo();
    updateSelection();
    view_->setFocus();
    const QSize screen = this->screen()->availableSize();
    resize(std::min(960, screen.width() - 20), std::min(1000, screen.height() - 40));
}

DocumentWindow::~DocumentWindow() {
    // Its commands look at the view and the document, which go first otherwise.
    delete commands_;
    delete find_;
    delete faults_;
    delete view_;
}

// A document opens nothing by itself; the reader did, and sees where it leads.
void DocumentWindow::openLink(const QString& target) {
    const std::optional<Link> link = linkTo(target);
    if (!link)
        statusBar()->showMessage(tr("This link leads to no page of the web"), 8000);
    else if (plain::Message::ask(QMessageBox::Question, this, tr("Open a link"),
                                 tr("Open %1?").arg(link->place),
                                 QMessageBox::Yes | QMessageBox::No) == QMessageBox::Yes)
        QDesktopServices::openUrl(link->url);
}

// --- menus -------------------------------------------------------------------------------------

QAction* DocumentWindow::add(QMenu* menu, const QString& text, const QKeySequence& keys,
                             const std::function<void()>& done, const QString& icon) {
    QAction* action = menu->addAction(plain::ours(text), this, done);
    action->setShortcut(keys);
    if (!icon.isEmpty())
        action->setIcon(view::iconNamed(icon));
    action->setIconVisibleInMenu(false);
    return action;
}

void DocumentWindow::buildFileMenu() {
    QMenu* menu = menuBar()->addMenu(tr("&File"));
    QMenu* fresh = menu->addMenu(tr("&New"));
    add(fresh, tr("&Memo"), QKeySequence::New, [this] {
        application_.openNew("CMEMO");
    })->setObjectName("newMemo");
    add(fresh, tr("&Report"), {}, [this] {
        application_.openNew("REPORT");
    })->setObjectName("newReport");
    add(menu, tr("&Open..."), QKeySequence::Open, [this] {
        const QStringList files = QFileDialog::getOpenFileNames(this, tr("Open"), {}, filter());
        for (const QString& file : files)
            application_.open(file, this);
    });
    recent_ = menu->addMenu(tr("Open &Recent"));
    connect(recent_, &QMenu::aboutToShow, this, &DocumentWindow::fillRecent);
    menu->addSeparator();
    save_ = add(menu, tr("&Save"), QKeySequence::Save, [this] { save(); });
    add(menu, tr("Save &As..."), QKeySequence("Ctrl+Shift+S"), [this] { saveAs(); });
    menu->addSeparator();
    add(menu, tr("Export P&DF..."), QKeySequence("Ctrl+Shift+E"), [this] { exportPdf(); });
    add(menu, tr("&Print..."), QKeySequence::Print, [this] { print(); });
    menu->addSeparator();
    add(menu, tr("&Close"), QKeySequence::Close, [this] { close(); });
    add(menu, tr("&Quit"), QKeySequence("Ctrl+Q"), [this] { application_.quit(); });
}

void DocumentWindow::fillRecent() {
    recent_->clear();
    for (const QString& file : application_.recentFiles())
        recent_
            ->addAction(plain::caption(QFileInfo(file).fileName()), this,
                        [this, file] { application_.open(file, this); })
            ->setToolTip(plain::tip(file));
    if (recent_->isEmpty())
        recent_->addAction(tr("Nothing yet"))->setEnabled(false);
}

void DocumentWindow::buildEditMenu() {
    QMenu* menu = menuBar()->addMenu(tr("&Edit"));
    undo_ = add(menu, tr("&Undo"), QKeySequence::Undo, [this] { document_->document().undo(); });
    redo_ = add(menu, tr("&Redo"), QKeySequence("Ctrl+Shift+Z"),
                [this] { document_->document().redo(); });
    menu->addSeparator();
    cut_ = add(menu, tr("Cu&t"), QKeySequence::Cut, [this] { view_->writing().cut(); });
    cut_->setObjectName("cut");
    copy_ = add(menu, tr("&Copy"), QKeySequence::Copy, [this] { view_->copy(); });
    copy_->setObjectName("copy");
    paste_ = add(menu, tr("&Paste"), QKeySequence::Paste,
                 [this] { view_->writing().paste(*QApplication::clipboard()->mimeData()); });
    paste_->setObjectName("paste");
    selectAll_ =
        add(menu, tr("Select &All"), QKeySequence::SelectAll, [this] { view_->selectAll(); });
    selectAll_->setObjectName("selectAll");
    menu->addSeparator();
    write_ = add(
        menu, tr("&Write"), QKeySequence("Ctrl+E"),
        [this] { view_->setWriting(write_->isChecked()); }, "document-edit");
    write_->setObjectName("write");
    write_->setCheckable(true);
    write_->setToolTip(tr("Write in the document (Ctrl+E)"));
    menu->addSeparator();
    add(menu, tr("&Find..."), QKeySequence::Find, [this] { find_->open(); });
    add(menu, tr("Find &Next"), QKeySequence(Qt::Key_F3), [this] { find_->next(1); });
    add(menu, tr("Find &Previous"), QKeySequence(Qt::SHIFT | Qt::Key_F3),
        [this] { find_->next(-1); });
}

void DocumentWindow::buildViewMenu() {
    QMenu* menu = menuBar()->addMenu(tr("&View"));
    add(menu, tr("&New Window"), QKeySequence("Ctrl+Shift+N"),
        [this] { application_.addWindow(document_); });
    presentations_ = menu->addMenu(tr("&Presentation"));
    connect(presentations_, &QMenu::aboutToShow, this, &DocumentWindow::fillPresentations);
    menu->addSeparator();
    add(
        menu, tr("Zoom &In"), QKeySequence("Ctrl++"), [this] { view_->zoomBy(1); }, "zoom-in")
        ->setShortcuts({QKeySequence("Ctrl++"), QKeySequence("Ctrl+=")});
    add(
        menu, tr("Zoom &Out"), QKeySequence("Ctrl+-"), [this] { view_->zoomBy(-1); }, "zoom-out");
    add(menu, tr("Fit &Width"), QKeySequence("Ctrl+9"),
        [this] { view_->setZoom(view_->widthZoom()); });
    add(menu, tr("&Actual Size"), QKeySequence("Ctrl+0"), [this] { view_->setZoom(1); });
    menu->addSeparator();
    menu->addAction(tools_->toggleViewAction());
    menu->addAction(faults_->toggleViewAction());
    add(menu, tr("&Full Screen"), QKeySequence("F11"),
        [this] { setWindowState(windowState() ^ Qt::WindowFullScreen); });
}

void DocumentWindow::fillPresentations() {
    presentations_->clear();
    auto* group = new QActionGroup(presentations_);
    const QStringList names = document_->schemas().presentations(document_->document().className());
    for (const QString& name : names) {
        QAction* action =
            presentations_->addAction(plain::caption(name.left(1).toUpper() + name.mid(1)), this,
                                      [this, name] { view_->setPresentation(name); });
        action->setCheckable(true);
        action->setChecked(name == view_->presentation() ||
                           (view_->presentation().isEmpty() && name == names.first()));
        group->addAction(action);
    }
}

void DocumentWindow::buildHelpMenu() {
    QMenu* menu = menuBar()->addMenu(tr("&Help"));
    add(menu, tr("&Keys and Buttons"), QKeySequence(Qt::Key_F1), [this] { showManual(this); });
    add(menu, tr("&About Ensemble"), {}, [this] {
        QStringList installed;
        for (const media::Manifest& manifest : document_->media().registry().media())
            installed << tr("%1 for %2").arg(manifest.name, manifest.documentClass);
        installed << document_->media().registry().faults();
        plain::Message::tell(QMessageBox::NoIcon, this, tr("About Ensemble"),
                             tr("Ensemble %1 shows compound documents.\n\nInstalled media:\n%2")
                                 .arg(QCoreApplication::applicationVersion(),
                                      installed.isEmpty() ? tr("none") : installed.join('\n')));
    });
}

void DocumentWindow::buildTools() {
    tools_->setObjectName("tools");
    tools_->setMovable(false);
    tools_->setIconSize({18, 18});
    tools_->addAction(write_);
    tools_->addSeparator();
    constexpr int leastHeight = 40; // it stays when there is nothing in it
    tools_->setMinimumHeight(leastHeight);
    tools_->toggleViewAction()->setText(tr("&Tool Area"));
    addToolBar(tools_);
}

// --- what changes ------------------------------------------------------------------------------

namespace {

// One line without what is not seen, of a length that a task list can show.
QString lineOf(const QString& text) {
    constexpr qsizetype longest = 120;
    QString line;
    for (const QChar c : text.simplified())
        if (c.isPrint() && line.size() < longest)
            line += c;
    return line;
}

} // namespace

// Its own, as the presentation says which element that is, else its file's name.
QString DocumentWindow::documentTitle() const {
    const QString title = lineOf(view_->title());
    const QString file = lineOf(QFileInfo(document_->document().fileName()).fileName());
    if (title.isEmpty())
        return file.isEmpty() ? tr("Untitled") : file;
    // Two documents may have one title.
    return file.isEmpty() ? title : tr("%1 (%2)").arg(title, file);
}

void DocumentWindow::updateTitle() {
    const document::Document& of = document_->document();
    setWindowTitle(plain::title(documentTitle()) + "[*] - Ensemble");
    setWindowModified(of.isModified());
    setWindowFilePath(of.fileName());
}

void DocumentWindow::updateUndo() {
    const document::Document& of = document_->document();
    undo_->setEnabled(of.canUndo());
    redo_->setEnabled(of.canRedo());
    undo_->setText(of.canUndo() ? tr("&Undo %1").arg(plain::caption(of.undoLabel())) : tr("&Undo"));
    redo_->setText(of.canRedo() ? tr("&Redo %1").arg(plain::caption(of.redoLabel())) : tr("&Redo"));
}

// While a figure has the keys, these are its own.
void DocumentWindow::updateSelection() {
    const bool writes = view_->isWriting() && !view_->chosen();
    write_->setChecked(view_->isWriting());
    cut_->setEnabled(writes && view_->canCopy());
    paste_->setEnabled(writes);
    copy_->setEnabled(view_->canCopy());
    selectAll_->setEnabled(!view_->chosen());
}

void DocumentWindow::showTextMenu(const QPoint& at) {
    auto* menu = new QMenu(this);
    menu->setObjectName("textMenu");
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->addActions(view_->isWriting() ? QList<QAction*>{cut_, copy_, paste_, selectAll_}
                                        : QList<QAction*>{copy_, selectAll_});
    menu->popup(at);
}

namespace {

// A document without its first line begins with an element.
bool looksLikeADocument(std::string_view bytes) {
    if (bytes.starts_with(text::byteOrderMark))
        bytes.remove_prefix(text::byteOrderMark.size());
    const auto first = bytes.find_first_not_of(" \t\r\n");
    return first == bytes.npos || bytes[first] == '<' ||
           bytes.substr(first).starts_with("DOCUMENT");
}

} // namespace

void DocumentWindow::updateFaults(int errors, int warnings) {
    const auto counted = [](int count, const QString& one, const QString& many) {
        return QStringLiteral("%1 %2").arg(count).arg(count == 1 ? one : many);
    };
    faults_->setWindowTitle(
        plain::ours(tr("Faults: %1, %2")
                        .arg(counted(errors, tr("error"), tr("errors")),
                             counted(warnings, tr("warning"), tr("warnings")))));
    const bool broken = document_->document().isBroken();
    if (broken && banner_->isHidden())
        faults_->show();
    banner_->setText(looksLikeADocument(document_->document().bytes())
                         ? tr("This file is damaged. It is shown as far as it can be read, and is "
                              "not overwritten without your consent.")
                         : tr("This file is no document: documents begin with the word DOCUMENT. "
                              "It may be one for another program, and is not overwritten without "
                              "your consent."));
    banner_->setVisible(broken);
}

// A key that neither a chosen rendition nor the view uses may still be a shortcut of a menu.
void DocumentWindow::useShortcut(int key, Qt::KeyboardModifiers modifiers) {
    if (key == 0)
        return;
    const QKeySequence keys(QKeyCombination(modifiers, static_cast<Qt::Key>(key)));
    for (QAction* action : findChildren<QAction*>())
        if (action->isEnabled() && action->shortcuts().contains(keys)) {
            action->trigger();
            return;
        }
}

// --- files -------------------------------------------------------------------------------------

// What is refused for a reason is done all the same when the user says so.
bool DocumentWindow::saveBy(const std::function<files::SaveResult(files::SaveOptions)>& saving) {
    files::SaveOptions options;
    for (;;) {
        const files::SaveResult result = saving(options);
        const QString sentence = QString::fromStdString(result.sentence);
        if (result.saved) {
            statusBar()->showMessage(tr("Saved"), 4000);
            return true;
        }
        if (result.refusal == files::Refusal::none) {
            plain::Message::tell(QMessageBox::Critical, this, tr("Save"), sentence);
            return false;
        }
        const auto answer = plain::Message::ask(
            QMessageBox::Warning, this, tr("Save"), tr("%1\n\nSave it all the same?").arg(sentence),
            QMessageBox::Yes | QMessageBox::No, QMessageBox::No);
        if (answer != QMessageBox::Yes)
            return false;
        options.evenBroken |= result.refusal == files::Refusal::broken;
        options.evenChanged |= result.refusal == files::Refusal::changed;
        options.evenLinked |= result.refusal == files::Refusal::linked;
    }
}

bool DocumentWindow::save() {
    switch (askAboutDrafts(tr("Save"), tr("&Update and Save"), tr("Save &Without It"))) {
    case Drafts::stay:
        return false;
    case Drafts::update:
        updateDrafts([this] { saveNow(); });
        return false;
    case Drafts::none:
    case Drafts::leave:
        break;
    }
    return saveNow();
}

bool DocumentWindow::saveNow() {
    document::Document& of = document_->document();
    if (of.fileName().isEmpty())
        return saveAs();
    return saveBy([&of](files::SaveOptions options) { return of.save(options); });
}

bool DocumentWindow::saveAs() {
    document::Document& of = document_->document();
    const QString file =
        askForFile(this, tr("Save As"), of.fileName(), filter(), QStringLiteral("ens"));
    if (file.isEmpty())
        return false;
    const bool saved =
        saveBy([&of, file](files::SaveOptions options) { return of.saveAs(file, options); });
    if (saved)
        application_.remember(file);
    return saved;
}

bool DocumentWindow::isLastOfDocument() const {
    return application_.windowsOf(*document_).size() <= 1;
}

// What was typed in a window of a medium and is no change of the document yet goes with its
// process.
DocumentWindow::Drafts DocumentWindow::askAboutDrafts(const QString& title, const QString& update,
                                                      const QString& leave) {
    const QStringList where = document_->drafts();
    if (where.isEmpty())
        return Drafts::none;
    plain::Message box(QMessageBox::Warning, title,
                       tr("Text that you typed in a window of %1 is not yet in the document.")
                           .arg(where.join(tr(" and "))),
                       QMessageBox::Cancel, this);
    if (document_->takesDrafts())
        box.addButton(QMessageBox::Apply)->setText(plain::ours(update));
    box.addButton(QMessageBox::Discard)->setText(plain::ours(leave));
    box.setDefaultButton(QMessageBox::Cancel);
    switch (box.exec()) {
    case QMessageBox::Apply:
        return Drafts::update;
    case QMessageBox::Discard:
        return Drafts::leave;
    default:
        return Drafts::stay;
    }
}

void DocumentWindow::updateDrafts(std::function<void()> then) {
    constexpr int longestMs = 10'000;
    auto* waiting = new QTimer(this); // and what it waits for, which goes with it
    waiting->setSingleShot(true);
    const auto look = [this, waiting, then = std::move(then)] {
        if (!document_->drafts().isEmpty())
            return;
        waiting->stop();
        waiting->deleteLater();
        // Not in the medium's own call.
        QTimer::singleShot(0, this, then);
    };
    connect(document_.get(), &session::OpenDocument::draftsChanged, waiting, look);
    connect(waiting, &QTimer::timeout, this, [this, waiting] {
        waiting->deleteLater();
        plain::Message::tell(QMessageBox::Warning, this, tr("Update"),
                             tr("%1 did not take the typed text. It is still in its window.")
                                 .arg(document_->drafts().join(tr(" and "))));
    });
    waiting->start(longestMs);
    document_->takeDrafts();
}

// What a watched folder does not tell, as on a network, is seen when the reader comes back.
void DocumentWindow::changeEvent(QEvent* event) {
    QMainWindow::changeEvent(event);
    if (event->type() == QEvent::ActivationChange && isActiveWindow())
        document_->followFile().look();
}

void DocumentWindow::closeEvent(QCloseEvent* event) {
    const Drafts drafts = isLastOfDocument()
                              ? askAboutDrafts(tr("Close"), tr("&Update"), tr("Close &Without It"))
                              : Drafts::none;
    if (drafts == Drafts::update)
        updateDrafts([this] { close(); });
    if (drafts == Drafts::update || drafts == Drafts::stay) {
        event->ignore();
        return;
    }
    if (document_->document().isModified() && isLastOfDocument()) {
        const auto answer = plain::Message::ask(
            QMessageBox::Question, this, tr("Close"),
            tr("The document has changes that are not saved."),
            QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, QMessageBox::Save);
        if (answer == QMessageBox::Cancel || (answer == QMessageBox::Save && !saveNow())) {
            event->ignore();
            return;
        }
    }
    if (isLastOfDocument() && document_->unsaved())
        document_->unsaved()->giveUp();
    event->accept();
}

void DocumentWindow::dragEnterEvent(QDragEnterEvent* event) {
    if (event->mimeData()->hasUrls())
        event->acceptProposedAction();
}

void DocumentWindow::dropEvent(QDropEvent* event) {
    for (const QUrl& url : event->mimeData()->urls())
        if (url.isLocalFile())
            application_.open(url.toLocalFile(), this);
}

// --- paper -------------------------------------------------------------------------------------

void DocumentWindow::exportPdf() {
    const QFileInfo own(document_->document().fileName());
    const QString file =
        askForFile(this, tr("Export PDF"), own.dir().filePath(own.completeBaseName() + ".pdf"),
                   tr("PDF (*.pdf)"), QStringLiteral("pdf"));
    if (!file.isEmpty())
        exportPdfTo(file);
}

void DocumentWindow::exportPdfTo(const QString& fileName) {
    auto* paper = new paper::Paper(*document_, view_->presentation(), paperDpi, false, this);
    statusBar()->showMessage(tr("Taking the pictures for %1").arg(QFileInfo(fileName).fileName()));
    connect(paper, &paper::Paper::ready, this, [this, paper, fileName] {
        paper->deleteLater();
        QSaveFile file(fileName);
        QString failed =
            file.open(QIODevice::WriteOnly) ? paper->writePdf(file) : file.errorString();
        if (failed.isEmpty() && !file.commit())
            failed = file.errorString();
        if (failed.isEmpty())
            statusBar()->showMessage(tr("Wrote %1").arg(fileName), 8000);
        else
            plain::Message::tell(QMessageBox::Critical, this, tr("Export PDF"), failed);
    });
    paper->prepare();
}

void DocumentWindow::print() {
    auto printer = std::make_shared<QPrinter>(QPrinter::HighResolution);
    printer->setFullPage(true);
    printer->setDocName(documentTitle());
    QPrintDialog dialog(printer.get(), this);
    if (dialog.exec() != QDialog::Accepted)
        return;
    auto* paper = new paper::Paper(*document_, view_->presentation(), paperDpi, false, this);
    statusBar()->showMessage(tr("Taking the pictures to print"));
    connect(paper, &paper::Paper::ready, this, [this, paper, printer] {
        paper->deleteLater();
        paper->print(*printer);
        statusBar()->showMessage(tr("Printed"), 4000);
    });
    paper->prepare();
}

} // namespace window
