#include "complementarity/centres.h"

#include "complementarity/convex.h"
#include "complementarity/fixed_point.h"
#include "complementarity/least.h"
#include "complementarity/newton.h"
#include "complementarity/search.h"
#include "complementarity/together.h"
#include "complementarity/widened.h"

#include <algorithm>

namespace complementarity {

namespace {

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

    // Of the other laws, with these centres.
    struct Problem {
        Matrix a;
        Vector b;
    };
    [[nodiscard]] Problem problemAt(const Vector& centres) const {
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
        return {a(rows_, rows_), b(rows_)};
    }
    [[nodiscard]] const Laws& others() const { return others_; }

    [[nodiscard]] std::optional<Answer> solve(const Vector& centres, const Answer& guess,
                                              Work& counts) const {
        const auto [a, b] = problemAt(centres);
        std::optional<Answer> found = Answer{};
        if (!rows_.empty())
            found = solveAtMiddles(a, b, others_, guessAt(centres, guess), counts);
        if (found)
            found = whole(centres, *found);
        return found;
    }

    // At the centres of these forces, with a pull to them.
    [[nodiscard]] Answer pulledTo(const Answer& last, double pull, Work& counts) const {
        const Vector centres = centresOf(last.forces);
        auto [a, b] = problemAt(centres);
        const Vector firm = pull * a.diagonal().cwiseAbs();
        b -= firm.cwiseProduct(guessAt(centres, last).forces);
        a.diagonal() += firm;
        const Approach inside = approachTogether(a, b, others_);
        counts.steps += inside.steps;
        return whole(centres, endOf(a, b, others_, inside));
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

// From the end of a path on which centres follow. Then rounds at the centres of the last one: a
// pull holds the forces where they were, so that a wall keeps the way in which its bricks share
// them, and what is wrong falls many times a round. Faces with a tilt leave forces no rest: the
// pull grows.
class FromTogether {
public:
    FromTogether(const AtCentres& at, const Matrix& a, const Vector& b, const Laws& laws,
                 Work& counts)
        : at_(at), a_(a), b_(b), laws_(laws), counts_(counts) {}

    std::optional<Answer> solve() {
        constexpr int most = 12;
        constexpr double weakest = 1e-3, strongest = 1, more = 10, half = 0.5;
        const Approach inside = approachTogether(a_, b_, laws_);
        counts_.steps += inside.steps;
        Answer last = endOf(a_, b_, laws_, inside);
        take(last);
        if (isExact(around(a_, b_, laws_, last, counts_)))
            return exact_;
        if (least_ == unbounded) // the path has no number
            return std::nullopt;
        double pull = weakest;
        for (int round = 0; round < most && pull <= strongest && least_ > hardly; ++round) {
            ++counts_.pulls;
            last = at_.pulledTo(last, pull, counts_);
            const double before = least_;
            take(last);
            if (least_ > half * before)
                pull *= more;
        }
        if (isExact(around(a_, b_, laws_, best_, counts_)) ||
            isExact(pulledFrom(a_, b_, laws_, best_, counts_)))
            return exact_;
        return std::nullopt;
    }

private:
    void take(const Answer& answer) {
        const double faulty = violation(a_, b_, laws_, answer);
        if (!(faulty < least_))
            return;
        best_ = answer;
        least_ = faulty;
    }
    [[nodiscard]] bool isExact(std::optional<Answer> answer) {
        exact_ = std::move(answer);
        return exact_ && violation(a_, b_, laws_, *exact_) <= hardly;
    }

    const AtCentres& at_;
    const Matrix& a_;
    const Vector& b_;
    const Laws& laws_;
    Work& counts_;
    Answer best_ = {};
    std::optional<Answer> exact_ = {};
    double least_ = unbounded;
};

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
                if (const auto there = around(a, b, laws, last_, counts))
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

    // From the best of these rounds on, at the answers' own centres.
    std::optional<Answer> pulled(const Matrix& a, const Vector& b, const Laws& laws, Work& counts) {
        if (best_.forces.size() == 0)
            return std::nullopt;
        if (const auto answer = pulledFrom(a, b, laws, best_, counts))
            take(*answer, violation(a, b, laws, *answer));
        return least_ <= hardly ? std::optional(best_) : std::nullopt;
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

    static constexpr int mostRounds = 30;
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
            auto found = around(a_, b_, laws, from, counts_);
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

std::optional<Answer> solveFromCentres(const Matrix& a, const Vector& b, const Laws& laws,
                                       const Answer& guess, Work& counts) {
    const AtCentres at(a, b, laws);
    const bool hasGuess = guess.forces.size() == b.size();
    if (hasGuess && guess.states.size() == laws.size())
        if (auto found = around(a, b, laws, guess, counts);
            found && violation(a, b, laws, *found) <= hardly)
            return found;
    if (!at.others().empty())
        if (auto found = FromTogether(at, a, b, laws, counts).solve())
            return found;
    const Vector start = at.centresOf(hasGuess ? guess.forces : withoutDiscs(a, b, laws));
    // The centres that forces without friction have may lie far from all answers. One start may
    // wander where another is there in a few rounds: first each has few of them.
    constexpr int few = 8, many = 20;
    std::vector<FromCentres> ways;
    for (const double part : {1.0, 0.0, -1.0, 0.5})
        if (part == 1 || !start.isZero(0))
            ways.emplace_back(part * start, guess);
    for (FromCentres& way : ways) {
        if (auto found = way.solve(few, at, a, b, laws, counts))
            return found;
        if (auto found = way.pulled(a, b, laws, counts))
            return found;
    }
    if (auto found = ByMoreFriction(a, b, laws, counts).solve())
        return found;
    for (FromCentres& way : ways)
        if (auto found = way.solve(many, at, a, b, laws, counts))
            return found;
    return std::nullopt;
}

std::optional<Answer> solveBesideCentres(const Matrix& a, const Vector& b, const Laws& laws) {
    constexpr int most = 10, mostHeld = 200; // convex problems while centres move, and then
    constexpr double settled = 1e-8, close = 1e-3, hardly = 1e-9, part = 0.5;
    const auto isSlip = [](const Law& law) { return law.kind == Law::Kind::slip; };
    if (std::ranges::any_of(laws, isSlip) || !isSymmetric(a))
        return std::nullopt;
    const AtCentres at(a, b, laws);
    Vector centres = at.centresOf(Vector::Zero(b.size())), slips;
    for (int round = 0; round < most && centres.size() > 0; ++round) {
        const auto [held, rest] = at.problemAt(centres);
        Widened widened(held, rest, at.others(), slips);
        widened.advance();
        slips = widened.slips();
        const Vector forces = at.whole(centres, widened.answer()).forces;
        const Vector ways = at.centresOf(forces) - centres;
        const Vector moves = (at.weightsOf(forces).array() > hardly).select(ways, 0);
        centres += part * moves;
        if (moves.cwiseAbs().maxCoeff() < settled)
            break;
    }
    const auto [held, rest] = at.problemAt(centres);
    Widened widened(held, rest, at.others(), slips);
    for (int k = 0; k < mostHeld && !(widened.change() < settled); ++k)
        widened.advance();
    Work counts;
    const auto exact = around(held, rest, at.others(), widened.answer(), counts);
    const Answer& answer = exact ? *exact : widened.answer();
    if (!(violation(held, rest, at.others(), answer) < close)) // nothing parts what jams
        return std::nullopt;
    return at.whole(centres, answer);
}

} // namespace complementarity
