// The hand of a user in a picture: it holds a handle, or a new point of a trajectory, by a button
// of the pointer or by the keys. A document's picture and a graphical viewer have one each, so that
// both behave alike.
//
// While something is held `z` and `x` push it away and bring it nearer, `a` frees the end of a link
// from its body, the arrows move it, Escape gives the text back. The button that took it lets it
// go; others do nothing meanwhile.
#pragma once

#include "gestures/grasp.h"
#include "gestures/handle_drag.h"
#include "gestures/new_point.h"

#include <memory>

namespace gestures {

class Hand {
public:
    using Button = render::CameraControl::Button;
    enum class Key { away, nearer, free, left, right, up, down, escape };

    // The handle of the grasp, but to remove a point: see removalOf(). `scale`: device pixels
    // for each of the reader's.
    void take(Ground ground, const Sight& sight, const Grasp& grasp, Button button,
              const Eigen::Vector2d& pixels, double scale);
    // What is held then moves upright or level, and maybe along an axis: a body that is dragged.
    void setUpright(const std::optional<HandleDrag::Along>& along);
    void setTurns(int axis); // a body's attitude, about an axis of the world
    // Once more for the same: as the hand goes. False: nothing is held that moves so.
    bool keepAlong(const HandleDrag::Along& along);
    // `company`: bodies that go with a body.
    void takeByKeys(Ground ground, const Sight& sight, const render::Handle& handle,
                    const std::vector<std::size_t>& company = {});

    [[nodiscard]] bool active() const { return drag_ || newPoint_; }
    [[nodiscard]] bool byKeys() const { return drag_ && !button_; }
    [[nodiscard]] const HandleDrag* drag() const { return drag_.get(); }
    [[nodiscard]] const NewPoint* newPoint() const { return newPoint_.get(); }
    [[nodiscard]] std::optional<editing::Answer> answer() const;
    [[nodiscard]] std::string words() const; // "" when nothing is held

    // Of the pointer; the keys do not follow it. `holdsOff`: things nearby do not draw it to them.
    void move(const Eigen::Vector2d& pixels, bool holdsOff = false);
    bool goOn() { return drag_ && button_ && drag_->goOn(); } // while the pointer rests
    // `scale`: device pixels for each of the reader's. False: nothing is held by it.
    bool key(Key key, bool pressed, double scale);

    // The drag that was let go: its change is a step of undo, or there is none.
    struct LetGo {
        std::unique_ptr<HandleDrag> drag; // none: it was a new point
        std::string fault;                // why there is no change, though one was asked for
    };
    [[nodiscard]] std::optional<LetGo> release(Button button); // none: another button holds it
    std::optional<LetGo> finish();
    void cancel(); // the text is as it was
    // The text that it was taken on is gone: nothing more of it is taken. False: nothing was held.
    bool drop();
    static constexpr const char* overtaken =
        "The text was changed meanwhile, so the drag has ended.";

private:
    std::unique_ptr<HandleDrag> drag_;
    std::unique_ptr<NewPoint> newPoint_;
    std::optional<Button> button_; // none: the keys
};

// A point of a trajectory taken out. The last but one takes its trajectory along, and then what
// depends on that: `along`, which the user is asked about, where there are means to ask.
struct Removal {
    text::Edits edits;
    std::string label; // for undo
    bool isWhole = false;
    std::vector<editing::Element> along;
    std::string reason; // why it cannot be
    [[nodiscard]] bool possible() const { return reason.empty(); }
};
[[nodiscard]] Removal removalOf(const Ground& ground, const render::Handle& point);

} // namespace gestures
