// Handles in the document's own picture (dissertation 6.2.4), dragged as in a graphical viewer and
// by the same code (gestures/).
//
// A shifted button takes hold of what is under the pointer: a handle that is shown, or a body
// (gestures/hand.h). The picture shows what is held where the pointer has it, however long the
// motion takes.
#pragma once

#include "gestures/hand.h"

#include <memory>
#include <string>

namespace service {

class HandleEditing {
public:
    // False: nothing is there to take hold of. `scale`: device pixels for each of the reader's.
    bool press(gestures::Ground ground, const render::Drawing& drawing, render::Size size,
               double scale, render::CameraControl::Button button, const Eigen::Vector2d& pixels);
    // `holdsOff`: things nearby do not draw it to them.
    void move(const Eigen::Vector2d& pixels, bool holdsOff = false);
    void release(render::CameraControl::Button button); // the change becomes one of the document
    bool key(const std::string& name, bool pressed);    // false: not theirs
    void finish();
    void cancel(); // the text is as it was
    // The text that a drag was made on is gone: nothing more of the drag is taken, which is said.
    void drop();

    [[nodiscard]] bool active() const { return hand_.active(); }
    // The words of a drag about itself, now or last: "b1: position -4.37 0 2", or why it cannot be.
    [[nodiscard]] const std::string& words() const { return words_; }
    // Grows whenever pictures of the same scene may differ.
    [[nodiscard]] unsigned generation() const { return generation_; }

    // The handles that a picture shows; none: its display has none.
    [[nodiscard]] std::shared_ptr<const render::HandleSet>
    handles(const std::shared_ptr<const scene::Scene>& scene, const render::Drawing& drawing,
            render::Size size);

private:
    void remove(const gestures::Ground& ground, const render::Handle& handle);
    void say(std::string words);

    void sayLetGo(const std::optional<gestures::Hand::LetGo>& gone);

    gestures::Hand hand_;
    double scale_ = 1;
    std::string words_;
    unsigned generation_ = 0;
    struct Prepared { // of one scene and motion, for all pictures
        std::shared_ptr<const scene::Scene> scene;
        simulation::MotionPointer motion;
        render::Handles handles;
    };
    std::unique_ptr<Prepared> prepared_;
};

} // namespace service
