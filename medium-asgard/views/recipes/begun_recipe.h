// A recipe on its way: the step that is asked for, what was shown for those before it, and the size
// of the new thing, which fits the view until its place is shown.
#pragma once

#include "editing/element.h"
#include "gestures/picking.h"
#include "recipes/recipe.h"

#include <optional>
#include <vector>

namespace views {

class BegunRecipe {
public:
    explicit BegunRecipe(Recipe recipe);

    [[nodiscard]] const Recipe& recipe() const { return recipe_; }
    [[nodiscard]] const std::vector<Indicated>& shown() const { return shown_; }
    // One that has none makes something without a click.
    [[nodiscard]] bool hasSteps() const { return !recipe_.steps.empty(); }
    [[nodiscard]] const Step& step() const; // that is asked for
    // Null: the new thing is none that can rest on a body.
    [[nodiscard]] const gestures::ShapePointer& ghost() const { return ghost_; }

    // A first step that asks for a body takes the one that is selected by Return, or the only one.
    void offerBody(const scene::Scene& scene, const std::vector<editing::Element>& selected);
    // A new body that is to stand there is as large as one sees well there.
    void fit(const gestures::Sight& sight, const Vector& place);
    // The words beside the pointer; none: nothing in particular.
    [[nodiscard]] std::optional<Judged> judge(const scene::Scene& scene,
                                              const Indicated& next) const;
    // True: that was the last step.
    [[nodiscard]] bool take(const Indicated& indicated);

private:
    Recipe recipe_;
    std::vector<Indicated> shown_;
    double times_ = 1; // as large as usual, of a new body
    gestures::ShapePointer ghost_;
};

} // namespace views
