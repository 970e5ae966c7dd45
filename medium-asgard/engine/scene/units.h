// The unit of an expression's value, and the words for the quantity that it reads.
//
//     b1.x              m         "x of b1"
//     b1.mass * b1.dx   kg m/s
//     atan2(b1.x, 3)    rad
//
// Every name has a dimension: powers of metre, kilogram, second and radian. Sums keep that of their
// terms, products add powers, functions of angles take them. A plain number is of any dimension in
// a sum (b1.x + 1 is a length); as a factor it has none where formulas have such factors (0.5 m v²,
// 2 x, -x). Any other factor may be a quantity (9.81) or change the unit (100 for centimetres): the
// unit of such a product is not known.
//
// Lengths, times and masses are in any units that go together; these are the ones that samples
// take. A radian beside other units is not written, but for torques, which are joules to a radian:
// N m.
// LIMIT: parameters and trajectories have no known dimension.
#pragma once

#include "scene/names.h"

#include <optional>
#include <string>

namespace scene {

struct Dimension {
    int length = 0, mass = 0, time = 0, angle = 0; // powers
    bool operator==(const Dimension&) const = default;
};

[[nodiscard]] std::string unitNamed(const Dimension& dimension); // "m/s", "N"; "": a bare number

class Units {
public:
    explicit Units(const Scene& scene) : scene_(scene), names_(scene) {}
    // "": it has none, or it is not known.
    [[nodiscard]] std::string of(const std::string& expression) const;
    // Of an expression that is one name: "x of b1", "energy". "": it is more than that.
    [[nodiscard]] std::string wordsOf(const std::string& expression) const;

private:
    [[nodiscard]] std::optional<Dimension> dimensionOf(const Named& named) const;

    const Scene& scene_;
    Names names_;
};

} // namespace scene
