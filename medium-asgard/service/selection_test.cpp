// Clicks in the document's picture, and the commands for the selected thing.
#include "service/handle_editing_testing.h"

namespace service {
namespace {

using namespace pointing;

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
