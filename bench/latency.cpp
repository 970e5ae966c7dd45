// What an author waits for at a handle: from a movement of the pointer to the picture in which the
// handle has moved, and to the one that shows the new motion. Drives a real graphical viewer with
// a language viewer beside it, without a display; the clock on the wall, since a picture, an
// evaluator and the engine's thread are waited for. The goals are one and two frames of a display
// of 60 Hz, at the 95th percentile.
//
//     bench_latency SCENE.al [--smoke]       Figure 4.6's scene
//
// And how long the interface's thread is held up in a scene of 3000 bodies (crowd.h): 50 ms at
// most, is the goal.
#include "computing/tools.h"
#include "crowd.h"
#include "paints.h"

#include "script/reader.h"
#include "viewers/editor.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QEventLoop>
#include <QMouseEvent>

#include <algorithm>
#include <cstdio>
#include <cstdlib>

namespace {

using bench::Measurement;
using Clock = std::chrono::steady_clock;

[[noreturn]] void stop(const char* why) {
    std::fprintf(stderr, "bench_latency: %s\n", why);
    std::exit(1);
}

double between(Clock::time_point begin, Clock::time_point end) {
    return std::chrono::duration<double>(end - begin).count();
}

void handleEventsUntil(const std::function<bool()>& condition) {
    const auto begin = Clock::now();
    while (!condition()) {
        if (between(begin, Clock::now()) > 20)
            stop("waited for 20 s for a handle, a picture or a motion");
        QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents, 50);
    }
}

struct Latencies {
    std::vector<double> toHandle, toMotion; // seconds
};

class Drag {
public:
    Drag(views::Editor& editor, views::GraphicalViewer& viewer)
        : document_(editor.document()), display_(viewer.display()), paints_(display_) {
        QObject::connect(&document_, &views::SceneDocument::motionChanged, [this] {
            ++motions_;
            paintsBefore_ = paints_.count;
        });
    }

    Latencies measure(render::HandleKind kind, std::size_t element, int moves) {
        const QPointF start = placeOf(kind, element);
        send(QEvent::MouseButtonPress, start, Qt::LeftButton);
        Latencies all;
        for (int i = 1; i <= moves; ++i) {
            const int moved = motions_;
            const std::string text = document_.text();
            paints_.await();
            const auto begin = Clock::now();
            // To and fro, so that the scene stays one of its kind.
            send(QEvent::MouseMove, start + 3 * QPointF(i % 40 < 20 ? i % 20 : 20 - i % 20, i % 7),
                 Qt::NoButton);
            handleEventsUntil([&] { return paints_.came(); });
            all.toHandle.push_back(between(begin, paints_.first)); // drawn over the picture
            if (document_.text() == text)
                continue; // a snap holds it: the motion stays as it is
            handleEventsUntil([&] {
                return motions_ > moved && document_.sceneIsCurrent() &&
                       document_.work() == views::Work::none;
            });
            handleEventsUntil(
                [&] { return paints_.count > paintsBefore_ && display_.showsNewest(); });
            all.toMotion.push_back(between(begin, paints_.last));
        }
        send(QEvent::MouseButtonRelease, start, Qt::LeftButton);
        handleEventsUntil([&] { return document_.work() == views::Work::none; });
        return all;
    }

private:
    QPointF placeOf(render::HandleKind kind, std::size_t element) {
        QPointF place;
        handleEventsUntil([&] {
            for (const render::Handle& handle : display_.handles().handles)
                if (handle.kind == kind && handle.element == element) {
                    place = display_.fromPixels(display_.sight().pixels(handle.place));
                    return true;
                }
            return false;
        });
        return place;
    }
    void send(QEvent::Type type, const QPointF& at, Qt::MouseButton button) {
        QMouseEvent event(type, at, display_.mapToGlobal(at), button, Qt::LeftButton,
                          Qt::ShiftModifier);
        QCoreApplication::sendEvent(&display_, &event);
    }

    views::SceneDocument& document_;
    views::SceneDisplay& display_;
    bench::Paints paints_;
    int motions_ = 0, paintsBefore_ = 0; // paints, when the last motion came
};

void add(const Measurement& m, const std::string& what, std::vector<double> seconds) {
    if (seconds.empty())
        stop("no move of a drag changed the motion");
    std::ranges::sort(seconds);
    const auto at = [&](double share) {
        return seconds[static_cast<std::size_t>(share * static_cast<double>(seconds.size() - 1))];
    };
    char note[80];
    std::snprintf(note, sizeof note, "wall; 95 of 100 within %.4g ms; %zu moves", 1e3 * at(0.95),
                  seconds.size());
    m.add({"Figure 4.6", what, 0, 0, {at(0.5), seconds.front()}, note});
}

} // namespace

int main(int argc, char** argv) {
    if (argc < 2) {
        std::fputs("usage: bench_latency SCENE.al [--smoke]\n", stderr);
        return 2;
    }
    qputenv("QT_QPA_PLATFORM", "offscreen");
    script::Reader reader;
    const Measurement m("latency", argc - 1, argv + 1);
    int count = 1;
    QApplication application(count, argv);
    std::setlocale(LC_NUMERIC, "C");
    m.add({"calibration", "sine and division", 0, 0, bench::calibration(m), ""});
    bench::measureCrowd(m, reader, m.smoke() ? 100 : 3000);
    views::Editor editor(computing::toolsOf(reader));
    if (const QString fault = editor.document().open(QString::fromLocal8Bit(argv[1]));
        !fault.isEmpty())
        stop(qPrintable(fault));
    views::GraphicalViewer& viewer = *editor.openGraphicalViewer();
    editor.openLanguageViewer();
    render::Display shown = viewer.display().display();
    shown.positionHandles = shown.velocityHandles = true;
    viewer.display().setDisplay(shown);
    handleEventsUntil([&] {
        return editor.document().work() == views::Work::none && editor.document().sceneIsCurrent();
    });
    Drag drag(editor, viewer);
    const int moves = m.smoke() ? 12 : 400;
    const Latencies velocity = drag.measure(render::HandleKind::velocity, 2, moves);
    add(m, "velocity dragged, to the moved handle", velocity.toHandle);
    add(m, "velocity dragged, to the new motion", velocity.toMotion);
    const Latencies place = drag.measure(render::HandleKind::position, 0, moves);
    add(m, "rod dragged, to the moved handle", place.toHandle);
    add(m, "rod dragged, to the new motion", place.toMotion);
    m.add({"calibration", "sine and division", 1, 0, bench::calibration(m), ""});
    return 0;
}
