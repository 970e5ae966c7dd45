// Sliders of parameters and motors write their numbers into the text.
#include "panels/parameters_panel.h"
#include "picture/creating_testing.h"

#include <QCheckBox>

#include <gmock/gmock.h>

namespace views {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

TEST_F(CreatingTest, AParametersSliderIsItsNumberInTheText) {
    open("parameter g -value 1.0 -min 0 -max 4 -label pull -unit N ;# drag me\n" + balls);
    const std::string before = text();
    auto* panel = viewer->findChild<ParametersPanel*>();
    ASSERT_NE(panel, nullptr);
    QSlider* slider = panel->slider("g");
    ASSERT_NE(slider, nullptr);
    EXPECT_EQ(slider->value(), 250);
    slider->setSliderDown(true);
    slider->setSliderPosition(500);
    slider->setSliderPosition(750);
    EXPECT_THAT(text(), StartsWith("parameter g -value 3.0 -min 0 -max 4 -label pull"));
    slider->setSliderDown(false);
    done();
    EXPECT_EQ(scene().parameters[0].value, 3);
    QTest::keyClick(slider, Qt::Key_Right);
    done();
    EXPECT_NEAR(scene().parameters[0].value, 3.04, 1e-9);
    editor.document().undo();
    editor.document().undo();
    EXPECT_EQ(text(), before);
}

TEST_F(CreatingTest, AMotorsSliderIsItsNumberInTheText) {
    open(balls + "joint pin -type hinge -body1 b1 -offset1 {0 0 0} -speed 2 ;# turns\n"
                 "joint rail -type cylindrical -body1 b2 -axis {0 1 0} -motor2 {0.5}\n"
                 "body b3 ball -init_pos {5 0 0}\n"
                 "joint free -type hinge -body1 b3 -offset1 {1 0 0} -motor {sin(t)}\n");
    auto* panel = viewer->findChild<ParametersPanel*>();
    EXPECT_EQ(panel->title(), "Motors");
    EXPECT_EQ(panel->slider("free -motor"), nullptr); // it is no number
    ASSERT_NE(panel->slider("rail -motor2"), nullptr);
    QSlider* slider = panel->slider("pin -speed");
    ASSERT_NE(slider, nullptr);
    EXPECT_EQ(slider->value(), 750); // between -4 and 4
    slider->setSliderDown(true);
    slider->setSliderPosition(500);
    slider->setSliderPosition(250);
    EXPECT_THAT(text(), HasSubstr("-speed -2 ;# turns"));
    slider->setSliderDown(false);
    done();
    EXPECT_EQ(scene().joints[0].coordinates[0].speed, "-2");
    EXPECT_EQ(slider->value(), 250); // its ends are as wide as they were
    panel->slider("rail -motor2")->setValue(1000);
    done();
    EXPECT_THAT(text(), HasSubstr("-motor2 {1.0}"));
    editor.document().undo();
    editor.document().undo();
    EXPECT_THAT(text(), HasSubstr("-speed 2 ;# turns"));
}

TEST_F(CreatingTest, UnderAHostASliderChangesTheTextToo) {
    open("parameter g -value 1 -min 0 -max 4\n" + balls);
    std::vector<std::string> told;
    editor.document().setHostLink(
        {[&](const text::Edit& edit, const QString&) { told.push_back(edit.text); }, [] {}, [] {}});
    QSlider* slider = viewer->findChild<ParametersPanel*>()->slider("g");
    slider->setSliderDown(true);
    slider->setSliderPosition(500);
    slider->setSliderPosition(750);
    slider->setSliderDown(false);
    EXPECT_THAT(text(), StartsWith("parameter g -value 3 -min"));
    EXPECT_EQ(told, std::vector<std::string>{"3"});
}

TEST_F(CreatingTest, KeysOfASliderAreHeardWhileTheSceneIsRead) {
    open("parameter g -value 1.00 -min 0 -max 4\n" + balls);
    QSlider* slider = viewer->findChild<ParametersPanel*>()->slider("g");
    for (int i = 0; i < 5; ++i)
        QTest::keyClick(slider, Qt::Key_Right);
    ASSERT_TRUE(waitFor([&] {
        return editor.document().work() == Work::none && editor.document().sceneIsCurrent() &&
               scene().parameters[0].value > 1.19;
    })) << text();
    EXPECT_NEAR(scene().parameters[0].value, 1.2, 1e-9);
}

TEST_F(CreatingTest, AKeyIsForItsSliderThoughAnotherStandsThereWhenTheTextIsRead) {
    const std::string own = "parameter g -value 1.00 -min 0 -max 4\n" + balls;
    open(own);
    auto* panel = viewer->findChild<ParametersPanel*>();
    editor.document().setText("parameter a -value 1.00 -min 0 -max 4\n" + own, "Edit");
    ASSERT_FALSE(editor.document().sceneIsCurrent());
    QTest::keyClick(panel->slider("g"), Qt::Key_Right);
    ASSERT_TRUE(waitFor([&] {
        return editor.document().sceneIsCurrent() && scene().parameters.size() == 2 &&
               scene().parameters[1].value > 1;
    })) << text();
    EXPECT_EQ(scene().parameters[0].value, 1);
    EXPECT_NEAR(scene().parameters[1].value, 1.04, 1e-9);
}

} // namespace
} // namespace views
