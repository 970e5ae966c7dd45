// The thing that a reader has selected in the document's pictures, and what can be done with it: as
// in a graphical viewer, by the same code (gestures/things.h, editing/).
#pragma once

#include "gestures/ground.h"
#include "gestures/things.h"
#include "render/renderer.h"
#include "service/thing_commands.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace service {

class Selection {
public:
    // A click: what lies there, or behind what is selected; beside everything nothing is.
    void click(const render::Drawing& drawing, const render::HandleSet& handles,
               const gestures::Sight& sight, const Eigen::Vector2d& pixels, double scale);
    // The right button's: as it is, where that lies there.
    void point(const render::Drawing& drawing, const render::HandleSet& handles,
               const gestures::Sight& sight, const Eigen::Vector2d& pixels, double scale);
    void clear() { select({}); }
    // The scene that is shown, and its text; what is selected is followed from the one before.
    void follow(const std::shared_ptr<const scene::Scene>& scene, const std::string& text);

    [[nodiscard]] const std::vector<editing::Element>& elements() const { return elements_; }
    [[nodiscard]] bool empty() const { return elements_.empty(); }
    [[nodiscard]] std::string name() const; // body "b1"; "" of nothing
    // What can be done with it, as the scene is now; null: nothing is selected.
    [[nodiscard]] const std::shared_ptr<const std::vector<ThingCommand>>&
    commands(const simulation::MotionPointer& motion);
    // Grows whenever pictures of the same scene may differ.
    [[nodiscard]] unsigned generation() const { return generation_; }

    // A sentence for the reader; "": it is done, or nothing is to be said.
    // With what cannot be without it after it was asked for twice: nobody can be asked here.
    [[nodiscard]] std::string remove(const gestures::Ground& ground);
    [[nodiscard]] std::string duplicate(const gestures::Ground& ground);

    // The frames around selected bodies, in pixels.
    [[nodiscard]] std::vector<Eigen::AlignedBox2d>
    frames(const render::Drawing& drawing, const gestures::Sight& sight, double scale) const;

private:
    void select(std::vector<editing::Element> elements);

    std::shared_ptr<const scene::Scene> scene_;
    std::string text_; // of it
    std::vector<editing::Element> elements_;
    // Of a text that is not read yet, made from `text_`: they are selected then.
    std::vector<editing::Element> expected_;
    std::optional<Eigen::Vector2d> clicked_;                    // where the last click was
    bool isAsked_ = false;                                      // whether all of it is to go
    std::shared_ptr<const std::vector<ThingCommand>> commands_; // null: to be found out
    unsigned generation_ = 0;
};

// Dashed, into a picture that is drawn.
void drawFrames(const std::vector<Eigen::AlignedBox2d>& frames, double scale, bool isDark,
                const render::Image& into);

} // namespace service
