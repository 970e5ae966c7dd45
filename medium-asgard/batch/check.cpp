#include "batch/command.h"
#include "batch/input.h"
#include "placing/placing.h"
#include "reports/doubts.h"
#include "reports/report.h"
#include "simulation/simulation.h"
#include "terminal/terminal.h"

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
    if (const auto* refusal = std::get_if<Refusal>(&read))
        return refuse(*refusal);
    const auto& scene = std::get<SceneText>(read);
    for (const std::string& fault : faultsOf(scene))
        terminal::say(fault);
    if (!scene.reading.usable)
        return failure;
    for (const scene::Diagnostic& doubt : simulation::doubtsAbout(scene.reading.scene))
        terminal::say(placed(scene, doubt));
    for (const std::string& sentence : simulation::startSentences(scene.reading.scene)) {
        scene::Diagnostic said = simulation::faultOf(scene.reading.scene, sentence);
        said.severity = scene::Severity::warning;
        terminal::say(placed(scene, said));
    }
    const Refusal refusal = refusalOf(scene, faultsOfTheEngine(scene.reading.scene));
    for (const std::string& fault : refusal.faults)
        terminal::say(fault);
    return refusal.faults.empty() ? success : failure;
}

} // namespace batch
