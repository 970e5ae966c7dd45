#include "run/squeezed.h"

#include "events/crushed.h"
#include "expression/tape.h"
#include "motion/body_motion.h"
#include "physics/crushing.h"
#include "physics/joint_rows.h"

#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace simulation {
namespace {

using Contact = ContactLog::Contact;

// Those in force at a time: the last entry of a body counts.
std::vector<const Contact*> inForceAt(const ContactLog& log, std::size_t bodies, double time) {
    std::vector<char> isTold(bodies, 0);
    std::vector<const Contact*> found;
    for (auto entry = log.entries().rbegin(); entry != log.entries().rend(); ++entry) {
        if ((*entry)->time > time)
            continue;
        for (const Contact& contact : (*entry)->contacts)
            if (isTold[contact.body] == 0 && isTold[contact.support] == 0)
                found.push_back(&contact);
        for (const std::size_t body : (*entry)->moving)
            isTold[body] = 1;
    }
    return found;
}

// The bodies that contacts and joints connect with those of `contacts`, at one time. Accelerations
// stand in the place of velocities: what begins to move there does so from rest.
class Squeeze {
public:
    Squeeze(const Problem& problem, const solution::Histories& histories, double time)
        : problem_(problem), histories_(histories), time_(time), joints_(problem.equations) {}

    void reach(std::vector<std::size_t> next, const std::vector<const Contact*>& contacts) {
        for (const std::size_t body : next)
            (void)placeOf(body);
        for (std::size_t i = 0; i < bodies_.size(); ++i) {
            const std::size_t body = bodies_[i];
            if (!givesWay(body))
                continue;
            for (const Contact* contact : contacts)
                if (contact->body == body || contact->support == body) {
                    (void)placeOf(contact->body);
                    (void)placeOf(contact->support);
                }
            for (const std::size_t joined : joints_.neighbours(body))
                (void)placeOf(joined);
        }
        for (const std::size_t body : bodies_)
            impacts_.push_back(impactBodyOf(body));
        for (const Contact* contact : contacts)
            if (isIn(contact->body) && isIn(contact->support))
                addPoints(*contact);
        findJoints();
    }

    // False: it is not known how the bodies begin to move.
    [[nodiscard]] bool lead() {
        Eigen::MatrixXd by = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(rows_.size()),
                                                   6 * static_cast<Eigen::Index>(bodies_.size()));
        Eigen::VectorXd led = Eigen::VectorXd::Zero(by.rows());
        for (std::size_t k = 0; k < rows_.size(); ++k) {
            const auto row = static_cast<Eigen::Index>(k);
            if (rows_[k].isStop)
                continue;
            const auto drive = driveOf(rows_[k]);
            if (!drive)
                return false;
            led[row] = *drive;
            for (const physics::ImpactRow::Part& part : rows_[k].parts) {
                const physics::ImpactBody& body = impacts_[part.body];
                led[row] += part.linear.dot(body.velocity) + part.angular.dot(body.angularVelocity);
                const auto at = 6 * static_cast<Eigen::Index>(part.body);
                if (body.inverseMass > 0)
                    by.block<1, 3>(row, at) += part.linear.cwiseProduct(body.moves).transpose();
                if (!body.inverseInertia.isZero(0))
                    by.block<1, 3>(row, at + 3) += part.angular.transpose();
            }
        }
        if (!led.allFinite() || !by.allFinite())
            return false;
        if (by.rows() > 0) {
            const Eigen::VectorXd rates =
                -Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd>(by).solve(led);
            if (!((by * rates + led).norm() <= 1e-9 * led.norm()))
                return false; // the joints contradict each other
            for (std::size_t i = 0; i < bodies_.size(); ++i) {
                const auto at = 6 * static_cast<Eigen::Index>(i);
                impacts_[i].velocity += rates.segment<3>(at);
                impacts_[i].angularVelocity += rates.segment<3>(at + 3);
            }
        }
        return isAnyLed();
    }

    [[nodiscard]] std::optional<Crushed> crushed(const std::vector<std::size_t>& ended) const {
        const physics::Crushing found = physics::crushingOf(impacts_, points_, rows_);
        const auto hasEnded = [&](std::size_t place) {
            return std::ranges::find(ended, bodies_[place]) != ended.end();
        };
        if (found.contacts.empty() || (std::ranges::none_of(found.pressed, hasEnded) &&
                                       std::ranges::none_of(found.between, hasEnded)))
            return std::nullopt;
        return crushedBy(problem_.scene, problem_.equations, found, bodies_, rows_);
    }

private:
    [[nodiscard]] bool isIn(std::size_t body) const {
        return std::ranges::find(bodies_, body) != bodies_.end();
    }
    std::size_t placeOf(std::size_t body) {
        const auto place = std::ranges::find(bodies_, body) - bodies_.begin();
        if (!isIn(body))
            bodies_.push_back(body);
        return static_cast<std::size_t>(place);
    }
    [[nodiscard]] physics::Held heldOf(std::size_t body) const {
        return physics::unyieldingAt(problem_.equations, body, time_);
    }
    [[nodiscard]] bool givesWay(std::size_t body) const {
        if (problem_.equations.bodies[body].isFixed)
            return false;
        const physics::Held held = heldOf(body);
        return !held.attitude || std::ranges::count(held.position, true) < 3;
    }
    [[nodiscard]] BodyState stateAt(std::size_t body) const {
        return stateOf((*problem_.bodies)[body], histories_, time_);
    }
    [[nodiscard]] physics::SurfacePose poseOf(std::size_t body) const {
        const BodyState state = stateAt(body);
        return {state.position, state.attitude.toRotationMatrix()};
    }

    // With the accelerations that trajectories give it from that time on.
    [[nodiscard]] physics::ImpactBody impactBodyOf(std::size_t body) const {
        const physics::BodyMotion& motion = problem_.equations.bodies[body];
        const BodyState state = stateAt(body);
        physics::ImpactBody made{.centre = state.position};
        if (motion.isFixed)
            return made;
        const physics::Held held = heldOf(body);
        const auto rateOf = [&](std::size_t of) {
            const auto& unknown =
                problem_.equations.set
                    .unknowns[motion.unknown(static_cast<physics::BodyUnknown>(of))];
            return valueOf(physics::phaseAt(unknown, time_).derivative, time_);
        };
        made.inverseMass = std::ranges::count(held.position, true) < 3 ? 1 / motion.mass.mass : 0;
        for (std::size_t i = 0; i < 3; ++i)
            if (held.position[i]) {
                made.moves[static_cast<Eigen::Index>(i)] = 0;
                made.velocity[static_cast<Eigen::Index>(i)] = rateOf(physics::dx + i);
            }
        const geometry::Matrix turn = state.attitude.toRotationMatrix();
        if (!held.attitude) {
            made.inverseInertia = turn * motion.mass.inertia.inverse() * turn.transpose();
            return made;
        }
        for (std::size_t i = 0; i < 3; ++i)
            made.angularVelocity[static_cast<Eigen::Index>(i)] = rateOf(physics::w1 + i);
        if (!motion.symbols.isSpinInWorldAxes)
            made.angularVelocity = turn * made.angularVelocity;
        return made;
    }

    // Points of the contact at which the bodies touch.
    void addPoints(const Contact& contact) {
        const physics::SurfacePose body = poseOf(contact.body), support = poseOf(contact.support);
        for (const physics::SurfaceGap& gap : contact.surfaces->gaps)
            if (const auto at = physics::nearest(gap, body, support);
                at.gap <= contact.surfaces->resolution)
                points_.push_back({.first = placeOf(contact.body),
                                   .second = placeOf(contact.support),
                                   .point = at.contact,
                                   .normal = at.normal});
    }

    void findJoints() {
        using State = physics::JointRows::State;
        const auto value = [&](std::size_t unknown) { return histories_.value(unknown, time_); };
        rows_ = joints_.rowsAt(bodies_, time_,
                               {.stateOf =
                                    [&](std::size_t body) {
                                        const BodyState s = stateAt(body);
                                        return physics::BodyValues{s.position, s.velocity,
                                                                   s.attitude, s.angularVelocity};
                                    },
                                .valueOf = value,
                                .multiplierOf =
                                    [&](std::size_t multiplier) {
                                        const double mode = value(multiplier);
                                        return mode == solution::releasedMode ? State::gone
                                               : mode == solution::heldMode   ? State::held
                                                                              : State::open;
                                    }});
    }

    // How fast the time alone changes the row's rate: that is its drive. None: that is not sure.
    [[nodiscard]] std::optional<double> driveOf(const physics::ImpactRow& row) const {
        const expression::Unknown& unknown = problem_.equations.set.unknowns[*row.multiplier];
        const auto& condition = physics::phaseAt(unknown, time_).condition;
        if (!condition || !condition->rate)
            return std::nullopt;
        const double step = 1e-5 * span();
        const double now = valueOf(*condition->rate, time_),
                     once = valueOf(*condition->rate, time_ + step) - now,
                     twice = valueOf(*condition->rate, time_ + 2 * step) - now;
        if (once == 0 && twice == 0)
            return 0;
        if (!(std::abs(twice - 2 * once) <= 0.01 * std::abs(once)))
            return std::nullopt;
        return once / step;
    }
    [[nodiscard]] double span() const { return problem_.finish() - problem_.start(); }

    [[nodiscard]] double valueOf(expression::Node node, double time) const {
        const expression::EquationSet& set = problem_.equations.set;
        std::vector<expression::Node> inputs{set.time};
        std::vector<double> values{time}, found(1);
        const auto symbols = expression::symbolsOf(set.graph, std::span(&node, 1));
        for (std::size_t u = 0; u < set.unknowns.size(); ++u)
            if (std::ranges::binary_search(symbols, set.unknowns[u].symbol)) {
                inputs.push_back(set.unknowns[u].symbol);
                values.push_back(histories_.value(u, time_));
            }
        expression::Tape::Scratch scratch;
        expression::Tape(set.graph, inputs, std::span(&node, 1)).evaluate(values, found, scratch);
        return found[0];
    }

    // By more than rounding.
    [[nodiscard]] bool isAnyLed() const {
        double most = 0, size = 0;
        for (std::size_t i = 0; i < bodies_.size(); ++i) {
            const double radius = (*problem_.bodies)[bodies_[i]].radius;
            if (std::isfinite(radius) && !problem_.equations.bodies[bodies_[i]].isFixed)
                size = std::max(size, radius);
            most = std::max(most, impacts_[i].velocity.norm());
            if (std::isfinite(radius))
                most = std::max(most, radius * impacts_[i].angularVelocity.norm());
        }
        return std::isfinite(most) && most * span() * span() > 1e-9 * size;
    }

    const Problem& problem_;
    const solution::Histories& histories_;
    double time_;
    physics::JointRows joints_;
    std::vector<std::size_t> bodies_; // of the scene
    std::vector<physics::ImpactBody> impacts_;
    std::vector<physics::ImpactContact> points_;
    std::vector<physics::ImpactRow> rows_;
};

} // namespace

std::optional<std::string> squeezedAt(const Problem& problem, const solution::Histories& histories,
                                      const ContactLog& contacts,
                                      const std::vector<std::size_t>& bodies, double time) {
    Squeeze squeeze(problem, histories, time);
    squeeze.reach(bodies, inForceAt(contacts, problem.scene.bodies.size(), time));
    if (!squeeze.lead())
        return std::nullopt;
    auto crushed = squeeze.crushed(bodies);
    if (!crushed)
        return std::nullopt;
    return std::move(crushed->sentence);
}

} // namespace simulation
