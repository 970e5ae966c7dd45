// Linear motion with constant coefficients, y' = A y + b: drag, a spring to a fixed point, an
// attitude that turns at a constant rate. Exact at the ends of its pieces:
//
//     (y, 1)(t + h) = e^{Mh} (y, 1),   M = | A b |     by scaling, Taylor's series and squaring
//                                          | 0 0 |
//
// Pieces are powers of 2 long: the exponential of one is the square of that of half of it. Each is
// kept as e^{Mh} - 1, and is squared with the digits of a long double: a slow motion beside a stiff
// end takes twenty squarings, and each doubles the error of the first. M is balanced first (Parlett
// and Reinsch 1969): unknowns are counted in units, powers of 2, in which its rows and columns are
// alike, so that a stiff spring needs no more squarings than its frequency asks for.
//
// and between them the polynomial of degree 7 through the exact values at Chebyshev's points,
// within 1e-13 of the largest value of each unknown, which is checked at four points more. (Degree
// 7, so that its integral still is a polynomial that a history can keep.) The misfit grows with the
// eighth power of the length, which says when pieces of twice the length will do; now and then they
// are tried without. An oscillation has some 25 in each period, a decayed motion few.
//
// Where one unknown is the rate of another, the polynomial of that one begins with just this rate:
// a body that rests on something and is lifted does not sink into it by rounding first.
#pragma once

#include "exact/closed_form.h"

#include <Eigen/Core>

#include <map>
#include <utility>
#include <vector>

namespace solution {

class LinearMotion {
public:
    static constexpr std::size_t mostStates = 8;

    explicit LinearMotion(const LinearForm& form);
    [[nodiscard]] double until() const { return until_; }
    [[nodiscard]] std::size_t bytes() const {
        const auto entries = static_cast<std::size_t>(precise_[0].size());
        return sizeof *this + made_.size() * sizeof(Propagators) +
               precise_.size() * entries * sizeof(long double);
    }

    // The next piece from y: its length. Columns are polynomials of (t - t0)/length; y becomes the
    // values at its end. 0: there is none, since values are not finite or rounding is worse than
    // what is promised (very stiff and badly scaled A).
    [[nodiscard]] double advance(std::span<double> y, std::span<Coefficients> columns);

private:
    static constexpr Eigen::Index most = static_cast<Eigen::Index>(mostStates) + 1;
    using Matrix =
        Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, most, most>;
    using Vector = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, most, 1>;
    static constexpr std::size_t points = 8, checks = 4;
    using PreciseMatrix = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;
    struct Propagators { // of one length, to each point and check of it; less 1
        std::array<Matrix, points> to;
        std::array<Matrix, checks> check;
    };
    using Precise = std::array<PreciseMatrix, points + checks>;

    void balance();
    [[nodiscard]] Precise exponentials(double h) const;
    [[nodiscard]] static Propagators rounded(const Precise& precise);
    [[nodiscard]] const Propagators& propagators(int level);
    [[nodiscard]] double lengthOf(int level) const;
    // The error of the polynomial over the error that it may have; `end`: the values at its end.
    [[nodiscard]] double misfit(int level, const Vector& start, std::span<Coefficients> columns,
                                Vector& end);
    void beginAtRates(double h, const Vector& start, std::span<Coefficients> columns) const;

    double until_;
    Matrix m_;
    Vector unit_; // of each unknown
    std::vector<std::pair<Eigen::Index, Eigen::Index>>
        rates_;                       // an unknown, and the one that is its rate
    double base_ = 1;                 // length of level 0
    int level_ = 0;                   // lengths are powers of 2 of it
    int waiting_ = 16;                // pieces until a longer one is tried
    int patience_ = 32;               // and how many that are after the next failure
    double misfit_ = 1;               // of the last piece
    Vector largest_;                  // of each unknown so far
    std::map<int, Propagators> made_; // of this level and those beside it
    Precise precise_;                 // of the level that was made last, if it is 0 or more
    int preciseLevel_ = -1;
};

} // namespace solution
