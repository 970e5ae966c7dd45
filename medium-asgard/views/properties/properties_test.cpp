// (text, field, text) in the pane of values.
#include "properties/properties_pane.h"
#include "viewers/editor.h"
#include "views/test_workshop.h"

#include <gmock/gmock.h>

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>

namespace views {
namespace {

using editing::Element;
using editing::Kind;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

const std::string shape = "shape_set s -desc {-sub {-sphere 0.5}}\n";
const std::string two = shape + "body a s -init_pos {1 2 0} -mass 2\nbody b s -init_pos {4 2 0}\n"
                                "force -body a -y {-9.81 * a.mass}\n";

class PropertiesTest : public testing::Test {
protected:
    static void SetUpTestSuite() { theApplication(); }
    void open(const std::string& text, std::vector<Element> selected) {
        document.setText(text, "Edit");
        ASSERT_TRUE(settle(document));
        document.select(std::move(selected));
        pane.show();
        QCoreApplication::processEvents();
    }
    // The rows follow a little after what they show.
    QLineEdit& field(const char* name) {
        EXPECT_TRUE(waitFor([&] { return pane.findChild<QLineEdit*>(name) != nullptr; })) << name;
        return *pane.findChild<QLineEdit*>(name);
    }
    void enter(const char* name, const QString& text) {
        QLineEdit& one = field(name);
        one.setFocus();
        one.selectAll();
        QTest::keyClicks(&one, text);
        if (text.isEmpty())
            QTest::keyClick(&one, Qt::Key_Delete);
        QTest::keyClick(&one, Qt::Key_Return);
    }
    void type(const char* name, const QString& text) {
        enter(name, text);
        ASSERT_TRUE(settle(document));
        settleTimers();
    }
    void choose(const char* name, const QString& text) {
        auto* box = pane.findChild<QComboBox*>(name);
        const int index = box->findText(text);
        ASSERT_GE(index, 0);
        box->setCurrentIndex(index);
        Q_EMIT box->activated(index);
        ASSERT_TRUE(settle(document));
        settleTimers();
    }
    static void settleTimers() { QTest::qWait(120); }

    TestWorkshop made;
    SceneDocument document{made.workshop()};
    int texts = 0;
    QString shapeOpened;
    PropertiesPane pane{document,
                        {[this] { ++texts; }, [this](const QString& name) { shapeOpened = name; },
                         [](const std::vector<Element>&) {}}};
};

TEST_F(PropertiesTest, ShowsWhatStandsInTheText) {
    open(two, {{Kind::body, 0}});
    EXPECT_EQ(pane.title(), "Body");
    EXPECT_EQ(pane.name().text(), "a");
    EXPECT_EQ(field("-init_pos2").text(), "2");
    EXPECT_EQ(field("-mass").text(), "2");
    EXPECT_EQ(field("-density").text(), "");
    EXPECT_EQ(field("-density").placeholderText(), ""); // its mass counts
    EXPECT_EQ(pane.findChild<QComboBox*>("-shape")->currentText(), "s");
    document.select({{Kind::force, 0}});
    settleTimers();
    EXPECT_EQ(pane.title(), "Force");
    EXPECT_TRUE(pane.name().isHidden());
    EXPECT_EQ(field("-y").text(), "-9.81 * a.mass");
    EXPECT_EQ(pane.findChild<QComboBox*>("-trajectory")->currentText(), "none");
    document.select({});
    settleTimers();
    EXPECT_THAT(pane.title().toStdString(), HasSubstr("Nothing is selected"));
}

// Grey, as the motion has it: of two alike the same number, of others from where to where.
TEST_F(PropertiesTest, SeveralBodiesHaveTheirMassWithoutAText) {
    SceneDocument real{engineWorkshop()};
    PropertiesPane values{real, {}};
    for (const auto& [second, mass] : {std::pair("", "0.523599"),
                                       {" -fixed 1", "0.523599"},
                                       {" -density 2", "0.523599 … 1.0472"}}) {
        real.setText(shape + "body a s\nbody b s -init_pos {4 2 0}" + second + "\n", "Edit");
        ASSERT_TRUE(settle(real));
        real.select({{Kind::body, 0}, {Kind::body, 1}});
        values.show();
        settleTimers();
        ASSERT_NE(values.findChild<QLineEdit*>("-mass"), nullptr);
        EXPECT_EQ(values.findChild<QLineEdit*>("-mass")->placeholderText(), mass) << second;
    }
}

TEST_F(PropertiesTest, NumbersHaveUnitsAndRestitutionSaysWhoseCounts) {
    const auto has = [&](const QString& words) {
        return std::ranges::any_of(pane.findChildren<QLabel*>(), [&](const QLabel* label) {
            return label->text().remove(QChar(0x2060)).replace(QChar(0xA0), ' ') == words;
        });
    };
    open(two, {{Kind::body, 0}});
    for (const char* words : {"Mass, kg", "Place, m", "Velocity, m/s", "Angular velocity, rad/s",
                              "Friction", "Of two bodies that meet the smaller one counts."})
        EXPECT_TRUE(has(words)) << words;
    document.select({{Kind::force, 0}});
    settleTimers();
    EXPECT_TRUE(has("Along y, N"));
    open(two + "force -body a -torque 1 -z 2\n", {{Kind::force, 1}});
    settleTimers();
    EXPECT_TRUE(has("Along z, N m"));
    open(two + "joint h -type hinge -body1 a -offset1 {0 1 0} -limits {-1 1} -stiffness 2\n"
               "joint s -type slider -body1 b -axis {1 0 0}\n",
         {{Kind::joint, 0}});
    settleTimers();
    for (const char* words : {"Limits, rad", "Stiffness, N m/rad", "Damping, N m s/rad",
                              "Friction, N m", "Speed, rad/s", "Motor, N m", "Rests at, rad"})
        EXPECT_TRUE(has(words)) << words;
    document.select({{Kind::joint, 1}});
    settleTimers();
    for (const char* words : {"Limits, m", "Stiffness, N/m", "Speed, m/s", "Friction, N"})
        EXPECT_TRUE(has(words)) << words;
    open(shape + "body a s -init_rot {0 0 1}\nbody b s -init_rot {1 0 0 0}\n", {{Kind::body, 0}});
    settleTimers();
    EXPECT_TRUE(has("Radius, m"));
    EXPECT_TRUE(has("Attitude, rad"));
    document.select({{Kind::body, 1}});
    settleTimers();
    EXPECT_TRUE(has("Attitude"));
    for (const QLabel* label : pane.findChildren<QLabel*>()) // no unit is torn apart
        if (label->text().startsWith("Angular velocity")) {
            EXPECT_EQ(label->text(), QStringLiteral("Angular velocity, rad/\u2060s"));
        }
}

TEST_F(PropertiesTest, AFieldWritesOneStepOfUndo) {
    open(two, {{Kind::body, 0}});
    type("-init_pos2", "5");
    EXPECT_THAT(document.text(), HasSubstr("body a s -init_pos {1 5 0} -mass 2\n"));
    EXPECT_EQ(document.undoLabel(), "Change place");
    type("-restitution", "0.5");
    EXPECT_THAT(document.text(), HasSubstr("-mass 2 -restitution 0.5\n"));
    type("-restitution", "");
    EXPECT_THAT(document.text(), HasSubstr("-mass 2\n"));
    document.undo();
    document.undo();
    document.undo();
    EXPECT_EQ(document.text(), two);
}

TEST_F(PropertiesTest, ANumberOfSevenDigitsIsSeenWhole) {
    open(shape + "body a s -init_pos {-1.162857 1.316727 0.4}\n", {{Kind::body, 0}});
    const QLineEdit& x = field("-init_pos1");
    EXPECT_EQ(x.text(), "-1.162857");
    const int words = x.fontMetrics().horizontalAdvance(x.text());
    const auto isWhole = [&] { return x.width() >= words + 6; }; // the frame, what is beside them
    pane.resize(pane.sizeHint());
    EXPECT_TRUE(waitFor(isWhole)) << x.width();
}

TEST_F(PropertiesTest, ABoxThatIsFixedDeadensNoBounce) {
    const std::string box = shape + "body a s -restitution 0 -friction 0.3\n";
    open(box, {{Kind::body, 0}});
    choose("-fixed", "yes");
    EXPECT_EQ(document.text(), shape + "body a s -friction 0.3 -fixed 1\n");
    choose("-fixed", "no");
    EXPECT_EQ(document.text(), shape + "body a s -friction 0.3 -restitution 0\n");
    document.undo();
    document.undo(); // one step each
    EXPECT_EQ(document.text(), box);
}

TEST_F(PropertiesTest, TheSizeOfItsShapeIsARow) {
    open(shape + "body a s\n", {{Kind::body, 0}});
    EXPECT_EQ(field("size1").text(), "0.5");
    EXPECT_EQ(field("size1").accessibleName(), "Radius");
    EXPECT_TRUE(field("size2").isHidden());
    type("size1", "0.25");
    EXPECT_THAT(document.text(), HasSubstr("-sphere 0.25"));
    EXPECT_EQ(document.undoLabel(), "Change the Size of s");
    type("size1", "-1");
    EXPECT_THAT(document.text(), HasSubstr("-sphere 0.25"));
    EXPECT_THAT(pane.sizeRow()->fault().toStdString(), HasSubstr("above 0"));
}

TEST_F(PropertiesTest, ABoxOnTheGridStandsThereWithAnotherSize) {
    const std::string box = "shape_set s -desc {-sub {-box {1 1 1}}}\n";
    open(box + "body a s -init_pos {0 0.5 0}\n", {{Kind::body, 0}});
    type("size2", "0.4");
    EXPECT_EQ(document.text(),
              "shape_set s -desc {-sub {-box {1 0.4 1}}}\nbody a s -init_pos {0 0.2 0}\n");
    document.undo(); // one step
    EXPECT_EQ(document.undoLabel(), "Edit");
}

TEST_F(PropertiesTest, AComputedPlaceStaysAndTheSizeIsTaken) {
    const std::string box = "shape_set s -desc {-sub {-box {1 1 1}}}\n";
    open(box + "set h [expr {0.25 * 2}]\nbody a s -init_pos \"0 $h 0\"\n", {{Kind::body, 0}});
    type("size2", "0.4");
    EXPECT_THAT(document.text(), HasSubstr("-box {1 0.4 1}"));
    EXPECT_THAT(document.text(), HasSubstr("set h [expr {0.25 * 2}]"));
}

TEST_F(PropertiesTest, SeveralOfOneShapeShareItsSize) {
    open(two, {{Kind::body, 0}, {Kind::body, 1}});
    EXPECT_EQ(field("size1").text(), "0.5");
    type("size1", "0.25");
    EXPECT_THAT(document.text(), HasSubstr("-sphere 0.25"));
    open(two + "shape_set other -desc {-sub {-sphere 0.5}}\nbody c other\n",
         {{Kind::body, 0}, {Kind::body, 2}});
    settleTimers();
    EXPECT_TRUE(field("size1").isHidden());
}

// A slope for a car, from the library's wedge.
TEST_F(PropertiesTest, APolyhedronIsStretchedByItsSize) {
    open("shape_set s -desc {-sub {-points {{-0.3 0 -0.3} {-0.3 0 0.3} {0.3 0 -0.3} {0.3 0 0.3} "
         "{0.3 0.3 -0.3} {0.3 0.3 0.3}}}}\nbody a s\n",
         {{Kind::body, 0}});
    EXPECT_EQ(field("size1").text(), "0.6");
    EXPECT_EQ(field("size2").text(), "0.3");
    EXPECT_EQ(field("size2").accessibleName(), "Size y");
    type("size1", "5");
    EXPECT_THAT(document.text(), HasSubstr("{-2.5 0 -0.3} {-2.5 0 0.3} {2.5 0 -0.3} {2.5 0 0.3} "
                                           "{2.5 0.3 -0.3} {2.5 0.3 0.3}"));
}

TEST_F(PropertiesTest, AShapeOfTwoPartsHasNoRowForItsSize) {
    open("shape_set s -desc {-sub {-sphere 0.5} -sub {-pos {1 0 0} -sphere 0.5}}\nbody a s\n",
         {{Kind::body, 0}});
    EXPECT_TRUE(field("size1").isHidden());
}

TEST_F(PropertiesTest, WhatMoreBodiesHaveIsSaidAtTheSize) {
    open(two, {{Kind::body, 0}});
    EXPECT_EQ(pane.sizeRow()->fault(), "");
    const auto labels = pane.findChildren<QLabel*>();
    EXPECT_TRUE(std::ranges::any_of(labels, [](const QLabel* one) {
        return one->isVisible() && one->text().startsWith("All 2 bodies");
    }));
}

TEST_F(PropertiesTest, AFlagThatIsAbsentSaysWhatItIs) {
    open(two, {{Kind::body, 0}});
    auto* fixed = pane.findChild<QComboBox*>("-fixed");
    EXPECT_EQ(fixed->currentText(), "no");
    choose("-fixed", "yes");
    EXPECT_THAT(document.text(), HasSubstr("-mass 2 -fixed 1\n"));
    choose("-fixed", "no");
    EXPECT_EQ(document.text(), two);
}

TEST_F(PropertiesTest, EscapeTakesTheSentenceAboutANameAway) {
    open(two, {{Kind::body, 0}});
    type("elementName", "my wheel");
    auto* fault = pane.findChild<QLabel*>("propertyFault");
    EXPECT_NE(fault->text(), "");
    QTest::keyClick(&field("elementName"), Qt::Key_Escape);
    EXPECT_TRUE(fault->isHidden());
    EXPECT_EQ(field("elementName").text(), "a");
}

TEST_F(PropertiesTest, WhatTheReaderRefusesIsSaidAtTheFieldAndLeavesTheText) {
    open(two, {{Kind::body, 0}});
    type("-mass", "-3");
    EXPECT_EQ(document.text(), two);
    EXPECT_NE(pane.row("-mass")->fault(), "");
    EXPECT_EQ(field("-mass").text(), "-3"); // to be mended
    QTest::keyClick(&field("-mass"), Qt::Key_Escape);
    EXPECT_EQ(field("-mass").text(), "2");
    EXPECT_EQ(pane.row("-mass")->fault(), "");
    document.select({{Kind::force, 0}});
    settleTimers();
    type("-y", "3 * nobody.mass");
    EXPECT_EQ(document.text(), two);
    EXPECT_THAT(pane.row("-y")->fault().toStdString(), HasSubstr("nobody"));
    EXPECT_FALSE(document.isPreview());
}

TEST_F(PropertiesTest, WhatIsTypedStaysWhileAnotherFieldIsRead) {
    open(two, {{Kind::body, 0}});
    made.readsSlowly = true;
    enter("-init_pos1", "5");
    QTest::keyClicks(&field("-init_pos2"), "6");
    made.readsSlowly = false;
    ASSERT_TRUE(waitFor([this] { return document.undoLabel() == "Change place"; }));
    ASSERT_TRUE(settle(document));
    settleTimers();
    EXPECT_EQ(field("-init_pos2").text(), "62"); // the caret was before it
    EXPECT_THAT(document.text(), HasSubstr("{5 2 0}"));
    QTest::keyClick(&field("-init_pos2"), Qt::Key_Return);
    ASSERT_TRUE(settle(document));
    EXPECT_THAT(document.text(), HasSubstr("{5 62 0}"));
}

TEST_F(PropertiesTest, ValuesThatAreEnteredWhileTheTextIsReadAreTakenThen) {
    open(two, {{Kind::body, 0}});
    made.readsSlowly = true;
    enter("-init_pos1", "5");
    enter("-init_pos2", "6");
    enter("-mass", "7");
    enter("-mass", "8");
    enter("elementName", "ball");
    document.select({{Kind::force, 0}}); // the fields are others by then
    settleTimers();
    made.readsSlowly = false;
    ASSERT_TRUE(waitFor([this] { return document.undoLabel() == "Rename a"; }));
    EXPECT_THAT(document.text(), HasSubstr("body ball s -init_pos {5 6 0} -mass 8\n"));
    for (int i = 0; i < 4; ++i)
        document.undo();
    EXPECT_EQ(document.text(), two);
}

// Its number in the scene is another one by then.
TEST_F(PropertiesTest, AValueGoesToTheBodyThatItWasTypedForWhenAnotherIsDeletedMeanwhile) {
    const std::string a = "body a s\n", b = "body b s -init_pos {4 0 0}\n",
                      c = "body c s -init_pos {8 0 0}\n";
    open(shape + a + b + c, {{Kind::body, 1}});
    made.readsSlowly = true;
    document.setText(shape + b + c, "Edit");
    enter("-mass", "7");
    made.readsSlowly = false;
    ASSERT_TRUE(settle(document));
    settleTimers();
    ASSERT_TRUE(settle(document));
    EXPECT_EQ(document.text(), shape + "body b s -init_pos {4 0 0} -mass 7\n" + c);
}

TEST_F(PropertiesTest, AValueThatNobodyHasReadIsNoStepOfUndo) {
    open(two, {{Kind::body, 0}});
    made.readsSlowly = true;
    enter("-mass", "abc");
    EXPECT_TRUE(document.isPreview());
    document.setText(two + "# more\n", "Edit");
    EXPECT_EQ(document.text(), two + "# more\n");
    document.undo();
    EXPECT_EQ(document.text(), two);
    made.readsSlowly = false;
    ASSERT_TRUE(settle(document));
    settleTimers();
    EXPECT_THAT(pane.row("-mass")->fault().toStdString(), HasSubstr("changed meanwhile"));
    QTest::keyClick(&field("-mass"), Qt::Key_Return); // and again
    ASSERT_TRUE(settle(document));
    EXPECT_THAT(pane.row("-mass")->fault().toStdString(), HasSubstr("abc"));
    EXPECT_EQ(document.text(), two);
}

TEST_F(PropertiesTest, AnotherSelectionForgetsWhatWasRefused) {
    open(two, {{Kind::body, 0}});
    type("-mass", "-3");
    document.select({{Kind::body, 1}});
    EXPECT_TRUE(waitFor([&] { return field("-mass").text().isEmpty(); }));
    EXPECT_EQ(pane.row("-mass")->fault(), "");
}

TEST_F(PropertiesTest, AnAttitudeIsTypedInDegrees) {
    open(two, {{Kind::body, 0}});
    type("-init_rotturn1", "90");
    EXPECT_THAT(document.text(), HasSubstr("-init_rot {0 0 1.570796327}\n"));
    EXPECT_EQ(field("-init_rotturn1").text(), "90");
    EXPECT_EQ(field("-init_rotturn4").text(), "1");
}

// It turns in the picture, or about the axis that was typed before.
TEST_F(PropertiesTest, ATurnIsAboutTheAxisThatPointsAtTheViewerUnlessAnotherIsTyped) {
    open(two, {{Kind::body, 0}});
    pane.setUsualAxis({1, 0, 0});
    EXPECT_EQ(field("-init_rotturn2").text(), "1");
    EXPECT_EQ(field("-init_rotturn4").text(), "0");
    type("-init_rotturn2", "0");
    EXPECT_THAT(pane.turn()->fault().toStdString(), HasSubstr("not 0 0 0"));
    type("-init_rotturn3", "2");
    EXPECT_EQ(document.text(), two); // nothing is turned yet
    EXPECT_EQ(field("-init_rotturn3").text(), "1");
    pane.setUsualAxis({0, 0, 1}); // the view turns: what was typed stays
    EXPECT_EQ(field("-init_rotturn3").text(), "1");
    type("-init_rotturn1", "90");
    EXPECT_THAT(document.text(), HasSubstr("-init_rot {0 1.570796327 0}\n"));
    document.select({{Kind::body, 1}});
    settleTimers();
    EXPECT_EQ(field("-init_rotturn4").text(), "1"); // another body, the usual axis
}

TEST_F(PropertiesTest, ANameIsChangedEverywhere) {
    open(two, {{Kind::body, 0}});
    type("elementName", "ball");
    EXPECT_THAT(document.text(), HasSubstr("body ball s"));
    EXPECT_THAT(document.text(), HasSubstr("force -body ball -y {-9.81 * ball.mass}"));
    EXPECT_THAT(document.selected(), ElementsAre(Element{Kind::body, 0}));
    type("elementName", "b");
    EXPECT_THAT(pane.fault().toStdString(), HasSubstr("something else"));
    EXPECT_EQ(pane.name().text(), "ball");
}

TEST_F(PropertiesTest, NamesFlagsAndChoicesAreBoxes) {
    open(two + "shape_set r -desc {-sub {-sphere 1}}\n", {{Kind::body, 1}});
    choose("-fixed", "yes");
    EXPECT_THAT(document.text(), HasSubstr("body b s -init_pos {4 2 0} -fixed 1\n"));
    choose("-fixed", "no");
    EXPECT_THAT(document.text(), HasSubstr("body b s -init_pos {4 2 0}\n"));
}

TEST_F(PropertiesTest, SeveralShowWhatTheyShare) {
    open(two, {{Kind::body, 0}, {Kind::body, 1}});
    EXPECT_EQ(pane.title(), "2 bodies");
    EXPECT_EQ(field("-init_pos1").placeholderText(), "1 … 4");
    EXPECT_EQ(field("-init_pos1").toolTip(), "a: 1\nb: 4");
    EXPECT_EQ(field("-init_pos2").text(), "2");
    EXPECT_EQ(field("-init_pos2").toolTip(), "");
    type("-init_pos2", "7");
    EXPECT_THAT(document.text(), HasSubstr("{1 7 0}"));
    EXPECT_THAT(document.text(), HasSubstr("{4 7 0}"));
    EXPECT_EQ(document.undoLabel(), "Change place");
}

TEST_F(PropertiesTest, SeveralAreCountedByTheirKind) {
    open(two + "force -body b -y 1\n", {{Kind::force, 0}, {Kind::force, 1}});
    EXPECT_EQ(pane.title(), "2 forces");
    open(two, {{Kind::body, 0}, {Kind::force, 0}});
    EXPECT_TRUE(waitFor([this] { return pane.title() == "2 elements"; }));
}

TEST_F(PropertiesTest, ALoopMakesOffersBelowTheField) {
    open(shape + "foreach i {0 3 6} {\n  body b$i s -init_pos \"$i 1 0\"\n}\n", {{Kind::body, 1}});
    type("-init_pos2", "2");
    EXPECT_THAT(pane.row("-init_pos")->fault().toStdString(), HasSubstr("is one of 3"));
    QPushButton* only = nullptr;
    for (QPushButton* button : pane.findChildren<QPushButton*>())
        if (button->text().startsWith("Only b3"))
            only = button;
    ASSERT_TRUE(only);
    only->click();
    ASSERT_TRUE(settle(document));
    EXPECT_EQ(document.shown().scene->bodies[1].initialPosition.y(), 2);
    EXPECT_EQ(document.shown().scene->bodies[0].initialPosition.y(), 1);
}

TEST_F(PropertiesTest, HiddenItDoesNothing) {
    open(two, {{Kind::body, 0}});
    pane.hide();
    document.select({{Kind::body, 1}});
    settleTimers();
    EXPECT_EQ(pane.name().text(), "a");
    pane.show();
    EXPECT_EQ(pane.name().text(), "b");
}

// For each option of the language that it may have a row with a field or a box, and no other row.
TEST_F(PropertiesTest, EachKindOfElementHasRowsThatCanBeRead) {
    open("simulator -finish 3\n" + two +
             "link -body1 a -x 0 -y 3 -z 0 -tightness 5\n"
             "joint j -type hinge -body1 b -axis {0 0 1}\njoint k -type hinge -body1 a\n"
             "gear g -joint1 j -joint2 k -ratio 2\nrope r -points {a {0 9 0} b}\n"
             "contact c -body1 a -body2 b -friction 0.2\n"
             "trajectory w -points {{0 0 0 0} {1 1 0 0}}\nconstrain a -rot w\n"
             "lightsource -direction {0 -1 0}\nview v -scale 2\nparameter q -value 2\n"
             "plot p -values {a.x}\n",
         {});
    ASSERT_TRUE(document.sceneIsCurrent()) << document.diagnostics().front().message;
    const scene::Scene& scene = *document.shown().scene;
    for (int i = 0; i <= static_cast<int>(Kind::plot); ++i) {
        const Element element{static_cast<Kind>(i), 0};
        ASSERT_TRUE(editing::sourceOf(scene, element)) << i;
        document.select({element});
        settleTimers();
        EXPECT_NE(pane.title(), "");
        const auto options = editing::optionsOf(scene, element);
        EXPECT_FALSE(options.empty()) << i;
        if (element.kind != Kind::joint) { // which has those of its type
            EXPECT_EQ(options.size(), editing::hintOf(scene, element).options.size()) << i;
        }
        for (const editing::OptionHint* option : options) {
            const PropertyRow* row = pane.row(std::string(option->name));
            ASSERT_TRUE(row) << option->name;
            EXPECT_TRUE(row->box() || !row->fields().empty()) << option->name;
        }
        for (const auto* one : pane.findChildren<QLineEdit*>())
            EXPECT_NE(one->accessibleName(), "") << one->objectName().toStdString();
        for (const auto* one : pane.findChildren<QComboBox*>())
            EXPECT_NE(one->accessibleName(), "") << one->objectName().toStdString();
    }
}

// A row that the reader would refuse whatever is typed there belongs to another type.
TEST_F(PropertiesTest, AJointHasTheRowsOfItsType) {
    const std::vector<std::string> types = {"fixed",       "hinge", "slider",
                                            "cylindrical", "screw", "distance",
                                            "universal",   "ball",  "planar"};
    std::string text = two;
    for (const std::string& type : types)
        text += "joint " + type + " -type " + type + " -body1 a -body2 b" +
                (type == "fixed" || type == "ball" || type == "distance" ? "" : " -axis {0 0 1}") +
                (type == "universal" ? " -axis2 {1 0 0}" : "") +
                (type == "screw" ? " -pitch 1" : "") + "\n";
    open(text, {});
    ASSERT_TRUE(document.sceneIsCurrent()) << document.diagnostics().front().message;
    const auto has = [&](const std::string& type, const char* option) {
        document.select({{Kind::joint, static_cast<std::size_t>(std::ranges::find(types, type) -
                                                                types.begin())}});
        settleTimers();
        return pane.row(option) != nullptr;
    };
    for (const std::string& type : types) {
        EXPECT_EQ(has(type, "-pitch"), type == "screw") << type;
        EXPECT_EQ(has(type, "-axis"), type != "fixed" && type != "ball" && type != "distance");
        EXPECT_EQ(has(type, "-axis2"), has(type, "-axis")) << type;
        EXPECT_EQ(has(type, "-motor2"), type == "cylindrical" || type == "universal") << type;
        EXPECT_EQ(has(type, "-motor"),
                  type == "hinge" || type == "slider" || type == "screw" || type == "distance")
            << type;
    }
}

// A typed number replaces all of the old one, also behind its point. A drag selects a part.
TEST_F(PropertiesTest, AClickOnANumberSelectsItAndTheNextOnePutsTheCaretInIt) {
    open(two, {{Kind::body, 0}});
    pane.activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(&pane, longestWait));
    type("-init_pos1", "1.25");
    QLineEdit& place = field("-init_pos1");
    const auto click = [&] { QTest::mouseClick(&place, Qt::LeftButton, {}, QPoint(8, 8)); };
    field("-init_pos2").setFocus();
    click();
    EXPECT_EQ(place.selectedText(), "1.25");
    click();
    EXPECT_EQ(place.selectedText(), "");
    QTest::mouseDClick(&place, Qt::LeftButton, {}, QPoint(8, 8));
    EXPECT_EQ(place.selectedText(), "1.25");
    QTest::keyClicks(&place, "5");
    QTest::keyClick(&place, Qt::Key_Return);
    ASSERT_TRUE(settle(document));
    click(); // after a look at the motion, say
    QTest::keyClicks(&place, "15");
    EXPECT_EQ(place.text(), "15"); // and not 515
    QTest::keyClick(&place, Qt::Key_Return);
    QTest::keyClicks(&place, "2");
    click(); // what is being typed is no matter of clicks
    EXPECT_EQ(place.selectedText(), "");
    QTest::keyClick(&place, Qt::Key_Return);
    ASSERT_TRUE(settle(document));
    document.select({{Kind::force, 0}});
    settleTimers();
    QLineEdit& along = field("-y");
    QTest::mouseClick(&along, Qt::LeftButton, {}, QPoint(8, 8));
    EXPECT_EQ(along.selectedText(), ""); // an expression is typed into
}

// A blank adds nothing to a number that was given by Return: it plays.
TEST_F(PropertiesTest, AfterReturnABlankIsTheWindows) {
    open(two, {{Kind::body, 0}});
    QLineEdit& mass = field("-mass");
    mass.setFocus();
    const auto keepsBlank = [&] {
        QKeyEvent asked(QEvent::ShortcutOverride, Qt::Key_Space, Qt::NoModifier, " ");
        asked.ignore();
        QCoreApplication::sendEvent(&mass, &asked);
        return asked.isAccepted();
    };
    mass.selectAll();
    QTest::keyClicks(&mass, "2.5");
    EXPECT_TRUE(keepsBlank());
    QTest::keyClick(&mass, Qt::Key_Return);
    EXPECT_FALSE(keepsBlank());
    ASSERT_TRUE(settle(document));
    EXPECT_FALSE(keepsBlank());
    const auto keeps = [&](Qt::Key key, const QString& letter) {
        QKeyEvent asked(QEvent::ShortcutOverride, key, Qt::NoModifier, letter);
        asked.ignore();
        QCoreApplication::sendEvent(&mass, &asked);
        return asked.isAccepted();
    };
    EXPECT_FALSE(keeps(Qt::Key_F, "f"));
    EXPECT_TRUE(keeps(Qt::Key_E, "e")); // "2.5e3"
    EXPECT_TRUE(keeps(Qt::Key_3, "3"));
    mass.selectAll();
    EXPECT_TRUE(keeps(Qt::Key_A, "a")); // a.mass, in its place
    mass.end(false);
    QTest::keyClicks(&mass, " * 2");
    EXPECT_TRUE(keepsBlank());
    EXPECT_TRUE(keeps(Qt::Key_F, "f"));
}

} // namespace
} // namespace views
