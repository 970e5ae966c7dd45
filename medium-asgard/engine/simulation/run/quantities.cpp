#include "run/quantities.h"

#include "expression/tape.h"
#include "motion/computed_motion.h"
#include "physics/scene_quantities.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <variant>

namespace simulation {

struct Quantities::Implementation {
    std::shared_ptr<const ComputedMotion> motion;
    struct Read {
        std::size_t body, unknown; // one of its thirteen, or behind them one of its record's more
        std::string reading = {};  // that, and no unknown
    };
    std::vector<std::string> faults; // of each expression
    std::vector<std::size_t> sound;  // which expressions the tape has
    std::vector<Read> reads;         // of the expressions, as inputs after time and count
    expression::Tape tape;
    mutable expression::Tape::Scratch scratch;

    [[nodiscard]] std::vector<double> inputsAt(double time) const;
    [[nodiscard]] std::vector<double> at(double time) const;
};

// The number of impacts so far is a symbol of the equations' graph.
struct ReadableScene::Implementation {
    physics::EquationsOfMotion equations;
    physics::SceneNodes nodes{};
};

namespace {

using expression::Node;

// The nodes of quantities of the whole scene are in the graph from here on.
physics::SceneNodes withSceneNodes(physics::EquationsOfMotion& equations,
                                   const scene::Scene& scene) {
    const physics::SceneNodes nodes = physics::sceneNodes(equations, scene);
    equations.scope->setSceneNodes(nodes);
    return nodes;
}

// An expression as a node of the equations' graph, in which it is put; or why there is none.
std::variant<Node, std::string> parsedIn(physics::EquationsOfMotion& equations,
                                         const std::string& text) {
    const auto parsed =
        equations.scope->parse(equations.set.graph, text, scene::Reading::quantities);
    const auto* fault = std::get_if<expression::SyntaxError>(&parsed);
    if (!fault)
        return std::get<Node>(parsed);
    const std::string hint = fault->suggestion.empty() ? "" : " (" + fault->suggestion + ")";
    return "\"" + text + "\": " + fault->message + hint;
}

scene::Scene withParameters(scene::Scene scene, const Options& options) {
    for (scene::Parameter& parameter : scene.parameters)
        if (const auto given = options.parameters.find(parameter.name);
            given != options.parameters.end())
            parameter.value = given->second;
    return scene;
}

} // namespace

std::vector<std::size_t> unknownsRead(const scene::Scene& scene,
                                      const std::vector<std::string>& expressions) {
    std::vector<std::size_t> read;
    physics::EquationsOfMotion equations(scene);
    if (expressions.empty() || !equations.scope)
        return read;
    (void)withSceneNodes(equations, scene);
    std::vector<Node> nodes;
    for (const std::string& text : expressions)
        if (const auto parsed = parsedIn(equations, text);
            const auto* node = std::get_if<Node>(&parsed))
            nodes.push_back(*node);
    const auto symbols = expression::symbolsOf(equations.set.graph, nodes);
    for (std::size_t u = 0; u < equations.set.unknowns.size(); ++u)
        if (std::ranges::binary_search(symbols, equations.set.unknowns[u].symbol))
            read.push_back(u);
    // The forces of contacts follow from all that their bodies do.
    for (const auto& contact : equations.scope->contacts())
        if (contact && std::ranges::any_of(contact->symbols(), [&](Node symbol) {
                return std::ranges::binary_search(symbols, symbol);
            }))
            for (const std::size_t body : {contact->moving, contact->other})
                for (std::size_t i = 0;
                     !equations.bodies[body].isFixed && i < physics::bodyUnknowns; ++i)
                    read.push_back(equations.bodies[body].firstUnknown + i);
    std::ranges::sort(read);
    read.erase(std::unique(read.begin(), read.end()), read.end());
    return read;
}

// --- of one scene --------------------------------------------------------------------------------

ReadableScene::ReadableScene(const scene::Scene& original, const Options& options) {
    const scene::Scene scene = withParameters(original, options);
    implementation_ = std::make_unique<Implementation>(
        Implementation{.equations = physics::EquationsOfMotion(scene), .nodes = {}});
    if (implementation_->equations.scope)
        implementation_->nodes = withSceneNodes(implementation_->equations, scene);
}

ReadableScene::~ReadableScene() = default;
ReadableScene::ReadableScene(ReadableScene&&) noexcept = default;
ReadableScene& ReadableScene::operator=(ReadableScene&&) noexcept = default;

const std::vector<std::string>& ReadableScene::faults() const {
    return implementation_->equations.faults;
}

Quantities ReadableScene::quantities(const MotionPointer& motion,
                                     const std::vector<std::string>& expressions) {
    auto read = std::make_unique<Quantities::Implementation>();
    read->motion = std::dynamic_pointer_cast<const ComputedMotion>(motion);
    physics::EquationsOfMotion& equations = implementation_->equations;
    if (!equations.scope) {
        read->faults.assign(expressions.size(), faults().empty() ? "" : faults().front());
        return Quantities(std::move(read));
    }
    std::vector<Node> outputs;
    for (const std::string& text : expressions) {
        auto parsed = parsedIn(equations, text);
        if (const auto* node = std::get_if<Node>(&parsed)) {
            read->sound.push_back(read->faults.size());
            outputs.push_back(*node);
            read->faults.emplace_back();
        } else {
            read->faults.push_back(std::get<std::string>(std::move(parsed)));
        }
    }
    std::vector<Node> inputs{equations.set.time, implementation_->nodes.collisions};
    const auto symbols = expression::symbolsOf(equations.set.graph, outputs);
    for (std::size_t b = 0; b < equations.bodies.size(); ++b)
        for (std::size_t i = 0; !equations.bodies[b].isFixed && i < physics::bodyUnknowns; ++i) {
            const Node symbol = equations.set.unknowns[equations.bodies[b].firstUnknown + i].symbol;
            if (!std::ranges::binary_search(symbols, symbol))
                continue;
            inputs.push_back(symbol);
            read->reads.push_back({b, i});
        }
    std::vector<std::size_t> more(equations.bodies.size(), physics::bodyUnknowns);
    for (std::size_t u = physics::bodyUnknowns * equations.set.quaternions.size();
         u < equations.owners.size(); ++u) {
        const std::size_t place = more[equations.owners[u]]++;
        if (std::ranges::binary_search(symbols, equations.set.unknowns[u].symbol)) {
            inputs.push_back(equations.set.unknowns[u].symbol);
            read->reads.push_back({equations.owners[u], place});
        }
    }
    for (const auto& contact : equations.scope->contacts()) {
        if (!contact)
            continue;
        for (const Node symbol : contact->symbols()) {
            if (!std::ranges::binary_search(symbols, symbol))
                continue;
            inputs.push_back(symbol);
            read->reads.push_back({contact->moving, 0, equations.set.graph.name(symbol)});
        }
    }
    read->tape = expression::Tape(equations.set.graph, inputs, outputs);
    return Quantities(std::move(read));
}

// --- of one motion -------------------------------------------------------------------------------

Quantities::Quantities(std::unique_ptr<Implementation> implementation)
    : implementation_(std::move(implementation)) {}

Quantities::Quantities(const scene::Scene& scene, const Options& options, MotionPointer motion,
                       const std::vector<std::string>& expressions,
                       std::vector<std::string>& faults)
    : implementation_(std::make_unique<Implementation>()) {
    if (expressions.empty())
        return;
    ReadableScene of(scene, options);
    *this = of.quantities(motion, expressions);
    faults.insert(faults.end(), of.faults().begin(), of.faults().end());
    if (of.faults().empty())
        std::ranges::copy_if(implementation_->faults, std::back_inserter(faults),
                             [](const std::string& fault) { return !fault.empty(); });
}

Quantities::~Quantities() = default;
Quantities::Quantities(Quantities&&) noexcept = default;
Quantities& Quantities::operator=(Quantities&&) noexcept = default;

const std::vector<std::string>& Quantities::faults() const { return implementation_->faults; }

// Time, the number of impacts, and the unknowns that are read.
std::vector<double> Quantities::Implementation::inputsAt(double time) const {
    const auto& impacts = motion->impacts();
    const auto collisions = std::ranges::count_if(
        impacts, [time](const Impact& impact) { return impact.time <= time; });
    std::vector<double> inputs{time, static_cast<double>(collisions)};
    for (const Read& read : reads) {
        const auto [record, histories] = motion->of(read.body);
        if (!read.reading.empty()) {
            const auto stop = motion->stop(read.body);
            inputs.push_back(stop && time > stop->time
                                 ? std::numeric_limits<double>::quiet_NaN()
                                 : motion->readingOf(read.body, read.reading, time));
            continue;
        }
        if (read.unknown >= physics::bodyUnknowns + record.more.size()) { // of an older scene
            inputs.push_back(std::numeric_limits<double>::quiet_NaN());
            continue;
        }
        const std::size_t unknown = read.unknown < physics::bodyUnknowns
                                        ? record.firstUnknown + read.unknown
                                        : record.more[read.unknown - physics::bodyUnknowns];
        // Past the end of its motion an unknown has no value.
        const solution::Stop* stop = histories.stop(unknown);
        const double value = motion->valueOf(read.body, unknown, time);
        const bool isOver = (stop && time > stop->time) || std::abs(value) > solution::largestValue;
        inputs.push_back(isOver ? std::numeric_limits<double>::quiet_NaN() : value);
    }
    return inputs;
}

std::vector<double> Quantities::Implementation::at(double time) const {
    std::vector<double> values(faults.size(), std::numeric_limits<double>::quiet_NaN());
    if (!motion || sound.empty())
        return values;
    std::vector<double> outputs(sound.size());
    tape.evaluate(inputsAt(time), outputs, scratch);
    for (std::size_t i = 0; i < sound.size(); ++i)
        values[sound[i]] = outputs[i];
    return values;
}

std::vector<double> Quantities::at(double time) const { return implementation_->at(time); }

} // namespace simulation
