#include "contacts/rest.h"

#include "contacts/bearing_rates.h"
#include "contacts/touch_constraints.h"

#include <Eigen/QR>

#include <algorithm>
#include <cmath>

namespace simulation {
namespace {

using physics::GapConstraint;

// The same edge, whichever way it runs.
bool isAlong(const Vector& a, const Vector& b) { return isOneNormal(a, b) || isOneNormal(a, -b); }

// In the frame of whichever owns the point or line that bears.
const Vector& placeOf(const GapConstraint& c) {
    return c.kind == GapConstraint::Kind::onSupportPlane ? c.bodyPoint : c.supportPoint;
}

double distanceTo(const std::vector<GapConstraint>& feature, const Vector& place) {
    const Vector start = placeOf(feature[0]);
    if (feature.size() < 2)
        return (place - start).norm();
    const Vector along = (placeOf(feature[1]) - start).normalized();
    return along.cross(place - start).norm();
}

bool isLike(const Footing& a, const Footing& b) {
    if (a.support != b.support || a.bodyPart != b.bodyPart || a.supportPart != b.supportPart ||
        a.isFlat != b.isFlat || a.constraints.size() != b.constraints.size())
        return false;
    for (std::size_t i = 0; i < a.constraints.size(); ++i) {
        const GapConstraint &p = a.constraints[i], &q = b.constraints[i];
        const bool onPlane = p.kind == GapConstraint::Kind::onSupportPlane ||
                             p.kind == GapConstraint::Kind::onBodyPlane;
        if (p.kind != q.kind || (onPlane && !isOneNormal(p.normal, q.normal)))
            return false;
        if (p.kind == GapConstraint::Kind::edgeOnEdge &&
            !(isAlong(p.bodyEdge, q.bodyEdge) && isAlong(p.supportEdge, q.supportEdge)))
            return false;
        const bool isFixedPlace = !a.isFlat && p.kind != GapConstraint::Kind::roundOnLine &&
                                  p.kind != GapConstraint::Kind::edgeOnEdge;
        if (isFixedPlace && distanceTo(a.constraints, placeOf(q)) > resolution::samePlace * a.size)
            return false;
    }
    return true;
}

// Of a Footing or a Touch.
template <class Pair> PartsInTouch partsOf(const Pair& pair) {
    return {pair.support, pair.bodyPart, pair.supportPart};
}

class Answer {
public:
    Answer(const RestQuestion& question, const ContactResolution& resolution,
           const std::vector<std::string>& names)
        : q_(question), resolution_(resolution), names_(names) {
        accelerations_ = q_.free.linear.norm() + q_.free.angular.norm() * q_.body.record->radius;
    }

    Rest find() {
        for (std::size_t s = 0; s < q_.supports.size(); ++s)
            for (Touch& touch : touchesOf(q_.body, q_.supports[s], resolution_.gap, q_.footings)) {
                const Touch* lasting = touch.lasting(slowest());
                if (lasting == nullptr || !lasting->isModelled)
                    passing_.push_back({std::move(touch), s, {}});
                else
                    touches_.push_back({*lasting, s, {}});
            }
        do
            bearWhatPresses();
        while (rest_.state != Rest::State::approaching && isPassingPressed());
        if (rest_.state == Rest::State::free) { // goes on from where it does not overlap
            for (const Candidate& candidate : touches_)
                moveOut(candidate.touch);
            for (const Candidate& candidate : passing_)
                moveOut(partingAxis(candidate.touch));
        }
        return rest_;
    }

private:
    struct Candidate {
        Touch touch;
        std::size_t support; // in the question
        std::vector<std::size_t> bearing;
    };
    struct Place {
        std::size_t touch, corner;
    };
    struct Load { // of a touch on its support
        double push = 0;
        Vector force = Vector::Zero(), torque = Vector::Zero();
        void add(double normalForce, const Vector& normal, const Vector& arm) {
            push += normalForce;
            force -= normalForce * normal;
            torque -= normalForce * arm.cross(normal);
        }
    };

    void bearWhatPresses() {
        corners_.clear();
        for (Candidate& candidate : touches_)
            candidate.bearing.clear();
        rest_ = {};
        given_.linear = q_.free.linear;
        given_.angular = q_.free.angular;
        gather();
        if (rest_.state != Rest::State::approaching && !corners_.empty())
            bear();
    }

    // Parts that touch along several axes press only where they do along each: then along the
    // first of these they take part.
    [[nodiscard]] bool isPassingPressed() {
        const auto pressed = std::ranges::find_if(passing_, [&](const Candidate& candidate) {
            const Touch& touch = candidate.touch;
            return !staysOpen(touch) && std::ranges::none_of(touch.others, [&](const Touch& other) {
                return staysOpen(other);
            });
        });
        if (pressed == passing_.end())
            return false;
        touches_.push_back(std::move(*pressed));
        passing_.erase(pressed);
        return true;
    }

    // Along its axis it does not approach, nor will it, as far as known.
    [[nodiscard]] bool staysOpen(const Touch& touch) const {
        return std::ranges::all_of(touch.corners, [&](const Corner& corner) {
            const Vector arm = corner.point - q_.mobility.centre;
            const double acceleration =
                touch.normal.dot(given_.linear + given_.angular.cross(arm)) + corner.extra;
            return corner.rate > slowest() ||
                   (corner.rate >= -slowest() &&
                    acceleration >= -resolution::stillBearing * accelerations_);
        });
    }

    [[nodiscard]] double slow() const { return slowFor(resolution_.hopHeight); }
    [[nodiscard]] double slowFor(double hopHeight) const {
        return std::sqrt(2 * accelerations_ * hopHeight * q_.body.record->radius);
    }

    // Slower than this nothing parts or approaches.
    [[nodiscard]] double slowest() const {
        return slow() +
               resolution::atRest * (q_.body.state.velocity.norm() +
                                     q_.body.state.angularVelocity.norm() * q_.body.record->radius);
    }

    [[nodiscard]] bool isFooting(const Touch& touch) const {
        return std::ranges::find(q_.footings, partsOf(touch)) != q_.footings.end();
    }

    // A ball that rolls up to an edge ahead touches that before it is there, and without
    // approaching when it is: what bore it until then, or is hit, counts so far, and not the edge's
    // slanting normal.
    [[nodiscard]] bool isYetToCome(const Touch& touch, double rate) const {
        const double speed = q_.body.state.velocity.norm() +
                             q_.body.state.angularVelocity.norm() * q_.body.record->radius;
        return !isFooting(touch) && rate < -resolution_.gap * speed - 1e-6 * slow();
    }

    // Faster than this a corner parts. A hop of a ball off what it rests on that is lower than what
    // it may sink in there unnoticed is none: in a groove, off the one wall that it slides on when
    // it meets the other, such hops would follow each other without end, each put back.
    [[nodiscard]] double slowestParting(const Touch& touch) const {
        return touch.round.isBall && isFooting(touch)
                   ? std::max(slowest(), slowFor(2 * resolution_.gap))
                   : slowest();
    }

    // Corners that neither part nor approach.
    void gather() {
        for (std::size_t t = 0; t < touches_.size(); ++t) {
            const Touch& touch = touches_[t].touch;
            const double most = slowest();
            for (std::size_t i = 0; i < touch.corners.size(); ++i) {
                const double rate = touch.corners[i].rate, gap = touch.corners[i].gap;
                if (touch.round.isOnEdge && isYetToCome(touch, rate))
                    continue;
                if (rate < -most && gap > resolution::landed * touch.size)
                    continue;
                const bool sinks =
                    gap < -resolution_.gap * touch.size && rate < 0 && isFooting(touch);
                if (rate < -most || sinks) {
                    if (!isFooting(touch))
                        continue;
                    rest_.state = Rest::State::approaching;
                    rest_.partner = touch.support;
                } else if (rate <= slowestParting(touch)) {
                    corners_.push_back({t, i});
                }
            }
        }
    }

    void bear() {
        std::vector<physics::RestingContact> contacts;
        for (const Place& place : corners_) {
            const Touch& touch = touches_[place.touch].touch;
            const Corner& corner = touch.corners[place.corner];
            contacts.push_back(
                {.point = corner.point, .normal = touch.normal, .extraAcceleration = corner.extra});
            accelerations_ = std::max(accelerations_, std::abs(corner.extra));
        }
        const physics::RestingForces forces =
            physics::restingForces(q_.mobility, q_.free.linear, q_.free.angular, contacts);
        given_.linear = forces.acceleration;
        given_.angular = forces.angularAcceleration;
        std::vector<Load> loads(touches_.size());
        for (std::size_t i = 0; i < corners_.size(); ++i) {
            Candidate& touched = touches_[corners_[i].touch];
            loads[corners_[i].touch].add(forces.normalForces[i], touched.touch.normal,
                                         contacts[i].point -
                                             q_.supportMobility[touched.support].centre);
            if (forces.gapAccelerations[i] <= resolution::stillBearing * accelerations_)
                touched.bearing.push_back(corners_[i].corner);
        }
        const double floor = resolution::leastPush * q_.body.record->radius;
        const double weak = std::max(resolution::weakPush * accelerations_, floor);
        for (std::size_t t = 0; t < touches_.size(); ++t) {
            const bool isFree = givesWay(touches_[t].support);
            const double least = isFree ? weak : resolution::isNoLoad * accelerations_;
            if (loads[t].push * q_.mobility.inverseMass > least && !touches_[t].bearing.empty())
                addFooting(touches_[t], loads[t]);
        }
        if (rest_.state == Rest::State::bearing)
            putBack();
    }

    [[nodiscard]] bool givesWay(std::size_t support) const { // along all axes
        const physics::ImpactBody& mobility = q_.supportMobility[support];
        return mobility.inverseMass > 0 && mobility.moves.minCoeff() > 0;
    }

    // A support that is held in part, as a bar at its centre, bears what does not move it: the
    // model of rest has the forces of one body only.
    [[nodiscard]] bool isMovedBy(std::size_t support, const Load& load) const {
        const physics::ImpactBody& mobility = q_.supportMobility[support];
        const double linear = mobility.inverseMass * load.force.cwiseProduct(mobility.moves).norm();
        const double angular = (mobility.inverseInertia * load.torque).norm();
        return linear + angular * q_.supports[support].record->radius >
               resolution::unmoved * accelerations_;
    }

    void addFooting(const Candidate& candidate, const Load& load) {
        const Touch& touch = candidate.touch;
        const Placed& support = q_.supports[candidate.support];
        if (givesWay(candidate.support))
            return refuse(touch, "come to rest on each other, which is modelled only where one of "
                                 "them is fixed or held");
        if (isMovedBy(candidate.support, load))
            return refuse(touch, "come to rest on each other, and \"" + names_[touch.support] +
                                     "\", which is held in part only, would give way under the "
                                     "load, which is not modelled; hold its rotation, too "
                                     "(constrain -rot), or all of its position");
        const bool isOnRim = touch.round.isCurved && touch.isFlat && !touch.corners.empty() &&
                             candidate.bearing.size() < 3;
        if (isOnRim || (!touch.isModelled && touch.round.isCurved))
            return refuse(touch, "come to rest on each other with a round side, rim or tip, which "
                                 "is not modelled");
        if (!touch.isModelled)
            return refuse(touch, "rest on each other with edges or vertices only, which is not "
                                 "modelled");
        Footing footing{.support = touch.support,
                        .bodyPart = touch.bodyPart,
                        .supportPart = touch.supportPart,
                        .isFlat = touch.isFlat && candidate.bearing.size() > 2,
                        .size = touch.size,
                        .constraints = constraintsOf(touch, candidate.bearing, q_.body, support)};
        rest_.footings.push_back(std::move(footing));
        if (rest_.state == Rest::State::free)
            rest_.state = Rest::State::bearing;
    }

    // Corners that a touch has sunk in at.
    static std::vector<std::size_t> overlapping(const Touch& touch) {
        std::vector<std::size_t> sunk;
        for (std::size_t i = 0; i < touch.corners.size(); ++i)
            if (touch.corners[i].gap < 0)
                sunk.push_back(i);
        return sunk;
    }

    // A constraint keeps the second derivative of its gap; what the integration errs in all that
    // bear is put right at once, and so is what has sunk in and does not bear. Impulses that would
    // do it in a unit of time are the multipliers.
    void putBack() {
        std::vector<const Corner*> corners;
        std::vector<Vector> normals;
        for (const Candidate& candidate : touches_) {
            const Touch& touch = candidate.touch;
            const bool isBearing = std::ranges::any_of(rest_.footings, [&](const Footing& footing) {
                return partsOf(footing) == partsOf(touch);
            });
            for (const std::size_t i : isBearing ? candidate.bearing : overlapping(touch)) {
                corners.push_back(&touch.corners[i]);
                normals.push_back(touch.normal);
                if (isBearing && std::abs(touch.corners[i].gap) >
                                     resolution::putBackAt * resolution_.gap * touch.size)
                    rest_.state = Rest::State::drifted;
            }
        }
        const auto n = static_cast<Eigen::Index>(corners.size());
        Eigen::MatrixXd rows(n, 3), turning(n, 3);
        Eigen::VectorXd gaps(n);
        for (Eigen::Index i = 0; i < n; ++i) {
            const auto k = static_cast<std::size_t>(i);
            rows.row(i) = normals[k];
            turning.row(i) = (corners[k]->point - q_.mobility.centre).cross(normals[k]);
            gaps[i] = corners[k]->gap;
        }
        const Eigen::MatrixXd moving = rows * q_.mobility.moves.asDiagonal();
        const Eigen::MatrixXd mobility = q_.mobility.inverseMass * moving * moving.transpose() +
                                         turning * q_.mobility.inverseInertia * turning.transpose();
        Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> solver(n, n);
        solver.setThreshold(1e-9); // corners of a face are more than its three freedoms
        const Eigen::VectorXd impulses = solver.compute(mobility).solve(-gaps);
        rest_.correction = withoutRounding(q_.mobility.inverseMass * moving.transpose() * impulses);
        rest_.turn = withoutRounding(q_.mobility.inverseInertia * (turning.transpose() * impulses));
    }

    // Of the axes of a touch that along which they part fastest.
    static const Touch& partingAxis(const Touch& touch) {
        const Touch* fastest = &touch;
        for (const Touch& other : touch.others)
            if (other.rate() > fastest->rate())
                fastest = &other;
        return *fastest;
    }

    // To where it does not overlap.
    void moveOut(const Touch& touch) {
        const double gap = touch.gap + touch.normal.dot(rest_.correction);
        if (gap < 0)
            rest_.correction -= touch.normal * gap;
    }

    void refuse(const Touch& touch, const std::string& why) {
        rest_.state = Rest::State::unmodelled;
        rest_.partner = touch.support;
        rest_.sentence =
            "bodies \"" + names_[q_.body.index] + "\" and \"" + names_[touch.support] + "\" " + why;
    }

    const RestQuestion& q_;
    const ContactResolution& resolution_;
    const std::vector<std::string>& names_;
    double accelerations_ = 0; // that enter
    std::vector<Candidate> touches_;
    std::vector<Candidate> passing_; // that may stay apart along an axis
    Acceleration given_;             // with the forces of what bears
    std::vector<Place> corners_;
    Rest rest_;
};

} // namespace

bool Rest::bearsLike(const Rest& other) const {
    return footings.size() == other.footings.size() &&
           std::equal(footings.begin(), footings.end(), other.footings.begin(), isLike);
}

Rest restOf(const RestQuestion& question, const ContactResolution& resolution,
            const std::vector<std::string>& names) {
    return Answer(question, resolution, names).find();
}

} // namespace simulation
