// How often a widget is painted, and when: other windows may be painted before the events are
// through.
#pragma once

#include <QEvent>
#include <QWidget>

#include <chrono>

namespace bench {

class Paints : public QObject {
public:
    explicit Paints(QWidget& of) { of.installEventFilter(this); }
    bool eventFilter(QObject* of, QEvent* event) override {
        if (event->type() != QEvent::Paint)
            return false;
        of->event(event);
        last = std::chrono::steady_clock::now();
        if (++count == awaited)
            first = last;
        return true;
    }
    // From now on.
    void await() { awaited = count + 1; }
    [[nodiscard]] bool came() const { return count >= awaited; }

    int count = 0, awaited = 0;
    std::chrono::steady_clock::time_point first, last;
};

} // namespace bench
