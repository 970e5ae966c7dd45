#include "console/convert.h"

#include "console/batch_document.h"
#include "exports/text_export.h"
#include "paper/paper.h"
#include "terminal/terminal.h"
#include "text/printable.h"

#include <QBuffer>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QImageWriter>
#include <QSaveFile>

namespace console {

namespace {

constexpr double paperDpi = 300;
constexpr double screenDpi = 144;

QString outputFile(const Conversion& conversion) {
    const QString extension = conversion.format == "text" ? "txt" : conversion.format;
    const QString base =
        conversion.input == "-" ? "document" : QFileInfo(conversion.input).completeBaseName();
    if (conversion.output.isEmpty())
        return base + '.' + extension;
    if (conversion.output.endsWith('/') || QFileInfo(conversion.output).isDir())
        return conversion.output + (conversion.output.endsWith('/') ? "" : "/") + base + '.' +
               extension;
    return conversion.output;
}

QString writeBytes(const QString& name, const QByteArray& bytes) {
    if (name == "-" && terminal::isTerminal())
        return "these bytes are not for a terminal: name a file, or send them on";
    if (name == "-")
        return terminal::pass(bytes.toStdString()) ? QString() : "cannot be written";
    QSaveFile file(name);
    file.setDirectWriteFallback(true); // such as /dev/stdout
    if (file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size() && file.commit())
        return {};
    return file.errorString();
}

QString writePng(const paper::Paper& paper, const QString& name) {
    for (int page = 0; page < paper.pageCount(); ++page) {
        QByteArray bytes;
        QBuffer buffer(&bytes);
        if (!paper.image(page, screenDpi).save(&buffer, "PNG"))
            return "the picture cannot be made";
        QString pageName = name;
        if (paper.pageCount() > 1 && name != "-") {
            const QFileInfo info(name);
            pageName = info.dir().filePath(
                QStringLiteral("%1-%2.png").arg(info.completeBaseName()).arg(page + 1));
        }
        QString failed = writeBytes(pageName, bytes);
        if (!failed.isEmpty())
            return failed;
    }
    return {};
}

QString writeText(BatchDocument& batch, const QString& presentation, const QString& name) {
    batch.settleValues();
    const document::Document& of = batch.document().document();
    const model::Model model =
        model::buildModel(of, batch.schemas().presentation(of.className(), presentation),
                          batch.schemas(), &batch.document().values());
    // Each line is the document's own, so that what orders its letters from right to left stays.
    const std::string shown =
        text::printable(exports::exportText(of, model), text::Direction::kept);
    if (name == "-")
        return terminal::pass(shown) ? QString() : "cannot be written";
    return writeBytes(name, QByteArray::fromStdString(shown));
}

bool isBroken(BatchDocument& batch, const QString& input) {
    const document::Document& of = batch.document().document();
    for (const sgml::Fault& fault : of.faults())
        complain(QString::fromStdString(sgml::formatted(fault, input.toStdString())));
    return of.isBroken();
}

} // namespace

int convert(const Conversion& conversion) {
    BatchDocument batch(conversion.input);
    if (!batch.isOpen()) {
        complain(batch.failure());
        return failure;
    }
    const std::string className = batch.document().document().className();
    const QStringList known = batch.schemas().presentations(className);
    if (!conversion.presentation.isEmpty() && !known.contains(conversion.presentation)) {
        complain(
            QStringLiteral("%1: error: documents of class %2 have no presentation %3; there is %4")
                .arg(conversion.input, QString::fromStdString(className), conversion.presentation,
                     known.join(QStringLiteral(", "))));
        return failure;
    }
    const bool broken = isBroken(batch, conversion.input);
    const QString name = outputFile(conversion);
    QString failed;
    QStringList missing;
    if (conversion.format == "text") {
        failed = writeText(batch, conversion.presentation, name);
        for (const session::ListedFault& fault : batch.document().valueFaults())
            missing << QStringLiteral("line %1: %2").arg(fault.position.line).arg(fault.message);
    } else {
        const bool png = conversion.format == "png";
        paper::Paper paper(batch.document(), conversion.presentation, png ? screenDpi : paperDpi,
                           true);
        QEventLoop loop;
        QObject::connect(&paper, &paper::Paper::ready, &loop, &QEventLoop::quit);
        paper.prepare();
        loop.exec();
        missing = paper.failures();
        if (png) {
            failed = writePng(paper, name);
        } else {
            QByteArray bytes;
            QBuffer buffer(&bytes);
            buffer.open(QIODevice::WriteOnly);
            failed = paper.writePdf(buffer);
            if (failed.isEmpty())
                failed = writeBytes(name, bytes);
        }
    }
    for (const QString& one : missing)
        complain(QStringLiteral("%1: error: %2").arg(conversion.input, one));
    if (!failed.isEmpty())
        complain(QStringLiteral("%1: error: %2").arg(name, failed));
    return failed.isEmpty() && missing.isEmpty() && !broken ? success : failure;
}

} // namespace console
