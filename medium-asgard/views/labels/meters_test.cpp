// Values beside bodies: what they say at a time, and that a viewer that opens again has them.
#include "viewers/editor.h"
#include "views/test_workshop.h"

#include <gtest/gtest.h>

namespace views {

using commands::Quantity, commands::quantitiesOf;
namespace {

const std::string flying = "simulator -finish 2\n"
                           "shape_set s -desc {-sub {-sphere 0.5}}\n"
                           "body b s -init_pos {1 5 0} -init_dpos {3 0 0} -init_drot {0 0 1}\n";

class MetersTest : public testing::Test {
protected:
    static void SetUpTestSuite() { theApplication(); }
    void SetUp() override {
        editor.document().setText(flying, "Edit");
        ASSERT_TRUE(settle(editor.document()));
    }
    // On the first value at the right of the ball at the start.
    static QPointF besideBody(const SceneDisplay& display) {
        const QPointF middle = display.fromPixels(display.sight().pixels({1, 5, 0}));
        const double radius = 0.5 / display.sight().pixelLength({1, 5, 0});
        return middle + QPointF(std::min(radius, 60.0) + 10, 12);
    }
    void toggle(Meters& meters, const Quantity& quantity) {
        EXPECT_EQ(meters.toggle(quantity), QString());
        ASSERT_TRUE(settle(editor.document()));
    }
    Editor editor{engineWorkshop()};
    const editing::Element body{editing::Kind::body, 0};
};

TEST_F(MetersTest, AValueStandsBesideItsBodyAtEachTime) {
    SceneDisplay& display = editor.openGraphicalViewer()->display();
    Meters& meters = display.meters();
    const Quantity x{"&x", "b.x"};
    toggle(meters, x);
    EXPECT_EQ(editor.document().text(),
              flying + "\nplot plot1 -values {{b.x}} -labels {{x}} -beside 1\n");
    ASSERT_EQ(meters.all().size(), 1U);
    const Meter meter = meters.all().front();
    EXPECT_TRUE(waitFor([&] { return meters.words(meter, 0) == "x 1 m"; }));
    EXPECT_EQ(meters.words(meter, 1.2345), "x 4.7 m");
    EXPECT_EQ(meters.words(meter, 5), QStringLiteral("x –"));
    const QImage with = display.grab().toImage();
    toggle(meters, x);
    EXPECT_TRUE(meters.all().empty());
    EXPECT_NE(display.grab().toImage(), with);
    EXPECT_EQ(editor.document().text(), flying);
}

// The chart of an author is his: it stays when its value goes.
TEST_F(MetersTest, AChartThatIsThereGetsTheOptionAndLosesItAgain) {
    const std::string charted = flying + "plot way -values {b.x} -title Way\n";
    editor.document().setText(charted, "Edit");
    ASSERT_TRUE(settle(editor.document()));
    Meters& meters = editor.openGraphicalViewer()->display().meters();
    EXPECT_TRUE(meters.all().empty());
    toggle(meters, {"&x", "b.x"});
    EXPECT_EQ(meters.all().size(), 1U);
    EXPECT_EQ(editor.document().text(), flying + "plot way -values {b.x} -title Way -beside 1\n");
    toggle(meters, {"&x", "b.x"});
    EXPECT_EQ(editor.document().text(), charted);
}

// It follows its body from where it was put.
TEST_F(MetersTest, ADragPutsItElsewhereAndADoubleClickMakesItAChart) {
    SceneDisplay& display = editor.openGraphicalViewer()->display();
    display.lookAlong(geometry::Vector::UnitZ());
    Meters& meters = display.meters();
    toggle(meters, {"&x", "b.x"});
    ASSERT_TRUE(waitFor([&] { return meters.words(meters.all().front(), 0) == "x 1 m"; }));
    display.grab();
    const auto beside = [&] { return besideBody(display); };
    const QPointF there = beside();
    ASSERT_TRUE(meters.at(there));
    const auto send = [&](QEvent::Type type, const QPointF& at, Qt::MouseButtons held) {
        const bool isMove = type == QEvent::MouseMove;
        QMouseEvent event(type, at, display.mapToGlobal(at), isMove ? Qt::NoButton : Qt::LeftButton,
                          held, Qt::NoModifier);
        QCoreApplication::sendEvent(&display, &event);
    };
    const render::Camera camera = display.camera();
    const std::string text = editor.document().text();
    const QPointF away(90, 60);
    send(QEvent::MouseButtonPress, there, Qt::LeftButton);
    send(QEvent::MouseMove, there + away / 2, Qt::LeftButton);
    send(QEvent::MouseMove, there + away, Qt::LeftButton);
    send(QEvent::MouseButtonRelease, there + away, Qt::NoButton);
    EXPECT_EQ(display.camera(), camera);
    EXPECT_TRUE(editor.document().selected().empty());
    EXPECT_FALSE(meters.at(there));
    EXPECT_TRUE(meters.at(there + away));
    EXPECT_EQ(meters.all().front().look.aside, away);
    EXPECT_EQ(editor.document().text(), text);

    const QImage number = display.grab().toImage();
    send(QEvent::MouseButtonDblClick, there + away, Qt::LeftButton);
    EXPECT_TRUE(meters.all().front().look.isChart);
    EXPECT_TRUE(meters.at(there + away + QPointF(0, 50))); // it is larger
    EXPECT_NE(display.grab().toImage(), number);
    // Escape while it is held: it is where it was.
    send(QEvent::MouseButtonPress, there + away, Qt::LeftButton);
    send(QEvent::MouseMove, there, Qt::LeftButton);
    EXPECT_NE(meters.all().front().look.aside, away);
    QKeyEvent escape(QEvent::KeyPress, Qt::Key_Escape, Qt::NoModifier);
    QCoreApplication::sendEvent(&display, &escape);
    EXPECT_EQ(meters.all().front().look.aside, away);
    // Dragged out of the picture it stays at its edge.
    send(QEvent::MouseButtonPress, there + away, Qt::LeftButton);
    send(QEvent::MouseMove, QPointF(-4000, -4000), Qt::LeftButton);
    send(QEvent::MouseButtonRelease, QPointF(-4000, -4000), Qt::NoButton);
    EXPECT_TRUE(meters.at({4, 4}));
    // From there it comes back with the pointer, and it follows its body.
    send(QEvent::MouseButtonPress, {4, 4}, Qt::LeftButton);
    send(QEvent::MouseMove, {104, 44}, Qt::LeftButton);
    send(QEvent::MouseButtonRelease, {104, 44}, Qt::NoButton);
    EXPECT_TRUE(meters.at({104, 44}));
    EXPECT_FALSE(meters.at({98, 44}));
    render::Camera moved = camera;
    moved.position.x() += 0.1;
    const QPointF before = beside();
    display.setCamera(moved);
    display.grab();
    const QPointF followed = QPointF(104, 44) + beside() - before;
    EXPECT_GT(followed.x(), 110);
    EXPECT_TRUE(meters.at(followed));
    EXPECT_FALSE(meters.at(followed - QPointF(6, 0)));
}

// A press that hardly moves is a click.
TEST_F(MetersTest, AClickLeavesItBesideItsBody) {
    SceneDisplay& display = editor.openGraphicalViewer()->display();
    Meters& meters = display.meters();
    toggle(meters, {"&x", "b.x"});
    display.grab();
    const QPointF there = besideBody(display);
    EXPECT_TRUE(meters.press(there));
    EXPECT_TRUE(meters.move(there + QPointF(1, 1)));
    EXPECT_TRUE(meters.release());
    EXPECT_TRUE(meters.all().front().look.aside.isNull());
}

// The arrow of a body that is selected is not the value's, and the hint tells what lies there.
TEST_F(MetersTest, ItLeavesTheArrowsFreeAndTheHintGoesWithThePointer) {
    SceneDisplay& display = editor.openGraphicalViewer()->display();
    Meters& meters = display.meters();
    toggle(meters, {"&x", "b.x"});
    editor.document().select({body});
    display.grab();
    const auto arrow = display.gizmo().arrow(0);
    ASSERT_TRUE(arrow);
    EXPECT_FALSE(meters.at(arrow->center()));
    EXPECT_FALSE(meters.at(display.fromPixels(display.sight().pixels({1, 5, 0}))));

    QString hint;
    QObject::connect(&display.pointing(), &Pointing::changed, &display,
                     [&] { hint = display.pointing().hint(); });
    display.pointing().moveTo(besideBody(display), Qt::NoModifier);
    EXPECT_TRUE(waitFor([&] { return hint.startsWith("Drag moves this value"); }));
    display.pointing().moveTo({5, 200}, Qt::NoModifier);
    EXPECT_TRUE(waitFor([&] { return !hint.startsWith("Drag moves this value"); }));
}

// The others close up behind one that is dragged away, and it stays where it was put.
TEST_F(MetersTest, ThoseOfOneBodyStandBelowEachOther) {
    SceneDisplay& display = editor.openGraphicalViewer()->display();
    Meters& meters = display.meters();
    for (const char* one : {"b.x", "b.y", "b.z"})
        toggle(meters, {one, one});
    display.grab();
    const QPointF first = besideBody(display);
    const QPointF line(0, QFontMetricsF(display.font()).height() + 2);
    EXPECT_TRUE(meters.at(first + 2 * line));
    const auto drag = [&](const QPointF& from, const QPointF& to) {
        EXPECT_TRUE(meters.press(from));
        meters.move(to);
        meters.release();
    };
    drag(first + line, first + QPointF(120, 80));
    EXPECT_TRUE(meters.at(first + line));
    EXPECT_FALSE(meters.at(first + 2 * line));
    const QPointF aside = meters.all()[1].look.aside;
    drag(first, first + QPointF(120, -80));
    EXPECT_FALSE(meters.at(first + line));
    EXPECT_TRUE(meters.at(first + QPointF(120, 80)));
    EXPECT_EQ(meters.all()[1].look.aside, aside);
}

TEST_F(MetersTest, AnAngleHasItsUnit) {
    Meters& meters = editor.openGraphicalViewer()->display().meters();
    const auto all = quantitiesOf(*editor.document().shown().scene, body);
    const auto angle = std::ranges::find(all, "b.wz", &Quantity::expression);
    ASSERT_NE(angle, all.end());
    toggle(meters, *angle);
    const auto words = [&] { return meters.words(meters.all().front(), 0); };
    ASSERT_TRUE(waitFor([&] { return !words().contains(u'…'); }));
    EXPECT_EQ(words().toStdString(), "Angular velocity about z 1 rad/s");
}

// Of the way and of the turning: a ball and a turned rod against the whole scene's energy.
TEST_F(MetersTest, KineticEnergyCountsTheTurningToo) {
    const std::string free = "simulator -finish 1\nshape_set s -desc {-sub {-sphere 0.5}}\n"
                             "shape_set rod -desc {-sub {-box {2 0.2 0.4}}}\n"
                             "shape_set bent -desc {-sub {-box {2 0.2 0.4}} -sub "
                             "{-pos {1 1 0.3} -box {0.2 1 0.2}}}\n";
    for (const std::string one :
         {"body b s -init_dpos {3 0 1} -init_drot {0 4 1}",
          "body b rod -mass 2 -init_dpos {1 2 0} -init_rot {0.3 0.4 0.5} -init_drot {1 4 2}",
          "body b bent -init_rot {0.3 0.4 0.5} -init_drot {1 4 2}"}) {
        editor.document().setText(free + one + "\n", "Edit");
        ASSERT_TRUE(settle(editor.document()));
        const auto all = quantitiesOf(*editor.document().shown().scene, body);
        const auto energy = std::ranges::find(all, "J", &Quantity::unit);
        ASSERT_NE(energy, all.end());
        Meters& meters = editor.openGraphicalViewer()->display().meters();
        const Quantity whole{"whole", "scene.energy + 0*b.x"};
        toggle(meters, *energy);
        toggle(meters, whole);
        const auto words = [&](std::size_t which) {
            return meters.words(meters.all()[which], 0.7);
        };
        ASSERT_TRUE(waitFor([&] { return !words(0).contains(u'…') && !words(1).contains(u'…'); }));
        EXPECT_TRUE(words(0).endsWith(" J")) << words(0).toStdString();
        EXPECT_EQ(words(0).remove("Kinetic energy").remove(" J"),
                  words(1).remove("whole").remove(" J"))
            << one;
    }
}

TEST_F(MetersTest, TheCoordinateUpwardsIsTheHeight) {
    const auto labels = [&] {
        QStringList all;
        for (const Quantity& one : quantitiesOf(*editor.document().shown().scene, body))
            all << QString::fromStdString(one.label).remove('&');
        return all.mid(0, 3);
    };
    EXPECT_EQ(labels(), QStringList({"x", "Height, y", "z"}));
    editor.document().setText(flying + "force -body b -gravitational {0 0 -9.81}\n", "Edit");
    ASSERT_TRUE(settle(editor.document()));
    EXPECT_EQ(labels(), QStringList({"x", "y", "Height, z"}));
}

// A rope's and a contact's stand at a body of theirs that moves.
TEST_F(MetersTest, ValuesOfRopesAndContactsAreSeen) {
    editor.document().setText(flying + "body floor s -fixed 1 -init_pos {9 0 0}\n"
                                       "rope line -points {{0 9 0} {b}}\n"
                                       "contact touch -body1 floor -body2 b -friction 0.1\n",
                              "Edit");
    ASSERT_TRUE(settle(editor.document()));
    ASSERT_FALSE(editor.document().hasErrors()) << editor.document().diagnostics()[0].message;
    SceneDisplay& display = editor.openGraphicalViewer()->display();
    for (const editing::Kind kind : {editing::Kind::rope, editing::Kind::contact}) {
        const QImage without = display.grab().toImage();
        const editing::Element element{kind, 0};
        const auto all = quantitiesOf(*editor.document().shown().scene, element);
        ASSERT_FALSE(all.empty());
        toggle(display.meters(), all.front());
        EXPECT_NE(display.grab().toImage(), without);
    }
}

// A name is not what a picture shows: whatever is renamed is as hidden, and its values are where
// they were put.
TEST_F(MetersTest, ARenamedBodyStaysHiddenAndKeepsItsValues) {
    SceneDisplay& display = editor.openGraphicalViewer()->display();
    const Quantity x = quantitiesOf(*editor.document().shown().scene, body).front();
    toggle(display.meters(), x);
    display.meters().setLooks({{{"plot1", 0}, {{30, 20}, false}}});
    display.setHidden({"b"});
    editor.document().select({body});
    std::string text = editor.document().text();
    text.replace(text.find("body b "), 7, "body stone ");
    text.replace(text.find("b.x"), 3, "stone.x");
    text.replace(text.find("plot1"), 5, "way");
    editor.document().setText(text, "Edit");
    EXPECT_TRUE(settle(editor.document()));
    EXPECT_EQ(display.hidden(), std::set<std::string>{"stone"});
    ASSERT_EQ(display.meters().all().size(), 1U);
    EXPECT_EQ(display.meters().all()[0].name, (MeterName{"way", 0}));
    EXPECT_EQ(display.meters().all()[0].look.aside, QPointF(30, 20));
    EXPECT_EQ(editor.document().selected(), std::vector{body});
    editor.document().undo();
    ASSERT_TRUE(settle(editor.document()));
    EXPECT_EQ(display.hidden(), std::set<std::string>{"b"});
    editor.document().reset("shape_set s -desc {-sub {-sphere 1}}\nbody other s\n");
    ASSERT_TRUE(settle(editor.document()));
    EXPECT_FALSE(display.hidden().contains("other"));
}

TEST_F(MetersTest, AViewerThatOpensAgainHasThem) {
    Meters& before = editor.openGraphicalViewer()->display().meters();
    toggle(before, {"Speed", "abs(b.dx)"});
    before.setLooks({{before.all()[0].name, {{30, -20}, true}}});
    editor.restoreWindows(editor.windowsState(), {});
    const auto again = editor.graphicalViewers().back()->display().meters().all();
    ASSERT_EQ(again.size(), 1U);
    EXPECT_EQ(again[0].look.aside, QPointF(30, -20));
    EXPECT_TRUE(again[0].look.isChart);
}

} // namespace
} // namespace views
