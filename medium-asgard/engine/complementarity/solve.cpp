#include "complementarity/solve.h"

#include "complementarity/convex.h"
#include "complementarity/fixed_point.h"
#include "complementarity/interior.h"
#include "complementarity/newton.h"
#include "complementarity/pivots.h"
#include "complementarity/sweeps.h"

#include <Eigen/Cholesky>

#include <algorithm>

namespace complementarity {

namespace {

constexpr double kept = 1e-11;  // a violation under this is rounding
constexpr double nearly = 1e-8; // under this it may be, where no answer keeps the laws better
constexpr double hardly = 1e-9; // under this none is looked for by the slower ways
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

    // As near(), or what all but keeps the laws.
    std::optional<Answer> around(const Answer& guess) {
        auto answer = near(guess.states, guess.forces);
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
        if (auto answer = alongSlips(inside.forces))
            return answer;
        if (auto answer = bySmallerSteps(inside))
            return answer;
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
        const std::vector<std::size_t> fast = fastDiscs(estimate);
        if (fast.empty())
            return std::nullopt;
        Laws laws = laws_;
        Answer answer{estimate, a_ * estimate + b_, {}};
        for (int round = 0; round < most; ++round) {
            for (const std::size_t k : fast) {
                laws[k].kind = Law::Kind::slip;
                laws[k].velocity = answer.rates.segment(laws[k].first, laws[k].rows);
                laws[k].beside.setZero(laws[k].rows);
            }
            Work work;
            auto next = complementarity::solve(a_, b_, laws, answer, &work);
            work_.steps += work.steps;
            work_.sweeps += work.sweeps;
            work_.tries += work.tries;
            if (!next || violation(a_, b_, laws_, *next) <= kept)
                return next;
            answer = std::move(*next);
        }
        return std::nullopt;
    }

    [[nodiscard]] std::vector<std::size_t> fastDiscs(const Vector& estimate) const {
        constexpr double fast = 10; // times what the forces change
        const Vector change = a_ * estimate;
        std::vector<std::size_t> discs;
        for (std::size_t k = 0; k < laws_.size(); ++k)
            if (const Law& law = laws_[k]; law.kind == Law::Kind::disc &&
                                           b_.segment(law.first, law.rows).norm() >
                                               fast * change.segment(law.first, law.rows).norm())
                discs.push_back(k);
        return discs;
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
    // Of those that keep the laws but for what faces that are all but parallel leave of them.
    std::optional<Answer> nearest_;
    double nearestFault_ = nearly;
};

bool areFew(const Laws& laws) {
    const auto choices =
        std::ranges::count_if(laws, [](const Law& law) { return possibleStates(law).size() > 1; });
    return static_cast<std::size_t>(choices) <= fewLaws;
}

// Laws that hold at centres, or follow these.
bool haveCentres(const Laws& laws) {
    return std::ranges::any_of(
        laws, [](const Law& law) { return law.levers.size() > 0 || law.kind == Law::Kind::slip; });
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

namespace {

// Of laws without levers and slips.
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

// The same problem with the rows of discs at centres that are held. There the forces of slips are
// multiples of their normal forces, whose columns they join.
class AtCentres {
public:
    AtCentres(const Matrix& a, const Vector& b, const Laws& laws) : a_(a), b_(b), laws_(laws) {
        std::vector<Index> placeOf(static_cast<std::size_t>(b.size()), -1);
        for (const Law& law : laws)
            for (Index i = 0; i < law.rows && law.kind != Law::Kind::slip; ++i) {
                placeOf[static_cast<std::size_t>(law.first + i)] = static_cast<Index>(rows_.size());
                rows_.push_back(law.first + i);
            }
        for (const Law& law : laws)
            if (law.kind != Law::Kind::slip) {
                others_.push_back(law);
                others_.back().levers.resize(0, 0);
                others_.back().first = placeOf[static_cast<std::size_t>(law.first)];
                if (law.normal >= 0)
                    others_.back().normal = placeOf[static_cast<std::size_t>(law.normal)];
            }
    }

    // Of the laws with levers, one after the other, at these forces.
    [[nodiscard]] Vector centresOf(const Vector& forces) const {
        return eachLever([&](const Law& law) { return centreOf(law, forces); });
    }
    // How much each of these counts: as its normal forces do beside the largest. The centre of
    // forces that are next to 0 may be anywhere.
    [[nodiscard]] Vector weightsOf(const Vector& forces) const {
        const Vector pressed = eachLever([&](const Law& law) {
            const double sum = forces.segment(law.normal, law.normals).sum();
            return Vector(Vector::Constant(law.rows - 1, std::abs(sum)));
        });
        const double most = pressed.size() > 0 ? pressed.maxCoeff() : 0;
        return most > 0 ? Vector(pressed / most) : Vector(Vector::Ones(pressed.size()));
    }

    [[nodiscard]] std::optional<Answer> solve(const Vector& centres, const Answer& guess,
                                              Work& counts) const {
        Matrix a = a_;
        Vector b = b_;
        eachSlip(centres, [&](const Law& law, const Vector& centre) { join(law, centre, a, b); });
        eachDisc(centres, [&](const Law& law, const Vector& centre) {
            const Index last = law.first + law.rows - 1;
            a.middleRows(law.first, law.rows - 1) += centre * a.row(last).eval();
            b.segment(law.first, law.rows - 1) += b[last] * centre;
        });
        eachDisc(centres, [&](const Law& law, const Vector& centre) {
            const Index last = law.first + law.rows - 1;
            a.middleCols(law.first, law.rows - 1) += a.col(last).eval() * centre.transpose();
        });
        std::optional<Answer> found = Answer{};
        if (!rows_.empty())
            found =
                solveAtMiddles(a(rows_, rows_), b(rows_), others_, guessAt(centres, guess), counts);
        if (found)
            found = whole(centres, *found);
        return found;
    }

private:
    template <class Visit>
    void each(const Vector& centres, Law::Kind kind, const Visit& visit) const {
        Index first = 0;
        for (const Law& law : laws_) {
            const Index count = law.levers.size() > 0 ? law.rows - 1 : 0;
            if (law.kind == kind && count > 0)
                visit(law, Vector(centres.segment(first, count)));
            else if (law.kind == kind)
                visit(law, Vector(Vector::Zero(law.rows - 1)));
            first += count;
        }
    }
    template <class Numbers> [[nodiscard]] Vector eachLever(const Numbers& numbers) const {
        std::vector<double> all;
        for (const Law& law : laws_)
            if (law.levers.size() > 0) {
                const Vector of = numbers(law);
                all.insert(all.end(), of.begin(), of.end());
            }
        return Eigen::Map<const Vector>(all.data(), static_cast<Index>(all.size()));
    }
    template <class Visit> void eachDisc(const Vector& centres, const Visit& visit) const {
        each(centres, Law::Kind::disc, visit);
    }
    template <class Visit> void eachSlip(const Vector& centres, const Visit& visit) const {
        each(centres, Law::Kind::slip, visit);
    }

    // The force of a slip for each unit of its radius.
    [[nodiscard]] static Vector unitForce(const Law& slip, const Vector& centre) {
        return forcesFrom(centre, -directionAt(centre, slip));
    }
    void join(const Law& slip, const Vector& centre, Matrix& a, Vector& b) const {
        const auto columns = a_.middleCols(slip.first, slip.rows);
        b += slip.radius * columns * unitForce(slip, centre);
        for (Index n = 0; slip.normal >= 0 && n < slip.normals; ++n) { // each at its own point
            const Vector at = slip.levers.size() > 0 ? Vector(slip.levers.col(n)) : centre;
            const Vector force = forcesFrom(at, -directionAt(centre, slip));
            a.col(slip.normal + n) += slip.coefficient * columns * force;
        }
    }

    // Of the other laws, there.
    [[nodiscard]] Answer guessAt(const Vector& centres, const Answer& guess) const {
        Answer at;
        if (guess.forces.size() != b_.size() || guess.states.size() != laws_.size())
            return at;
        Vector forces = guess.forces;
        eachDisc(centres, [&](const Law& law, const Vector& centre) {
            forces.segment(law.first, law.rows) =
                forcesAt(centre, forces.segment(law.first, law.rows));
        });
        at.forces = forces(rows_);
        for (std::size_t k = 0; k < laws_.size(); ++k)
            if (laws_[k].kind != Law::Kind::slip)
                at.states.push_back(guess.states[k]);
        return at;
    }
    [[nodiscard]] Answer whole(const Vector& centres, const Answer& others) const {
        Answer answer{Vector::Zero(b_.size()), {}, {}};
        answer.forces(rows_) = others.forces;
        auto state = others.states.begin();
        for (const Law& law : laws_)
            answer.states.push_back(law.kind == Law::Kind::slip ? State::edge : *state++);
        eachDisc(centres, [&](const Law& law, const Vector& centre) {
            answer.forces.segment(law.first, law.rows) =
                forcesFrom(centre, answer.forces.segment(law.first, law.rows));
        });
        eachSlip(centres, [&](const Law& law, const Vector& centre) {
            answer.forces.segment(law.first, law.rows) =
                radiusOf(law, answer.forces) * unitForce(law, centre);
        });
        answer.rates = a_ * answer.forces + b_;
        return answer;
    }

    const Matrix& a_;
    const Vector& b_;
    const Laws& laws_;
    std::vector<Index> rows_; // of others than slips
    Laws others_;
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

// From centre to centre, beginning with these.
class FromCentres {
public:
    FromCentres(const Vector& start, const Answer& guess) : centres_(start), last_(guess) {}

    // Until the best round is so many rounds ago.
    std::optional<Answer> solve(int patience, const AtCentres& at, const Matrix& a, const Vector& b,
                                const Laws& laws, Work& counts) {
        constexpr double close = 1e-7; // a violation that goes on no further down: rounding is left
        for (int inVain = 0; inVain < patience && rounds_ < mostRounds && !isOver_; ++inVain) {
            ++rounds_;
            ++counts.rounds;
            const auto answer = at.solve(centres_.at(), last_, counts);
            isOver_ = !answer || centres_.at().size() == 0;
            if (!answer)
                break;
            last_ = *answer;
            const double before = least_;
            take(last_, violation(a, b, laws, last_));
            if (least_ > kept && !isOver_)
                if (const auto there = Search(a, b, laws, counts).around(last_))
                    take(*there, violation(a, b, laws, *there));
            if (least_ <= kept || (least_ <= close && least_ >= 0.5 * before))
                return best_;
            if (least_ < before)
                inVain = 0;
            if (!isOver_)
                move(at);
        }
        isOver_ = isOver_ || rounds_ == mostRounds;
        return isOver_ && least_ <= close ? std::optional(best_) : std::nullopt;
    }

private:
    void take(const Answer& answer, double faulty) {
        if (faulty >= least_)
            return;
        best_ = answer;
        least_ = faulty;
    }
    // A face that is hardly pressed keeps its centre.
    void move(const AtCentres& at) {
        constexpr double hardly = 1e-9; // beside what is pressed most
        const Vector weights = at.weightsOf(last_.forces), now = at.centresOf(last_.forces);
        centres_.moveFrom((weights.array() > hardly).select(now, centres_.at()), weights);
    }

    static constexpr int mostRounds = 60;
    FixedPoint centres_;
    Answer last_, best_;
    double least_ = unbounded;
    int rounds_ = 0;
    bool isOver_ = false; // it can find no more
};

// The forces without friction are known, and lead to those with it while it grows: each part of it
// begins at the forces of the one before.
class ByMoreFriction {
public:
    ByMoreFriction(const Matrix& a, const Vector& b, const Laws& laws, Work& counts)
        : a_(a), b_(b), laws_(laws), counts_(counts) {}

    std::optional<Answer> solve() const {
        constexpr double first = 0.25, least = 1e-4, longer = 1.5, shorter = 0.4;
        Answer last = without();
        double part = 0;
        for (double step = first; step > least;) {
            const double next = std::min(1.0, part + step);
            const Laws laws = with(next);
            const Answer from = part > 0 ? last : slipping(laws, last);
            auto found = Search(a_, b_, laws, counts_).around(from);
            step *= found ? longer : shorter;
            if (!found)
                continue;
            last = std::move(*found);
            part = next;
            if (part == 1)
                return last;
        }
        return std::nullopt;
    }

private:
    [[nodiscard]] Answer without() const {
        constexpr double none = 1e-9; // of the largest force
        Answer answer{withoutDiscs(a_, b_, laws_), {}, {}};
        answer.rates = a_ * answer.forces + b_;
        const double some = none * answer.forces.cwiseAbs().maxCoeff();
        for (const Law& law : laws_) {
            const double force = answer.forces[law.first];
            answer.states.push_back(law.kind != Law::Kind::interval ? State::edge
                                    : force <= law.low + some       ? State::low
                                    : force >= law.high - some      ? State::high
                                                                    : State::inside);
        }
        return answer;
    }
    [[nodiscard]] Laws with(double part) const {
        Laws laws = laws_;
        for (Law& law : laws) {
            law.coefficient *= part;
            law.radius *= part;
        }
        return laws;
    }
    // Each disc has its force against the rate there.
    [[nodiscard]] static Answer slipping(const Laws& laws, Answer answer) {
        for (const Law& law : laws) {
            if (law.kind == Law::Kind::interval)
                continue;
            const Vector centre = centreOf(law, answer.forces);
            const Vector way =
                law.kind == Law::Kind::slip
                    ? directionAt(centre, law)
                    : Vector(
                          ratesAt(centre, answer.rates.segment(law.first, law.rows)).normalized());
            answer.forces.segment(law.first, law.rows) =
                forcesFrom(centre, -radiusOf(law, answer.forces) * way);
        }
        return answer;
    }

    const Matrix& a_;
    const Vector& b_;
    const Laws& laws_;
    Work& counts_;
};

} // namespace

std::optional<Answer> solve(const Matrix& a, const Vector& given, const Laws& laws,
                            const Answer& guess, Work* work) {
    Work counted;
    Work& counts = work != nullptr ? *work : counted;
    counts = {};
    if (given.size() == 0)
        return Answer{};
    constexpr double none = 1e-40; // no body moves so slowly: what is left of a motion that fades
    const Vector b = (given.array().abs() > none).select(given, 0);
    if (!haveCentres(laws))
        return solveAtMiddles(a, b, laws, guess, counts);
    const AtCentres at(a, b, laws);
    const bool hasGuess = guess.forces.size() == b.size();
    const Vector start = at.centresOf(hasGuess ? guess.forces : withoutDiscs(a, b, laws));
    // The centres that forces without friction have may lie far from all answers. One start may
    // wander where another is there in a few rounds: first each has few of them.
    constexpr int few = 8, many = 60;
    std::vector<FromCentres> ways;
    for (const double part : {1.0, 0.0, -1.0, 0.5})
        if (part == 1 || !start.isZero(0))
            ways.emplace_back(part * start, guess);
    for (FromCentres& way : ways)
        if (auto found = way.solve(few, at, a, b, laws, counts))
            return found;
    if (auto found = ByMoreFriction(a, b, laws, counts).solve())
        return found;
    for (FromCentres& way : ways)
        if (auto found = way.solve(many, at, a, b, laws, counts))
            return found;
    return std::nullopt;
}

} // namespace complementarity
