#include "shapes/shape_import.h"

#include "point_edits/shape_edit.h"

#include "shapes/mesh_job.h"
#include "shapes/shape_display.h"
#include "views/test_workshop.h"
#include "workbench/scene_document.h"

#include <gtest/gtest.h>

#include <QFile>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QTemporaryDir>
#include <QThreadPool>

namespace views {
namespace {

// An L of millimetres: two convex parts.
const std::string ell = "v 0 0 0\nv 30 0 0\nv 30 10 0\nv 10 10 0\nv 10 20 0\nv 0 20 0\n"
                        "v 0 0 10\nv 30 0 10\nv 30 10 10\nv 10 10 10\nv 10 20 10\nv 0 20 10\n"
                        "f 6 5 4 3 2 1\nf 7 8 9 10 11 12\nf 1 2 8 7\nf 2 3 9 8\nf 3 4 10 9\n"
                        "f 4 5 11 10\nf 5 6 12 11\nf 6 1 7 12\n";

class ShapeImportTest : public testing::Test {
protected:
    static void SetUpTestSuite() { theApplication(); }

    void open(const QString& name, const std::string& bytes) {
        document.setText(ballScene, "Edit");
        ASSERT_TRUE(settle(document));
        const QString path = folder.filePath(name);
        QFile file(path);
        ASSERT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(bytes.data(), static_cast<qint64>(bytes.size()));
        file.close();
        openPath(path);
    }
    void openPath(const QString& path) {
        dialog = new ShapeImport(document, pictures, path);
        dialog->setAttribute(Qt::WA_DeleteOnClose, false);
        owner.reset(dialog);
        dialog->show();
        wait();
    }
    void wait() {
        ASSERT_TRUE(waitFor([&] { return dialog->words() != "Looking for convex parts…"; }));
    }
    template <class Field> Field* field(int index) {
        return dialog->findChildren<Field*>().at(index);
    }

    QTemporaryDir folder;
    TestWorkshop made;
    SceneDocument document{made.workshop()};
    std::shared_ptr<PictureThread> pictures = std::make_shared<PictureThread>(false);
    ShapeImport* dialog = nullptr;
    std::unique_ptr<ShapeImport> owner;
};

TEST_F(ShapeImportTest, ShowsThePartsBeforeTheyAreTakenInOneStep) {
    open("ell.obj", ell);
    EXPECT_EQ(dialog->words(), "2 convex parts with 16 vertices; the file's volume.");
    EXPECT_EQ(document.text(), ballScene);
    dialog->accept();
    ASSERT_TRUE(settle(document));
    ASSERT_EQ(document.shown().scene->shapeSets.size(), 2U);
    EXPECT_EQ(document.shown().scene->shapeSets[1].name, "ell");
    EXPECT_EQ(document.shown().scene->shapeSets[1].parts.size(), 2U);
    EXPECT_EQ(document.undoLabel(), "Import ell.obj");
    document.undo();
    EXPECT_EQ(document.text(), ballScene);
}

TEST_F(ShapeImportTest, ScalesAndMovesToTheMiddle) {
    open("ell.obj", ell);
    for (QLineEdit* one : dialog->findChildren<QLineEdit*>())
        if (one->text() == "1")
            one->setText("0.001");
    Eigen::AlignedBox3d box;
    for (const scene::Part& part : dialog->parts())
        for (const auto& p : std::get<scene::HullShape>(part.shape).points)
            box.extend(p);
    EXPECT_EQ(box.max(), geometry::Vector(0.015, 0.01, 0.005));
    EXPECT_EQ(box.min(), geometry::Vector(-0.015, -0.01, -0.005));
}

TEST_F(ShapeImportTest, FewerPartsFillMore) {
    open("ell.obj", ell);
    dialog->findChild<QSpinBox*>()->setValue(1);
    wait();
    EXPECT_EQ(dialog->words(), "One convex part with 10 vertices; 25.00 % more volume than the "
                               "file's.\nMore parts would come nearer.");
}

TEST_F(ShapeImportTest, WhatIsWrongIsSaidAndChangesNothing) {
    open("ell.obj", ell + "f 1 2 99\n");
    EXPECT_EQ(dialog->words(), "ell.obj, line 21: there is no vertex 99 yet, only 12.");
    dialog->accept();
    EXPECT_EQ(document.text(), ballScene);
    openPath(folder.filePath("none.stl"));
    EXPECT_TRUE(dialog->words().startsWith("Cannot read none.stl: "))
        << qPrintable(dialog->words());
    openPath("/dev/zero");
    EXPECT_EQ(dialog->words(), "zero is no ordinary file.");
}

TEST_F(ShapeImportTest, ANameThatIsTakenIsAskedForAgain) {
    open("ball.obj", ell);
    EXPECT_EQ(field<QLineEdit>(0)->text(), "ball2");
    field<QLineEdit>(0)->setText("ball");
    EXPECT_EQ(dialog->words(), "There is a shape ball already.");
    dialog->accept();
    EXPECT_EQ(document.text(), ballScene);
}

TEST_F(ShapeImportTest, WhatTheTextCannotHoldIsSaidBefore) {
    open("ell.obj", ell);
    const std::string much =
        ballScene + "# " + std::string((8U << 20) - ballScene.size() - 100, '-') + "\n";
    document.setText(much, "Edit");
    ASSERT_TRUE(settle(document));
    ASSERT_FALSE(document.hasErrors());
    openPath(folder.filePath("ell.obj"));
    EXPECT_TRUE(dialog->words().contains("a scene has at most 8")) << qPrintable(dialog->words());
    dialog->accept();
    EXPECT_EQ(document.text(), much);
}

// Small parts first, large ones behind them.
TEST(ShapeImportText, TheLengthOfItsTextIsToldWithoutWritingIt) {
    std::vector<scene::Part> parts;
    for (int i = 0; i < 200; ++i) {
        scene::HullShape hull;
        for (int k = 0; k < (i < 10 ? 8 : 500); ++k)
            hull.points.emplace_back(0.125 * k, 0.5 * i, 1.25);
        parts.emplace_back().shape = hull;
    }
    const auto is = static_cast<double>(editing::descriptionText(parts).size());
    EXPECT_NEAR(lengthInText(parts), is, 0.1 * is);
    parts.resize(10);
    EXPECT_GT(lengthInText(parts), 10 * 8 * 6.0);
    EXPECT_LT(lengthInText({}), 10.0);
}

// The threads that windows share for what is short may all be busy, and leaving waits for those.
TEST_F(ShapeImportTest, ReadsOnAThreadOfItsOwn) {
    QThreadPool& pool = *QThreadPool::globalInstance();
    pool.waitForDone();
    const int threads = pool.maxThreadCount();
    pool.setMaxThreadCount(0);
    open("ell.obj", ell);
    EXPECT_EQ(dialog->words(), "2 convex parts with 16 vertices; the file's volume.");
    pool.setMaxThreadCount(threads);
}

TEST_F(ShapeImportTest, ClosingEndsTheThreadWhateverItDoes) {
    std::string bytes;
    for (int i = 0; i < 300'000; ++i)
        bytes += "v 0.25 0.5 0.75\n";
    QFile file(folder.filePath("late.obj"));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(bytes.data(), static_cast<qint64>(bytes.size()));
    file.close();
    for (int i = 0; i < 3; ++i) {
        ShapeImport dropped(document, pictures, file.fileName());
        dropped.setAttribute(Qt::WA_DeleteOnClose, false);
        EXPECT_EQ(dropped.words(), "Looking for convex parts…");
        EXPECT_GE(MeshJob::threads(), 1);
    }
    EXPECT_TRUE(waitFor([] { return MeshJob::threads() == 0; }));
    QCoreApplication::processEvents(); // and tells nobody
    EXPECT_EQ(document.text(), "");
}

} // namespace
} // namespace views
