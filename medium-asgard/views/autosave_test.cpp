#include "views/autosave.h"
#include "views/recent_files.h"
#include "views/test_workshop.h"

#include <gtest/gtest.h>

#include <QDir>
#include <QFile>
#include <QMenu>
#include <QProcess>
#include <QSettings>
#include <QTemporaryDir>

namespace views {
namespace {

QByteArray contents(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

void write(const QString& path, const QByteArray& bytes) {
    QFile file(path);
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(bytes);
}

class AutosaveTest : public testing::Test {
protected:
    static void SetUpTestSuite() { theApplication(); }

    void SetUp() override {
        path_ = home_.filePath("scene.al");
        write(path_, ballScene.c_str());
        ASSERT_EQ(document_.open(path_), "");
    }

    [[nodiscard]] QStringList kept() const {
        return QDir(folder()).entryList(QDir::Files | QDir::Hidden);
    }
    [[nodiscard]] QString folder() const { return home_.filePath("unsaved"); }

    // As a process that was killed leaves it: the text there, the lock of one that is no more.
    LeftBehind killed(const QByteArray& text, const QString& scene) {
        EXPECT_TRUE(QDir().mkpath(folder()));
        const QString base = folder() + "/1-0";
        write(base + ".al", text);
        write(base + ".json", "{\"scene\": \"" + scene.toUtf8() + "\"}");
        const QString lock = base + ".lock";
        QByteArray held;
        {
            QLockFile own(lock);
            EXPECT_TRUE(own.tryLock());
            held = contents(lock);
        }
        QProcess other;
        other.start("true", QStringList());
        EXPECT_TRUE(other.waitForStarted());
        const QByteArray process = QByteArray::number(other.processId());
        EXPECT_TRUE(other.waitForFinished());
        held.replace(0, held.indexOf('\n'),
                     process); // a lock begins with the process that holds it
        write(lock, held);
        const auto all = leftBehind(folder());
        EXPECT_EQ(all.size(), 1);
        return all.value(0);
    }

    QTemporaryDir home_;
    QString path_;
    TestWorkshop made_;
    SceneDocument document_{made_.workshop()};
};

TEST_F(AutosaveTest, KeepsWhatIsNotSavedAndForgetsWhatIs) {
    Autosave autosave(document_, folder(), 5, 1000);
    const std::string changed = "# \xff not UTF-8\n" + ballScene;
    document_.setText(changed, "Edit");
    ASSERT_TRUE(waitFor([&] { return !autosave.file().isEmpty(); }));
    EXPECT_EQ(contents(autosave.file()).toStdString(), changed);
    EXPECT_EQ(contents(path_).toStdString(), ballScene); // the file itself is the user's to save
    document_.undo();                                    // as it is on the disk
    EXPECT_EQ(autosave.file(), "");
    EXPECT_EQ(kept(), QStringList());
    document_.redo();
    ASSERT_TRUE(waitFor([&] { return !autosave.file().isEmpty(); }));
    ASSERT_EQ(document_.save(path_), "");
    EXPECT_EQ(kept(), QStringList());
}

TEST_F(AutosaveTest, KeepsDuringChangesThatNeverRest) {
    Autosave autosave(document_, folder(), 200, 300);
    QElapsedTimer clock;
    clock.start();
    int count = 0;
    while (autosave.file().isEmpty() && clock.elapsed() < 10'000) {
        document_.setText(ballScene + "# " + std::to_string(++count) + "\n", "Edit");
        QTest::qWait(20);
    }
    EXPECT_FALSE(autosave.file().isEmpty());
}

TEST_F(AutosaveTest, AProgramThatEndsAsItShouldLeavesNothing) {
    {
        Autosave autosave(document_, folder(), 5, 1000);
        document_.setText("# given up\n", "Edit");
        ASSERT_TRUE(waitFor([&] { return !autosave.file().isEmpty(); }));
    }
    EXPECT_EQ(kept(), QStringList());
}

TEST_F(AutosaveTest, WhatALivingProcessKeepsIsNotLeftBehind) {
    Autosave autosave(document_, folder(), 5, 1000);
    document_.setText("# here\n", "Edit");
    ASSERT_TRUE(waitFor([&] { return !autosave.file().isEmpty(); }));
    EXPECT_TRUE(leftBehind(folder()).isEmpty());
}

TEST_F(AutosaveTest, RecoversAsOneChangeOfTheFile) {
    const LeftBehind left = killed("# lost and found\n", path_);
    EXPECT_EQ(left.scene, path_);
    SceneDocument other{made_.workshop()};
    Autosave autosave(other, folder(), 5, 1000);
    ASSERT_EQ(autosave.recover(left), "");
    EXPECT_EQ(other.text(), "# lost and found\n");
    EXPECT_EQ(other.path(), path_);
    EXPECT_TRUE(other.isModified());
    EXPECT_EQ(other.undoLabel(), "Recover");
    other.undo();
    EXPECT_EQ(other.text(), ballScene);
    EXPECT_FALSE(other.isModified());
    EXPECT_TRUE(leftBehind(folder()).isEmpty());
    EXPECT_EQ(kept(), QStringList());
}

// A text that ends every program that reads it is still there for one that does not.
TEST_F(AutosaveTest, WhatIsRecoveredIsKeptAllTheTime) {
    const LeftBehind left = killed("# lost and found\n", path_);
    SceneDocument other{made_.workshop()};
    Autosave autosave(other, folder(), 5, 1000);
    QByteArray then;
    QObject::connect(&other, &SceneDocument::textChanged, [&] { then = contents(left.file); });
    ASSERT_EQ(autosave.recover(left), "");
    EXPECT_EQ(then, "# lost and found\n"); // as the reading of it begins
    EXPECT_EQ(autosave.file(), left.file);
    EXPECT_TRUE(leftBehind(folder()).isEmpty()); // nobody else is offered it
    other.setText("# and more\n", "Edit");
    ASSERT_TRUE(waitFor([&] { return contents(left.file) == "# and more\n"; }));
    EXPECT_EQ(other.save(path_), "");
    EXPECT_EQ(kept(), QStringList());
}

TEST_F(AutosaveTest, OneAtATimeIsOfferedWhatWasLeft) {
    {
        const LeftBehind left = killed("# lost and found\n", path_);
        EXPECT_TRUE(leftBehind(folder()).isEmpty()); // while this one is being asked
    }
    ASSERT_EQ(leftBehind(folder()).size(), 1); // later
    discard(leftBehind(folder()).first());
    EXPECT_EQ(kept(), QStringList());
}

TEST_F(AutosaveTest, RecoversWhatHasNoFileAnyMore) {
    const LeftBehind left = killed("# lost and found\n", home_.filePath("gone.al"));
    Autosave autosave(document_, folder(), 5, 1000);
    ASSERT_EQ(autosave.recover(left), "");
    EXPECT_EQ(document_.text(), "# lost and found\n");
    EXPECT_EQ(document_.path(), "");
    EXPECT_TRUE(document_.isModified());
}

TEST_F(AutosaveTest, SaysOnceThatThereIsNoPlace) {
    write(home_.filePath("file"), "");
    Autosave autosave(document_, home_.filePath("file") + "/unsaved", 5, 1000);
    QStringList said;
    QObject::connect(&autosave, &Autosave::failed, [&](const QString& s) { said << s; });
    document_.setText("# one\n", "Edit");
    ASSERT_TRUE(waitFor([&] { return !said.isEmpty(); }));
    document_.setText("# two\n", "Edit");
    QTest::qWait(50);
    ASSERT_EQ(said.size(), 1);
    EXPECT_TRUE(said[0].startsWith("Unsaved changes cannot be kept in ")) << qPrintable(said[0]);
}

TEST_F(AutosaveTest, TheLastTenFilesThatStillAreThere) {
    QSettings::setDefaultFormat(QSettings::IniFormat);
    QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, home_.path());
    for (int i = 0; i < 12; ++i) {
        const QString file = home_.filePath(QStringLiteral("%1 & more.al").arg(i));
        write(file, "");
        rememberFile(file);
    }
    rememberFile(home_.filePath("5 & more.al"));
    QFile::remove(home_.filePath("11 & more.al"));
    EXPECT_EQ(recentFiles().size(), 9);
    EXPECT_EQ(recentFiles().first(), home_.filePath("5 & more.al"));
    QMenu menu;
    QString opened;
    fillWithRecentFiles(&menu, [&](const QString& path) { opened = path; });
    Q_EMIT menu.aboutToShow();
    Q_EMIT menu.aboutToShow();
    ASSERT_EQ(menu.actions().size(), 9);
    menu.actions().first()->trigger();
    EXPECT_EQ(opened, home_.filePath("5 & more.al"));
}

} // namespace
} // namespace views
