// For tests: can every text of a window be read? The contrast of texts, measured where they are
// painted.
//
// WCAG 2.1, 1.4.3: at least 4.5 to 1, but for what is disabled.
#pragma once

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QGroupBox>
#include <QImage>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QPainter>
#include <QStatusBar>
#include <QWidget>

#include <cmath>
#include <map>
#include <string>
#include <vector>

namespace plain {

constexpr double leastContrast = 4.5;

inline double luminance(QRgb color) {
    const auto linear = [](int part) {
        const double c = part / 255.0;
        return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(qRed(color)) + 0.7152 * linear(qGreen(color)) +
           0.0722 * linear(qBlue(color));
}

inline double contrast(QRgb a, QRgb b) {
    const double light = std::max(luminance(a), luminance(b));
    return (light + 0.05) / (std::min(luminance(a), luminance(b)) + 0.05);
}

// Between the colour that most of the rectangle has and the one that differs most from it: the
// core of the letters, where they are painted large enough to have one.
inline double contrastIn(const QImage& image, QRect place) {
    std::map<QRgb, int> counts;
    place &= image.rect();
    for (int y = place.top(); y <= place.bottom(); ++y)
        for (int x = place.left(); x <= place.right(); ++x)
            ++counts[image.pixel(x, y)];
    QRgb ground = 0;
    int most = 0;
    for (const auto& [color, count] : counts)
        if (count > most) {
            ground = color;
            most = count;
        }
    double best = 1;
    for (const auto& one : counts)
        best = std::max(best, contrast(one.first, ground));
    return best;
}

// As it is painted, four times as large: then letters have a core of their own colour.
inline QImage enlarged(QWidget& window) {
    constexpr int factor = 4;
    QImage image(window.size() * factor, QImage::Format_RGB32);
    image.setDevicePixelRatio(factor);
    image.fill(window.palette().color(QPalette::Window));
    window.render(&image);
    return image;
}

struct PaintedText {
    std::string text;
    double contrast = 0;
};

// Every text of a window that is shown, with its contrast.
inline std::vector<PaintedText> textsOf(QWidget& window) {
    const QImage image = enlarged(window);
    std::vector<PaintedText> all;
    const auto add = [&](const QString& text, const QWidget& in, const QRect& place) {
        const QRect at(in.mapTo(&window, place.topLeft()), place.size());
        const double factor = image.devicePixelRatio();
        if (!text.trimmed().isEmpty() && !place.isEmpty())
            all.push_back(
                {in.metaObject()->className() + std::string(" \"") + text.toStdString() + "\"",
                 contrastIn(image, QRect((QPointF(at.topLeft()) * factor).toPoint(),
                                         at.size() * factor))});
    };
    const auto look = [&](QWidget& widget) {
        if (auto* label = qobject_cast<QLabel*>(&widget)) {
            add(label->text(), widget, widget.rect());
        } else if (auto* button = qobject_cast<QAbstractButton*>(&widget)) {
            if (button->isEnabled())
                add(button->text(), widget, widget.rect());
        } else if (auto* field = qobject_cast<QLineEdit*>(&widget)) {
            if (field->isEnabled())
                add(field->text().isEmpty() ? field->placeholderText() : field->text(), widget,
                    widget.rect().adjusted(4, 4, -4, -4));
        } else if (auto* bar = qobject_cast<QMenuBar*>(&widget)) {
            for (QAction* action : bar->actions())
                if (action->isEnabled())
                    add(action->text(), widget, bar->actionGeometry(action));
        } else if (auto* menu = qobject_cast<QMenu*>(&widget)) {
            for (QAction* action : menu->actions())
                if (action->isEnabled())
                    add(action->text(), widget, menu->actionGeometry(action));
        } else if (auto* group = qobject_cast<QGroupBox*>(&widget)) {
            add(group->title(), widget, QRect(0, 0, group->width(), group->fontMetrics().height()));
        } else if (auto* status = qobject_cast<QStatusBar*>(&widget)) {
            add(status->currentMessage(), widget,
                QRect(0, 0, status->width() / 2, status->height()));
        } else if (auto* view = qobject_cast<QAbstractItemView*>(&widget)) {
            for (int row = 0; view->model() && row < view->model()->rowCount(); ++row)
                for (int column = 0; column < view->model()->columnCount(); ++column) {
                    const QModelIndex index = view->model()->index(row, column);
                    const QRect place = view->visualRect(index) & view->viewport()->rect();
                    add(index.data().toString(), *view->viewport(), place);
                }
        }
    };
    look(window);
    for (QWidget* widget : window.findChildren<QWidget*>())
        if (widget->isVisibleTo(&window) && widget->width() > 0 && widget->height() > 0)
            look(*widget);
    return all;
}

} // namespace plain
