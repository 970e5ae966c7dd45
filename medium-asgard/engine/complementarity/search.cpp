#include "complementarity/search.h"

#include "complementarity/convex.h"
#include "complementarity/interior.h"
#include "complementarity/least.h"
#include "complementarity/newton.h"
#include "complementarity/pivots.h"
#include "complementarity/solve.h"
#include "complementarity/sweeps.h"

#include <Eigen/Cholesky>

#include <algorithm>

namespace complementarity {

namespace {

constexpr double nearly =
    1e-8; // a violation under this counts as none where no answer has a smaller one
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

    // As near(), or what all but keeps the laws.
    std::optional<Answer> around(const Answer& guess) {
        auto answer = near(guess.states, guess.forces);
        return answer ? answer : nearest_;
    }

    // From this one on by pulls to the last answer; or what all but keeps the laws.
    std::optional<Answer> pulledFrom(const Answer& guess) {
        auto answer = bySmallerSteps(guess.forces, guess.states);
        return answer ? answer : nearest_;
    }

    std::optional<Answer> fromNothing() {
        const Approach inside = approach(a_, b_, laws_);
        work_.steps = inside.steps;
        if (auto answer = near(inside.states, inside.forces))
            return answer;
        if (nearestFault_ <= hardly)
            return nearest_;
        if (const auto corner = byPivots(a_, b_, laws_)) {
            if (auto answer = near(corner->states, corner->forces))
                return answer;
            keep(*corner, violation(a_, b_, laws_, *corner));
            if (nearest_) // the laws themselves err by as much: no other way finds a better one
                return nearest_;
        }
        if (auto answer = bySmallerSteps(inside.forces, inside.states))
            return answer;
        // Slips make A unsymmetric. Then there may be no forces, and the slips jam; forces that
        // sweeps find there last for microseconds.
        if (nearestFault_ > hardly && isSymmetric(a_))
            if (auto answer = bySweeps())
                return answer;
        return nearest_;
    }

private:
    std::optional<Answer> near(States states, const Vector& forces, Aim aim) {
        constexpr int most = 20, patience = 5; // rounds, and those since the best one
        std::optional<Answer> best;
        std::vector<States> tried;
        double least = kept, leastFault = unbounded;
        for (int round = 0, inVain = 0; round < most && inVain < patience; ++round, ++inVain) {
            ++work_.tries;
            const std::optional<Answer> answer = solveStates(a_, b_, laws_, states, forces, aim);
            if (!answer)
                break;
            const double faulty = violation(a_, b_, laws_, *answer);
            keep(*answer, faulty);
            if (faulty < 0.5 * leastFault) {
                leastFault = faulty;
                inVain = 0;
            }
            if (faulty <= least) {
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

    void keep(const Answer& answer, double faulty) {
        if (faulty > nearestFault_)
            return;
        nearest_ = answer;
        nearestFault_ = faulty;
    }

    // Bodies that jam, as dominoes that lean on each other, have many answers that are all but
    // alike, and the states of one lead to another. A pull towards the last answer leaves one of
    // them; the pull fades (the proximal point method; Rockafellar, SIAM Journal on Control and
    // Optimization 14, 1976). Faces with a tilt leave a violation that no pull makes smaller.
    std::optional<Answer> bySmallerSteps(Vector forces, States states) {
        constexpr double strongest = 1, weakest = 1e-9, less = 0.1, more = 10;
        constexpr int most = 60, patience = 3; // steps, and those since the violation was halved
        double pull = 1e-3, least = unbounded;
        for (int step = 0, inVain = 0; step < most && pull <= strongest; ++step) {
            ++work_.pulls;
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
            const double faulty = violation(a_, b_, laws_, *answer);
            keep(*answer, faulty);
            if (faulty <= kept)
                return answer;
            inVain = faulty < 0.5 * least ? 0 : inVain + 1;
            least = std::min(least, faulty);
            if (inVain >= patience && nearestFault_ <= hardly)
                return nearest_;
            pull = std::max(weakest, less * pull);
        }
        return std::nullopt;
    }

    // Each law in turn, with the forces of the others as they are. A little on the diagonal leads
    // redundant laws to short forces. The states do not always tell the forces, as with many bodies
    // at the limit of sticking: then the sweeps' own forces count, if they settle.
    std::optional<Answer> bySweeps() {
        constexpr int most = 4096;
        const Matrix firm = a_ + 1e-10 * Matrix(a_.diagonal().asDiagonal());
        Vector forces = Vector::Zero(b_.size());
        for (int next = 16; work_.sweeps < most; next *= 4) {
            const double change = sweepOn(firm, next, forces);
            if (auto answer = near(statesOf(firm, b_, laws_, forces), forces))
                return answer;
            if (nearestFault_ <= hardly || !(change > 1e-15 * forces.cwiseAbs().maxCoeff()))
                break;
        }
        const auto isWanted = [&] {
            return nearestFault_ > hardly && work_.sweeps < most && forces.allFinite();
        };
        for (int next = work_.sweeps + 16; isWanted(); next *= 2) {
            sweepOn(a_, next, forces);
            const Answer swept{forces, a_ * forces + b_, statesOf(a_, b_, laws_, forces)};
            const double faulty = violation(a_, b_, laws_, swept);
            if (faulty <= kept)
                return swept;
            keep(swept, faulty);
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
    // Of those that keep the laws but for what faces that are all but parallel leave of them.
    std::optional<Answer> nearest_;
    double nearestFault_ = nearly;
};

bool isOther(const Answer& answer, const std::vector<Answer>& found) {
    return std::ranges::none_of(found, [&](const Answer& other) {
        const double size = std::max(answer.forces.norm(), other.forces.norm());
        return (answer.forces - other.forces).norm() <= 1e-9 * size;
    });
}

bool areFew(const Laws& laws) {
    const auto choices =
        std::ranges::count_if(laws, [](const Law& law) { return possibleStates(law).size() > 1; });
    return static_cast<std::size_t>(choices) <= fewLaws;
}

} // namespace

bool isConvex(const Matrix& a, const Laws& laws) {
    const double largest = a.cwiseAbs().maxCoeff();
    if (std::ranges::any_of(laws, [](const Law& law) { return law.kind != Law::Kind::interval; }) ||
        !isSymmetric(a))
        return false;
    return Eigen::LDLT<Matrix>(a).vectorD().minCoeff() >= -1e-12 * largest;
}

bool haveCentres(const Laws& laws) {
    return std::ranges::any_of(
        laws, [](const Law& law) { return law.levers.size() > 0 || law.kind == Law::Kind::slip; });
}

std::vector<Answer> everySolution(const Matrix& a, const Vector& b, const Laws& laws) {
    std::vector<Answer> found;
    if (!areFew(laws) || haveCentres(laws))
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

std::optional<Answer> around(const Matrix& a, const Vector& b, const Laws& laws,
                             const Answer& guess, Work& work) {
    return Search(a, b, laws, work).around(guess);
}

std::optional<Answer> pulledFrom(const Matrix& a, const Vector& b, const Laws& laws,
                                 const Answer& guess, Work& work) {
    return Search(a, b, laws, work).pulledFrom(guess);
}

} // namespace complementarity
