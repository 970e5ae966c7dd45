#include "physics/body_phases.h"

#include <limits>
#include <unordered_map>

namespace physics {
namespace {

using expression::Phase;

// The equations of one segment of time, unknown by unknown.
class Segment {
public:
    Segment(Graph& g, const Scope& scope, const BodyMotion& body,
            std::span<const std::size_t> trajectories, const HoldSegment& held)
        : g_(g), time_(scope.time()), body_(body), s_(body.symbols),
          pieces_(scope.piecesFrom(g, trajectories, held.from)) {
        turn(held);
        for (std::size_t i = 0; i < 3; ++i)
            move(i, held.linear[i]);
        for (Phase& phase : phases)
            phase.from = held.from;
    }

    std::array<Phase, bodyUnknowns> phases;

private:
    void turn(const HoldSegment& held) {
        const NodeQuaternion rate = s_.attitudeRate(g_);
        for (std::size_t i = 0; i < 4; ++i)
            phases[qw + i].derivative = rate[i];
        if (!held.angular)
            setSpin(inForce(body_.spinRate), std::nullopt);
        else if (held.angular->isRate)
            setSpin(s_.toSpinAxes(g_, rateOf(held.angular->value)),
                    s_.toSpinAxes(g_, held.angular->value));
        else
            turnAlong(held.angular->value);
    }

    // The spin's own change of axes adds nothing to the rate: w x w = 0.
    void setSpin(const NodeVector& rate, const std::optional<NodeVector>& given) {
        for (std::size_t i = 0; i < 3; ++i) {
            phases[w1 + i].derivative = rate[i];
            if (given)
                phases[w1 + i].given = (*given)[i];
        }
    }

    void turnAlong(const NodeVector& rotationVector) {
        const NodeQuaternion attitude = attitudeOf(g_, rotationVector);
        for (std::size_t i = 0; i < 4; ++i)
            phases[qw + i].given = attitude[i];
        const NodeVector spin =
            spinOf(g_, rotationVector, rateOf(rotationVector), s_.isSpinInWorldAxes);
        setSpin(rateOf(spin), spin);
    }

    void move(std::size_t i, const std::optional<HoldSegment::Linear>& held) {
        Phase& place = phases[x + i];
        Phase& velocity = phases[dx + i];
        place.derivative = s_.velocity[i];
        velocity.derivative = substitute(g_, body_.acceleration[i], pieces_);
        if (!held)
            return;
        if (held->isVelocity) {
            velocity.given = held->value;
            velocity.derivative = differentiate(g_, held->value, time_);
            return;
        }
        const NodeVector arm = constant(g_, body_.mass.centroid); // reference point to centre
        const Node rate = differentiate(g_, held->value, time_);
        const Node turning = s_.velocityOfArm(g_, arm)[i];
        place.given = g_.add(held->value, s_.toWorld(g_, arm)[i]);
        velocity.given = g_.add(rate, turning);
        place.derivative = *velocity.given;
        velocity.derivative = g_.add(differentiate(g_, rate, time_), rateOfTurning(turning));
    }

    // d/dt of what depends on attitude and spin, as they move in this segment.
    Node rateOfTurning(Node turning) {
        Node rate = g_.constant(0);
        const auto addPart = [&](Node symbol, Node symbolRate) {
            rate = g_.add(rate, g_.multiply(differentiate(g_, turning, symbol), symbolRate));
        };
        for (std::size_t i = 0; i < 4; ++i)
            addPart(s_.attitude[i], phases[qw + i].derivative);
        for (std::size_t i = 0; i < 3; ++i)
            addPart(s_.spin[i], phases[w1 + i].derivative);
        return rate;
    }

    NodeVector inForce(const NodeVector& v) {
        return {substitute(g_, v[0], pieces_), substitute(g_, v[1], pieces_),
                substitute(g_, v[2], pieces_)};
    }

    NodeVector rateOf(const NodeVector& v) { return differentiated(g_, v, time_); }

    Graph& g_;
    Node time_;
    const BodyMotion& body_;
    const BodySymbols& s_;
    std::unordered_map<std::uint32_t, Node> pieces_;
};

void append(std::vector<Phase>& phases, Phase next, double start) {
    if (next.from <= start) { // in force at the start: nothing came before
        next.from = -std::numeric_limits<double>::infinity();
        phases.clear();
    }
    if (phases.empty()) {
        phases.push_back(next);
        return;
    }
    const Phase& last = phases.back();
    if (last.given && !next.given)
        next.jump = last.given;
    if (last.derivative != next.derivative || last.given != next.given)
        phases.push_back(next);
}

} // namespace

std::array<std::vector<Phase>, bodyUnknowns> phasesOf(Graph& g, const Scope& scope,
                                                      const BodyMotion& body,
                                                      std::span<const HoldSegment> segments,
                                                      std::span<const std::size_t> trajectories,
                                                      double start) {
    std::array<std::vector<Phase>, bodyUnknowns> phases;
    for (const HoldSegment& held : segments) {
        const Segment segment(g, scope, body, trajectories, held);
        for (std::size_t i = 0; i < bodyUnknowns; ++i)
            append(phases[i], segment.phases[i], start);
    }
    return phases;
}

} // namespace physics
