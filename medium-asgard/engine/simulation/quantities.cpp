#include "expression/tape.h"
#include "physics/scene_quantities.h"
#include "simulation/computed_motion.h"
#include "simulation/run.h"
#include "simulation/simulation.h"

#include <algorithm>
#include <limits>

namespace simulation {

struct Quantities::Implementation {
    std::shared_ptr<const ComputedMotion> motion;
    struct Read {
        std::size_t body, unknown; // one of its thirteen
    };
    std::vector<Read> reads; // of the expressions, as inputs after time and count
    expression::Tape tape;
    std::size_t count = 0;
    mutable expression::Tape::Scratch scratch;

    [[nodiscard]] std::vector<double> at(double time) const;
};

namespace {

using expression::Node;

std::vector<Node> parseAll(physics::EquationsOfMotion& equations,
                           const std::vector<std::string>& expressions,
                           std::vector<std::string>& faults) {
    std::vector<Node> nodes;
    for (const std::string& text : expressions) {
        const auto parsed =
            equations.scope->parse(equations.set.graph, text, scene::Reading::quantities);
        if (const auto* fault = std::get_if<expression::SyntaxError>(&parsed)) {
            const std::string hint =
                fault->suggestion.empty() ? "" : " (" + fault->suggestion + ")";
            faults.push_back("\"" + text + "\": " + fault->message + hint);
        } else {
            nodes.push_back(std::get<Node>(parsed));
        }
    }
    return nodes;
}

// The expressions as nodes of the equations' graph, in which they are put. The number of impacts so
// far is a symbol.
struct Parsed {
    std::vector<Node> nodes;
    Node collisions;
};
Parsed parsedIn(physics::EquationsOfMotion& equations, const scene::Scene& scene,
                const std::vector<std::string>& expressions, std::vector<std::string>& faults) {
    const physics::SceneNodes nodes = physics::sceneNodes(equations, scene);
    equations.scope->setSceneNodes(nodes);
    return {parseAll(equations, expressions, faults), nodes.collisions};
}

} // namespace

std::vector<std::size_t> unknownsRead(const scene::Scene& scene,
                                      const std::vector<std::string>& expressions) {
    std::vector<std::size_t> read;
    physics::EquationsOfMotion equations(scene);
    if (expressions.empty() || !equations.scope)
        return read;
    std::vector<std::string> faults;
    const auto nodes = parsedIn(equations, scene, expressions, faults).nodes;
    const auto symbols = expression::symbolsOf(equations.set.graph, nodes);
    for (std::size_t u = 0; u < equations.set.unknowns.size(); ++u)
        if (std::ranges::binary_search(symbols, equations.set.unknowns[u].symbol))
            read.push_back(u);
    return read;
}

Quantities::Quantities(const scene::Scene& original, const Options& options, MotionPointer motion,
                       const std::vector<std::string>& expressions,
                       std::vector<std::string>& faults)
    : implementation_(std::make_unique<Implementation>()) {
    if (expressions.empty())
        return;
    scene::Scene scene = original;
    for (scene::Parameter& parameter : scene.parameters)
        if (const auto given = options.parameters.find(parameter.name);
            given != options.parameters.end())
            parameter.value = given->second;
    physics::EquationsOfMotion equations(scene);
    faults.insert(faults.end(), equations.faults.begin(), equations.faults.end());
    implementation_->motion = std::dynamic_pointer_cast<const ComputedMotion>(motion);
    implementation_->count = expressions.size();
    if (!equations.scope || !implementation_->motion)
        return;
    const auto [outputs, collisionsSoFar] = parsedIn(equations, scene, expressions, faults);
    if (outputs.size() != expressions.size())
        return;
    std::vector<Node> inputs{equations.set.time, collisionsSoFar};
    const auto symbols = expression::symbolsOf(equations.set.graph, outputs);
    for (std::size_t b = 0; b < equations.bodies.size(); ++b)
        for (std::size_t i = 0; !equations.bodies[b].isFixed && i < physics::bodyUnknowns; ++i) {
            const Node symbol = equations.set.unknowns[equations.bodies[b].firstUnknown + i].symbol;
            if (!std::ranges::binary_search(symbols, symbol))
                continue;
            inputs.push_back(symbol);
            implementation_->reads.push_back({b, i});
        }
    implementation_->tape = expression::Tape(equations.set.graph, inputs, outputs);
}

Quantities::~Quantities() = default;
Quantities::Quantities(Quantities&&) noexcept = default;
Quantities& Quantities::operator=(Quantities&&) noexcept = default;

std::vector<double> Quantities::Implementation::at(double time) const {
    std::vector<double> values(count, std::numeric_limits<double>::quiet_NaN());
    if (!motion || tape.outputs() != count)
        return values;
    const auto& impacts = motion->impacts();
    const auto collisions = std::ranges::count_if(
        impacts, [time](const Impact& impact) { return impact.time <= time; });
    std::vector<double> inputs{time, static_cast<double>(collisions)};
    for (const Read& read : reads) {
        const auto [record, histories] = motion->of(read.body);
        const std::size_t unknown = record.firstUnknown + read.unknown;
        // Past the end of its motion an unknown has no value.
        const solution::Stop* stop = histories.stop(unknown);
        const double value = histories.value(unknown, time);
        const bool isOver = (stop && time > stop->time) || std::abs(value) > solution::largestValue;
        inputs.push_back(isOver ? std::numeric_limits<double>::quiet_NaN() : value);
    }
    tape.evaluate(inputs, values, scratch);
    return values;
}

std::vector<double> Quantities::at(double time) const { return implementation_->at(time); }

} // namespace simulation
