// The values that stand in pictures beside what they are of: those of a scene's plots with
// `-beside 1`.
//
// A value stands at the first body, joint, spring, rope or contact that its expression names, in
// graphical viewers and in documents. Both say it in the same words at the same places, and paint
// it by themselves.
#pragma once

#include "charts/plots.h"
#include "editing/element.h"
#include "gestures/picking.h"
#include "render/renderer.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace meters {

struct Meter {
    std::size_t plot = 0, value = 0; // of the scene
    editing::Element of;
    std::string label; // that of the value; its expression where it has none
    bool operator==(const Meter&) const = default;
};

// LIMIT: the first 60 values, of the first 60 plots.
inline constexpr std::size_t most = 60;
[[nodiscard]] std::vector<Meter> metersOf(const scene::Scene& scene);

// The plots of a scene, which may be an older one, with their values.
struct Sampled {
    std::shared_ptr<const scene::Scene> scene = {};
    std::vector<charts::Plot> plots = {}; // the first of it
    // Of the values of this plot; null: they are not known yet.
    [[nodiscard]] const charts::Plot* of(const scene::Plot& plot) const;
};

// "Speed 1.25 m/s", to three digits; "Speed …" where `sampled` is null, and "Speed –" at a time at
// which there is no value.
[[nodiscard]] std::string wordsOf(const Meter& meter, const charts::Plot* sampled, double time);

// --- places, in points of the screen: one is `scale` of the picture's pixels

struct Place {
    Eigen::Vector2d at; // of its body or joint
    double reach = 10;  // how far that is seen to the right
    static constexpr double gap = 7;
    // The first place at its right, below the arrow of a selected one.
    [[nodiscard]] Eigen::Vector2d beside() const { return at + Eigen::Vector2d(reach + gap, gap); }
};
// None: it is gone, or hidden.
[[nodiscard]] std::optional<Place> placeOf(const render::Drawing& drawing,
                                           const gestures::Sight& sight,
                                           const editing::Element& element, double scale);

struct Wish {
    editing::Element of;
    Place place;
    Eigen::Vector2d size;
    Eigen::Vector2d aside = Eigen::Vector2d::Zero(); // from its first place; 0: not moved
};
struct Box {
    Eigen::Vector2d beside; // the first place of its thing
    Eigen::AlignedBox2d rect;
};
// Those of one thing stand below each other, at its right where they cover no others, else about it
// (handles/handle_layout.h); all of each is in the picture where its thing is.
[[nodiscard]] std::vector<Box> boxesFor(const std::vector<Wish>& wishes,
                                        const Eigen::Vector2d& picture);

// All of the rectangle, as far as it fits, is in the picture.
[[nodiscard]] Eigen::AlignedBox2d inside(const Eigen::AlignedBox2d& rect,
                                         const Eigen::Vector2d& picture);

} // namespace meters
