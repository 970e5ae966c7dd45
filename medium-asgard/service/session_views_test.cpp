// How renditions are seen and turned, and when they are drawn.
#include "service/session_testing.h"

namespace service {
namespace {

using namespace held;

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
        turn(rendition);
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

TEST_F(SessionTest, TheGridAndTheSunStayWhileOneEdits) {
    using Keeps = render::Renderer::Keeps;
    load("a");
    computedTo(10);
    until([&] { return told->state == ipc::MotionState::current; });
    show();
    until([&] { return !frames.empty(); });
    const auto last = around.last;
    ASSERT_NE(last, nullptr);
    EXPECT_EQ(around.keeps, Keeps::nothing);
    const auto shownAgain = [&] {
        until([&] { return !session->subdocument().computing(); });
        now += std::chrono::seconds(1);
        exchange();
        host.notify(ipc::RenditionAck{1, frames.back().serial});
        exchange();
        EXPECT_EQ(around.last, last);
        return around.keeps;
    };
    host.notify(ipc::RenditionAck{1, frames.back().serial});
    ask(ipc::SubdocumentEdit{2, {{0, 1, "b"}}, "Edit"});
    computedTo(10);
    EXPECT_EQ(shownAgain(), Keeps::whereItFits); // all of the motion is framed anew
    turn(1);
    EXPECT_EQ(shownAgain(), Keeps::all); // the view is its user's
    load("a", 3);                        // an edit that is too large for the protocol
    EXPECT_EQ(shownAgain(), Keeps::all);
    ask(ipc::RenditionDestroy{1});
    until([&] { return !session->subdocument().computing(); });
    now += std::chrono::seconds(1);
    show();
    EXPECT_NE(around.last, last);
    EXPECT_EQ(around.keeps, Keeps::nothing);
}

// Until its first motion is whole nothing says how deep it leads.
TEST_F(SessionTest, TheGridAndTheSunAreThoseOfTheFirstWholeMotion) {
    using Keeps = render::Renderer::Keeps;
    load("a");
    computedTo(2);
    show();
    until([&] { return !frames.empty(); });
    const auto shownAgain = [&] {
        host.notify(ipc::RenditionAck{1, frames.back().serial});
        const std::size_t before = frames.size();
        ask(ipc::TimeSeek{0.1 * static_cast<double>(before)});
        now += std::chrono::seconds(1);
        exchange();
        EXPECT_GT(frames.size(), before);
        return around.keeps;
    };
    EXPECT_EQ(shownAgain(), Keeps::nothing);
    computedTo(10);
    until([&] { return told->state == ipc::MotionState::current; });
    EXPECT_EQ(shownAgain(), Keeps::nothing); // of the whole motion
    EXPECT_EQ(shownAgain(), Keeps::whereItFits);
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

} // namespace
} // namespace service
