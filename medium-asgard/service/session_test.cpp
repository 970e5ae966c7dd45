// What a session tells of a motion that is read and computed, and of its faults.
#include "service/session_testing.h"

namespace service {
namespace {

using namespace held;

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

} // namespace
} // namespace service
