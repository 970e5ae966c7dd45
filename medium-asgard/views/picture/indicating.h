// The meaning of a place to the step of a recipe: of one in the picture that is pointed at, of one
// of a body, or of one whose numbers are typed.
//
// A point lies where the step before left off, or as deep as all bodies that stand in one plane. It
// is drawn to things and round numbers nearby (gestures/snapping.h); a new body rests on what is
// seen there, a body below it or the grid. The place that holds a body lies in the plane of the
// screen through what was shown of it.
#pragma once

#include "gestures/snapping.h"
#include "recipes/begun_recipe.h"
#include "surroundings/grid.h"
#include "workbench/scene_document.h"

#include <QPointF>
#include <QString>

#include <optional>
#include <variant>

namespace views {

class SceneDisplay;

class Indicating {
public:
    static constexpr double clickReach = 12; // pixels
    static constexpr double edgeReach = 8;   // pixels beside what is seen of a body

    // Both outlive it.
    Indicating(const SceneDocument& document, const SceneDisplay& display)
        : document_(document), display_(display) {}

    // Under the pointer; else why there is nothing that the step asks for. What is to be made may
    // get another size. `holdsOff`: things nearby do not draw it to them.
    [[nodiscard]] std::variant<Indicated, QString> at(BegunRecipe& begun, const QPointF& position,
                                                      bool holdsOff);
    // A body that is shown by a place of its surface (in the world); its centre where that is near.
    [[nodiscard]] Indicated onSurface(const Step& step, std::size_t body,
                                      const Vector& surface) const;
    [[nodiscard]] Indicated centerOf(std::size_t body) const;
    // "1 2.5": numbers that are not typed are 0. None: it is no place.
    [[nodiscard]] std::optional<Indicated> typed(BegunRecipe& begun, const QString& numbers) const;
    // The origin, which Return takes; a new body that would lie in the grid there stands on it.
    [[nodiscard]] Indicated atOrigin(BegunRecipe& begun);
    void forget() { near_.reset(); } // until it is asked again

private:
    [[nodiscard]] Indicated pointAt(BegunRecipe& begun, const Eigen::Vector2d& pixels,
                                    bool holdsOff);
    [[nodiscard]] Vector depth(const std::vector<Indicated>& shown) const;
    [[nodiscard]] std::optional<Indicated> onGrid(BegunRecipe& begun, const Eigen::Vector2d& pixels,
                                                  Indicated found);
    [[nodiscard]] Indicated standingOn(const BegunRecipe& begun, const render::GroundPlane& ground,
                                       Indicated found);
    [[nodiscard]] Eigen::Index raise(const BegunRecipe& begun, const gestures::Picked& picked,
                                     Vector& up, Indicated& found) const;
    [[nodiscard]] Indicated restingOn(BegunRecipe& begun, const gestures::Picked& body,
                                      Indicated found);
    [[nodiscard]] Indicated onBody(const Step& step, std::size_t body, const Vector& point) const;
    [[nodiscard]] Vector onAxes(std::size_t body, const Vector& onBody, double near) const;
    [[nodiscard]] Indicated held(const BegunRecipe& begun, Eigen::Vector2d pixels, bool holdsOff);
    void drawn(Indicated& found, std::size_t alongside);
    void holdFirst(Indicated& found, const Indicated& first) const; // the place that was typed
    [[nodiscard]] bool isNear(const Vector& point, const Eigen::Vector2d& pixels) const;
    [[nodiscard]] geometry::Pose poseOf(std::size_t body) const;
    [[nodiscard]] Vector towardsViewer() const;
    [[nodiscard]] const gestures::Snapping& snapping();

    const SceneDocument& document_;
    const SceneDisplay& display_;
    struct Near { // what stands in the picture, as long as that stays as it is
        Shown of;
        double time;
        gestures::Sight sight;
        gestures::Snapping snapping;
    };
    std::optional<Near> near_;
};

} // namespace views
