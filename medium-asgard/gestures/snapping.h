// The place that a hand means: nearby things draw it to them.
//
// A point that lies as deep in the picture as the hand comes first (the middle of a face, a corner,
// the origin of a body, a joint, the end of a link, a point of a path), then an edge, then a point
// at another depth, which the place is moved to. Otherwise each coordinate that the hand moves is
// drawn to round numbers, those of the grid, and to the number that it had before.
//
// LIMIT: round surfaces draw to their centres only, hulls to their corners; of a crowd the first
// bodies only.
#pragma once

#include "gestures/picking.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace gestures {

struct Snapped {
    Vector place;
    bool isExact = false; // it is the place of a thing, not a round number
    std::string to;       // "a corner of b1"; "": round numbers, or nothing
};

class Snapping {
public:
    // The things stand where the drawing shows them. `scale`: device pixels for each of the
    // reader's. `held`: the handle that the hand moves. Things that move with it draw nothing, nor
    // do those bodies.
    Snapping(const render::Drawing& drawing, const Sight& sight, double scale,
             const render::Handle* held = nullptr, const std::vector<std::size_t>& company = {});

    // `before`: where it was before it was moved.
    [[nodiscard]] Snapped at(const Vector& wanted,
                             const std::optional<Vector>& before = std::nullopt) const;
    // Round numbers are so far apart here, in units of the world.
    [[nodiscard]] double step(const Vector& place) const;

private:
    struct Point {
        Vector place;
        Eigen::Vector2d pixels;
        std::string name;
    };
    struct Edge {
        Vector from, to;
        std::size_t body = 0;
    };
    void addBody(const render::Drawing& drawing, std::size_t index);
    void addHandles(const render::Drawing& drawing);
    void addEnd(const Vector& place, const std::string& body, const char* name);
    void add(const Vector& place, std::string name);
    [[nodiscard]] bool moves(const std::string& body) const;
    [[nodiscard]] const Point* nearest(const Vector& wanted, bool flat) const;
    [[nodiscard]] std::optional<Snapped> onEdge(const Vector& wanted) const;
    [[nodiscard]] Vector rounded(const Vector& wanted, const std::optional<Vector>& before) const;
    [[nodiscard]] bool isAsDeep(const Vector& place, const Vector& wanted) const;

    Sight sight_;
    double reach_, apart_; // pixels: of a thing, and of round numbers from one to the next
    std::vector<Point> points_;
    std::vector<Edge> edges_;
    std::vector<std::string> bodies_; // names
    std::vector<std::string> moving_; // of the bodies that move with the hand
    std::optional<Vector> held_;      // the place that it moves
};

// The least of 1, 2 or 5 times a power of ten that is not below `length`.
[[nodiscard]] double roundStep(double length);

} // namespace gestures
