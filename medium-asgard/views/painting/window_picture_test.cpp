#include "painting/window_picture.h"
#include "views/test_workshop.h"

#include <gtest/gtest.h>

#include <QWidget>

namespace views {
namespace {

class WindowPictureTest : public testing::Test {
protected:
    static void SetUpTestSuite() { theApplication(); }
    void SetUp() override {
        window.resize(200, 100);
        window.show();
    }
    [[nodiscard]] PictureWish wish() {
        ++wishes;
        PictureWish made;
        made.shown.scene = scene;
        return made;
    }

    std::shared_ptr<const scene::Scene> scene = std::make_shared<scene::Scene>();
    int wishes = 0;
    bool mayTake = true;
    QWidget window;
    WindowPicture picture{window, std::make_shared<PictureThread>(false), [this] { return wish(); },
                          [this](const Picture&) { return mayTake; }};
};

TEST_F(WindowPictureTest, OneThatIsUpToDateIsAskedForOnce) {
    EXPECT_FALSE(picture.isNewest());
    picture.bringUpToDate();
    picture.bringUpToDate();
    EXPECT_EQ(wishes, 1);
    EXPECT_TRUE(picture.isNewest());
    EXPECT_EQ(picture.last()->of.size, (render::Size{200, 100}));
    window.resize(300, 100);
    EXPECT_FALSE(picture.isNewest());
    picture.bringUpToDate();
    EXPECT_EQ(picture.last()->of.size, (render::Size{300, 100}));
}

TEST_F(WindowPictureTest, WhatMovesIsCoarseAndFineOnceItRests) {
    picture.redraw(true);
    picture.bringUpToDate();
    EXPECT_EQ(picture.last()->of.display.samples, 1);
    EXPECT_TRUE(waitFor([&] { return !picture.isMoving(); }));
    picture.bringUpToDate();
    EXPECT_EQ(picture.last()->of.display.samples, 4);
}

TEST_F(WindowPictureTest, OneThatIsNotWantedAnyMoreIsNotTaken) {
    picture.bringUpToDate();
    mayTake = false;
    picture.redraw(false);
    picture.bringUpToDate();
    EXPECT_EQ(picture.last()->of.serial, 1U);
    EXPECT_FALSE(picture.isNewest());
    mayTake = true;
    picture.bringUpToDate();
    EXPECT_EQ(picture.last()->of.serial, 2U);
}

} // namespace
} // namespace views
