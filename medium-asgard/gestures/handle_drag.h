// One handle that the pointer or the keys drag: the text follows, and with it everything else
// (dissertation 4.1.3, 4.2.2).
//
// The handle moves in the plane of the screen; push() moves it along the line of sight. An
// orientation's moves on a sphere about its body, the end of a link on the body's surface
// (Figure 4.5) until it is freed. Each place is a wish that editing/ answers with a change of the
// text as it was when the drag began, so that a drag is one step of undo however long it was. A
// handle without a possible change says why.
//
// A body that joints hold goes as they let it (joined.h), and turns by whole degrees as about an
// axis of the world, where one joint holds it to what stands. By the keys it turns by tenths. Along
// an axis it takes all with it that is joined to it. About an axis it turns as far as joints let
// it, and takes with it what must follow. Several bodies that are dragged together go by one way
// (company.h).
#pragma once

#include "editing/value_edit.h"
#include "gestures/company.h"
#include "gestures/ground.h"
#include "gestures/joined.h"
#include "gestures/snapping.h"
#include "point_edits/trajectory_edit.h"

#include <optional>
#include <string>

namespace gestures {

class HandleDrag {
public:
    // `pixels`: where it is held; none: by the keys, at its middle.
    HandleDrag(Ground ground, const Sight& sight, const render::Handle& handle,
               const std::optional<Eigen::Vector2d>& pixels);
    HandleDrag(const HandleDrag&) = delete; // its mapper asks it for factors
    HandleDrag& operator=(const HandleDrag&) = delete;

    void move(const Eigen::Vector2d& pixels);
    // Joined bodies for which a move did not suffice come nearer to the hand, which rests. False:
    // they have arrived.
    bool goOn();
    void nudge(const Eigen::Vector2d& byPixels);
    void push(double pixels); // away from the viewer, as far as so many pixels across
    void setFree(bool free);  // does not follow the surface
    // Of a body that is dragged: these go with it. Before setSnaps().
    void setCompany(const std::vector<std::size_t>& others);
    // A place is drawn to things and round numbers nearby (snapping.h), unless that is held off.
    // `scale`: device pixels for each of the reader's.
    void setSnaps(double scale);
    void holdSnapsOff(bool off) { snaps_.areHeldOff = off; }
    // A place moves along one axis of the world, or in the plane across it; none: as the hand goes.
    struct Along {
        int axis = 0;
        bool isPlane = false;
        bool operator==(const Along&) const = default;
    };
    void setAlong(const std::optional<Along>& along);
    [[nodiscard]] const std::optional<Along>& along() const { return along_; }
    void setUpright() { isUpright_ = true; } // in the upright or level plane that faces the viewer
    [[nodiscard]] bool isUpright() const { return isUpright_; }
    void setRolls(); // an attitude, about the line of sight, as far as one goes sideways
    // An attitude turns about an axis of the world, by the angle that the hand goes round it: whole
    // degrees, drawn to each 15, unless snapping is held off.
    void setTurns(int axis);
    [[nodiscard]] std::optional<int> turnsAbout() const {
        return turning_ ? std::optional(turning_->axis) : std::nullopt;
    }
    [[nodiscard]] double turned() const; // degrees
    void finish();                       // the change becomes a step of undo
    void cancel();                       // the text is as it was

    [[nodiscard]] const render::Handle& handle() const { return handle_; }
    [[nodiscard]] const geometry::Vector& place() const { return place_; }
    [[nodiscard]] const editing::Answer& answer() const { return answer_; }
    // "b1: position -4.37 0 2", or why it stays where it is.
    [[nodiscard]] std::string words() const;
    // When the drag began.
    [[nodiscard]] const std::string& text() const { return ground_.text; }
    [[nodiscard]] const Ground& ground() const { return ground_; }
    [[nodiscard]] std::string label() const; // "Move b1"
    [[nodiscard]] bool moved() const { return moved_; }
    [[nodiscard]] std::vector<editing::Wish> wishes() const; // of where it is

private:
    [[nodiscard]] std::vector<editing::Wish> turnWishes(double exact) const;
    [[nodiscard]] geometry::Vector under(const Eigen::Vector2d& pixels) const;
    void findJoined();
    void moveJoined();
    void turnJoined();
    void roundPlace();
    [[nodiscard]] bool swings() const { return joined_ && !joined_->movesAsOne() && !along_; }
    [[nodiscard]] std::string joinedWords() const;
    [[nodiscard]] std::string whyNotJoined() const;
    [[nodiscard]] double joinedDegrees() const;
    [[nodiscard]] double rounded(double degrees) const;
    [[nodiscard]] geometry::Vector wanted();
    [[nodiscard]] geometry::Vector snapped(const geometry::Vector& place);
    [[nodiscard]] geometry::Vector unsnapped() const;
    [[nodiscard]] geometry::Vector kept(const geometry::Vector& place) const; // on what it is along
    [[nodiscard]] bool isPlace() const; // of a thing, which others may meet
    [[nodiscard]] double resolution() const;
    [[nodiscard]] geometry::Vector onSphere() const;
    [[nodiscard]] geometry::Vector rolled() const;
    [[nodiscard]] std::optional<geometry::Vector> onSurface() const;
    [[nodiscard]] double angleOfHand() const;
    [[nodiscard]] editing::Answer asked(bool offers) const;
    [[nodiscard]] bool isOnSurface(const geometry::Vector& place) const;
    void update();

    Ground ground_;
    editing::Mapper mapper_;
    Sight sight_;
    render::Handle handle_;
    double pixelLength_;             // of the world, at the handle
    std::unique_ptr<Joined> joined_; // with the body that is dragged
    std::optional<Company> company_; // with others
    geometry::Vector place_, plane_; // plane_: a point of the screen's plane that it moves in
    Eigen::Vector2d held_, grip_;    // pixels: of the pointer, and from it to the handle
    std::optional<editing::TrajectoryEdits> path_; // of a trajectory's point
    struct Hold {                                  // on the body's surface
        ShapePointer surface;
        bool follows = false, isFree = false;
    } hold_;
    std::optional<double> rollsFrom_; // pixels, of where it was pressed
    struct Turning {
        int axis;
        double last;        // the angle of the hand
        double angle = 0;   // radians, since it was taken
        double reached = 0; // degrees: of a body that joints hold
    };
    std::optional<Turning> turning_;
    struct Snaps {
        std::optional<Snapping> by;
        Snapped last; // move
        bool areHeldOff = false;
    } snaps_;
    editing::Answer answer_;
    std::optional<Along> along_;
    bool quaternion_ = false, moved_ = false, isUpright_ = false, isByKeys_;
};

} // namespace gestures
