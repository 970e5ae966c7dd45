// The x with x = f(x), of which f(x) is known for one x after the other.
//
// The next x is the one at which f(x) - x would be least if it were linear between the last ones
// (Anderson, Journal of the ACM 12, 1965). Weights say how much each of its numbers counts there.
#pragma once

#include <Eigen/Core>
#include <Eigen/QR>

#include <algorithm>
#include <utility>

namespace complementarity {

class FixedPoint {
public:
    using Vector = Eigen::VectorXd;
    explicit FixedPoint(Vector start) : at_(std::move(start)) {}

    [[nodiscard]] const Vector& at() const { return at_; }
    // From f(at()).
    void moveFrom(const Vector& value, const Vector& weights) {
        constexpr double longest = 30; // times the step to f(x)
        const Vector step = value - at_;
        if (lastStep_.size() > 0) {
            const Eigen::Index room = std::min<Eigen::Index>(kept, at_.size());
            const Eigen::Index count = std::min(room, steps_.cols() + 1);
            moves_ = joined(moves_, at_ - last_, count);
            steps_ = joined(steps_, step - lastStep_, count);
        }
        last_ = at_;
        lastStep_ = step;
        at_ = value;
        if (steps_.cols() == 0)
            return;
        const Vector parts = Eigen::ColPivHouseholderQR<Columns>(weights.asDiagonal() * steps_)
                                 .solve(weights.cwiseProduct(step));
        const Vector less = (moves_ + steps_) * parts;
        if (less.norm() < longest * step.norm())
            at_ -= less;
    }

private:
    static constexpr int kept = 5; // differences
    using Columns = Eigen::MatrixXd;
    // The last `count` columns.
    static Columns joined(const Columns& columns, const Vector& more, Eigen::Index count) {
        Columns all(more.size(), count);
        if (count > 1)
            all.leftCols(count - 1) = columns.rightCols(count - 1);
        all.col(count - 1) = more;
        return all;
    }
    Vector at_, last_, lastStep_;
    Columns moves_, steps_; // from x to x, and of f(x) - x
};

} // namespace complementarity
