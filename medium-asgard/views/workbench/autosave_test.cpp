#include "views/test_workshop.h"
#include "workbench/autosave.h"
#include "workbench/recent_files.h"

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QApplication>
#include <QDir>
#include <QFile>
#include <QMenu>
#include <QMessageBox>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>

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
        return QDir(home_.filePath("unsaved")).entryList(QDir::Files | QDir::Hidden);
    }
    [[nodiscard]] std::string folder() const { return home_.filePath("unsaved").toStdString(); }
    [[nodiscard]] files::AllLeft left() const {
        return files::leftBehind(files::FileSystem::real(), folder());
    }
    static files::Kept keptIn(const std::string& path) {
        const auto file = files::readFile(files::FileSystem::real(), path, 1 << 20);
        auto kept = files::decoded(file.bytes);
        return std::holds_alternative<files::Kept>(kept) ? std::get<files::Kept>(kept)
                                                         : files::Kept{};
    }

    // As a process that was killed leaves it: the text there, its lock free.
    [[nodiscard]] files::LeftBehind killed(const std::string& text, const QString& scene,
                                           const std::string& windows = {}) const {
        {
            auto place = files::Place::claim(files::FileSystem::real(), folder());
            files::Kept kept{.file = {scene.toStdString(), {}}, .at = 1, .text = text};
            if (QFile::exists(scene)) {
                const auto read =
                    files::readFile(files::FileSystem::real(), kept.file.path, 1 << 20);
                kept.file.stamp = read.stamp;
            }
            if (!windows.empty())
                kept.drafts["windows"] = windows;
            EXPECT_EQ(std::get<std::unique_ptr<files::Place>>(place)->keep(kept), "");
        }
        files::AllLeft all = left();
        EXPECT_EQ(all.texts.size(), 1u);
        return std::move(all.texts.front());
    }

    QTemporaryDir home_;
    QString path_;
    TestWorkshop made_;
    SceneDocument document_{made_.workshop()};
};

TEST_F(AutosaveTest, KeepsWhatIsNotSavedAndForgetsWhatIs) {
    Autosave autosave(document_, folder());
    const std::string changed = "# \xff not UTF-8\n" + ballScene;
    document_.setText(changed, "Edit");
    const std::string file = autosave.file();
    EXPECT_EQ(keptIn(file).text, changed);
    EXPECT_EQ(keptIn(file).file.path, path_.toStdString());
    EXPECT_EQ(contents(path_).toStdString(), ballScene); // the file itself is the user's to save
    EXPECT_EQ(QFile::permissions(QString::fromStdString(file)),
              QFile::ReadOwner | QFile::WriteOwner | QFile::ReadUser | QFile::WriteUser);
    document_.undo(); // as it is on the disk
    EXPECT_EQ(autosave.file(), "");
    EXPECT_EQ(kept(), QStringList());
    document_.redo();
    EXPECT_NE(autosave.file(), "");
    ASSERT_EQ(document_.save(path_).sentence, "");
    EXPECT_EQ(autosave.file(), "");
    EXPECT_EQ(kept(), QStringList());
}

// Changes that never rest come to the disk while they go on: nobody waits here for the writer.
TEST_F(AutosaveTest, KeepsDuringChangesThatNeverRest) {
    Autosave autosave(document_, folder());
    const auto onDisk = [this] {
        for (const QString& name : kept())
            if (name.endsWith(".kept"))
                return keptIn(folder() + "/" + name.toStdString()).text;
        return std::string();
    };
    int count = 0;
    EXPECT_TRUE(waitFor([&] {
        document_.setText(document_.text() + "# " + std::to_string(++count) + "\n", "Edit");
        return onDisk().find("# 7\n") != std::string::npos;
    }));
}

TEST_F(AutosaveTest, KeepsDraftsAndGivesThemBack) {
    std::string typed, back;
    Autosave autosave(document_, folder(),
                      {[&] { return typed; }, [&](const std::string& state) { back = state; }});
    autosave.lookAtDrafts();
    EXPECT_EQ(autosave.file(), ""); // nothing to keep
    typed = "a draft";
    autosave.lookAtDrafts();
    const files::Kept all = keptIn(autosave.file());
    EXPECT_EQ(all.drafts.at("windows"), "a draft");
    EXPECT_EQ(all.text, ballScene);
    typed.clear(); // it was updated, or dropped
    autosave.lookAtDrafts();
    EXPECT_EQ(autosave.file(), "");

    SceneDocument other{made_.workshop()};
    Autosave again(other, folder(),
                   {[&] { return back; }, [&](const std::string& state) { back = state; }});
    again.recover(killed(ballScene, path_, "two drafts"));
    EXPECT_EQ(back, "two drafts");
    EXPECT_FALSE(other.isModified());
    EXPECT_EQ(keptIn(again.file()).drafts.at("windows"), "two drafts");
}

// What goes on being typed in a draft is no signal of anybody's.
TEST_F(AutosaveTest, LooksAtDraftsAsLongAsThereAreSome) {
    std::string typed = "a";
    Autosave autosave(document_, folder(), {[&] { return typed; }, [](const std::string&) {}});
    autosave.lookAtDrafts();
    typed = "a draft";
    ASSERT_TRUE(waitFor([&] { return keptIn(autosave.file()).drafts["windows"] == "a draft"; }));
    typed.clear();
    ASSERT_TRUE(waitFor([&] { return autosave.file().empty(); }));
}

TEST_F(AutosaveTest, AProgramThatEndsAsItShouldLeavesNothing) {
    {
        Autosave autosave(document_, folder());
        document_.setText("# given up\n", "Edit");
        EXPECT_NE(autosave.file(), "");
    }
    EXPECT_EQ(kept(), QStringList());
}

TEST_F(AutosaveTest, WhatALivingProcessKeepsIsNotLeftBehind) {
    Autosave autosave(document_, folder());
    document_.setText("# here\n", "Edit");
    ASSERT_NE(autosave.file(), "");
    EXPECT_TRUE(left().texts.empty());
}

TEST_F(AutosaveTest, RecoversAsOneChangeOfTheFile) {
    SceneDocument other{made_.workshop()};
    Autosave autosave(other, folder());
    autosave.recover(killed("# lost and found\n", path_));
    EXPECT_EQ(other.text(), "# lost and found\n");
    EXPECT_EQ(other.path(), path_);
    EXPECT_TRUE(other.isModified());
    EXPECT_EQ(other.undoLabel(), "Recover");
    other.undo();
    EXPECT_EQ(other.text(), ballScene);
    EXPECT_FALSE(other.isModified());
    EXPECT_EQ(autosave.file(), "");
    EXPECT_TRUE(left().texts.empty());
    EXPECT_EQ(kept(), QStringList());
}

TEST_F(AutosaveTest, WhatAnotherProgramDidWithTheFileSinceIsAskedAbout) {
    files::LeftBehind was = killed("# lost and found\n", path_);
    write(path_, "# another's\n");
    SceneDocument other{made_.workshop()};
    Autosave autosave(other, folder());
    autosave.recover(std::move(was));
    EXPECT_EQ(other.save(path_).refusal, files::Refusal::changed);
    EXPECT_EQ(contents(path_), "# another's\n");
    EXPECT_TRUE(other.save(path_, {.evenChanged = true}));
    EXPECT_EQ(contents(path_), "# lost and found\n");
}

// A text that ends every program that reads it is still there for one that does not.
TEST_F(AutosaveTest, WhatIsRecoveredIsKeptAllTheTime) {
    files::LeftBehind was = killed("# lost and found\n", path_);
    const std::string file = was.place->path();
    SceneDocument other{made_.workshop()};
    Autosave autosave(other, folder());
    std::string then;
    QObject::connect(&other, &SceneDocument::textChanged, [&] { then = keptIn(file).text; });
    autosave.recover(std::move(was));
    EXPECT_EQ(then, "# lost and found\n"); // as the reading of it begins
    EXPECT_EQ(autosave.file(), file);
    EXPECT_TRUE(left().texts.empty()); // nobody else is offered it
    other.setText("# and more\n", "Edit");
    EXPECT_EQ(keptIn(autosave.file()).text, "# and more\n");
    EXPECT_EQ(other.save(path_).sentence, "");
    EXPECT_EQ(autosave.file(), "");
    EXPECT_EQ(kept(), QStringList());
}

TEST_F(AutosaveTest, RecoversWhatHasNoFileAnyMore) {
    Autosave autosave(document_, folder());
    autosave.recover(killed("# lost and found\n", home_.filePath("gone.al")));
    EXPECT_EQ(document_.text(), "# lost and found\n");
    EXPECT_EQ(document_.path(), "");
    EXPECT_TRUE(document_.isModified());
}

// The question of the next start, answered by a key or a click; then what is left for the start
// after that.
TEST_F(AutosaveTest, TheNextStartAsksAndLosesNothingToAKeyMeantForAnotherWindow) {
    const auto answer = [](const QString& words) {
        QTimer::singleShot(10, qApp, [words] {
            auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
            ASSERT_TRUE(box);
            EXPECT_TRUE(box->text().startsWith("scene.al was not saved before Asgard stopped "));
            if (words == "Return")
                return QTest::keyClick(box, Qt::Key_Return);
            for (QAbstractButton* button : box->buttons())
                if (button->text() == words)
                    return button->click();
            box->reject();
            ADD_FAILURE() << "no button " << words.toStdString();
        });
    };
    { const files::LeftBehind left = killed("# lost and found\n", path_); } // its lock is free
    Autosave autosave(document_, folder());
    for (const char* later : {"Return", "&Later"}) {
        answer(later);
        EXPECT_FALSE(offerRecovery(nullptr, autosave, folder(), {}));
        EXPECT_EQ(left().texts.size(), 1U) << later;
        EXPECT_EQ(document_.text(), ballScene);
    }
    EXPECT_FALSE(offerRecovery(nullptr, autosave, folder(), home_.filePath("another.al")));
    answer("&Recover");
    EXPECT_TRUE(offerRecovery(nullptr, autosave, folder(), path_));
    EXPECT_EQ(document_.text(), "# lost and found\n");
    EXPECT_EQ(document_.path(), path_);
    ASSERT_EQ(document_.save(path_).sentence, "");
    { const files::LeftBehind left = killed("# not wanted\n", path_); }
    answer("&Discard");
    EXPECT_FALSE(offerRecovery(nullptr, autosave, folder(), {}));
    EXPECT_EQ(left().texts.size(), 0U);
    EXPECT_EQ(document_.text(), "# lost and found\n");
}

TEST_F(AutosaveTest, ASceneWithoutAFileIsAskedAboutAsOneWithoutAName) {
    { const files::LeftBehind left = killed("# lost and found\n", {}); }
    Autosave autosave(document_, folder());
    QString asked;
    QTimer::singleShot(10, qApp, [&] {
        if (auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget())) {
            asked = box->text();
            box->reject();
        }
    });
    EXPECT_FALSE(offerRecovery(nullptr, autosave, folder(), {}));
    EXPECT_TRUE(asked.startsWith("A scene without a name was not saved before Asgard stopped "))
        << qPrintable(asked);
}

TEST_F(AutosaveTest, SaysOnceThatThereIsNoPlace) {
    write(home_.filePath("file"), "");
    Autosave autosave(document_, home_.filePath("file").toStdString() + "/unsaved");
    QStringList said;
    QObject::connect(&autosave, &Autosave::failed, [&](const QString& s) { said << s; });
    document_.setText("# one\n", "Edit");
    ASSERT_TRUE(waitFor([&] { return !said.isEmpty(); }));
    document_.setText("# two\n", "Edit");
    EXPECT_EQ(autosave.file(), "");
    QCoreApplication::processEvents();
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

TEST_F(AutosaveTest, SettingsOfTheOldPlaceAreTakenOverOnce) {
    QSettings::setDefaultFormat(QSettings::IniFormat);
    QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, home_.path());
    const QString name = QCoreApplication::applicationName();
    QCoreApplication::setOrganizationName("asgard");
    QCoreApplication::setApplicationName("asgard");
    ASSERT_TRUE(QDir(home_.path()).mkpath("Unknown Organization"));
    write(home_.filePath("Unknown Organization/asgard.ini"), "[General]\nrecentFiles=/a.al\n");
    takeOverOldSettings();
    EXPECT_EQ(QSettings().fileName(), home_.filePath("asgard/asgard.ini"));
    EXPECT_EQ(QSettings().value("recentFiles").toString(), "/a.al");
    QSettings().setValue("recentFiles", "/b.al");
    QSettings().sync();
    takeOverOldSettings();
    EXPECT_EQ(QSettings().value("recentFiles").toString(), "/b.al");
    QCoreApplication::setOrganizationName({});
    QCoreApplication::setApplicationName(name);
}

} // namespace
} // namespace views
