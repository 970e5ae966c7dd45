// A confined player still does what a player does: draws, computes in threads, waits, reads scenes.
//
// In the order of a medium's start: an evaluator server forked, a frame drawn, confined.
#include "confinement/confinement.h"
#include "expression/function.h"
#include "render/renderer.h"
#include "script/reader.h"
#include "script/test_processes.h"

#include <array>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <future>
#include <optional>
#include <vector>

#include <gtest/gtest.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

namespace {

std::size_t pixelsDrawn(render::Renderer& renderer, const scene::Scene& scene, int width) {
    const render::Size size{width, width * 3 / 4};
    const auto stride = static_cast<std::size_t>(size.width) * 4;
    std::vector<std::byte> pixels(stride * static_cast<std::size_t>(size.height));
    render::Drawing drawing;
    drawing.scene = &scene;
    drawing.camera = render::framed(scene, {}, size);
    drawing.display.grid = false;
    if (!renderer.draw(drawing, {pixels, stride, size}))
        return 0;
    std::size_t dark = 0;
    for (std::size_t i = 0; i < pixels.size(); i += 4)
        dark += pixels[i] != pixels[0] || pixels[i + 1] != pixels[1] ? 1 : 0;
    return dark;
}

// Evaluates until machine code would pay; how much was made, or none when a number was wrong.
std::optional<std::size_t> codesMade() {
    expression::Graph graph;
    const expression::Node x = graph.symbol("x"), square = graph.multiply(x, x);
    const expression::Function function(
        expression::Tape(graph, std::span(&x, 1), std::span(&square, 1)));
    expression::Function::Scratch scratch;
    const std::size_t before = expression::Kernel::counts().compiled;
    for (int i = 0; i < 20'000; ++i) {
        const double at = i;
        double value = 0;
        function.evaluate(std::span(&at, 1), std::span(&value, 1), scratch);
        if (value != at * at)
            return std::nullopt;
    }
    return expression::Kernel::counts().compiled - before;
}

using script::testing::childrenOf;

// Asked by a byte: ends the evaluator server of `player` that works, and answers when it is gone.
void endServerOf(pid_t player, int asked, int answer) {
    char byte = 0;
    if (read(asked, &byte, 1) != 1)
        return;
    pid_t working = 0;
    for (auto servers = childrenOf(player); working == 0 && !servers.empty();
         servers = childrenOf(player))
        for (const pid_t server : servers)
            working = childrenOf(server).empty() ? working : server;
    ASSERT_NE(working, 0) << "the player has ended";
    kill(working, SIGKILL);
    while (std::ranges::count(childrenOf(player), working) != 0)
        usleep(1000);
    (void)!write(answer, &byte, 1);
}

// Returns the number of the step that failed, 0 when all is well.
int play(int ask, int answered) {
    script::Reader reader;
    auto made = render::Renderer::create();
    auto* renderer = std::get_if<std::unique_ptr<render::Renderer>>(&made);
    if (!renderer)
        return 1;
    scene::Scene nothing;
    (void)pixelsDrawn(**renderer, nothing, 64);
    const auto report =
        confinement::confine(confinement::Role::player,
                             {.memory = std::size_t{4} << 30, .cpuSeconds = {}, .descriptors = 64});
    if (!report.inForce.calls || !report.inForce.privileges)
        return 2;
    // Only now the document.
    const script::ReadResult read =
        reader.read("shape_set s -desc {-sub {-box {1 2 3} -color red}}\n"
                    "body b s -init_rot {1 1 0}\n");
    if (!read.usable)
        return 3;
    // Other sizes, other samples, meshes and states of the pipeline than before.
    for (const int width : {160, 640, 320})
        if (pixelsDrawn(**renderer, read.scene, width) < 100)
            return 4;
    if (std::async(std::launch::async, [] { return 7; }).get() != 7)
        return 5;
    pollfd nothingToRead{-1, POLLIN, 0};
    if (poll(&nothingToRead, 1, 5) != 0)
        return 6;
    // A script that runs away is ended by the server, though this process may signal nobody.
    const script::ReadResult endless = reader.read("while 1 {}");
    if (endless.usable || endless.diagnostics.empty())
        return 7;
    const std::size_t expected = expression::Function::lanes() > 1 ? 1 : 0;
    if (codesMade() != expected)
        return 9;
    if (!reader.read("").usable)
        return 8;
    // Its server is ended from outside; the spare takes its place and makes another.
    char byte = 0;
    for (int i = 0; i < 2; ++i)
        if (write(ask, "x", 1) != 1 || ::read(answered, &byte, 1) != 1 || !reader.read("").usable)
            return 10;
    return 0;
}

TEST(Player, DrawsAndReadsScenesWhenConfined) {
    std::array<int, 2> asking{-1, -1};
    std::array<int, 2> answering{-1, -1};
    ASSERT_TRUE(pipe(asking.data()) == 0 && pipe(answering.data()) == 0);
    const pid_t process = fork();
    if (process == 0) {
        close(asking[0]);
        _exit(play(asking[1], answering[0]));
    }
    close(asking[1]);
    for (int i = 0; i < 2; ++i)
        endServerOf(process, asking[0], answering[1]);
    int status = 0;
    waitpid(process, &status, 0);
    ASSERT_TRUE(WIFEXITED(status)) << "signal " << WTERMSIG(status);
    EXPECT_EQ(WEXITSTATUS(status), 0) << "the step that failed";
}

// An evaluator may make nothing executable; numbers come all the same.
TEST(Evaluator, ComputesWithoutMachineCode) {
    const pid_t process = fork();
    if (process == 0) {
        const auto report = confinement::confine(confinement::Role::evaluator, {});
        _exit(!report.inForce.calls ? 1 : codesMade() == std::size_t{0} ? 0 : 2);
    }
    int status = 0;
    waitpid(process, &status, 0);
    ASSERT_TRUE(WIFEXITED(status)) << "signal " << WTERMSIG(status);
    EXPECT_EQ(WEXITSTATUS(status), 0);
}

} // namespace
