// Readings go on where an evaluator server ended.
#include "script/reader.h"
#include "script/test_processes.h"

#include <algorithm>
#include <array>
#include <csignal>
#include <optional>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

namespace script {
namespace {

constexpr const char* scene = "shape_set s -desc {-sub {-sphere 1}}\nbody b s";

using testing::childrenOf;
using testing::statusOf;

// The servers of one reader. Other tests' readers may have theirs already.
class Servers : public ::testing::Test {
protected:
    [[nodiscard]] std::vector<pid_t> servers() const {
        std::vector<pid_t> all = childrenOf(getpid());
        std::erase_if(all, [&](pid_t server) { return std::ranges::count(before_, server) != 0; });
        return all;
    }
    // The one that works or the spare; returns when it is gone. The one that works has an
    // evaluator, but not at once: it makes the next one after it has answered.
    void endServer(bool working) const {
        std::optional<pid_t> server;
        while (!(server = oneOfTwo(working)))
            usleep(1000);
        kill(*server, SIGKILL);
        while (std::ranges::count(servers(), *server) != 0)
            usleep(1000);
    }

private:
    // Nothing while it cannot be told which is which.
    [[nodiscard]] std::optional<pid_t> oneOfTwo(bool working) const {
        const std::vector<pid_t> both = servers();
        if (both.size() != 2)
            return std::nullopt;
        const std::array<bool, 2> works{!childrenOf(both[0]).empty(), !childrenOf(both[1]).empty()};
        if (works[0] == works[1])
            return std::nullopt;
        return both[works[0] == working ? 0 : 1];
    }

    std::vector<pid_t> before_ = childrenOf(getpid());
};

std::string messages(const ReadResult& result) {
    std::string all;
    for (const scene::Diagnostic& diagnostic : result.diagnostics)
        all += diagnostic.message + "\n";
    return all;
}

TEST_F(Servers, ThatEndedAreReplacedAndAWarningSaysSo) {
    Reader reader;
    ASSERT_TRUE(reader.read(scene).usable);
    ASSERT_EQ(servers().size(), 2u);
    for (int i = 0; i < 2; ++i) {
        endServer(true);
        const ReadResult result = reader.read(scene);
        EXPECT_TRUE(result.usable) << messages(result);
        EXPECT_EQ(result.scene.bodies.size(), 1u);
        EXPECT_EQ(messages(result), "the process that evaluates scripts was ended from outside; "
                                    "another was started\n");
        EXPECT_EQ(messages(reader.read(scene)), "");
        ASSERT_EQ(servers().size(), 2u);
        for (const pid_t server : servers()) { // within the same fences
            EXPECT_EQ(statusOf(server, "Seccomp"), "2");
            EXPECT_EQ(statusOf(server, "Seccomp_filters"), "1");
            EXPECT_EQ(statusOf(server, "NoNewPrivs"), "1");
        }
    }
}

TEST_F(Servers, AreReplacedWhileTheyRead) {
    Reader reader({.wallClock = std::chrono::milliseconds(1500)});
    (void)reader.read(scene);
    std::jthread other([&] {
        // Its evaluator computes.
        for (int i = 0; i < 500; ++i)
            for (const pid_t server : servers())
                for (const pid_t evaluator : childrenOf(server))
                    if (statusOf(evaluator, "State").starts_with("R")) {
                        kill(server, SIGKILL);
                        return;
                    }
    });
    const ReadResult result = reader.read("while 1 {}");
    EXPECT_THAT(messages(result), ::testing::HasSubstr("did not end within 1.5 s"));
    EXPECT_THAT(messages(result), ::testing::HasSubstr("another was started"));
    EXPECT_TRUE(reader.read(scene).usable);
}

TEST_F(Servers, ThatAreSpareAreReplacedToo) {
    Reader reader;
    (void)reader.read(scene);
    for (int i = 0; i < 2; ++i) {
        endServer(false);
        EXPECT_EQ(messages(reader.read(scene)), ""); // no reading was lost by it
        EXPECT_EQ(servers().size(), 2u);
    }
    endServer(true);
    EXPECT_TRUE(reader.read(scene).usable);
}

TEST_F(Servers, ThatEndTooOftenWait) {
    Reader reader({.restarts = 1, .restartsWithin = std::chrono::milliseconds(3'600'000)});
    (void)reader.read(scene);
    endServer(true);
    EXPECT_TRUE(reader.read(scene).usable);
    endServer(true);
    for (int i = 0; i < 2; ++i) {
        const ReadResult result = reader.read(scene);
        EXPECT_FALSE(result.usable);
        EXPECT_THAT(messages(result), ::testing::HasSubstr("was ended 2 times within 3600 s; try "
                                                           "again when as much time has passed"));
    }
}

TEST_F(Servers, AreReplacedAgainWhenTheTimeIsOver) {
    Reader reader({.restarts = 0, .restartsWithin = std::chrono::milliseconds(0)});
    (void)reader.read(scene);
    for (int i = 0; i < 5; ++i) {
        endServer(true);
        EXPECT_TRUE(reader.read(scene).usable);
    }
}

TEST_F(Servers, ThatEndTogetherAreMissed) {
    Reader reader;
    (void)reader.read(scene);
    for (const pid_t server : servers())
        kill(server, SIGKILL);
    while (!servers().empty())
        usleep(1000);
    const ReadResult result = reader.read(scene);
    EXPECT_FALSE(result.usable);
    EXPECT_THAT(messages(result), ::testing::HasSubstr("save, and start this program again"));
}

TEST_F(Servers, LeaveWithTheirReader) {
    { Reader reader; }
    EXPECT_THAT(servers(), ::testing::IsEmpty());
}

} // namespace
} // namespace script
