// The desktop's style, but for what it draws too dark to be seen on a dark window: the boxes of
// check boxes and radio buttons, and the buttons of panes.
#pragma once

#include <QProxyStyle>

namespace views {

class SeenStyle : public QProxyStyle {
    Q_OBJECT
public:
    using QProxyStyle::QProxyStyle;
    void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                       const QWidget* widget) const override;
    [[nodiscard]] QIcon standardIcon(StandardPixmap which, const QStyleOption* option,
                                     const QWidget* widget) const override;
};

} // namespace views
