#include "workbench/recent_files.h"

#include "plain/plain.h"

#include <QDir>
#include <QFileInfo>
#include <QMenu>
#include <QSettings>

namespace views {

namespace {

constexpr qsizetype most = 10;

QString settingsKey() { return QStringLiteral("recentFiles"); }

} // namespace

QStringList recentFiles() {
    QStringList files = QSettings().value(settingsKey()).toStringList();
    files.removeIf([](const QString& file) { return !QFileInfo(file).isFile(); });
    return files;
}

void rememberFile(const QString& path) {
    const QString file = QFileInfo(path).absoluteFilePath();
    QStringList files = recentFiles();
    files.removeAll(file);
    files.prepend(file);
    QSettings().setValue(settingsKey(), files.mid(0, most));
}

void takeOverOldSettings() {
    QSettings now;
    if (QFileInfo::exists(now.fileName()))
        return;
    const QSettings then(QSettings::defaultFormat(), QSettings::UserScope,
                         QStringLiteral("Unknown Organization"), QStringLiteral("asgard"));
    if (!QFileInfo::exists(then.fileName()))
        return; // other programs without a folder of their own share this one's fallbacks
    for (const QString& key : then.allKeys())
        now.setValue(key, then.value(key));
}

void fillWithRecentFiles(QMenu* menu, std::function<void(const QString& path)> open) {
    QObject::connect(menu, &QMenu::aboutToShow, menu, [menu, open = std::move(open)] {
        menu->clear();
        int place = 0;
        for (const QString& file : recentFiles()) {
            const QString name = plain::caption(QDir::toNativeSeparators(file));
            ++place;
            menu->addAction(
                plain::ours(place < 10 ? QStringLiteral("&%1  %2").arg(QString::number(place), name)
                                       : name),
                menu, [open, file] { open(file); });
        }
        if (place == 0)
            menu->addAction(QMenu::tr("None"))->setEnabled(false);
    });
}

} // namespace views
