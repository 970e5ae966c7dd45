#include "views/manual.h"

#include <QAction>
#include <QFile>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QPointer>
#include <QTextBlock>
#include <QTextBrowser>
#include <QTextTable>
#include <QTimer>

namespace views {

namespace {

QString read(const QString& name) {
    QFile file(QStringLiteral(":/manual/") + name);
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

void goTo(QTextBrowser& browser, const QString& chapter) {
    for (QTextBlock block = browser.document()->begin(); block.isValid(); block = block.next())
        if (block.blockFormat().headingLevel() > 0 && block.text() == chapter) {
            // The chapter's heading comes to the top: from below, one scrolls no further.
            browser.moveCursor(QTextCursor::End);
            browser.setTextCursor(QTextCursor(block));
            return;
        }
}

// Thin lines, and room within them.
void drawTablesLightly(const QTextFrame& frame) {
    for (QTextFrame* child : frame.childFrames()) {
        if (auto* table = qobject_cast<QTextTable*>(child)) {
            QTextTableFormat format = table->format();
            format.setBorderCollapse(true);
            format.setBorder(0.5);
            format.setBorderBrush(QColor(0xC8, 0xCC, 0xD2));
            format.setCellPadding(4);
            format.setCellSpacing(0);
            table->setFormat(format);
        }
        drawTablesLightly(*child);
    }
}

QTextBrowser* newManual() {
    auto* browser = new QTextBrowser;
    browser->setAttribute(Qt::WA_DeleteOnClose);
    browser->setAttribute(Qt::WA_QuitOnClose, false);
    browser->setWindowTitle(QObject::tr("Manual"));
    browser->setMarkdown(read(QStringLiteral("editing.md")) + QStringLiteral("\n\n") +
                         read(QStringLiteral("scene-language.md")));
    browser->document()->setDocumentMargin(16);
    drawTablesLightly(*browser->document()->rootFrame());
    browser->resize(820, 760);
    return browser;
}

} // namespace

void showManual(const QString& chapter) {
    static QPointer<QTextBrowser> manual;
    if (!manual)
        manual = newManual();
    manual->show();
    manual->raise();
    manual->activateWindow();
    if (!chapter.isEmpty()) // once it is laid out
        QTimer::singleShot(0, manual, [chapter] { goTo(*manual, chapter); });
}

QMenu* addHelpMenu(QMainWindow* window, const QString& chapter) {
    QMenu* help = window->menuBar()->addMenu(QObject::tr("&Help"));
    help->addAction(QObject::tr("&Keys and Buttons"), QKeySequence(Qt::Key_F1), window,
                    [chapter] { showManual(chapter); });
    help->addAction(QObject::tr("&Manual"), window, [] { showManual(); });
    return help;
}

} // namespace views
