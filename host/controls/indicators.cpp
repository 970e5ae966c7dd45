#include "controls/indicators.h"

#include <QPainter>
#include <QStyleOption>

namespace controls {

namespace {

// Between the text's colour and that of its ground, nearer to the text.
QColor edgeOf(const QPalette& palette) {
    constexpr double share = 0.65;
    const QColor text = palette.color(QPalette::WindowText), ground = palette.color(QPalette::Base);
    const auto mixed = [](int a, int b) { return qRound(share * a + (1 - share) * b); };
    return {mixed(text.red(), ground.red()), mixed(text.green(), ground.green()),
            mixed(text.blue(), ground.blue())};
}

} // namespace

IndicatorStyle::IndicatorStyle() : QProxyStyle("fusion") {}

void IndicatorStyle::drawPrimitive(PrimitiveElement element, const QStyleOption* option,
                                   QPainter* painter, const QWidget* widget) const {
    QProxyStyle::drawPrimitive(element, option, painter, widget);
    const bool isRound = element == PE_IndicatorRadioButton;
    const bool isMark =
        isRound || element == PE_IndicatorCheckBox || element == PE_IndicatorItemViewItemCheck;
    if (!isMark || !(option->state & State_Enabled))
        return;
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    painter->setPen(edgeOf(option->palette));
    painter->setBrush(Qt::NoBrush);
    if (isRound) {
        const double radius = std::min(option->rect.width(), option->rect.height()) / 2.0 - 1;
        painter->drawEllipse(QRectF(option->rect).center(), radius, radius);
    } else {
        painter->drawRoundedRect(QRectF(option->rect).adjusted(0.5, 0.5, -0.5, -0.5), 1.5, 1.5);
    }
    painter->restore();
}

} // namespace controls
