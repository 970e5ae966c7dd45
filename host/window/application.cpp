#include "window/application.h"

#include <QApplication>
#include <QFileInfo>
#include <QMessageBox>
#include <QPalette>
#include <QSettings>
#include <QStyle>

namespace window {

namespace {

constexpr int mostRecent = 10;
constexpr const char* emptyMemo = "DOCUMENT CMEMO\n<CMEMO>\n<TO>{}</TO>\n<FROM>{}</FROM>\n"
                                  "<SUBJECT>{}</SUBJECT>\n<BODY>\n"
                                  "<PARAGRAPH><TEXT>{}</TEXT></PARAGRAPH>\n</BODY>\n</CMEMO>\n";

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

} // namespace

void dress() {
    QFont font = QApplication::font();
    font.setFamilies(QStringList{"Inter"} + font.families());
    font.setPointSizeF(9.5);
    QApplication::setFont(font);
    const bool desktopHasStyle =
        QApplication::style()->name().compare("fusion", Qt::CaseInsensitive) != 0;
    if (desktopHasStyle || QApplication::palette().color(QPalette::Window).lightness() < 128)
        return;
    QApplication::setPalette(lightPalette());
    qApp->setStyleSheet("QToolBar{border:none;border-bottom:1px solid #e2e3e7;padding:3px 6px;"
                        "spacing:4px;background:#f7f7f8}"
                        "QMenuBar{background:#f7f7f8}"
                        "QStatusBar{background:#f7f7f8;border-top:1px solid #e2e3e7}"
                        "QStatusBar::item{border:none}");
}

Application::Application(media::TimeLimits limits)
    : schemas_(document::Schemas::load(document::Schemas::standardFolders())),
      media_(media::Registry::read(media::registryFolders(QCoreApplication::applicationDirPath())),
             QCoreApplication::applicationDirPath(), pipes_, limits) {
    media_.setMostLive(QSettings().value("media/mostLive", media_.mostLive()).toInt());
    for (const QString& fault : media_.registry().faults())
        qWarning("%s", qPrintable(fault));
    for (const auto& fault : schemas_.faults())
        qWarning("%s", sgml::formatted(fault.fault, fault.file.toStdString()).c_str());
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
        QMessageBox::critical(parent, tr("Open"), loaded.failure);
        return nullptr;
    }
    remember(path);
    return addWindow(
        std::make_shared<session::OpenDocument>(std::move(loaded.document), schemas_, media_));
}

DocumentWindow* Application::openNew() {
    return addWindow(std::make_shared<session::OpenDocument>(
        std::make_unique<document::Document>(emptyMemo), schemas_, media_));
}

DocumentWindow* Application::addWindow(std::shared_ptr<session::OpenDocument> document) {
    std::erase_if(windows_, [](const QPointer<DocumentWindow>& one) { return !one; });
    auto* made = new DocumentWindow(*this, std::move(document));
    windows_.emplace_back(made);
    made->show();
    return made;
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
    QStringList files = recentFiles();
    files.removeAll(fileName);
    files.prepend(fileName);
    QSettings().setValue("recent", files.mid(0, mostRecent));
}

} // namespace window
