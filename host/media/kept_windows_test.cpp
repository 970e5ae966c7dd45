// The state and drafts of a medium's own windows outlive its process.
#include "media/scripted_medium.h"

#include <gmock/gmock.h>

namespace media {
namespace {

using ::testing::HasSubstr;
using testing::scriptedManifest;
using testing::shortLimits;
using testing::waitFor;

class KeptWindowsTest : public ::testing::Test {
protected:
    void begin(const QByteArray& text, int restarts) {
        TimeLimits limits = shortLimits();
        limits.restartsPerMinute = restarts;
        limits.quiet = limits.hung = 20'000; // a slow machine is not what is tested here
        const Manifest manifest = scriptedManifest();
        it = std::make_unique<LiveSubdocument>(manifest, programOf(manifest, {}), pipes_, limits);
        it->setText(text);
        it->onChange([this](const ipc::SubdocumentChanged& change) -> std::optional<QString> {
            changes.push_back(change.edits.front().text);
            it->edit(change.edits, "Append");
            return std::nullopt;
        });
        it->start();
        ASSERT_TRUE(waitFor([&] { return it->hasLoaded(); }));
        it->invoke("editor", nullptr);
        ASSERT_TRUE(waitFor([&] { return !it->keptState().empty() && it->windows().drafts; }));
    }
    void crash() {
        it->invoke("crash", nullptr);
        ASSERT_TRUE(waitFor([&] { return it->condition() != Condition::live; }));
        EXPECT_TRUE(it->windows().drafts); // closing the document asks about them all the time
    }

    PipeThread pipes_;
    std::unique_ptr<LiveSubdocument> it;
    std::vector<std::string> changes;
};

TEST_F(KeptWindowsTest, WhatWasTypedIsThereAgainAndTheReaderIsToldWhy) {
    begin("colour 112233\nkeep NEWS", 1);
    EXPECT_EQ(it->keptState(), "NEWS");
    EXPECT_EQ(it->notice(), "");
    crash();
    ASSERT_TRUE(waitFor([&] { return it->hasLoaded() && it->takesDrafts(); }));
    EXPECT_EQ(it->notice(), "Scripted was ended by signal 11 (Segmentation fault). Its windows are "
                            "open again with what was typed.");
    it->takeDrafts();
    ASSERT_TRUE(waitFor([&] { return !changes.empty(); }));
    EXPECT_EQ(changes.front(), "NEWS");
    it->dismissNotice();
    EXPECT_EQ(it->notice(), "");
}

TEST_F(KeptWindowsTest, AClickOpensThemWhereNoMoreRestartsAreAllowed) {
    begin("keep NEWS", 0);
    crash();
    ASSERT_TRUE(waitFor([&] { return it->condition() == Condition::failed; }));
    EXPECT_EQ(it->keptState(), "NEWS");
    it->start(); // the click
    EXPECT_TRUE(waitFor([&] { return it->hasLoaded() && it->takesDrafts(); }));
    EXPECT_THAT(it->notice().toStdString(), HasSubstr("signal 11"));
}

// The picture is not lost with windows that cannot be opened.
TEST_F(KeptWindowsTest, WindowsThatEndTheirProcessAreOpenedOnlyWhenTheyAreAskedFor) {
    begin("keep behave crash", 3);
    crash();
    // One that opens them, and ends; then one that does not.
    ASSERT_TRUE(waitFor([&] { return it->hasLoaded() && !it->hasWindows(); }));
    EXPECT_EQ(it->keptState(), "behave crash");
    EXPECT_EQ(it->notice(), "");
    EXPECT_TRUE(it->windows().drafts);
}

TEST_F(KeptWindowsTest, AnotherRunOfTheHostOpensThem) {
    begin("colour 112233\nkeep NEWS", 0);
    const std::string state = it->keptState();
    const Manifest manifest = scriptedManifest();
    it =
        std::make_unique<LiveSubdocument>(manifest, programOf(manifest, {}), pipes_, shortLimits());
    it->setText("colour 112233");
    it->setKeptState(state);
    it->start();
    ASSERT_TRUE(waitFor([&] { return it->hasLoaded() && it->takesDrafts(); }));
    EXPECT_EQ(it->notice(), "The windows of Scripted are open again with what was typed.");
}

TEST(KeptWindows, AreForgottenWhenTheyAreClosedAndNeverLongerThanTheyMayBe) {
    KeptWindows kept;
    EXPECT_FALSE(kept.handOver("A", {}));
    kept.keep("one");
    kept.keep(std::string(KeptWindows::longest + 1, 'x'));
    EXPECT_EQ(kept.state(), "one");
    ASSERT_TRUE(kept.handOver("A", "A ended."));
    EXPECT_FALSE(kept.opensAgain()); // it said nothing of them since
    EXPECT_TRUE(kept.opensAgain());
    kept.keep("");
    EXPECT_FALSE(kept.any());
    EXPECT_FALSE(kept.opensAgain());
}

} // namespace
} // namespace media
