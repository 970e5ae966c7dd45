// One handle that the pointer drags: the text follows, and with it everything else (dissertation
// 4.1.3, 4.2.2).
//
// The handle moves in the plane of the screen; push() moves it along the line of sight. Each place
// is a wish that editing/ answers with a change of the text as it was when the drag began, so that
// a drag is one step of undo however long it was. What cannot be changed says why.
#pragma once

#include "editing/value_edit.h"
#include "render/handles.h"
#include "views/scene_document.h"

#include <memory>
#include <optional>

namespace views {

class HandleDrag {
public:
    // The handle nearest to the pixels, within `reach` of them; none: there is none, or the text
    // is not the one that the picture shows.
    [[nodiscard]] static std::unique_ptr<HandleDrag>
    at(SceneDocument& document, const render::Drawing& drawing, render::Size size,
       const Eigen::Vector2d& pixels, double reach);

    void move(const Eigen::Vector2d& pixels);
    void push(double pixels); // away from the viewer, as far as so many pixels across
    void finish();            // the change becomes a step of undo
    void cancel();            // the text is as it was

    [[nodiscard]] geometry::Vector place() const;
    [[nodiscard]] const editing::Answer& answer() const { return answer_; }
    // "b1: position -4.37 0 2", or why it stays where it is.
    [[nodiscard]] QString words() const;
    // What an offer of the answer would make of the text.
    [[nodiscard]] std::string textWith(const editing::Offer& offer) const;
    [[nodiscard]] QString label() const; // "Move b1"

private:
    HandleDrag(SceneDocument& document, const render::Drawing& drawing, render::Size size,
               const render::Handle& handle, double sceneSize);
    [[nodiscard]] editing::Wish wish() const;
    void update();

    SceneDocument& document_;
    std::string text_; // when the drag began
    std::shared_ptr<const scene::Scene> scene_;
    editing::Mapper mapper_;
    render::Camera camera_;
    render::Size size_;
    render::Handle handle_;
    double velocityTime_;
    double pixelLength_; // of the world, at the handle
    Eigen::Vector2d grip_ = Eigen::Vector2d::Zero();
    double depth_ = 0; // view units
    std::optional<Eigen::Vector2d> pointer_;
    editing::Answer answer_;
};

} // namespace views
