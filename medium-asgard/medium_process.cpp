#include "medium_process.h"

#include "charts/canvas.h"
#include "confinement/confinement.h"
#include "edit_mode.h"
#include "screen/display.h"
#include "terminal/terminal.h"

#include <array>
#include <csignal>
#include <string_view>

#include <unistd.h>

namespace asgard {
namespace {

// Room for a large scene and large frames; a run that wants more ends, not the machine.
constexpr std::size_t mostMemory = std::size_t{4} << 30;
constexpr std::size_t mostDescriptors = 64;

// A ball and a box that fall past each other.
scene::Scene smallScene() {
    scene::Scene scene;
    scene.simulator.finish = 1;
    scene.shapeSets.push_back({"ball", {scene::Part{}}, {}, {}});
    scene.shapeSets.push_back({"box", {scene::Part{scene::BoxShape{}, {}, {}, {}}}, {}, {}});
    for (const char* shape : {"ball", "box"}) {
        scene::Body& body = scene.bodies.emplace_back();
        body.name = body.shape = shape;
        body.initialPosition.x() = 4 * static_cast<double>(scene.bodies.size());
        scene::Force& force = scene.forces.emplace_back();
        force.body = shape;
        force.kind = scene::GravitationalForce{{0, -1, 0}};
    }
    return scene;
}

// With the first picture the driver opens files and starts threads, which it cannot later on, and
// compiles what it draws with, which takes longer than a ping may wait on a busy machine.
void warmUp(render::Renderer& renderer, int samples) {
    const scene::Scene scene = smallScene();
    render::Drawing drawing;
    drawing.scene = &scene;
    drawing.motion = simulation::simulate(scene).motion;
    drawing.time = scene.simulator.finish;
    drawing.display.samples = samples;
    constexpr render::Size size{64, 48};
    drawing.camera = render::framed(scene, drawing.motion, size);
    std::array<std::byte, 4 * size.width * size.height> pixels;
    if (!renderer.draw(drawing, {pixels, 4 * size.width, size}))
        terminal::complain("asgard: the graphics driver could not draw");
}

// The thread that draws is older than the fence of paths, which binds the thread that calls it: it
// gets one of its own. The others hold for all threads.
void confine(ipc::Mode mode, render::DrawingThread& drawing) {
    if (mode == ipc::Mode::edit)
        return;
    const confinement::Limits limits{mostMemory, std::nullopt, mostDescriptors};
    drawing.run([&] {
        (void)confinement::confine(confinement::Role::player, limits,
                                   {.limits = false, .calls = false}); // told by the next
    });
    const auto report = confinement::confine(confinement::Role::player, limits);
    if (!report.missing.empty())
        terminal::complain("asgard: not confined by every fence: " + report.missing);
}

} // namespace

void tieToTheHost(int argc, char** argv) {
    for (int i = 1; i < argc; ++i)
        if (std::string_view(argv[i]) == "--medium") {
            confinement::dieWithParent(getppid());
            // Without it (an older kernel) the filter on calls holds the driver's threads.
            (void)confinement::keepSignalsInside();
        }
}

int serveAsMedium(script::Reader& reader) {
    std::signal(SIGPIPE, SIG_IGN);
    Windows* windows = nullptr;
    charts::Canvas::keepFonts();
    service::Platform platform;
    platform.tools = computing::toolsOf(reader);
    platform.version = ASGARD_VERSION;
    // It draws its first picture before the process is confined, on the thread that draws the next.
    const auto renderer = std::make_shared<std::unique_ptr<render::Renderer>>();
    platform.thread = std::make_unique<render::DrawingThread>([renderer] { renderer->reset(); });
    platform.thread->run([&] {
        auto created = render::Renderer::create();
        if (const auto* sentence = std::get_if<std::string>(&created)) {
            platform.noPictures = *sentence;
            return terminal::complain("asgard: " + *sentence);
        }
        *renderer = std::get<std::unique_ptr<render::Renderer>>(std::move(created));
        warmUp(**renderer, service::stillSamples);
        platform.maximumSize = (*renderer)->maximumSize();
    });
    if (*renderer) {
        platform.inSpareTime = [renderer] { warmUp(**renderer, service::movingSamples); };
        platform.draw = [renderer](const render::Drawing& drawing, const render::Image& into,
                                   const service::Around& around) {
            return (*renderer)->draw(drawing, into, around.last.get(), around.keeps);
        };
    }
    platform.confine = [drawing = platform.thread.get()](ipc::Mode mode) {
        confine(mode, *drawing);
    };
    platform.openViewer = [&windows](const std::string& entry,
                                     const std::optional<ipc::ScreenArea>& figure) {
        if (windows)
            return windows->open(entry, figure);
        const std::string why = screen::displayFault();
        return std::optional(why.empty() ? "windows are opened by a process in mode \"edit\""
                                         : why);
    };
    platform.restoreWindows = [&windows](const std::string& state, const std::string& notice) {
        if (windows)
            windows->restore(state, notice);
    };
    service::Connection connection(std::move(platform), STDIN_FILENO, STDOUT_FILENO);
    service::serve(connection, [&connection] {
        return connection.session().mode() == ipc::Mode::edit && screen::displayFault().empty();
    });
    if (!connection.closed())
        serveWithWindows(connection, windows);
    return connection.exitCode();
}

} // namespace asgard
