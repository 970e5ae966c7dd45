#include "physics/linkage.h"

#include "physics/carried_points.h"
#include "physics/independent_rows.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <set>
#include <unordered_map>

namespace physics {
namespace {

constexpr double closed = 1e-13;       // of the largest radius
constexpr double unmoved = 1e-12;      // of the largest radius
constexpr double longestTurn = 0.3;    // radians in one step
constexpr double leastMovement = 1e-9; // of the size; less is rounding's

} // namespace

Linkage::Linkage(const scene::Scene& scene, EquationsOfMotion& equations,
                 std::optional<std::size_t> about)
    : equations_(equations), start_(scene.simulator.start) {
    inputs_.push_back(equations.set.time);
    values_.push_back(start_);
    for (const expression::Unknown& unknown : equations.set.unknowns) {
        inputs_.push_back(unknown.symbol);
        values_.push_back(unknown.initial);
    }
    putGiven(graph(), equations.set, start_, values_);
    for (std::size_t b = 0; b < equations.bodies.size(); ++b)
        if (const BodyMotion& body = equations.bodies[b]; !body.isFixed && !isHeld(body))
            free_.push_back(b);
    conditions_ = conditions();
    if (about)
        keepTo(*about, conditions_);
    for (std::size_t i = 0; i < free_.size(); ++i) {
        size_ = std::max(size_, radiusOf(i));
        first_.push_back(poseOf(i));
    }
    conditions_.lasting = conditions_.gaps.size();
    tighten();
    makeTape();
}

bool Linkage::isHeld(const BodyMotion& body) const {
    const Held& held = body.heldAt(start_);
    return held.attitude || std::ranges::count(held.position, true) > 0;
}

Linkage::Conditions Linkage::conditions() {
    Conditions all;
    std::unordered_map<std::uint32_t, Node> unturned;
    const auto& unknowns = equations_.set.unknowns;
    for (std::size_t u = 0; u < unknowns.size(); ++u) {
        const expression::Phase& phase = phaseAt(unknowns[u], start_);
        if (!phase.condition && !phase.given && u >= afterBodies()) {
            angles_.places.push_back(1 + u);
            unturned.emplace(unknowns[u].symbol.index, graph().constant(unknowns[u].initial));
        }
        if (!phase.condition || unknowns[u].initial == expression::goneFromStart)
            continue;
        const auto& condition = *phase.condition;
        const bool isBounded = std::isfinite(condition.low) || std::isfinite(condition.high);
        if (!condition.gap) {
            if (condition.rate && !isBounded)
                all.drives.push_back(*condition.rate);
            continue;
        }
        (isBounded ? all.ropes : condition.rate ? all.gaps : all.ties).push_back(*condition.gap);
        if (condition.rate)
            all.rates.emplace(condition.gap->index, *condition.rate);
    }
    for (Node& rope : all.ropes) { // a wheel winds nothing before the start
        const Node rate = expression::substitute(graph(), all.rates.at(rope.index), unturned);
        rope = expression::substitute(graph(), rope, unturned);
        all.rates.emplace(rope.index, rate);
    }
    return all;
}

// Bodies and angles that one condition reads belong together.
void Linkage::keepTo(std::size_t body, Conditions& all) {
    const auto none = equations_.bodies.size() + angles_.places.size();
    std::unordered_map<std::uint32_t, std::size_t> things; // by symbol
    for (const std::size_t b : free_) {
        const BodySymbols& s = equations_.bodies[b].symbols;
        for (const Node& symbol : s.position)
            things.emplace(symbol.index, b);
        for (const Node& symbol : s.attitude)
            things.emplace(symbol.index, b);
        for (std::size_t i = 0; i < 3; ++i) {
            things.emplace(s.velocity[i].index, b);
            things.emplace(s.spin[i].index, b);
        }
    }
    for (std::size_t k = 0; k < angles_.places.size(); ++k)
        things.emplace(inputs_[angles_.places[k]].index, equations_.bodies.size() + k);
    std::vector<std::size_t> group(none + 1);
    std::iota(group.begin(), group.end(), 0);
    const auto firstOf = [&](const Node& node) {
        for (const Node& symbol : expression::symbolsOf(graph(), std::span(&node, 1)))
            if (const auto found = things.find(symbol.index); found != things.end())
                return group[found->second];
        return none;
    };
    for (const auto* list : {&all.ties, &all.gaps, &all.ropes})
        for (const Node& node : *list)
            for (const Node& symbol : expression::symbolsOf(graph(), std::span(&node, 1)))
                if (const auto found = things.find(symbol.index); found != things.end())
                    std::ranges::replace(group, std::size_t{group[found->second]}, firstOf(node));
    const std::size_t mine = group[body];
    for (auto* list : {&all.ties, &all.gaps, &all.ropes, &all.drives})
        std::erase_if(*list, [&](const Node& node) { return firstOf(node) != mine; });
    std::erase_if(free_, [&](std::size_t b) { return group[b] != mine; });
    std::vector<std::size_t> kept;
    for (std::size_t k = 0; k < angles_.places.size(); ++k)
        if (group[equations_.bodies.size() + k] == mine)
            kept.push_back(angles_.places[k]);
    angles_.places = std::move(kept);
}

bool Linkage::tighten() {
    auto& ropes = conditions_.ropes;
    const std::vector<double> left =
        valuesOf(expression::Tape(graph(), inputs_, ropes), ropes.size());
    std::vector<Node> slack;
    for (std::size_t k = 0; k < ropes.size(); ++k)
        (left[k] < -unmoved * size_ ? conditions_.gaps : slack).push_back(ropes[k]);
    const bool areNew = slack.size() < ropes.size();
    ropes = std::move(slack);
    if (areNew)
        makeTape();
    return areNew;
}

void Linkage::slacken() {
    auto& gaps = conditions_.gaps;
    if (gaps.size() == conditions_.lasting)
        return;
    const auto from = gaps.begin() + static_cast<std::ptrdiff_t>(conditions_.lasting);
    conditions_.ropes.insert(conditions_.ropes.end(), from, gaps.end());
    gaps.erase(from, gaps.end());
    makeTape();
}

std::vector<Linkage::Reads> Linkage::reads() {
    std::vector<Node> all = conditions_.gaps;
    all.insert(all.end(), conditions_.ropes.begin(), conditions_.ropes.end());
    std::unordered_map<std::uint32_t, std::set<std::size_t>> readBy; // by symbol
    for (std::size_t i = 0; i < free_.size(); ++i) {
        const BodySymbols& s = equations_.bodies[free_[i]].symbols;
        for (const Node& symbol : s.position)
            readBy[symbol.index].insert(i);
        for (const Node& symbol : s.attitude)
            readBy[symbol.index].insert(i);
    }
    const auto placesOf = [&](const Node& node) {
        std::set<std::size_t> places;
        for (const Node& symbol : expression::symbolsOf(graph(), std::span(&node, 1)))
            if (const auto found = readBy.find(symbol.index); found != readBy.end())
                places.insert(found->second.begin(), found->second.end());
        return places;
    };
    for (const Node& tie : conditions_.ties) { // an angle is that of its bodies
        const auto bodies = placesOf(tie);
        for (const std::size_t place : angles_.places)
            for (const Node& symbol : expression::symbolsOf(graph(), std::span(&tie, 1)))
                if (symbol == inputs_[place])
                    readBy[symbol.index].insert(bodies.begin(), bodies.end());
    }
    std::vector<Reads> reads;
    for (std::size_t k = 0; k < all.size(); ++k) {
        const auto places = placesOf(all[k]);
        reads.push_back({{places.begin(), places.end()}, true, k >= conditions_.gaps.size()});
    }
    const expression::Tape tape(graph(), inputs_, all);
    const std::vector<double> before = valuesOf(tape, all.size()), first = values_;
    for (const BodyUnknown axis : {x, y, z}) {
        for (const std::size_t b : free_)
            values_[1 + equations_.bodies[b].unknown(axis)] += size_;
        const std::vector<double> after = valuesOf(tape, all.size());
        for (std::size_t k = 0; k < all.size(); ++k)
            reads[k].isLoose =
                reads[k].isLoose && std::abs(after[k] - before[k]) <= leastMovement * size_;
        values_ = first;
    }
    return reads;
}

Linkage::Rates Linkage::rates() {
    constexpr double taut = 1e-9; // of the largest radius
    Rates made;
    std::vector<Node> ropes = conditions_.ropes, nodes = conditions_.drives;
    for (std::size_t k = 0; k < conditions_.gaps.size(); ++k)
        if (k < conditions_.lasting)
            nodes.push_back(conditions_.rates.at(conditions_.gaps[k].index));
        else
            ropes.push_back(conditions_.gaps[k]);
    made.isRope.assign(nodes.size(), 0);
    const std::vector<double> left =
        valuesOf(expression::Tape(graph(), inputs_, ropes), ropes.size());
    for (std::size_t k = 0; k < ropes.size(); ++k)
        if (left[k] < taut * size_) {
            nodes.push_back(conditions_.rates.at(ropes[k].index));
            made.isRope.push_back(1);
        }
    const expression::Tape tape(graph(), inputs_, nodes);
    const auto columns = static_cast<Eigen::Index>(6 * free_.size());
    const auto rows = static_cast<Eigen::Index>(nodes.size());
    const std::vector<double> first = values_;
    const auto at = [&](const Eigen::VectorXd& velocities) {
        for (std::size_t i = 0; i < free_.size(); ++i) {
            const BodyMotion& body = equations_.bodies[free_[i]];
            const auto from = static_cast<Eigen::Index>(6 * i);
            Vector spin = velocities.segment<3>(from + 3) / radiusOf(i);
            if (!body.symbols.isSpinInWorldAxes)
                spin = poseOf(i).attitude.conjugate() * spin;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const auto k = static_cast<Eigen::Index>(axis);
                values_[1 + body.unknown(dx) + axis] = velocities[from + k];
                values_[1 + body.unknown(w1) + axis] = spin[k];
            }
        }
        const std::vector<double> found = valuesOf(tape, nodes.size());
        return Eigen::VectorXd(Eigen::Map<const Eigen::VectorXd>(found.data(), rows));
    };
    made.led = at(Eigen::VectorXd::Zero(columns));
    made.by.resize(rows, columns);
    for (Eigen::Index c = 0; c < columns; ++c)
        made.by.col(c) = at(Eigen::VectorXd::Unit(columns, c)) - made.led;
    values_ = first;
    return made;
}

void Linkage::makeTape() {
    std::vector<Node> symbols, outputs = conditions_.ties;
    for (const std::size_t b : free_) {
        const BodySymbols& s = equations_.bodies[b].symbols;
        symbols.insert(symbols.end(), s.position.begin(), s.position.end());
        symbols.insert(symbols.end(), s.attitude.begin(), s.attitude.end());
    }
    for (const std::size_t place : angles_.places)
        symbols.push_back(inputs_[place]);
    outputs.insert(outputs.end(), conditions_.gaps.begin(), conditions_.gaps.end());
    const auto rows = expression::gradients(graph(), outputs, symbols);
    entries_.clear();
    for (std::size_t r = 0; r < rows.size(); ++r)
        for (const auto& [symbol, derivative] : rows[r]) {
            entries_.emplace_back(r, symbol);
            outputs.push_back(derivative);
        }
    tape_ = expression::Tape(graph(), inputs_, outputs);
    now_.isKnown = false;
}

std::size_t Linkage::afterBodies() const {
    std::size_t after = 0;
    for (const BodyMotion& body : equations_.bodies)
        if (!body.isFixed)
            after = std::max(after, body.firstUnknown + bodyUnknowns);
    return after;
}

std::vector<double> Linkage::valuesOf(const expression::Tape& tape, std::size_t count) {
    std::vector<double> found(count);
    expression::Tape::Scratch scratch;
    tape.evaluate(values_, found, scratch);
    return found;
}

geometry::Pose Linkage::poseOf(std::size_t place) const {
    return poseOf(equations_.bodies[free_[place]]);
}

geometry::Pose Linkage::poseOf(const BodyMotion& body) const {
    if (body.isFixed)
        return body.start;
    const double* v = values_.data() + 1 + body.firstUnknown;
    return {Vector(v[x], v[y], v[z]), Quaternion(v[qw], v[qx], v[qy], v[qz]).normalized()};
}

std::vector<geometry::Pose> Linkage::poses() const {
    std::vector<geometry::Pose> all;
    for (const BodyMotion& body : equations_.bodies)
        all.push_back(poseOf(body));
    return all;
}

bool Linkage::isClosed() { return largest(gapsNow()) <= closed * size_; }

double Linkage::largest(const Eigen::VectorXd& gaps) const {
    const Eigen::VectorXd& tied = angles_.missed;
    return std::max(gaps.size() == 0 ? 0 : gaps.lpNorm<Eigen::Infinity>(),
                    tied.size() == 0 ? 0 : tied.lpNorm<Eigen::Infinity>());
}

bool Linkage::close(const std::function<bool()>& cancelled) {
    constexpr int most = 60;
    Eigen::VectorXd gaps = gapsNow();
    for (int k = 0; k < most && !(cancelled && cancelled()); ++k) {
        if (largest(gaps) <= closed * size_)
            return true;
        step(leastStep(gaps));
        gaps = gapsNow();
    }
    return largest(gaps) <= 1e3 * closed * size_;
}

// Held columns make the system smaller.
Eigen::VectorXd Linkage::leastStep(const Eigen::VectorXd& gaps) const {
    const Eigen::MatrixXd& jacobian = now_.jacobian;
    Eigen::VectorXd by = Eigen::VectorXd::Zero(jacobian.cols());
    if (jacobian.rows() == 0)
        return by;
    if (held_.empty())
        return -solverOf(jacobian).solve(gaps);
    if (const IndependentRows independent(jacobian, held_); independent.are())
        return -independent.least(gaps);
    std::vector<Eigen::Index> rows, columns;
    for (Eigen::Index c = 0; c < jacobian.cols(); ++c)
        if (held_[static_cast<std::size_t>(c)] == 0)
            columns.push_back(c);
    for (Eigen::Index r = 0; r < jacobian.rows(); ++r)
        if (!jacobian.row(r).isZero(0))
            rows.push_back(r);
    if (!rows.empty() && !columns.empty())
        by(columns) = -solverOf(jacobian(rows, columns)).solve(gaps(rows));
    return by;
}

const Eigen::MatrixXd& Linkage::jacobian() {
    gapsNow();
    return now_.jacobian;
}

const Eigen::VectorXd& Linkage::gapsNow() {
    if (!std::exchange(now_.isKnown, true))
        findGaps();
    return now_.gaps;
}

// The angles follow the bodies and cost nothing, so the ties solve them away.
void Linkage::findGaps() {
    ++now_.places;
    const auto tieCount = conditions_.ties.size(), count = tieCount + conditions_.gaps.size();
    const std::vector<double> all = valuesOf(tape_, count + entries_.size());
    const auto rows = static_cast<Eigen::Index>(count), ties = static_cast<Eigen::Index>(tieCount),
               columns = static_cast<Eigen::Index>(6 * free_.size()),
               angles = static_cast<Eigen::Index>(angles_.places.size());
    Eigen::MatrixXd by = Eigen::MatrixXd::Zero(rows, columns + angles);
    const std::vector<Turning> turning = this->turning();
    for (std::size_t k = 0; k < entries_.size(); ++k) {
        const double derivative = all[count + k];
        const auto row = static_cast<Eigen::Index>(entries_[k].first);
        const auto symbol = static_cast<Eigen::Index>(entries_[k].second);
        const Eigen::Index body = symbol / 7, of = symbol % 7;
        if (body >= columns / 6)
            by(row, columns + symbol - 7 * (columns / 6)) += derivative;
        else if (of < 3)
            by(row, 6 * body + of) += derivative;
        else
            by.block<1, 3>(row, 6 * body + 3) +=
                derivative * turning[static_cast<std::size_t>(body)].row(of - 3);
    }
    const Eigen::Map<const Eigen::VectorXd> gaps(all.data(), rows);
    angles_.missed = gaps.head(ties);
    now_.jacobian = by.bottomLeftCorner(rows - ties, columns);
    now_.gaps = gaps.tail(rows - ties);
    if (ties > 0 && angles > 0) {
        const Eigen::MatrixXd own = by.topRightCorner(ties, angles);
        if (ties == angles && own.isDiagonal(0) && own.diagonal().cwiseAbs().minCoeff() > 0) {
            const auto each = own.diagonal().cwiseInverse().asDiagonal();
            angles_.by = each * by.topLeftCorner(ties, columns);
            angles_.off = each * angles_.missed;
        } else {
            const Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> solver(own);
            angles_.by = solver.solve(by.topLeftCorner(ties, columns));
            angles_.off = solver.solve(angles_.missed);
        }
        const auto through = by.bottomRightCorner(rows - ties, angles);
        if (!through.isZero(0)) {
            now_.jacobian -= through * angles_.by;
            now_.gaps -= through * angles_.off;
        }
    }
    leaveOutHeld();
}

void Linkage::leaveOutHeld() {
    for (std::size_t c = 0; c < held_.size(); ++c)
        if (held_[c] != 0)
            now_.jacobian.col(static_cast<Eigen::Index>(c)).setZero();
}

std::vector<Linkage::Turning> Linkage::turning() const {
    std::vector<Turning> all(free_.size());
    for (std::size_t i = 0; i < free_.size(); ++i) {
        const Quaternion q = poseOf(i).attitude;
        for (Eigen::Index axis = 0; axis < 3; ++axis) { // q' = (0, w) q / 2
            Quaternion turn(0, 0, 0, 0);
            turn.vec()[axis] = 0.5 / radiusOf(i);
            const Quaternion rate = turn * q;
            all[i].col(axis) << rate.w(), rate.x(), rate.y(), rate.z();
        }
    }
    return all;
}

Linkage::Solver Linkage::solverOf(const Eigen::MatrixXd& matrix) {
    Solver least(matrix.rows(), matrix.cols());
    least.setThreshold(leastMovement);
    least.compute(matrix);
    return least;
}

Eigen::VectorXd Linkage::shortened(const Eigen::VectorXd& by) const {
    double turn = 0;
    for (std::size_t i = 0; i < free_.size(); ++i)
        turn = std::max(turn,
                        by.segment<3>(static_cast<Eigen::Index>(6 * i + 3)).norm() / radiusOf(i));
    return turn > longestTurn ? Eigen::VectorXd(longestTurn / turn * by) : by;
}

void Linkage::step(const Eigen::VectorXd& wanted) {
    now_.isKnown = false;
    const Eigen::VectorXd by = shortened(wanted);
    if (angles_.off.size() > 0) {
        const Eigen::VectorXd angles = angles_.off + angles_.by * by;
        for (std::size_t k = 0; k < angles_.places.size(); ++k)
            values_[angles_.places[k]] -= angles[static_cast<Eigen::Index>(k)];
    }
    for (std::size_t i = 0; i < free_.size(); ++i) {
        const BodyMotion& body = equations_.bodies[free_[i]];
        const auto at = static_cast<Eigen::Index>(6 * i);
        const geometry::Pose now = poseOf(i);
        const Vector place = now.position + by.segment<3>(at);
        const Vector angles = by.segment<3>(at + 3) / radiusOf(i);
        const Quaternion q = geometry::fromRotationVector(angles) * now.attitude;
        const std::array<double, 3> places{place.x(), place.y(), place.z()};
        const std::array<double, 4> entries{q.w(), q.x(), q.y(), q.z()};
        std::ranges::copy(places,
                          values_.begin() + static_cast<std::ptrdiff_t>(1 + body.unknown(x)));
        std::ranges::copy(entries,
                          values_.begin() + static_cast<std::ptrdiff_t>(1 + body.unknown(qw)));
    }
}

Eigen::VectorXd Linkage::movement() const {
    Eigen::VectorXd way(static_cast<Eigen::Index>(6 * free_.size()));
    for (std::size_t i = 0; i < free_.size(); ++i) {
        const auto at = static_cast<Eigen::Index>(6 * i);
        const geometry::Pose now = poseOf(i);
        const Eigen::AngleAxisd turn(now.attitude * first_[i].attitude.conjugate());
        way.segment<3>(at) = now.position - first_[i].position;
        way.segment<3>(at + 3) =
            radiusOf(i) * std::remainder(turn.angle(), 2 * std::numbers::pi) * turn.axis();
    }
    return way;
}

std::vector<Assembly::Moved> Linkage::moved() const {
    std::vector<Assembly::Moved> all;
    const Eigen::VectorXd way = movement();
    for (std::size_t i = 0; i < free_.size(); ++i) {
        const auto at = static_cast<Eigen::Index>(6 * i);
        const double shift = way.segment<3>(at).norm(), arc = way.segment<3>(at + 3).norm();
        if (!(std::max(shift, arc) > unmoved * size_))
            continue;
        geometry::Pose pose = poseOf(i);
        if (!(arc > unmoved * size_))
            pose.attitude = first_[i].attitude;
        pose.position -= pose.attitude * equations_.bodies[free_[i]].mass.centroid;
        all.push_back({free_[i], pose, std::max(shift, arc), arc > unmoved * size_});
    }
    return all;
}

} // namespace physics
