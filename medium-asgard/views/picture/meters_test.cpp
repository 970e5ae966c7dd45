// Values beside bodies: what they say at a time, and that a viewer that opens again has them.
#include "viewers/editor.h"
#include "views/test_workshop.h"

#include <gtest/gtest.h>

namespace views {
namespace {

const std::string flying = "simulator -finish 2\n"
                           "shape_set s -desc {-sub {-sphere 0.5}}\n"
                           "body b s -init_pos {1 5 0} -init_dpos {3 0 0}\n";

class MetersTest : public testing::Test {
protected:
    static void SetUpTestSuite() { theApplication(); }
    void SetUp() override {
        editor.document().setText(flying, "Edit");
        ASSERT_TRUE(settle(editor.document()));
    }
    static Workshop workshop() { // values are read from the engine's own motion
        static TestWorkshop made;
        Workshop workshop = made.workshop();
        workshop.simulate = [](const auto& scene, const auto& options, const auto& observer) {
            return simulation::simulate(*scene, options, observer);
        };
        return workshop;
    }
    Editor editor{workshop()};
    const editing::Element body{editing::Kind::body, 0};
};

TEST_F(MetersTest, AValueStandsBesideItsBodyAtEachTime) {
    SceneDisplay& display = editor.openGraphicalViewer()->display();
    Meters& meters = display.meters();
    const Quantity x{"&x", "b.x"};
    meters.toggle(body, x);
    ASSERT_EQ(meters.all().size(), 1U);
    const Meter meter = meters.all().front();
    EXPECT_TRUE(waitFor([&] { return meters.words(meter, 0) == "x 1"; }));
    EXPECT_EQ(meters.words(meter, 1.2345), "x 4.7");
    EXPECT_EQ(meters.words(meter, 5), QStringLiteral("x –"));
    const QImage with = display.grab().toImage();
    meters.toggle(body, x);
    EXPECT_TRUE(meters.all().empty());
    EXPECT_NE(display.grab().toImage(), with);
    EXPECT_EQ(editor.document().text(), flying);
}

TEST_F(MetersTest, AViewerThatOpensAgainHasThem) {
    editor.openGraphicalViewer()->display().meters().toggle(body, {"Speed", "abs(b.dx)"});
    editor.restoreWindows(editor.windowsState(), {});
    const auto& again = editor.graphicalViewers().back()->display().meters().all();
    ASSERT_EQ(again.size(), 1U);
    EXPECT_EQ(again[0].element, "b");
    EXPECT_EQ(again[0].quantity.expression, "abs(b.dx)");
}

} // namespace
} // namespace views
