// A picture in which things are made by clicks and keys, for the tests.
#pragma once

#include "picture/create_menu.h"
#include "viewers/editor.h"
#include "views/test_workshop.h"

#include <gtest/gtest.h>

#include <string>

namespace views {

using geometry::Vector;

inline const std::string balls = "simulator -finish 2\n"
                                 "shape_set ball -desc {-sub {-sphere 0.5}}\n"
                                 "body b1 ball -init_pos {-1 0 0}\n"
                                 "body b2 ball -init_pos {1 0 0}\n";

class CreatingTest : public testing::Test {
protected:
    static void SetUpTestSuite() { theApplication(); }
    void open(const std::string& text) {
        editor.document().setText(text, "Edit");
        ASSERT_TRUE(settle(editor.document()));
        viewer = editor.openGraphicalViewer();
        viewer->display().lookAlong(Vector::UnitZ());
        viewer->display().grab();
    }
    SceneDisplay& display() { return viewer->display(); }
    const std::string& text() { return editor.document().text(); }
    const scene::Scene& scene() { return *editor.document().shown().scene; }
    void click(const Vector& world) {
        QTest::mouseClick(&display(), Qt::LeftButton, {},
                          display().fromPixels(display().sight().pixels(world)).toPoint());
    }
    void key(Qt::Key which) { QTest::keyClick(&display(), which); }
    void done() { ASSERT_TRUE(settle(editor.document())) << text(); }

    TestWorkshop made;
    Editor editor{made.workshop()};
    GraphicalViewer* viewer = nullptr;
};

} // namespace views
