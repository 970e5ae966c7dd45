#include "physics/joint_multipliers.h"

#include "physics/assembly.h"
#include "physics/contact_readings.h"

#include "expression/operation.h"
#include "expression/tape.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <numeric>
#include <set>

namespace physics {
namespace {

constexpr double stopResolution = 1e-9;  // of the joint's size: lower hops and gaps are none
constexpr double startResolution = 1e-5; // of the scene's size: a smaller gap is closed

// A comparison, several that are joined, or a number: it changes from 0 in a jump.
bool isCondition(const Graph& g, Node node) {
    switch (g.op(node)) {
    case Op::less:
    case Op::lessEqual:
    case Op::equal:
    case Op::notEqual:
    case Op::logicalNot:
    case Op::logicalAnd:
    case Op::logicalOr:
    case Op::constant:
        return true;
    default:
        return false;
    }
}

// Comparisons of the time with a number: the number, and the value once the time is beyond.
struct TimeSwitch {
    Node node;
    double at = 0;
    bool after = false;
};
std::vector<TimeSwitch> timeSwitchesOf(const Graph& g, std::span<const Node> nodes, Node time) {
    std::vector<TimeSwitch> found;
    for (const Node n : expression::reachable(g, nodes)) {
        if (g.op(n) != Op::less && g.op(n) != Op::lessEqual)
            continue;
        const auto arguments = g.arguments(n);
        for (const std::size_t side : {0U, 1U})
            if (arguments[side] == time && g.op(arguments[1 - side]) == Op::constant)
                found.push_back({n, g.value(arguments[1 - side]), side == 1});
    }
    return found;
}

std::string shortRope(double by) {
    char text[100];
    std::snprintf(text, sizeof text, ": its -length is %.4g under what it measures at the start",
                  by);
    return text;
}

std::string nameOf(const JointMultipliers::Element& element) {
    return element.kind + " \"" + element.name + "\"";
}

} // namespace

void JointMultipliers::begin(Element element, const std::optional<scene::Expression>& release) {
    begun_.element = std::move(element);
    begun_.release.reset();
    if (!release)
        return;
    begun_.release = g_.symbol(begun_.element.name + ".release");
    releases_.push_back({.symbol = *begun_.release,
                         .text = *release,
                         .element = begun_.element,
                         .value = g_.constant(0)});
}

Node JointMultipliers::add(Make make, const JointBounds& bounds,
                           std::vector<std::size_t> trajectories, std::vector<Node> reads) {
    const std::string number = std::to_string(kept_.size());
    kept_.push_back({.multiplier = g_.symbol(begun_.element.name + ".condition" + number),
                     .element = begun_.element,
                     .make = std::move(make),
                     .bounds = bounds,
                     .release = begun_.release,
                     .trajectories = std::move(trajectories),
                     .reads = std::move(reads)});
    return kept_.back().multiplier;
}

void JointMultipliers::push(std::vector<Contribution>& contributions, Contribution made, Node rate,
                            Node force) {
    for (const std::size_t body : begun_.element.moving) {
        const BodySymbols& s = bodies_[body].symbols;
        made.body = body;
        for (std::size_t i = 0; i < 3; ++i) {
            made.force[i] = g_.multiply(differentiate(g_, rate, s.velocity[i]), force);
            made.torque[i] = g_.multiply(differentiate(g_, rate, s.spin[i]), force);
        }
        contributions.push_back(made);
    }
}

void JointMultipliers::keepThroughBlows(const Jet& jet) {
    const Node rate = jet.rate;
    JointRow row{.multiplier = kept_.size() - 1, .pushes = {}}; // its unknown is known later
    if (kept_.back().bounds.low == 0)
        row.gap = jet.value;
    row.resolution = stopResolution * kept_.back().element.size;
    for (const std::size_t body : kept_.back().element.moving) {
        const BodySymbols& s = bodies_[body].symbols;
        JointPush push{.body = body, .linear = {}, .angular = {}};
        for (std::size_t i = 0; i < 3; ++i) {
            push.linear[i] = differentiate(g_, rate, s.velocity[i]);
            push.angular[i] = differentiate(g_, rate, s.spin[i]);
        }
        if (!s.isSpinInWorldAxes)
            push.angular = s.toWorld(g_, push.angular);
        row.pushes.push_back(push);
    }
    rows_.push_back(std::move(row));
}

Node JointMultipliers::releasable(Node force) {
    if (!begun_.release)
        return force;
    const Node multiplier = add({}), rate = g_.subtract(multiplier, force);
    kept_.back().make = [rate](const Along&) {
        return JointCondition{{rate, rate, rate}, JointCondition::Order::value};
    };
    return multiplier;
}

Node JointMultipliers::located(Node value) {
    const std::vector<TimeSwitch> byTime = timeSwitchesOf(g_, std::span(&value, 1), scope_.time());
    const auto isOther = [&](Node n) {
        return expression::isSwitch(g_.op(n)) &&
               std::ranges::find(byTime, n, &TimeSwitch::node) == byTime.end();
    };
    if (std::ranges::none_of(expression::reachable(g_, std::span(&value, 1)), isOther) ||
        !scope_.trajectoriesReadBy(g_, std::span(&value, 1)).empty())
        return value;
    const Node symbol =
        g_.symbol(begun_.element.name + ".wanted" + std::to_string(located_.size()));
    located_.push_back({symbol, value, begun_.element.moving.front()});
    return symbol;
}

void JointMultipliers::addAngle(Node symbol, Node rate, double size, std::size_t owner) {
    angles_.push_back({symbol, rate, size, owner, std::nullopt});
}

bool JointMultipliers::needsTie(Node symbol) const {
    const auto angle = std::ranges::find(angles_, symbol, &Angle::symbol);
    return angle != angles_.end() && !angle->tie;
}

void JointMultipliers::tie(Node symbol, Node multiplier) {
    std::ranges::find(angles_, symbol, &Angle::symbol)->tie = multiplier;
}

void JointMultipliers::readReleases() {
    for (Release& release : releases_) {
        const auto made = scope_.parse(g_, release.text, scene::Reading::release);
        if (const auto* node = std::get_if<Node>(&made); node && !isCondition(g_, *node))
            faults_.push_back("-release of " + nameOf(release.element) +
                              ": it wants a comparison, as {t > 2}");
        else if (node)
            release.value = *node;
        else
            faults_.push_back("-release of " + nameOf(release.element) + ": " +
                              std::get<expression::SyntaxError>(made).message);
    }
}

Node JointMultipliers::onBranches(Node node, double time) {
    const double from = std::max(time, scene_.simulator.start);
    std::unordered_map<std::uint32_t, Node> taken;
    for (const TimeSwitch& at : timeSwitchesOf(g_, std::span(&node, 1), scope_.time()))
        taken.emplace(at.node.index, g_.constant((from >= at.at) == at.after ? 1 : 0));
    return taken.empty() ? node : substitute(g_, node, taken);
}

Node JointMultipliers::rateOf(Node node, const Along& along) {
    if (!along.set)
        return g_.constant(0);
    Node rate = differentiate(g_, node, scope_.time());
    for (const Node symbol : symbolsOf(g_, std::span(&node, 1))) {
        const auto unknown = unknownOf_.find(symbol.index);
        if (unknown != unknownOf_.end())
            rate = g_.add(
                rate,
                g_.multiply(differentiate(g_, node, symbol),
                            phaseAt(along.set->unknowns[unknown->second], along.time).derivative));
    }
    return rate;
}

void JointMultipliers::addUnknown(expression::EquationSet& set, const Angle& angle) const {
    expression::Unknown unknown;
    unknown.name = g_.name(angle.symbol);
    unknown.symbol = angle.symbol;
    unknown.lengthPerUnit = angle.size;
    unknown.phases.emplace_back();
    unknown.phases[0].derivative = angle.tie ? g_.add(angle.rate, *angle.tie) : angle.rate;
    set.unknowns.push_back(std::move(unknown));
}

void JointMultipliers::addUnknown(expression::EquationSet& set, const Located& located) const {
    expression::Unknown unknown;
    unknown.name = g_.name(located.symbol);
    unknown.symbol = located.symbol;
    unknown.phases.emplace_back();
    unknown.phases[0].derivative = g_.constant(0); // until all unknowns are there
    unknown.phases[0].given = located.value;
    set.unknowns.push_back(std::move(unknown));
}

void JointMultipliers::addUnknown(expression::EquationSet& set, const Release& release) const {
    expression::Unknown unknown;
    unknown.name = g_.name(release.symbol);
    unknown.symbol = release.symbol;
    unknown.phases.emplace_back();
    unknown.phases[0].derivative = g_.constant(0);
    unknown.phases[0].given = release.value;
    set.unknowns.push_back(std::move(unknown));
}

expression::Phase JointMultipliers::phaseOf(const Kept& kept, const Along& along) const {
    using Order = JointCondition::Order;
    const JointCondition condition = kept.make(along);
    const auto& [value, rate, second] = condition.jet;
    const bool isFirst = condition.order == Order::first || condition.order == Order::value;
    expression::Phase phase;
    phase.from = along.time;
    phase.derivative = isFirst ? rate : second;
    phase.condition.emplace();
    if (!isFirst)
        phase.condition->rate = rate;
    if (condition.order == Order::first || condition.order == Order::second)
        phase.condition->gap = value;
    phase.condition->low = kept.bounds.low;
    phase.condition->high = kept.bounds.high;
    phase.condition->restitution = kept.bounds.restitution;
    phase.condition->resolution = stopResolution * kept.element.size;
    phase.condition->release = kept.release;
    return phase;
}

// Its condition is another whenever a body that it moves, or a trajectory that it reads, has
// another phase.
void JointMultipliers::addUnknown(expression::EquationSet& set, const Kept& kept) const {
    std::set<double> times{-std::numeric_limits<double>::infinity()};
    for (const std::size_t body : kept.element.moving)
        for (std::size_t i = 0; i < bodyUnknowns; ++i)
            for (const expression::Phase& phase :
                 set.unknowns[bodies_[body].firstUnknown + i].phases)
                times.insert(phase.from);
    for (const std::size_t trajectory : kept.trajectories)
        for (const TrajectoryPiece& piece : scope_.trajectory(trajectory).pieces)
            times.insert(piece.from);
    for (const TimeSwitch& at : timeSwitchesOf(g_, kept.reads, scope_.time()))
        if (at.at > scene_.simulator.start)
            times.insert(at.at);
    for (const Node symbol : expression::symbolsOf(g_, kept.reads))
        if (const auto read = unknownOf_.find(symbol.index); read != unknownOf_.end())
            for (const expression::Phase& phase : set.unknowns[read->second].phases)
                times.insert(phase.from);
    expression::Unknown unknown;
    unknown.name = kept.element.name;
    unknown.symbol = kept.multiplier;
    for (const double time : times) {
        const expression::Phase phase = phaseOf(kept, {&set, time});
        const auto isSame = [&](const expression::Phase& last) {
            return last.derivative == phase.derivative &&
                   last.condition->gap == phase.condition->gap &&
                   last.condition->rate == phase.condition->rate;
        };
        if (unknown.phases.empty() || !isSame(unknown.phases.back()))
            unknown.phases.push_back(phase);
    }
    set.unknowns.push_back(std::move(unknown));
}

std::vector<JointRow> JointMultipliers::addUnknowns(expression::EquationSet& set,
                                                    std::vector<std::size_t>& owners,
                                                    std::vector<std::string>& notes,
                                                    bool checksStart) {
    for (const Angle& angle : angles_) {
        addUnknown(set, angle);
        owners.push_back(angle.owner);
    }
    for (const Release& release : releases_) {
        addUnknown(set, release);
        owners.push_back(release.element.moving.front());
    }
    for (const Located& located : located_) {
        addUnknown(set, located);
        owners.push_back(located.owner);
    }
    contactReaders_ = withoutContacts(set);
    for (std::size_t u = 0; u < set.unknowns.size(); ++u)
        unknownOf_.emplace(set.unknowns[u].symbol.index, u);
    for (const Located& located : located_)
        set.unknowns[unknownOf_.at(located.symbol.index)].phases[0].derivative =
            rateOf(located.value, {&set, scene_.simulator.start});
    const std::size_t first = set.unknowns.size();
    for (const Kept& kept : kept_) {
        addUnknown(set, kept);
        owners.push_back(kept.element.moving.front());
    }
    markReleased(set, first);
    if (checksStart && first < set.unknowns.size())
        checkStart(set, first, notes);
    for (JointRow& row : rows_)
        row.multiplier += first;
    return std::move(rows_);
}

// The time and the unknowns, which are the inputs.
std::vector<double> JointMultipliers::startValues(const expression::EquationSet& set,
                                                  std::vector<Node>& inputs) const {
    inputs = {set.time};
    std::vector<double> values{scene_.simulator.start};
    for (const expression::Unknown& unknown : set.unknowns) {
        inputs.push_back(unknown.symbol);
        values.push_back(unknown.initial);
    }
    physics::putGiven(g_, set, scene_.simulator.start, values);
    return values;
}

// Conditions whose release is not 0 at the start were never there. A release that reads forces of
// joints is none of those: nobody knows these yet.
void JointMultipliers::markReleased(expression::EquationSet& set, std::size_t first) const {
    if (releases_.empty())
        return;
    std::vector<Node> inputs;
    const std::vector<double> values = startValues(set, inputs);
    const auto isForce = [&](Node symbol) {
        return std::ranges::find(kept_, symbol, &Kept::multiplier) != kept_.end();
    };
    for (std::size_t k = 0; k < kept_.size(); ++k) {
        const auto release = std::ranges::find_if(releases_, [&](const Release& one) {
            return kept_[k].release && one.symbol == *kept_[k].release;
        });
        if (release != releases_.end() && isReleased(kept_[k], values) &&
            std::ranges::none_of(expression::symbolsOf(g_, std::span(&release->value, 1)), isForce))
            set.unknowns[first + k].initial = expression::goneFromStart;
    }
}

// Gaps and their rates as the scene was written.
void JointMultipliers::checkStart(const expression::EquationSet& set, std::size_t first,
                                  std::vector<std::string>& notes) {
    std::vector<Node> inputs, outputs;
    const std::vector<double> values = startValues(set, inputs);
    for (std::size_t k = 0; k < kept_.size(); ++k) {
        const auto& condition = *phaseAt(set.unknowns[first + k], scene_.simulator.start).condition;
        outputs.push_back(condition.gap.value_or(g_.constant(0)));
        outputs.push_back(condition.rate.value_or(g_.constant(0)));
    }
    std::vector<double> found(outputs.size());
    expression::Tape::Scratch scratch;
    expression::Tape(g_, inputs, outputs).evaluate(values, found, scratch);
    struct Miss {
        double gap = 0, rate = 0;
        double before = 0; // without its last condition
        bool isUniversal = false;
        std::size_t body = 0; // one of its own
    };
    std::map<std::string, Miss> worst; // by element
    for (std::size_t k = 0; k < kept_.size(); ++k) {
        const Element& element = kept_[k].element;
        if (set.unknowns[first + k].initial == expression::goneFromStart)
            continue;
        const bool isStop = kept_[k].bounds.low == 0;
        if (isStop && found[2 * k] < -startResolution * extents().first)
            faults_.push_back(nameOf(element) + (element.kind == "rope"
                                                     ? shortRope(-found[2 * k])
                                                     : ": it starts outside its limits"));
        if (isStop || kept_[k].bounds.high < std::numeric_limits<double>::infinity())
            continue;
        if (!kept_[k].reads.empty()) {
            tellDrive(nameOf(element), found[2 * k]);
            continue;
        }
        Miss& miss = worst[nameOf(element)];
        miss.before = miss.gap;
        miss.gap = std::hypot(miss.gap, found[2 * k]);
        miss.rate = std::hypot(miss.rate, found[2 * k + 1]);
        miss.isUniversal = element.kind == "joint" && isUniversal(element.name);
        miss.body = element.moving.front();
    }
    const double none = startResolution * extents().first;
    for (const auto& [element, miss] : worst)
        if (miss.isUniversal && miss.before <= none && miss.gap > none) // the last is of its axes
            faults_.push_back(element +
                              ": -axis and -axis2 must be perpendicular; change one of them" +
                              (madeAtOnce(scene_, askedAbout(miss.body))
                                   ? " or turn a body"
                                   : ", turn a body, or let \"asgard assemble SCENE\" do it"));
        else
            tell({element + ": ", miss.body}, miss.gap, miss.rate, notes);
}

// That body and, of those that elements connect with it, one that a line makes with others: advice
// reads no more of them.
const std::vector<std::size_t>& JointMultipliers::askedAbout(std::size_t body) {
    if (!asked_.empty())
        return asked_[body];
    std::vector<std::size_t> group(bodies_.size());
    std::iota(group.begin(), group.end(), 0);
    const auto rootOf = [&](std::size_t of) {
        while (group[of] != of)
            of = group[of] = group[group[of]];
        return of;
    };
    for (const Kept& kept : kept_)
        for (const std::size_t moving : kept.element.moving)
            group[rootOf(moving)] = rootOf(kept.element.moving.front());
    std::map<std::size_t, std::size_t> several; // by root
    asked_.resize(bodies_.size());
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
        asked_[b].push_back(b);
        if (madeAtOnce(scene_, asked_[b]))
            several.emplace(rootOf(b), b);
    }
    for (std::size_t b = 0; b < bodies_.size(); ++b)
        if (const auto one = several.find(rootOf(b)); one != several.end())
            asked_[b].push_back(one->second);
    return asked_[body];
}

// `values`: the time, and the unknowns.
bool JointMultipliers::isReleased(const Kept& kept, const std::vector<double>& values) const {
    const auto place = kept.release ? unknownOf_.find(kept.release->index) : unknownOf_.end();
    return place != unknownOf_.end() && values[1 + place->second] != 0;
}

bool JointMultipliers::isUniversal(const std::string& joint) const {
    return std::ranges::any_of(scene_.joints, [&](const scene::Joint& one) {
        return one.name == joint && one.type == scene::JointType::universal;
    });
}

// A drive takes its speed without a word.
void JointMultipliers::tellDrive(const std::string& element, double gap) {
    if (std::abs(gap) <= startResolution * extents().first)
        return;
    char text[200];
    std::snprintf(text, sizeof text,
                  ": -position is %.4g at the start, where the joint's coordinate is 0; let it "
                  "begin at 0, or turn its bodies and leave that part out",
                  std::abs(gap));
    faults_.push_back(element + text);
}

void JointMultipliers::tell(const Where& where, double gap, double rate,
                            std::vector<std::string>& notes) {
    const auto [size, speed] = extents();
    char text[200];
    if (!(gap <= startResolution * size)) {
        std::snprintf(text, sizeof text, "its bodies miss each other by %.4g at the start; ", gap);
        faults_.push_back(where.sentence + text + closeAdvice(scene_, askedAbout(where.body)));
    } else if (!(rate <= startResolution * speed)) {
        std::snprintf(text, sizeof text,
                      "the velocities at the start differ by %.4g from what it allows; they are "
                      "changed by as little energy as possible",
                      rate);
        notes.push_back(where.sentence + text);
    }
}

// The size of the box of all moving bodies at the start, and their largest speed.
std::pair<double, double> JointMultipliers::extents() const {
    Eigen::AlignedBox3d box;
    double speed = 0;
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
        const BodyMotion& body = bodies_[b];
        if (body.isFixed)
            continue;
        const Vector reach = Vector::Constant(body.mass.radius);
        box.extend(Vector(body.start.position - reach));
        box.extend(Vector(body.start.position + reach));
        speed =
            std::max(speed, scene_.bodies[b].initialVelocity.norm() +
                                body.mass.radius * scene_.bodies[b].initialAngularVelocity.norm());
    }
    const double size = box.isEmpty() ? 1 : box.sizes().maxCoeff();
    return {size, std::max(speed, 1e-6 * size)};
}

} // namespace physics
