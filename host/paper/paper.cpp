#include "paper/paper.h"

#include "model/empty_places.h"
#include "paragraphs/measure.h"
#include "paragraphs/typeface.h"

#include <QPainter>
#include <QPdfWriter>
#include <QPrinter>

namespace paper {
Paper::Paper(session::OpenDocument& document, const QString& presentation, double dpi, bool posters,
             QObject* parent)
    : QObject(parent), document_(document), presentation_(presentation), dpi_(dpi),
      pictures_(document, document.document().subdocuments(), dpi / 96, posters) {
    connect(&pictures_, &session::Pictures::progressed, this, &Paper::progressed);
    connect(&pictures_, &session::Pictures::finished, this, &Paper::askForValues);
    connect(&document_.images(), &session::Images::ready, this, &Paper::becomeReady);
}

void Paper::prepare() { pictures_.start(); }

// Once media have said how large their pictures are.
void Paper::askForValues() {
    connect(&document_.values(), &session::Values::settled, this, &Paper::present,
            Qt::SingleShotConnection);
    document_.values().settle();
}

void Paper::present() {
    presented_ = document_.presented(presentation_);
    // Behind those who go on with the pages: they may be made anew.
    connect(presented_.get(), &session::Presented::complete, this, &Paper::lookAtPages,
            Qt::QueuedConnection);
    lookAtPages();
}

void Paper::lookAtPages() {
    if (!laidOut_ && presented_->isUpToDate())
        askForImages();
}

// Each file at the resolution of its largest place, so that a PDF holds it once. As many are
// decoded beforehand as are kept; the others are when their page is painted.
void Paper::askForImages() {
    laidOut_ = true;
    pages_ = presented_->pages();
    // Empty places that wait for text are not printed.
    if (const std::shared_ptr<const model::Model> model = presented_->model())
        if (const auto filled = model::withoutEmptyPlaces(*model))
            pages_ = layout::relaid(pages_, filled, presented_->objects());
    for (const auto& page : pages_.pages)
        for (const layout::PlacedObject& object : page->objects)
            if (!object.subdocument) {
                QSize& size = imageSizes_[object.image];
                const QSizeF pixels = object.rect.size() * (dpi_ / paragraphs::twipsPerInch);
                size = size.expandedTo(pixels.toSize());
            }
    qint64 bytes = 0;
    for (const auto& [source, size] : imageSizes_) {
        constexpr qint64 bytesToPixel = 4;
        bytes += bytesToPixel * size.width() * size.height();
        if (bytes < session::Images::mostKept / 4)
            (void)document_.images().image(source, size);
    }
    becomeReady();
}

void Paper::becomeReady() {
    if (ready_ || !laidOut_ || document_.images().isWaiting())
        return;
    ready_ = true;
    for (const layout::PlacedSubdocument& placed : pages_.subdocuments()) {
        const auto found = pictures_.pictures().find(placed.subdocument);
        if (found != pictures_.pictures().end() && !found->second.error.isEmpty())
            failures_ << found->second.error;
    }
    for (const auto& [source, size] : imageSizes_)
        if (const QString fault = document_.images().fault(source); !fault.isEmpty())
            failures_ << fault;
    for (const session::ListedFault& fault : document_.valueFaults())
        failures_ << tr("line %1: %2").arg(fault.position.line).arg(fault.message);
    Q_EMIT ready();
}

QImage Paper::imageOf(const layout::ImagePiece& piece) const {
    const auto size = imageSizes_.find(piece.source);
    return size == imageSizes_.end() ? QImage()
                                     : document_.images().imageNow(piece.source, size->second);
}

namespace {

constexpr double boxMarginPoints = 12;
constexpr int boxFlags = Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap;

QFont boxFont(bool bold) {
    schemas::TextStyle style;
    style.family = "sans";
    style.size = 9;
    style.bold = bold;
    return paragraphs::fontOf(style);
}

// The lower part of a figure that a sentence about it takes: as high as the sentence is, and no
// more than half of the figure.
QRectF noteIn(QPainter& painter, const QRectF& figure, const QString& sentence) {
    const double margin = paragraphs::fromPoints(boxMarginPoints);
    painter.setFont(boxFont(true));
    const QRectF inside = figure.adjusted(margin, 0, -margin, 0);
    const double height = painter.boundingRect(inside, boxFlags, sentence).height() + 2 * margin;
    QRectF note = figure;
    note.setTop(std::max(figure.center().y(), figure.bottom() - height));
    return note;
}

// As large as there is room for it: paper hides no part of a picture under words.
QRectF fittedInto(const QRectF& room, const QSizeF& picture) {
    const QSizeF size = picture.scaled(room.size(), Qt::KeepAspectRatio);
    return {room.topLeft() + QPointF((room.width() - size.width()) / 2, 0), size};
}

} // namespace

void paintBox(QPainter& painter, const QRectF& rect, const QString& title, const QString& text) {
    painter.fillRect(rect, QColor(246, 246, 247));
    painter.setPen(QPen(QColor(200, 200, 205), paragraphs::fromPoints(0.75)));
    painter.drawRect(rect);
    const double margin = paragraphs::fromPoints(boxMarginPoints);
    const QRectF inside = rect.adjusted(margin, margin, -margin, -margin);
    painter.setPen(QColor(60, 60, 65));
    painter.setFont(boxFont(true));
    QRectF used;
    painter.drawText(inside, boxFlags, title, &used);
    painter.setFont(boxFont(false));
    painter.drawText(inside.adjusted(0, used.height() + margin / 3, 0, 0), boxFlags, text);
}

void Paper::paintSubdocument(QPainter& painter, const layout::SubdocumentPiece& piece) const {
    const auto found = pictures_.pictures().find(piece.subdocument);
    const session::Picture picture =
        found == pictures_.pictures().end() ? session::Picture{} : found->second;
    const document::Subdocument* subdocument = document_.document().subdocument(piece.subdocument);
    if (picture.image.isNull()) {
        const QString alternative =
            subdocument ? QString::fromStdString(subdocument->alternative) : QString();
        paintBox(painter, piece.rect, picture.note, alternative);
        return;
    }
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    if (picture.error.isEmpty())
        return painter.drawImage(piece.rect, picture.image);
    const QRectF note = noteIn(painter, piece.rect, picture.error);
    QRectF above = piece.rect;
    above.setBottom(note.top());
    painter.drawImage(fittedInto(above, piece.rect.size()), picture.image);
    paintBox(painter, note, picture.error, {});
}

void Paper::paint(QPainter& painter, int page) const {
    const QRectF whole({0, 0}, pages_.size);
    if (pages_.paper != QColor(Qt::white))
        painter.fillRect(whole, pages_.paper);
    layout::paintPage(painter, pages_, static_cast<std::size_t>(page), whole,
                      {[this](QPainter& by, const layout::SubdocumentPiece& piece) {
                           paintSubdocument(by, piece);
                       },
                       [this](const layout::ImagePiece& piece) { return imageOf(piece); }});
}

QString Paper::writePdf(QIODevice& file) const {
    QPdfWriter writer(&file);
    writer.setResolution(static_cast<int>(paragraphs::twipsPerInch));
    writer.setCreator(QStringLiteral("ensemble"));
    writer.setTitle(title());
    writer.setPageMargins({0, 0, 0, 0});
    writer.setPageSize(QPageSize(pages_.size / paragraphs::twipsPerPoint, QPageSize::Point, {},
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
    const double scale = dpi / paragraphs::twipsPerInch;
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
    const double scale = printer.resolution() / paragraphs::twipsPerInch;
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
