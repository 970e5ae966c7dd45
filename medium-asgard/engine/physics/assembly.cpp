#include "physics/assembly.h"

#include "expression/tape.h"
#include "physics/carried_points.h"
#include "physics/equations_of_motion.h"

#include <Eigen/Geometry>
#include <Eigen/QR>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <unordered_map>
#include <utility>

namespace physics {
namespace {

constexpr double closed = 1e-13;    // of the largest radius
constexpr double unmoved = 1e-12;   // of the largest radius
constexpr double longestTurn = 0.3; // radians in one step
constexpr double isIndependent = 1e-9;

// Gaps and their derivatives by the places of the bodies that may move.
class Closing {
public:
    Closing(const scene::Scene& scene, EquationsOfMotion& equations,
            std::function<bool()> cancelled)
        : equations_(equations), start_(scene.simulator.start), cancelled_(std::move(cancelled)) {
        for (std::size_t b = 0; b < equations.bodies.size(); ++b)
            if (const BodyMotion& body = equations.bodies[b]; !body.isFixed && !isHeld(body)) {
                free_.push_back(b);
                size_ = std::max(size_, body.mass.radius);
            }
        inputs_.push_back(equations.set.time);
        values_.push_back(start_);
        for (const expression::Unknown& unknown : equations.set.unknowns) {
            inputs_.push_back(unknown.symbol);
            values_.push_back(unknown.initial);
        }
        putGiven(graph(), equations.set, start_, values_);
        findGaps();
        for (const std::size_t b : free_)
            first_.push_back(poseOf(b));
    }

    [[nodiscard]] bool close() {
        constexpr int most = 60;
        Eigen::VectorXd gaps = gapsNow();
        for (int k = 0; k < most && !isCancelled(); ++k) {
            if (largest(gaps) <= closed * size_)
                return true;
            step(jacobian_.rows() == 0 ? Eigen::VectorXd::Zero(jacobian_.cols())
                                       : Eigen::VectorXd(-solver().solve(gaps)));
            gaps = gapsNow();
        }
        return largest(gaps) <= 1e3 * closed * size_;
    }
    // Along what opens nothing, back towards where the bodies were.
    void shorten() {
        constexpr int most = 60;
        for (int k = 0; k < most && !isCancelled(); ++k) {
            const Eigen::VectorXd way = movement();
            const auto least = solver();
            const Eigen::VectorXd along = way - least.solve(Eigen::VectorXd(jacobian_ * way));
            if (!(along.norm() > 1e-9 * way.norm()))
                return;
            const std::vector<double> before = values_;
            step(-along);
            if (!close() || !(movement().norm() < way.norm())) {
                values_ = before;
                return;
            }
        }
    }
    [[nodiscard]] bool isCancelled() {
        stopped_ = stopped_ || (cancelled_ && cancelled_());
        return stopped_;
    }
    [[nodiscard]] double largestGap() { return largest(gapsNow()); }
    [[nodiscard]] std::vector<Assembly::Moved> moved() const {
        std::vector<Assembly::Moved> all;
        const Eigen::VectorXd way = movement();
        for (std::size_t i = 0; i < free_.size(); ++i) {
            const auto at = static_cast<Eigen::Index>(6 * i);
            const double shift = way.segment<3>(at).norm(), arc = way.segment<3>(at + 3).norm();
            if (!(std::max(shift, arc) > unmoved * size_))
                continue;
            geometry::Pose pose = poseOf(free_[i]);
            if (!(arc > unmoved * size_))
                pose.attitude = first_[i].attitude;
            pose.position -= pose.attitude * equations_.bodies[free_[i]].mass.centroid;
            all.push_back({free_[i], pose, std::max(shift, arc), arc > unmoved * size_});
        }
        return all;
    }

private:
    [[nodiscard]] double largest(const Eigen::VectorXd& gaps) const {
        return std::max(gaps.size() == 0 ? 0 : gaps.lpNorm<Eigen::Infinity>(),
                        tied_.size() == 0 ? 0 : tied_.lpNorm<Eigen::Infinity>());
    }
    [[nodiscard]] bool isHeld(const BodyMotion& body) const {
        const Held& held = body.heldAt(start_);
        return held.attitude || std::ranges::count(held.position, true) > 0;
    }
    // Ties first: conditions that make an unknown the angle of a joint, or what a drum has wound.
    void findGaps() {
        std::vector<Node> ties, gaps, ropes, symbols;
        std::unordered_map<std::uint32_t, Node> unturned;
        for (const std::size_t b : free_) {
            const BodySymbols& s = equations_.bodies[b].symbols;
            symbols.insert(symbols.end(), s.position.begin(), s.position.end());
            symbols.insert(symbols.end(), s.attitude.begin(), s.attitude.end());
        }
        const auto& unknowns = equations_.set.unknowns;
        for (std::size_t u = 0; u < unknowns.size(); ++u) {
            const expression::Phase& phase = phaseAt(unknowns[u], start_);
            if (!phase.condition && !phase.given && u >= afterBodies()) {
                angles_.push_back(1 + u);
                unturned.emplace(unknowns[u].symbol.index, graph().constant(unknowns[u].initial));
                symbols.push_back(unknowns[u].symbol);
            }
            if (!phase.condition || !phase.condition->gap ||
                unknowns[u].initial == expression::goneFromStart)
                continue;
            const auto& condition = *phase.condition;
            const bool isBounded = std::isfinite(condition.low) || std::isfinite(condition.high);
            (isBounded ? ropes : condition.rate ? gaps : ties).push_back(*condition.gap);
        }
        for (Node& rope : ropes) // a wheel winds nothing before the start
            rope = expression::substitute(graph(), rope, unturned);
        const std::vector<double> left = valuesOf(expression::Tape(graph(), inputs_, ropes), ropes);
        for (std::size_t k = 0; k < ropes.size(); ++k)
            if (left[k] < -unmoved * size_)
                gaps.push_back(ropes[k]); // too short
        ties_ = ties.size();
        ties.insert(ties.end(), gaps.begin(), gaps.end());
        count_ = ties.size();
        outputs_ = ties;
        const auto rows = expression::gradients(graph(), ties, symbols);
        for (std::size_t r = 0; r < rows.size(); ++r)
            for (const auto& [symbol, derivative] : rows[r]) {
                entries_.push_back({r, symbol});
                outputs_.push_back(derivative);
            }
        tape_ = expression::Tape(graph(), inputs_, outputs_);
    }
    [[nodiscard]] std::size_t afterBodies() const {
        std::size_t after = 0;
        for (const BodyMotion& body : equations_.bodies)
            if (!body.isFixed)
                after = std::max(after, body.firstUnknown + bodyUnknowns);
        return after;
    }
    [[nodiscard]] expression::Graph& graph() { return equations_.set.graph; }
    [[nodiscard]] std::vector<double> valuesOf(const expression::Tape& tape,
                                               const std::vector<Node>& nodes) {
        std::vector<double> found(nodes.size());
        expression::Tape::Scratch scratch;
        tape.evaluate(values_, found, scratch);
        return found;
    }
    [[nodiscard]] geometry::Pose poseOf(std::size_t b) const { // of the centre of mass
        const double* v = values_.data() + 1 + equations_.bodies[b].firstUnknown;
        return {Vector(v[x], v[y], v[z]), Quaternion(v[qw], v[qx], v[qy], v[qz]).normalized()};
    }

    // Gaps, and their derivatives by six of each body (a way, and an arc about the world's axes)
    // and by the angles. The angles follow the bodies and cost nothing, so the ties solve them
    // away.
    Eigen::VectorXd gapsNow() {
        const std::vector<double> all = valuesOf(tape_, outputs_);
        const auto rows = static_cast<Eigen::Index>(count_),
                   ties = static_cast<Eigen::Index>(ties_),
                   columns = static_cast<Eigen::Index>(6 * free_.size()),
                   angles = static_cast<Eigen::Index>(angles_.size());
        Eigen::MatrixXd by = Eigen::MatrixXd::Zero(rows, columns + angles);
        for (std::size_t k = 0; k < entries_.size(); ++k)
            addDerivative(by, entries_[k].first, entries_[k].second, all[count_ + k]);
        const Eigen::Map<const Eigen::VectorXd> gaps(all.data(), rows);
        tied_ = gaps.head(ties);
        jacobian_ = by.bottomLeftCorner(rows - ties, columns);
        if (ties == 0 || angles == 0)
            return gaps.tail(rows - ties);
        const Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> own(
            by.topRightCorner(ties, angles));
        anglesBy_ = own.solve(by.topLeftCorner(ties, columns));
        anglesOff_ = own.solve(tied_);
        const auto through = by.bottomRightCorner(rows - ties, angles);
        jacobian_ -= through * anglesBy_;
        return gaps.tail(rows - ties) - through * anglesOff_;
    }
    void addDerivative(Eigen::MatrixXd& by, std::size_t row, std::size_t symbol,
                       double derivative) {
        const auto r = static_cast<Eigen::Index>(row);
        if (symbol >= 7 * free_.size()) {
            by(r, static_cast<Eigen::Index>(symbol - free_.size())) += derivative;
            return;
        }
        const auto at = static_cast<Eigen::Index>(6 * (symbol / 7));
        if (symbol % 7 < 3) {
            by(r, at + static_cast<Eigen::Index>(symbol % 7)) += derivative;
            return;
        }
        const std::size_t b = free_[symbol / 7];
        const Quaternion q = poseOf(b).attitude;
        const double radius = equations_.bodies[b].mass.radius;
        for (Eigen::Index axis = 0; axis < 3; ++axis) { // q' = (0, w) q / 2
            Quaternion turn(0, 0, 0, 0);
            turn.vec()[axis] = 0.5 / radius;
            const Quaternion rate = turn * q;
            const std::array<double, 4> rates{rate.w(), rate.x(), rate.y(), rate.z()};
            by(r, at + 3 + axis) += derivative * rates[symbol % 7 - 3];
        }
    }
    [[nodiscard]] Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> solver() const {
        Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> least(jacobian_.rows(),
                                                                      jacobian_.cols());
        least.setThreshold(isIndependent);
        least.compute(jacobian_);
        return least;
    }
    void step(Eigen::VectorXd by) {
        double turn = 0;
        for (std::size_t i = 0; i < free_.size(); ++i)
            turn = std::max(turn, by.segment<3>(static_cast<Eigen::Index>(6 * i + 3)).norm() /
                                      equations_.bodies[free_[i]].mass.radius);
        if (turn > longestTurn)
            by *= longestTurn / turn;
        if (anglesOff_.size() > 0) {
            const Eigen::VectorXd angles = anglesOff_ + anglesBy_ * by;
            for (std::size_t k = 0; k < angles_.size(); ++k)
                values_[angles_[k]] -= angles[static_cast<Eigen::Index>(k)];
        }
        for (std::size_t i = 0; i < free_.size(); ++i) {
            const BodyMotion& body = equations_.bodies[free_[i]];
            const auto at = static_cast<Eigen::Index>(6 * i);
            const geometry::Pose now = poseOf(free_[i]);
            const Vector place = now.position + by.segment<3>(at);
            const Vector angles = by.segment<3>(at + 3) / body.mass.radius;
            const Quaternion q = geometry::fromRotationVector(angles) * now.attitude;
            const std::array<double, 3> places{place.x(), place.y(), place.z()};
            const std::array<double, 4> entries{q.w(), q.x(), q.y(), q.z()};
            std::ranges::copy(places,
                              values_.begin() + static_cast<std::ptrdiff_t>(1 + body.unknown(x)));
            std::ranges::copy(entries,
                              values_.begin() + static_cast<std::ptrdiff_t>(1 + body.unknown(qw)));
        }
    }
    // From where the bodies were.
    [[nodiscard]] Eigen::VectorXd movement() const {
        Eigen::VectorXd way(static_cast<Eigen::Index>(6 * free_.size()));
        for (std::size_t i = 0; i < free_.size(); ++i) {
            const auto at = static_cast<Eigen::Index>(6 * i);
            const geometry::Pose now = poseOf(free_[i]);
            const Eigen::AngleAxisd turn(now.attitude * first_[i].attitude.conjugate());
            way.segment<3>(at) = now.position - first_[i].position;
            way.segment<3>(at + 3) = equations_.bodies[free_[i]].mass.radius *
                                     std::remainder(turn.angle(), 2 * std::numbers::pi) *
                                     turn.axis();
        }
        return way;
    }

    EquationsOfMotion& equations_;
    double start_;
    std::function<bool()> cancelled_;
    bool stopped_ = false;
    double size_ = 0;
    std::vector<std::size_t> free_; // bodies
    std::vector<geometry::Pose> first_;
    std::vector<Node> inputs_, outputs_; // gaps, then derivatives
    std::vector<double> values_;
    std::size_t ties_ = 0, count_ = 0;
    std::vector<std::size_t> angles_; // places in values_
    Eigen::VectorXd tied_,
        anglesOff_;            // how far the ties miss; the angles, with the bodies as they are
    Eigen::MatrixXd anglesBy_; // how the angles follow the bodies
    std::vector<std::pair<std::size_t, std::uint32_t>> entries_; // row, symbol
    expression::Tape tape_;
    Eigen::MatrixXd jacobian_;
};

} // namespace

// A coordinate counts from the start, wherever that is: its drive is no gap.
Assembly assembled(const scene::Scene& written, std::function<bool()> cancelled) {
    scene::Scene scene = written;
    for (scene::Joint& joint : scene.joints)
        for (scene::JointCoordinate& coordinate : joint.coordinates)
            coordinate.position.reset();
    EquationsOfMotion equations(scene, {}, nullptr, EquationsOfMotion::Start::mayMiss);
    Assembly made;
    if (!equations.faults.empty()) {
        made.reason = equations.faults.front();
        return made;
    }
    Closing closing(scene, equations, std::move(cancelled));
    const bool closes = closing.close();
    if (closes)
        closing.shorten();
    made.cancelled = closing.isCancelled();
    if (made.cancelled)
        return made;
    if (closes) {
        made.moved = closing.moved();
        return made;
    }
    char text[160];
    std::snprintf(text, sizeof text,
                  "the joints do not close by moving the bodies that are free to move; a gap of "
                  "%.4g is left",
                  closing.largestGap());
    made.reason = text;
    return made;
}

} // namespace physics
