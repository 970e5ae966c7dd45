#include "paper/paper.h"

#include "layout/measure.h"
#include "layout/typeface.h"

#include <QDir>
#include <QFileInfo>
#include <QImageReader>
#include <QPainter>
#include <QPdfWriter>
#include <QPrinter>

namespace paper {
namespace {

QImage imageOf(const document::Document& document, const std::string& source) {
    const QDir folder = QFileInfo(document.fileName()).absoluteDir();
    const QString path =
        QFileInfo(folder.filePath(QString::fromStdString(source))).canonicalFilePath();
    if (path.isEmpty() || !path.startsWith(folder.canonicalPath() + '/'))
        return {};
    QImageReader reader(path);
    constexpr int mostMegabytes = 256;
    QImageReader::setAllocationLimit(mostMegabytes);
    return reader.read();
}

} // namespace

document::Model modelOf(const session::OpenDocument& document, const QString& presentation) {
    const document::Document& read = document.document();
    return document::buildModel(
        read, document.schemas().presentation(read.className(), presentation), document.schemas());
}

layout::Objects objectsOf(const session::OpenDocument& document) {
    layout::Objects objects;
    objects.subdocumentSize = [&document](document::SubdocumentId id) {
        return layout::fromPixels(document.sizeOf(id));
    };
    objects.image = [&document](const std::string& source) {
        return imageOf(document.document(), source);
    };
    return objects;
}

Paper::Paper(session::OpenDocument& document, const QString& presentation, double dpi, bool posters,
             QObject* parent)
    : QObject(parent), document_(document), presentation_(presentation),
      pictures_(document, document.document().subdocuments(), dpi / 96, posters) {
    connect(&pictures_, &session::Pictures::progressed, this, &Paper::progressed);
    connect(&pictures_, &session::Pictures::finished, this, [this] {
        layOut();
        Q_EMIT ready();
    });
}

void Paper::prepare() { pictures_.start(); }

void Paper::layOut() {
    model_ = modelOf(document_, presentation_);
    pages_ = layout::layOut(model_, objectsOf(document_));
    title_ = QString::fromStdString(model_.title);
    for (const layout::PlacedSubdocument& placed : pages_.subdocuments) {
        const auto found = pictures_.pictures().find(placed.subdocument);
        if (found != pictures_.pictures().end() && !found->second.error.isEmpty())
            failures_ << found->second.error;
    }
}

void paintBox(QPainter& painter, const QRectF& rect, const QString& title, const QString& text) {
    painter.fillRect(rect, QColor(246, 246, 247));
    painter.setPen(QPen(QColor(200, 200, 205), layout::fromPoints(0.75)));
    painter.drawRect(rect);
    document::TextStyle style;
    style.family = "sans";
    style.size = 9;
    style.bold = true;
    const double margin = layout::fromPoints(12);
    const QRectF inside = rect.adjusted(margin, margin, -margin, -margin);
    painter.setPen(QColor(60, 60, 65));
    painter.setFont(layout::fontOf(style));
    QRectF used;
    painter.drawText(inside, Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap, title, &used);
    style.bold = false;
    painter.setFont(layout::fontOf(style));
    painter.drawText(inside.adjusted(0, used.height() + margin / 3, 0, 0),
                     Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap, text);
}

void Paper::paintSubdocument(QPainter& painter, const layout::SubdocumentPiece& piece) const {
    const auto found = pictures_.pictures().find(piece.subdocument);
    const session::Picture picture =
        found == pictures_.pictures().end() ? session::Picture{} : found->second;
    const document::Subdocument* subdocument = document_.document().subdocument(piece.subdocument);
    if (picture.image.isNull()) {
        const QString alternative =
            subdocument ? QString::fromStdString(subdocument->alternative) : QString();
        paintBox(painter, piece.rect, picture.error, alternative);
        return;
    }
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.drawImage(piece.rect, picture.image);
    if (picture.error.isEmpty())
        return;
    QRectF note = piece.rect;
    note.setTop(std::max(note.top(), note.bottom() - layout::fromPoints(40)));
    paintBox(painter, note, picture.error, {});
}

void Paper::paint(QPainter& painter, int page) const {
    const QRectF whole({0, 0}, pages_.size);
    if (pages_.paper != QColor(Qt::white))
        painter.fillRect(whole, pages_.paper);
    layout::paintPage(painter, pages_.pages[static_cast<std::size_t>(page)], whole,
                      [this](QPainter& by, const layout::SubdocumentPiece& piece) {
                          paintSubdocument(by, piece);
                      });
}

QString Paper::writePdf(QIODevice& file) const {
    QPdfWriter writer(&file);
    writer.setResolution(static_cast<int>(layout::twipsPerInch));
    writer.setCreator(QStringLiteral("ensemble"));
    writer.setTitle(title_);
    writer.setPageMargins({0, 0, 0, 0});
    writer.setPageSize(QPageSize(pages_.size / layout::twipsPerPoint, QPageSize::Point, {},
                                 QPageSize::ExactMatch));
    QPainter painter;
    if (!painter.begin(&writer))
        return tr("The file cannot be written.");
    for (int page = 0; page < pageCount(); ++page) {
        if (page > 0 && !writer.newPage())
            return tr("The file cannot be written.");
        paint(painter, page);
    }
    return painter.end() ? QString() : tr("The file cannot be written.");
}

QImage Paper::image(int page, double dpi) const {
    const double scale = dpi / layout::twipsPerInch;
    QImage image((pages_.size * scale).toSize(), QImage::Format_RGB32);
    image.fill(pages_.paper);
    QPainter painter(&image);
    painter.setRenderHints(QPainter::Antialiasing | QPainter::TextAntialiasing);
    painter.scale(scale, scale);
    paint(painter, page);
    return image;
}

void Paper::print(QPrinter& printer) const {
    QPainter painter(&printer);
    const int from = printer.fromPage() > 0 ? printer.fromPage() - 1 : 0;
    const int to = printer.toPage() > 0 ? std::min(printer.toPage(), pageCount()) : pageCount();
    const double scale = printer.resolution() / layout::twipsPerInch;
    for (int page = from; page < to; ++page) {
        if (page > from)
            printer.newPage();
        painter.save();
        painter.scale(scale, scale);
        paint(painter, page);
        painter.restore();
    }
}

} // namespace paper
