// What a process that runs hostile machine code can do inside each confinement: nothing.
//
// Each attempt runs in a process of its own that is confined as an evaluator or a player is. Then
// again with fences taken away, to see that each of them stops what it is there for.
#include "attempts.h"

#include "confinement/confinement.h"
#include "script/reader.h"
#include "script/test_processes.h"

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <latch>
#include <sstream>
#include <thread>

#include <arpa/inet.h>
#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

namespace {

namespace fs = std::filesystem;
using confinement::Fences;
using confinement::Role;
using hostile::Also;
using hostile::Attempt;

constexpr Fences noFences{false, false, false, false};
constexpr int denied = 42;
constexpr int succeeded = 43;

confinement::Limits limitsFor(Role role) {
    if (role == Role::player)
        return {.memory = std::size_t{4} << 30, .cpuSeconds = {}, .descriptors = 64};
    return {.memory = std::size_t{256} << 20, .cpuSeconds = 2, .descriptors = 0};
}

// Who makes the attempt: a process whose descriptors are closed and whose environment is empty, one
// that was left as it is, or a thread of the first that Landlock does not bind.
enum class From { process, processAsItIs, olderThread };

// A folder with files to lose, a process to attack, a port to call.
class RawCalls : public testing::Test {
protected:
    void SetUp() override {
        before_ = fs::current_path();
        std::string pattern = (fs::temp_directory_path() / "cage-XXXXXX").string();
        folder_ = mkdtemp(pattern.data());
        fs::current_path(folder_);
        startOther();
        listener_ = socket(AF_INET, SOCK_STREAM, 0);
        sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        socklen_t size = sizeof address;
        ASSERT_EQ(bind(listener_, reinterpret_cast<sockaddr*>(&address), sizeof address), 0);
        ASSERT_EQ(listen(listener_, 50), 0);
        getsockname(listener_, reinterpret_cast<sockaddr*>(&address), &size);
        hostile::listeningPort = ntohs(address.sin_port);
        restock();
        hostile::inheritedDescriptor = open("canary", O_RDONLY);
    }

    void TearDown() override {
        close(listener_);
        close(hostile::inheritedDescriptor);
        kill(hostile::otherProcess, SIGKILL);
        waitpid(hostile::otherProcess, nullptr, 0);
        fs::current_path(before_);
        fs::remove_all(folder_);
    }

    static void startOther() {
        hostile::otherProcess = fork();
        if (hostile::otherProcess == 0) {
            prctl(PR_SET_PDEATHSIG, SIGKILL);
            while (true)
                pause();
        }
        setpgid(hostile::otherProcess, hostile::otherProcess);
    }

    // Where an attempt ended the other process, or made it slow.
    static void restartOther() {
        kill(hostile::otherProcess, SIGKILL);
        waitpid(hostile::otherProcess, nullptr, 0);
        startOther();
    }

    void restock() const {
        for (const auto& entry : fs::directory_iterator(folder_))
            fs::remove_all(entry.path());
        fs::create_directory("mounted");
        for (const char* name : {"canary", "spare1", "spare2", "spare4"})
            std::ofstream(name) << "secret";
    }

    // The names of the attempts that succeed.
    std::vector<std::string> run(Role role, Fences fences, From from = From::process) {
        std::vector<std::string> names;
        for (const Attempt& attempt : hostile::attempts()) {
            restock();
            const pid_t process = fork();
            if (process == 0)
                attack(attempt, role, fences, from);
            int status = 0;
            waitpid(process, &status, 0);
            if (!WIFEXITED(status)) // ended by a signal: it did not succeed
                continue;
            const int code = WEXITSTATUS(status);
            if (code == succeeded || code == 0) { // 0: another program ran in its place
                names.push_back(attempt.name);
                restartOther();
            } else if (code != denied)
                names.push_back(attempt.name + " was not even tried");
        }
        return names;
    }

private:
    [[noreturn]] static void attack(const Attempt& attempt, Role role, Fences fences, From from) {
        if (from != From::processAsItIs) {
            confinement::closeDescriptorsExcept({});
            confinement::emptyEnvironment();
        }
        alarm(10);
        std::latch confined(1);
        const auto tryIt = [&] {
            confined.wait();
            _exit(attempt.succeeds() ? succeeded : denied);
        };
        std::thread older;
        if (from == From::olderThread)
            older = std::thread(tryIt);
        if (fences != noFences)
            (void)confinement::confine(role, limitsFor(role), fences);
        confined.count_down();
        if (older.joinable())
            older.join();
        tryIt();
        _exit(denied);
    }

    fs::path before_;
    fs::path folder_;
    int listener_ = -1;
};

std::vector<std::string> namesWhere(auto condition) {
    std::vector<std::string> names;
    for (const Attempt& attempt : hostile::attempts())
        if (condition(attempt))
            names.push_back(attempt.name);
    return names;
}

bool landlockIsHere() {
    const pid_t process = fork();
    if (process == 0)
        _exit(confinement::confine(Role::evaluator, {}, {false, true, true, false}).inForce.paths
                  ? 1
                  : 0);
    int status = 0;
    waitpid(process, &status, 0);
    return WEXITSTATUS(status) == 1;
}

TEST_F(RawCalls, NoneSucceedsInAnEvaluator) {
    EXPECT_GE(hostile::attempts().size(), 98u);
    EXPECT_THAT(run(Role::evaluator, {}), testing::IsEmpty());
}

TEST_F(RawCalls, NoneSucceedsInAPlayer) {
    const auto may = namesWhere([](const Attempt& a) { return a.playerMay; });
    EXPECT_THAT(run(Role::player, {}), testing::IsSubsetOf(may));
}

// As the threads of a graphics driver are, which was there before the document.
TEST_F(RawCalls, NoneSucceedsInAPlayersOlderThread) {
    const auto may = namesWhere([](const Attempt& a) { return a.playerMay; });
    EXPECT_THAT(run(Role::player, {}, From::olderThread), testing::IsSubsetOf(may));
}

// It parses nothing, and makes processes; they are its own. What Tcl asks for as it starts is let
// through.
TEST_F(RawCalls, ThatReachOthersFailInAServer) {
    const std::vector<std::string> may{"ask for a file's size", "fork by clone",
                                       "outlive the parent", "raise a limit", "take a gigabyte"};
    EXPECT_THAT(run(Role::server, {}), testing::IsSubsetOf(may));
    // Without Landlock, as on kernels where it knows of no signals.
    EXPECT_THAT(run(Role::server, {true, true, false, true}), testing::IsSubsetOf(may));
}

// The attempts are real: without fences all that an ordinary process may do succeed.
TEST_F(RawCalls, SucceedWhereNothingIsConfined) {
    const auto ordinary = namesWhere([](const Attempt& a) { return a.ordinary; });
    const auto done = run(Role::evaluator, noFences, From::processAsItIs);
    EXPECT_THAT(done, testing::IsSupersetOf(ordinary));
    EXPECT_THAT(done, testing::Contains("use an inherited descriptor"));
    EXPECT_THAT(done, testing::Contains("read a variable of the environment"));
}

TEST_F(RawCalls, AreStoppedByTheFilterAlone) {
    EXPECT_THAT(run(Role::evaluator, {false, false, false, true}),
                testing::UnorderedElementsAre("take a gigabyte"));
}

TEST_F(RawCalls, OnPathsAreStoppedByLandlockAlone) {
    const auto paths = namesWhere([](const Attempt& a) { return a.also == Also::paths; });
    const auto done = run(Role::evaluator, {false, false, true, false});
    std::vector<std::string> through;
    for (const std::string& name : paths)
        if (std::find(done.begin(), done.end(), name) != done.end())
            through.push_back(name);
    if (landlockIsHere())
        EXPECT_THAT(through, testing::IsEmpty());
    else
        GTEST_SKIP() << "this kernel has no Landlock; the filter on calls stands alone";
}

TEST_F(RawCalls, OnResourcesAreStoppedByLimitsAlone) {
    const auto limited = namesWhere([](const Attempt& a) { return a.also == Also::limits; });
    const auto done = run(Role::evaluator, {true, false, false, false});
    for (const std::string& name : limited)
        EXPECT_THAT(done, testing::Not(testing::Contains(name)));
}

// Paths hold in the evaluator's own confinement too, in which no descriptor can be opened.
TEST_F(RawCalls, OnPathsAreStoppedWithoutTheFilter) {
    const auto paths = namesWhere([](const Attempt& a) { return a.also == Also::paths; });
    if (!landlockIsHere())
        GTEST_SKIP() << "this kernel has no Landlock; the filter on calls stands alone";
    const auto done = run(Role::evaluator, {true, true, true, false});
    for (const std::string& name : paths)
        EXPECT_THAT(done, testing::Not(testing::Contains(name)));
}

TEST_F(RawCalls, AreStoppedWithAnyOneFenceMissing) {
    EXPECT_THAT(run(Role::evaluator, {true, true, false, true}), testing::IsEmpty());
    EXPECT_THAT(run(Role::evaluator, {true, false, true, true}), testing::IsEmpty());
    EXPECT_THAT(run(Role::evaluator, {false, true, true, true}),
                testing::UnorderedElementsAre("take a gigabyte"));
}

TEST(Privileges, CannotBeGainedAndTheProcessCannotBeRead) {
    const pid_t process = fork();
    if (process == 0) {
        const auto report = confinement::confine(Role::evaluator, {}, {false, true, false, false});
        const bool good = report.inForce.privileges &&
                          prctl(PR_GET_NO_NEW_PRIVS, 0, 0, 0, 0) == 1 &&
                          prctl(PR_GET_DUMPABLE, 0, 0, 0, 0) == 0;
        _exit(good ? succeeded : denied);
    }
    int status = 0;
    waitpid(process, &status, 0);
    EXPECT_EQ(WEXITSTATUS(status), succeeded);
}

// A pipe's owner gets a signal from the kernel, not from the thread that wrote into it.
TEST_F(RawCalls, OfSignalsStayInsideBeforeThereAreThreads) {
    const pid_t process = fork();
    if (process == 0) {
        if (!confinement::keepSignalsInside().empty())
            _exit(2);
        for (const Attempt& attempt : hostile::attempts())
            if (attempt.name.find("signal") != std::string::npos ||
                attempt.name.find("end another") != std::string::npos)
                (void)attempt.succeeds();
        _exit(kill(hostile::otherProcess, 0) == 0 ? 1 : 0);
    }
    int status = 0;
    waitpid(process, &status, 0);
    if (WIFEXITED(status) && WEXITSTATUS(status) == 2)
        GTEST_SKIP() << "this kernel does not bound signals; the filter on calls stands alone";
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << status;
    EXPECT_EQ(kill(hostile::otherProcess, 0), 0);
    EXPECT_EQ(waitpid(hostile::otherProcess, nullptr, WNOHANG), 0) << "it was ended";
}

TEST(Report, SaysWhichFencesAreInForce) {
    int ends[2];
    ASSERT_EQ(pipe(ends), 0);
    const pid_t process = fork();
    if (process == 0) {
        const auto report = confinement::confine(Role::player, limitsFor(Role::player));
        const Fences f = report.inForce;
        const char answer[4] = {static_cast<char>('0' + f.limits),
                                static_cast<char>('0' + f.privileges),
                                static_cast<char>('0' + (f.paths || report.landlockVersion == 0)),
                                static_cast<char>('0' + f.calls)};
        _exit(write(ends[1], answer, 4) == 4 ? 0 : 1); // its pipe still works
    }
    char answer[5] = {};
    EXPECT_EQ(read(ends[0], answer, 4), 4);
    EXPECT_STREQ(answer, "1111");
    waitpid(process, nullptr, 0);
    close(ends[0]);
    close(ends[1]);
}

TEST(Report, OfATrialIsThatOfTheRealThing) {
    const auto report = confinement::tryOut(Role::evaluator, limitsFor(Role::evaluator));
    EXPECT_TRUE(report.inForce.limits && report.inForce.privileges && report.inForce.calls);
    EXPECT_EQ(report.inForce.paths, landlockIsHere());
    EXPECT_EQ(report.missing.empty(), report.inForce.paths);
    std::ifstream stillFree("/proc/self/status"); // this process is as it was
    EXPECT_TRUE(stillFree.good());
}

// A process that computes and never reads its pipe would outlive the one that started it.
TEST(DieWithParent, EndsABusyProcess) {
    int ends[2];
    ASSERT_EQ(pipe(ends), 0);
    const pid_t parent = fork();
    if (parent == 0) {
        const pid_t self = getpid();
        if (fork() == 0) {
            confinement::dieWithParent(self);
            if (write(ends[1], "x", 1) != 1)
                _exit(1);
            std::atomic<unsigned> i{0};
            while (true)
                ++i;
        }
        pause();
    }
    close(ends[1]);
    char c = 0;
    ASSERT_EQ(read(ends[0], &c, 1), 1); // it runs
    kill(parent, SIGKILL);
    waitpid(parent, nullptr, 0);
    EXPECT_EQ(read(ends[0], &c, 1), 0); // the last writer is gone
    close(ends[0]);
}

// --- the real evaluators --------------------------------------------------------------------

using script::testing::childrenOf;
using script::testing::statusOf;

TEST(Evaluators, OfAReaderStandConfined) {
    const script::Reader reader;
    (void)const_cast<script::Reader&>(reader).read("");
    const std::vector<pid_t> servers = childrenOf(getpid());
    ASSERT_EQ(servers.size(), 2u); // one works, one is spare
    std::vector<pid_t> evaluators;
    // The next one is made ready just after the answer.
    for (int i = 0;
         i < 60'000 && (evaluators.empty() || statusOf(evaluators[0], "Seccomp_filters") != "2");
         ++i) {
        usleep(2000);
        evaluators = childrenOf(servers[0]);
        if (evaluators.empty())
            evaluators = childrenOf(servers[1]);
    }
    ASSERT_EQ(evaluators.size(), 1u);
    for (const pid_t process : {servers[0], servers[1], evaluators[0]}) {
        EXPECT_EQ(statusOf(process, "Seccomp"), "2");
        EXPECT_EQ(statusOf(process, "NoNewPrivs"), "1");
        EXPECT_EQ(statusOf(process, "Threads"), "1");
    }
    for (const pid_t server : servers)
        EXPECT_EQ(statusOf(server, "Seccomp_filters"), "1");
    EXPECT_EQ(statusOf(evaluators[0], "Seccomp_filters"), "2");
    EXPECT_TRUE(childrenOf(evaluators[0]).empty());
}

} // namespace
