// The first page shows what there is, its pictures are drawn once, and the tour sees its steps.
#include "frame/help_page.h"
#include "start/first_page.h"
#include "start/tour.h"
#include "viewers/editor.h"
#include "viewers/scene_files.h"
#include "viewers/starting.h"
#include "views/test_workshop.h"

#include <QComboBox>
#include <QDir>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QRegularExpression>
#include <QSignalSpy>
#include <QTemporaryDir>

#include <gmock/gmock.h>

namespace views {
namespace {

using ::testing::HasSubstr;

class StartTest : public testing::Test {
protected:
    static void SetUpTestSuite() { theApplication(); }
    QString write(const char* name, const QByteArray& bytes) {
        const QString path = folder.filePath(QString::fromLatin1(name));
        QFile file(path);
        EXPECT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(bytes);
        return path;
    }
    // A program that draws: it notes that it was called, and writes a picture.
    QString painter() {
        QImage(8, 6, QImage::Format_RGB32).save(folder.filePath("any.png"));
        const QString path =
            write("draw.sh", QStringLiteral("#!/bin/sh\necho \"$@\" >> %1/calls\n"
                                            "for last; do :; done\ncp %1/any.png \"$last\"\n")
                                 .arg(folder.path())
                                 .toUtf8());
        QFile(path).setPermissions(QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
        return path;
    }
    QByteArray calls() {
        QFile file(folder.filePath("calls"));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }
    QList<Sample> samples() {
        return {{write("a.al", "# a\n"), "First", "About one", "Easy", 1.5},
                {write("b.al", "# b\n"), "Second", "About two", "Hard", 2}};
    }

    QTemporaryDir folder;
};

TEST_F(StartTest, CardsFillTheRowsAtEachWidth) {
    QList<Sample> many;
    for (int i = 0; i < 12; ++i)
        many += samples();
    FirstPage page(many, {}, nullptr);
    page.show();
    const auto* list = page.findChild<QListWidget*>("samples");
    for (int width = 700; width <= 1500; width += 67) {
        page.resize(width, 700);
        QCoreApplication::processEvents();
        int right = 0, columns = 0;
        for (int i = 0; i < list->count(); ++i) {
            const QRect place = list->visualItemRect(list->item(i));
            right = std::max(right, place.right());
            columns += place.top() == list->visualItemRect(list->item(0)).top() ? 1 : 0;
        }
        const int room = list->viewport()->width();
        EXPECT_LE(right, room) << width;
        EXPECT_LT(room - right, 40) << width << ": " << columns;
        EXPECT_EQ(columns, std::max(1, (room - 1) / 214)) << width;
    }
}

TEST_F(StartTest, SamplesAreThoseOfTheManifestWhoseFilesAreThere) {
    write("a.al", "# a\n");
    const QString manifest = write("m.json", R"({"samples": [
        {"file": "a.al", "title": "A", "about": "It is", "group": "G", "time": 2},
        {"file": "gone.al", "title": "B"}, {"file": "a.al"}, 7]})");
    const QList<Sample> found = samplesOf(manifest);
    ASSERT_EQ(found.size(), 1);
    EXPECT_EQ(found[0], (Sample{folder.filePath("a.al"), "A", "It is", "G", 2}));
    EXPECT_TRUE(samplesOf(folder.filePath("none.json")).isEmpty());
    EXPECT_TRUE(samplesOf(write("bad.json", "{\"samples\": ")).isEmpty());
}

TEST_F(StartTest, PicturesAreDrawnOnceAndKept) {
    const QString program = painter(), kept = folder.filePath("kept");
    for (const int calledBefore : {0, 2}) {
        SamplePictures pictures(program, kept);
        QSignalSpy drawn(&pictures, &SamplePictures::drawn);
        EXPECT_EQ(calls().count('\n'), calledBefore);
        pictures.ask(samples(), {80, 60}, Qt::white);
        ASSERT_TRUE(waitFor([&] { return drawn.count() == 2; }));
    }
    EXPECT_EQ(calls().count('\n'), 2);
    EXPECT_THAT(calls().toStdString(), HasSubstr("--time 1.5 --size 80x60 --background #ffffff"));
    QFile installed(program); // anew: it may draw other pictures
    ASSERT_TRUE(installed.open(QIODevice::Append));
    installed.write("# better\n");
    installed.close();
    SamplePictures pictures(program, kept);
    QSignalSpy drawn(&pictures, &SamplePictures::drawn);
    pictures.ask(samples(), {80, 60}, Qt::white);
    ASSERT_TRUE(waitFor([&] { return drawn.count() == 2; }));
    EXPECT_EQ(calls().count('\n'), 4);
}

TEST_F(StartTest, PicturesLieOnThePaperOfThePageAlsoADarkOne) {
    const QPalette light = QApplication::palette();
    QPalette dark = light;
    dark.setColor(QPalette::Base, QColor(30, 32, 34));
    QApplication::setPalette(dark);
    SamplePictures pictures(painter(), folder.filePath("kept"));
    QSignalSpy drawn(&pictures, &SamplePictures::drawn);
    {
        const FirstPage page(samples(), {}, &pictures);
        EXPECT_TRUE(waitFor([&] { return drawn.count() == 2; }));
    }
    QApplication::setPalette(light);
    EXPECT_THAT(calls().toStdString(), HasSubstr("--background #1e2022"));
}

// As after a move to a screen of another scale.
TEST_F(StartTest, AnOpenPageAsksForPicturesAnewWhenItsLookChanges) {
    const QPalette light = QApplication::palette();
    QPalette dark = light;
    dark.setColor(QPalette::Base, QColor(30, 32, 34));
    SamplePictures pictures(painter(), folder.filePath("kept"));
    QSignalSpy drawn(&pictures, &SamplePictures::drawn), failed(&pictures, &SamplePictures::failed);
    {
        const FirstPage page(samples(), {}, &pictures);
        QApplication::setPalette(dark); // the first picture is being drawn
        EXPECT_TRUE(waitFor([&] { return calls().count("--background #1e2022") == 2; }));
        EXPECT_TRUE(waitFor([&] {
            return !drawn.isEmpty() && drawn.last()[0].value<Sample>() == samples().back();
        }));
        EXPECT_EQ(drawn.count(), 2); // and not the first one, of the old look
    }
    QApplication::setPalette(light);
    EXPECT_EQ(failed.count(), 0);
    EXPECT_EQ(calls().count("--background #1e2022"), 2);
}

TEST_F(StartTest, APictureThatCannotBeDrawnIsLeftOut) {
    SamplePictures pictures(folder.filePath("no-program"), folder.filePath("kept"));
    QSignalSpy failed(&pictures, &SamplePictures::failed);
    pictures.ask(samples(), {80, 60}, Qt::white);
    EXPECT_TRUE(waitFor([&] { return failed.count() == 2; }));
}

TEST_F(StartTest, TheFirstPageOpensWhatIsChosen) {
    SamplePictures pictures(painter(), folder.filePath("kept"));
    FirstPage page(samples(), {folder.filePath("mine.al")}, &pictures);
    page.setAttribute(Qt::WA_DeleteOnClose, false);
    auto* list = page.findChild<QListWidget*>("samples");
    ASSERT_EQ(list->count(), 2);
    const QPixmap before = list->item(1)->icon().pixmap(8, 6);
    ASSERT_TRUE(waitFor(
        [&] { return list->item(1)->icon().pixmap(8, 6).cacheKey() != before.cacheKey(); }));
    QSignalSpy sample(&page, &FirstPage::sampleWanted), file(&page, &FirstPage::fileWanted),
        scene(&page, &FirstPage::newWanted), tour(&page, &FirstPage::tourWanted);
    Q_EMIT list->itemActivated(list->item(1));
    ASSERT_EQ(sample.count(), 1);
    EXPECT_EQ(sample[0][0].value<Sample>().title, "Second");
    auto* recent = page.findChild<QListWidget*>("recent");
    ASSERT_EQ(recent->count(), 1);
    Q_EMIT recent->itemActivated(recent->item(0));
    EXPECT_EQ(file[0][0].toString(), folder.filePath("mine.al"));
    page.findChild<QPushButton*>("newScene")->click();
    page.findChild<QPushButton*>("tour")->click();
    EXPECT_EQ(scene.count(), 1);
    EXPECT_EQ(tour.count(), 1);
    page.findChild<QComboBox*>("groups")->setCurrentText("Hard");
    EXPECT_TRUE(list->isRowHidden(0));
    EXPECT_FALSE(list->isRowHidden(1));
}

TEST_F(StartTest, WithoutSamplesThePageSaysSo) {
    const FirstPage page({}, {}, nullptr);
    EXPECT_TRUE(page.findChild<QListWidget*>("samples")->isHidden());
    EXPECT_THAT(page.findChild<QLabel*>("noSamples")->text().toStdString(),
                testing::HasSubstr("No samples are installed"));
}

TEST_F(StartTest, ASampleIsASceneOfNoFile) {
    TestWorkshop made;
    Editor editor(made.workshop());
    SceneFiles& files = editor.beginSession();
    Starting starting(editor, files);
    starting.openSample(samples()[0]);
    EXPECT_EQ(editor.document().text(), "# a\n");
    EXPECT_FALSE(editor.document().isModified());
    EXPECT_EQ(editor.document().path(), "");
    EXPECT_EQ(editor.document().name(), "First");
    EXPECT_EQ(editor.graphicalViewers().size(), 1);
    const QString path = folder.filePath("mine.al");
    ASSERT_EQ(editor.document().save(path).sentence, "");
    EXPECT_EQ(editor.document().name(), "mine.al");
}

TEST_F(StartTest, TheTourSeesEachStepAndItsUndoing) {
    TestWorkshop made;
    SceneDocument document(made.workshop());
    Tour tour(document);
    const QSignalSpy built(&tour, &Tour::built);
    const auto step = [&](const std::string& text) {
        document.setText(text, "Edit");
        EXPECT_TRUE(settle(document));
        return tour.done();
    };
    EXPECT_EQ(tour.done(), 0);
    std::string text = "shape_set Rod -desc {-sub {-box {4 0.3 0.3}}}\nbody r1 Rod\n";
    EXPECT_EQ(step(text), 1);
    text += "joint j1 -type hinge -body1 r1 -offset1 {-2 0 0} -axis {0 0 1}\n";
    EXPECT_EQ(step(text), 2);
    text += "body r2 Rod -init_pos {4 0 0}\n";
    EXPECT_EQ(step(text), 2);
    text += "joint j2 -type hinge -body1 r2 -offset1 {-2 0 0} -body2 r1 -axis {0 0 1}\n";
    EXPECT_EQ(step(text), 3);
    tour.played(); // too early
    const std::string light = text;
    text += "foreach b {r1 r2} {force -body $b -gravitational {0 -9.81 0}}\n";
    EXPECT_EQ(step(text), 4);
    EXPECT_EQ(built.count(), 0); // nobody sees the tour
    tour.show();
    EXPECT_EQ(built.count(), 1);
    tour.played();
    EXPECT_EQ(tour.done(), Tour::steps);
    EXPECT_EQ(step(text + "body r3 Rod -init_pos {0 9 0}\n"), Tour::steps); // a copy that floats
    EXPECT_EQ(built.count(), 1);
    EXPECT_EQ(step(light), 3);
    EXPECT_EQ(step(text), 4);
    EXPECT_EQ(built.count(), 2);
    tour.hide(); // it has ended, and pictures jump no more
    EXPECT_EQ(step(light), 3);
    EXPECT_EQ(step(text), 4);
    EXPECT_EQ(built.count(), 2);
}

TEST_F(StartTest, TheTourTellsOfThePicturesBannerAndOfEscape) {
    TestWorkshop made;
    SceneDocument document(made.workshop());
    const Tour tour(document);
    const auto said = [&](const std::string& text) {
        document.setText(text, "Edit");
        EXPECT_TRUE(settle(document));
        return tour.findChild<QLabel*>("tourStep")->text().toStdString();
    };
    EXPECT_THAT(said(""), testing::HasSubstr("A banner at the top of the picture"));
    EXPECT_THAT(said("shape_set Rod -desc {-sub {-box {4 0.3 0.3}}}\nbody r1 Rod\n"
                     "joint j1 -type hinge -body1 r1 -offset1 {-2 0 0}\n"
                     "body r2 Rod -init_pos {4 0 0}\n"
                     "joint j2 -type hinge -body1 r2 -offset1 {-2 0 0} -body2 r1\n"
                     "force -body r1 -gravitational {0 -9.81 0}\n"
                     "force -body r2 -gravitational {0 -9.81 0}\n"),
                testing::HasSubstr("press it twice"));
}

TEST_F(StartTest, TheTourSaysWhatIsWrongInAStep) {
    TestWorkshop made;
    SceneDocument document(made.workshop());
    Tour tour(document);
    const auto said = [&](const std::string& text) {
        document.setText(text, "Edit");
        EXPECT_TRUE(settle(document));
        return tour.findChild<QLabel*>("tourStep")->text().toStdString();
    };
    std::string text = "shape_set Rod -desc {-sub {-box {4 0.3 0.3}}}\nbody r1 Rod\n"
                       "joint j1 -type hinge -body1 r1 -offset1 {-2 0 0}\n"
                       "body r2 Rod -init_pos {4 0 0}\n";
    EXPECT_THAT(said(text), testing::StartsWith("Choose Create"));
    EXPECT_THAT(said(text + "joint j2 -type hinge -body1 r2 -offset1 {-2 0 0}\n"),
                testing::StartsWith("j2 holds r2 to the ground. Undo it (Ctrl+Z); its second "
                                    "click belongs on r1"));
    EXPECT_THAT(said(text + "joint j2 -type hinge -body1 r1 -offset1 {2 0 0}\n"),
                testing::StartsWith("j2 holds r1 to the ground, which j1 does already"));
    EXPECT_THAT(said(text + "joint j2 -type hinge -body1 r2 -offset1 {-2 0 0} -body2 r1\n"),
                testing::StartsWith("Choose Create"));
}

TEST_F(StartTest, EachPageOfHelpHasItsChapterInTheManual) {
    for (const char* topic :
         {"The picture", "Body", "Joint", "Force", "Link", "Rope", "Trajectory", "Light", "Time",
          "Strip of times", "Tools", "Motion and handles", "The text", "Plots", "The tour",
          "Shape editor", "Trajectory editor", "Speed and accuracy"}) {
        const auto page = helpPage(topic);
        ASSERT_TRUE(page) << topic;
        EXPECT_FALSE(page->words.contains("\n## ")) << topic;
        EXPECT_FALSE(page->words.contains("Manual:")) << topic;
        bool isThere = false;
        for (const char* manual : {"editing.md", "scene-language.md"}) {
            QFile file(QStringLiteral(":/manual/") + QLatin1String(manual));
            ASSERT_TRUE(file.open(QIODevice::ReadOnly));
            isThere |= ("\n" + QString::fromUtf8(file.readAll()))
                           .contains(QRegularExpression("\n#+ " + page->chapter + "\n"));
        }
        EXPECT_TRUE(isThere) << topic << ": " << page->chapter.toStdString();
    }
    EXPECT_FALSE(helpPage("Nothing"));
    QWidget outer;
    auto* inner = new QWidget(&outer);
    setHelp(outer, "Body");
    EXPECT_EQ(helpOf(inner), "Body");
}

} // namespace
} // namespace views
