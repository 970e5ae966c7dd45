// Formulas on screen and paper: always as outlines.
#pragma once

#include "formulas/typeset.h"

#include <QColor>

class QPainter;

namespace formulas {

// `at`: the left end of its base line. A part that could not be read has a colour of its own.
void paint(QPainter& painter, const Box& box, QPointF at, const Font& font, const QColor& ink,
           const QColor& faulty);

} // namespace formulas
