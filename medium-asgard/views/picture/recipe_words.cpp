#include "picture/recipe_words.h"

#include "editing/number_text.h"

namespace views {

std::string listed(const Vector& v, double resolution) {
    std::string text = "{";
    for (int i = 0; i < 3; ++i)
        text += (i == 0 ? "" : " ") + editing::numberText(v[i], editing::decimalStep(resolution));
    return text + "}";
}

Vector alongAxis(const Vector& v) {
    constexpr double steady = 0.1; // radians
    Eigen::Index axis = 0;
    v.cwiseAbs().maxCoeff(&axis);
    const Vector along = v[axis] * Vector::Unit(axis);
    return (v - along).norm() <= steady * along.norm() ? along : v;
}

} // namespace views
