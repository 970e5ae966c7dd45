// What is exported is what was asked for, and nothing else is overwritten.
#include "viewers/editor.h"
#include "viewers/scene_files.h"
#include "views/test_workshop.h"

#include <QAction>
#include <QDir>
#include <QFile>
#include <QImage>
#include <QMenuBar>
#include <QPushButton>
#include <QTemporaryDir>
#include <gtest/gtest.h>

namespace views {
namespace {

class ExportsTest : public testing::Test {
protected:
    static void SetUpTestSuite() { theApplication(); }
    void SetUp() override {
        files = &editor.beginSession();
        viewer = editor.openGraphicalViewer();
        viewer->resize(420, 300);
        QCoreApplication::processEvents();
        editor.document().setText(ballScene, "Edit");
        ASSERT_TRUE(settle(editor.document()));
        QObject::connect(&exports(), &Exports::says,
                         [this](const QString& words) { said = words; });
        exports().agrees = [this](const QString& question) {
            asked = question;
            return agreed;
        };
    }
    Exports& exports() { return files->exports(); }
    QString in(const char* name) { return folder.filePath(QString::fromLatin1(name)); }
    // Until it is written or refused.
    QString write(const char* name, ExportFormat format) {
        said.clear();
        asked.clear();
        exports().write(in(name), format);
        EXPECT_TRUE(waitFor([&] { return !exports().isBusy(); }));
        return said;
    }
    void put(const char* name) {
        QFile file(in(name));
        ASSERT_TRUE(file.open(QIODevice::WriteOnly));
        file.write("mine");
    }
    QByteArray bytes(const char* name) {
        QFile file(in(name));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }

    TestWorkshop made;
    Editor editor{made.workshop()};
    SceneFiles* files = nullptr;
    GraphicalViewer* viewer = nullptr;
    QTemporaryDir folder;
    QString said, asked;
    bool agreed = false;
};

TEST_F(ExportsTest, WhatIsSeenAndTheMotionAreWritten) {
    const int width = viewer->display().sight().size.width;
    EXPECT_EQ(write("now", ExportFormat::png), in("now.png") + " is written.");
    EXPECT_EQ(QImage(in("now.png")).width(), width);
    EXPECT_EQ(write("motion", ExportFormat::table), in("motion.csv") + " is written.");
    EXPECT_EQ(bytes("motion.csv").count('\n'), 102);
    // As short as they are the same numbers: a twentieth of the motion, and not
    // 0.050000000000000003.
    EXPECT_EQ(bytes("motion.csv").split('\n')[5].split(',').first(), "0.08");
    EXPECT_EQ(write("film", ExportFormat::film), "51 pictures are in " + in("film") + ".");
    EXPECT_EQ(QDir(in("film")).entryList(QDir::Files).size(), 51); // two seconds
    EXPECT_EQ(asked, "");
}

// Asked about is the name that is written.
TEST_F(ExportsTest, NothingIsOverwrittenUnasked) {
    put("scene.al");
    EXPECT_EQ(write("scene.al", ExportFormat::png), in("scene.al.png") + " is written.");
    EXPECT_EQ(asked, "");
    EXPECT_EQ(bytes("scene.al"), "mine");
    put("now.png");
    EXPECT_EQ(write("now.png", ExportFormat::png), "");
    EXPECT_EQ(write("now", ExportFormat::png), "");
    EXPECT_TRUE(asked.contains(QStringLiteral("now.png exists"))) << asked.toStdString();
    EXPECT_EQ(bytes("now.png"), "mine");
    QDir(folder.path()).mkdir(QStringLiteral("film"));
    put("film/00001.png");
    EXPECT_EQ(write("film", ExportFormat::film), "");
    EXPECT_TRUE(asked.contains(QStringLiteral("not empty"))) << asked.toStdString();
    EXPECT_EQ(bytes("film/00001.png"), "mine");
    agreed = true;
    EXPECT_EQ(write("now", ExportFormat::png), in("now.png") + " is written.");
    EXPECT_FALSE(QImage(in("now.png")).isNull());
}

TEST_F(ExportsTest, ASecondOneWaitsUntilTheFirstIsDone) {
    exports().write(in("film"), ExportFormat::film);
    ASSERT_TRUE(exports().isBusy());
    exports().write(in("second"), ExportFormat::png);
    EXPECT_EQ(said, "Another export is still being written.");
    EXPECT_TRUE(waitFor([&] { return !exports().isBusy(); }));
    EXPECT_TRUE(said.startsWith("51 pictures")) << said.toStdString();
    EXPECT_FALSE(QFile::exists(in("second.png")));
}

TEST_F(ExportsTest, ACancelledOneIsNotCalledExported) {
    exports().write(in("film"), ExportFormat::film);
    QProgressDialog* dialog = nullptr;
    for (QWidget* one : QApplication::topLevelWidgets())
        if (auto* found = qobject_cast<QProgressDialog*>(one))
            dialog = found;
    ASSERT_TRUE(dialog);
    dialog->findChild<QPushButton*>()->click();
    EXPECT_TRUE(waitFor([&] { return !exports().isBusy(); }));
    EXPECT_EQ(said, "The export was cancelled.");
    EXPECT_LT(QDir(in("film")).entryList(QDir::Files).size(), 51);
}

TEST_F(ExportsTest, TheMotionOfAnEarlierSceneIsAskedAbout) {
    made.blocked = true;
    std::string faster = ballScene;
    faster.replace(faster.find("-init_dpos {1"), 13, "-init_dpos {2");
    editor.document().setText(faster, "Edit");
    ASSERT_TRUE(waitFor([&] { return editor.document().motionIsStale(); }));
    EXPECT_EQ(write("motion", ExportFormat::table), "");
    EXPECT_TRUE(asked.contains(QStringLiteral("earlier scene"))) << asked.toStdString();
    EXPECT_FALSE(QFile::exists(in("motion.csv")));
    made.blocked = false;
    EXPECT_TRUE(settle(editor.document()));
}

TEST_F(ExportsTest, WithoutAMotionThereIsNoTable) {
    made.blocked = true;
    editor.document().setText(ballScene + "body b2 ball -init_pos {3 0 0}\n", "Edit");
    ASSERT_TRUE(waitFor([&] { return !editor.document().shown().motion; }));
    EXPECT_EQ(write("motion", ExportFormat::table), "There is no motion yet.");
    made.blocked = false;
    EXPECT_TRUE(settle(editor.document()));
}

TEST_F(ExportsTest, AFilmOfAYearIsRefused) {
    std::string year = ballScene;
    year.replace(year.find("-finish 2"), 9, "-finish 4e7");
    editor.document().setText(year, "Edit");
    ASSERT_TRUE(settle(editor.document()));
    EXPECT_TRUE(write("film", ExportFormat::film).startsWith(QStringLiteral("1e+09 pictures")))
        << said.toStdString();
    EXPECT_FALSE(QFile::exists(in("film")));
}

} // namespace
} // namespace views
