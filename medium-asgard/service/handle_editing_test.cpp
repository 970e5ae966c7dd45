// Drags of handles and throws in the document's picture.
#include "service/handle_editing_testing.h"

#include "handles/handle_layout.h"

namespace service {
namespace {

using namespace pointing;

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

// In a document's picture as in a viewer: the pointer opens what is folded, and what came out is
// dragged.
TEST_F(HandleEditingTest, HandlesThatAreFoldedComeOutUnderThePointer) {
    std::string text = ball + "body b1 ball -init_pos {0.5 0 0}\n";
    for (int i = 1; i <= 9; ++i)
        text += "force -body b1 -x 0 -y 0 -z 0\n";
    open(text, {"force-handles"});
    const auto folded = [&] { return std::ranges::count(handles.handles, true, &Handle::folded); };
    ASSERT_GT(folded(), 0);
    ASSERT_THAT(handles.crowds, SizeIs(1));
    const auto isDark = [](std::byte one) { return one == std::byte(0); };
    EXPECT_FALSE(std::ranges::all_of(frame, isDark)); // the number beside it
    const Eigen::Vector2d middle = handles.crowds[0].middle;
    const double reach = handles.crowds[0].reach;
    move(middle);
    settle();
    EXPECT_EQ(folded(), 0);
    EXPECT_TRUE(std::ranges::all_of(frame, isDark));
    const Handle last = handles.handles.back();
    const Eigen::Vector2d stand = render::standOf(last, camera, size);
    EXPECT_GT((stand - middle).norm(), reach);
    move(stand);
    settle();
    EXPECT_EQ(folded(), 0); // it stays open around the pointer
    press(stand);
    move(stand + Eigen::Vector2d(30, 0));
    settle();
    release(stand + Eigen::Vector2d(30, 0));
    ASSERT_THAT(asked, SizeIs(1));
    const auto& change = std::get<ipc::SubdocumentChanged>(asked[0].call);
    EXPECT_GE(change.edits.at(0).range.from, text.rfind("force")); // the last one's
    move({5, 5});
    settle();
    EXPECT_GT(folded(), 0);
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

} // namespace
} // namespace service
