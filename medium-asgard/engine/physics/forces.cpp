#include "physics/forces.h"

#include <cmath>
#include <tuple>

namespace physics {
namespace {

template <class T>
std::unordered_map<std::string, std::size_t> indexByName(const std::vector<T>& elements) {
    std::unordered_map<std::string, std::size_t> indices;
    for (std::size_t i = 0; i < elements.size(); ++i)
        indices.try_emplace(elements[i].name, i);
    return indices;
}

// A sum's place and what is added to it: B.x + ... is (B.x, ...), 1e6 - ... is (1e6, -...).
// Anything else is (0, itself). For differences of places far from the origin.
std::pair<Node, Node> placeAndRest(Graph& g, Node sum) {
    const auto isPlace = [&g](Node n) { return g.op(n) == Op::symbol || g.op(n) == Op::constant; };
    if (isPlace(sum))
        return {sum, g.constant(0)};
    const auto terms = g.arguments(sum);
    if (g.op(sum) == Op::add && isPlace(terms[0]))
        return {terms[0], terms[1]};
    if (g.op(sum) == Op::add && isPlace(terms[1]))
        return {terms[1], terms[0]};
    if (g.op(sum) == Op::subtract && isPlace(terms[0]))
        return {terms[0], g.negate(terms[1])};
    return {g.constant(0), sum};
}

NodeVector negated(Graph& g, const NodeVector& v) {
    return {g.negate(v[0]), g.negate(v[1]), g.negate(v[2])};
}

} // namespace

ForceReader::ForceReader(Graph& g, const scene::Scene& scene, Scope& scope,
                         JointMultipliers& multipliers, std::vector<std::string>& faults)
    : g_(g), scene_(scene), scope_(scope), multipliers_(multipliers), faults_(faults),
      bodies_(indexByName(scene.bodies)), trajectories_(indexByName(scene.trajectories)) {}

void ForceReader::read(std::vector<Contribution>& contributions, std::vector<LinkNodes>& links) {
    nameSprings();
    for (std::size_t i = 0; i < scene_.forces.size(); ++i)
        readForce(i, contributions);
    for (std::size_t i = 0; i < scene_.links.size(); ++i)
        readLink(i, contributions, links);
}

std::optional<std::size_t> ForceReader::bodyNamed(const std::string& name) const {
    const auto found = bodies_.find(name);
    return found == bodies_.end() ? std::nullopt : std::optional(found->second);
}

const ScopeTrajectory* ForceReader::trajectoryNamed(const std::string& name) const {
    const auto found = trajectories_.find(name);
    return found == trajectories_.end() ? nullptr : &scope_.trajectory(found->second);
}

NodeVector ForceReader::parsed(const std::array<scene::Expression, 3>& texts,
                               const scene::Source& source, const std::string& element,
                               scene::Reading reading) {
    static constexpr const char* options[] = {"-x", "-y", "-z"};
    NodeVector result = constant(g_, Vector::Zero());
    for (std::size_t i = 0; i < 3; ++i) {
        const auto made = scope_.parse(g_, texts[i], reading);
        if (const auto* error = std::get_if<expression::SyntaxError>(&made))
            faults_.push_back("line " + std::to_string(source.line) + ": " + options[i] + " of " +
                              element + ": " + error->message);
        else
            result[i] = std::get<Node>(made);
    }
    return result;
}

Contribution ForceReader::at(std::size_t body, const Vector& arm, const NodeVector& force) {
    const BodySymbols& symbols = scope_.body(body);
    const NodeVector lever = constant(g_, arm);
    Contribution made;
    made.body = body;
    made.force = force;
    if (arm.isZero(0))
        made.torque = constant(g_, Vector::Zero());
    else if (symbols.isSpinInWorldAxes)
        made.torque = cross(g_, symbols.toWorld(g_, lever), force);
    else
        made.torque = cross(g_, lever, symbols.toBody(g_, force));
    return made;
}

std::string multiplierName(const scene::Force& force, std::size_t index) {
    return force.body + ".force" + std::to_string(index + 1);
}

std::string multiplierName(const scene::Link& link, std::size_t index) {
    return link.name.empty() ? link.first.body + ".link" + std::to_string(index + 1) : link.name;
}

Node ForceReader::strengthOf(const std::optional<scene::Expression>& release, const char* kind,
                             const std::string& name, std::span<const std::size_t> bodies) {
    std::vector<std::size_t> moving;
    for (const std::size_t body : bodies)
        if (!scene_.bodies[body].fixed)
            moving.push_back(body);
    if (!release || moving.empty())
        return g_.constant(1);
    multipliers_.begin({.name = name, .moving = moving, .size = 1, .kind = kind}, release);
    return multipliers_.releasable(g_.constant(1));
}

// --- forces ---------------------------------------------------------------------------------

NodeVector ForceReader::forceVector(const scene::Force& force, double mass, bool& isInBodyAxes) {
    isInBodyAxes = false;
    if (const auto* gravity = std::get_if<scene::GravitationalForce>(&force.kind))
        return constant(g_, mass * gravity->acceleration);
    if (const auto* driven = std::get_if<scene::TrajectoryForce>(&force.kind)) {
        if (const ScopeTrajectory* trajectory = trajectoryNamed(driven->trajectory))
            return trajectory->value;
        faults_.push_back("a force on \"" + force.body + "\": no trajectory named \"" +
                          driven->trajectory + "\"");
        return constant(g_, Vector::Zero());
    }
    const auto& components = std::get<scene::ComponentForce>(force.kind);
    isInBodyAxes = components.frame == scene::Frame::body;
    return parsed(components.components, force.source, "a force on \"" + force.body + "\"",
                  scene::Reading::state);
}

void ForceReader::readForce(std::size_t index, std::vector<Contribution>& contributions) {
    const scene::Force& force = scene_.forces[index];
    const auto body = bodyNamed(force.body);
    if (!body) {
        faults_.push_back("a force: no body named \"" + force.body + "\"");
        return;
    }
    const BodySymbols& symbols = scope_.body(*body);
    bool isInBodyAxes = false;
    const NodeVector value = forceVector(force, scope_.mass(*body).mass, isInBodyAxes);
    const NodeVector inWorld = isInBodyAxes ? symbols.toWorld(g_, value) : value;
    Contribution made;
    if (force.couple) { // turns the body about its centre of mass wherever it is drawn
        made.body = *body;
        made.force = constant(g_, Vector::Zero());
        const bool asGiven = isInBodyAxes != symbols.isSpinInWorldAxes;
        made.torque = asGiven ? value : symbols.toSpinAxes(g_, inWorld);
    } else {
        const Vector arm = scope_.armTo(*body, force.offset);
        made = at(*body, arm, inWorld);
        if (isInBodyAxes && !symbols.isSpinInWorldAxes) // not turned out and back
            made.torque = cross(g_, constant(g_, arm), value);
    }
    const Node strength =
        strengthOf(force.release, "force", multiplierName(force, index), std::span(&*body, 1));
    made.force = scaled(g_, strength, made.force);
    made.torque = scaled(g_, strength, made.torque);
    made.kind = Contribution::Kind::force;
    made.element = index;
    if (std::holds_alternative<scene::ComponentForce>(force.kind))
        made.written = value;
    contributions.push_back(made);
}

// --- links ----------------------------------------------------------------------------------

ForceReader::End ForceReader::bodyEnd(const scene::BodyEnd& end, std::size_t body) {
    const BodySymbols& symbols = scope_.body(body);
    const NodeVector arm = constant(g_, scope_.armTo(body, end.offset));
    return {symbols.position, symbols.toWorld(g_, arm), symbols.velocity,
            symbols.velocityOfArm(g_, arm)};
}

void ForceReader::findPositionRates() {
    if (!positionRates_.empty())
        return;
    for (std::size_t b = 0; b < scene_.bodies.size(); ++b) {
        const BodySymbols& body = scope_.body(b);
        const NodeQuaternion attitudeRate = body.attitudeRate(g_);
        for (std::size_t i = 0; i < 3; ++i)
            positionRates_.emplace(body.position[i].index, body.velocity[i]);
        for (std::size_t i = 0; i < 4; ++i)
            positionRates_.emplace(body.attitude[i].index, attitudeRate[i]);
    }
}

// d point / dt along the motion: by time, and by every place and attitude that it reads.
NodeVector ForceReader::rateOfPoint(const NodeVector& point) {
    NodeVector rate;
    for (std::size_t i = 0; i < 3; ++i) {
        rate[i] = differentiate(g_, point[i], scope_.time());
        for (const Node symbol : symbolsOf(g_, std::span(&point[i], 1))) {
            findPositionRates();
            const auto found = positionRates_.find(symbol.index);
            if (found != positionRates_.end())
                rate[i] = g_.add(rate[i],
                                 g_.multiply(differentiate(g_, point[i], symbol), found->second));
        }
    }
    return rate;
}

ForceReader::End ForceReader::secondEnd(const scene::Link& link) {
    const NodeVector zero = constant(g_, Vector::Zero());
    const std::string element = "a link of \"" + link.first.body + "\"";
    if (const auto* end = std::get_if<scene::BodyEnd>(&link.second)) {
        if (const auto body = bodyNamed(end->body))
            return bodyEnd(*end, *body);
        faults_.push_back(element + ": no body named \"" + end->body + "\"");
    } else if (const auto* driven = std::get_if<scene::TrajectoryEnd>(&link.second)) {
        if (const ScopeTrajectory* trajectory = trajectoryNamed(driven->trajectory))
            return {trajectory->value, zero, trajectory->rate, zero};
        faults_.push_back(element + ": no trajectory named \"" + driven->trajectory + "\"");
    } else {
        const NodeVector point = parsed(std::get<scene::PointEnd>(link.second).coordinates,
                                        link.source, element, scene::Reading::positions);
        End made{zero, zero, rateOfPoint(point), zero};
        for (std::size_t i = 0; i < 3; ++i)
            std::tie(made.place[i], made.arm[i]) = placeAndRest(g_, point[i]);
        return made;
    }
    return {zero, zero, zero, zero};
}

double ForceReader::dampingOf(const scene::Link& link) const {
    if (link.damping)
        return *link.damping;
    const auto inverseMass = [this](const std::string& name) {
        const auto body = bodyNamed(name);
        return body && !scene_.bodies[*body].fixed ? 1 / scope_.mass(*body).mass : 0;
    };
    double inverse = inverseMass(link.first.body);
    if (const auto* end = std::get_if<scene::BodyEnd>(&link.second))
        inverse += inverseMass(end->body);
    return inverse > 0 ? 2 * std::sqrt(link.tightness / inverse) : 0;
}

// Expressions of forces may read the lengths of springs.
void ForceReader::nameSprings() {
    for (std::size_t i = 0; i < scene_.links.size(); ++i) {
        const scene::Link& link = scene_.links[i];
        const auto first = bodyNamed(link.first.body);
        if (!link.spring || link.name.empty() || !first)
            continue;
        const std::size_t told = faults_.size();
        const LinkNodes nodes = geometryOf(link, bodyEnd(link.first, *first), secondEnd(link));
        scope_.setSpring(i, lawOf(link, nodes).spring);
        faults_.resize(told); // they are told when its force is read
    }
}

LinkNodes ForceReader::geometryOf(const scene::Link& link, const End& a, const End& b) const {
    LinkNodes made;
    made.damping = dampingOf(link);
    // Places first: far from the origin their difference is small and exact, and a sum of a place
    // and an arm would lose the arm's last digits.
    made.extension = add(g_, subtract(g_, a.place, b.place), subtract(g_, a.arm, b.arm));
    made.speed = add(g_, subtract(g_, a.velocity, b.velocity), subtract(g_, a.turning, b.turning));
    return made;
}

ForceReader::Law ForceReader::lawOf(const scene::Link& link, const LinkNodes& nodes) {
    if (link.spring)
        return springLaw(link, nodes);
    Law law;
    law.force = subtract(g_, scaled(g_, g_.constant(-link.tightness), nodes.extension),
                         scaled(g_, g_.constant(nodes.damping), nodes.speed));
    law.energy =
        g_.multiply(g_.constant(0.5 * link.tightness), dot(g_, nodes.extension, nodes.extension));
    return law;
}

// What is added to l and l² in denominators changes no other length than 0, where d/l and the rate
// l' = d.v/l are 0. Along one line d/l is the sign of d: a switch.
ForceReader::Law ForceReader::springLaw(const scene::Link& link, const LinkNodes& nodes) {
    const NodeVector &d = nodes.extension, &v = nodes.speed;
    const Node k = g_.constant(link.tightness), c = g_.constant(nodes.damping);
    const Node length = g_.apply(Op::hypot, g_.apply(Op::hypot, d[0], d[1]), d[2]);
    const double rest = restOf(link, length);
    const Node nearly = g_.constant(1e-300), divisor = g_.add(length, nearly);
    const Node stretch = g_.subtract(length, g_.constant(rest));
    const Node rateOverLength = g_.divide(dot(g_, d, v), g_.add(dot(g_, d, d), nearly));
    const auto whilePulling = [&](Node value) {
        return link.spring->isPullOnly
                   ? g_.apply(Op::select, g_.apply(Op::less, g_.constant(rest), length), value,
                              g_.constant(0))
                   : value;
    };
    Law law;
    for (std::size_t i = 0; i < 3; ++i) {
        const Node atRest =
            g_.divide(g_.multiply(g_.constant(link.tightness * rest), d[i]), divisor);
        const Node damped = g_.multiply(g_.multiply(c, rateOverLength), d[i]);
        law.force[i] = whilePulling(g_.subtract(g_.subtract(atRest, g_.multiply(k, d[i])), damped));
    }
    law.energy =
        whilePulling(g_.multiply(g_.constant(0.5 * link.tightness), g_.multiply(stretch, stretch)));
    const Node rate = g_.multiply(length, rateOverLength);
    law.spring = {length, whilePulling(g_.add(g_.multiply(k, stretch), g_.multiply(c, rate)))};
    return law;
}

double ForceReader::restOf(const scene::Link& link, Node length) {
    if (link.spring->rest)
        return *link.spring->rest;
    if (!start_)
        start_.emplace(g_, scene_, scope_);
    const double rest = start_->of(length);
    if (std::isfinite(rest))
        return rest;
    faults_.push_back("line " + std::to_string(link.source.line) +
                      ": a spring without -rest has its length at the start, which is not finite");
    return 0;
}

void ForceReader::readLink(std::size_t index, std::vector<Contribution>& contributions,
                           std::vector<LinkNodes>& links) {
    const scene::Link& link = scene_.links[index];
    const auto first = bodyNamed(link.first.body);
    if (!first) {
        faults_.push_back("a link: no body named \"" + link.first.body + "\"");
        return;
    }
    const End a = bodyEnd(link.first, *first), b = secondEnd(link);
    LinkNodes made = geometryOf(link, a, b);
    made.link = index;
    std::vector<std::size_t> bodies{*first};
    if (const auto* end = std::get_if<scene::BodyEnd>(&link.second))
        if (const auto second = bodyNamed(end->body))
            bodies.push_back(*second);
    const Node strength = strengthOf(link.release, link.spring ? "spring" : "link",
                                     multiplierName(link, index), bodies);
    const Law law = lawOf(link, made);
    const NodeVector force = scaled(g_, strength, law.force);
    made.energy = g_.multiply(strength, law.energy);
    if (link.spring && !link.name.empty())
        scope_.setSpring(index, {law.spring.length, g_.multiply(strength, law.spring.force)});
    links.push_back(made);
    const auto contribute = [&](std::size_t body, const scene::BodyEnd& end, const NodeVector& f) {
        Contribution contribution = at(body, scope_.armTo(body, end.offset), f);
        contribution.kind = Contribution::Kind::link;
        contribution.element = index;
        if (std::holds_alternative<scene::PointEnd>(link.second))
            contribution.written = add(g_, b.place, b.arm);
        contributions.push_back(contribution);
    };
    contribute(*first, link.first, force);
    if (const auto* end = std::get_if<scene::BodyEnd>(&link.second))
        if (const auto second = bodyNamed(end->body))
            contribute(*second, *end, negated(g_, force));
}

} // namespace physics
