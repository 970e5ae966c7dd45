#include "media/scripted_medium.h"

#include <gmock/gmock.h>

#include <atomic>

#include <QFile>
#include <QStringList>
#include <csignal>

namespace media {
namespace {

using ::testing::HasSubstr;
using testing::scriptedManifest;
using testing::shortLimits;
using testing::waitFor;

// For what takes long on a slow machine and is not what is tested.
TimeLimits patient() {
    TimeLimits limits = shortLimits();
    limits.quiet = limits.hung = 100'000;
    return limits;
}

class MediumProcessTest : public ::testing::Test {
protected:
    std::unique_ptr<LiveSubdocument> subdocument(const QByteArray& text,
                                                 const QStringList& behaviour = {},
                                                 const TimeLimits& limits = shortLimits()) {
        const Manifest manifest = scriptedManifest(behaviour);
        auto made =
            std::make_unique<LiveSubdocument>(manifest, programOf(manifest, {}), pipes_, limits);
        made->setText(text);
        return made;
    }

    // Starts it and says why it failed for good.
    std::string failure(const QByteArray& text, const QStringList& behaviour = {},
                        const TimeLimits& limits = shortLimits()) {
        auto it = subdocument(text, behaviour, limits);
        it->start();
        EXPECT_TRUE(waitFor([&] { return it->condition() == Condition::failed; }));
        EXPECT_EQ(it->text(), text);
        return it->reason().toStdString();
    }

    PipeThread pipes_;
};

QColor middle(const QImage& image) { return image.pixelColor(image.rect().center()); }

TEST_F(MediumProcessTest, DrawsItsTextIntoARendition) {
    auto it = subdocument("colour 20C040\nsize 300 100");
    auto rendition = it->createRendition();
    rendition->setGeometry({64, 48}, 1);
    rendition->setShown(true);
    it->start();
    ASSERT_TRUE(waitFor([&] { return !rendition->picture().isNull() && it->preferredSize(); }));
    EXPECT_EQ(rendition->picture().size(), QSize(64, 48));
    EXPECT_EQ(middle(rendition->picture()), QColor(0x20, 0xC0, 0x40));
    EXPECT_EQ(*it->preferredSize(), QSizeF(300, 100));
    EXPECT_EQ(it->menus().size(), 4u);
}

TEST_F(MediumProcessTest, IsShownAsOneOfItsPresentations) {
    auto it = subdocument("colour 204060\nsize 300 100");
    it->setPresentation("source");
    auto rendition = it->createRendition();
    rendition->setGeometry({64, 48}, 1);
    rendition->setShown(true);
    it->start();
    const auto shows = [&](const QColor& colour, QSizeF size) {
        return waitFor([&] {
            rendition->painted();
            return !rendition->picture().isNull() && middle(rendition->picture()) == colour &&
                   it->preferredSize() == size;
        });
    };
    EXPECT_TRUE(shows(QColor(0xDF, 0xBF, 0x9F), {300, 50}));
    EXPECT_EQ(it->presentation(), "source");
    it->setPresentation("");
    EXPECT_TRUE(shows(QColor(0x20, 0x40, 0x60), {300, 100}));
    it->setPresentation("source");
    EXPECT_TRUE(shows(QColor(0xDF, 0xBF, 0x9F), {300, 50}));
    it->setPresentation("nothing it knows");
    EXPECT_TRUE(shows(QColor(0x20, 0x40, 0x60), {300, 100}));
    EXPECT_EQ(it->presentation(), "picture");
}

TEST_F(MediumProcessTest, FollowsEditsAndResizes) {
    auto it = subdocument("colour 202020");
    auto small = it->createRendition(), large = it->createRendition();
    small->setGeometry({40, 30}, 1);
    large->setGeometry({400, 300}, 2);
    for (auto* rendition : {small.get(), large.get()})
        rendition->setShown(true);
    it->start();
    ASSERT_TRUE(waitFor([&] { return !small->picture().isNull() && !large->picture().isNull(); }));
    small->painted();
    large->painted();
    it->edit({{7, 13, "FF0000"}}, "Colour");
    EXPECT_EQ(it->text(), "colour FF0000");
    small->setGeometry({50, 60}, 1);
    ASSERT_TRUE(waitFor([&] { return small->picture().size() == QSize(50, 60); }));
    EXPECT_EQ(middle(small->picture()), QColor(255, 0, 0));
    ASSERT_TRUE(waitFor([&] { return middle(large->picture()) == QColor(255, 0, 0); }));
}

TEST_F(MediumProcessTest, GetsNoMoreThanTwoFramesAheadOfTheScreen) {
    auto it = subdocument("duration 100");
    auto rendition = it->createRendition();
    rendition->setShown(true);
    int pictures = 0;
    QObject::connect(rendition.get(), &Rendition::pictureChanged, [&] { ++pictures; });
    it->start();
    ASSERT_TRUE(waitFor([&] { return pictures > 0; }));
    it->play();
    ASSERT_TRUE(waitFor([&] { return it->time() && it->time()->time > 0.5; }));
    EXPECT_LE(pictures, 2); // nothing was painted
    const int before = pictures;
    ASSERT_TRUE(waitFor([&] {
        rendition->painted();
        return pictures > before + 3;
    }));
}

// A medium counts anew from each size: what it drew before is not held against it.
TEST_F(MediumProcessTest, MayFillBothPlacesAgainAfterEachSize) {
    auto it = subdocument("duration 100");
    auto rendition = it->createRendition();
    rendition->setShown(true);
    it->start();
    ASSERT_TRUE(waitFor([&] { return !rendition->picture().isNull(); }));
    ipc::Input press; // is answered by a picture
    press.type = ipc::InputType::press;
    for (int i = 0; i < 20; ++i) {
        const QSize size(40 + i % 2, 30);
        rendition->setGeometry(size, 1);
        rendition->input(press);
        rendition->input(press);
        ASSERT_TRUE(waitFor([&] {
            return it->condition() == Condition::failed || rendition->picture().size() == size;
        }));
        ASSERT_EQ(it->reason().toStdString(), "");
    }
}

TEST_F(MediumProcessTest, ReleasesTheMemoryOfOldSizes) {
    auto it = subdocument("colour 101010");
    auto rendition = it->createRendition();
    rendition->setShown(true);
    it->start();
    for (int width = 100; width < 140; ++width) {
        rendition->setGeometry({width, 100}, 1);
        ASSERT_TRUE(waitFor([&] {
            rendition->painted();
            return rendition->picture().width() == width;
        }));
    }
}

// --- what goes wrong ---------------------------------------------------------------------------

TEST_F(MediumProcessTest, SaysWhatHappened) {
    EXPECT_THAT(failure("behave crash"), HasSubstr("was ended by signal 11 (Segmentation fault)"));
    EXPECT_THAT(failure("", {"exit"}), HasSubstr("ended with exit code 3"));
    EXPECT_THAT(failure("behave garbage"), HasSubstr("broke the protocol"));
    EXPECT_THAT(failure("behave oversize"), HasSubstr("broke the protocol"));
    EXPECT_THAT(failure("behave bad-reply"), HasSubstr("broke the protocol"));
    EXPECT_THAT(failure("behave truncated"), HasSubstr("ended with exit code 0"));
    // A host that reads as fast as it sends ends it because it answers no pings.
    EXPECT_THAT(failure("behave flood"),
                ::testing::AnyOf(HasSubstr("flood"), HasSubstr("did not respond")));
    EXPECT_THAT(failure("", {"wrong-version"}), HasSubstr("only version 99 is spoken here"));
}

TEST_F(MediumProcessTest, SaysThatTheProgramIsMissing) {
    Manifest manifest = scriptedManifest();
    manifest.command = {"no-such-program"};
    LiveSubdocument it(manifest, programOf(manifest, {}), pipes_);
    it.start();
    ASSERT_TRUE(waitFor([&] { return it.condition() == Condition::failed; }));
    EXPECT_THAT(it.reason().toStdString(), HasSubstr("there is no program \"no-such-program\""));
}

TEST_F(MediumProcessTest, EndsOneThatNeverAnswersTheStart) {
    TimeLimits limits = shortLimits();
    limits.initialize = 300;
    const Manifest manifest = scriptedManifest({"silent"});
    LiveSubdocument it(manifest, programOf(manifest, {}), pipes_, limits);
    it.start();
    ASSERT_TRUE(waitFor([&] { return it.condition() == Condition::failed; }));
    EXPECT_THAT(it.reason().toStdString(), HasSubstr("did not answer within 0.3 s"));
}

TEST_F(MediumProcessTest, ShowsThatItDoesNotRespondAndThenEndsIt) {
    for (const char* behaviour : {"behave hang", "behave stop", "behave busy"}) {
        auto it = subdocument(behaviour);
        bool wasQuiet = false;
        QObject::connect(it.get(), &LiveSubdocument::conditionChanged,
                         [&] { wasQuiet |= it->condition() == Condition::notResponding; });
        it->start();
        ASSERT_TRUE(waitFor([&] { return it->condition() == Condition::failed; })) << behaviour;
        EXPECT_TRUE(wasQuiet) << behaviour;
        EXPECT_THAT(it->reason().toStdString(), HasSubstr("did not respond")) << behaviour;
    }
}

TEST_F(MediumProcessTest, KeepsThePictureAndStartsAgainThreeTimes) {
    TimeLimits limits = shortLimits();
    limits.restartsPerMinute = 3;
    limits.quiet = limits.hung = 20'000; // a slow machine is not what is tested here
    const Manifest manifest = scriptedManifest();
    auto it = std::make_unique<LiveSubdocument>(manifest, programOf(manifest, {}), pipes_, limits);
    it->setText("colour 804020");
    auto rendition = it->createRendition();
    rendition->setShown(true);
    int starts = 0;
    QObject::connect(it.get(), &LiveSubdocument::conditionChanged,
                     [&] { starts += it->condition() == Condition::live; });
    it->start();
    for (int life = 1; life <= limits.restartsPerMinute + 1; ++life) {
        ASSERT_TRUE(waitFor(
            [&] { return starts == life && it->hasLoaded() && !rendition->picture().isNull(); }));
        it->invoke("crash", nullptr);
        ASSERT_TRUE(waitFor([&] { return it->condition() != Condition::live; }));
        EXPECT_FALSE(rendition->picture().isNull());
    }
    ASSERT_TRUE(waitFor([&] { return it->condition() == Condition::failed; }));
    EXPECT_EQ(middle(rendition->picture()), QColor(0x80, 0x40, 0x20));
    it->start(); // the click
    EXPECT_TRUE(waitFor([&] { return it->condition() == Condition::live; }));
}

TEST_F(MediumProcessTest, ClosesOneThatPointsOutsideOfItsPictures) {
    auto it = subdocument("colour 010203");
    auto rendition = it->createRendition();
    rendition->setShown(true);
    it->start();
    ASSERT_TRUE(waitFor([&] { return !rendition->picture().isNull(); }));
    rendition->painted();
    it->edit({{0, 0, "behave bad-frame\n"}}, {});
    ASSERT_TRUE(waitFor([&] { return it->condition() == Condition::failed; }));
    EXPECT_THAT(it->reason().toStdString(), HasSubstr("sent a picture that has no place"));
}

TEST_F(MediumProcessTest, ClosesOneThatSendsMoreThanTheProtocolHolds) {
    for (const char* lie : {"diagnostics 1 60000000", "diagnostics 1001 8", "diagnostics 1 4097",
                            "menu 1001 8", "menu 1 1025", "title 1 4097", "state 1 4097"})
        EXPECT_THAT(failure(QByteArray("behave lie ") + lie, {}, patient()),
                    ::testing::AnyOf(HasSubstr("is longer than"), HasSubstr("holds more than")))
            << lie;
}

TEST_F(MediumProcessTest, CountsWhatIsSaidWhetherItWaitsOrNot) {
    EXPECT_THAT(failure("behave chatter", {}, patient()),
                HasSubstr("more than it may in a second (a flood)"));
}

TEST_F(MediumProcessTest, OnlyAProcessWithWindowsMayUndo) {
    auto it = subdocument("colour 102030");
    int undone = 0;
    QObject::connect(it.get(), &LiveSubdocument::undoRequested, [&] { ++undone; });
    it->start();
    ASSERT_TRUE(waitFor([&] { return it->hasLoaded(); }));
    it->edit({{0, 0, "behave undo\nfault 1 1 told\n"}}, {});
    ASSERT_TRUE(waitFor([&] { return !it->diagnostics().items.empty(); }));
    it->invoke("editor", nullptr); // the new process asks, too
    ASSERT_TRUE(waitFor([&] { return undone > 0; }));
    EXPECT_EQ(undone, 1);
}

// The end of a process is told later: a call that sends goes on, whatever came of the sending.
TEST_F(MediumProcessTest, ACallGoesOnWhenItsProcessEndsInIt) {
    for (int before = 0; before < 3; ++before) {
        const Manifest manifest = scriptedManifest();
        LiveSubdocument it(manifest, programOf(manifest, {}), pipes_, patient());
        it.setText("duration 10\nbehave stop");
        auto rendition = it.createRendition();
        it.start();
        ASSERT_TRUE(
            waitFor([&] { return it.time().has_value() && it.condition() == Condition::live; }));
        for (int i = 0; i < before; ++i)
            it.pause();
        for (int i = 0; i < 5000; ++i) { // more than may be unread and than the pipe holds
            it.setPoster(1);
            it.play();
            rendition->setGeometry({100 + i % 2, 100}, 1);
        }
        EXPECT_EQ(it.condition(), Condition::live); // it has not been told yet
        ASSERT_TRUE(waitFor([&] { return it.condition() == Condition::failed; }));
        EXPECT_THAT(it.reason().toStdString(), HasSubstr("does not read its messages"));
    }
}

TEST_F(MediumProcessTest, ATextThatNoMessageHoldsIsRefusedUntilItIsShorter) {
    const auto most = static_cast<qsizetype>(ipc::longestText.most);
    auto it = subdocument(QByteArray(most + 1, '\x01'));
    EXPECT_EQ(it->condition(), Condition::failed);
    EXPECT_THAT(it->reason().toStdString(), HasSubstr("this text has 8.0 MiB"));
    int told = 0;
    QObject::connect(it.get(), &LiveSubdocument::conditionChanged, [&] { ++told; });
    it->start();
    EXPECT_EQ(told, 0); // later
    ASSERT_TRUE(waitFor([&] { return told > 0; }));
    EXPECT_EQ(it->condition(), Condition::failed);
    EXPECT_FALSE(it->hasProcess());
    it->edit({{0, most + 1, "colour 102030"}}, {});
    EXPECT_EQ(it->condition(), Condition::still);
    it->start();
    ASSERT_TRUE(waitFor([&] { return it->hasLoaded(); }));
    it->edit({{13, 13, std::string(ipc::longestText.most, '\n')}}, {});
    EXPECT_EQ(it->condition(), Condition::failed);
    EXPECT_TRUE(waitFor([&] { return pipes_.alive() == 0; }));
}

TEST_F(MediumProcessTest, TheLongestTextsAreTold) {
    auto it = subdocument(QByteArray("colour 102030\n")
                              .leftJustified(static_cast<qsizetype>(ipc::longestText.most), '\x1f'),
                          {}, patient()); // blanks to it
    it->start();                          // it is 48 MiB of JSON
    ASSERT_TRUE(waitFor([&] { return it->hasLoaded() || it->condition() == Condition::failed; }));
    EXPECT_TRUE(it->hasLoaded()) << it->reason().toStdString();
    // More changes than a message holds are told as a new text.
    it->setText(QByteArray(20'000, '\n'));
    text::Edits edits;
    for (std::size_t i = 0; i < 20'000; ++i)
        edits.push_back({i, i, i == 0 ? "fault 1 1 there" : "\n"});
    it->edit(edits, {});
    ASSERT_TRUE(waitFor([&] { return !it->diagnostics().items.empty(); }));
    EXPECT_EQ(it->diagnostics().items[0].message, "there");
}

// --- edits, modes, ends ------------------------------------------------------------------------

TEST_F(MediumProcessTest, PassesOnAChangeAndRefusesAStaleOne) {
    auto it = subdocument("colour 102030\nchange X");
    text::Edits got;
    it->onChange([&](const ipc::SubdocumentChanged& change) -> std::optional<QString> {
        got = change.edits;
        it->edit(change.edits, "Append");
        return std::nullopt;
    });
    it->start();
    ASSERT_TRUE(waitFor([&] { return !got.empty(); }));
    EXPECT_EQ(it->text(), "colour 102030\nchange XX");
}

TEST_F(MediumProcessTest, AnEntryOfTheEditModeMovesTheRenditions) {
    auto it = subdocument("colour 112233");
    auto rendition = it->createRendition();
    rendition->setShown(true);
    it->start();
    ASSERT_TRUE(waitFor([&] { return !rendition->picture().isNull(); }));
    int pictures = 0;
    QObject::connect(rendition.get(), &Rendition::pictureChanged, [&] { ++pictures; });
    it->invoke("editor", rendition.get());
    ASSERT_TRUE(waitFor([&] { return pictures > 0; }));
    EXPECT_EQ(it->condition(), Condition::live);
    EXPECT_TRUE(waitFor([&] { return pipes_.alive() == 1; })); // the other one has ended
}

TEST_F(MediumProcessTest, TimeAndViewComeBackInAnotherProcess) {
    TimeLimits limits = shortLimits();
    limits.restartsPerMinute = 1;
    const Manifest manifest = scriptedManifest();
    LiveSubdocument it(manifest, programOf(manifest, {}), pipes_, limits);
    it.setText("colour 102030\nduration 100");
    auto turned = it.createRendition(), other = it.createRendition();
    for (auto* rendition : {turned.get(), other.get()})
        rendition->setShown(true);
    it.start();
    ASSERT_TRUE(waitFor([&] { return it.time() && !turned->picture().isNull(); }));
    turned->painted();
    it.seek(40);
    it.setRate(2, true);
    ipc::Input press;
    press.type = ipc::InputType::press;
    turned->input(press);
    const QColor magenta(255, 0, 255);
    ASSERT_TRUE(waitFor([&] {
        turned->painted();
        return middle(turned->picture()) == magenta && it.time()->rate == 2;
    }));
    int pictures = 0, others = 0;
    it.invoke("crash", nullptr);
    ASSERT_TRUE(waitFor([&] { return it.condition() != Condition::live; }));
    QObject::connect(turned.get(), &Rendition::pictureChanged, [&] { ++pictures; });
    QObject::connect(other.get(), &Rendition::pictureChanged, [&] { ++others; });
    ASSERT_TRUE(waitFor(
        [&] { return pictures > 0 && others > 0 && it.time()->time == 40 && it.time()->loop; }));
    EXPECT_EQ(middle(turned->picture()), magenta);
    EXPECT_EQ(middle(other->picture()), QColor(0x10, 0x20, 0x30));
    EXPECT_FALSE(it.time()->playing);
    EXPECT_EQ(it.time()->rate, 2);
}

TEST_F(MediumProcessTest, NothingIsLeftOfAMediumThatDoesNotWantToGo) {
    {
        auto it = subdocument("behave stay\nbehave child");
        it->start();
        ASSERT_TRUE(waitFor([&] { return it->hasLoaded(); }));
    }
    EXPECT_TRUE(waitFor([&] { return pipes_.alive() == 0; }));
}

// Processes that sleep for so many seconds.
int sleeping(const QByteArray& seconds) {
    const QByteArray command = QByteArray("sleep\0", 6) + seconds + '\0';
    int count = 0;
    for (const QString& process : QDir("/proc").entryList(QDir::Dirs | QDir::NoDotAndDotDot)) {
        QFile file("/proc/" + process + "/cmdline");
        count += file.open(QIODevice::ReadOnly) && file.readAll() == command;
    }
    return count;
}

TEST_F(MediumProcessTest, WhatLeftTheSessionOfAMediumEndsWithIt) {
    const QByteArray seconds = QByteArray::number(1'000'000 + QCoreApplication::applicationPid());
    for (const char* end : {"", "\nbehave exit", "\nbehave crash", "\nbehave garbage"}) {
        auto it = subdocument("behave daemon " + seconds, {}, patient());
        it->start();
        ASSERT_TRUE(waitFor([&] { return it->hasLoaded() && sleeping(seconds) == 1; })) << end;
        if (*end)
            it->edit({{0, static_cast<std::size_t>(it->text().size()), end}}, {});
        else
            it->makeStill();
        EXPECT_TRUE(waitFor([&] { return pipes_.alive() == 0; })) << end;
        EXPECT_EQ(sleeping(seconds), 0) << end;
    }
}

TEST_F(MediumProcessTest, TheEndOfTheHostsMediaIsTheEndOfWhatLeftThem) {
    const QByteArray seconds = QByteArray::number(2'000'000 + QCoreApplication::applicationPid());
    {
        PipeThread pipes;
        const Manifest manifest = scriptedManifest();
        LiveSubdocument it(manifest, programOf(manifest, {}), pipes, patient());
        it.setText("behave stay\nbehave daemon " + seconds);
        it.start();
        ASSERT_TRUE(waitFor([&] { return it.hasLoaded() && sleeping(seconds) == 1; }));
    }
    EXPECT_EQ(sleeping(seconds), 0);
}

TEST_F(MediumProcessTest, InheritsNothingButWhatIsNamed) {
    Manifest manifest = scriptedManifest();
    manifest.command =
        QStringList{"/bin/sh", "-c", "{ ls /proc/self/fd | tr '\\n' ' '; env; } >&2"};
    qputenv("SECRET_OF_THE_USER", "1");
    MediumProcess process(manifest, "/bin/sh", Mode::play, pipes_);
    bool over = false;
    QObject::connect(&process, &MediumProcess::ended, [&] { over = true; });
    process.start();
    ASSERT_TRUE(waitFor([&] { return over; }));
    EXPECT_THAT(process.log().toStdString(), ::testing::StartsWith("0 1 2 3 ")); // and ls's own
    EXPECT_THAT(process.log().toStdString(), ::testing::Not(HasSubstr("SECRET_OF_THE_USER")));
    EXPECT_THAT(process.log().toStdString(), ::testing::Not(HasSubstr("HOME=")));
    qunsetenv("SECRET_OF_THE_USER");
}

TEST_F(MediumProcessTest, AProcessWithWindowsIsOfTheUsersDesktop) {
    Manifest manifest = scriptedManifest();
    manifest.command = QStringList{"/bin/sh", "-c", "env >&2"};
    qputenv("QT_SCALE_FACTOR", "1.5");
    qputenv("LC_ALL", "de_DE.UTF-8");
    MediumProcess process(manifest, "/bin/sh", Mode::edit, pipes_);
    bool over = false;
    QObject::connect(&process, &MediumProcess::ended, [&] { over = true; });
    process.start();
    ASSERT_TRUE(waitFor([&] { return over; }));
    for (const char* line : {"QT_SCALE_FACTOR=1.5", "LC_TIME=de_DE.UTF-8", "LC_NUMERIC=C"})
        EXPECT_THAT(process.log().toStdString(), HasSubstr(line));
    qunsetenv("QT_SCALE_FACTOR");
    qunsetenv("LC_ALL");
}

TEST_F(MediumProcessTest, StartsAndEndsLeaveNoDescriptorsBehind) {
    const auto descriptors = [] {
        return QDir("/proc/self/fd")
            .entryList(QDir::NoDotAndDotDot | QDir::AllEntries | QDir::System)
            .size();
    };
    const auto before = descriptors();
    for (int i = 0; i < 10; ++i) {
        auto it = subdocument(i % 2 ? "colour 102030" : "behave crash");
        auto rendition = it->createRendition();
        it->start();
        ASSERT_TRUE(
            waitFor([&] { return it->hasLoaded() || it->condition() == Condition::failed; }));
    }
    EXPECT_TRUE(waitFor([&] { return pipes_.alive() == 0 && descriptors() == before; }))
        << descriptors() << " instead of " << before;
}

TEST_F(MediumProcessTest, OnlyTheNearestLive) {
    Registry registry;
    registry.add(scriptedManifest());
    LiveMedia live(registry, {}, pipes_, shortLimits());
    live.setMostLive(3);
    std::vector<std::unique_ptr<LiveSubdocument>> all;
    for (int i = 0; i < 100; ++i) {
        all.push_back(live.create("SCRIPTED"));
        live.setDistance(*all.back(), this, i);
    }
    const auto living = [&] {
        std::string which;
        for (const auto& one : all)
            which += one->condition() == Condition::live ? '1' : one->hasProcess() ? '?' : '0';
        return which;
    };
    EXPECT_TRUE(waitFor([&] { return living() == "111" + std::string(97, '0'); })) << living();
    for (int i = 0; i < 100; ++i)
        live.setDistance(*all[i], this, std::abs(i - 50.2));
    EXPECT_TRUE(waitFor([&] {
        return living() == std::string(49, '0') + "111" + std::string(48, '0');
    })) << living();
}

TEST_F(MediumProcessTest, NoMoreLiveThanTheMemoryHas) {
    constexpr std::size_t mib = 1 << 20;
    const auto measured = std::make_shared<std::atomic<int>>(0);
    pipes_.setMostMemory(350 * mib);
    pipes_.setMeasure([measured](pid_t) {
        ++*measured;
        return 100 * mib;
    });
    Registry registry;
    registry.add(scriptedManifest());
    LiveMedia live(registry, {}, pipes_, patient());
    std::vector<std::unique_ptr<LiveSubdocument>> all;
    for (int i = 0; i < 8; ++i)
        all.push_back(live.create("SCRIPTED"));
    const auto living = [&] {
        std::string which;
        for (const auto& one : all)
            which += one->condition() == Condition::live ? '1' : one->hasProcess() ? '?' : '0';
        return which;
    };
    live.setDistance(*all[0], this, 0);
    ASSERT_TRUE(waitFor([&] { return living()[0] == '1' && *measured >= 2; }));
    for (int i = 0; i < 8; ++i)
        live.setDistance(*all[i], this, i);
    EXPECT_TRUE(waitFor([&] { return living() == "11100000"; })) << living();
    const int before = *measured;
    EXPECT_TRUE(waitFor([&] { return *measured >= before + 10; }));
    EXPECT_EQ(living(), "11100000");
    for (int i = 0; i < 8; ++i) // scrolled: the nearest live, and none was ended for its memory
        live.setDistance(*all[i], this, 8 - i);
    EXPECT_TRUE(waitFor([&] { return living() == "00000111"; })) << living();
    for (const auto& one : all)
        EXPECT_NE(one->condition(), Condition::failed);
}

// A reader who sees ten sees each of them play.
TEST_F(MediumProcessTest, TenThatAreSeenPlayAtOnce) {
    Registry registry;
    registry.add(scriptedManifest());
    LiveMedia live(registry, {}, pipes_, shortLimits());
    std::vector<std::unique_ptr<LiveSubdocument>> all;
    for (int i = 0; i < 10; ++i) {
        all.push_back(live.create("SCRIPTED"));
        all.back()->setText("duration 1000");
        live.setDistance(*all.back(), this, 0);
    }
    const auto each = [&](auto is) {
        return waitFor([&] { return std::ranges::all_of(all, is); });
    };
    ASSERT_TRUE(each([](const auto& one) { return one->time().has_value(); }));
    for (const auto& one : all)
        one->play();
    EXPECT_TRUE(each([](const auto& one) { return one->time()->playing; }));
}

} // namespace
} // namespace media

int main(int argc, char** argv) {
    QCoreApplication application(argc, argv);
    ::testing::InitGoogleTest(&argc, argv);
    return RUN_ALL_TESTS();
}
