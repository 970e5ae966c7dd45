// A session with a world that the test holds by the hand: reading answers at once, the motion goes
// as far as the test lets it, pictures are counted.
#include "service/testing.h"

#include <gmock/gmock.h>

#include <atomic>

#include <poll.h>

namespace service {
namespace {

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
// the pushed ball, and moves as it should; "falls down" and "falls back" are that ball with a
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
        if (text == "pushed") {
            result.usable = true;
            result.scene = pushedBallScene(parameters.empty() ? 1 : parameters.at("p"));
            result.scene.simulator.finish = 10;
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
        platform.draw = [this](const render::Drawing& drawing, const render::Image&) {
            drawn.push_back(drawing.time);
            camera = drawing.camera;
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
    std::optional<ipc::TimeChanged> told;
    std::optional<ipc::Diagnostics> diagnostics;
    std::vector<ipc::RenditionFrame> frames;
    std::vector<ipc::ValueChanged> valueReports;
    std::vector<std::string> answers, progress, states;
    std::vector<ipc::Asked<ipc::ToHost>> asked;
};

TEST_F(SessionTest, MotionIsShownAsFarAsItIsKnown) {
    load("a");
    until([&] { return diagnostics.has_value(); });
    now += milliseconds(300); // longer than the old scene may stay
    computedTo(2);
    EXPECT_EQ(told->state, ipc::MotionState::computing);
    ask(ipc::TimePlay{});
    now += milliseconds(5000);
    exchange();
    EXPECT_EQ(told->time, 2);
    EXPECT_TRUE(told->playing);
    computedTo(10);
    until([&] { return told->state == ipc::MotionState::current; });
    now += milliseconds(1000);
    exchange();
    EXPECT_NEAR(told->time, 3, 1e-9);
}

TEST_F(SessionTest, PingIsAnsweredAndASnapshotWaitsWhileTheMotionIsComputed) {
    load("a");
    now += milliseconds(2000);
    computedTo(1);
    ipc::RenditionSnapshot snapshot;
    snapshot.width = snapshot.height = 10;
    snapshot.time = 5;
    answers.clear();
    ask(snapshot);
    ask(ipc::Ping{});
    EXPECT_THAT(answers, ElementsAre("ping"));
    computedTo(6);
    until([&] { return answers.size() == 2; });
    EXPECT_THAT(answers, ElementsAre("ping", "rendition/snapshot"));
    EXPECT_THAT(drawn, Contains(5));
}

TEST_F(SessionTest, ANewerTextCancelsTheRunOfTheOlder) {
    load("a");
    until([&] { return world.runs == 1; });
    load("b", 2);
    until([&] { return world.runs == 2; });
    EXPECT_EQ(world.cancelledRuns, 1);
    computedTo(10);
    until([&] { return told->state == ipc::MotionState::current; });
    EXPECT_EQ(diagnostics->revision, 2);
}

TEST_F(SessionTest, TheOldSceneStaysUntilTheNewMotionReachesTheTimeShown) {
    load("a");
    computedTo(10);
    until([&] { return told->state == ipc::MotionState::current; });
    ask(ipc::TimeSeek{4});
    world.allow(0);
    const unsigned before = session->subdocument().generation();
    load("b", 2);
    until([&] { return diagnostics->revision == 2; });
    world.allow(3);
    until([&] { return world.runs == 2; });
    exchange();
    EXPECT_EQ(session->subdocument().generation(), before);
    EXPECT_EQ(told->time, 4);
    world.allow(5);
    until([&] { return session->subdocument().generation() != before; });
    EXPECT_EQ(told->time, 4);
}

TEST_F(SessionTest, AFaultyTextLeavesTheLastSceneAndSaysSo) {
    load("a");
    computedTo(10);
    until([&] { return told->state == ipc::MotionState::current; });
    const ScenePointer scene = session->subdocument().scene();
    load("faulty", 2);
    until([&] { return told->state == ipc::MotionState::stale; });
    EXPECT_EQ(session->subdocument().scene(), scene);
    EXPECT_THAT(diagnostics->items, testing::SizeIs(1));
}

TEST_F(SessionTest, ProgressIsToldOnlyOfWhatTakesLongAndCanBeCancelled) {
    load("a");
    computedTo(1);
    EXPECT_THAT(progress, IsEmpty());
    now += milliseconds(500);
    exchange();
    EXPECT_THAT(progress, ElementsAre("begin"));
    host.notify(ipc::ProgressCancel{1});
    exchange();
    until([&] { return told->state == ipc::MotionState::failed; });
    EXPECT_THAT(progress, ElementsAre("begin", "end"));
    EXPECT_EQ(told->computed, 1); // what there was is kept
}

TEST_F(SessionTest, ValuesAreReadWithASentenceForEachThatHasNone) {
    load("empty");
    computedTo(10);
    until([&] { return told->state == ipc::MotionState::current; });
    const ipc::Values read = values({"2*t", "c.x"}, 1.0);
    // This motion has no state to read.
    EXPECT_THAT(read.faults, ElementsAre("it has no value at this time", HasSubstr("\"c.x\"")));
    EXPECT_THAT(values({"2*t"}, 11.0).faults,
                ElementsAre("there is no motion at 11 s: it is known from 0 s to 10 s"));
    EXPECT_EQ(session->valueSource().built(), 1u);
    // Those of a faulty text are not told as its own.
    load("faulty", 2);
    until([&] { return told->state == ipc::MotionState::stale; });
    answers.clear();
    (void)values({"2*t"}, 1.0);
    EXPECT_THAT(answers, ElementsAre(HasSubstr("the text is faulty")));
}

TEST_F(SessionTest, ValuesOfASubscriptionAreToldAtOnceAndWhenTheyChange) {
    load("empty");
    computedTo(10);
    until([&] { return told->state == ipc::MotionState::current; });
    ask(ipc::ValueSubscribe{7, {"c.x"}});
    ASSERT_THAT(valueReports, testing::SizeIs(1));
    EXPECT_EQ(valueReports[0].id, 7);
    EXPECT_THAT(valueReports[0].faults, ElementsAre(HasSubstr("\"c.x\"")));
    ask(ipc::ValueSubscribe{8, {"d.x"}}); // told at once
    ASSERT_THAT(valueReports, testing::SizeIs(2));
    ask(ipc::TimeSeek{5}); // nothing of them is another one
    EXPECT_THAT(valueReports, testing::SizeIs(2));
}

// While a slider is dragged: x = p t^2 / 2 holds in each report.
TEST_F(SessionTest, AParameterIsToldWithTheMotionThatItMade) {
    load("pushed");
    computedTo(10);
    until([&] { return told->state == ipc::MotionState::current; });
    ask(ipc::TimeSeek{2});
    ask(ipc::ValueSubscribe{7, {"p", "b.x"}});
    for (const double p : {3.0, 4.0}) {
        world.allow(0);
        host.notify(ipc::ParameterSet{"p", p});
        exchange();
        ask(ipc::ValueUnsubscribe{7}); // what is asked now is of the motion before
        ask(ipc::ValueSubscribe{7, {"p", "b.x"}});
        EXPECT_LT(valueReports.back().values[0], p);
        computedTo(10);
        until([&] { return told->state == ipc::MotionState::current; });
        until([&] {
            now += milliseconds(100);
            return valueReports.back().values[0] == p;
        });
    }
    for (const ipc::ValueChanged& report : valueReports)
        EXPECT_NEAR(report.values[1], 2 * report.values[0], 1e-6);
    EXPECT_EQ(session->valueSource().built(), 3u); // once for each scene
}

TEST_F(SessionTest, AChartIsShownAndTakenWhenItsPlotsHaveBeenSampled) {
    load("a");
    computedTo(10);
    ipc::RenditionCreate create;
    create.rendition = 1;
    create.presentation = "chart";
    create.width = create.height = 20;
    ask(create);
    host.notify(ipc::RenditionShow{1});
    until([&] { return frames.size() == 1; });
    answers.clear();
    ipc::RenditionSnapshot snapshot;
    snapshot.presentation = "chart";
    snapshot.width = snapshot.height = 20;
    ask(snapshot);
    until([&] { return !answers.empty(); });
    EXPECT_THAT(answers, ElementsAre("rendition/snapshot"));
}

TEST_F(SessionTest, AMotionThatStoppedIsSaidAtItsBody) {
    world.stops = {{3, "the force on \"b\" is not finite at t = 3"}};
    load("a");
    world.allow(10);
    until([&] { return told->state == ipc::MotionState::failed; });
    EXPECT_EQ(session->subdocument().playback.span().finish, 3); // it is played no farther
    ASSERT_THAT(diagnostics->items, testing::SizeIs(1));
    EXPECT_EQ(diagnostics->items[0].line, 3);
    EXPECT_THAT(diagnostics->items[0].message, HasSubstr("not finite"));
}

// --- changes made here -----------------------------------------------------------------------

TEST_F(SessionTest, AChangeIsTheHostsToAcceptAndThenTheTextHere) {
    load("one two", 7);
    std::optional<std::optional<std::string>> refusal;
    const auto keep = [&](std::optional<std::string> why) { refusal = std::move(why); };
    session->propose({4, 7, "three"}, "Edit text", keep);
    exchange();
    ASSERT_EQ(asked.size(), 1u);
    const auto& change = std::get<ipc::SubdocumentChanged>(asked[0].call);
    EXPECT_EQ(change.base, 7);
    EXPECT_EQ(change.label, "Edit text");
    ASSERT_EQ(change.edits.size(), 1u);
    EXPECT_EQ(change.edits[0].text, "three");
    EXPECT_EQ(session->subdocument().text(), "one two");
    EXPECT_FALSE(refusal);
    host.answer(asked[0].id, ipc::Revised{8});
    exchange();
    ASSERT_TRUE(refusal);
    EXPECT_EQ(*refusal, std::nullopt);
    EXPECT_EQ(session->subdocument().text(), "one three");
    EXPECT_EQ(session->subdocument().revision(), 8);
}

TEST_F(SessionTest, AChangeOfATextThatTheHostHasChangedMeanwhileIsRefused) {
    load("one two", 7);
    std::optional<std::string> why;
    session->propose({4, 7, "three"}, "Edit text", [&](auto refusal) { why = refusal; });
    exchange();
    ask(ipc::SubdocumentEdit{8, {{0, 3, "1"}}, "Undo"});
    ASSERT_EQ(asked.size(), 1u);
    host.refuse(asked[0].id, {ipc::ErrorCode::staleBase, "the text is at revision 8"});
    exchange();
    EXPECT_EQ(why, "the text is at revision 8");
    EXPECT_EQ(session->subdocument().text(), "1 two");
}

TEST_F(SessionTest, HowARenditionIsSeenComesBackInAnotherProcess) {
    load("a scene");
    show();
    exchange();
    EXPECT_THAT(states, IsEmpty());
    ipc::RenditionInput input;
    input.rendition = 1;
    input.x = input.y = 10;
    const auto drag = [&](ipc::InputType type, double x) {
        input.type = type;
        input.button = type == ipc::InputType::move ? ipc::Button::none : ipc::Button::left;
        input.x = x;
        host.notify(input);
        exchange();
    };
    drag(ipc::InputType::press, 10);
    drag(ipc::InputType::move, 15);
    EXPECT_THAT(states, IsEmpty()); // still being turned
    drag(ipc::InputType::release, 15);
    now += std::chrono::seconds(1);
    exchange();
    ASSERT_EQ(states.size(), 1u);
    ipc::RenditionCreate create;
    create.rendition = 2;
    create.width = create.height = 20;
    create.state = states[0];
    ask(create);
    drag(ipc::InputType::press, 10); // told again only when it is another
    drag(ipc::InputType::release, 10);
    now += std::chrono::seconds(1);
    exchange();
    EXPECT_EQ(states.size(), 1u);

    Rendition same, other;
    const std::string plain = other.state();
    same.restore(states[0]);
    EXPECT_EQ(same.state(), states[0]);
    for (const char* nonsense : {"", "x", "asgard-1", "asgard-1 1 1 1 1 1 1 1 nan",
                                 "asgard-1 0 0 0 0 0 0 1 0 0 0 0 0 0 0 0 0 0 1"}) {
        other.restore(nonsense);
        EXPECT_EQ(other.state(), plain) << nonsense;
    }
    // One of before joints were drawn.
    other.restore("asgard-2 1 0 1 1 0 0 0 0 0 0 1 0 0 0 ");
    EXPECT_TRUE(other.display.wireframe && other.display.linkHandles && other.display.joints);
    EXPECT_FALSE(other.display.jointHandles);
}

// An upright body leans to a side as it did before a drag, whoever turned the picture before.
TEST_F(SessionTest, APictureTurnsAboutWhatIsUpright) {
    load("falls down");
    computedTo(10);
    show();
    const auto turned = [&](ipc::Integer rendition) {
        const render::Camera before = camera;
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
        now += std::chrono::seconds(1);
        exchange();
        host.notify(ipc::RenditionAck{rendition, frames.back().serial});
        EXPECT_GT(camera.rotation.angularDistance(before.rotation), 0.1);
        return std::pair(before.rotation, camera.rotation);
    };
    const auto keeps = [](const auto& turn, const simulation::Vector& up) {
        const auto lean = [&](const geometry::Quaternion& rotation) -> Eigen::Vector2d {
            return (rotation * up).head<2>().normalized();
        };
        return lean(turn.first).isApprox(lean(turn.second), 1e-9);
    };
    EXPECT_TRUE(keeps(turned(1), simulation::Vector::UnitY()));
    load("falls back", 2); // while it is seen
    until([&] { return !session->subdocument().computing(); });
    now += std::chrono::seconds(1);
    exchange();
    EXPECT_TRUE(keeps(turned(1), simulation::Vector::UnitZ()));
    ask(ipc::RenditionDestroy{1});
    ipc::RenditionCreate create;
    create.rendition = 2;
    create.width = create.height = 20;
    create.state = states.back();
    ask(create);
    host.notify(ipc::RenditionShow{2});
    exchange();
    EXPECT_TRUE(keeps(turned(2), simulation::Vector::UnitZ()));
}

TEST_F(SessionTest, PicturesAreDrawnOnceForEachLookAndNeverWhileHidden) {
    load("a");
    computedTo(10);
    until([&] { return told->state == ipc::MotionState::current; });
    show();
    until([&] { return frames.size() == 1; });
    for (int i = 0; i < 5; ++i) {
        now += milliseconds(100);
        exchange();
    }
    EXPECT_EQ(drawn.size(), 1u);
    EXPECT_FALSE(session->deadline()); // nothing will be due
    host.notify(ipc::RenditionHide{1});
    ask(ipc::TimePlay{});
    now += milliseconds(1000);
    exchange();
    EXPECT_EQ(drawn.size(), 1u);
    host.notify(ipc::RenditionShow{1});
    exchange();
    EXPECT_EQ(drawn.size(), 2u);
}

TEST_F(SessionTest, WhatIsNotAcknowledgedIsNotDrawnOver) {
    load("a");
    computedTo(10);
    until([&] { return told->state == ipc::MotionState::current; });
    show();
    ask(ipc::TimePlay{});
    for (int i = 0; i < 20; ++i) {
        now += milliseconds(100);
        exchange();
    }
    ASSERT_EQ(frames.size(), 2u);
    EXPECT_NE(frames[0].slot, frames[1].slot);
    host.notify(ipc::RenditionAck{1, frames[1].serial});
    exchange();
    ASSERT_EQ(frames.size(), 3u);
    EXPECT_EQ(frames[2].slot, frames[1].slot);
}

TEST_F(SessionTest, AParameterKeepsToItsBoundsAndDoesNotSpoilATextWithoutIt) {
    load("p");
    computedTo(10);
    until([&] { return told->state == ipc::MotionState::current; });
    host.notify(ipc::ParameterSet{"p", 5});
    host.notify(ipc::ParameterSet{"q", 5}); // there is none
    exchange();
    EXPECT_THAT(session->subdocument().parameters(), ElementsAre(std::pair("p", 2.0)));
    until([&] { return told->state == ipc::MotionState::current; });
    load("a", 2);
    until([&] { return diagnostics->revision == 2 && told->state == ipc::MotionState::current; });
    EXPECT_THAT(diagnostics->items, IsEmpty());
}

} // namespace
} // namespace service
