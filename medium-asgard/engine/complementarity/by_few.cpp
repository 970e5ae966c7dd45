#include "complementarity/by_few.h"

#include "complementarity/centres.h"
#include "complementarity/solve.h"

#include <algorithm>

namespace complementarity {

namespace {

// The laws of some of their rows: the others have no force.
class Reduced {
public:
    Reduced(const Laws& laws, Index rows, const Answer& guess) : laws_(laws), guess_(guess) {
        constexpr Index few = 4, many = 8;
        std::vector<char> isSpare(static_cast<std::size_t>(rows), 0);
        for (const Law& law : laws)
            for (Index i = 0; law.normals > many && i < law.normals; ++i)
                if (i % (law.normals / few) != 0 &&
                    !(hasGuess() && guess.forces[law.normal + i] > 0))
                    isSpare[static_cast<std::size_t>(law.normal + i)] = 1;
        for (Index row = 0; row < rows; ++row)
            (isSpare[static_cast<std::size_t>(row)] != 0 ? spare_ : rows_).push_back(row);
    }

    [[nodiscard]] bool isWhole() const { return spare_.empty(); }
    [[nodiscard]] std::optional<Answer> solve(const Matrix& a, const Vector& b) const {
        const auto found = complementarity::solve(a(rows_, rows_), b(rows_), laws(), guess());
        if (!found)
            return std::nullopt;
        Answer answer{Vector::Zero(b.size()), {}, {}};
        answer.forces(rows_) = found->forces;
        answer.rates = a * answer.forces + b;
        auto state = found->states.begin();
        for (const Law& law : laws_)
            answer.states.push_back(isIn(law.first) ? *state++ : State::low);
        return answer;
    }
    // Of the rows without a force those that sink in, where none beside them sinks deeper. False:
    // none does.
    [[nodiscard]] bool takeIn(const Vector& rates, double rounding) {
        const auto sinking = [&](Index row) { return isIn(row) ? 0 : -rates[row]; };
        std::vector<Index> more;
        for (const Law& law : laws_)
            for (Index i = 0; law.normal >= 0 && i < law.normals; ++i) {
                const Index row = law.normal + i,
                            before = law.normal + (i + law.normals - 1) % law.normals,
                            after = law.normal + (i + 1) % law.normals;
                if (sinking(row) > rounding && sinking(row) >= sinking(before) &&
                    sinking(row) >= sinking(after))
                    more.push_back(row);
            }
        for (const Index row : more) {
            rows_.insert(std::ranges::lower_bound(rows_, row), row);
            std::erase(spare_, row);
        }
        return !more.empty();
    }

private:
    [[nodiscard]] bool isIn(Index row) const { return std::ranges::binary_search(rows_, row); }
    [[nodiscard]] Index placeOf(Index row) const {
        return std::ranges::lower_bound(rows_, row) - rows_.begin();
    }
    [[nodiscard]] bool hasGuess() const { return guess_.forces.size() > 0; }
    [[nodiscard]] Answer guess() const {
        Answer reduced;
        if (!hasGuess())
            return reduced;
        reduced.forces = guess_.forces(rows_);
        for (std::size_t k = 0; k < laws_.size(); ++k)
            if (isIn(laws_[k].first))
                reduced.states.push_back(guess_.states[k]);
        return reduced;
    }
    [[nodiscard]] Laws laws() const {
        Laws reduced;
        for (Law law : laws_) {
            if (!isIn(law.first))
                continue;
            law.first = placeOf(law.first);
            if (law.normal >= 0) {
                std::vector<Index> kept;
                for (Index i = 0; i < law.normals; ++i)
                    if (isIn(law.normal + i))
                        kept.push_back(i);
                law.normal = placeOf(law.normal);
                law.normals = static_cast<Index>(kept.size());
                if (law.levers.size() > 0)
                    law.levers = law.levers(Eigen::all, kept).eval();
            }
            reduced.push_back(std::move(law));
        }
        return reduced;
    }

    const Laws& laws_;
    const Answer& guess_;
    std::vector<Index> rows_, spare_; // in order
};

} // namespace

std::optional<Answer> solveByFew(const Matrix& a, const Vector& b, const Laws& laws,
                                 const Answer& guess) {
    Reduced reduced(laws, b.size(), guess);
    constexpr double none = 1e-11; // of the largest rate: rounding
    const double rounding = b.size() > 0 ? none * b.cwiseAbs().maxCoeff() : 0;
    while (!reduced.isWhole()) {
        auto found = reduced.solve(a, b);
        if (!found)
            break;
        if (!reduced.takeIn(found->rates, rounding))
            return found;
    }
    const auto found = solve(a, b, laws, guess);
    return found ? found : solveBesideCentres(a, b, laws);
}

} // namespace complementarity
