#include "crowd.h"
#include "computing/tools.h"

#include "script/reader.h"
#include "viewers/editor.h"

#include <QApplication>
#include <QMouseEvent>
#include <QThread>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <map>

namespace bench {

namespace {

std::string crowd(int bodies) {
    std::string text = "simulator -finish 1 -collisions 0\n"
                       "shape_set ball -desc {-sub {-sphere 0.3}}\n";
    for (int i = 0; i < bodies; ++i)
        text += "body b" + std::to_string(i) + " ball -init_pos {" + std::to_string(i % 60) + " " +
                std::to_string(i / 60) + " 0} -init_dpos {0 0 1}\n";
    return text;
}

// Of what is done under a name every piece.
class Pieces {
public:
    void of(const std::string& name, const std::function<void()>& work) {
        all_[name].push_back(seconds(work));
    }
    void eventsUntil(const std::string& name, const std::function<bool()>& condition) {
        const double began = cpuSeconds();
        while (!condition()) {
            if (cpuSeconds() - began > 60)
                std::exit((std::fprintf(stderr, "bench_latency: nothing happens\n"), 1));
            of(name, [] { QCoreApplication::processEvents(); });
            QThread::msleep(1); // waiting costs nothing; all that comes meanwhile is one piece
        }
    }
    void report(const Measurement& m, int bodies) {
        for (auto& [name, pieces] : all_) {
            std::ranges::sort(pieces);
            m.add({std::to_string(bodies) + " bodies",
                   name,
                   0,
                   0,
                   {pieces[pieces.size() / 2], pieces.front()},
                   "longest " + std::to_string(1e3 * pieces.back()) + " ms of " +
                       std::to_string(pieces.size())});
        }
    }

private:
    std::map<std::string, std::vector<double>> all_;
};

void drag(views::SceneDisplay& display, int body, Pieces& pieces) {
    const geometry::Vector place(body % 60, body / 60, 0); // of the crowd
    const QPoint from = display.fromPixels(display.sight().pixels(place)).toPoint();
    const auto send = [&](QEvent::Type type, QPoint at, Qt::MouseButton button) {
        QMouseEvent event(type, at, display.mapToGlobal(at), button, Qt::LeftButton,
                          Qt::ShiftModifier);
        QCoreApplication::sendEvent(&display, &event);
    };
    pieces.of("press", [&] { send(QEvent::MouseButtonPress, from, Qt::LeftButton); });
    for (int i = 1; i <= 30; ++i) {
        const QPoint at = from + QPoint(2 * i, i);
        pieces.of("drag", [&] { send(QEvent::MouseMove, at, Qt::NoButton); });
        pieces.of("events while it is dragged", [] { QCoreApplication::processEvents(); });
    }
    const QPoint to = from + QPoint(60, 30);
    pieces.of("release", [&] { send(QEvent::MouseButtonRelease, to, Qt::LeftButton); });
}

} // namespace

void measureCrowd(const Measurement& measurement, script::Reader& reader, int bodies) {
    views::Editor editor(computing::toolsOf(reader));
    views::SceneDocument& document = editor.document();
    const auto settled = [&] { return document.work() == views::Work::none; };
    Pieces pieces;
    views::GraphicalViewer* viewer = nullptr;
    pieces.of("open a graphical viewer", [&] { viewer = editor.openGraphicalViewer(); });
    pieces.of("open a language viewer", [&] { editor.openLanguageViewer(); });
    pieces.of("set the text", [&] { document.setText(crowd(bodies), "Edit"); });
    pieces.eventsUntil("events while it is read", settled);
    views::SceneDisplay& display = viewer->display();
    render::Display shown = display.display();
    shown.positionHandles = true;
    pieces.of("show handles", [&] { display.setDisplay(shown); });
    pieces.eventsUntil("events while handles are drawn", [&] {
        return display.handles().handles.size() == static_cast<std::size_t>(bodies);
    });
    const std::string before = document.text();
    drag(display, bodies / 2, pieces);
    if (document.text() == before)
        std::exit((std::fprintf(stderr, "bench_latency: the drag moved nothing\n"), 1));
    pieces.eventsUntil("events after the drag", settled);
    std::vector<editing::Element> all;
    for (std::size_t i = 0; i < static_cast<std::size_t>(bodies); ++i)
        all.push_back({editing::Kind::body, i});
    pieces.of("select all", [&] {
        document.select(all);
        display.repaint();
    });
    pieces.of("undo", [&] { document.undo(); });
    pieces.eventsUntil("events after undo", settled);
    pieces.of("play", [&] {
        viewer->playback().seek(0.5);
        QCoreApplication::processEvents();
    });
    pieces.report(measurement, bodies);
}

} // namespace bench
