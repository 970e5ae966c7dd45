// Rows of forces with laws: the one form of joints, contacts, motors, friction and held switches.
//
//     w = A f + b         f: forces (or impulses, or weights), w: rates (or speeds) that they give
//
// Each row of f belongs to one law:
//     interval  low <= f <= high; w = 0 inside, w >= 0 at low, w <= 0 at high
//     disc      |f| <= r; w = 0 inside; at the edge w points against f
//               f has one, two or three rows; r = radius + coefficient * N, at least 0, where N is
//               the sum of some rows next to each other, the normal forces of one contact
//     slip      f = -r v/|v|: a disc that moves already, with a velocity v that no force changes
//     here
//
// The disc of a face acts at the centre of its normal forces, wherever they press. Its last row
// turns, and the others read at the point of normal force i the rates  w_k + c_ki w_last  (levers).
// With  c = sum c_i n_i / N  the laws above hold for  w_k + c_k w_last  and  f_last - sum c_k f_k.
//
// A joint is an interval without ends, a contact one from 0 on, a motor one between its greatest
// forces, Coulomb's friction a disc whose radius is the coefficient times the normal force.
//
// Units are the caller's. Rows of couples are best divided by a length, so that forces of least
// norm mean something.
#pragma once

#include <Eigen/Core>

#include <limits>
#include <vector>

namespace complementarity {

using Index = Eigen::Index;
using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;

inline constexpr double unbounded = std::numeric_limits<double>::infinity();

struct Law {
    enum class Kind { interval, disc, slip };
    Kind kind = Kind::interval;
    Index first = 0, rows = 1;                 // an interval has one row
    double low = -unbounded, high = unbounded; // interval
    double radius = 0, coefficient = 0;        // disc and slip, and all below
    Index normal = -1;                         // the first row of the normal force; -1: none
    Index normals = 1;                         // its rows
    Matrix levers = {};                        // rows but the last, by normals; none: 0
    Vector velocity = {};                      // slip: of its rows
    Vector beside = {};                        // slip: what v has besides, at every centre
};

using Laws = std::vector<Law>;

// Laws of the next rows.
void addEquality(Laws& laws);
void addInterval(Laws& laws, double low, double high);
void addUnilateral(Laws& laws); // f >= 0
void addDisc(Laws& laws, Index rows, double radius);
void addFriction(Laws& laws, Index rows, Index normal, double coefficient, Index normals = 1);
[[nodiscard]] Index rowsOf(const Laws& laws);

// The place of a law's force among those that the law allows.
enum class State { inside, low, high, edge };
using States = std::vector<State>; // one for each law; a slip is at the edge

struct Answer {
    Vector forces, rates;
    States states;
};

[[nodiscard]] double radiusOf(const Law& disc, const Vector& forces);
// The levers of the centre of a disc's normal forces.
[[nodiscard]] Vector centreOf(const Law& disc, const Vector& forces);
// Rows of the disc at that centre: from rates w, and from forces f.
[[nodiscard]] Vector ratesAt(const Vector& centre, const Vector& rates);
[[nodiscard]] Vector forcesAt(const Vector& centre, const Vector& forces);
// Of a slip, the direction of its velocity.
[[nodiscard]] Vector directionAt(const Vector& centre, const Law& slip);
// Back from the centre.
[[nodiscard]] Vector forcesFrom(const Vector& centre, const Vector& forces);

// By how much the answer breaks the laws, over the size of what enters: of forces beyond their
// bounds over the largest force; of rates over the largest of b, and of those that forces at fixed
// bounds give.
[[nodiscard]] double violation(const Matrix& a, const Vector& b, const Laws& laws,
                               const Answer& answer);

} // namespace complementarity
