// An author waits at a handle in a document: from a movement of the pointer to the painted
// picture in which the handle has moved, and to the one that shows the new motion. Drives a real
// document window without a display, with the medium's real process behind it; the clock on the
// wall, since two programs, a pipe and a renderer are waited for. The goals are those of the
// graphical viewer (latency.cpp): one and two frames of a display of 60 Hz, at the 95th percentile.
//
//     bench_document_latency SCENE.al [--smoke]       Figure 4.6's scene
//
// The figure is 640 x 480 pixels large. A loop of arithmetic before and after each movement tells
// how busy the machine is: movements beside which it was free have rows of their own.
#include "measurement.h"
#include "paints.h"

#include "window/application.h"
#include "window/document_window.h"

#include <QApplication>
#include <QFile>
#include <QMouseEvent>
#include <QTemporaryDir>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <memory>
#include <utility>

namespace {

using bench::Measurement;
using Clock = std::chrono::steady_clock;

[[noreturn]] void stop(const char* why) {
    std::fprintf(stderr, "bench_document_latency: %s\n", why);
    std::fflush(stderr);
    std::_Exit(1); // its process ends with it
}

double between(Clock::time_point begin, Clock::time_point end) {
    return std::chrono::duration<double>(end - begin).count();
}

// False: not within so many seconds.
bool waitFor(double seconds, const std::function<bool()>& condition) {
    const auto begin = Clock::now();
    while (!condition()) {
        if (between(begin, Clock::now()) > seconds)
            return false;
        QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents, 5);
    }
    return true;
}

void handleEventsUntil(const char* what, const std::function<bool()>& condition) {
    if (!waitFor(30, condition))
        stop(what);
}

QByteArray memo(const QByteArray& scene) {
    QByteArray escaped = scene;
    escaped.replace('\\', "\\\\").replace('{', "\\{").replace('}', "\\}");
    return "DOCUMENT CMEMO\n<CMEMO>\n<SUBJECT>{A drag}</SUBJECT>\n<BODY>\n<PARAGRAPH><DOCUMENT>\n"
           "DOCUMENT ANIMATION\n<ANIMATION WIDTH=\"640\" HEIGHT=\"480\"><ASGARD>{" +
           escaped + "}</ASGARD></ANIMATION>\n</DOCUMENT></PARAGRAPH>\n</BODY>\n</CMEMO>\n";
}

double loop() {
    const auto begin = Clock::now();
    volatile double x = 0;
    for (int i = 0; i < 1'000'000; ++i)
        x = x + i * 1e-9;
    return between(begin, Clock::now());
}

struct Move { // seconds
    double toHandle, toMotion, loopBefore, loopAfter;
};

class Page {
public:
    explicit Page(const QByteArray& scene)
        : application_({}, folder_.filePath(QStringLiteral("journal")).toStdString()) {
        const QString name = folder_.filePath(QStringLiteral("document.ens"));
        QFile file(name);
        if (!file.open(QIODevice::WriteOnly) || file.write(memo(scene)) < 0)
            stop("no file could be written");
        file.close();
        window_ = application_.open(name);
        if (window_ == nullptr)
            stop("the document could not be opened");
        window_->resize(900, 900);
        handleEventsUntil("the pages did not come", [&] { return view().isLaidOut(); });
        figure_ = window_->document().document().subdocuments().front();
        view().setZoom(1);
        view().scrollTo(figure_);
        handleEventsUntil("the motion did not come", [&] {
            return live() && live()->time() && live()->time()->state == ipc::MotionState::current &&
                   !rendition().picture().isNull();
        });
        QObject::connect(live(), &media::LiveSubdocument::message,
                         [this](const QString& text) { said_ = text; });
        for (const char* entry : {"position-handles", "velocity-handles"})
            live()->invoke(QLatin1String(entry), &rendition());
        paints_ = std::make_unique<bench::Paints>(*view().viewport());
        paints_->within = QRect(place().center().toPoint(), QSize(1, 1));
        const QPointF middle = place().center();
        send(QEvent::MouseButtonPress, middle, Qt::LeftButton, Qt::NoModifier); // chooses it
        send(QEvent::MouseButtonRelease, middle, Qt::LeftButton, Qt::NoModifier);
        rest();
        // Pages are laid out anew once the medium has said how large it would like to be.
        QObject::connect(&rendition(), &media::Rendition::pictureChanged, [this] {
            cameAt_ = Clock::now();
            if (std::exchange(isAwaited_, false)) // painted from now on
                paints_->await();
        });
    }

    // A drag of what says so of itself.
    std::vector<Move> measure(const QString& what, int moves) {
        const QPointF start = find(what);
        std::vector<Move> all;
        for (int i = 1; i <= moves; ++i) {
            rest();
            const auto motion = live()->time()->motion;
            const QString said = said_;
            const double before = loop();
            isAwaited_ = true;
            const auto begin = Clock::now();
            // To and fro, so that the scene stays one of its kind.
            send(QEvent::MouseMove, start + 3 * QPointF(i % 40 < 20 ? i % 20 : 20 - i % 20, i % 7));
            const bool isChanged = waitFor(1, [&] { return !isAwaited_ && paints_->came(); });
            if (!isChanged || said_ == said)
                continue; // a snap holds it
            const double toHandle = between(begin, paints_->first);
            if (!waitFor(2, [&] { return live()->time()->motion != motion; }))
                continue; // the same numbers again
            rest();
            all.push_back({toHandle, between(begin, paints_->last), before, loop()});
        }
        send(QEvent::MouseButtonRelease, start, Qt::LeftButton);
        rest();
        return all;
    }

    void undo() {
        while (window_->document().document().canUndo())
            window_->document().document().undo();
    }

private:
    view::DocumentView& view() { return window_->view(); }
    media::LiveSubdocument* live() { return window_->document().live(figure_); }
    media::Rendition& rendition() { return *view().rendition(figure_); }
    QRectF place() { return view().placeOf(figure_); }

    // Until the newest motion is there, and no picture has come for a while.
    void rest() {
        constexpr double quiet = 0.06;
        const auto begin = Clock::now();
        handleEventsUntil("the picture did not come to rest", [&] {
            return live()->time()->state == ipc::MotionState::current &&
                   between(std::max(cameAt_, begin), Clock::now()) > quiet;
        });
    }

    // Takes hold of it: the pointer looks for it all over the picture. An answer may come late,
    // when the pointer is some places further on: it then goes back, with more patience.
    QPointF find(const QString& what) {
        const QRectF all = place();
        constexpr double step = 12;
        std::vector<QPointF> places;
        for (double y = all.top() + step; y < all.bottom(); y += step)
            for (double x = all.left() + step; x < all.right(); x += step) {
                places.emplace_back(x, y);
                if (!holds(what, places.back(), 0.02))
                    continue;
                letGo(places.back());
                for (std::size_t back = 1; back <= std::min<std::size_t>(places.size(), 20);
                     ++back) {
                    const QPointF at = places[places.size() - back];
                    if (holds(what, at, 0.5))
                        return at;
                }
            }
        stop("nothing can be dragged");
    }

    // Presses there: does that say, within so many seconds, that it holds what is looked for? It
    // lets go of anything else.
    bool holds(const QString& what, const QPointF& at, double seconds) {
        said_.clear();
        send(QEvent::MouseButtonPress, at, Qt::LeftButton);
        send(QEvent::MouseMove, at, Qt::NoButton);
        waitFor(seconds, [&] { return !said_.isEmpty(); });
        if (said_.contains(what))
            return true;
        letGo(at);
        return false;
    }

    void letGo(const QPointF& at) {
        send(QEvent::MouseButtonRelease, at, Qt::LeftButton);
        if (!said_.isEmpty())
            rest();
    }

    void send(QEvent::Type type, const QPointF& at, Qt::MouseButton button = Qt::NoButton,
              Qt::KeyboardModifiers with = Qt::ShiftModifier) {
        QWidget& viewport = *view().viewport();
        QMouseEvent event(type, at, viewport.mapToGlobal(at), button,
                          type == QEvent::MouseButtonRelease ? Qt::NoButton : Qt::LeftButton, with);
        QCoreApplication::sendEvent(&viewport, &event);
    }

    QTemporaryDir folder_;
    window::Application application_;
    window::DocumentWindow* window_ = nullptr;
    document::SubdocumentId figure_ = document::noSubdocument;
    std::unique_ptr<bench::Paints> paints_;
    QString said_;
    Clock::time_point cameAt_{}; // the last picture
    bool isAwaited_ = false;     // the next one
};

void add(const Measurement& m, const std::string& what, const std::vector<Move>& moves,
         double Move::*time) {
    if (moves.empty())
        return;
    std::vector<double> seconds;
    for (const Move& one : moves)
        seconds.push_back(one.*time);
    std::ranges::sort(seconds);
    const auto at = [&](double share) {
        return seconds[static_cast<std::size_t>(share * static_cast<double>(seconds.size() - 1))];
    };
    char note[80];
    std::snprintf(note, sizeof note, "wall; 95 of 100 within %.4g ms; of %zu", 1e3 * at(0.95),
                  seconds.size());
    m.add({"Figure 4.6 in a document", what, 0, 0, {at(0.5), seconds.front()}, note});
}

} // namespace

int main(int argc, char** argv) {
    if (argc < 2) {
        std::fputs("usage: bench_document_latency SCENE.al [--smoke]\n", stderr);
        return 2;
    }
    qputenv("QT_QPA_PLATFORM", "offscreen");
    const Measurement m("document_latency", argc - 1, argv + 1);
    int count = 1;
    const QApplication application(count, argv);
    QFile scene(QString::fromLocal8Bit(argv[1]));
    if (!scene.open(QIODevice::ReadOnly))
        stop("the scene cannot be read");
    m.add({"calibration", "sine and division", 0, 0, bench::calibration(m), ""});
    Page page(scene.readAll());
    const int moves = m.smoke() ? 8 : 100;
    for (const std::string what : {"velocity", "position"}) {
        const std::vector<Move> all = page.measure(QString::fromStdString(what), moves);
        if (all.empty())
            stop("no move of a drag changed the motion");
        const double least = std::ranges::min(all, {}, &Move::loopBefore).loopBefore;
        std::vector<Move> free; // nobody else used the processors then, as far as loops tell
        for (const Move& one : all)
            if (std::max(one.loopBefore, one.loopAfter) < 1.2 * least)
                free.push_back(one);
        for (const auto& [these, when] : {std::pair(all, ""), std::pair(free, ", machine free")}) {
            add(m, what + " dragged, to the moved handle" + when, these, &Move::toHandle);
            add(m, what + " dragged, to the new motion" + when, these, &Move::toMotion);
            add(m, "a loop of arithmetic before it", these, &Move::loopBefore);
        }
    }
    m.add({"calibration", "sine and division", 1, 0, bench::calibration(m), ""});
    page.undo();
    std::fflush(stdout);
    std::_Exit(0);
}
