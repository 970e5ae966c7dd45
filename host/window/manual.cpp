#include "window/manual.h"

#include <QDialog>
#include <QFile>
#include <QPointer>
#include <QTextBrowser>
#include <QVBoxLayout>

namespace window {

void showManual(QWidget* asked) {
    static QPointer<QDialog> manual;
    if (!manual) {
        manual = new QDialog(asked);
        manual->setAttribute(Qt::WA_DeleteOnClose);
        manual->setWindowTitle(QDialog::tr("Keys and Buttons"));
        auto* column = new QVBoxLayout(manual);
        column->setContentsMargins(0, 0, 0, 0);
        auto* text = new QTextBrowser;
        text->setObjectName("manual");
        text->setFrameShape(QFrame::NoFrame);
        text->document()->setDocumentMargin(16);
        QFile file(QStringLiteral(":/manual/reading.md"));
        if (file.open(QIODevice::ReadOnly))
            text->setMarkdown(QString::fromUtf8(file.readAll()));
        column->addWidget(text);
        manual->resize(640, 620);
    }
    manual->show();
    manual->raise();
    manual->activateWindow();
}

} // namespace window
