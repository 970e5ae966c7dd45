#include "viewers/run_editor.h"

#include "frame/icons.h"
#include "frame/seen_style.h"
#include "plain/plain.h"
#include "plain/qt_messages.h"
#include "script/reader.h"
#include "start/first_page.h"
#include "viewers/editor.h"
#include "viewers/scene_files.h"
#include "viewers/starting.h"
#include "workbench/autosave.h"
#include "workbench/recent_files.h"

#include <QApplication>
#include <QTimer>

#include <algorithm>

namespace views {

int runEditor(int argc, char** argv, const std::string& file, script::Reader& reader) {
    plain::printQtMessages("asgard", plain::QtMessages::all);
    QApplication application(argc, argv);
    QApplication::setOrganizationName(QStringLiteral("asgard"));
    QApplication::setApplicationName(QStringLiteral("asgard"));
    takeOverOldSettings();
    QApplication::setApplicationDisplayName(QStringLiteral("Asgard"));
    QApplication::setQuitOnLastWindowClosed(true);
    QApplication::setWindowIcon(applicationIcon());
    QApplication::setStyle(new SeenStyle);
    Editor editor(computing::toolsOf(reader));
    SceneFiles& files = editor.beginSession();
    SceneDocument& document = editor.document();
    const QString path = QString::fromStdString(file);
    if (!path.isEmpty()) {
        if (const QString fault = document.open(path); !fault.isEmpty()) {
            plain::Message::tell(QMessageBox::Critical, nullptr, QStringLiteral("Asgard"), fault);
            return 1;
        }
        rememberFile(path);
    } else {
        document.reset(); // it has a motion from the first moment, too
    }
    const std::string journal = files::journalFolder("asgard");
    Autosave autosave(
        document, journal,
        {[&editor] {
             const bool any =
                 std::ranges::any_of(editor.languageViewers(),
                                     [](const LanguageViewer* one) { return one->hasDraft(); });
             return any ? editor.windowsState() : std::string();
         },
         [&editor](const std::string& state) {
             const auto before = editor.viewerWindows(); // of a program that begins
             editor.restoreWindows(state,
                                   Autosave::tr("Asgard ended before this was saved. Its windows "
                                                "are open again with what was typed."));
             editor.closeAll(before);
         }});
    QObject::connect(&editor, &Editor::viewersChanged, &autosave, &Autosave::lookAtDrafts,
                     Qt::QueuedConnection);
    QObject::connect(&autosave, &Autosave::failed, &files, [](const QString& sentence) {
        plain::Message::tell(QMessageBox::Warning, QApplication::activeWindow(),
                             QStringLiteral("Asgard"), sentence);
    });
    Starting starting(editor, files);
    const QPointer<QWidget> first =
        path.isEmpty() ? static_cast<QWidget*>(starting.showFirstPage()) : editor.openMainWindow();
    QTimer::singleShot(0, &files, [&] {
        if (!offerRecovery(first, autosave, journal, path) || !path.isEmpty())
            return;
        if (editor.viewerWindows().isEmpty())
            editor.openMainWindow();
        first->close();
    });
    return QApplication::exec();
}

} // namespace views
