#include "window/help_menu.h"

#include "menus/actions.h"
#include "plain/plain.h"
#include "window/manual.h"

namespace window {

namespace {

QString about(session::OpenDocument& document) {
    const media::Registry& registry = document.media().registry();
    QStringList installed;
    for (const media::Manifest& manifest : registry.media())
        installed << QMenu::tr("%1 for %2").arg(manifest.name, manifest.documentClass);
    installed << registry.faults();
    return QMenu::tr("Ensemble %1 shows and writes compound documents.\n\nInstalled media:\n%2")
        .arg(QCoreApplication::applicationVersion(),
             installed.isEmpty() ? QMenu::tr("none") : installed.join('\n'));
}

} // namespace

QMenu* makeHelpMenu(session::OpenDocument& document, QWidget* window) {
    auto* menu = new QMenu(QMenu::tr("&Help"), window);
    menus::addTo(*menu, "keys", QMenu::tr("&Keys and Buttons"), QKeySequence(Qt::Key_F1),
                 [window] { showManual(window); });
    menus::addTo(*menu, "about", QMenu::tr("&About Ensemble"), {}, [window, &document] {
        plain::Message::tell(QMessageBox::NoIcon, window, QMenu::tr("About Ensemble"),
                             about(document));
    });
    return menu;
}

} // namespace window
