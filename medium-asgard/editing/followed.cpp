#include "editing/followed.h"

#include "text/difference.h"

#include <algorithm>
#include <array>

namespace editing {

namespace {

// Whether an element is at its place still: by its name, or by its command, which an edit moved at
// most. Quick for the usual case, where nothing comes or goes.
class Stays {
public:
    Stays(const scene::Scene& before, const scene::Scene& after, const text::Edit& edit)
        : before_(before), after_(after), edit_(edit) {}

    // Something came or went: then a command may stand where another one stood.
    [[nodiscard]] bool sameCounts() const {
        const auto counts = [](const scene::Scene& s) {
            return std::array{s.shapeSets.size(),   s.bodies.size(),   s.forces.size(),
                              s.links.size(),       s.joints.size(),   s.gears.size(),
                              s.ropes.size(),       s.contacts.size(), s.trajectories.size(),
                              s.constraints.size(), s.lights.size(),   s.views.size(),
                              s.parameters.size(),  s.plots.size()};
        };
        return counts(before_) == counts(after_);
    }
    bool operator()(const Element& element) const {
        const scene::Source* old = sourceOf(before_, element);
        const scene::Source* now = sourceOf(after_, element);
        if (!old || !now || old->runs != now->runs)
            return false;
        const std::string name = nameOf(before_, element);
        if (name != nameOf(after_, element))
            return false;
        if (!name.empty())
            return true;
        const scene::Range command = old->command;
        if (old->runs != 1 || !command.known())
            return false;
        if (command.to <= edit_.range.from ||
            (command.from < edit_.range.from && edit_.range.to <= command.to))
            return now->command.from == command.from;
        return command.from >= edit_.range.to &&
               now->command.from == command.from - edit_.range.size() + edit_.text.size();
    }

private:
    const scene::Scene &before_, &after_;
    const text::Edit& edit_;
};

} // namespace

std::vector<Element> followed(const std::vector<Element>& elements, const Reading& before,
                              const Reading& after, const std::vector<Renamed>& renamed) {
    const text::Edit edit = text::difference(before.text, after.text);
    const Stays stays(before.scene, after.scene, edit);
    if (stays.sameCounts() && std::ranges::all_of(elements, stays))
        return elements;
    const Changes changes = changesBetween(before, after);
    std::vector<Element> now;
    for (const Element& element : elements)
        if (const auto is = changes.now(element))
            now.push_back(*is);
        else if (std::ranges::find(renamed, element, &Renamed::element) != renamed.end())
            now.push_back(element);
    return now;
}

} // namespace editing
