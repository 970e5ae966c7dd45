// Every hostile script ends in a sentence within its time, and reaches nothing.
//
// scripts.txt holds them. They run where a canary file lies and a socket listens; afterwards the
// file is as it was, no other has appeared, nobody has connected, and no process is left.
#include "script/reader.h"

#include <atomic>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <mutex>
#include <regex>
#include <sstream>
#include <thread>

#include <arpa/inet.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr const char* secret = "the canary sings";

struct Script {
    std::string kind;
    std::string text;
};

// "%5000*[%" is five thousand brackets.
std::string expanded(const std::string& text) {
    static const std::regex run("%([0-9]+)\\*(.)%");
    std::string out;
    std::sregex_iterator at(text.begin(), text.end(), run);
    std::size_t copied = 0;
    for (; at != std::sregex_iterator(); ++at) {
        out += text.substr(copied, static_cast<std::size_t>(at->position()) - copied);
        out += std::string(std::stoul((*at)[1]), (*at)[2].str()[0]);
        copied = static_cast<std::size_t>(at->position() + at->length());
    }
    return out + text.substr(copied);
}

std::vector<Script> scripts(const std::string& port) {
    std::vector<Script> all;
    std::ifstream file(SOURCE_DIR "/tests/hostile/scripts.txt");
    for (std::string line; std::getline(file, line);) {
        if (line.starts_with("=== "))
            all.push_back({line.substr(4), ""});
        else if (!all.empty())
            all.back().text += std::regex_replace(line, std::regex("PORT"), port) + "\n";
    }
    for (Script& script : all)
        script.text = expanded(script.text);
    return all;
}

class Listener {
public:
    Listener() : fd_(socket(AF_INET, SOCK_STREAM, 0)) {
        sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        socklen_t size = sizeof address;
        if (bind(fd_, reinterpret_cast<sockaddr*>(&address), sizeof address) == 0 &&
            listen(fd_, 5) == 0 &&
            getsockname(fd_, reinterpret_cast<sockaddr*>(&address), &size) == 0)
            port_ = std::to_string(ntohs(address.sin_port));
    }
    ~Listener() { close(fd_); }
    Listener(const Listener&) = delete;
    Listener& operator=(const Listener&) = delete;
    [[nodiscard]] const std::string& port() const { return port_; }
    [[nodiscard]] bool wasCalled() const {
        pollfd waiting{fd_, POLLIN, 0};
        return poll(&waiting, 1, 0) > 0;
    }

private:
    int fd_;
    std::string port_;
};

// The folder with the canary, in which this process stands.
class Cage {
public:
    Cage() : before_(fs::current_path()) {
        std::string pattern = (fs::temp_directory_path() / "cage-XXXXXX").string();
        folder_ = mkdtemp(pattern.data());
        fs::current_path(folder_);
        std::ofstream("canary") << secret;
    }
    ~Cage() {
        fs::current_path(before_);
        fs::remove_all(folder_);
    }
    Cage(const Cage&) = delete;
    Cage& operator=(const Cage&) = delete;
    [[nodiscard]] static bool untouched() {
        std::ifstream file("canary");
        std::stringstream text;
        text << file.rdbuf();
        const auto files = std::distance(fs::directory_iterator("."), fs::directory_iterator());
        return text.str() == secret && files == 1;
    }

private:
    fs::path before_;
    fs::path folder_;
};

// What is wrong with how a script ended, or "".
std::string fault(const Script& script, const script::ReadResult& result, double seconds) {
    // A server ends a script after 3 s; a reader gives up a server after 3 s more, and tries once
    // again. A script that takes longer hangs. (How fast the others are is no test's matter: the
    // machine may be loaded.)
    constexpr double most = 2 * (3.0 + 3.0);
    if (seconds > most)
        return "took " + std::to_string(seconds) + " s";
    if (script.kind != "harmless" && (result.usable || result.diagnostics.empty()))
        return "is taken for a scene";
    std::string all;
    for (const scene::Diagnostic& diagnostic : result.diagnostics) {
        all += diagnostic.message + "\n";
        if (diagnostic.message.empty() || diagnostic.message.find('\n') != std::string::npos)
            return "has a message that is not one line";
    }
    if (all.find(secret) != std::string::npos)
        return "read the canary";
    static const std::regex refusal(
        "scenes have no command|there is no command|no such variable|"
        "subcommand|bad level|unknown namespace|should be|unknown object|not found");
    if (script.kind == "refused" && !std::regex_search(all, refusal))
        return "is not refused: " + all;
    return "";
}

TEST(HostileScripts, EndInASentenceAndReachNothing) {
    const Cage cage;
    const Listener listener;
    const std::vector<Script> all = scripts(listener.port());
    ASSERT_GE(all.size(), 200u);
    // Most wait for a limit of time rather than compute.
    constexpr int readers = 6;
    std::vector<std::unique_ptr<script::Reader>> pool; // forked before there are threads
    for (int i = 0; i < readers; ++i)
        pool.push_back(std::make_unique<script::Reader>());
    std::atomic<std::size_t> next{0};
    std::mutex mutex;
    std::vector<std::string> faults;
    {
        std::vector<std::jthread> threads;
        for (const auto& reader : pool)
            threads.emplace_back([&, own = reader.get()] {
                for (std::size_t i = next++; i < all.size(); i = next++) {
                    const auto start = Clock::now();
                    const script::ReadResult result = own->read(all[i].text);
                    const std::chrono::duration<double> taken = Clock::now() - start;
                    const std::string what = fault(all[i], result, taken.count());
                    const std::lock_guard lock(mutex);
                    if (std::getenv("VERBOSE"))
                        std::printf("%5.2f s  %-60.60s  %s\n", taken.count(), all[i].text.c_str(),
                                    result.diagnostics.empty()
                                        ? "-"
                                        : result.diagnostics[0].message.substr(0, 120).c_str());
                    if (!what.empty())
                        faults.push_back(all[i].text.substr(0, 100) + ": " + what);
                }
            });
    }
    EXPECT_THAT(faults, testing::IsEmpty());
    // The readers go on.
    for (const auto& reader : pool)
        EXPECT_TRUE(reader->read("shape_set s -desc {-sub {-sphere 1}}\nbody b s").usable);
    pool.clear();
    EXPECT_EQ(waitpid(-1, nullptr, WNOHANG), -1); // no child is left
    EXPECT_TRUE(Cage::untouched());
    EXPECT_FALSE(listener.wasCalled());
}

} // namespace
