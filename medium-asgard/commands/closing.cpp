#include "commands/closing.h"

#include "element_edits/closing.h"
#include "physics/assembly.h"
#include "placing/placing.h"

namespace commands {

Misplaced misplacedIn(const std::vector<scene::Diagnostic>& faults) {
    Misplaced found;
    for (const scene::Diagnostic& fault : faults) {
        found.openJoints += physics::asksToClose(fault.message) ? 1 : 0;
        found.overlaps += physics::asksToPart(fault.message) ? 1 : 0;
    }
    return found;
}

std::string offerOf(const Misplaced& misplaced) {
    return misplaced.openJoints > 1    ? "Close Them"
           : misplaced.openJoints == 1 ? "Close It"
                                       : "Move Apart";
}

std::string labelOf(const Misplaced& misplaced) {
    return misplaced.openJoints > 0 ? "Close Joints" : "Move Bodies Apart";
}

Closed closed(const std::string& text, const std::shared_ptr<const scene::Scene>& scene,
              const std::function<bool()>& cancelled) {
    const physics::Assembly assembly = simulation::placed(*scene, cancelled);
    if (assembly.cancelled)
        return {};
    if (!assembly.reason.empty())
        return {{}, assembly.reason};
    std::vector<editing::NewPlace> places;
    for (const physics::Assembly::Moved& moved : assembly.moved)
        places.push_back({moved.body, moved.pose, moved.turns});
    const editing::Closing closing =
        editing::closingEdits(editing::Mapper(text, scene), *scene, places);
    return {text::applied(text, closing.edits), closing.reason};
}

} // namespace commands
