#include "navigation/kept_place.h"

#include "view/folds.h"
#include "view/text_hand.h"

#include <QEvent>
#include <QFileInfo>
#include <QScrollBar>
#include <QSettings>

namespace navigation {

namespace {

constexpr auto list = "places", fileKey = "file", placeKey = "place", belowKey = "below",
               pageKey = "page", zoomKey = "zoom", foldsKey = "folds", caretKey = "caret";

// By which a file is known, however it is named. A document without a file has none: "".
QString nameOf(const view::DocumentView& view) {
    return QFileInfo(view.document().document().fileName()).canonicalFilePath();
}

using Entry = QVariantMap;

QList<Entry> entries() {
    QList<Entry> result;
    for (const QVariant& one : QSettings().value(list).toList())
        result << one.toMap();
    return result;
}

} // namespace

KeptPlace::KeptPlace(view::DocumentView& view, QObject* parent) : QObject(parent), view_(view) {
    view_.installEventFilter(this);
    connect(&view_, &view::DocumentView::laidOut, this, &KeptPlace::restore);
}

bool KeptPlace::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Show && !event->spontaneous())
        // The view itself comes to its usual size first.
        QMetaObject::invokeMethod(this, &KeptPlace::recall, Qt::QueuedConnection);
    if (event->type() == QEvent::Hide && !event->spontaneous())
        keep();
    return QObject::eventFilter(watched, event);
}

void KeptPlace::recall() {
    const QString file = nameOf(view_);
    if (file.isEmpty() || view_.verticalScrollBar()->value() > 0)
        return;
    for (const Entry& one : entries())
        if (one.value(fileKey).toString() == file) {
            Kept kept;
            kept.place = {one.value(placeKey).toULongLong(), one.value(belowKey).toDouble()};
            kept.page = one.value(pageKey).toULongLong();
            kept.zoom = one.value(zoomKey).toDouble();
            if (one.contains(caretKey))
                kept.caret = one.value(caretKey).toULongLong();
            wanted_ = kept;
            std::vector<std::size_t> folds;
            for (const QVariant& fold : one.value(foldsKey).toList())
                folds.push_back(fold.toULongLong());
            if (!folds.empty())
                view_.folds().pages().restore(folds);
            view_.setZoom(kept.zoom);
            view_.verticalScrollBar()->setValue(0); // it kept the middle of the first page
            restore();
            return;
        }
}

void KeptPlace::restore() {
    if (!wanted_)
        return;
    if (view_.verticalScrollBar()->value() > 0) { // the reader went on meanwhile
        writeAgain(*std::exchange(wanted_, std::nullopt));
        return;
    }
    if (!view_.isLaidOut() && view_.pages().pages.size() <= wanted_->page + 1)
        return;
    const std::size_t size = view_.document().document().bytes().size();
    const Kept kept = *std::exchange(wanted_, std::nullopt);
    view_.show({std::min(kept.place.place, size), kept.place.below});
    writeAgain(kept);
}

// A caret that is in the document already stays.
void KeptPlace::writeAgain(const Kept& kept) {
    if (!kept.caret)
        return;
    const std::size_t caret = std::min(*kept.caret, view_.document().document().bytes().size());
    if (!view_.text().cursor().selection())
        view_.text().cursor().set({caret, caret});
    view_.setWriting(true);
}

void KeptPlace::keep() const {
    const QString file = nameOf(view_);
    const std::optional<view::ReadingPlace> place = view_.readingPlace();
    if (file.isEmpty() || !place)
        return;
    QVariantList folds;
    for (const std::size_t fold : view_.folds().pages().places())
        folds << static_cast<qulonglong>(fold);
    Entry own{{fileKey, file},          {placeKey, static_cast<qulonglong>(place->place)},
              {belowKey, place->below}, {pageKey, static_cast<qulonglong>(view_.currentPage())},
              {zoomKey, view_.zoom()},  {foldsKey, folds}};
    if (const auto at = view_.text().cursor().selection(); at && view_.isWriting())
        own[caretKey] = static_cast<qulonglong>(at->caret);
    QVariantList kept{own};
    for (const Entry& one : entries())
        if (one.value(fileKey).toString() != file && kept.size() < most)
            kept << one;
    QSettings().setValue(list, kept);
}

} // namespace navigation
