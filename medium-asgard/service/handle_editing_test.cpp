// A reader's pointer on handles in the document's picture, with the real evaluator and engine.
#include "ipc/base64.h"
#include "service/testing.h"

#include <gmock/gmock.h>

#include <atomic>
#include <set>

#include <poll.h>

namespace service {
namespace {

using render::Handle;
using render::HandleKind;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

script::Reader& reader() {
    static script::Reader shared;
    return shared;
}

const std::string ball = "simulator -finish 2\nshape_set ball -desc {-sub {-sphere 0.5}}\n";

class HandleEditingTest : public testing::Test {
protected:
    HandleEditingTest() {
        reader(); // made by this thread: it ends with the one that makes it
        Platform platform;
        platform.tools.read = [this](const std::string& text, const ParameterValues& parameters) {
            ++readings;
            return reader().read(text, parameters);
        };
        platform.tools.cancelReading = [] { reader().cancel(); };
        platform.tools.simulate = [](const auto& scene, const auto& options, const auto& observer) {
            return simulation::simulate(*scene, options, observer);
        };
        platform.draw = [this](const render::Drawing& drawing, const render::Image& image) {
            camera = drawing.camera;
            size = image.size;
            handles = drawing.handles ? *drawing.handles : render::HandleSet{};
            std::ranges::fill(image.pixels, std::byte(0));
            return true;
        };
        session.emplace(std::move(platform), medium);
    }

    void exchange() {
        for (int i = 0; i < 3; ++i)
            exchangeOnce(host, medium, *session, now, asked,
                         [this](ipc::ToHost call) { take(std::move(call)); });
    }
    void take(ipc::ToHost call) {
        if (auto* sent = std::get_if<ipc::RenditionFrame>(&call)) {
            frame = ipc::fromBase64(sent->pixels.value_or("")).value_or(std::vector<std::byte>());
            host.notify(ipc::RenditionAck{1, sent->serial});
        } else if (auto* changed = std::get_if<ipc::MenuChanged>(&call))
            menus = changed->menus;
        else if (auto* diagnostics = std::get_if<ipc::Diagnostics>(&call))
            diagnosed = diagnostics->revision;
        else if (auto* report = std::get_if<ipc::ProgressReport>(&call))
            said.push_back(report->message);
        else if (auto* begin = std::get_if<ipc::ProgressBegin>(&call)) {
            if (begin->title != "Editing") // the motion's, whenever that ends
                others.insert(begin->token);
        } else if (auto* end = std::get_if<ipc::ProgressEnd>(&call); end != nullptr) {
            if (!others.contains(end->token))
                saidLast = end->message;
        }
    }
    // Until what is shown is what is to be shown, and drawn.
    void settle() {
        const Instant end = Clock::now() + std::chrono::seconds(20);
        do {
            ASSERT_LT(Clock::now(), end) << "waited too long";
            pollfd news{session->descriptor(), POLLIN, 0};
            poll(&news, 1, 5);
            now += std::chrono::milliseconds(200);
            exchange();
        } while (session->subdocument().computing() || !session->subdocument().upToDate());
        now += std::chrono::seconds(1);
        exchange();
    }
    template <class R> void ask(R request) {
        host.request(std::move(request), [](const ipc::Outcome<typename R::Result>& outcome) {
            const auto* error = std::get_if<ipc::Error>(&outcome);
            EXPECT_EQ(error, nullptr) << R::method << ": " << error->message;
        });
        exchange();
    }
    void open(const std::string& text, const std::vector<std::string>& switches) {
        ask(ipc::Initialize{});
        ask(ipc::SubdocumentLoad{text, 1});
        ipc::RenditionCreate create;
        create.rendition = 1;
        create.width = create.height = 400;
        ask(create);
        host.notify(ipc::RenditionShow{1});
        for (const std::string& id : switches)
            ask(ipc::MenuInvoke{id, 1});
        settle();
    }

    Eigen::Vector2d pixels(const render::Vector& world) const {
        return render::toPixels(camera, size, world);
    }
    Handle handle(HandleKind kind, std::size_t part = 0) const {
        for (const Handle& one : handles.handles)
            if (one.kind == kind && one.part == part)
                return one;
        throw std::runtime_error("no such handle");
    }
    void pointer(ipc::InputType type, const Eigen::Vector2d& at,
                 ipc::Button button = ipc::Button::left, bool shifted = true) {
        ipc::RenditionInput input;
        input.rendition = 1;
        input.type = type;
        input.button = type == ipc::InputType::move ? ipc::Button::none : button;
        if (shifted)
            input.modifiers = {ipc::Modifier::shift};
        input.x = at.x();
        input.y = at.y();
        host.notify(input);
        exchange();
    }
    void key(const std::string& name) {
        ipc::RenditionInput input;
        input.rendition = 1;
        input.type = ipc::InputType::keyPress;
        input.key = name;
        input.modifiers = {ipc::Modifier::shift};
        host.notify(input);
        exchange();
    }
    void press(const Eigen::Vector2d& at) { pointer(ipc::InputType::press, at); }
    void move(const Eigen::Vector2d& at) { pointer(ipc::InputType::move, at); }
    void release(const Eigen::Vector2d& at) { pointer(ipc::InputType::release, at); }
    void drag(const render::Vector& from, const render::Vector& to) {
        const Eigen::Vector2d start = pixels(from), end = pixels(to);
        press(start);
        move((start + end) / 2);
        move(end);
        release(end);
    }
    // The host takes the only change that it was asked for.
    text::Edit accepted(const std::string& label) {
        EXPECT_THAT(asked, SizeIs(1));
        const auto& change = std::get<ipc::SubdocumentChanged>(asked.at(0).call);
        EXPECT_EQ(change.label, label);
        const text::Edit edit = change.edits.at(0);
        host.answer(asked[0].id, ipc::Revised{change.base + 1});
        asked.clear();
        settle();
        return edit;
    }
    const std::string& text() { return session->subdocument().text(); }
    const scene::Scene& scene() { return *session->subdocument().scene(); }

    ipc::HostChannel host;
    ipc::MediumChannel medium;
    std::atomic<int> readings = 0;
    std::optional<Session> session;
    Instant now = Clock::now();
    render::Camera camera;
    render::Size size;
    render::HandleSet handles;
    std::vector<std::byte> frame; // that was sent last
    std::vector<ipc::MenuEntry> menus;
    std::vector<std::string> said;
    std::string saidLast;
    ipc::Integer diagnosed = 0;    // the revision that was told of last
    std::set<ipc::Integer> others; // tokens
    std::vector<ipc::Asked<ipc::ToHost>> asked;
};

TEST_F(HandleEditingTest, ADragIsOneChangeOfItsNumbersAndTheHostHasItWhenItEnds) {
    const std::string before = ball + "body b1 ball -init_pos {-1   0 0} ;# left\n";
    open(before, {"position-handles"});
    const auto at = pixels(handle(HandleKind::position).place);
    const auto to = pixels(handle(HandleKind::position).place + render::Vector(0.1, 0, 0));
    press(at);
    move(to);
    settle();
    EXPECT_EQ(text(), before); // the document's
    EXPECT_THAT(asked, IsEmpty());
    EXPECT_NEAR(scene().bodies[0].initialPosition.x(), -0.9, 1e-9); // shown meanwhile
    EXPECT_NEAR(handle(HandleKind::position).place.x(), -0.9, 1e-9);
    ASSERT_FALSE(said.empty());
    EXPECT_THAT(said.back(), HasSubstr("b1: position -0."));
    release(to);
    const text::Edit edit = accepted("Move b1");
    const std::size_t numbers = before.find("{-1") + 1;
    EXPECT_GE(edit.range.from, numbers);
    EXPECT_LE(edit.range.to, before.find("} ;# left"));
    EXPECT_EQ(text().substr(0, numbers), before.substr(0, numbers));
    EXPECT_THAT(text(), testing::EndsWith("} ;# left\n"));
    EXPECT_FALSE(session->subdocument().previewing());
    EXPECT_NEAR(scene().bodies[0].initialPosition.x(), -0.9, 1e-9);
}

// A text that the host accepts is shown already.
TEST_F(HandleEditingTest, TheEndOfADragIsNotReadAgain) {
    open(ball + "body b1 ball -init_pos {-1 0 0}\n", {"position-handles"});
    const int opened = readings;
    const auto at = pixels(handle(HandleKind::position).place);
    press(at);
    move(at + Eigen::Vector2d(40, 0));
    settle();
    const auto motion = session->subdocument().motion();
    release(at + Eigen::Vector2d(40, 0));
    const ipc::Integer revision = session->subdocument().revision();
    accepted("Move b1");
    EXPECT_EQ(readings, opened + 1);
    EXPECT_EQ(session->subdocument().motion(), motion);
    EXPECT_EQ(session->subdocument().revision(), revision + 1);
    EXPECT_EQ(session->subdocument().shownText(), text());
    EXPECT_EQ(diagnosed, revision + 1); // the faults are said to be of the text that is now
}

TEST_F(HandleEditingTest, ForcesVelocitiesLinksAndPointsAreDraggedAsInAViewer) {
    open(ball + "body b1 ball -mass 2 -init_dpos {1 0 0} -fixed 0\n"
                "force -body b1 -x 0 -y {-10 * b1.mass} -z 0\n"
                "link -body1 b1 -offset1 {0 0 0.5} -x 2 -y 0 -z 0 -tightness 10\n"
                "trajectory T -points {{0 -1 1 0} {1 0 1 0}}\n",
         {"velocity-handles", "force-handles", "link-handles", "trajectories"});
    const Handle velocity = handle(HandleKind::velocity);
    drag(velocity.place, 1.5 * velocity.place);
    accepted("Change the velocity of b1");
    EXPECT_GT(scene().bodies[0].initialVelocity.x(), 1.3);
    const Handle head = handle(HandleKind::forceHead);
    drag(head.place, head.base + 0.5 * (head.place - head.base));
    accepted("Change the components of force on b1");
    EXPECT_THAT(text(), HasSubstr(" * b1.mass}"));
    EXPECT_THAT(text(), testing::Not(HasSubstr("-10 *")));
    const Handle end = handle(HandleKind::linkEnd, 1);
    drag(end.place, end.place + render::Vector(0, 0.5, 0));
    accepted("Change the second end of link of b1");
    EXPECT_THAT(text(), testing::Not(HasSubstr("-x 2 -y 0 ")));
    const Handle point = handle(HandleKind::trajectoryPoint, 1);
    drag(point.place, point.place + render::Vector(0.5, 0, 0));
    accepted("Change the point 2 of T");
    EXPECT_GT(scene().trajectories[0].points[1].second.x(), 0.3);
    pointer(ipc::InputType::press, pixels(handle(HandleKind::trajectoryPoint, 1).place),
            ipc::Button::middle);
    const auto beyond = pixels({1.5, 1.2, 0});
    move(beyond);
    pointer(ipc::InputType::release, beyond, ipc::Button::middle);
    accepted("New point of T");
    EXPECT_EQ(scene().trajectories[0].points.size(), 3U);
    pointer(ipc::InputType::press, pixels(handle(HandleKind::trajectoryPoint, 2).place),
            ipc::Button::right);
    accepted("Remove a point");
    EXPECT_EQ(scene().trajectories[0].points.size(), 2U);
}

// As in a viewer; but nobody can be asked here about what depends on it.
TEST_F(HandleEditingTest, TheLastButOnePointTakesItsTrajectoryAlong) {
    const std::string path = "trajectory T -points {{0 -1 1 0} {1 0 1 0}}\n";
    const std::string constraint = "constrain b1 -pos T\n";
    open(ball + "body b1 ball\n" + path + constraint, {"trajectories"});
    const auto remove = [&] {
        pointer(ipc::InputType::press, pixels(handle(HandleKind::trajectoryPoint, 1).place),
                ipc::Button::right);
        settle();
    };
    remove();
    EXPECT_THAT(asked, IsEmpty());
    EXPECT_THAT(saidLast, HasSubstr("With this point its trajectory goes, and with that"));
    ask(ipc::SubdocumentLoad{ball + "body b1 ball\n" + path, 2});
    settle();
    pointer(ipc::InputType::press, pixels(handle(HandleKind::trajectoryPoint, 1).place),
            ipc::Button::right);
    EXPECT_THAT(asked, SizeIs(1));
    accepted("Delete trajectory \"T\"");
    EXPECT_EQ(scene().trajectories.size(), 0U);
}

// As in a viewer: a body is there without its handles.
TEST_F(HandleEditingTest, ABodyIsDraggedWithoutHandlesToo) {
    open(ball + "body b1 ball\nbody b2 ball -init_pos {3 1 1}\n", {});
    const auto at = pixels({0, 0, 0});
    press(at);
    move(at + Eigen::Vector2d(30, 10));
    EXPECT_THAT(said, testing::Contains(testing::StartsWith("b1: position")));
    release(at + Eigen::Vector2d(30, 10));
    settle();
    EXPECT_THAT(asked, SizeIs(1));
}

TEST_F(HandleEditingTest, WhoChoosesAPictureIsToldWhatTheButtonsDo) {
    open(ball + "body b1 ball\n", {});
    ipc::RenditionInput chosen;
    chosen.rendition = 1;
    chosen.type = ipc::InputType::focusIn;
    host.notify(chosen);
    exchange();
    EXPECT_THAT(saidLast, HasSubstr("Shift-drag moves a body"));
    ask(ipc::MenuInvoke{"position-handles", 1});
    host.notify(chosen);
    exchange();
    EXPECT_THAT(saidLast, HasSubstr("Shift-drag changes what is under the pointer"));
}

TEST_F(HandleEditingTest, WithoutShiftOrBesideBodiesThePointerTurnsTheView) {
    const std::string before = ball + "body b1 ball\nbody b2 ball -init_pos {3 1 1}\n";
    open(before, {});
    const auto at = pixels({0, 0, 0});
    const Eigen::Vector2d aside(30, 10);
    const auto attitude = camera.rotation;
    const Eigen::Vector2d nowhere(3, 3);
    press(nowhere);
    move(nowhere + aside);
    release(nowhere + aside);
    ask(ipc::MenuInvoke{"position-handles", 1});
    pointer(ipc::InputType::press, at, ipc::Button::left, false);
    pointer(ipc::InputType::move, at + aside, ipc::Button::left, false);
    pointer(ipc::InputType::release, at + aside, ipc::Button::left, false);
    settle();
    EXPECT_GT(camera.rotation.angularDistance(attitude), 0.01);
    EXPECT_THAT(asked, IsEmpty());
    EXPECT_EQ(text(), before);
}

TEST_F(HandleEditingTest, EscapeGivesTheTextBackAndWhatCannotBeSaysWhy) {
    open(ball + "body b1 ball\nbody b2 ball -init_pos [list [expr {1 + 1}] 0 0]\n",
         {"position-handles"});
    const auto at = pixels(handle(HandleKind::position).place);
    press(at);
    move(at + Eigen::Vector2d(30, 0));
    key("Escape");
    release(at + Eigen::Vector2d(30, 0));
    settle();
    EXPECT_EQ(scene().bodies[0].initialPosition.x(), 0);
    EXPECT_THAT(asked, IsEmpty());
    drag({2, 0, 0}, {1, 0, 0});
    EXPECT_THAT(asked, IsEmpty());
    EXPECT_THAT(saidLast, HasSubstr("is computed by [expr {1 + 1}]"));
    EXPECT_FALSE(session->subdocument().previewing());
}

TEST_F(HandleEditingTest, WhatTheHostRefusesOrChangesMeanwhileIsNotKept) {
    const std::string before = ball + "body b1 ball -init_pos {-1 0 0}\n";
    open(before, {"position-handles"});
    const auto at = pixels(handle(HandleKind::position).place);
    press(at);
    move(at + Eigen::Vector2d(30, 0));
    release(at + Eigen::Vector2d(30, 0));
    ASSERT_THAT(asked, SizeIs(1));
    host.refuse(asked[0].id, {ipc::ErrorCode::notPossible, "the document cannot be edited"});
    asked.clear();
    settle();
    EXPECT_EQ(saidLast, "the document cannot be edited");
    EXPECT_EQ(scene().bodies[0].initialPosition.x(), -1);

    press(pixels(handle(HandleKind::position).place));
    move(at + Eigen::Vector2d(60, 0));
    ask(ipc::SubdocumentLoad{before + "# theirs\n", 5});
    release(at + Eigen::Vector2d(60, 0));
    settle();
    EXPECT_THAT(asked, IsEmpty());
    EXPECT_EQ(text(), before + "# theirs\n");
    EXPECT_EQ(scene().bodies[0].initialPosition.x(), -1);
}

// A window's change that was on its way when the drag began.
TEST_F(HandleEditingTest, ADragEndsWhereAWindowsChangeIsAccepted) {
    const std::string before = ball + "body b1 ball -init_pos {-1 0 0}\n", added = "# theirs\n";
    open(before, {"position-handles"});
    std::optional<std::string> refused;
    const std::size_t end = before.size();
    session->propose({{end, end}, added}, "Update",
                     [&](const std::optional<std::string>& why) { refused = why; });
    exchange();
    ASSERT_THAT(asked, SizeIs(1));
    const auto at = pixels(handle(HandleKind::position).place);
    press(at);
    move(at + Eigen::Vector2d(30, 0));
    const auto& change = std::get<ipc::SubdocumentChanged>(asked[0].call);
    host.answer(asked[0].id, ipc::Revised{change.base + 1});
    asked.clear();
    exchange();
    move(at + Eigen::Vector2d(60, 0));
    release(at + Eigen::Vector2d(60, 0));
    settle();
    EXPECT_THAT(asked, IsEmpty()); // nothing takes the window's change back
    EXPECT_FALSE(refused);
    EXPECT_EQ(text(), before + added);
    EXPECT_EQ(session->subdocument().shownText(), before + added);
    EXPECT_EQ(scene().bodies[0].initialPosition.x(), -1);
    EXPECT_THAT(saidLast, HasSubstr("The text was changed meanwhile"));
}

TEST_F(HandleEditingTest, WhatCannotBeSaysWhyEachTime) {
    open(ball + "body b2 ball -init_pos [list [expr {1 + 1}] 0 0]\n", {"position-handles"});
    for (int i = 0; i < 3; ++i) {
        said.clear();
        saidLast.clear();
        drag({2, 0, 0}, {1, 0, 0});
        settle();
        EXPECT_THAT(said, SizeIs(testing::Ge(1))) << i;
        EXPECT_THAT(saidLast, HasSubstr("is computed by [expr {1 + 1}]")) << i;
    }
}

TEST_F(HandleEditingTest, ADragEndsWhereItsPictureIsHidden) {
    open(ball + "body b1 ball -init_pos {-1 0 0}\n", {"position-handles"});
    const auto at = pixels(handle(HandleKind::position).place);
    press(at);
    move(at + Eigen::Vector2d(30, 0));
    host.notify(ipc::RenditionHide{1});
    exchange();
    accepted("Move b1");
    EXPECT_GT(scene().bodies[0].initialPosition.x(), -0.95);
}

// The ball flies along x at 1 m/s; after a second it is at 0.
class ThrowingTest : public HandleEditingTest {
protected:
    const std::string start = ball + "body b ball -init_pos {-1 0 0} -init_dpos {1 0 0}\n";
    ThrowingTest() {
        open(start, {});
        ask(ipc::TimePlay{});
        now += std::chrono::seconds(1);
        exchange();
        EXPECT_NEAR(time(), 1, 0.01);
    }
    double time() { return session->subdocument().playback.time(now); }
    bool plays() { return session->subdocument().playback.playing(); }
    // To the right, for half a second.
    void carry() {
        const Eigen::Vector2d start = pixels({0, 0, 0});
        press(start);
        for (int i = 1; i <= 10; ++i) {
            now += std::chrono::milliseconds(50);
            move(start + Eigen::Vector2d(4 * i, 0));
        }
        settleHeld();
    }
    void settleHeld() {
        const Instant end = Clock::now() + std::chrono::seconds(20);
        while (session->subdocument().computing() || !session->subdocument().upToDate()) {
            ASSERT_LT(Clock::now(), end) << "waited too long";
            pollfd news{session->descriptor(), POLLIN, 0};
            poll(&news, 1, 5);
            exchange();
        }
    }
};

TEST_F(ThrowingTest, WhilePlayingABodyIsThrownAndTheMotionGoesOn) {
    carry();
    EXPECT_TRUE(session->subdocument().previewing());
    EXPECT_FALSE(plays()); // time stands still
    EXPECT_NEAR(time(), 1, 0.01);
    const auto held = session->subdocument().scene()->bodies[0];
    EXPECT_GT(held.initialPosition.x(), 0.05); // in the hand
    release(pixels({0, 0, 0}) + Eigen::Vector2d(40, 0));
    ASSERT_THAT(asked, SizeIs(1));
    const auto change = std::get<ipc::SubdocumentChanged>(asked[0].call);
    EXPECT_THAT(change.label, HasSubstr("Throw b at 1"));
    host.answer(asked[0].id, ipc::Revised{change.base + 1});
    asked.clear();
    exchange();
    settleHeld();
    exchange();
    EXPECT_THAT(session->subdocument().text(), HasSubstr("-start"));
    EXPECT_GT(session->subdocument().scene()->bodies[0].initialVelocity.x(), 0.1);
    EXPECT_TRUE(plays());
    EXPECT_GE(time(), 0.99);
    EXPECT_LE(time(), 1.3);
}

TEST_F(ThrowingTest, EscapeLetsItGoOnAsItWas) {
    carry();
    key("Escape");
    settleHeld();
    exchange();
    EXPECT_THAT(asked, IsEmpty());
    EXPECT_FALSE(session->subdocument().previewing());
    EXPECT_EQ(session->subdocument().scene()->simulator.start, 0);
    EXPECT_TRUE(plays());
    EXPECT_NEAR(time(), 1, 0.02);
}

TEST_F(ThrowingTest, WhatTheReaderSaysOfTimeMeanwhileCounts) {
    carry();
    ask(ipc::TimePause{});
    key("Escape");
    settleHeld();
    exchange();
    EXPECT_FALSE(plays());
}

// By the menu, by keys and by another text, before the new motion is known.
TEST_F(ThrowingTest, WhatTheReaderSaysOfTimeAfterAThrowCounts) {
    const auto answered = [](const auto&) {};
    const auto space = [&] {
        ipc::RenditionInput input;
        input.rendition = 1;
        input.type = ipc::InputType::keyPress;
        input.key = " ";
        host.notify(input);
    };
    const auto invoke = [&](const char* id) {
        host.request(ipc::MenuInvoke{id, std::nullopt}, answered);
    };
    const auto load = [&](ipc::Integer later) {
        host.request(ipc::SubdocumentLoad{start, session->subdocument().revision() + later},
                     answered);
    };
    const std::vector<std::pair<std::string, std::function<void()>>> said{
        {"nothing", [] {}},
        {"play", [&] { invoke("play"); }},
        {"pause", [&] { invoke("pause"); }},
        {"stop", [&] { invoke("stop"); }},
        {"step", [&] { invoke("step"); }},
        {"Space, Space", [&] { space(), space(); }},
        {"load", [&] { load(5); }}};
    for (const auto& [what, say] : said) {
        load(1);
        exchange();
        settleHeld();
        ask(ipc::TimeSeek{0});
        ask(ipc::TimePlay{});
        now += std::chrono::seconds(1);
        exchange();
        carry();
        ipc::RenditionInput letGo;
        letGo.rendition = 1;
        letGo.type = ipc::InputType::release;
        letGo.button = ipc::Button::left;
        letGo.x = pixels({0, 0, 0}).x() + 40;
        letGo.y = pixels({0, 0, 0}).y();
        host.notify(letGo);
        say();
        exchange();
        ASSERT_THAT(asked, SizeIs(1)) << what;
        const auto& change = std::get<ipc::SubdocumentChanged>(asked[0].call);
        host.answer(asked[0].id, ipc::Revised{change.base + 1});
        asked.clear();
        exchange();
        settleHeld();
        exchange();
        EXPECT_EQ(plays(), what == "nothing" || what == "play") << what;
    }
}

// --- clicks, and what is done with what they select ----------------------------------------------

class SelectingTest : public HandleEditingTest {
protected:
    void click(const Eigen::Vector2d& at, ipc::Button button = ipc::Button::left) {
        pointer(ipc::InputType::press, at, button, false);
        pointer(ipc::InputType::release, at, button, false);
        settle();
    }
    void plainKey(const std::string& name) {
        ipc::RenditionInput input;
        input.rendition = 1;
        input.type = ipc::InputType::keyPress;
        input.key = name;
        host.notify(input);
        exchange();
    }
    std::string offered() { // of the thing: "Delete ..."
        for (const ipc::MenuEntry& entry : menus)
            if (entry.id.starts_with("delete "))
                return entry.label;
        return {};
    }
    Eigen::Vector2d beside(const Eigen::Vector2d& at) { return {at.x() + 40, at.y()}; }
    const std::string two = ball + "body front ball -init_pos {0 0 1}\nbody back ball\n"
                                   "body b3 ball -init_pos {3 0 0}\n";
};

TEST_F(SelectingTest, AClickSelectsAndAnotherOneWhatLiesBehind) {
    open(two + "view above -eye {0 0 10} -look {0 0 0} -up {0 1 0}\n", {});
    const auto at = pixels({0, 0, 0});
    EXPECT_EQ(offered(), "");
    click(at);
    EXPECT_EQ(offered(), "Delete body \"front\"");
    click(at);
    EXPECT_EQ(offered(), "Delete body \"back\"");
    click({3, 3});
    EXPECT_EQ(offered(), "");
    click(at);
    EXPECT_EQ(offered(), "Delete body \"front\"");
    plainKey("Escape");
    EXPECT_EQ(offered(), "");
    EXPECT_THAT(asked, IsEmpty());
}

TEST_F(SelectingTest, ADragMovesWhatIsSelectedAndTurnsTheViewElsewhere) {
    open(two, {});
    const auto at = pixels({3, 0, 0});
    const auto attitude = camera.rotation;
    const auto pull = [&] {
        pointer(ipc::InputType::press, at, ipc::Button::left, false);
        pointer(ipc::InputType::move, at + Eigen::Vector2d(2, 0), ipc::Button::left, false);
        EXPECT_EQ(camera.rotation.angularDistance(attitude), 0);
        pointer(ipc::InputType::move, beside(at), ipc::Button::left, false);
        pointer(ipc::InputType::release, beside(at), ipc::Button::left, false);
    };
    click(at);
    pull();
    accepted("Move b3");
    EXPECT_GT(scene().bodies[2].initialPosition.x(), 3.05);
    EXPECT_EQ(camera.rotation.angularDistance(attitude), 0);
    EXPECT_EQ(offered(), "Delete body \"b3\"");
    click({3, 3});
    pull();
    settle();
    EXPECT_THAT(asked, IsEmpty());
    EXPECT_GT(camera.rotation.angularDistance(attitude), 0.01);
}

TEST_F(SelectingTest, TheMenuOfAThingIsToldBeforeWhatIsAskedNext) {
    open(two, {});
    const auto at = pixels({3, 0, 0});
    pointer(ipc::InputType::press, at, ipc::Button::right, false);
    ipc::RenditionInput release;
    release.rendition = 1;
    release.type = ipc::InputType::release;
    release.button = ipc::Button::right;
    release.x = at.x();
    release.y = at.y();
    host.notify(release);
    std::string then;
    host.request(ipc::Ping{}, [&](const ipc::Outcome<ipc::Done>&) { then = offered(); });
    exchange();
    EXPECT_EQ(then, "Delete body \"b3\"");
}

TEST_F(SelectingTest, DeleteTakesItOutAndAsksTwiceWhereOthersGoAlong) {
    open(two + "force -body b3 -x 1 -y 0 -z 0\n", {});
    click(pixels({0, 0, 1}));
    const render::Camera before = camera;
    plainKey("Delete");
    accepted("Delete body \"front\"");
    EXPECT_EQ(camera, before); // the others stay where they are seen
    EXPECT_THAT(text(), testing::Not(HasSubstr("front")));
    EXPECT_EQ(offered(), "");
    click(pixels({3, 0, 0}));
    plainKey("Delete");
    EXPECT_THAT(asked, IsEmpty());
    EXPECT_THAT(saidLast, HasSubstr("With body \"b3\" goes: "));
    plainKey("Delete");
    accepted("Delete body \"b3\"");
    EXPECT_EQ(scene().forces.size(), 0U);
}

TEST_F(SelectingTest, ACopyStandsBesideAndIsSelected) {
    open(two, {});
    click(pixels({3, 0, 0}));
    ask(ipc::MenuInvoke{"duplicate body \"b3\"", 1});
    accepted("Duplicate body \"b3\"");
    ASSERT_EQ(scene().bodies.size(), 4U);
    EXPECT_NEAR(scene().bodies[3].initialPosition.x(), 4.1, 1e-9);
    EXPECT_EQ(offered(), "Delete body \"" + scene().bodies[3].name + "\"");
    // Elements before it come and go, and it is selected still.
    const std::size_t end = text().size();
    ask(ipc::SubdocumentEdit{session->subdocument().revision() + 1,
                             {{{end, end}, "body b9 ball -init_pos {0 3 0}\n"}},
                             ""});
    settle();
    EXPECT_EQ(offered(), "Delete body \"" + scene().bodies[3].name + "\"");
}

TEST_F(SelectingTest, AFrameIsDrawnAroundIt) {
    open(two, {});
    const auto coloured = [&] {
        return std::ranges::count_if(frame, [](std::byte one) { return one != std::byte(0); });
    };
    EXPECT_EQ(coloured(), 0);
    click(pixels({3, 0, 0}));
    EXPECT_GT(coloured(), 100);
    click({3, 3});
    EXPECT_EQ(coloured(), 0);
}

} // namespace
} // namespace service
