// What is done with a selected thing by the menu of a document's picture.
#include "service/handle_editing_testing.h"

namespace service {
namespace {

using namespace pointing;

class ThingCommandsTest : public HandleEditingTest {
protected:
    void select(const render::Vector& place) {
        const auto at = pixels(place);
        pointer(ipc::InputType::press, at, ipc::Button::left, false);
        pointer(ipc::InputType::release, at, ipc::Button::left, false);
        settle();
    }
    const ipc::MenuEntry* entryOf(const std::string& label) {
        for (const ipc::MenuEntry& entry : menus)
            if (entry.label == label)
                return &entry;
        return nullptr;
    }
    // By its label; the question that it is answered with.
    std::optional<ipc::Question> invoke(const std::string& label,
                                        const std::vector<std::string>& values = {},
                                        bool isTrial = false) {
        const ipc::MenuEntry* entry = entryOf(label);
        EXPECT_NE(entry, nullptr) << label;
        return entry ? invokeById(entry->id, values, isTrial) : std::nullopt;
    }
    std::optional<ipc::Question> invokeById(const std::string& id,
                                            const std::vector<std::string>& values = {},
                                            bool isTrial = false) {
        std::optional<ipc::Question> question;
        refusal.clear();
        host.request(ipc::MenuInvoke{id, 1, values, isTrial},
                     [&](const ipc::Outcome<ipc::Invoked>& outcome) {
                         if (const auto* error = std::get_if<ipc::Error>(&outcome))
                             refusal = error->message;
                         else
                             question = std::get<ipc::Invoked>(outcome).question;
                     });
        exchange();
        return question;
    }
    std::string refusal;
    const std::string moving =
        ball + "body b1 ball -init_pos {-1   0 0} -init_dpos {1 0 0} -mass 2 ;# left\n";
};

TEST_F(ThingCommandsTest, AnExactValueIsAskedForAndWritesItsNumberOnly) {
    open(moving, {});
    EXPECT_EQ(entryOf("Velocity\u2026"), nullptr);
    select({-1, 0, 0});
    ASSERT_NE(entryOf("Velocity\u2026"), nullptr);
    EXPECT_EQ(entryOf("Velocity\u2026")->group, "Exact Values");
    const auto asks = invoke("Position\u2026");
    ASSERT_TRUE(asks);
    EXPECT_EQ(asks->title, "b1: position");
    ASSERT_EQ(asks->fields.size(), 3U);
    EXPECT_EQ(asks->fields[0].label, "x");
    EXPECT_EQ(asks->fields[0].value, "-1");
    EXPECT_EQ(asks->refusal, "");
    EXPECT_THAT(asked, IsEmpty());
    EXPECT_FALSE(invoke("Position\u2026", {"-1.25", "0", "0"}));
    accepted("Move b1");
    EXPECT_THAT(text(), HasSubstr("{-1.25   0 0} -init_dpos {1 0 0} -mass 2 ;# left"));
    EXPECT_FALSE(invoke("Position\u2026", {"-1.25", "0", "0"})); // nothing was typed
    EXPECT_THAT(asked, IsEmpty());
    const auto refused = invoke("Velocity\u2026", {"fast", "0", "0"});
    ASSERT_TRUE(refused);
    EXPECT_EQ(refused->refusal, "Decimal numbers, please.");
    EXPECT_EQ(refused->fields[0].value, "fast");
    EXPECT_THAT(asked, IsEmpty());
}

// As a graphical viewer's entry does, a question shows the line before and after.
TEST_F(ThingCommandsTest, ValuesThatAreTriedShowTheLineThatTheyChange) {
    open(moving, {});
    select({-1, 0, 0});
    const std::string before = text();
    ASSERT_TRUE(invoke("Position\u2026")->tries);
    const auto tried = invoke("Position\u2026", {"-1.25", "0", "0"}, true);
    ASSERT_TRUE(tried);
    EXPECT_EQ(tried->refusal, "");
    ASSERT_EQ(tried->changes.size(), 1U);
    EXPECT_EQ(tried->changes[0].line, 3);
    EXPECT_THAT(tried->changes[0].before, HasSubstr("-init_pos {-1   0 0}"));
    EXPECT_THAT(tried->changes[0].after, HasSubstr("-init_pos {-1.25   0 0}"));
    EXPECT_THAT(asked, IsEmpty());
    EXPECT_EQ(text(), before);
    EXPECT_FALSE(session->subdocument().previewing());
    EXPECT_THAT(invoke("Position\u2026", {"-1", "0", "0"}, true)->changes, IsEmpty());
    EXPECT_EQ(invoke("Position\u2026", {"-", "0", "0"}, true)->refusal, "Decimal numbers, please.");
    // Nothing else is done for a trial.
    EXPECT_FALSE(invoke("Fixed", {"1"}, true));
    EXPECT_NE(refusal, "");
    EXPECT_FALSE(invoke("Delete body \"b1\"", {"1"}, true));
    EXPECT_NE(refusal, "");
    EXPECT_THAT(asked, IsEmpty());
}

// The window that asks takes the keyboard, and with it what is selected.
TEST_F(ThingCommandsTest, AQuestionIsAnsweredWhenNothingIsSelectedAnyMore) {
    open(moving, {});
    select({-1, 0, 0});
    const std::string id = entryOf("Position\u2026")->id;
    ASSERT_TRUE(invokeById(id));
    pointer(ipc::InputType::focusOut, {0, 0}, ipc::Button::none, false);
    EXPECT_EQ(entryOf("Position\u2026"), nullptr);
    EXPECT_FALSE(invokeById(id, {"-1.5", "0", "0"}));
    EXPECT_EQ(refusal, "");
    accepted("Move b1");
    EXPECT_EQ(scene().bodies[0].initialPosition.x(), -1.5);
}

TEST_F(ThingCommandsTest, SizesAndSurfacesAreAskedFor) {
    open(moving, {});
    select({-1, 0, 0});
    const auto size = invoke("Size\u2026");
    ASSERT_TRUE(size);
    EXPECT_EQ(size->fields[0].label, "Radius");
    EXPECT_EQ(invoke("Size\u2026", {"-1"})->refusal, "A size is a number above 0.");
    EXPECT_FALSE(invoke("Size\u2026", {"0.25"}));
    accepted("Change the Size of ball");
    EXPECT_THAT(text(), HasSubstr("{-sphere 0.25}"));
    EXPECT_EQ(invoke("Surface\u2026")->fields.size(), 4U);
    EXPECT_FALSE(invoke("Surface\u2026", {"0.5", "0", "0", "0"}));
    accepted("Change the Surface of b1");
    EXPECT_EQ(scene().bodies[0].restitution, 0.5);
}

// What a loop makes can be changed in several ways; one is taken.
TEST_F(ThingCommandsTest, AValueThatALoopMakesHasWays) {
    open(ball + "for {set i 0} {$i < 3} {incr i} {\n    body b$i ball -init_pos \"[expr 3 * $i] "
                "0 0\"\n}\n",
         {});
    select({3, 0, 0});
    const auto asks = invoke("Position\u2026", {"3.5", "0", "0"});
    ASSERT_TRUE(asks);
    EXPECT_NE(asks->refusal, "");
    ASSERT_FALSE(asks->ways.empty());
    EXPECT_THAT(asked, IsEmpty());
    EXPECT_FALSE(invokeById(asks->ways.front().id));
    accepted("Move b1");
    EXPECT_EQ(scene().bodies[1].initialPosition.x(), 3.5);
    invokeById(asks->ways.front().id); // of a text that is gone
    EXPECT_THAT(refusal, HasSubstr("changed meanwhile"));
}

// As a viewer opens the same offers where the drag ended.
TEST_F(ThingCommandsTest, ARefusedDragLeavesItsWaysInTheMenu) {
    open(ball + "for {set i 0} {$i < 3} {incr i} {\n    body b$i ball -init_pos \"[expr 3 * $i] "
                "0 0\"\n}\n",
         {"position-handles"});
    const auto at = pixels({3, 0, 0});
    press(at);
    move(at + Eigen::Vector2d(20, 0));
    release(at + Eigen::Vector2d(20, 0));
    settle();
    EXPECT_THAT(asked, IsEmpty());
    EXPECT_THAT(saidLast, HasSubstr("Right button"));
    ASSERT_TRUE(menus.front().id.starts_with("way "));
    invokeById(menus.front().id);
    accepted("Move b1");
    EXPECT_GT(scene().bodies[1].initialPosition.x(), 3.01);
    EXPECT_FALSE(menus.front().id.starts_with("way "));
}

TEST_F(ThingCommandsTest, FixedIsASwitch) {
    open(moving, {});
    select({-1, 0, 0});
    EXPECT_FALSE(entryOf("Fixed")->checked);
    EXPECT_FALSE(invoke("Fixed"));
    accepted("Fix b1");
    EXPECT_TRUE(scene().bodies[0].fixed);
    EXPECT_TRUE(entryOf("Fixed")->checked);
    EXPECT_EQ(entryOf("Velocity\u2026"), nullptr);
}

TEST_F(ThingCommandsTest, APlotOfItIsWritten) {
    open(moving, {});
    select({-1, 0, 0});
    ASSERT_NE(entryOf("Speed, m/s"), nullptr);
    EXPECT_EQ(entryOf("Speed, m/s")->group, "New Plot of");
    EXPECT_FALSE(invoke("Speed, m/s"));
    accepted("New Plot");
    ASSERT_EQ(scene().plots.size(), 1U);
    EXPECT_THAT(scene().plots[0].values, testing::ElementsAre("hypot(b1.dx, b1.dy, b1.dz)"));
    EXPECT_THAT(saidLast, HasSubstr("Show As"));
}

TEST_F(ThingCommandsTest, AValueIsShownBesideIt) {
    open(moving, {});
    select({-1, 0, 0});
    const auto beside = [&]() -> const ipc::MenuEntry& {
        return *std::ranges::find_if(menus, [](const ipc::MenuEntry& entry) {
            return entry.group == "Show Beside It" && entry.label == "Speed, m/s";
        });
    };
    EXPECT_FALSE(beside().checked);
    invokeById(beside().id);
    accepted("Show Speed Beside It");
    ASSERT_EQ(scene().plots.size(), 1U);
    EXPECT_TRUE(scene().plots[0].beside);
    EXPECT_TRUE(beside().checked);
    invokeById(beside().id);
    accepted("Do Not Show Speed Beside It");
    EXPECT_TRUE(scene().plots.empty());
}

TEST_F(ThingCommandsTest, BodiesThatOverlapAreMovedApart) {
    open(ball + "body b1 ball\nbody b2 ball -init_pos {0.5 0 0}\n", {});
    ASSERT_NE(entryOf("Move Bodies Apart"), nullptr);
    EXPECT_FALSE(invoke("Move Bodies Apart"));
    for (int i = 0; i < 200 && asked.empty(); ++i)
        settle();
    accepted("Move Bodies Apart");
    EXPECT_GT((scene().bodies[1].initialPosition - scene().bodies[0].initialPosition).norm(),
              0.999);
    EXPECT_EQ(entryOf("Move Bodies Apart"), nullptr);
}

TEST_F(ThingCommandsTest, AJointThatIsOpenIsClosed) {
    open(ball + "body b1 ball\nbody b2 ball -init_pos {3 0 0}\n"
                "joint pin -type hinge -body1 b1 -body2 b2 -offset1 {1 0 0} -offset2 {-1.5 0 0}\n",
         {});
    ASSERT_NE(entryOf("Close Joints"), nullptr);
    EXPECT_FALSE(invoke("Close Joints"));
    for (int i = 0; i < 200 && asked.empty(); ++i)
        settle();
    accepted("Close Joints");
    EXPECT_EQ(entryOf("Close Joints"), nullptr);
}

// Everyday entries stand at hand, all others in a few submenus.
TEST_F(ThingCommandsTest, TheMenuIsShort) {
    open(moving, {});
    select({-1, 0, 0});
    std::set<std::string> groups;
    int rows = 0;
    for (const ipc::MenuEntry& entry : menus)
        rows += entry.group.empty() || groups.insert(entry.group).second ? 1 : 0;
    EXPECT_LE(rows, 19);
    EXPECT_EQ(groups.size(), 6U);
    std::set<std::string> ids;
    for (const ipc::MenuEntry& entry : menus)
        EXPECT_TRUE(ids.insert(entry.id).second) << entry.id;
}

} // namespace
} // namespace service
