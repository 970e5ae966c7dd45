#include "point_edits/shape_library.h"
#include "point_edits/shape_points.h"
#include "shapes/shape_editor.h"
#include "surroundings/triad.h"
#include "views/test_workshop.h"

#include <gtest/gtest.h>

#include "shapes/shape_names.h"
#include "viewers/editor.h"

#include <QLineEdit>
#include <QListWidget>
#include <QMessageBox>
#include <QPushButton>

#include <random>

namespace views {
namespace {

using geometry::Vector;

const std::string text = "shape_set corner -desc {\n"
                         "  -sub {-points {{0 0 0} {1 0 0} {0 1 0} {0 0 1}}}\n"
                         "  -sub {-pos {2 0 0} -sphere 0.5}\n}\nbody b1 corner\n";

class ShapeEditorTest : public testing::Test {
protected:
    static void SetUpTestSuite() { theApplication(); }

    void SetUp() override { open(text); }

    void open(const std::string& scene) {
        document.setText(scene, "Edit");
        ASSERT_TRUE(settle(document));
        editor = std::make_unique<ShapeEditor>(document, pictures);
        editor->setAttribute(Qt::WA_DeleteOnClose, false);
        editor->show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(editor.get(), longestWait));
    }

    [[nodiscard]] QPoint at(const Vector& place) const {
        return editor->display().position(place).toPoint();
    }
    void drag(QPoint from, QPoint by, Qt::KeyboardModifiers modifiers = {}) {
        ShapeDisplay& display = editor->display();
        QTest::mousePress(&display, Qt::LeftButton, modifiers, from);
        for (int k = 1; k <= 4; ++k) {
            const QPoint now = from + by * k / 4;
            QMouseEvent move(QEvent::MouseMove, now, display.mapToGlobal(now), Qt::NoButton,
                             Qt::LeftButton, modifiers);
            QCoreApplication::sendEvent(&display, &move);
        }
        QTest::mouseRelease(&display, Qt::LeftButton, modifiers, from + by);
        ASSERT_TRUE(settle(document));
    }
    void type(const QString& name, const QString& value) {
        for (QLineEdit* field : editor->findChildren<QLineEdit*>())
            if (field->accessibleName() == name) {
                field->setFocus();
                field->selectAll();
                QTest::keyClicks(field, value);
                QTest::keyClick(field, Qt::Key_Return);
            }
        ASSERT_TRUE(settle(document));
    }
    [[nodiscard]] const scene::Part& part(std::size_t index) const {
        return document.shown().scene->shapeSets.at(0).parts.at(index);
    }

    static scene::Scene theScene(const std::string& of) { return theReader().read(of).scene; }

    TestWorkshop made;
    SceneDocument document{made.workshop()};
    std::shared_ptr<PictureThread> pictures = std::make_shared<PictureThread>();
    std::unique_ptr<ShapeEditor> editor;
};

TEST_F(ShapeEditorTest, WhyNothingCanBeChangedIsSaidUntilItIsNoLongerSo) {
    document.setText(text + "bdy b2\n", "Edit");
    ASSERT_TRUE(settle(document));
    drag(at({0, 1, 0}), {30, -40});
    EXPECT_NE(editor->words().indexOf("errors"), -1) << qPrintable(editor->words());
    EXPECT_EQ(document.text(), text + "bdy b2\n");
    document.undo();
    ASSERT_TRUE(settle(document));
    EXPECT_TRUE(editor->words().startsWith("Click chooses a part"));
}

// Closed while the text was read, which then had errors, and opened again.
TEST_F(ShapeEditorTest, StaysOpenWhenItIsWantedAgain) {
    drag(at({0, 1, 0}), {30, -40});
    document.setText(document.text() + "bdy b2\n", "Edit");
    editor->close();
    ASSERT_TRUE(settle(document));
    editor->show();
    document.undo();
    ASSERT_TRUE(settle(document));
    EXPECT_TRUE(editor->isVisible());
}

TEST_F(ShapeEditorTest, KeysMoveTheVertexThatWasChosenWhenTheyWerePressed) {
    const auto key = [&](Qt::Key which) { QTest::keyClick(&editor->display(), which); };
    key(Qt::Key_PageDown);
    const auto first = editor->display().chosenPoint();
    ASSERT_TRUE(first);
    key(Qt::Key_Right);
    ASSERT_FALSE(document.sceneIsCurrent());
    key(Qt::Key_Right); // while the text is read
    key(Qt::Key_PageDown);
    key(Qt::Key_Up);
    const auto second = editor->display().chosenPoint();
    ASSERT_NE(first, second);
    const auto before = editing::pointsOf(editing::draftOf(theScene(text).shapeSets[0])[0].part);
    ASSERT_TRUE(waitFor([&] { // one after the other, when the text was read
        return document.sceneIsCurrent() && editing::pointsOf(part(0))[*second] != before[*second];
    }));
    EXPECT_EQ(editor->display().chosenPoint(), second);
    const auto after = editing::pointsOf(part(0));
    for (std::size_t i = 0; i < before.size(); ++i)
        EXPECT_EQ(before[i] != after[i], i == *first || i == *second) << i;
    for (int k = 0; k < 3; ++k) // three steps of undo
        document.undo();
    EXPECT_EQ(document.text(), text);
}

TEST_F(ShapeEditorTest, ADraggedVertexChangesItsNumbersInOneStepOfUndo) {
    drag(at({0, 1, 0}), {30, -40});
    const Vector moved = editing::pointsOf(part(0))[2];
    EXPECT_GT(moved.y(), 1.05);
    EXPECT_NE(document.text().find("-points {{0 0 0} {1 0 0} {"), std::string::npos);
    EXPECT_NE(document.text().find("{0 0 1}}}\n  -sub {-pos {2 0 0} -sphere 0.5}\n}\nbody b1"),
              std::string::npos);
    EXPECT_EQ(document.undoLabel(), "Move Vertex of corner");
    document.undo();
    EXPECT_EQ(document.text(), text);
}

// Beside the vertices a drag turns the view, with Shift nothing; there Shift drags, too.
TEST_F(ShapeEditorTest, ADragBesideTheVerticesIsTheViews) {
    const QPoint beside = at({0, 1, 0}) + QPoint(0, -30);
    drag(beside, {30, -10});
    EXPECT_EQ(document.text(), text);
    EXPECT_NE(at({0, 1, 0}) + QPoint(0, -30), beside);
    drag(at({0, 1, 0}), {30, -40}, Qt::ShiftModifier);
    EXPECT_EQ(document.undoLabel(), "Move Vertex of corner");
}

// As in a scene's picture: again in one place chooses what lies behind, and on nothing none is.
TEST_F(ShapeEditorTest, AClickChoosesThePart) {
    const auto click = [&](const QPoint& where) {
        QTest::mouseClick(&editor->display(), Qt::LeftButton, {}, where);
        return editor->display().chosenPart();
    };
    editor->display().lookAlong(Vector::UnitX());
    const QPoint both = at({2.5, 0.2, 0.15}); // the sphere, before the corner
    EXPECT_EQ(click(both), 1U);
    EXPECT_EQ(click(both), 0U);
    EXPECT_EQ(click(both), 1U);
    auto* list = editor->findChild<QListWidget*>("parts");
    EXPECT_EQ(list->currentRow(), 1);
    EXPECT_EQ(click(QPoint(editor->display().width() - 20, 20)), std::nullopt);
    EXPECT_EQ(list->currentRow(), -1);
    EXPECT_EQ(document.text(), text);
}

// Grid, shadows and axes as in a scene's picture, whose triad turns the view.
TEST_F(ShapeEditorTest, ThePictureIsThatOfAScene) {
    ShapeDisplay& display = editor->display();
    display.grab();
    ASSERT_NE(display.picture().last(), nullptr);
    EXPECT_EQ(display.picture().last()->fault, "");
    EXPECT_TRUE(display.picture().last()->ground);
    const render::Size size = display.picture().pixelSize();
    for (const render::TriadEnd& end : render::triadOf(display.picture().last()->camera, size))
        if (end.axis == 1 && !end.against) {
            QTest::mouseClick(&display, Qt::LeftButton, {},
                              display.picture().fromPixels(end.place).toPoint());
            break;
        }
    EXPECT_EQ(display.screenAxis(2), Vector::UnitY());
    EXPECT_EQ(display.chosenPart(), 0U);
}

TEST_F(ShapeEditorTest, ASphereHasItsCentreAndAPointOfItsSurface) {
    drag(at({2.5, 0, 0}), {40, 0});
    EXPECT_GT(std::get<scene::SphereShape>(part(1).shape).radius, 0.55);
    EXPECT_EQ(part(1).position, Vector(2, 0, 0));
    EXPECT_EQ(editor->display().chosenPart(), 1U);
}

TEST_F(ShapeEditorTest, VerticesAreAddedAndDeleted) {
    QTest::mouseClick(&editor->display(), Qt::LeftButton, Qt::ShiftModifier, at({0, 0, 1}));
    ASSERT_TRUE(settle(document));
    EXPECT_EQ(document.text(), text); // choosing changes nothing
    QTest::mousePress(&editor->display(), Qt::MiddleButton, Qt::ShiftModifier, at({1, 1, 1}));
    ASSERT_TRUE(settle(document));
    ASSERT_EQ(editing::pointsOf(part(0)).size(), 5U);
    const Vector added = editing::pointsOf(part(0))[4];
    QTest::mousePress(&editor->display(), Qt::RightButton, Qt::ShiftModifier, at(added));
    ASSERT_TRUE(settle(document));
    EXPECT_EQ(document.text(), text);
    QTest::mousePress(&editor->display(), Qt::RightButton, Qt::ShiftModifier, at({1, 0, 0}));
    ASSERT_TRUE(settle(document));
    EXPECT_EQ(document.text(), text);
    EXPECT_NE(editor->words().indexOf("needs four vertices"), -1);
}

TEST_F(ShapeEditorTest, ThePartCannotBecomeFlat) {
    Q_EMIT editor->display().chosen(0, 3);
    type("z of the vertex", "0");
    EXPECT_EQ(document.text(), text);
    EXPECT_EQ(editor->words(), "There the part would be flat.");
}

TEST_F(ShapeEditorTest, EscapeGivesTheOldTextBack) {
    ShapeDisplay& display = editor->display();
    const QPoint from = at({0, 1, 0});
    QTest::mousePress(&display, Qt::LeftButton, Qt::ShiftModifier, from);
    QMouseEvent move(QEvent::MouseMove, from + QPoint(20, 20), QPointF(), Qt::NoButton,
                     Qt::LeftButton, Qt::ShiftModifier);
    QCoreApplication::sendEvent(&display, &move);
    EXPECT_NE(document.text(), text); // it follows at once
    QTest::keyClick(&display, Qt::Key_Escape);
    EXPECT_EQ(document.text(), text);
    EXPECT_EQ(document.undoLabel(), "Edit");
}

TEST_F(ShapeEditorTest, PlacesSnapToTheGrid) {
    editor->display().setGrid(0.25);
    drag(at({0, 1, 0}), {17, -43});
    const Vector moved = editing::pointsOf(part(0))[2];
    EXPECT_EQ(Vector((moved / 0.25).array().round() * 0.25), moved);
    EXPECT_NE(moved, Vector(0, 1, 0));
}

TEST_F(ShapeEditorTest, PartsAreAddedChosenAndDeleted) {
    editor->addParts({editing::box({1, 2, 3})}, "Add Box");
    ASSERT_TRUE(settle(document));
    EXPECT_NE(document.text().find("-sphere 0.5}\n  -sub {-box {1 2 3}}\n}"), std::string::npos);
    EXPECT_EQ(editor->display().chosenPart(), 2U);
    QTest::keyClick(editor.get(), Qt::Key_Delete, Qt::ShiftModifier);
    ASSERT_TRUE(settle(document));
    EXPECT_EQ(document.text(), text);
}

TEST_F(ShapeEditorTest, InnerVerticesGoWhenAShapeThatWasEditedIsLeft) {
    QTest::mouseClick(&editor->display(), Qt::LeftButton, Qt::ShiftModifier, at({0, 0, 1}));
    editor->display().choose(0, 3);
    Q_EMIT editor->display().addWanted({0.1, 0.1, 0.1});
    ASSERT_TRUE(settle(document));
    EXPECT_EQ(editing::pointsOf(part(0)).size(), 5U); // white until then
    editor->close();
    EXPECT_EQ(document.text(), text);
    EXPECT_EQ(document.undoLabel(), "Convex Hull of corner");
}

TEST_F(ShapeEditorTest, LookingAtAShapeChangesNothing) {
    const std::string inner = "shape_set c -desc {-sub {-points {{0 0 0} {1 0 0} {0 1 0} {0 0 1} "
                              "{0.1 0.1 0.1}}}}\n";
    document.setText(inner, "Edit");
    ASSERT_TRUE(settle(document));
    editor->close();
    EXPECT_EQ(document.text(), inner);
}

TEST_F(ShapeEditorTest, TheButtonMakesTheHullOfTheChosenPart) {
    document.setText("shape_set c -desc {-sub {-points {{0 0 0} {1 0 0} {0 1 0} {0 0 1} {0.1 0.1 "
                     "0.1}}}}\n",
                     "Edit");
    ASSERT_TRUE(settle(document));
    editor->display().choose(0);
    QTest::keyClick(editor.get(), Qt::Key_H, Qt::ControlModifier | Qt::ShiftModifier);
    ASSERT_TRUE(settle(document));
    EXPECT_EQ(document.text(),
              "shape_set c -desc {-sub {-points {{0 0 0} {1 0 0} {0 1 0} {0 0 1}}}}\n");
}

TEST_F(ShapeEditorTest, SizesAndColoursAreTheTexts) {
    Q_EMIT editor->display().chosen(1, 0);
    type("Radius", "0.75");
    EXPECT_NE(document.text().find("-sub {-pos {2 0 0} -sphere 0.75}"), std::string::npos);
    editor->setColour(1, scene::Color{1, 0.5, 0});
    ASSERT_TRUE(settle(document));
    EXPECT_NE(document.text().find("-sub {-color {1 0.5 0} -pos {2 0 0} -sphere 0.75}"),
              std::string::npos)
        << document.text();
    document.undo();
    document.undo();
    EXPECT_EQ(document.text(), text);
}

TEST_F(ShapeEditorTest, RoundPartsComeFromButtonsAndTakeSizes) {
    for (const char* name :
         {"addCylinder", "addCone", "addCapsule", "addEllipsoid", "addTube", "addBowl"}) {
        editor->findChild<QPushButton*>(name)->click();
        ASSERT_TRUE(settle(document));
    }
    for (const char* part :
         {"-sub {-cylinder {0.5 1}}", "-sub {-cone {0.5 1}}", "-sub {-capsule {0.3 1}}",
          "-sub {-ellipsoid {0.6 0.4 0.4}}", "-sub {-tube {0.4 0.5 1}}", "-sub {-bowl {0.4 0.5}}"})
        EXPECT_NE(document.text().find(part), std::string::npos) << document.text();
    Q_EMIT editor->display().chosen(2, 0);
    type("Height", "2.5");
    ASSERT_TRUE(settle(document));
    EXPECT_NE(document.text().find("-sub {-cylinder {0.5 2.5}}"), std::string::npos);
}

TEST_F(ShapeEditorTest, ARenamedShapeIsRenamedWhereItIsUsed) {
    EXPECT_EQ(editor->renameShape("edge"), "");
    ASSERT_TRUE(settle(document));
    EXPECT_NE(document.text().find("shape_set edge -desc"), std::string::npos);
    EXPECT_NE(document.text().find("body b1 edge\n"), std::string::npos);
    EXPECT_EQ(editor->shape(), "edge");
    EXPECT_EQ(document.undoLabel(), "Rename corner to edge");
}

TEST_F(ShapeEditorTest, WhatALoopMakesSaysSo) {
    const std::string loop = "foreach r {1 2} {\n  shape_set s$r -desc {-sub {-sphere 1}}\n}\n";
    document.setText(loop, "Edit");
    ASSERT_TRUE(settle(document));
    drag(at({1, 0, 0}), {30, 0});
    EXPECT_EQ(document.text(), loop);
    EXPECT_NE(editor->words().indexOf("made by the command of line 2, which makes several"), -1)
        << qPrintable(editor->words());
}

TEST_F(ShapeEditorTest, OpensWithTheShapeOfWhatIsSelected) {
    Editor all(made.workshop());
    all.document().setText("shape_set a -desc {-sub {-sphere 1}}\nshape_set b -desc {-sub {-sphere "
                           "1}}\nbody one a\nbody two b -init_pos {3 0 0}\n",
                           "Edit");
    ASSERT_TRUE(settle(all.document()));
    all.document().select({{editing::Kind::body, 1}});
    ShapeEditor* opened = all.openShapeEditor();
    EXPECT_EQ(opened->shape(), "b");
    EXPECT_EQ(all.openShapeEditor("a"), opened); // one at a time
    EXPECT_EQ(opened->shape(), "a");
}

TEST_F(ShapeEditorTest, OpenedAgainItStandsWhereItWasPut) {
    Editor all(made.workshop());
    all.document().setText(ballScene, "Edit");
    ASSERT_TRUE(settle(all.document()));
    GraphicalViewer* viewer = all.openGraphicalViewer();
    QApplication::setActiveWindow(viewer);
    ShapeEditor* opened = all.openShapeEditor();
    opened->move(123, 45);
    opened->hide();
    all.openShapeEditor();
    EXPECT_EQ(opened->pos(), QPoint(123, 45));
}

TEST_F(ShapeEditorTest, EverythingIsDoneByKeysToo) {
    editor->display().setFocus();
    QTest::keyClick(editor.get(), Qt::Key_PageDown);
    QTest::keyClick(editor.get(), Qt::Key_PageDown);
    ASSERT_EQ(editor->display().chosenPoint(), 1U);
    QTest::keyClick(&editor->display(), Qt::Key_Right);
    ASSERT_TRUE(settle(document));
    EXPECT_GT(editing::pointsOf(part(0))[1].x(), 1);
    QTest::keyClick(editor.get(), Qt::Key_Insert);
    ASSERT_TRUE(settle(document));
    EXPECT_EQ(editing::pointsOf(part(0)).size(), 5U);
}

TEST_F(ShapeEditorTest, ExactValuesAreTyped) {
    Q_EMIT editor->display().chosen(0, 1);
    type("z of the vertex", "0.125");
    EXPECT_NE(document.text().find("{1 0 0.125}"), std::string::npos) << document.text();
}

TEST_F(ShapeEditorTest, ANewShapeIsShownToBeEdited) {
    EXPECT_EQ(editor->newShape("corner"), "There is a shape corner already.");
    EXPECT_NE(editor->newShape("two words"), "");
    EXPECT_EQ(editor->newShape("wedge"), "");
    ASSERT_TRUE(settle(document));
    EXPECT_EQ(editor->shape(), "wedge");
    EXPECT_EQ(editor->draft().size(), 1U);
    document.undo();
    EXPECT_EQ(document.text(), text);
}

// The polyhedron of a new shape gives way to the first part, unless somebody has changed it.
TEST_F(ShapeEditorTest, TheFirstPartOfANewShapeIsTheOneThatIsAdded) {
    ASSERT_EQ(editor->newShape("rod"), "");
    ASSERT_TRUE(settle(document));
    editor->addParts({editing::box({10, 1, 1})}, "Add Box");
    ASSERT_TRUE(settle(document));
    EXPECT_NE(document.text().find("shape_set rod -desc {-sub {-box {10 1 1}}}"), std::string::npos)
        << document.text();
    EXPECT_EQ(editor->display().chosenPart(), 0U);
    editor->addParts({editing::sphere(1)}, "Add Sphere");
    ASSERT_TRUE(settle(document));
    EXPECT_EQ(editor->draft().size(), 2U);
    ASSERT_EQ(editor->newShape("two"), "");
    ASSERT_TRUE(settle(document));
    editor->addParts({editing::tetrahedron(1)}, "Add Polyhedron"); // one more is meant
    ASSERT_TRUE(settle(document));
    EXPECT_EQ(editor->draft().size(), 2U);
    ASSERT_EQ(editor->newShape("moved"), "");
    ASSERT_TRUE(settle(document));
    Q_EMIT editor->display().chosen(0, 1);
    type("z of the vertex", "0.125");
    editor->addParts({editing::sphere(1)}, "Add Sphere");
    ASSERT_TRUE(settle(document));
    EXPECT_EQ(editor->draft().size(), 2U);
}

TEST_F(ShapeEditorTest, WhatIsComputedSaysSoAndOffersToBeWrittenOut) {
    const std::string computed =
        "set r 1\nshape_set s -desc \"-sub {-sphere [expr {2 * $r}]}\"\nbody b s\n";
    document.setText(computed, "Edit");
    ASSERT_TRUE(settle(document));
    drag(at({2, 0, 0}), {30, 0});
    EXPECT_EQ(document.text(), computed);
    EXPECT_NE(editor->words().indexOf("is computed"), -1) << qPrintable(editor->words());
    auto* box = editor->findChild<QMessageBox*>();
    ASSERT_NE(box, nullptr);
    for (QAbstractButton* button : box->buttons())
        if (box->buttonRole(button) == QMessageBox::AcceptRole)
            button->click();
    ASSERT_TRUE(settle(document));
    EXPECT_NE(document.text().find("shape_set s -desc {-sub {-sphere 2."), std::string::npos)
        << document.text();
}

// Whatever is done: what is shown is what the text says, undo leads to the first bytes and redo to
// the last.
TEST_F(ShapeEditorTest, RandomGesturesUndoToTheFirstBytes) {
    std::mt19937 random(20261120);
    const auto number = [&] { return std::uniform_real_distribution(-2.0, 2.0)(random); };
    const auto place = [&] { return Vector(number(), number(), number()); };
    ShapeDisplay& display = editor->display();
    for (int k = 0; k < 60; ++k) {
        const std::size_t one = random() % editor->draft().size();
        const auto count = editing::pointsOf(editor->draft()[one].part).size();
        Q_EMIT display.chosen(one, random() % count);
        switch (random() % 7) {
        case 0:
            Q_EMIT display.addWanted(place());
            break;
        case 1:
            Q_EMIT display.removeWanted(one, random() % count);
            break;
        case 2:
            editor->addParts({editing::cylinder(0.25, 1)}, "Add Cylinder");
            break;
        case 3:
            editor->setColour(one, scene::Color{0.25, 0.5, 0.75});
            break;
        case 4:
            if (editor->draft().size() > 1)
                QTest::keyClick(editor.get(), Qt::Key_Delete, Qt::ShiftModifier);
            break;
        default:
            for (int step = 0; step < 3; ++step)
                Q_EMIT display.dragged(place());
            Q_EMIT display.released();
        }
        ASSERT_TRUE(settle(document));
        ASSERT_FALSE(document.hasErrors()) << document.text();
        const auto& parts = document.shown().scene->shapeSets.at(0).parts;
        ASSERT_EQ(parts.size(), editor->draft().size());
        for (std::size_t i = 0; i < parts.size(); ++i)
            EXPECT_EQ(parts[i], editor->draft()[i].part);
    }
    const std::string last = document.text();
    EXPECT_NE(last, text);
    int steps = 0;
    for (; document.undoLabel() != "Edit" && steps < 100; ++steps)
        document.undo();
    EXPECT_EQ(document.text(), text);
    while (document.canRedo())
        document.redo();
    EXPECT_EQ(document.text(), last);
    EXPECT_GT(steps, 30);
}

} // namespace
} // namespace views
