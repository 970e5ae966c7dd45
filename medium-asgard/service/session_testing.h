// A session with a world that the test holds by the hand: reading answers at once, the motion goes
// as far as the test lets it, pictures are counted.
#pragma once

#include "service/testing.h"

#include <gmock/gmock.h>

#include <atomic>

#include <poll.h>

namespace service::held {

using std::chrono::milliseconds;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

class StillMotion final : public simulation::Motion {
public:
    StillMotion(double finish, double computed, std::vector<simulation::Stop> stops = {})
        : finish_(finish), computed_(computed), stops_(std::move(stops)) {}
    double start() const override { return 0; }
    double finish() const override { return finish_; }
    double computed() const override { return computed_; }
    bool draft() const override { return false; }
    std::size_t bodies() const override { return 1; }
    simulation::BodyState at(std::size_t, double) const override { return {}; }
    std::optional<simulation::Stop> stop(std::size_t) const override {
        return stops_.empty() ? std::nullopt : std::optional(stops_.front());
    }
    simulation::Vector centroid(std::size_t) const override { return simulation::Vector::Zero(); }
    double mass(std::size_t) const override { return 1; }
    const std::vector<simulation::Impact>& impacts() const override { return impacts_; }
    std::vector<double> jumps(std::size_t) const override { return {}; }
    std::optional<double> errorEstimate() const override { return std::nullopt; }
    std::optional<double> predictableUntil() const override { return std::nullopt; }
    const std::vector<std::string>& notes() const override { return notes_; }

private:
    double finish_, computed_;
    std::vector<simulation::Stop> stops_;
    std::vector<simulation::Impact> impacts_;
    std::vector<std::string> notes_;
};

// Texts: "faulty" makes no scene, "p" has a parameter p, all but "empty" have one body. "pushed" is
// the pushed ball, and moves as it should; "charted" has a plot of its way, "measured" has that
// beside it, too; "falls down" and "falls back" are that ball with a
// weight along -y and -z. A motion of 10 s is computed up to what allow() said, and ends there when
// `ends`.
class World {
public:
    Tools tools() {
        Tools tools;
        tools.read = [this](const std::string& text, const ParameterValues& parameters) {
            return read(text, parameters);
        };
        tools.cancelReading = [] {};
        tools.simulate = [this](const auto& scene, const auto&, const auto& observer) {
            return simulate(*scene, observer);
        };
        return tools;
    }

    void allow(double time) {
        const std::lock_guard lock(mutex_);
        allowed_ = time;
        changed_.notify_all();
    }

    std::vector<simulation::Stop> stops; // of the motion when it is whole
    std::atomic<int> runs{0}, cancelledRuns{0};

private:
    script::ReadResult read(const std::string& text, const ParameterValues& parameters) {
        script::ReadResult result;
        if (text == "pushed" || text == "charted" || text == "measured") {
            result.usable = true;
            result.scene = pushedBallScene(parameters.empty() ? 1 : parameters.at("p"));
            result.scene.simulator.finish = 10;
            if (text != "pushed")
                result.scene.plots.push_back({"way", {"b.x"}, {"Way"}, "", text == "measured", {}});
            return result;
        }
        if (text.starts_with("falls")) {
            result.usable = true;
            result.scene = pushedBallScene(1);
            result.scene.simulator.finish = 10;
            result.scene.forces[0].kind = scene::GravitationalForce{
                -10 *
                (text == "falls back" ? simulation::Vector::UnitZ() : simulation::Vector::UnitY())};
            return result;
        }
        const bool known = text == "p" || parameters.empty();
        result.usable = text != "faulty" && known;
        if (!result.usable)
            result.diagnostics.push_back({scene::Severity::error, {}, 1, 1, 1, 2, "faulty", ""});
        if (text == "p")
            result.scene.parameters.push_back({"p", 1, 0, 2, "", "", {}});
        result.scene.simulator.finish = 10;
        if (text == "empty")
            return result;
        result.scene.bodies.emplace_back().name = "b";
        result.scene.bodies.back().source.line = 3;
        return result;
    }

    simulation::Result simulate(const scene::Scene& scene, const simulation::Observer& observer) {
        ++runs;
        const auto motionTo = [&](double reached) -> simulation::MotionPointer {
            if (scene.forces.empty())
                return std::make_shared<StillMotion>(10, reached);
            simulation::Options options;
            options.finish = reached;
            return simulation::simulate(scene, options).motion;
        };
        double reached = 0;
        std::unique_lock lock(mutex_);
        while (reached < 10) {
            if (observer.cancelled()) {
                ++cancelledRuns;
                return {motionTo(reached), {}, {}, true, {}};
            }
            if (allowed_ > reached) {
                reached = std::min(allowed_, 10.0);
                observer.progress(motionTo(reached));
            } else {
                changed_.wait_for(lock, milliseconds(1));
            }
        }
        if (!scene.forces.empty())
            return {motionTo(10), {}, {}, false, {}};
        return {std::make_shared<StillMotion>(10, 10, stops), {}, {}, false, {}};
    }

    std::mutex mutex_;
    std::condition_variable changed_;
    double allowed_ = 0;
};

class SessionTest : public testing::Test {
protected:
    SessionTest() {
        Platform platform;
        platform.tools = world.tools();
        platform.draw = [this](const render::Drawing& drawing, const render::Image&,
                               const Around& drawnAround) {
            drawn.push_back(drawing.time);
            camera = drawing.camera;
            around = drawnAround;
            return true;
        };
        session.emplace(std::move(platform), medium);
    }

    // Both ends say what they have to say, at the time `now`.
    void exchange() {
        for (int i = 0; i < 3; ++i)
            exchangeOnce(host, medium, *session, now, asked,
                         [this](ipc::ToHost call) { take(std::move(call)); });
        ASSERT_EQ(host.fault(), "");
        ASSERT_EQ(medium.fault(), "");
    }

    void take(ipc::ToHost call) {
        if (auto* time = std::get_if<ipc::TimeChanged>(&call))
            told = *time;
        else if (auto* d = std::get_if<ipc::Diagnostics>(&call))
            diagnostics = *d;
        else if (auto* frame = std::get_if<ipc::RenditionFrame>(&call))
            frames.push_back(*frame);
        else if (auto* values = std::get_if<ipc::ValueChanged>(&call))
            valueReports.push_back(*values);
        else if (auto* state = std::get_if<ipc::RenditionState>(&call))
            states.push_back(state->state);
        else if (std::holds_alternative<ipc::ProgressBegin>(call))
            progress.push_back("begin");
        else if (std::holds_alternative<ipc::ProgressEnd>(call))
            progress.push_back("end");
    }

    template <class F> void until(F condition) {
        const Instant end = Clock::now() + std::chrono::seconds(20);
        while (!condition()) {
            ASSERT_LT(Clock::now(), end) << "waited too long";
            pollfd news{session->descriptor(), POLLIN, 0};
            poll(&news, 1, 5);
            exchange();
        }
    }

    template <class R> void ask(R request) {
        service::request(host, std::move(request), answers);
        exchange();
    }

    ipc::Values values(std::vector<std::string> expressions, double time) {
        ipc::Values read;
        host.request(ipc::ValueRead{std::move(expressions), time},
                     [&](ipc::Outcome<ipc::Values> outcome) {
                         if (const auto* error = std::get_if<ipc::Error>(&outcome))
                             answers.push_back(error->message);
                         else
                             read = std::get<ipc::Values>(outcome);
                     });
        exchange();
        return read;
    }

    void load(const std::string& text, ipc::Integer revision = 1) {
        if (!session->mode())
            ask(ipc::Initialize{});
        ask(ipc::SubdocumentLoad{text, revision});
    }

    void show() {
        ipc::RenditionCreate create;
        create.rendition = 1;
        create.width = create.height = 20;
        ask(create);
        host.notify(ipc::RenditionShow{1});
        exchange();
    }

    // A drag turns its view.
    void turn(ipc::Integer rendition) {
        ipc::RenditionInput input;
        input.rendition = rendition;
        for (const auto type :
             {ipc::InputType::press, ipc::InputType::move, ipc::InputType::release}) {
            input.type = type;
            input.button = type == ipc::InputType::move ? ipc::Button::none : ipc::Button::left;
            input.x = type == ipc::InputType::press ? 5 : 9;
            input.y = 10;
            host.notify(input);
            exchange();
            host.notify(ipc::RenditionAck{rendition, frames.back().serial});
        }
    }

    void computedTo(double time) {
        world.allow(time);
        until([&] {
            return session->subdocument().playback.span().computed == std::min(time, 10.0);
        });
    }

    World world;
    ipc::HostChannel host;
    ipc::MediumChannel medium;
    std::optional<Session> session;
    Instant now = Clock::now();
    std::vector<double> drawn;
    render::Camera camera; // of the last
    Around around;         // the same
    std::optional<ipc::TimeChanged> told;
    std::optional<ipc::Diagnostics> diagnostics;
    std::vector<ipc::RenditionFrame> frames;
    std::vector<ipc::ValueChanged> valueReports;
    std::vector<std::string> answers, progress, states;
    std::vector<ipc::Asked<ipc::ToHost>> asked;
};

} // namespace service::held
