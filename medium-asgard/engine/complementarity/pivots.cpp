#include "complementarity/pivots.h"

#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace complementarity {

namespace {

// w = M x + q.
class Tableau {
public:
    Tableau(const Matrix& m, const Vector& q)
        : size_(q.size()), rows_(size_, 2 * size_ + 2), basis_(static_cast<std::size_t>(size_)) {
        rows_ << Matrix::Identity(size_, size_), -m, -Vector::Ones(size_), q;
        for (Index i = 0; i < size_; ++i)
            basis_[static_cast<std::size_t>(i)] = i;
    }

    // False: they end on a ray, or do not end.
    bool solve() {
        Index row = 0;
        if (rows_.col(2 * size_ + 1).minCoeff(&row) >= 0)
            return true;
        Index leaving = exchange(row, added());
        for (Index pivots = 0, most = 10 * size_ + 50; pivots < most; ++pivots) {
            const Index entering = leaving < size_ ? leaving + size_ : leaving - size_;
            row = rowFor(entering);
            if (row < 0)
                return false;
            leaving = exchange(row, entering);
            if (leaving == added())
                return true;
        }
        return false;
    }

    // x; `isBasic`: of those whose w is 0.
    [[nodiscard]] Vector values(std::vector<char>& isBasic) const {
        Vector x = Vector::Zero(size_);
        isBasic.assign(static_cast<std::size_t>(size_), 0);
        for (Index i = 0; i < size_; ++i)
            if (const Index k = basis_[static_cast<std::size_t>(i)] - size_; k >= 0 && k < size_) {
                x[k] = rows_(i, 2 * size_ + 1);
                isBasic[static_cast<std::size_t>(k)] = 1;
            }
        return x;
    }

private:
    static constexpr double noPivot = 1e-6; // what faces that are all but parallel leave is none
    static constexpr double tie = 1e-13;

    [[nodiscard]] Index added() const { return 2 * size_; }

    // The first row that the entering number takes to 0; of several the least by its other numbers.
    [[nodiscard]] Index rowFor(Index entering) const {
        std::vector<Index> rows;
        for (Index i = 0; i < size_; ++i)
            if (rows_(i, entering) > noPivot)
                rows.push_back(i);
        if (rows.empty())
            return -1;
        keepLeast(rows, entering, 2 * size_ + 1);
        for (const Index row : rows)
            if (basis_[static_cast<std::size_t>(row)] == added())
                return row;
        for (Index column = 0; column < size_ && rows.size() > 1; ++column)
            keepLeast(rows, entering, column);
        return rows.front();
    }
    void keepLeast(std::vector<Index>& rows, Index entering, Index column) const {
        const auto ratio = [&](Index row) { return rows_(row, column) / rows_(row, entering); };
        double least = unbounded;
        for (const Index row : rows)
            least = std::min(least, ratio(row));
        const double most = least + tie * std::max(1.0, std::abs(least));
        std::erase_if(rows, [&](Index row) { return ratio(row) > most; });
    }

    Index exchange(Index row, Index entering) {
        rows_.row(row) /= rows_(row, entering);
        for (Index i = 0; i < size_; ++i)
            if (const double by = rows_(i, entering); i != row && by != 0)
                rows_.row(i) -= by * rows_.row(row);
        return std::exchange(basis_[static_cast<std::size_t>(row)], entering);
    }

    Index size_;
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> rows_;
    std::vector<Index> basis_;
};

// The laws as such a problem:  f = fixed + forces x.
class Linear {
public:
    Linear(const Matrix& a, const Vector& b, const Laws& laws) : a_(a), b_(b), laws_(laws) {}

    // False: they are not linear.
    bool make() {
        constexpr Index most = 400;
        findMoved();
        for (std::size_t k = 0; k < laws_.size(); ++k)
            if (!isFree(laws_[k]) && !add(k))
                return false;
        if (numbers_.empty() || static_cast<Index>(numbers_.size()) > most)
            return false;
        findForces();
        return true;
    }

    std::optional<Answer> solve() {
        const auto n = static_cast<Index>(numbers_.size());
        Matrix m = Matrix::Zero(n, n);
        Vector q(n), scale(n);
        const Matrix rates = a_ * forces_;
        const Vector rest = a_ * fixed_ + b_;
        for (Index i = 0; i < n; ++i) {
            const Number& of = numbers_[static_cast<std::size_t>(i)];
            const double own = std::sqrt(std::max(a_(of.row, of.row), 1e-300));
            scale[i] = of.sign == 0 ? own : 1 / own;
            if (of.sign == 0) { // the room of its law
                q[i] = of.room;
                m.row(i) = of.slope * forces_;
                q[i] += of.slope.dot(fixed_);
                if (laws_[of.law].kind == Law::Kind::disc)
                    m(i, i - 2) = m(i, i - 1) = -1;
            } else {
                q[i] = of.sign * rest[of.row];
                m.row(i) = of.sign * rates.row(of.row);
                if (of.slip >= 0)
                    m(i, of.slip) += 1;
            }
        }
        m = scale.asDiagonal() * m * scale.asDiagonal();
        q = scale.cwiseProduct(q);
        const double size = std::max(q.cwiseAbs().maxCoeff(), 1e-300);
        Tableau tableau(m, q / size);
        if (!tableau.solve())
            return std::nullopt;
        std::vector<char> isBasic;
        const Vector x = size * scale.cwiseProduct(tableau.values(isBasic));
        Answer answer{fixed_ + forces_ * x, {}, States(laws_.size(), State::inside)};
        answer.rates = a_ * answer.forces + b_;
        for (std::size_t i = 0; i < numbers_.size(); ++i)
            if (const Number& of = numbers_[i]; (isBasic[i] != 0) == of.isAwayIfBasic)
                answer.states[of.law] = of.away;
        for (std::size_t k = 0; k < laws_.size(); ++k)
            if (const Law& law = laws_[k]; law.kind == Law::Kind::interval && law.low == law.high)
                answer.states[k] = answer.rates[law.first] < 0 ? State::high : State::low;
        return answer;
    }

private:
    static constexpr double rounding = 1e-12;
    // An x: of a force, by its sign, from a bound on; or of a slip, whose w is the room of its law.
    struct Number {
        std::size_t law = 0;
        Index row = 0;
        double sign = 0, room = 0;
        Index slip = -1;
        Eigen::RowVectorXd slope = {}; // of the room, by forces
        State away = State::inside;    // its law's state, if the number is basic or if it is not
        bool isAwayIfBasic = false;
    };

    [[nodiscard]] static bool isFree(const Law& law) {
        return law.kind == Law::Kind::interval && law.low == -unbounded && law.high == unbounded;
    }

    // Rows of discs that forces move: those on which a rate or a normal force works, and those on
    // which such a row does.
    void findMoved() {
        std::vector<Index> from;
        moved_.assign(static_cast<std::size_t>(b_.size()), 0);
        const double none = rounding * b_.cwiseAbs().maxCoeff();
        for (const Law& law : laws_)
            for (Index i = law.first; i < law.first + law.rows; ++i)
                if (law.kind == Law::Kind::interval || std::abs(b_[i]) > none) {
                    moved_[static_cast<std::size_t>(i)] = 1;
                    from.push_back(i);
                }
        while (!from.empty()) {
            const Index by = from.back();
            from.pop_back();
            for (Index i = 0; i < b_.size(); ++i)
                if (moved_[static_cast<std::size_t>(i)] == 0 &&
                    std::abs(a_(i, by)) > rounding * std::sqrt(std::abs(a_(i, i) * a_(by, by)))) {
                    moved_[static_cast<std::size_t>(i)] = 1;
                    from.push_back(i);
                }
        }
    }
    // Of a disc, the one row that forces move; -1: none does; -2: several.
    [[nodiscard]] Index rowOf(const Law& disc) const {
        Index found = -1;
        for (Index i = disc.first; i < disc.first + disc.rows; ++i)
            if (moved_[static_cast<std::size_t>(i)] != 0) {
                if (found >= 0)
                    return -2;
                found = i;
            }
        return found;
    }

    bool add(std::size_t k) {
        const Law& law = laws_[k];
        if (law.kind == Law::Kind::interval) {
            addInterval(k);
            return true;
        }
        const Index row = rowOf(law);
        if (row == -2)
            return false;
        if (row == -1)
            return true;
        const auto slip = static_cast<Index>(numbers_.size()) + 2;
        numbers_.push_back({.law = k, .row = row, .sign = 1, .slip = slip});
        numbers_.push_back({.law = k, .row = row, .sign = -1, .slip = slip});
        Number room{.law = k, .row = row, .room = law.radius};
        room.away = State::edge;
        room.isAwayIfBasic = true;
        numbers_.push_back(std::move(room));
        return true;
    }
    void addInterval(std::size_t k) {
        const Law& law = laws_[k];
        if (law.low == law.high)
            return;
        const bool isFromLow = law.low > -unbounded, hasBoth = isFromLow && law.high < unbounded;
        const auto next = static_cast<Index>(numbers_.size()) + 1;
        numbers_.push_back({.law = k,
                            .row = law.first,
                            .sign = isFromLow ? 1.0 : -1.0,
                            .slip = hasBoth ? next : -1,
                            .away = isFromLow ? State::low : State::high});
        if (hasBoth)
            numbers_.push_back({.law = k,
                                .row = law.first,
                                .room = law.high,
                                .away = State::high,
                                .isAwayIfBasic = true});
    }

    void findForces() {
        const auto n = static_cast<Index>(numbers_.size());
        forces_ = Matrix::Zero(b_.size(), n);
        fixed_ = Vector::Zero(b_.size());
        for (const Law& law : laws_)
            if (law.kind == Law::Kind::interval && !isFree(law))
                fixed_[law.first] = law.low > -unbounded ? law.low : law.high;
        for (Index i = 0; i < n; ++i)
            if (const Number& of = numbers_[static_cast<std::size_t>(i)]; of.sign != 0)
                forces_(of.row, i) = of.sign;
        for (Index i = 0; i < n; ++i)
            if (numbers_[static_cast<std::size_t>(i)].sign == 0)
                findSlope(i);
        std::vector<Index> free;
        for (const Law& law : laws_)
            if (isFree(law))
                free.push_back(law.first);
        if (free.empty())
            return;
        const Eigen::CompleteOrthogonalDecomposition<Matrix> held(Matrix(a_(free, free)));
        forces_(free, Eigen::all) = -held.solve(Matrix((a_ * forces_)(free, Eigen::all)));
        fixed_(free) = -held.solve(Vector((a_ * fixed_ + b_)(free)));
    }

    // Of the radius, from which p and n are taken besides; or of what is left to the other bound.
    void findSlope(Index i) {
        Number& of = numbers_[static_cast<std::size_t>(i)];
        const Law& law = laws_[of.law];
        of.slope = Eigen::RowVectorXd::Zero(b_.size());
        if (law.kind == Law::Kind::interval)
            of.slope[of.row] = -1;
        else if (law.normal >= 0)
            of.slope.segment(law.normal, law.normals).setConstant(law.coefficient);
    }

    const Matrix& a_;
    const Vector& b_;
    const Laws& laws_;
    std::vector<char> moved_;
    std::vector<Number> numbers_;
    Matrix forces_;
    Vector fixed_;
};

} // namespace

std::optional<Answer> byPivots(const Matrix& a, const Vector& b, const Laws& laws) {
    Linear linear(a, b, laws);
    return linear.make() ? linear.solve() : std::nullopt;
}

} // namespace complementarity
