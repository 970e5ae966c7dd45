#include "complementarity/solve.h"

#include "complementarity/convex.h"
#include "complementarity/fixed_point.h"
#include "complementarity/interior.h"
#include "complementarity/newton.h"
#include "complementarity/sweeps.h"

#include <Eigen/Cholesky>

#include <algorithm>

namespace complementarity {

namespace {

constexpr double kept = 1e-11; // a violation under this is rounding
constexpr std::size_t fewLaws = 6;

std::vector<State> possibleStates(const Law& law) {
    std::vector<State> states = {State::inside};
    if (law.kind == Law::Kind::disc)
        states.push_back(State::edge);
    if (law.kind == Law::Kind::interval && law.low > -unbounded)
        states.push_back(State::low);
    if (law.kind == Law::Kind::interval && law.high < unbounded)
        states.push_back(State::high);
    return states;
}

// Intervals on a symmetric A without a negative direction.
bool isConvex(const Matrix& a, const Laws& laws) {
    const double largest = a.cwiseAbs().maxCoeff();
    if (std::ranges::any_of(laws, [](const Law& law) { return law.kind != Law::Kind::interval; }) ||
        (a - a.transpose()).cwiseAbs().maxCoeff() > 1e-12 * largest)
        return false;
    return Eigen::LDLT<Matrix>(a).vectorD().minCoeff() >= -1e-12 * largest;
}

class Search {
public:
    Search(const Matrix& a, const Vector& b, const Laws& laws, Work& work)
        : a_(a), b_(b), laws_(laws), work_(work) {}

    // From these states and forces, and those that their faults ask for: the answer with the least
    // violation. Its sign alone decides a state, so that a threshold is right to rounding.
    std::optional<Answer> near(const States& states, const Vector& forces) {
        if (auto answer = near(states, forces, Aim::shortest))
            return answer;
        return near(states, forces, Aim::nearest);
    }

    std::optional<Answer> fromNothing() {
        const Approach inside = approach(a_, b_, laws_);
        work_.steps = inside.steps;
        if (auto answer = near(inside.states, inside.forces))
            return answer;
        if (auto answer = alongSlips(inside.forces))
            return answer;
        if (auto answer = bySmallerSteps(inside))
            return answer;
        return bySweeps();
    }

private:
    std::optional<Answer> near(States states, const Vector& forces, Aim aim) {
        constexpr int most = 20;
        std::optional<Answer> best;
        std::vector<States> tried;
        double least = kept;
        for (int round = 0; round < most; ++round) {
            ++work_.tries;
            const std::optional<Answer> answer = solveStates(a_, b_, laws_, states, forces, aim);
            if (!answer)
                break;
            if (const double faulty = violation(a_, b_, laws_, *answer); faulty <= least) {
                best = answer;
                least = faulty;
            } else if (best) {
                break;
            }
            tried.push_back(states);
            states = improved(laws_, *answer);
            if (states == tried.back() && !best)
                states = opened(laws_, *answer);
            if (std::ranges::find(tried, states) != tried.end())
                break;
        }
        return best;
    }

    // Bodies that jam, as dominoes that lean on each other, have many answers that are all but
    // alike, and the states of one lead to another. A pull towards the last answer leaves one of
    // them; the pull fades (the proximal point method; Rockafellar, SIAM Journal on Control and
    // Optimization 14, 1976).
    std::optional<Answer> bySmallerSteps(const Approach& from) {
        constexpr double strongest = 1, least = 1e-9, less = 0.1, more = 10;
        constexpr int most = 60;
        Vector forces = from.forces;
        States states = from.states;
        double pull = 1e-3;
        for (int step = 0; step < most && pull <= strongest; ++step) {
            const Vector added = pull * a_.diagonal();
            const Matrix firm = a_ + Matrix(added.asDiagonal());
            const Vector b = b_ - added.cwiseProduct(forces);
            auto answer = Search(firm, b, laws_, work_).near(states, forces);
            if (!answer) {
                pull *= more;
                continue;
            }
            forces = answer->forces;
            states = answer->states;
            answer->rates = a_ * forces + b_;
            if (violation(a_, b_, laws_, *answer) <= kept)
                return answer;
            pull = std::max(least, less * pull);
        }
        return std::nullopt;
    }

    // Friction of what slips so fast that the forces hardly turn the slip is known but for its
    // normal force: it goes into the columns of that, and the slips are out of sight of the rest,
    // whose rates may be millions of times smaller. Then the slips are turned, and all is again.
    std::optional<Answer> alongSlips(const Vector& estimate) {
        constexpr int most = 20;
        const Slips slips = slipsOf(estimate);
        if (slips.discs.empty())
            return std::nullopt;
        Vector rates = a_ * estimate + b_;
        Answer last;
        for (int round = 0; round < most; ++round) {
            auto answer = alongSlips(slips, rates, last);
            if (!answer || violation(a_, b_, laws_, *answer) <= kept)
                return answer;
            rates = answer->rates;
        }
        return std::nullopt;
    }

    struct Slips {
        std::vector<std::size_t> discs, others; // laws
        std::vector<Index> rows;                // of the others
    };
    [[nodiscard]] Slips slipsOf(const Vector& estimate) const {
        constexpr double fast = 10; // times what the forces change
        const Vector change = a_ * estimate;
        Slips slips;
        for (std::size_t k = 0; k < laws_.size(); ++k) {
            const Law& law = laws_[k];
            const bool isFast = law.kind == Law::Kind::disc &&
                                b_.segment(law.first, law.rows).norm() >
                                    fast * change.segment(law.first, law.rows).norm();
            (isFast ? slips.discs : slips.others).push_back(k);
            for (Index i = 0; i < law.rows && !isFast; ++i)
                slips.rows.push_back(law.first + i);
        }
        return slips;
    }

    // `rates` have the directions of the slips; `last`: the answer of the others, before and after.
    std::optional<Answer> alongSlips(const Slips& slips, const Vector& rates, Answer& last) {
        Matrix a = a_;
        Vector b = b_;
        for (const std::size_t k : slips.discs) {
            const Law& law = laws_[k];
            const Vector against = -rates.segment(law.first, law.rows).normalized();
            const Vector given = a_.middleCols(law.first, law.rows) * against;
            b += law.radius * given;
            for (Index n = 0; law.normal >= 0 && n < law.normals; ++n)
                a.col(law.normal + n) += law.coefficient * given;
        }
        Laws laws;
        std::vector<Index> placeOf(static_cast<std::size_t>(b_.size()), -1);
        for (std::size_t i = 0; i < slips.rows.size(); ++i)
            placeOf[static_cast<std::size_t>(slips.rows[i])] = static_cast<Index>(i);
        for (const std::size_t k : slips.others) {
            laws.push_back(laws_[k]);
            laws.back().first = placeOf[static_cast<std::size_t>(laws_[k].first)];
            if (laws_[k].normal >= 0)
                laws.back().normal = placeOf[static_cast<std::size_t>(laws_[k].normal)];
        }
        Work work;
        auto others =
            complementarity::solve(a(slips.rows, slips.rows), b(slips.rows), laws, last, &work);
        work_.steps += work.steps;
        work_.sweeps += work.sweeps;
        work_.tries += work.tries;
        if (!others)
            return std::nullopt;
        last = std::move(*others);
        Answer answer{Vector::Zero(b_.size()), {}, States(laws_.size(), State::edge)};
        answer.forces(slips.rows) = last.forces;
        for (std::size_t i = 0; i < slips.others.size(); ++i)
            answer.states[slips.others[i]] = last.states[i];
        for (const std::size_t k : slips.discs) {
            const Law& law = laws_[k];
            answer.forces.segment(law.first, law.rows) =
                -radiusOf(law, answer.forces) * rates.segment(law.first, law.rows).normalized();
        }
        answer.rates = a_ * answer.forces + b_;
        return answer;
    }

    // A little on the diagonal leads redundant laws to short forces. Where the states do not tell
    // the forces, as with many bodies at the limit of sticking, the sweeps' own do, if they settle.
    std::optional<Answer> bySweeps() {
        constexpr int most = 4096;
        const Matrix firm = a_ + 1e-10 * Matrix(a_.diagonal().asDiagonal());
        Vector forces = Vector::Zero(b_.size());
        for (int next = 16; work_.sweeps < most; next *= 4) {
            const double change = sweepOn(firm, next, forces);
            if (auto answer = near(statesOf(firm, b_, laws_, forces), forces))
                return answer;
            if (!(change > 1e-15 * forces.cwiseAbs().maxCoeff()))
                break;
        }
        for (int next = work_.sweeps + 16; work_.sweeps < most && forces.allFinite(); next *= 2) {
            sweepOn(a_, next, forces);
            const Answer swept{forces, a_ * forces + b_, statesOf(a_, b_, laws_, forces)};
            if (violation(a_, b_, laws_, swept) <= kept)
                return swept;
        }
        return std::nullopt;
    }

    // The last change of a force.
    double sweepOn(const Matrix& a, int upTo, Vector& forces) {
        double change = 0;
        for (; work_.sweeps < upTo; ++work_.sweeps)
            change = sweep(a, b_, laws_, forces);
        return change;
    }

    const Matrix& a_;
    const Vector& b_;
    const Laws& laws_;
    Work& work_;
};

bool areFew(const Laws& laws) {
    const auto choices =
        std::ranges::count_if(laws, [](const Law& law) { return possibleStates(law).size() > 1; });
    return static_cast<std::size_t>(choices) <= fewLaws;
}

bool hasLevers(const Laws& laws) {
    return std::ranges::any_of(laws, [](const Law& law) { return law.levers.size() > 0; });
}

bool isOther(const Answer& answer, const std::vector<Answer>& found) {
    return std::ranges::none_of(found, [&](const Answer& other) {
        const double size = std::max(answer.forces.norm(), other.forces.norm());
        return (answer.forces - other.forces).norm() <= 1e-9 * size;
    });
}

} // namespace

std::vector<Answer> everySolution(const Matrix& a, const Vector& b, const Laws& laws) {
    std::vector<Answer> found;
    if (!areFew(laws) || hasLevers(laws))
        return found;
    std::vector<std::vector<State>> possible;
    std::size_t ways = 1;
    for (const Law& law : laws) {
        possible.push_back(possibleStates(law));
        ways *= possible.back().size();
    }
    const Approach inside = approach(a, b, laws);
    for (std::size_t way = 0; way < ways; ++way) {
        States states;
        std::size_t digits = way;
        for (const std::vector<State>& of : possible) {
            states.push_back(of[digits % of.size()]);
            digits /= of.size();
        }
        const std::optional<Answer> answer =
            solveStates(a, b, laws, states, inside.forces, Aim::shortest);
        if (answer && violation(a, b, laws, *answer) <= kept && isOther(*answer, found))
            found.push_back(*answer);
    }
    return found;
}

namespace {

// Of laws without levers.
std::optional<Answer> solveAtMiddles(const Matrix& a, const Vector& b, const Laws& laws,
                                     const Answer& guess, Work& counts) {
    Search search(a, b, laws, counts);
    if (guess.states.size() == laws.size() && guess.forces.size() == b.size())
        if (auto answer = search.near(guess.states, guess.forces))
            return answer;
    if (isConvex(a, laws))
        return solveConvex(a, b, laws);
    if (auto answer = search.fromNothing())
        return answer;
    const auto choices =
        std::ranges::count_if(laws, [](const Law& law) { return possibleStates(law).size() > 1; });
    if (static_cast<std::size_t>(choices) > fewLaws)
        return std::nullopt;
    const std::vector<Answer> all = everySolution(a, b, laws);
    return all.empty() ? std::nullopt : std::optional(all.front());
}

// The same problem with the rows of discs at centres that are held.
class AtCentres {
public:
    AtCentres(const Matrix& a, const Vector& b, const Laws& laws)
        : a_(a), b_(b), laws_(laws), plain_(laws) {
        for (Law& law : plain_)
            law.levers.resize(0, 0);
    }

    // Of the discs with levers, one after the other, at these forces.
    [[nodiscard]] Vector centresOf(const Vector& forces) const {
        std::vector<double> centres;
        eachDisc([&](const Law& law) {
            const Vector centre = centreOf(law, forces);
            centres.insert(centres.end(), centre.begin(), centre.end());
        });
        return Eigen::Map<const Vector>(centres.data(), static_cast<Index>(centres.size()));
    }

    [[nodiscard]] std::optional<Answer> solve(const Vector& centres, const Answer& guess,
                                              Work& counts) const {
        Matrix a = a_;
        Vector b = b_;
        Answer from = guess;
        eachDisc(centres, [&](const Law& law, const Vector& centre) {
            const Index last = law.first + law.rows - 1;
            a.middleRows(law.first, law.rows - 1) += centre * a.row(last).eval();
            b.segment(law.first, law.rows - 1) += b[last] * centre;
            if (from.forces.size() == b.size())
                from.forces.segment(law.first, law.rows) =
                    forcesAt(centre, from.forces.segment(law.first, law.rows));
        });
        eachDisc(centres, [&](const Law& law, const Vector& centre) {
            const Index last = law.first + law.rows - 1;
            a.middleCols(law.first, law.rows - 1) += a.col(last).eval() * centre.transpose();
        });
        auto answer = solveAtMiddles(a, b, plain_, from, counts);
        if (!answer)
            return answer;
        eachDisc(centres, [&](const Law& law, const Vector& centre) {
            answer->forces.segment(law.first, law.rows) =
                forcesFrom(centre, answer->forces.segment(law.first, law.rows));
        });
        answer->rates = a_ * answer->forces + b_;
        return answer;
    }

private:
    template <class Visit> void eachDisc(const Visit& visit) const {
        for (const Law& law : laws_)
            if (law.levers.size() > 0)
                visit(law);
    }
    template <class Visit> void eachDisc(const Vector& centres, const Visit& visit) const {
        Index first = 0;
        eachDisc([&](const Law& law) {
            visit(law, Vector(centres.segment(first, law.rows - 1)));
            first += law.rows - 1;
        });
    }

    const Matrix& a_;
    const Vector& b_;
    const Laws& laws_;
    Laws plain_;
};

// The forces that the other laws have alone: none where those are not convex.
Vector withoutDiscs(const Matrix& a, const Vector& b, const Laws& laws) {
    Vector forces = Vector::Zero(b.size());
    std::vector<Index> rows;
    Laws others;
    for (const Law& law : laws)
        if (law.kind == Law::Kind::interval) {
            others.push_back(law);
            others.back().first = static_cast<Index>(rows.size());
            rows.push_back(law.first);
        }
    const Matrix among = a(rows, rows);
    if (!isConvex(among, others))
        return forces;
    if (const auto answer = solveConvex(among, b(rows), others))
        forces(rows) = answer->forces;
    return forces;
}

} // namespace

std::optional<Answer> solve(const Matrix& a, const Vector& b, const Laws& laws, const Answer& guess,
                            Work* work) {
    Work counted;
    Work& counts = work != nullptr ? *work : counted;
    counts = {};
    if (b.size() == 0)
        return Answer{};
    if (!hasLevers(laws))
        return solveAtMiddles(a, b, laws, guess, counts);
    const AtCentres at(a, b, laws);
    const bool hasGuess = guess.forces.size() == b.size();
    FixedPoint<> centres(at.centresOf(hasGuess ? guess.forces : withoutDiscs(a, b, laws)));
    constexpr int most = 60;
    constexpr double close = 1e-7; // of a violation that goes on no further down: rounding is left
    std::optional<Answer> answer = guess, best;
    double least = unbounded;
    for (int round = 0; round < most; ++round) {
        ++counts.rounds;
        answer = at.solve(centres.at(), *answer, counts);
        if (!answer)
            break;
        const double faulty = violation(a, b, laws, *answer);
        const bool isOn = faulty < 0.5 * least;
        if (faulty < least) {
            best = answer;
            least = faulty;
        }
        if (least <= kept || (least <= close && !isOn))
            return best;
        centres.moveFrom(at.centresOf(answer->forces));
    }
    return least <= close ? best : std::nullopt;
}

} // namespace complementarity
