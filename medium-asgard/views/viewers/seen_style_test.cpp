// Boxes to tick and buttons of panes on dark windows.
#include "frame/readable.h"
#include "frame/seen_style.h"
#include "views/test_desk.h"

#include <gtest/gtest.h>

#include <QPainter>
#include <QStyleOption>

#include <algorithm>

namespace views {
namespace {

constexpr double seenContrast = 3; // of marks, as the Web Content Accessibility Guidelines say

QPalette night() {
    QPalette palette(QColor(42, 46, 50), QColor(42, 46, 50));
    palette.setColor(QPalette::Base, QColor(27, 30, 32));
    for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
        palette.setColor(role, QColor(252, 252, 252));
    return palette;
}

double bestContrast(const QImage& image, const QColor& paper) {
    double best = 1;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            best = std::max(best, contrast(image.pixelColor(x, y), paper));
    return best;
}

TEST(SeenStyleTest, WhatIsNotTickedIsSeenOnADarkWindow) {
    theApplication();
    const SeenStyle style;
    for (const auto element : {QStyle::PE_IndicatorCheckBox, QStyle::PE_IndicatorRadioButton,
                               QStyle::PE_IndicatorItemViewItemCheck}) {
        QImage image(24, 24, QImage::Format_RGB32);
        image.fill(night().color(QPalette::Window));
        QStyleOptionButton option;
        option.rect = QRect(4, 4, 14, 14);
        option.palette = night();
        option.state = QStyle::State_Enabled | QStyle::State_Off;
        QPainter painter(&image);
        style.drawPrimitive(element, &option, &painter, nullptr);
        painter.end();
        EXPECT_GT(bestContrast(image, night().color(QPalette::Window)), seenContrast) << element;
    }
}

// A desktop's style that knows light windows only.
class BlackIcons : public QProxyStyle {
public:
    [[nodiscard]] QIcon standardIcon(StandardPixmap, const QStyleOption*,
                                     const QWidget*) const override {
        QPixmap black(16, 16);
        black.fill(Qt::black);
        return QIcon(black);
    }
};

TEST(SeenStyleTest, TheButtonsOfPanesAreSeenOnADarkWindow) {
    theApplication();
    const SeenStyle style(new BlackIcons);
    QWidget dark;
    dark.setPalette(night());
    for (const auto which : {QStyle::SP_TitleBarCloseButton, QStyle::SP_TitleBarNormalButton}) {
        QImage image(16, 16, QImage::Format_RGB32);
        image.fill(night().color(QPalette::Window));
        QPainter painter(&image);
        style.standardIcon(which, nullptr, &dark).paint(&painter, image.rect());
        painter.end();
        EXPECT_GT(bestContrast(image, night().color(QPalette::Window)), seenContrast) << which;
    }
}

} // namespace
} // namespace views
