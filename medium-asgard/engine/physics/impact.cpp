#include "physics/impact.h"

#include "complementarity/by_few.h"
#include "complementarity/convex.h"
#include "geometry/patch_middle.h"

#include <Eigen/QR>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <utility>

namespace physics {

namespace {

// Surfaces that approach slower than this times the speeds that enter do not approach.
constexpr double approachThreshold = 1e-12;

// How a unit impulse along a line acts on one of its bodies.
struct Response {
    std::size_t body = 0;
    Vector linear = Vector::Zero(), angular = Vector::Zero(); // of the impulse, world axes
    double reach = 0;                                         // from the centre to the point
    Vector velocity = Vector::Zero(), angularVelocity = Vector::Zero(); // that it gives
};

Response responseOf(const std::vector<ImpactBody>& bodies, std::size_t body, const Vector& linear,
                    const Vector& angular) {
    const ImpactBody& b = bodies[body];
    return {.body = body,
            .linear = linear,
            .angular = angular,
            .velocity = b.inverseMass * linear.cwiseProduct(b.moves),
            .angularVelocity = b.inverseInertia * angular};
}

Response responseAt(const std::vector<ImpactBody>& bodies, std::size_t body, const Vector& point,
                    const Vector& direction) {
    const Vector& centre = bodies[body].centre;
    const Vector lever = point - centre;
    Vector turning = lever.cross(direction);
    // An impulse through the centre, up to rounding, turns nothing: a sphere's spin stays its own.
    if (turning.norm() <= 1e-14 * lever.norm() + 1e-15 * (point.norm() + centre.norm()))
        turning.setZero();
    Response r = responseOf(bodies, body, direction, turning);
    r.reach = lever.norm();
    return r;
}

// Joints answer an impulse that has the effect c on their conditions by -(J W J')^+ c.
class JointResponse {
public:
    JointResponse(const std::vector<ImpactBody>& bodies, std::span<const ImpactRow> all) {
        std::ranges::copy_if(all, std::back_inserter(rows_),
                             [](const ImpactRow& row) { return !row.isStop; });
        const std::span<const ImpactRow> rows = rows_;
        const auto n = static_cast<Eigen::Index>(rows.size());
        if (n == 0)
            return;
        Eigen::MatrixXd a = Eigen::MatrixXd::Zero(n, n);
        for (Eigen::Index i = 0; i < n; ++i)
            for (Eigen::Index j = 0; j < n; ++j)
                for (const ImpactRow::Part& q : rows[static_cast<std::size_t>(j)].parts)
                    a(i, j) +=
                        effectOn(static_cast<std::size_t>(i), q.body, velocityBy(bodies[q.body], q),
                                 bodies[q.body].inverseInertia * q.angular);
        constexpr double isNone = 1e-11; // of a condition that the others say already
        Eigen::VectorXd scale = a.diagonal().cwiseSqrt().cwiseInverse();
        scale = (a.diagonal().array() > 0).select(scale, 0);
        Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> least;
        least.setThreshold(isNone);
        least.compute(scale.asDiagonal() * a * scale.asDiagonal());
        answer_ = scale.asDiagonal() * least.pseudoInverse() * scale.asDiagonal();
    }
    [[nodiscard]] bool empty() const { return rows_.empty(); }
    [[nodiscard]] Eigen::VectorXd effectOf(std::span<const Response> responses) const {
        Eigen::VectorXd effect = Eigen::VectorXd::Zero(answer_.rows());
        for (const Response& r : responses)
            for (std::size_t i = 0; i < rows_.size(); ++i)
                effect[static_cast<Eigen::Index>(i)] +=
                    effectOn(i, r.body, r.velocity, r.angularVelocity);
        return effect;
    }
    [[nodiscard]] double between(const Eigen::VectorXd& one, const Eigen::VectorXd& other) const {
        return -one.dot(answer_ * other);
    }
    void apply(const Eigen::VectorXd& effect, std::vector<ImpactBody>& bodies) const {
        const Eigen::VectorXd impulses = -(answer_ * effect);
        for (std::size_t i = 0; i < rows_.size(); ++i)
            for (const ImpactRow::Part& p : rows_[i].parts) {
                ImpactBody& body = bodies[p.body];
                const double impulse = impulses[static_cast<Eigen::Index>(i)];
                body.velocity += impulse * velocityBy(body, p);
                body.angularVelocity += impulse * (body.inverseInertia * p.angular);
            }
    }

private:
    static Vector velocityBy(const ImpactBody& body, const ImpactRow::Part& part) {
        return body.inverseMass * part.linear.cwiseProduct(body.moves);
    }
    [[nodiscard]] double effectOn(std::size_t row, std::size_t body, const Vector& velocity,
                                  const Vector& angularVelocity) const {
        double sum = 0;
        for (const ImpactRow::Part& p : rows_[row].parts)
            if (p.body == body)
                sum += p.linear.dot(velocity) + p.angular.dot(angularVelocity);
        return sum;
    }

    std::vector<ImpactRow> rows_; // that always hold
    Eigen::MatrixXd answer_;
};

// Along which impulses act, on each of its bodies.
struct Line {
    std::vector<Response> responses;
    Vector surface = Vector::Zero(); // of both, first less second, along themselves
    Eigen::VectorXd effect = {};     // of a unit impulse on the joints' conditions
};

class Round {
public:
    Round(std::vector<ImpactBody>& bodies, std::span<const ImpactContact> contacts,
          std::span<const ImpactRow> joints)
        : bodies_(bodies), contacts_(contacts), joints_(bodies, joints), blows_(contacts.size()) {
        for (const ImpactContact& c : contacts)
            addLine(between(c, c.point, c.normal));
        for (const ImpactRow& row : joints)
            if (row.isStop)
                addStop(row);
        stops_ = lines_.size() - contacts.size();
    }

    // Of the surfaces at the contact along its normal; negative: they approach.
    [[nodiscard]] double speed(std::size_t i) const { return speedAlong(lines_[i]); }
    [[nodiscard]] bool approaches(std::size_t i) const {
        double scale = 0;
        for (const Response& r : lines_[i].responses)
            scale +=
                bodies_[r.body].velocity.norm() + bodies_[r.body].angularVelocity.norm() * r.reach;
        return speed(i) < -approachThreshold * scale;
    }
    [[nodiscard]] double fastest(std::span<const std::size_t> approaching) const {
        double most = 0;
        for (const std::size_t c : approaching)
            most = std::max(most, -speed(c));
        return most;
    }
    [[nodiscard]] bool canYield(std::size_t i) const { return mobility(i, i) > 0; }

    // The speed along line i that a unit impulse along line j adds.
    [[nodiscard]] double mobility(std::size_t i, std::size_t j) const {
        double sum = 0;
        for (const Response& a : lines_[i].responses)
            for (const Response& b : lines_[j].responses)
                if (a.body == b.body)
                    sum += a.linear.dot(b.velocity) + a.angular.dot(b.angularVelocity);
        if (joints_.empty())
            return sum;
        constexpr double rounding = 1e-12; // of what joints hold altogether
        const double left = sum + joints_.between(lines_[i].effect, lines_[j].effect);
        return i == j && left <= rounding * sum ? 0 : left;
    }

    // Of the contact's next blow: none once its powers are next to nothing.
    [[nodiscard]] double restitution(std::size_t contact) const {
        constexpr double leastOfAll = 1e-3; // of the first approach
        constexpr int mostBounces = 50;     // where restitution is all but 1
        const double e = contacts_[contact].restitution;
        const int before = blows_[contact];
        return e == 1 || (before < mostBounces && std::pow(e, before) > leastOfAll * (1 + 1e-9))
                   ? e
                   : 0;
    }

    struct Impulse {
        std::size_t line = 0;
        double size = 0;
    };
    // On the chosen contacts such that each parts at its restitution or more: first those along the
    // normals, in order, then those on stops. None: there are none such. Contacts of one patch are
    // chosen one after the other.
    // `answer`: what the same contacts had with other velocities, from where the search begins,
    // then what they have; empty at first.
    [[nodiscard]] std::vector<Impulse> impulses(const std::vector<std::size_t>& chosen,
                                                double restitution,
                                                complementarity::Answer& answer) {
        std::vector<Impulse> found;
        found.reserve(3 * chosen.size() + stops_);
        for (const std::size_t c : chosen)
            found.push_back({c});
        for (std::size_t s = 0; s < stops_; ++s)
            found.push_back({contacts_.size() + s});
        complementarity::Laws laws;
        for (std::size_t k = 0; k < found.size(); ++k)
            complementarity::addUnilateral(laws);
        const std::size_t withoutFriction = found.size();
        for (std::size_t k = 0; k < chosen.size();) {
            const auto patch = patchFrom(std::span(chosen).subspan(k));
            if (const double friction = contacts_[patch[0]].friction; friction > 0) {
                const Lines along = frictionOf(patch);
                for (std::size_t i = 0; i < along.count; ++i)
                    found.push_back({along.first + i});
                complementarity::addFriction(laws, static_cast<Eigen::Index>(along.count),
                                             static_cast<Eigen::Index>(k), friction,
                                             static_cast<Eigen::Index>(patch.size()));
                laws.back().levers = along.levers;
            }
            k += patch.size();
        }
        const auto n = static_cast<Eigen::Index>(found.size());
        Eigen::MatrixXd a(n, n);
        Eigen::VectorXd b(n);
        for (Eigen::Index i = 0; i < n; ++i) {
            const std::size_t line = found[static_cast<std::size_t>(i)].line;
            b[i] = wantedOf(line, restitution);
            for (Eigen::Index j = 0; j < n; ++j)
                a(i, j) = mobility(line, found[static_cast<std::size_t>(j)].line);
        }
        const bool hasFriction = found.size() > withoutFriction;
        const auto next = hasFriction ? complementarity::solveByFew(a, b, laws, answer)
                                      : complementarity::solveConvex(a, b, laws);
        if (!next)
            return {};
        answer = *next;
        for (Eigen::Index i = 0; i < n; ++i)
            found[static_cast<std::size_t>(i)].size = answer.forces[i];
        return found;
    }
    // Of the last round with these contacts, empty if there was none: a blow that runs to and fro
    // comes back to them with the same states, but for slower bodies.
    [[nodiscard]] complementarity::Answer& lastAnswer(const std::vector<std::size_t>& chosen) {
        return answers_[chosen];
    }
    // The kinetic energy that they add.
    [[nodiscard]] double energyOf(std::span<const Impulse> impulses) const {
        double sum = 0;
        for (const Impulse& one : impulses) {
            sum += one.size * speed(one.line);
            for (const Impulse& other : impulses)
                sum += one.size * mobility(one.line, other.line) * other.size / 2;
        }
        return sum;
    }

    void apply(const Impulse& impulse) {
        const Line& line = lines_[impulse.line];
        if (impulse.line < contacts_.size() && impulse.size > 0)
            ++blows_[impulse.line];
        for (const Response& r : line.responses) {
            bodies_[r.body].velocity += impulse.size * r.velocity;
            bodies_[r.body].angularVelocity += impulse.size * r.angularVelocity;
        }
        if (!joints_.empty())
            joints_.apply(impulse.size * line.effect, bodies_);
    }

private:
    // `part`: of the restitution that counts.
    [[nodiscard]] double wantedOf(std::size_t line, double part) const {
        if (line < contacts_.size())
            return (1 + part * restitution(line)) * speed(line);
        const Line& of = lines_[line];
        return speedAlong(of) + of.responses[0].linear.dot(of.surface);
    }
    [[nodiscard]] Line between(const ImpactContact& c, const Vector& point,
                               const Vector& direction) const {
        return {.responses = {responseAt(bodies_, c.first, point, direction),
                              responseAt(bodies_, c.second, point, -direction)}};
    }
    void addLine(Line line) {
        if (!joints_.empty())
            line.effect = joints_.effectOf(line.responses);
        lines_.push_back(std::move(line));
    }
    void addStop(const ImpactRow& row) {
        Line line;
        for (const ImpactRow::Part& part : row.parts)
            line.responses.push_back(responseOf(bodies_, part.body, part.linear, part.angular));
        addLine(std::move(line));
    }

    // The first of these contacts, and those after it that are of its patch.
    [[nodiscard]] std::span<const std::size_t>
    patchFrom(std::span<const std::size_t> chosen) const {
        const auto patch = contacts_[chosen[0]].patch;
        std::size_t count = 1;
        while (patch && count < chosen.size() && contacts_[chosen[count]].patch == patch)
            ++count;
        return chosen.first(count);
    }
    struct Lines {
        std::size_t first = 0, count = 0;
        Eigen::MatrixXd levers = {}; // complementarity/laws.h
    };
    // Two along the surfaces at the middle of these contacts, and one about their normal.
    Lines frictionOf(std::span<const std::size_t> patch) {
        const auto [place, isNew] = frictions_.try_emplace({patch.begin(), patch.end()});
        Lines& lines = place->second;
        if (!isNew)
            return lines;
        const ImpactContact& c = contacts_[patch[0]];
        std::vector<Vector> points;
        for (const std::size_t contact : patch)
            points.push_back(contacts_[contact].point);
        const geometry::PatchMiddle middle = geometry::middleOf(points, c.normal);
        lines = {.first = lines_.size(), .count = middle.reach > 0 ? 3u : 2u};
        const Vector across = acrossOf(c.normal);
        const std::array<Vector, 2> directions{c.normal.cross(across), across};
        for (const Vector& direction : directions) {
            Line line = between(c, middle.centre, direction);
            line.surface = c.surface;
            addLine(std::move(line));
        }
        const Vector turning = middle.reach * c.normal;
        if (lines.count < 3)
            return lines;
        addLine({.responses = {responseOf(bodies_, c.first, Vector::Zero(), turning),
                               responseOf(bodies_, c.second, Vector::Zero(), -turning)}});
        lines.levers.resize(2, static_cast<Eigen::Index>(points.size()));
        for (std::size_t k = 0; k < points.size(); ++k) {
            const Vector moves = c.normal.cross(points[k] - middle.centre) / middle.reach;
            for (std::size_t i = 0; i < 2; ++i)
                lines.levers(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k)) =
                    directions[i].dot(moves);
        }
        return lines;
    }
    // An axis of the world as nearly across as there is, made perpendicular.
    static Vector acrossOf(const Vector& normal) {
        int best = 2;
        for (const int axis : {1, 0})
            if (std::abs(normal[axis]) < std::abs(normal[best]) - 1e-9)
                best = axis;
        const Vector axis = Vector::Unit(best);
        return (axis - normal * normal.dot(axis)).normalized();
    }
    [[nodiscard]] double speedAlong(const Line& line) const {
        double sum = 0;
        for (const Response& r : line.responses)
            sum += r.linear.dot(bodies_[r.body].velocity) +
                   r.angular.dot(bodies_[r.body].angularVelocity);
        return sum;
    }

    std::vector<ImpactBody>& bodies_;
    std::span<const ImpactContact> contacts_;
    JointResponse joints_;
    std::vector<Line> lines_; // of the contacts' normals, then of stops, then of friction
    std::size_t stops_ = 0;
    std::map<std::vector<std::size_t>, Lines> frictions_; // by the contacts of a patch
    std::vector<int> blows_;                              // that a contact has had
    std::map<std::vector<std::size_t>, complementarity::Answer> answers_; // by the contacts
};

// What approaches so much slower than the fastest is at relative rest, but for rounding and, of
// what goes side by side, what forces do to it: it takes part when the blow has reached it.
void leaveTheSlow(const Round& round, std::span<const ImpactContact> contacts,
                  std::vector<std::size_t>& approaching) {
    constexpr double atRest = 1e-9, atRestBeside = 1e-2;
    const double fastest = round.fastest(approaching);
    std::erase_if(approaching, [&](std::size_t c) {
        return !contacts[c].isPressed &&
               -round.speed(c) < (contacts[c].isBeside ? atRestBeside : atRest) * fastest;
    });
}

// A blow without any bounce reaches all contacts without bounce at once: one after the other, the
// impulses of the later ones would part the earlier ones again. False: some contact has a bounce.
bool joinInelastic(const Round& round, const std::vector<std::size_t>& yielding,
                   std::vector<std::size_t>& chosen) {
    const auto isInelastic = [&](std::size_t c) { return round.restitution(c) == 0; };
    if (!std::ranges::all_of(chosen, isInelastic))
        return false;
    chosen.clear();
    std::ranges::copy_if(yielding, std::back_inserter(chosen), isInelastic);
    return true;
}

bool takesPart(const Round& round, const ImpactContact& contact, std::size_t c, bool isFirst) {
    if (isFirst && contact.isPressed)
        return true;
    return round.approaches(c) && !(isFirst && contact.isResting);
}

// With restitutions that add no energy, by the common factor (in 0 to 1) at which it stays the
// same: the rule of false position, after Illinois.
std::vector<Round::Impulse> withoutGain(Round& round, const std::vector<std::size_t>& chosen,
                                        std::vector<Round::Impulse> impulses,
                                        complementarity::Answer& answer, ImpactResult& result) {
    constexpr double rounding = 1e-12, unknown = std::numeric_limits<double>::infinity();
    double scale = 0;
    for (const Round::Impulse& impulse : impulses)
        scale += std::abs(impulse.size * round.mobility(impulse.line, impulse.line) * impulse.size);
    if (!(round.energyOf(impulses) > rounding * scale))
        return impulses;
    result.loweredRestitution = true;
    double low = 0, high = 1, gained = round.energyOf(impulses);
    impulses = round.impulses(chosen, 0, answer);
    if (impulses.empty())
        return impulses;
    double lost = -round.energyOf(impulses);
    int onSide = 0; // how often the same end moved
    for (int i = 0; i < 60 && lost > rounding * scale; ++i) {
        const double part = gained < unknown ? lost / (lost + gained) : 0.5;
        const double factor = low + std::clamp(part, 1e-3, 1 - 1e-3) * (high - low);
        auto tried = round.impulses(chosen, factor, answer);
        const double energy = tried.empty() ? unknown : round.energyOf(tried);
        if (energy > rounding * scale) {
            onSide = std::max(onSide, 0) + 1;
            high = factor;
            gained = energy;
            if (onSide > 1)
                lost /= 2;
        } else {
            onSide = std::min(onSide, 0) - 1;
            low = factor;
            lost = -energy;
            impulses = std::move(tried);
            if (onSide < -1)
                gained /= 2;
        }
    }
    return impulses;
}

// Gives the impulses to the chosen contacts. False when there are none that part them.
bool solveTogether(Round& round, std::span<const ImpactContact> contacts,
                   const std::vector<std::size_t>& chosen, bool plastic, ImpactResult& result) {
    complementarity::Answer& answer = round.lastAnswer(chosen);
    std::vector<Round::Impulse> impulses = round.impulses(chosen, plastic ? 0 : 1, answer);
    if (impulses.empty())
        return false;
    const bool isDriven =
        std::ranges::any_of(chosen, [&](std::size_t c) { return !contacts[c].surface.isZero(0); });
    const bool mayGain =
        std::ranges::any_of(chosen, [&](std::size_t c) { return contacts[c].friction > 0; }) &&
        std::ranges::any_of(chosen, [&](std::size_t c) { return round.restitution(c) > 0; });
    if (!plastic && !isDriven && mayGain)
        impulses = withoutGain(round, chosen, std::move(impulses), answer, result);
    if (impulses.empty())
        return false;
    for (std::size_t i = 0; i < impulses.size(); ++i)
        if (impulses[i].size != 0)
            round.apply(impulses[i]);
    for (std::size_t i = 0; i < chosen.size(); ++i)
        if (impulses[i].size > 0)
            result.impulses.push_back({chosen[i], impulses[i].size});
    return true;
}

} // namespace

ImpactResult resolveImpact(std::vector<ImpactBody> bodies, std::span<const ImpactContact> contacts,
                           std::span<const ImpactRow> joints) {
    ImpactResult result;
    result.bodies = std::move(bodies);
    Round round(result.bodies, contacts, joints);
    std::vector<std::size_t> yielding;
    for (std::size_t i = 0; i < contacts.size(); ++i)
        if (round.canYield(i))
            yielding.push_back(i);
        else if (round.approaches(i))
            result.unyielding.push_back(i);

    // Elastic chains end after about as many rounds as there are pairs of contacts; inelastic ones
    // between walls never end, and what is left is then taken up without bounce.
    constexpr double isNothing = 1e-12; // of the first approach
    const std::size_t most = 100 + 20 * yielding.size() * yielding.size();
    std::size_t rounds = 0;
    double first = 0;
    bool wasInelastic = false, isWithoutAnswer = false;
    for (; rounds < most; ++rounds) {
        std::vector<std::size_t> approaching;
        for (std::size_t c : yielding)
            if (takesPart(round, contacts[c], c, rounds == 0))
                approaching.push_back(c);
        if (approaching.empty() && rounds == 0)
            continue;
        if (approaching.empty())
            return result;
        const double fastest = round.fastest(approaching);
        first = std::max(first, fastest);
        if (fastest < isNothing * first)
            break;
        leaveTheSlow(round, contacts, approaching);
        const bool isInelastic = joinInelastic(round, yielding, approaching);
        if (isInelastic && wasInelastic)
            break; // rounding is left
        wasInelastic = isInelastic;
        if (!solveTogether(round, contacts, approaching, false, result)) {
            isWithoutAnswer = isInelastic && approaching == yielding;
            break;
        }
    }
    result.jammed = rounds == most;
    // Without bounce on all contacts at once: a blow of these laws may have been the last round.
    result.settled = !isWithoutAnswer && solveTogether(round, contacts, yielding, true, result);
    return result;
}

} // namespace physics
