// A gesture on the parts of a shape: the text follows it, and it is one step of undo
// (dissertation 4.1.1).
#pragma once

#include "point_edits/shape_edit.h"
#include "workbench/scene_document.h"

namespace views {

class ShapeGesture {
public:
    // On a shape set of the scene that is shown, which must be the text's.
    ShapeGesture(SceneDocument& document, std::size_t shapeSet);

    [[nodiscard]] const std::vector<editing::DraftPart>& before() const { return before_; }
    [[nodiscard]] const std::string& text() const { return text_; } // when it began
    // Shows the parts as they are to be. False: the text cannot be changed so, see answer().
    bool show(const std::vector<editing::DraftPart>& draft);
    // The draft that was shown last stays, when the text could become it.
    void finish(const QString& label);
    void cancel(); // the text is as it was
    [[nodiscard]] const editing::Answer& answer() const { return answer_; }
    [[nodiscard]] Asked asked() const { return {since_, answer_}; }

private:
    SceneDocument& document_;
    std::string text_; // when it began
    int since_;        // its revision
    std::shared_ptr<const scene::Scene> scene_;
    std::size_t shapeSet_;
    std::vector<editing::DraftPart> before_;
    editing::Answer answer_;
};

// A place or a size to the decimals that the pointer can tell apart, `length` of them; free of the
// digits that rounding leaves. 0: exactly.
[[nodiscard]] double decimal(double value, double length);
[[nodiscard]] geometry::Vector decimal(const geometry::Vector& value, double length);
// The part with the values that a gesture changed, so rounded; the rest stays bit for bit.
[[nodiscard]] scene::Part tidied(const scene::Part& before, scene::Part after, double length);

} // namespace views
