#include "frame/readable.h"

#include <QApplication>
#include <QEvent>
#include <QPalette>

#include <algorithm>
#include <cmath>

namespace views {

namespace {

double luminance(const QColor& color) {
    const auto linear = [](double part) {
        return part <= 0.03928 ? part / 12.92 : std::pow((part + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(color.redF()) + 0.7152 * linear(color.greenF()) +
           0.0722 * linear(color.blueF());
}

// `share` of the one, the rest of the other.
QColor mixed(const QColor& one, const QColor& other, double share) {
    const auto part = [&](double a, double b) {
        return static_cast<float>(share * a + (1 - share) * b);
    };
    return QColor::fromRgbF(part(one.redF(), other.redF()), part(one.greenF(), other.greenF()),
                            part(one.blueF(), other.blueF()));
}

} // namespace

double contrast(const QColor& one, const QColor& other) {
    const double a = luminance(one), b = luminance(other);
    return (std::max(a, b) + 0.05) / (std::min(a, b) + 0.05);
}

QColor readable(const QColor& ink, const QColor& paper) {
    const QColor end =
        contrast(Qt::white, paper) > contrast(Qt::black, paper) ? Qt::white : Qt::black;
    QColor found = mixed(ink, paper, ink.alphaF());
    constexpr int steps = 20;
    for (int step = 1; step <= steps && contrast(found, paper) < readableContrast; ++step)
        found = mixed(end, mixed(ink, paper, ink.alphaF()), static_cast<double>(step) / steps);
    return found.toRgb();
}

ReadablePalette::ReadablePalette(QObject* parent) : QObject(parent) {
    qApp->installEventFilter(this);
    adapt();
}

void ReadablePalette::adapt() {
    struct Pair {
        QPalette::ColorRole ink, paper;
    };
    constexpr Pair pairs[] = {{QPalette::WindowText, QPalette::Window},
                              {QPalette::Text, QPalette::Base},
                              {QPalette::ButtonText, QPalette::Button},
                              {QPalette::ToolTipText, QPalette::ToolTipBase},
                              {QPalette::HighlightedText, QPalette::Highlight},
                              {QPalette::PlaceholderText, QPalette::Window},
                              {QPalette::PlaceholderText, QPalette::Base},
                              {QPalette::Link, QPalette::Base},
                              {QPalette::LinkVisited, QPalette::Base}};
    const QPalette now = QApplication::palette();
    QPalette changed; // the theme still says the rest
    bool any = false;
    for (const auto group : {QPalette::Active, QPalette::Inactive})
        for (const auto& [ink, paper] : pairs) {
            const bool known = changed.isBrushSet(group, ink);
            const QColor is = (known ? changed : now).color(group, ink);
            if (ink == QPalette::HighlightedText) { // white stays white: blue gets darker
                changed.setColor(group, paper, readable(now.color(group, paper), is));
                any = any || changed.color(group, paper).rgba() != now.color(group, paper).rgba();
                continue;
            }
            const QColor made = readable(is, now.color(group, paper));
            if (made.rgba() == is.rgba())
                continue;
            changed.setColor(group, ink, made);
            any = true;
        }
    if (!any)
        return;
    adapting_ = true;
    QApplication::setPalette(changed.resolve(now));
    adapting_ = false;
}

bool ReadablePalette::eventFilter(QObject* watched, QEvent* event) {
    if (watched == qApp && event->type() == QEvent::ApplicationPaletteChange && !adapting_)
        adapt();
    return false;
}

} // namespace views
