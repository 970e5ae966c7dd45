// Handles in the document's own picture (dissertation 6.2.4), dragged as in a graphical viewer and
// by the same code (gestures/).
//
// A shifted button takes hold of what is under the pointer: a handle that is shown, or a body
// (gestures/hand.h). The picture shows what is held where the pointer has it, however long the
// motion takes. While the motion plays a body is taken out of its way and thrown
// (gestures/throw.h); then the picture shows the scene that begins with the body in the hand.
#pragma once

#include "gestures/hand.h"
#include "gestures/throw.h"

#include <memory>
#include <string>
#include <utility>

namespace service {

class HandleEditing {
public:
    struct Pointer {
        Eigen::Vector2d pixels;
        double seconds = 0;    // of its clock
        bool holdsOff = false; // things nearby do not draw what it holds to them
    };
    struct Picture { // under the pointer
        render::Drawing drawing;
        render::Size size;
        double scale = 1;                // device pixels for each of the reader's
        std::optional<double> rate = {}; // while it plays: seconds of its time for each
    };
    // False: nothing is there to take hold of.
    bool press(gestures::Ground ground, const Picture& picture,
               render::CameraControl::Button button, const Pointer& pointer);
    // Of a body, wherever something is before it: by a drag of the left button.
    bool pressBody(gestures::Ground ground, const Picture& picture, std::size_t body,
                   const Pointer& pointer);
    void tell(std::string words) { say(std::move(words)); } // of what was done without a drag
    void move(const Pointer& pointer);
    // The change becomes one of the document.
    void release(render::CameraControl::Button button, const Pointer& pointer);
    bool key(const std::string& name, bool pressed); // false: not theirs
    void finish();
    void cancel(); // the text is as it was
    // The text that a drag was made on is gone: nothing more of the drag is taken, which is said.
    void drop();

    [[nodiscard]] bool active() const { return hand_.active() || thrown_; }
    // The moment that is to stand still while a body is held; none: it may go on.
    [[nodiscard]] std::optional<double> moment() const {
        return thrown_ ? std::optional(thrown_->body.moment()) : std::nullopt;
    }
    // The words of a drag about itself, now or last: "b1: position -4.37 0 2", or why it cannot be.
    [[nodiscard]] const std::string& words() const { return words_; }
    // In place of the drag that could not be: what can be done instead, once.
    struct Refused {
        std::string label; // of the step of undo
        std::vector<editing::Offer> ways;
    };
    [[nodiscard]] std::optional<Refused> takeRefused() { return std::exchange(refused_, {}); }
    // Grows whenever pictures of the same scene may differ.
    [[nodiscard]] unsigned generation() const { return generation_; }

    // The handles that a picture shows; none: its display has none.
    [[nodiscard]] std::shared_ptr<const render::HandleSet>
    handles(const std::shared_ptr<const scene::Scene>& scene, const render::Drawing& drawing,
            render::Size size);

private:
    void remove(const gestures::Ground& ground, const render::Handle& handle);
    // False: a drag does not mean that there.
    bool take(const gestures::Ground& ground, const Picture& picture, const gestures::Sight& sight,
              std::size_t body, const Pointer& pointer);
    void letFly(double seconds);
    void say(std::string words);

    void sayLetGo(const std::optional<gestures::Hand::LetGo>& gone);

    gestures::Hand hand_;
    struct Thrown {
        gestures::Throw body;
        gestures::Sight sight;
        double rate;
    };
    std::optional<Thrown> thrown_;
    double scale_ = 1;
    std::string words_;
    std::optional<Refused> refused_;
    unsigned generation_ = 0;
    struct Prepared { // of one scene and motion, for all pictures
        std::shared_ptr<const scene::Scene> scene;
        simulation::MotionPointer motion;
        render::Handles handles;
    };
    std::unique_ptr<Prepared> prepared_;
};

} // namespace service
