// Copies of elements as text: their commands, which can be put into the same scene, another one, or
// a letter.
//
// A copy takes along what its elements cannot be without (shape sets, trajectories), the forces on
// its bodies, and the joints, links and contacts between two of them.
#pragma once

#include "editing/element.h"
#include "text/edit.h"

#include <functional>
#include <set>
#include <string>
#include <vector>

namespace editing {

struct Copied {
    std::string commands; // one on each line, in the order of the text
    std::string reason;   // why there is none: one sentence
    [[nodiscard]] bool possible() const { return reason.empty(); }
};

[[nodiscard]] Copied copied(const std::string& text, const scene::Scene& scene,
                            const std::vector<Element>& elements);

// The names of the bodies that commands make.
[[nodiscard]] std::set<std::string> bodiesOf(const std::string& commands);

struct Pasted {
    text::Edits edits;
    std::vector<Element> added; // of the scene that will be read
    std::string reason;
    [[nodiscard]] bool possible() const { return reason.empty(); }
};

// A body that commands make, with a shape of the scene; null: the scene does not have it yet.
struct CopiedBody {
    const scene::ShapeSet* shape;
    geometry::Pose pose;
};
// Whether bodies would stand where others are.
using Meets = std::function<bool(const std::vector<CopiedBody>& bodies)>;

// Puts commands into a text. A shape set or trajectory that is there word for word is not put in
// again, nor a second weight of a body that has one: they would add up. A name that is taken gets a
// number, wherever the commands mention it. Where a body would stand exactly where another one
// does, or where `meets` says so, all of them are moved by `beside`, as often as it takes, and so
// are the points of the world and of other bodies that joints and springs hold them by. Where they
// meet others in each of the next places, the first place counts in which none stands exactly. What
// is the same and cannot be there twice (a simulator) is refused, as is all that is no command of a
// scene.
[[nodiscard]] Pasted pasted(const std::string& text, const scene::Scene& scene,
                            const std::string& commands, const geometry::Vector& beside,
                            const Meets& meets = nullptr);

} // namespace editing
