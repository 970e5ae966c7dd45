// Finds the change of the text that gives a value to an element.
//
// A gesture in a picture is a change of the text (dissertation 4.2.2): the numbers that it moves
// are rewritten where they stand, and no other byte. A number can be rewritten when its bytes are
// the value's own; when it comes through one variable or a parameter, there; in an expression like
// "-10 * b1.mass", when it is the factor. A value that a loop, a procedure or another expression
// makes is never replaced unasked: the answer names its maker and the place, and makes offers.
//
// Reference: dissertation 4.2.2; docs/scene-language.md.
#pragma once

#include "editing/element.h"
#include "text/edit.h"

#include "scene/scene.h"
#include "script/structure.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace editing {

// New numbers for one option of an element.
struct Wish {
    Element element;
    std::string option;            // "-init_pos"; "-points" with a path for one point
    std::vector<std::size_t> path; // into nested lists: which element of the list, then of that
    std::vector<double> values;
    double resolution = 0; // differences below half of it are none; 0: exact
    // The values where the option does not stand; a wish for just these changes nothing then.
    std::vector<double> absent = {};
    // The values as they are, where they are known: values that are not to change may be computed,
    // and a number that the text gives otherwise is not the one that is meant.
    std::vector<double> now = {};
    bool offers = true; // alternatives are worked out, too, which may take long
};

// A change that is possible, but only if the author wants it.
struct Offer {
    std::string label; // "Only b3: ...", "All 4: ..."
    text::Edits edits;
};

struct Answer {
    text::Edits edits;  // empty with an empty reason: nothing changes
    std::string reason; // why the text cannot be changed so: one sentence
    scene::Range cause; // what is meant by it, where it has a place
    std::vector<Offer> offers;
    std::vector<scene::Range> kept; // numbers of the wish that are to stay as they stand
    [[nodiscard]] bool possible() const { return reason.empty(); }
};

// Answers for one text and the scene that was read from it.
class Mapper {
public:
    // `factor` gives the value of a name in an expression that does not change ("b1.mass");
    // nothing: not known. Both are kept.
    using Factor = std::function<std::optional<double>(const std::string& name)>;
    Mapper(std::string text, std::shared_ptr<const scene::Scene> scene, Factor factor = {});

    [[nodiscard]] Answer answer(const Wish& wish) const;
    // Several at once, of one element (-x -y -z): all of them, or none.
    [[nodiscard]] Answer answer(const std::vector<Wish>& wishes) const;
    // How many numbers the option has in the text, where it is a list written out; 0: none, or
    // computed.
    [[nodiscard]] std::size_t count(const Wish& wish) const;
    // The text that stands for each number of the wish ("$h", "-10 * b1.mass"); "" where the option
    // does not stand.
    [[nodiscard]] std::vector<std::string> written(const Wish& wish) const;
    [[nodiscard]] const scene::Source* sourceOf(const Element& element) const;
    [[nodiscard]] const scene::Scene& scene() const { return *scene_; }
    [[nodiscard]] std::string
    nameOf(const Element& element) const; // "body \"b1\"", "the force of line 7"

private:
    std::string text_;
    std::shared_ptr<const scene::Scene> scene_;
    Factor factor_;
    script::Structure structure_;
};

} // namespace editing
