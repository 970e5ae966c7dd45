#include "window/document_window.h"

#include "filing/printing.h"
#include "filing/saving.h"
#include "menus/figure_menu.h"
#include "menus/format_menu.h"
#include "menus/image_menu.h"
#include "menus/insert_menu.h"
#include "menus/table_menu.h"
#include "navigation/go_menu.h"
#include "navigation/kept_place.h"
#include "panes/faults_pane.h"
#include "panes/file_bar.h"
#include "panes/find_bar.h"
#include "panes/outline_pane.h"
#include "panes/reading_bar.h"
#include "panes/spelling_commands.h"
#include "plain/plain.h"
#include "source/presentation_pane.h"
#include "source/source_pane.h"
#include "text/characters.h"
#include "view/writing.h"
#include "window/application.h"
#include "window/edit_menu.h"
#include "window/file_menu.h"
#include "window/help_menu.h"
#include "window/link.h"
#include "window/medium_commands.h"
#include "window/status_line.h"
#include "window/view_menu.h"

#include <QApplication>
#include <QCloseEvent>
#include <QDesktopServices>
#include <QFileInfo>
#include <QMimeData>
#include <QPointer>
#include <QScreen>
#include <QStatusBar>
#include <QToolButton>
#include <QVBoxLayout>

namespace window {

namespace {

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
      view_(new view::DocumentView(*document_)), find_(new panes::FindBar(*view_, this)),
      faults_(new panes::FaultsPane(*document_, this)),
      outline_(new panes::OutlinePane(*view_, this)), source_(new source::SourcePane(*view_, this)),
      presentation_(new source::PresentationPane(*view_, this)),
      tools_(new QToolBar(tr("Tools"), this)), saving_(new filing::Saving(*document_, *this)),
      printing_(new filing::Printing(*document_, *this)),
      status_(new StatusLine(*view_, *statusBar(), this)) {
    setAttribute(Qt::WA_DeleteOnClose);
    setObjectName("documentWindow");
    banner_->setObjectName("banner");
    view_->setObjectName("pages");
    setAcceptDrops(true);
    auto* middle = new QWidget(this);
    auto* column = new QVBoxLayout(middle);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(banner_);
    column->addWidget(new panes::FileBar(document_->followFile(), this));
    column->addWidget(view_, 1);
    column->addWidget(find_);
    setCentralWidget(middle);
    addDockWidget(Qt::BottomDockWidgetArea, faults_);
    constexpr int faultsHeight = 130;
    resizeDocks({faults_}, {faultsHeight}, Qt::Vertical);
    faults_->hide();
    addDockWidget(Qt::LeftDockWidgetArea, outline_);
    outline_->hide();
    source_->placeIn(*this);
    new navigation::KeptPlace(*view_, this);
    auto* edit = new EditMenu(*view_, *find_, this);
    auto* table = new menus::TableMenu(*view_, this);
    auto* image = new menus::ImageMenu(*view_, this);
    auto* insert = new menus::InsertMenu(*view_, *table, *image, this);
    edit->offerAtPointer(*image, [image] { return image->isOnImage(); });
    edit->offerAtPointer(*table, [table] { return table->isInTable(); });
    column->addWidget(new panes::ReadingBar(*view_, edit->write(), this));
    buildTools(edit->write());
    auto* figure = new menus::FigureMenu(*view_, this);
    auto* spelling = new panes::SpellingCommands(*view_, this);
    connect(edit, &EditMenu::aboutToShowAt, spelling, &panes::SpellingCommands::addTo);
    connect(edit, &EditMenu::aboutToShowAt, insert, &menus::InsertMenu::addTo);
    connect(spelling, &panes::SpellingCommands::languageChanged, status_,
            &StatusLine::showLanguage);
    connect(spelling, &panes::SpellingCommands::said, this, &DocumentWindow::say);
    auto* look = new ViewMenu(application, *this,
                              {&spelling->toggle(), outline_->toggleViewAction(),
                               source_->toggleViewAction(), tools_->toggleViewAction(),
                               faults_->toggleViewAction()});
    connectPresentation(*look);
    for (QMenu* menu :
         {static_cast<QMenu*>(new FileMenu(application, *this)), static_cast<QMenu*>(edit),
          static_cast<QMenu*>(look), static_cast<QMenu*>(new navigation::GoMenu(*view_, this)),
          static_cast<QMenu*>(insert), static_cast<QMenu*>(new menus::FormatMenu(*view_, this)),
          static_cast<QMenu*>(table), static_cast<QMenu*>(figure), makeHelpMenu(*document_, this)})
        menuBar()->addMenu(menu);
    commands_ =
        new MediumCommands(*document_, *view_, *menuBar(), menuBar()->actions().last(), *tools_);
    commands_->setParent(this);

    document::Document* of = &document_->document();
    connect(of, &document::Document::modifiedChanged, this, &DocumentWindow::updateTitle);
    connect(of, &document::Document::fileNameChanged, this, &DocumentWindow::updateTitle);
    connect(view_, &view::DocumentView::laidOut, this, &DocumentWindow::updateTitle);
    connect(document_.get(), &session::OpenDocument::message, this, &DocumentWindow::say);
    connect(document_.get(), &session::OpenDocument::figureSaid, status_, &StatusLine::sayOf);
    connect(saving_, &filing::Saving::said, this, &DocumentWindow::say);
    connect(saving_, &filing::Saving::savedAs, this,
            [this](const QString& file) { application_.remember(file); });
    connect(saving_, &filing::Saving::mayCloseNow, this, &DocumentWindow::close);
    connect(printing_, &filing::Printing::said, this, &DocumentWindow::say);
    connect(find_, &panes::FindBar::replaced, this, &DocumentWindow::say);
    connect(faults_, &panes::FaultsPane::countChanged, this, &DocumentWindow::updateFaults);
    connect(faults_, &panes::FaultsPane::activated, this, &DocumentWindow::goTo);
    connect(source_, &source::SourcePane::said, this, &DocumentWindow::say);
    connect(source_, &QDockWidget::visibilityChanged, this, &DocumentWindow::updateBanner);
    connect(view_, &view::DocumentView::linkActivated, this, &DocumentWindow::openLink);
    connect(view_, &view::DocumentView::contextMenuWanted, this,
            [this, figure](document::SubdocumentId id, const QPoint& at) {
                const auto show = [window = QPointer(this), this, figure, id, at] {
                    if (!window)
                        return;
                    commands_->refresh();
                    figure->showAt(at, commands_->menuOf(id));
                };
                media::LiveSubdocument* live = document_->live(id);
                live ? live->whenHeard(show) : show();
            });
    connect(view_, &view::DocumentView::textMenuWanted, edit, &EditMenu::showAt);
    connect(&view_->writing(), &view::Writing::refused, this, &DocumentWindow::say);
    connect(view_, &view::DocumentView::unhandledKey, this, &DocumentWindow::useShortcut);
    updateTitle();
    view_->setFocus();
    const QSize screen = this->screen()->availableSize();
    resize(std::min(960, screen.width() - 20), std::min(1000, screen.height() - 40));
}

DocumentWindow::~DocumentWindow() {
    // Its commands look at the view and the document, which go first otherwise.
    delete commands_;
    delete find_;
    delete faults_;
    delete outline_;
    delete source_;
    delete presentation_;
    delete view_;
}

bool DocumentWindow::save() { return saving_->save(); }
bool DocumentWindow::saveAs() { return saving_->saveAs(); }

void DocumentWindow::say(const QString& sentence) { status_->say(sentence); }

void DocumentWindow::buildTools(QAction& write) {
    tools_->setObjectName("tools");
    tools_->setMovable(false);
    tools_->setIconSize({18, 18});
    tools_->addAction(&write);
    // Newcomers do not know the pencil.
    if (auto* button = qobject_cast<QToolButton*>(tools_->widgetForAction(&write)))
        button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    tools_->addSeparator();
    constexpr int leastHeight = 40; // it stays when there is nothing in it
    tools_->setMinimumHeight(leastHeight);
    tools_->toggleViewAction()->setText(tr("&Tool Area"));
    addToolBar(tools_);
}

void DocumentWindow::connectPresentation(ViewMenu& menu) {
    connect(&menu, &ViewMenu::editPresentationWanted, this, [this] {
        presentation_->open(
            document_->schemas().fileOf(document_->document().className(), view_->presentation()));
    });
    connect(&menu, &ViewMenu::suppliedPresentationWanted, presentation_,
            &source::PresentationPane::bringSupplied);
    connect(presentation_, &source::PresentationPane::edited, this,
            [this](const QString& name, const QString& path, const std::string& text) {
                application_.setPresentation(name, path, text);
            });
    connect(presentation_, &source::PresentationPane::said, this, &DocumentWindow::say);
}

// A document opens nothing by itself; the reader did, and sees where it leads.
void DocumentWindow::openLink(const QString& target) {
    const std::optional<Link> link = linkTo(target);
    if (!link)
        say(tr("This link leads to no page of the web"));
    else if (plain::Message::ask(QMessageBox::Question, this, tr("Open a link"),
                                 tr("Open %1?").arg(link->place),
                                 QMessageBox::Yes | QMessageBox::No) == QMessageBox::Yes)
        QDesktopServices::openUrl(link->url);
}

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
    source_->setFaults(faults_->faults());
    updateBanner();
}

// A text that is not on the disk as it is here is no damaged file.
QString DocumentWindow::damage() const {
    const document::Document& of = document_->document();
    if (of.isModified() || of.fileName().isEmpty())
        return tr("A part of this text cannot be read. It is shown as far as it can; the list of "
                  "faults says where, and Undo takes back what was done.");
    if (looksLikeADocument(of.bytes()))
        return tr("This file is damaged. It is shown as far as it can be read, and is not "
                  "overwritten without your consent.");
    return tr("This file is no document: documents begin with the word DOCUMENT. It may be one for "
              "another program, and is not overwritten without your consent.");
}

void DocumentWindow::updateBanner() {
    // Text that is being typed in the source is not a damaged file, and nothing moves for it.
    const bool broken =
        document_->document().isBroken() && (!banner_->isHidden() || source_->isHidden());
    if (broken && banner_->isHidden())
        faults_->show();
    banner_->setText(damage());
    banner_->setVisible(broken);
}

void DocumentWindow::goTo(const session::ListedFault& fault) {
    view_->scrollTo(fault.subdocument);
    if (fault.file.isEmpty() && fault.position.line > 0)
        source_->goTo(fault.position);
}

// A key that neither a chosen rendition nor the view uses may still be a shortcut of a menu. Who
// types while a figure has the keys learns why no letter comes.
void DocumentWindow::useShortcut(int key, Qt::KeyboardModifiers modifiers) {
    if (key == 0)
        return;
    const QKeySequence keys(QKeyCombination(modifiers, static_cast<Qt::Key>(key)));
    for (QAction* action : findChildren<QAction*>())
        if (action->isEnabled() && action->shortcuts().contains(keys)) {
            action->trigger();
            return;
        }
    constexpr int firstOfOthers = Qt::Key_Escape; // behind all letters
    constexpr auto commands = Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier;
    if (view_->chosen() && view_->isWriting() && key < firstOfOthers && !(modifiers & commands))
        say(tr("The figure has the keyboard. Press Escape to write behind it, or click in the "
               "text."));
}

// Changes that a watched folder does not tell, as on a network, are seen when the reader comes
// back.
void DocumentWindow::changeEvent(QEvent* event) {
    QMainWindow::changeEvent(event);
    if (event->type() == QEvent::ActivationChange && isActiveWindow())
        document_->followFile().look();
}

void DocumentWindow::closeEvent(QCloseEvent* event) {
    const bool isLast = application_.windowsOf(*document_).size() <= 1;
    event->setAccepted(presentation_->mayClose() &&
                       (!isLast || saving_->mayClose(documentTitle())));
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

} // namespace window
