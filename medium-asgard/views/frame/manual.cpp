#include "frame/manual.h"

#include "frame/manual_window.h"
#include "frame/placing.h"

#include <QApplication>
#include <QFile>
#include <QPointer>
#include <QTimer>

namespace views {

namespace {

QString read(const QString& name) {
    QFile file(QStringLiteral(":/manual/") + name);
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

} // namespace

void showManual(const QString& chapter) {
    static QPointer<ManualWindow> manual;
    if (!manual) {
        manual = new ManualWindow(read(QStringLiteral("editing.md")) + QStringLiteral("\n\n") +
                                  read(QStringLiteral("scene-language.md")));
        fitScreen(*manual, QApplication::activeWindow()); // later it is as large as it was made
    }
    manual->show();
    manual->raise();
    manual->activateWindow();
    if (!chapter.isEmpty()) // once it is laid out
        QTimer::singleShot(0, manual, [chapter] { manual->goTo(chapter); });
}

} // namespace views
