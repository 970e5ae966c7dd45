// A dialog that asks for an image's description in words, its caption and its width.
#pragma once

#include <QImage>
#include <QString>

#include <optional>

class QWidget;

namespace menus {

struct ImageWishes {
    QString alternative;
    QString caption; // one line
    int width = 0;   // 1/96 inch; 0: its own
};

// Nothing: all is to stay. `picture`: a small one of it; `hasCaption`: one is asked for.
[[nodiscard]] std::optional<ImageWishes> askAboutImage(const QString& title, const QImage& picture,
                                                       const ImageWishes& now, bool hasCaption,
                                                       QWidget* parent);

} // namespace menus
