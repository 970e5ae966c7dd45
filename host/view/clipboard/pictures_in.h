// Pictures that come from other programs, by the clipboard or by a drop.
#pragma once

#include "session/picture_home.h"

#include <QMimeData>

namespace view {

// Files of pictures, or a picture itself. Text that comes with one counts more.
[[nodiscard]] bool holdsPictures(const QMimeData& data);

// Keeps them; the first one that is not kept ends it.
struct Pictures {
    std::vector<std::string> sources;
    QString fault;
};
[[nodiscard]] Pictures taken(const QMimeData& data, const session::PictureHome& home);

} // namespace view
