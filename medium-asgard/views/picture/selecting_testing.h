// A viewer of three balls, clicks and drags in its picture.
#pragma once

#include "viewers/editor.h"
#include "views/test_workshop.h"

namespace views {

using editing::Element;
using editing::Kind;
using geometry::Vector;

// Seen along z: near stands before far; left stands alone.
inline const std::string three = "simulator -finish 2\n"
                                 "shape_set s -desc {-sub {-sphere 0.5}}\n"
                                 "body near s -init_pos {0 0 2}\n"
                                 "body far s -init_pos {0.2 0 -2}\n"
                                 "body left s -init_pos {-3 0 0}\n";
inline constexpr Element nearOne{Kind::body, 0}, farOne{Kind::body, 1}, leftOne{Kind::body, 2};

class SelectingTest : public testing::Test {
protected:
    static void SetUpTestSuite() { theApplication(); }
    void SetUp() override {
        editor.document().setText(three, "Edit");
        ASSERT_TRUE(settle(editor.document()));
        viewer = editor.openGraphicalViewer();
        display().lookAlong(Vector::UnitZ());
        display().keepCamera();
        display().grab();
        middle = at({0.1, 0, 0});
        left = at({-3, 0, 0});
        empty = QPoint(8, display().height() - 8);
    }
    SceneDisplay& display() { return viewer->display(); }
    const std::vector<Element>& selected() { return editor.document().selected(); }
    QPoint at(const Vector& world) {
        return display().fromPixels(display().sight().pixels(world)).toPoint();
    }
    void click(QPoint place, Qt::KeyboardModifiers keys = {}) {
        QTest::mouseClick(&display(), Qt::LeftButton, keys, place);
    }
    void drag(QPoint from, QPoint to, Qt::KeyboardModifiers keys = {}) {
        QTest::mousePress(&display(), Qt::LeftButton, keys, from);
        for (const QPoint& place : {from + QPoint(1, 0), (from + to) / 2, to}) {
            QMouseEvent move(QEvent::MouseMove, place, display().mapToGlobal(place), Qt::NoButton,
                             Qt::LeftButton, keys);
            QApplication::sendEvent(&display(), &move);
        }
        QTest::mouseRelease(&display(), Qt::LeftButton, keys, to);
        ASSERT_TRUE(settle(editor.document()));
    }

    TestWorkshop made;
    Editor editor{made.workshop()};
    GraphicalViewer* viewer = nullptr;
    QPoint middle, left, empty;
};

} // namespace views
