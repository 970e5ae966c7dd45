// Tools that the tests of this folder share: an application, a reader, and motion known exactly.
#pragma once

#include "framing/test_scenes.h"
#include "picture/scene_display.h"
#include "script/reader.h"
#include "workbench/scene_document.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QTemporaryDir>
#include <QTest>

#include <atomic>
#include <functional>

namespace views {

// Made before anything else of the process, as in the programs.
inline script::Reader& theReader() {
    static script::Reader reader;
    return reader;
}

inline QApplication& theApplication() {
    static int argc = 1;
    static char name[] = "views_test";
    static char* argv[] = {name, nullptr};
    theReader();
    // Panes and recent files that one program of tests leaves behind are no other one's.
    static const QTemporaryDir settings;
    qputenv("XDG_CONFIG_HOME", settings.path().toUtf8());
    // Never destroyed: when the process ends, objects that Qt has made since may be gone before it.
    static QApplication& application = *new QApplication(argc, argv);
    // However loaded the machine is, tests look at the picture that was asked for.
    WindowPicture::setPatience(std::chrono::seconds(60));
    Said::setPace(1000); // and at what is said, however late
    return application;
}

// Bodies fly on from where they start; nothing acts on them.
inline simulation::MotionPointer flight(const scene::Scene& scene) {
    std::vector<render::GivenMotion::Law> laws;
    for (const scene::Body& body : scene.bodies)
        laws.push_back([body](double t) {
            simulation::BodyState state;
            state.position = body.initialPosition + t * body.initialVelocity;
            state.attitude = body.initialAttitude;
            state.velocity = body.initialVelocity;
            return state;
        });
    return std::make_shared<render::GivenMotion>(scene.simulator.finish, laws);
}

// A workshop that counts what it is asked for.
struct TestWorkshop {
    std::atomic<int> reads{0}, simulations{0}, cancelled{0};
    std::atomic<int> onTheInterface{0}; // of all these: on the thread that made this
    std::atomic<bool> blocked{false}; // simulations wait until this is false or they are cancelled
    std::atomic<bool> readsSlowly{false}; // reading waits until this is false

    Workshop workshop() {
        Workshop w;
        w.read = [this](const std::string& text, const computing::ParameterValues&) {
            ++reads;
            onTheInterface += QThread::currentThread() == interface_ ? 1 : 0;
            while (readsSlowly)
                QThread::msleep(1);
            return theReader().read(text);
        };
        w.cancelReading = [] { theReader().cancel(); };
        w.simulate = [this](const std::shared_ptr<const scene::Scene>& scene,
                            const simulation::Options&, const simulation::Observer& observer) {
            ++simulations;
            onTheInterface += QThread::currentThread() == interface_ ? 1 : 0;
            simulation::Result result;
            while (blocked && !observer.cancelled())
                QThread::msleep(1);
            if (observer.cancelled()) {
                ++cancelled;
                result.cancelled = true;
            }
            result.motion = flight(*scene);
            return result;
        };
        return w;
    }

private:
    QThread* interface_ = QThread::currentThread();
};

// The same with the engine's own motion, for values that are read from it.
inline Workshop engineWorkshop() {
    static TestWorkshop made;
    Workshop workshop = made.workshop();
    workshop.simulate = [](const auto& scene, const auto& options, const auto& observer) {
        return simulation::simulate(*scene, options, observer);
    };
    return workshop;
}

// How long a test waits for something at most, in milliseconds: only a hang reaches it.
constexpr int longestWait = 120'000;

// Handles events until the condition holds.
inline bool waitFor(const std::function<bool()>& condition) {
    QElapsedTimer timer;
    timer.start();
    while (!condition()) {
        if (timer.elapsed() > longestWait)
            return false;
        QCoreApplication::processEvents(QEventLoop::AllEvents, 20);
        QThread::msleep(1);
    }
    return true;
}

inline bool settle(SceneDocument& document) {
    return waitFor([&] { return document.work() == Work::none; });
}

inline const std::string ballScene = "simulator -finish 2\n"
                                     "shape_set ball -desc {-sub {-sphere 0.5}}\n"
                                     "body b1 ball -init_pos {-1 0 0} -init_dpos {1 0 0}\n";

} // namespace views
