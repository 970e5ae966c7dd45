#include "frame/seen_style.h"

#include "frame/icons.h"

#include <QApplication>
#include <QPainter>
#include <QStyleOption>

namespace views {

namespace {

bool isDark(const QPalette& palette) { return palette.color(QPalette::Window).lightness() < 128; }

} // namespace

void SeenStyle::drawPrimitive(PrimitiveElement element, const QStyleOption* option,
                              QPainter* painter, const QWidget* widget) const {
    QProxyStyle::drawPrimitive(element, option, painter, widget);
    const bool isRound = element == PE_IndicatorRadioButton;
    const bool isBox = element == PE_IndicatorCheckBox || element == PE_IndicatorItemViewItemCheck;
    if ((!isRound && !isBox) || !isDark(option->palette))
        return;
    QColor rim = option->palette.color(QPalette::WindowText);
    rim.setAlphaF((option->state & State_Enabled) ? 0.6F : 0.3F);
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    painter->setPen(rim);
    painter->setBrush(Qt::NoBrush);
    const QRectF box = QRectF(option->rect).adjusted(0.5, 0.5, -0.5, -0.5);
    if (isRound)
        painter->drawEllipse(box);
    else
        painter->drawRoundedRect(box, 2, 2);
    painter->restore();
}

QIcon SeenStyle::standardIcon(StandardPixmap which, const QStyleOption* option,
                              const QWidget* widget) const {
    const QPalette palette = widget ? widget->palette() : QApplication::palette();
    if (which == SP_TitleBarCloseButton)
        return icon(Icon::close, palette);
    if (which == SP_TitleBarNormalButton)
        return icon(Icon::tearOff, palette);
    return QProxyStyle::standardIcon(which, option, widget);
}

} // namespace views
