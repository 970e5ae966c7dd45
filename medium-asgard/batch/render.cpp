#include "batch/command.h"
#include "batch/input.h"
#include "batch/picture_file.h"
#include "batch/waiting.h"
#include "framing/view.h"
#include "lettering/values_beside.h"
#include "script/svg_colors.h"
#include "simulation/simulation.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <filesystem>

namespace batch {
namespace {

struct Target {
    PictureFormat format = PictureFormat::png;
    bool folder = false; // numbered pictures
};

int refuseFor(const std::string& sentence, int exitCode) {
    return refuse(Refusal{exitCode, sentence});
}

std::variant<Target, Refusal> targetOf(const std::string& output) {
    std::error_code ignored;
    if (output.ends_with('/') || std::filesystem::is_directory(output, ignored))
        return Target{PictureFormat::png, true};
    const std::string extension = std::filesystem::path(output).extension();
    if (extension == ".png")
        return Target{PictureFormat::png, false};
    if (extension == ".ppm")
        return Target{PictureFormat::ppm, false};
    return Refusal{wrongUsage,
                   "this version writes .png, .ppm and numbered pictures into DIR/, not \"" +
                       output + "\""};
}

std::optional<render::Size> sizeOf(const std::string& written) {
    render::Size size;
    const char* end = written.data() + written.size();
    const auto width = std::from_chars(written.data(), end, size.width);
    if (width.ec != std::errc{} || width.ptr == end || *width.ptr != 'x')
        return std::nullopt;
    const auto height = std::from_chars(width.ptr + 1, end, size.height);
    if (height.ec != std::errc{} || height.ptr != end || size.width < 1 || size.height < 1)
        return std::nullopt;
    return size;
}

// The times of the pictures: one, or those of a film.
std::variant<std::vector<double>, Refusal> timesOf(const RenderArguments& arguments, bool folder,
                                                   double start, double finish) {
    const bool film = arguments.from || arguments.to || arguments.fps;
    if (film && arguments.time)
        return Refusal{wrongUsage, "--time excludes --from, --to and --fps"};
    if (film && !folder)
        return Refusal{wrongUsage, "--from, --to and --fps want a folder: --output DIR/"};
    std::vector<double> times{arguments.time.value_or(start)};
    if (folder && !arguments.time) {
        const double from = arguments.from.value_or(start), to = arguments.to.value_or(finish);
        const double rate = arguments.fps.value_or(25);
        if (!(rate > 0 && rate <= 1000) || !(to >= from) || (to - from) * rate > 99'999)
            return Refusal{wrongUsage, "--from, --to and --fps want 1 to 99999 pictures"};
        times.clear();
        for (int i = 0; i <= static_cast<int>((to - from) * rate + 1e-9); ++i)
            times.push_back(std::min(from + i / rate, to));
    }
    for (const double time : times)
        if (!(time >= start && time <= finish)) {
            char text[120];
            std::snprintf(text, sizeof text, "time %g lies outside the motion, %g to %g", time,
                          start, finish);
            return Refusal{failure, text};
        }
    return times;
}

std::string fileName(const std::string& output, bool folder, std::size_t index) {
    if (!folder)
        return output;
    char name[32];
    std::snprintf(name, sizeof name, "%05zu.png", index + 1);
    return (std::filesystem::path(output) / name).string();
}

std::optional<scene::Color> colorOf(const std::string& written) {
    if (written.empty())
        return scene::Color{1, 1, 1};
    if (!written.starts_with('#'))
        return script::namedColor(written);
    unsigned value = 0;
    const char* end = written.data() + written.size();
    const auto read = std::from_chars(written.data() + 1, end, value, 16);
    if (written.size() != 7 || read.ec != std::errc{} || read.ptr != end)
        return std::nullopt;
    const auto part = [value](int shift) { return ((value >> shift) & 0xFFU) / 255.0; };
    return scene::Color{part(16), part(8), part(0)};
}

std::optional<std::string> unknownView(const scene::Scene& scene, const std::string& name) {
    std::string names;
    for (const scene::View& view : scene.views) {
        if (view.name == name)
            return std::nullopt;
        names += (names.empty() ? "" : " ") + view.name;
    }
    return "no view named \"" + name + "\" (views here: " + (names.empty() ? "none" : names) + ")";
}

// For the values that stand beside bodies; no plots where there are none.
meters::Sampled sampledOf(const scene::Scene& scene, const simulation::MotionPointer& motion) {
    const std::vector<meters::Meter> all = meters::metersOf(scene);
    if (all.empty())
        return {};
    meters::Sampled sampled{{std::shared_ptr<const void>(), &scene}, {}}; // the scene outlives them
    simulation::ReadableScene readable(scene);
    for (std::size_t i = 0; i <= all.back().plot; ++i)
        sampled.plots.push_back(*charts::sampled(readable, scene, scene.plots[i], motion));
    return sampled;
}

int drawAll(const SceneText& scene, const simulation::MotionPointer& motion,
            const RenderArguments& arguments, Target target, render::Size size,
            const std::vector<double>& times) {
    auto created = render::Renderer::create();
    if (const auto* sentence = std::get_if<std::string>(&created))
        return refuseFor(*sentence, failure);
    render::Renderer& renderer = *std::get<std::unique_ptr<render::Renderer>>(created);
    if (std::max(size.width, size.height) > renderer.maximumSize())
        return refuseFor("pictures are at most " + std::to_string(renderer.maximumSize()) +
                             " pixels wide and high here",
                         failure);
    const meters::Sampled sampled = sampledOf(scene.reading.scene, motion);
    const render::SceneView view(scene.reading.scene, motion, arguments.view, size);
    const auto stride = 4 * static_cast<std::size_t>(size.width);
    std::vector<std::byte> pixels(stride * static_cast<std::size_t>(size.height));
    const render::Image image{pixels, stride, size};
    render::Drawing drawing{&scene.reading.scene, motion, 0, {}, {}};
    drawing.display.wireframe = arguments.wireframe;
    drawing.display.background = colorOf(arguments.background).value_or(scene::Color{1, 1, 1});
    drawing.display.samples = 8;
    for (std::size_t i = 0; i < times.size(); ++i) {
        drawing.time = times[i];
        drawing.camera = view.at(times[i]);
        const std::string file = fileName(arguments.output, target.folder, i);
        if (!renderer.draw(drawing, image))
            return refuseFor(file + ": the graphics driver lost its state", failure);
        lettering::drawValues(lettering::valuesBeside(drawing, size, 1, sampled), 1,
                              render::isDark(drawing.display.background), image);
        if (std::string why; !writePicture(file, target.format, image, why))
            return refuseFor(file + ": " + why, failure);
    }
    return success;
}

} // namespace

int renderCommand(script::Reader& reader, const RenderArguments& arguments) {
    const auto target = targetOf(arguments.output);
    if (const auto* refusal = std::get_if<Refusal>(&target))
        return refuse(*refusal);
    const auto size = sizeOf(arguments.size);
    if (!size)
        return refuseFor("--size wants WIDTHxHEIGHT in pixels, not \"" + arguments.size + "\"",
                         wrongUsage);
    if (!colorOf(arguments.background))
        return refuseFor("--background wants #rrggbb or a colour's name, not \"" +
                             arguments.background + "\"",
                         wrongUsage);
    const auto read = readScene(reader, arguments.scene);
    if (const auto* refusal = std::get_if<Refusal>(&read))
        return refuse(*refusal);
    const auto& scene = std::get<SceneText>(read);
    if (const auto refusal = unusable(scene))
        return refuse(*refusal);
    if (!arguments.view.empty())
        if (const auto sentence = unknownView(scene.reading.scene, arguments.view))
            return refuseFor(*sentence, failure);
    const bool folder = std::get<Target>(target).folder;
    const scene::Simulator& simulator = scene.reading.scene.simulator;
    const auto times = timesOf(arguments, folder, simulator.start, simulator.finish);
    if (const auto* refusal = std::get_if<Refusal>(&times))
        return refuse(*refusal);
    const simulation::Result result = simulated(scene.reading.scene);
    if (!result.motion) {
        return refuse(refusalOf(scene, result.refusal));
    }
    (void)tell(scene, *result.motion); // what there is of it is drawn
    std::error_code error;
    if (folder && !std::filesystem::is_directory(arguments.output, error) &&
        !std::filesystem::create_directories(arguments.output, error))
        return refuseFor(arguments.output + ": " + error.message(), failure);
    return drawAll(scene, result.motion, arguments, std::get<Target>(target), *size,
                   std::get<std::vector<double>>(times));
}

} // namespace batch
