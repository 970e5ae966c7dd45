// How one subdocument's place in a view looks: its picture, and over it what the reader must know.
//
// Picture and medium alive: the picture alone. No picture yet: the ALT text or that the medium
// starts. A medium that does not respond: a note in the corner. One that ended: its last picture,
// what happened, and that a click starts it again. A faulty text: its first fault with the place in
// the file. A text that is still empty: that it is, and how one begins.
#pragma once

#include "media/live_subdocument.h"
#include "session/open_document.h"

#include <QPainter>

namespace view {

struct Shown {
    document::SubdocumentId id = document::noSubdocument;
    std::size_t page = 0;
    QRectF onPage; // twips
    std::unique_ptr<media::Rendition> rendition;
    std::unique_ptr<QObject> context; // of its connections
};

// The words over or instead of its picture.
struct Notice {
    enum class Kind { none, waiting, empty, note, box, stopped };
    Kind kind = Kind::none;
    QString title, text;
};
[[nodiscard]] Notice noticeOf(const session::OpenDocument& document, const Shown& shown);

// `rect` in logical pixels, on device pixels.
void paintShown(QPainter& painter, const QRectF& rect, const Shown& shown, const Notice& notice,
                bool chosen);

} // namespace view
