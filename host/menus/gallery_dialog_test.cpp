#include "menus/gallery_dialog.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QListWidget>
#include <QScreen>

namespace menus {
namespace {

class GalleryTest : public testing::Test {
protected:
    GalleryTest() {
        manifest_.documentClass = "NONE"; // nothing draws the pictures
        manifest_.samples = {{"a.x", "A", "", {}, "First"},
                             {"b.x", "B", "", {}, "Second"},
                             {"c.x", "C", "", {}, "First"},
                             {"d.x", "D", "", {}, ""}};
    }

    void open() {
        dialog_ = std::make_unique<GalleryDialog>(media_, manifest_, nullptr);
        samples_ = dialog_->findChild<QListWidget*>("samples");
        groups_ = dialog_->findChild<QListWidget*>("groups");
    }
    [[nodiscard]] QString shown() const {
        QString titles;
        for (int i = 0; i < samples_->count(); ++i)
            if (!samples_->isRowHidden(i))
                titles += samples_->item(i)->text();
        return titles;
    }

    media::PipeThread pipes_;
    media::LiveMedia media_{media::Registry::read({}), QString(), pipes_};
    media::Manifest manifest_;
    std::unique_ptr<GalleryDialog> dialog_;
    QListWidget *samples_ = nullptr, *groups_ = nullptr;
};

TEST_F(GalleryTest, AGroupShowsItsSamplesAlone) {
    open();
    ASSERT_EQ(groups_->count(), 3);
    EXPECT_FALSE(groups_->isHidden());
    EXPECT_EQ(groups_->item(1)->text(), "First");
    EXPECT_EQ(groups_->item(2)->text(), "Second");
    EXPECT_EQ(shown(), "ABCD");
    samples_->setCurrentRow(2);
    groups_->setCurrentRow(1);
    EXPECT_EQ(shown(), "AC");
    EXPECT_EQ(dialog_->chosen(), 2); // it belongs to the group
    groups_->setCurrentRow(2);
    EXPECT_EQ(shown(), "B");
    EXPECT_EQ(dialog_->chosen(), 1);
    groups_->setCurrentRow(0);
    EXPECT_EQ(shown(), "ABCD");
}

TEST_F(GalleryTest, WithoutGroupsThereIsNoListOfThem) {
    for (media::Sample& sample : manifest_.samples)
        sample.group.clear();
    open();
    EXPECT_TRUE(groups_->isHidden());
    EXPECT_EQ(shown(), "ABCD");
}

TEST_F(GalleryTest, ItFitsIntoItsScreen) {
    open();
    const QSize room = dialog_->screen()->availableSize();
    ASSERT_LT(room.width(), 900); // of the platform of tests, where four columns do not fit
    EXPECT_LT(dialog_->width(), room.width());
    EXPECT_LT(dialog_->height(), room.height());
}

} // namespace
} // namespace menus

int main(int argc, char** argv) {
    QApplication application(argc, argv);
    ::testing::InitGoogleTest(&argc, argv);
    return RUN_ALL_TESTS();
}
