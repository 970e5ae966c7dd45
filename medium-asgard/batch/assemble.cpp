#include "batch/command.h"
#include "batch/input.h"
#include "batch/output.h"
#include "element_edits/closing.h"
#include "files/save.h"
#include "placing/placing.h"
#include "terminal/terminal.h"

#include <algorithm>
#include <cstdio>

namespace batch {
namespace {

Refusal refusalAt(const SceneText& scene, const std::string& sentence, scene::Range range) {
    scene::Diagnostic said;
    said.message = sentence;
    if (range.known()) {
        said.range = range;
        const auto before = std::string_view(scene.text).substr(0, range.from);
        said.line = said.endLine = 1 + static_cast<int>(std::ranges::count(before, '\n'));
        said.column = said.endColumn = static_cast<int>(range.from - (before.rfind('\n') + 1)) + 1;
        return {failure, "", {placed(scene, said)}};
    }
    return {failure, sentence};
}

// Into the scene's own file, or another one.
bool writeText(const AssembleArguments& arguments, const std::string& text) {
    const bool isItself = !arguments.output && arguments.scene != "-";
    if (!isItself) {
        Output output(arguments.output.value_or("-"));
        return output.good() && output.finish(output.write(text));
    }
    files::KnownFile known;
    const files::SaveResult saved = files::saveFile(files::FileSystem::real(), arguments.scene,
                                                    text, known, {.evenChanged = true});
    if (!saved)
        terminal::complain("asgard: " + saved.sentence);
    return saved.saved;
}

std::string toldOf(const scene::Scene& scene, const physics::Assembly::Moved& moved) {
    char by[40];
    std::snprintf(by, sizeof by, "%.4g", moved.by);
    return "asgard: body \"" + scene.bodies[moved.body].name + "\" " +
           (moved.turns ? "moves and turns" : "moves") + " by " + by;
}

} // namespace

int assembleCommand(script::Reader& reader, const AssembleArguments& arguments) {
    const auto read = readScene(reader, arguments.scene);
    if (const auto* refusal = std::get_if<Refusal>(&read))
        return refuse(*refusal);
    const auto& scene = std::get<SceneText>(read);
    if (const auto refusal = unusable(scene))
        return refuse(*refusal);
    const scene::Scene& of = scene.reading.scene;
    const physics::Assembly assembly = simulation::placed(of);
    if (!assembly.reason.empty())
        return refuse({failure, assembly.reason});
    std::vector<editing::NewPlace> places;
    for (const physics::Assembly::Moved& moved : assembly.moved)
        places.push_back({moved.body, moved.pose, moved.turns});
    const editing::Mapper mapper(scene.text, std::make_shared<const scene::Scene>(of));
    const editing::Closing closing = editing::closingEdits(mapper, of, places);
    if (!closing.reason.empty())
        return refuse(refusalAt(scene, closing.reason, closing.cause));
    for (const physics::Assembly::Moved& moved : assembly.moved)
        terminal::complain(toldOf(of, moved));
    if (closing.edits.empty() && !arguments.output && arguments.scene != "-") {
        terminal::complain(
            "asgard: all joints are closed and no bodies overlap: the text stays as it is");
        return success;
    }
    return writeText(arguments, text::applied(scene.text, closing.edits)) ? success : failure;
}

} // namespace batch
