#include "physics/pulling.h"

#include "physics/independent_rows.h"

#include <Eigen/Eigenvalues>
#include <Eigen/SVD>

#include <algorithm>
#include <cmath>
#include <utility>

namespace physics {
namespace {

constexpr double farther = 10;    // a joint that is one body further away costs so much more
constexpr double absolute = 1e-3; // movements cost so much beside those of joints
constexpr double noWay = 0.15;    // of the body's radius: an arm so short turns nothing
constexpr double damping = 1e-7;
constexpr double converged = 1e-9; // of the size and the way: refine() does the rest
constexpr double isIndependent = 1e-9;
constexpr double unreached = 1e-3;
// Places that one pull may look at.
constexpr std::size_t work = 1000, fewest = 12;
constexpr std::size_t quickly = 8; // places to close after a good step

Eigen::Matrix3d crossed(const Vector& v) {
    Eigen::Matrix3d m;
    m << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
    return m;
}

scene::Scene withoutWhatCounts(scene::Scene scene, std::size_t body) {
    for (scene::Joint& joint : scene.joints)
        for (scene::JointCoordinate& coordinate : joint.coordinates) {
            coordinate.position.reset();
            coordinate.lower.reset();
            coordinate.upper.reset();
        }
    for (scene::Rope& rope : scene.ropes)
        if (!rope.length)
            rope.release = "1"; // it is gone from the start on
    scene.bodies[body].fixed = false;
    return scene;
}

// How far the point may be from the hand, of the hand's way, where it is `left` from it.
double permitted(double left) {
    constexpr double most = 0.5, none = 0.75;
    return left <= most ? left : std::max(0.0, most * (none - left) / (none - most));
}

// Of a way of the hand, where the fastest body moves so many times as fast as the hand.
double share(double fastest) {
    constexpr double most = 3;
    return fastest > most ? std::pow(most / fastest, 2) : 1;
}

// Movements that it takes to 0, without the held columns: each of length 1 and across the others.
Eigen::MatrixXd nullSpaceOf(const Eigen::MatrixXd& matrix, const std::vector<char>& held = {}) {
    std::vector<Eigen::Index> columns;
    for (Eigen::Index c = 0; c < matrix.cols(); ++c)
        if (held.empty() || held[static_cast<std::size_t>(c)] == 0)
            columns.push_back(c);
    const auto count = static_cast<Eigen::Index>(columns.size());
    Eigen::MatrixXd own = Eigen::MatrixXd::Identity(count, count);
    std::vector<Eigen::Index> rows;
    for (Eigen::Index r = 0; r < matrix.rows(); ++r)
        if (!matrix(r, columns).isZero(0))
            rows.push_back(r);
    if (!rows.empty() && count > 0) {
        const auto solver = Linkage::solverOf(matrix(rows, columns));
        if (solver.rank() > 0)
            own = solver.colsPermutation() *
                  Eigen::MatrixXd(solver.matrixZ().adjoint().rightCols(count - solver.rank()));
    }
    Eigen::MatrixXd all = Eigen::MatrixXd::Zero(matrix.cols(), own.cols());
    for (Eigen::Index k = 0; k < count; ++k)
        all.row(columns[static_cast<std::size_t>(k)]) = own.row(k);
    return all;
}

// The velocities that conditions give by themselves: they turn as little as can be, then move as
// little.
Eigen::VectorXd ledBy(const Eigen::MatrixXd& by, const Eigen::VectorXd& led) {
    if (led.size() == 0 || led.isZero(0))
        return Eigen::VectorXd::Zero(by.cols());
    Eigen::VectorXd v = -Linkage::solverOf(by).solve(led);
    const Eigen::MatrixXd free = nullSpaceOf(by);
    if (free.cols() == 0)
        return v;
    const auto turnsOf = [](Eigen::MatrixXd movements) {
        for (Eigen::Index i = 0; i < movements.rows(); i += 6)
            movements.middleRows<3>(i).setZero();
        return movements;
    };
    const Eigen::MatrixXd turns = turnsOf(free);
    v -= free * Linkage::solverOf(turns).solve(Eigen::VectorXd(turnsOf(v)));
    const Eigen::MatrixXd shifts = free * nullSpaceOf(turns);
    return v - shifts * Eigen::VectorXd(shifts.transpose() * v);
}

} // namespace

Pulling::Pulling(const scene::Scene& scene, std::size_t body, const Vector& point)
    : scene_(withoutWhatCounts(scene, body)),
      equations_(std::make_unique<EquationsOfMotion>(scene_, std::function<void()>(), nullptr,
                                                     EquationsOfMotion::Start::mayMiss)) {
    if (!equations_->faults.empty())
        return;
    linkage_ = std::make_unique<Linkage>(scene_, *equations_, body);
    const auto& bodies = linkage_->bodies();
    const auto found = std::ranges::find(bodies, body);
    if (found == bodies.end() || linkage_->reads().empty())
        return;
    if (bodies.size() > most) {
        state_ = State::tooMany;
        return;
    }
    if (!linkage_->close())
        return;
    state_ = State::joined;
    grasp_.place = static_cast<std::size_t>(found - bodies.begin());
    const geometry::Pose pose = linkage_->firstPoseOf(grasp_.place);
    grasp_.arm = pose.attitude.conjugate() * (point - pose.position);
    findCosts();
    findStages();
    if (scene.bodies[body].fixed) // it is put elsewhere as it is
        for (Held& held : stages_)
            std::fill_n(held.begin() + columnOf(grasp_.place) + 3, 3, 1);
    held_ = stages_.back();
    linkage_->hold(held_);
    const Eigen::MatrixXd free = allowed();
    isStuck_ = free.cols() == 0;
    movesAsOne_ = isLoose_ || isStuck_;
    if (movesAsOne_)
        return;
    const Eigen::MatrixXd own = free.middleRows(columnOf(grasp_.place), 6);
    const Eigen::JacobiSVD<Eigen::MatrixXd> ways(own, Eigen::ComputeThinU);
    turns_ = own.bottomRows(3).norm() > 1e-9;
    const auto independent = (ways.singularValues().array() > 1e-9).count();
    Eigen::MatrixXd reached = Eigen::MatrixXd::Zero(3, 1);
    if (independent > 0)
        reached =
            pointBy().middleCols(columnOf(grasp_.place), 6) * ways.matrixU().leftCols(independent);
    movesAsOne_ = !(reached.jacobiSvd().singularValues()[0] > noWay);
}

// Bodies that hang together but for the pulled one hold it where one of them is held by what
// stands.
void Pulling::findStages() {
    constexpr std::size_t steps = 3; // then all of them move
    const auto reads = linkage_->reads();
    const std::size_t count = bodies().size();
    const std::size_t far = count + 1;
    std::vector<std::size_t> away(count, far), group(count);
    for (std::size_t i = 0; i < count; ++i)
        group[i] = i;
    away[grasp_.place] = 0;
    std::vector<char> stands(count, 0); // by group
    const auto others = [&](const Linkage::Reads& one) {
        std::vector<std::size_t> places = one.places;
        std::erase(places, grasp_.place);
        return places;
    };
    for (const Linkage::Reads& one : reads)
        if (const auto places = others(one); !places.empty())
            for (const std::size_t place : places)
                std::ranges::replace(group, std::size_t{group[place]}, group[places.front()]);
    bool isLoose = true, hangsSlackly = false;
    for (const Linkage::Reads& one : reads) {
        isLoose = isLoose && one.isLoose;
        hangsSlackly = hangsSlackly || one.isSlack;
        if (one.isLoose)
            continue;
        const auto places = others(one);
        grasp_.isOnGround = grasp_.isOnGround || (places.empty() && !one.isSlack);
        for (const std::size_t place : places)
            stands[group[place]] = 1;
    }
    isLoose_ = isLoose && !hangsSlackly;
    for (std::size_t round = 0; round < count; ++round)
        for (const Linkage::Reads& one : reads) {
            std::size_t nearest = far;
            for (const std::size_t place : one.places)
                nearest = std::min(nearest, away[place]);
            for (const std::size_t place : one.places)
                away[place] = std::min(away[place], nearest + 1);
        }
    for (std::size_t step = 0; step <= steps; ++step) {
        Held held(6 * count, 0);
        for (std::size_t i = 0; i < count && step < steps; ++i)
            if (stands[group[i]] != 0 && away[i] > step)
                std::fill_n(held.begin() + columnOf(i), 6, 1);
        if (stages_.empty() || held != stages_.back())
            stages_.push_back(std::move(held));
    }
}

Vector Pulling::centreOf(const std::string& body) const {
    const scene::Body* found = scene::findBody(scene_, body);
    return found ? equations_->bodies[static_cast<std::size_t>(found - scene_.bodies.data())]
                       .mass.centroid
                 : Vector::Zero();
}

Vector Pulling::point() const {
    const geometry::Pose pose = linkage_->poseOf(grasp_.place);
    return pose.position + pose.attitude * grasp_.arm;
}

Eigen::MatrixXd Pulling::pointBy() const {
    const auto columns = static_cast<Eigen::Index>(6 * bodies().size());
    Eigen::MatrixXd by = Eigen::MatrixXd::Zero(3, columns);
    by.block<3, 3>(0, columnOf(grasp_.place)).setIdentity();
    by.block<3, 3>(0, columnOf(grasp_.place) + 3) =
        -crossed(linkage_->poseOf(grasp_.place).attitude * grasp_.arm) /
        linkage_->radiusOf(grasp_.place);
    return by;
}

Eigen::MatrixXd Pulling::allowed() const { return nullSpaceOf(linkage_->jacobian(), held_); }

bool Pulling::isGone(const std::string& joint) const {
    return std::ranges::any_of(equations_->set.unknowns, [&](const expression::Unknown& one) {
        return one.name == joint && one.initial == expression::goneFromStart &&
               one.phases.front().condition;
    });
}

void Pulling::findCosts() {
    const auto placeOf = [&](const std::string& name) -> std::optional<std::size_t> {
        for (std::size_t i = 0; i < bodies().size(); ++i)
            if (scene_.bodies[bodies()[i]].name == name)
                return i;
        return std::nullopt;
    };
    for (const scene::Joint& joint : scene_.joints) {
        const auto first = placeOf(joint.body1);
        const auto second = joint.body2 ? placeOf(*joint.body2) : std::nullopt;
        if ((!first && !second) || isGone(joint.name))
            continue;
        Cost cost{first, second, Vector::Zero(), Vector::Zero(), 0, 1};
        const scene::Body* body1 = scene::findBody(scene_, joint.body1);
        const auto at = static_cast<std::size_t>(body1 - scene_.bodies.data());
        const BodyMotion& motion = equations_->bodies[at];
        if (joint.offset1)
            cost.arm1 = *joint.offset1 - motion.mass.centroid;
        const Vector place = motion.start.position + motion.start.attitude * cost.arm1;
        if (second) {
            const geometry::Pose pose = linkage_->firstPoseOf(*second);
            cost.arm2 = pose.attitude.conjugate() * (place - pose.position);
        }
        cost.radius = std::min(first ? linkage_->radiusOf(*first) : HUGE_VAL,
                               second ? linkage_->radiusOf(*second) : HUGE_VAL);
        costs_.push_back(cost);
    }
    std::vector<int> away(bodies().size(), 3); // joints from the body, at most
    away[grasp_.place] = 0;
    for (int round = 1; round < 3; ++round)
        for (const Cost& cost : costs_)
            if (cost.first && cost.second) {
                const int near = std::min(away[*cost.first], away[*cost.second]) + 1;
                away[*cost.first] = std::min(away[*cost.first], near);
                away[*cost.second] = std::min(away[*cost.second], near);
            }
    for (Cost& cost : costs_)
        cost.weight = std::pow(farther, std::min(cost.first ? away[*cost.first] : 3,
                                                 cost.second ? away[*cost.second] : 3));
}

Eigen::SparseMatrix<double> Pulling::cost() const {
    const auto columns = columnOf(bodies().size());
    std::vector<Eigen::Triplet<double>> entries;
    for (Eigen::Index i = 0; i < columns; ++i) // a turn rather than none costs much
        entries.emplace_back(static_cast<int>(i), static_cast<int>(i),
                             absolute * absolute * (i % 6 < 3 ? 1 : 1e2));
    for (const Cost& one : costs_) {
        Eigen::Matrix<double, 6, 12> by = Eigen::Matrix<double, 6, 12>::Zero(); // slides and turns
        std::vector<Eigen::Index> at;
        const auto add = [&](std::size_t place, const Vector& arm, double sign) {
            const auto own = static_cast<Eigen::Index>(at.size());
            const double radius = linkage_->radiusOf(place);
            by.block<3, 3>(0, own) = sign * Eigen::Matrix3d::Identity();
            by.block<3, 3>(0, own + 3) =
                -sign * crossed(linkage_->poseOf(place).attitude * arm) / radius;
            by.block<3, 3>(3, own + 3) = sign * one.radius / radius * Eigen::Matrix3d::Identity();
            for (Eigen::Index k = 0; k < 6; ++k)
                at.push_back(columnOf(place) + k);
        };
        if (one.first)
            add(*one.first, one.arm1, 1);
        if (one.second)
            add(*one.second, one.arm2, -1);
        const double weight = effort_.goesOn ? 1 : one.weight; // alike: they go far in a few steps
        const Eigen::Matrix<double, 12, 12> square = weight * weight * by.transpose() * by;
        for (std::size_t i = 0; i < at.size(); ++i)
            for (std::size_t k = 0; k < at.size(); ++k)
                entries.emplace_back(
                    static_cast<int>(at[i]), static_cast<int>(at[k]),
                    square(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k)));
    }
    Eigen::SparseMatrix<double> all(columns, columns);
    all.setFromTriplets(entries.begin(), entries.end());
    return all;
}

// For each row of `by` the movement that changes no condition, and changes that most for its cost.
Eigen::MatrixXd Pulling::cheapest(const Eigen::MatrixXd& by, const Eigen::MatrixXd& conditions,
                                  const Held& held) const {
    const Eigen::SparseMatrix<double> cost = this->cost();
    if (const IndependentRows independent(conditions, held); independent.are())
        if (auto found = independent.cheapest(cost, by.transpose()))
            return *std::move(found);
    const Eigen::MatrixXd free = nullSpaceOf(conditions, held);
    if (free.cols() == 0)
        return Eigen::MatrixXd::Zero(by.cols(), by.rows());
    const Eigen::MatrixXd own = free.transpose() * (cost * free), reaches = by * free;
    return free * own.ldlt().solve(reaches.transpose());
}

Eigen::VectorXd Pulling::towards(const Vector& way, const Eigen::MatrixXd& by) const {
    const Eigen::MatrixXd cheaply = cheapest(by, linkage_->jacobian(), held_);
    Eigen::Matrix3d compliance = by * cheaply;
    if (!(compliance.trace() > 0))
        return Eigen::VectorXd::Zero(cheaply.rows());
    compliance.diagonal().array() += damping * compliance.trace();
    return cheaply * compliance.ldlt().solve(way);
}

Eigen::VectorXd Pulling::given(const Vector& velocity, const Eigen::MatrixXd& conditions,
                               const Held& held) const {
    const Eigen::MatrixXd cheaply = cheapest(pointBy(), conditions, held);
    Eigen::VectorXd all = Eigen::VectorXd::Zero(cheaply.rows());
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> ways(Eigen::Matrix3d(pointBy() * cheaply));
    for (Eigen::Index k = 0; k < 3; ++k) {
        const double compliance = ways.eigenvalues()[k];
        if (!(compliance > damping * ways.eigenvalues()[2]))
            continue;
        const Vector way = ways.eigenvectors().col(k);
        const Eigen::VectorXd by = cheaply * way / compliance;
        double fastest = 0;
        for (Eigen::Index i = 0; i < by.size(); i += 3) // the centres' and the arcs'
            fastest = std::max(fastest, by.segment<3>(i).norm());
        all += share(fastest) * way.dot(velocity) * by;
    }
    return all;
}

std::vector<std::size_t> Pulling::loose(const Eigen::MatrixXd& conditions) const {
    const std::size_t count = bodies().size();
    std::vector<std::size_t> group{grasp_.place};
    std::vector<char> isIn(count, 0);
    isIn[grasp_.place] = 1;
    for (std::size_t k = 0; k < group.size(); ++k)
        for (Eigen::Index r = 0; r < conditions.rows(); ++r) {
            const double size = conditions.row(r).norm();
            const auto reads = [&](std::size_t place) {
                return conditions.block<1, 6>(r, columnOf(place)).norm() > isIndependent * size;
            };
            if (!reads(group[k]))
                continue;
            Eigen::RowVector3d shift = Eigen::RowVector3d::Zero();
            for (std::size_t i = 0; i < count; ++i) {
                shift += conditions.block<1, 3>(r, columnOf(i));
                if (reads(i) && std::exchange(isIn[i], 1) == 0)
                    group.push_back(i);
            }
            if (shift.norm() > isIndependent * size)
                return {};
        }
    return group;
}

bool Pulling::nearer(const Vector& place) {
    const Vector way = place - point();
    const auto group = loose(linkage_->jacobian());
    Eigen::VectorXd by = Eigen::VectorXd::Zero(linkage_->jacobian().cols());
    for (const std::size_t one : group)
        by.segment<3>(columnOf(one)) = way;
    if (group.empty())
        by = towards(way, pointBy());
    by = linkage_->shortened(by);
    constexpr double enough = 0.25; // of what the way would get shorter along a straight line
    const double least = converged * (linkage_->size() + way.norm());
    const double straight = 2 * way.dot(pointBy() * by);
    const std::vector<double> before = linkage_->values();
    const double whole = effort_.goesOn ? std::min(1.0, 4 * effort_.share) : 1;
    for (double share = whole; share > 1e-3 && share * by.norm() > least; share /= 2) {
        linkage_->step(share * by);
        effort_.share = share;
        const std::size_t until = linkage_->places() + quickly;
        if (linkage_->close([&] { return linkage_->places() >= until; }) &&
            way.squaredNorm() - (place - point()).squaredNorm() > enough * share * straight)
            return true;
        linkage_->setValues(before);
    }
    effort_.share = 1;
    return false;
}

// Beside the hand the way to it hardly tells the last steps from none.
void Pulling::refine(const Vector& place) {
    constexpr double small = 1e-4;
    double last = small * linkage_->size();
    for (int k = 0; k < 4 && loose(linkage_->jacobian()).empty(); ++k) {
        const Eigen::VectorXd by = towards(place - point(), pointBy());
        const std::vector<double> before = linkage_->values();
        if (!(by.norm() < last))
            return;
        last = by.norm();
        linkage_->step(by);
        if (!linkage_->close())
            return linkage_->setValues(before);
    }
}

void Pulling::approach(const Vector& place) {
    constexpr int steps = 60, rounds = 4;
    linkage_->slacken();
    const std::vector<double> before = linkage_->values();
    for (int round = 0; round < rounds; ++round) {
        for (int k = 0; k < steps && !isSpent() && nearer(place); ++k)
            ;
        if (!isSpent())
            refine(place);
        if (!linkage_->tighten())
            return;
        if (!linkage_->close())
            break;
    }
    linkage_->setValues(before);
}

void Pulling::allow() {
    effort_.until = linkage_->places() + std::max(fewest, work / bodies().size());
}

bool Pulling::isSpent() const { return linkage_->places() >= effort_.until; }

// From where they are, with all of them moving.
void Pulling::follow(const Vector& place) {
    effort_.goesOn = true;
    stage_ = stages_.size() - 1;
    held_ = stages_.back();
    linkage_->hold(held_);
    allow();
    approach(place);
}

// The holders stand at their places again at first. A way around, which was found step by step,
// counts where that does not come as near.
void Pulling::pullTo(const Vector& place) {
    if (effort_.goesOn)
        return follow(place);
    const std::vector<double> before = linkage_->values();
    const std::size_t last = stage_;
    if (first_.empty())
        first_ = before;
    if (last > 0)
        linkage_->setValues(first_);
    const Vector from = linkage_->firstPoseOf(grasp_.place).toWorld(grasp_.arm);
    const double way = (place - from).norm();
    Vector target = place;
    double left = way;
    bool isAside = true;
    allow();
    for (stage_ = 0; isAside && stage_ < stages_.size() && !isSpent(); ++stage_) {
        held_ = stages_[stage_];
        linkage_->hold(held_);
        approach(target);
        left = (place - point()).norm();
        const double mayBeLeft = permitted(left / way) * way;
        isAside = left > mayBeLeft + unreached * unreached * (linkage_->size() + way);
        target = place - mayBeLeft / std::max(left, mayBeLeft) * (place - point());
    }
    if (isSpent()) {
        linkage_->setValues(before);
        return follow(place);
    }
    --stage_; // the last one
    held_ = stages_.back();
    linkage_->hold(held_);
    if (last == 0 || !isAside)
        return;
    const std::vector<double> found = linkage_->values();
    linkage_->setValues(before);
    approach(place);
    if (!((place - point()).norm() < (1 - unreached) * left))
        linkage_->setValues(found);
}

Eigen::VectorXd Pulling::addHand(Eigen::VectorXd rates, const Eigen::MatrixXd& conditions,
                                 const Vector& ofHand) const {
    const Vector more = ofHand - pointBy() * rates;
    const auto group = loose(conditions);
    for (const std::size_t one : group)
        rates.segment<3>(columnOf(one)) += more;
    if (!group.empty())
        return rates;
    Vector target = ofHand;
    for (std::size_t stage = 0; stage < stages_.size(); ++stage) {
        rates += given(target - pointBy() * rates, conditions, stages_[stage]);
        const Vector left = ofHand - pointBy() * rates;
        const double mayBeLeft = permitted(left.norm() / more.norm()) * more.norm();
        if (!(left.norm() > (1 + converged) * mayBeLeft))
            break;
        target = ofHand - mayBeLeft / left.norm() * left;
    }
    return rates;
}

std::vector<Pulling::Velocity> Pulling::velocities(const std::vector<Velocity>& atFirst,
                                                   const std::optional<Vector>& ofHand) {
    const auto onlyJoints = [](const Linkage::Rates& all, const std::vector<char>& isLeftOut) {
        std::vector<Eigen::Index> rows;
        for (std::size_t r = 0; r < isLeftOut.size(); ++r)
            if (isLeftOut[r] == 0)
                rows.push_back(static_cast<Eigen::Index>(r));
        return std::pair<Eigen::MatrixXd, Eigen::VectorXd>(all.by(rows, Eigen::all), all.led(rows));
    };
    const std::vector<double> place = linkage_->values();
    if (!first_.empty())
        linkage_->setValues(first_);
    const Linkage::Rates before = linkage_->rates();
    const auto [byFirst, ledFirst] = onlyJoints(before, before.isRope);
    linkage_->setValues(place);
    const Eigen::VectorXd led = ledBy(byFirst, ledFirst);
    Eigen::VectorXd own(led.size());
    for (std::size_t i = 0; i < atFirst.size(); ++i) {
        const Eigen::Index at = columnOf(i);
        const geometry::Quaternion turn =
            linkage_->poseOf(i).attitude * linkage_->firstPoseOf(i).attitude.conjugate();
        own.segment<3>(at) = turn * Vector(atFirst[i].linear - led.segment<3>(at));
        own.segment<3>(at + 3) =
            turn * Vector(linkage_->radiusOf(i) * atFirst[i].angular - led.segment<3>(at + 3));
    }
    const Linkage::Rates now = linkage_->rates();
    std::vector<char> isLeftOut = now.isRope;
    Eigen::VectorXd rates;
    for (bool isNew = true; isNew;) { // ropes that would become longer hold
        const auto [by, ledNow] = onlyJoints(now, isLeftOut);
        const Eigen::MatrixXd free = nullSpaceOf(by);
        rates = ledBy(by, ledNow) + free * Eigen::VectorXd(free.transpose() * own);
        if (ofHand)
            rates = addHand(std::move(rates), by, *ofHand);
        const Eigen::VectorXd left = now.by * rates + now.led;
        isNew = false;
        for (std::size_t r = 0; r < isLeftOut.size(); ++r)
            if (isLeftOut[r] != 0 &&
                left[static_cast<Eigen::Index>(r)] < -isIndependent * rates.norm()) {
                isLeftOut[r] = 0;
                isNew = true;
            }
    }
    std::vector<Velocity> after;
    for (std::size_t i = 0; i < atFirst.size(); ++i)
        after.push_back({bodies()[i], rates.segment<3>(columnOf(i)),
                         rates.segment<3>(columnOf(i) + 3) / linkage_->radiusOf(i)});
    return after;
}

} // namespace physics
