#include "batch/command.h"
#include "batch/input.h"
#include "simulation/doubts.h"
#include "simulation/simulation.h"

#include <cstdio>

namespace batch {
namespace {

// What only the engine can tell: the scene is given to it, and taken back before it computes.
std::vector<std::string> faultsOfTheEngine(const scene::Scene& scene) {
    simulation::Observer atOnce;
    atOnce.cancelled = [] { return true; };
    return simulation::simulate(scene, {}, atOnce).refusal;
}

} // namespace

int checkCommand(script::Reader& reader, const CheckArguments& arguments) {
    const auto read = readScene(reader, arguments.scene);
    if (const auto* refusal = std::get_if<Refusal>(&read)) {
        std::fprintf(stderr, "asgard: %s\n", refusal->message.c_str());
        return refusal->exitCode;
    }
    const auto& scene = std::get<SceneText>(read);
    std::fputs(printed(scene).c_str(), stdout);
    if (!scene.reading.usable)
        return failure;
    for (const scene::Diagnostic& doubt : simulation::doubtsAbout(scene.reading.scene))
        std::fputs(printed(scene, doubt).c_str(), stdout);
    const auto faults = faultsOfTheEngine(scene.reading.scene);
    std::fputs(refusalOf(scene, faults).message.c_str(), stdout);
    return faults.empty() ? success : failure;
}

} // namespace batch
