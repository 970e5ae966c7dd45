#include "window/application.h"

#include "accessibility/accessible_view.h"
#include "controls/indicators.h"
#include "dialogs/recovery.h"
#include "filing/choosing.h"
#include "model/model.h"
#include "plain/plain.h"
#include "terminal/terminal.h"

#include <QApplication>
#include <QFile>
#include <QFileInfo>
#include <QMessageBox>
#include <QPalette>
#include <QSettings>
#include <QStyle>

#include <set>

namespace window {

namespace {

constexpr int mostRecent = 10;

// Says it and goes on: nothing waits until it is read.
void tell(QWidget* over, const QString& sentence) {
    auto* box = new plain::Message(QMessageBox::Warning, Application::tr("Unsaved Changes"),
                                   sentence, QMessageBox::Ok, over);
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setModal(false);
    box->show();
}

QPalette lightPalette() {
    QPalette palette(QColor(247, 247, 248));
    palette.setColor(QPalette::Window, QColor(247, 247, 248));
    palette.setColor(QPalette::Base, Qt::white);
    palette.setColor(QPalette::AlternateBase, QColor(243, 244, 246));
    palette.setColor(QPalette::WindowText, QColor(38, 40, 46));
    palette.setColor(QPalette::Text, QColor(38, 40, 46));
    palette.setColor(QPalette::ButtonText, QColor(38, 40, 46));
    palette.setColor(QPalette::Highlight, QColor(38, 110, 214));
    palette.setColor(QPalette::HighlightedText, Qt::white);
    for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
        palette.setColor(QPalette::Disabled, role, QColor(160, 163, 170));
    return palette;
}

// Some desktops name dark colours but none for the hints in empty fields, which would be dark, too.
void dressHints() {
    QPalette now = QApplication::palette(); // all else of it goes on following the desktop
    const QColor base = now.color(QPalette::Base), text = now.color(QPalette::Text);
    const QColor hint = now.color(QPalette::PlaceholderText);
    const bool isLikeText =
        (hint.lightness() < base.lightness()) == (text.lightness() < base.lightness());
    if (isLikeText)
        return;
    constexpr double faint = 0.65;
    QColor made = text;
    made.setAlphaF(faint);
    now.setColor(QPalette::PlaceholderText, made);
    QApplication::setPalette(now);
}

} // namespace

void dress() {
    QFont font = QApplication::font();
    font.setFamilies(QStringList{"Inter"} + font.families());
    font.setPointSizeF(9.5);
    QApplication::setFont(font);
    dressHints();
    const bool desktopHasStyle =
        QApplication::style()->name().compare("fusion", Qt::CaseInsensitive) != 0;
    if (!desktopHasStyle)
        QApplication::setStyle(new controls::IndicatorStyle);
    if (desktopHasStyle || QApplication::palette().color(QPalette::Window).lightness() < 128)
        return;
    QApplication::setPalette(lightPalette());
    qApp->setStyleSheet("QToolBar{border:none;border-bottom:1px solid #e2e3e7;padding:3px 6px;"
                        "spacing:4px;background:#f7f7f8}"
                        "QMenuBar{background:#f7f7f8}"
                        "QStatusBar{background:#f7f7f8;border-top:1px solid #e2e3e7}"
                        "QStatusBar::item{border:none}");
}

Application::Application(media::TimeLimits limits, std::string journal)
    : journal_(std::move(journal)),
      schemas_(schemas::Schemas::load(schemas::Schemas::standardFolders())),
      media_(media::Registry::read(media::registryFolders(QCoreApplication::applicationDirPath())),
             QCoreApplication::applicationDirPath(), pipes_, limits) {
    accessibility::AccessibleView::install();
    media_.setMostLive(QSettings().value("media/mostLive", media_.mostLive()).toInt());
    constexpr int kib = 1024;
    const auto mostMiB = QSettings().value("media/mostMemory", 0).toULongLong(); // 0: the usual
    if (mostMiB > 0)
        pipes_.setMostMemory(mostMiB * kib * kib);
    for (const QString& fault : media_.registry().faults())
        terminal::complain("ensemble: " + fault.toStdString());
    for (const auto& fault : schemas_.faults())
        terminal::complain(sgml::formatted(fault.fault, fault.file.toStdString()));
}

Application::~Application() {
    for (const QPointer<DocumentWindow>& one : windows_)
        delete one;
}

DocumentWindow* Application::open(const QString& fileName, QWidget* parent) {
    const QString path = QFileInfo(fileName).absoluteFilePath();
    for (const QPointer<DocumentWindow>& one : windows_)
        if (one && one->document().document().fileName() == path) {
            one->raise();
            one->activateWindow();
            return one;
        }
    document::Document::Loaded loaded = document::Document::load(path);
    if (!loaded.document) {
        plain::Message::tell(QMessageBox::Critical, parent, tr("Open"), loaded.failure);
        return nullptr;
    }
    remember(path);
    DocumentWindow* made = addWindow(
        std::make_shared<session::OpenDocument>(std::move(loaded.document), schemas_, media_));
    closeUntouched(*made);
    return made;
}

// It has no file of its own yet.
DocumentWindow* Application::openNew(const filing::Template& from, QWidget* parent) {
    const filing::Template::Read read = from.read();
    if (!read.failure.isEmpty()) {
        plain::Message::tell(QMessageBox::Critical, parent, tr("New"), read.failure);
        return nullptr;
    }
    DocumentWindow* made = addWindow(std::make_shared<session::OpenDocument>(
        std::make_unique<document::Document>(read.bytes), schemas_, media_));
    made->view().setWriting(true);
    closeUntouched(*made);
    return made;
}

DocumentWindow* Application::openNew() { return openNew(filing::templates().front(), nullptr); }

DocumentWindow* Application::addWindow(std::shared_ptr<session::OpenDocument> document) {
    std::erase_if(windows_, [](const QPointer<DocumentWindow>& one) { return !one; });
    if (!document->unsaved())
        connect(&document->keepUnsavedIn(journal_), &session::Unsaved::failed, this,
                [this](const QString& sentence) {
                    tell(windows_.empty() ? nullptr : windows_.back(), sentence);
                });
    auto* made = new DocumentWindow(*this, std::move(document));
    windows_.emplace_back(made);
    made->show();
    return made;
}

// --- what was not saved ------------------------------------------------------------------------

namespace {

QString titleOf(const std::string& text, const schemas::Schemas& schemas) {
    const document::Document document(text);
    const auto& presentation = schemas.presentation(document.className());
    return QString::fromStdString(model::buildModel(document, presentation, schemas).title);
}

dialogs::Asking asking(const files::Kept& kept, const schemas::Schemas& schemas) {
    const QString title = kept.file.path.empty() ? titleOf(kept.text, schemas) : QString();
    return {.program = Application::tr("Ensemble"),
            .unnamed = title.isEmpty() ? Application::tr("A document without a name")
                                       : Application::tr("“%1”").arg(title),
            .drafts =
                Application::tr("Windows of its figures open again, with what was typed in them.")};
}

} // namespace

void Application::offerRecovered() {
    files::AllLeft all = files::leftBehind(files::FileSystem::real(), journal_);
    const auto over = [this]() -> QWidget* {
        return windows_.empty() ? nullptr : windows_.back().data();
    };
    for (const std::string& fault : all.faults)
        tell(over(), QString::fromStdString(fault));
    for (files::LeftBehind& left : all.texts) {
        const dialogs::Recovery answer =
            dialogs::askAbout(over(), left.kept, asking(left.kept, schemas_));
        if (answer == dialogs::Recovery::discard)
            left.place->remove();
        if (answer == dialogs::Recovery::recover)
            closeUntouched(*recover(std::move(left)));
    }
}

DocumentWindow* Application::recover(files::LeftBehind left) {
    files::Kept& kept = left.kept;
    const QString path = QFile::decodeName(kept.file.path.c_str());
    for (const QPointer<DocumentWindow>& one : windows_) {
        if (!one || path.isEmpty() || one->document().document().fileName() != path)
            continue;
        if (one->document().document().isModified()) {
            kept.file = {}; // what was done since is worth as much: both are there, to choose from
            break;
        }
        one->document().unsaved()->adopt(std::move(left));
        return one;
    }
    DocumentWindow* made = addWindow(std::make_shared<session::OpenDocument>(
        document::Document::recover(kept.file, kept.text), schemas_, media_));
    made->document().unsaved()->adopt(std::move(left));
    made->view().setWriting(true); // somebody was writing in it
    return made;
}

// The empty memo that a program begins with which is given no document. Somebody who asks for two
// empty memos gets them.
void Application::closeUntouched(DocumentWindow& instead) {
    for (const QPointer<DocumentWindow>& one : windows_) {
        if (!one || one == &instead)
            continue;
        const document::Document& of = one->document().document();
        const bool isAlike = of.bytes() == instead.document().document().bytes();
        if (!of.fileName().isEmpty() || of.isModified() || of.revision() != 0 || isAlike)
            continue;
        instead.setGeometry(one->geometry());
        instead.setWindowState(one->windowState());
        one->close();
    }
}

void Application::setPresentation(const QString& name, const QString& path,
                                  const std::string& text) {
    schemas_.setText(name, path, text);
    std::set<session::OpenDocument*> open;
    for (const QPointer<DocumentWindow>& one : windows_)
        if (one && open.insert(&one->document()).second)
            one->document().presentAnew();
}

void Application::playWhenLoaded(session::OpenDocument& document) {
    for (const document::SubdocumentId id : document.document().subdocuments())
        if (media::LiveSubdocument* live = document.live(id))
            connect(
                live, &media::LiveSubdocument::loaded, live, [live] { live->play(); },
                Qt::SingleShotConnection);
}

void Application::quit() {
    for (const QPointer<DocumentWindow>& one : windows_)
        if (one && !one->close())
            return;
    QCoreApplication::quit();
}

std::vector<DocumentWindow*> Application::windowsOf(const session::OpenDocument& of) const {
    std::vector<DocumentWindow*> result;
    for (const QPointer<DocumentWindow>& one : windows_)
        if (one && &one->document() == &of)
            result.push_back(one);
    return result;
}

QStringList Application::recentFiles() const {
    QStringList result;
    for (const QString& file : QSettings().value("recent").toStringList())
        if (QFileInfo::exists(file))
            result << file;
    return result;
}

void Application::remember(const QString& fileName) {
    filing::rememberFolderOf(fileName);
    QStringList files = recentFiles();
    files.removeAll(fileName);
    files.prepend(fileName);
    QSettings().setValue("recent", files.mid(0, mostRecent));
}

} // namespace window
