#include "filing/printing.h"

#include "filing/choosing.h"
#include "paper/paper.h"
#include "plain/plain.h"
#include "session/presented.h"

#include <QDir>
#include <QFileInfo>
#include <QMessageBox>
#include <QPrintDialog>
#include <QPrinter>
#include <QSaveFile>

namespace filing {

namespace {

constexpr double paperDpi = 300;

} // namespace

Printing::Printing(session::OpenDocument& document, QWidget& window)
    : QObject(&window), document_(document), window_(window) {}

void Printing::askAndExport(const QString& presentation) {
    const QFileInfo own(document_.document().fileName());
    const bool isSaved = !own.fileName().isEmpty();
    const QString folder = isSaved ? own.path() : folderUsedLast();
    const QString name =
        isSaved ? own.completeBaseName() : fileNameOf(document_.presented(presentation)->title());
    const QString file = askForFile(&window_, tr("Export PDF"), folder + '/' + name + ".pdf",
                                    tr("PDF (*.pdf)"), QStringLiteral("pdf"));
    if (!file.isEmpty())
        exportTo(file, presentation);
}

void Printing::exportTo(const QString& fileName, const QString& presentation) {
    auto* paper = new paper::Paper(document_, presentation, paperDpi, false, this);
    Q_EMIT said(tr("Taking the pictures for %1").arg(QFileInfo(fileName).fileName()));
    connect(paper, &paper::Paper::ready, this, [this, paper, fileName] {
        paper->deleteLater();
        QSaveFile file(fileName);
        QString failed =
            file.open(QIODevice::WriteOnly) ? paper->writePdf(file) : file.errorString();
        if (failed.isEmpty() && !file.commit())
            failed = file.errorString();
        if (failed.isEmpty())
            Q_EMIT said(tr("Wrote %1").arg(fileName));
        else
            plain::Message::tell(QMessageBox::Critical, &window_, tr("Export PDF"), failed);
    });
    paper->prepare();
}

void Printing::askAndPrint(const QString& presentation, const QString& title) {
    auto printer = std::make_shared<QPrinter>(QPrinter::HighResolution);
    printer->setFullPage(true);
    printer->setDocName(title);
    QPrintDialog dialog(printer.get(), &window_);
    if (dialog.exec() != QDialog::Accepted)
        return;
    auto* paper = new paper::Paper(document_, presentation, paperDpi, false, this);
    Q_EMIT said(tr("Taking the pictures to print"));
    connect(paper, &paper::Paper::ready, this, [this, paper, printer] {
        paper->deleteLater();
        paper->print(*printer);
        Q_EMIT said(tr("Printed"));
    });
    paper->prepare();
}

} // namespace filing
