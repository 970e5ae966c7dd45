// Lengths. The layout counts in twips, 1440 to the inch; documents in points; screens in 1/96 inch.
#pragma once

#include <QSizeF>

namespace paragraphs {

inline constexpr double twipsPerInch = 1440;
inline constexpr double twipsPerPoint = 20;
inline constexpr double twipsPerPixel = 15; // of 1/96 inch

inline double fromPoints(double points) { return points * twipsPerPoint; }
inline QSizeF fromPixels(QSizeF size) { return size * twipsPerPixel; }
inline QSizeF toPixels(QSizeF size) { return size / twipsPerPixel; }

} // namespace paragraphs
