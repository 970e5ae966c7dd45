#include "onpage/shown.h"

#include "controls/accent.h"

#include <QApplication>
#include <QPainterPath>

namespace view {

namespace {

// Of one colour, as far as a grid of points shows: what a medium draws that has nothing to show.
bool looksEmpty(const QImage& image) {
    constexpr int grid = 24;
    for (int i = 0; i < grid * grid; ++i) {
        const QPoint at((2 * (i % grid) + 1) * image.width() / (2 * grid),
                        (2 * (i / grid) + 1) * image.height() / (2 * grid));
        if (image.pixel(at) != image.pixel(0, 0))
            return false;
    }
    return true;
}

QFont noticeFont(bool bold) {
    QFont font = QApplication::font();
    font.setPointSizeF(9.5);
    font.setBold(bold);
    return font;
}

void paintPanel(QPainter& painter, const QRectF& rect) {
    painter.fillRect(rect, QColor(245, 246, 248));
    painter.setPen(QColor(222, 224, 229));
    painter.drawRect(rect.adjusted(0.5, 0.5, -0.5, -0.5));
}

void paintWords(QPainter& painter, const QRectF& rect, const Notice& notice) {
    const QRectF inside = rect.adjusted(18, 16, -18, -16);
    painter.setFont(noticeFont(true));
    const QRectF title = painter.boundingRect(inside, Qt::TextWordWrap, notice.title);
    painter.setPen(QColor(50, 52, 58));
    painter.drawText(inside, Qt::TextWordWrap, notice.title);
    painter.setFont(noticeFont(false));
    painter.setPen(QColor(95, 98, 106));
    painter.drawText(inside.adjusted(0, title.height() + 6, 0, 0), Qt::TextWordWrap, notice.text);
}

void paintWaiting(QPainter& painter, const QRectF& rect, const Notice& notice) {
    paintPanel(painter, rect);
    painter.setFont(noticeFont(false));
    painter.setPen(QColor(95, 98, 106));
    painter.drawText(rect.adjusted(16, 12, -16, -12), Qt::AlignCenter | Qt::TextWordWrap,
                     notice.text.isEmpty() ? notice.title : notice.text);
}

// Words on an empty stage.
void paintEmpty(QPainter& painter, const QRectF& rect, const Notice& notice) {
    const QRectF inside = rect.adjusted(18, 16, -18, -16);
    painter.setFont(noticeFont(true));
    painter.setPen(QColor(50, 52, 58));
    const QRectF title = painter.boundingRect(inside, Qt::TextWordWrap, notice.title);
    painter.setFont(noticeFont(false));
    const QRectF text = painter.boundingRect(inside, Qt::TextWordWrap, notice.text);
    constexpr double gap = 6;
    QRectF line = inside;
    line.setTop(inside.top() +
                std::max(0.0, (inside.height() - title.height() - gap - text.height()) / 2));
    constexpr int flags = Qt::AlignHCenter | Qt::AlignTop | Qt::TextWordWrap;
    painter.setFont(noticeFont(true));
    painter.drawText(line, flags, notice.title);
    line.setTop(line.top() + title.height() + gap);
    painter.setFont(noticeFont(false));
    painter.setPen(QColor(95, 98, 106));
    painter.drawText(line, flags, notice.text);
}

void paintNote(QPainter& painter, const QRectF& rect, const Notice& notice) {
    painter.setFont(noticeFont(false));
    constexpr int mostLines = 4; // of a sentence that may be long; more would hide the picture
    const QRectF room(rect.left() + 20, rect.top() + 15, std::max(20.0, rect.width() - 40),
                      mostLines * QFontMetricsF(painter.font()).lineSpacing());
    const QRectF text = painter.boundingRect(room, Qt::TextWordWrap, notice.title) & room;
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(24, 25, 28, 200));
    painter.drawRoundedRect(text.adjusted(-10, -5, 10, 5), 13, 13);
    painter.setPen(Qt::white);
    painter.drawText(text.adjusted(0, 0, 1, 1), Qt::TextWordWrap, notice.title);
}

// The last picture, paled, and a strip that says what happened.
void paintStopped(QPainter& painter, const QRectF& rect, const Notice& notice) {
    painter.fillRect(rect, QColor(255, 255, 255, 110));
    painter.setFont(noticeFont(true));
    const QRectF room = rect.adjusted(16, 0, -16, 0);
    const QRectF title = painter.boundingRect(room, Qt::TextWordWrap, notice.title);
    painter.setFont(noticeFont(false));
    const QRectF text = painter.boundingRect(room, Qt::TextWordWrap, notice.text);
    QRectF strip = rect;
    strip.setTop(std::max(rect.top(), rect.bottom() - title.height() - text.height() - 26));
    painter.fillRect(strip, QColor(24, 25, 28, 215));
    QRectF inside = strip.adjusted(16, 10, -16, -8);
    painter.setFont(noticeFont(true));
    painter.setPen(Qt::white);
    painter.drawText(inside, Qt::TextWordWrap, notice.title);
    inside.setTop(inside.top() + title.height() + 4);
    painter.setFont(noticeFont(false));
    painter.setPen(QColor(200, 203, 210));
    painter.drawText(inside, Qt::TextWordWrap, notice.text);
}

Notice faultNotice(const std::vector<session::ListedFault>& faults, bool hasPicture,
                   const QString& medium) {
    const auto isError = [](const session::ListedFault& fault) { return fault.isError; };
    const auto first = std::find_if(faults.begin(), faults.end(), isError);
    if (first == faults.end())
        return {};
    const auto count = std::count_if(faults.begin(), faults.end(), isError);
    const QString place = first->position.line > 0 ? QObject::tr("Line %1, column %2: ")
                                                         .arg(first->position.line)
                                                         .arg(first->position.column)
                                                   : QString();
    const QString more = count > 1 ? QObject::tr(" (and %1 more)").arg(count - 1) : QString();
    if (hasPicture)
        return {Notice::Kind::note, place + first->message + more, {}};
    return {Notice::Kind::box, QObject::tr("%1 cannot show this text.").arg(medium),
            place + first->message + more};
}

} // namespace

Notice noticeOf(const session::OpenDocument& document, const Shown& shown) {
    const document::Subdocument* subdocument = document.document().subdocument(shown.id);
    const QString alternative =
        subdocument ? QString::fromStdString(subdocument->alternative) : QString();
    const media::LiveSubdocument* live = document.live(shown.id);
    if (!live)
        return {Notice::Kind::box, document.whyNotLive(shown.id), alternative};
    const bool hasPicture = shown.rendition && !shown.rendition->picture().isNull();
    switch (live->condition()) {
    case media::Condition::failed:
        return {hasPicture ? Notice::Kind::stopped : Notice::Kind::box, live->reason(),
                live->mayStart() ? QObject::tr("Click to start it again.") : QString()};
    case media::Condition::notResponding:
        return {Notice::Kind::note, QObject::tr("%1 is not responding").arg(live->name()), {}};
    case media::Condition::starting:
    case media::Condition::still:
        if (hasPicture)
            return live->reason().isEmpty()
                       ? Notice{}
                       : Notice{Notice::Kind::note,
                                QObject::tr("%1 Starting it again").arg(live->reason()),
                                {}};
        return {Notice::Kind::waiting, QObject::tr("%1 is starting").arg(live->name()),
                alternative};
    case media::Condition::live:
        break;
    }
    const bool isDrawn = hasPicture && !looksEmpty(shown.rendition->picture());
    Notice fault = faultNotice(document.faultsOf(shown.id), isDrawn, live->name());
    if (fault.kind == Notice::Kind::none && !hasPicture)
        return {Notice::Kind::waiting, QObject::tr("%1 is drawing").arg(live->name()), alternative};
    if (fault.kind == Notice::Kind::none && !live->notice().isEmpty())
        return {Notice::Kind::note, live->notice(), {}};
    if (const QString empty = document.emptyNotice(shown.id);
        fault.kind == Notice::Kind::none && !empty.isEmpty())
        return {
            Notice::Kind::empty, empty,
            QObject::tr("Click here, then Figure > Edit opens the window in which it is built.")};
    return fault;
}

void paintShown(QPainter& painter, const QRectF& rect, const Shown& shown, const Notice& notice,
                bool chosen) {
    painter.save();
    painter.setClipRect(rect.adjusted(-4, -4, 4, 4), Qt::IntersectClip);
    if (shown.rendition && !shown.rendition->picture().isNull())
        painter.drawImage(rect, shown.rendition->picture());
    painter.setRenderHint(QPainter::Antialiasing);
    switch (notice.kind) {
    case Notice::Kind::none:
        break;
    case Notice::Kind::waiting:
        paintWaiting(painter, rect, notice);
        break;
    case Notice::Kind::empty:
        paintEmpty(painter, rect, notice);
        break;
    case Notice::Kind::note:
        paintNote(painter, rect, notice);
        break;
    case Notice::Kind::box:
        paintPanel(painter, rect);
        paintWords(painter, rect, notice);
        break;
    case Notice::Kind::stopped:
        paintStopped(painter, rect, notice);
        break;
    }
    if (chosen) {
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(controls::accent, 2));
        painter.drawRoundedRect(rect.adjusted(-2, -2, 2, 2), 3, 3);
    }
    painter.restore();
}

} // namespace view
