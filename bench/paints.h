// How often a widget is painted, and when: other windows may be painted before the events are
// through. An awaited paint covers `within` (where that is empty: any part of the widget).
#pragma once

#include <QCoreApplication>
#include <QPaintEvent>
#include <QWidget>

#include <chrono>

namespace bench {

class Paints : public QObject {
public:
    explicit Paints(QWidget& of) { of.installEventFilter(this); }
    bool eventFilter(QObject* of, QEvent* event) override {
        if (event->type() != QEvent::Paint)
            return false;
        of->removeEventFilter(this);
        QCoreApplication::sendEvent(of, event); // also to who paints a viewport, by a filter
        of->installEventFilter(this);
        last = std::chrono::steady_clock::now();
        ++count;
        const QRegion painted = static_cast<QPaintEvent*>(event)->region();
        if (!came_ && (within.isEmpty() || painted.contains(within))) {
            came_ = true;
            first = last;
        }
        return true;
    }
    // From now on.
    void await() { came_ = false; }
    [[nodiscard]] bool came() const { return came_; }

    QRect within;
    int count = 0;
    std::chrono::steady_clock::time_point first, last;

private:
    bool came_ = true;
};

} // namespace bench
