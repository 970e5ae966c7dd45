#include "resimulation/resimulation.h"

#include "resimulation/composition.h"
#include "resimulation/edit.h"
#include "resimulation/new_finish.h"
#include "run/cpu_seconds.h"
#include "scene/part_of.h"

#include <algorithm>
#include <cmath>

namespace simulation {
namespace {

using scene::noElement;
using VersionPointer = std::shared_ptr<const scene::Version>;

// The scene as the options change it.
std::shared_ptr<const scene::Scene> inForce(std::shared_ptr<const scene::Scene> scene,
                                            const Options& options) {
    bool differs = (options.accuracy && *options.accuracy != scene->simulator.accuracy) ||
                   (options.finish && *options.finish != scene->simulator.finish) ||
                   (!options.method.empty() && options.method != scene->simulator.method);
    for (const scene::Parameter& parameter : scene->parameters)
        if (const auto given = options.parameters.find(parameter.name);
            given != options.parameters.end())
            differs = differs || given->second != parameter.value;
    if (!differs)
        return scene;
    auto changed = std::make_shared<scene::Scene>(*scene);
    changed->simulator.accuracy = options.accuracy.value_or(changed->simulator.accuracy);
    changed->simulator.finish = options.finish.value_or(changed->simulator.finish);
    if (!options.method.empty())
        changed->simulator.method = options.method;
    for (scene::Parameter& parameter : changed->parameters)
        if (const auto given = options.parameters.find(parameter.name);
            given != options.parameters.end())
            parameter.value = given->second;
    return changed;
}

bool isSolvedInParts(const scene::Version& version, const Options& options) {
    return !options.whole && options.eventDriven && !options.explain && !options.only &&
           !version.connections.isBroken;
}

// The scene in force has the parameters' values, and a part of it may lack the parameters;
// accuracy, finish and method it has too, and to be told them twice changes nothing.
Options ofParts(const Options& options) {
    Options rest = options;
    rest.parameters.clear();
    return rest;
}

bool areKnown(const std::map<std::string, double>& parameters, const scene::Scene& scene) {
    return std::ranges::all_of(parameters, [&](const auto& given) {
        return std::ranges::find(scene.parameters, given.first, &scene::Parameter::name) !=
               scene.parameters.end();
    });
}

bool sameMethods(const Options& a, const Options& b) {
    return a.method == b.method && a.fixedStep == b.fixedStep;
}

void add(const Statistics& more, Statistics& sum) {
    static_cast<WorkCounts&>(sum) += more;
    sum.secondsSettingUp += more.secondsSettingUp;
    sum.secondsMoving += more.secondsMoving;
    sum.secondsSolving += more.secondsSolving;
    sum.componentList.insert(sum.componentList.end(), more.componentList.begin(),
                             more.componentList.end());
}

Result cancelledAt(const MotionPointer& motion, const Statistics& work) {
    Result result;
    result.cancelled = true;
    result.motion = motion;
    result.statistics = work;
    result.statistics.reached = motion->computed();
    return result;
}

// A body of a part that is solved again elsewhere is not of it any more.
void addKeptParts(const KnownMotion& before, const Edit& edit, KnownMotion& kept) {
    const scene::Difference& difference = edit.difference();
    for (const PlacedPart& placed : before.parts) {
        if (std::ranges::find(kept.units, placed.part, [](const UnitPointer& unit) {
                return unit->part;
            }) == kept.units.end())
            continue;
        PlacedPart& now = kept.parts.emplace_back(placed);
        for (std::size_t& body : now.bodies) {
            body = body == noElement ? noElement : difference.after[body];
            if (body != noElement && (edit.isAgain(body) || difference.changed[body]))
                body = noElement;
        }
    }
}

// What is kept of the motion before; the homes of what is solved again are empty.
KnownMotion keptOf(const KnownMotion& before, const Edit& edit, const VersionPointer& version) {
    const scene::Difference& difference = edit.difference();
    KnownMotion kept;
    kept.version = version;
    kept.isEstimated = before.isEstimated;
    for (std::size_t u = 0; u < before.units.size(); ++u) {
        if (!edit.isKept(u))
            continue;
        const UnitPointer& unit = before.units[u];
        const bool stays = std::ranges::all_of(
            unit->bodies, [&](std::size_t b) { return difference.after[b] == b; });
        if (stays) {
            kept.units.push_back(unit);
            continue;
        }
        auto changed = std::make_shared<Unit>(*unit);
        for (std::size_t& body : changed->bodies)
            body = difference.after[body];
        kept.units.push_back(std::move(changed));
    }
    const auto& bodies = version->scene->bodies;
    kept.homes.resize(bodies.size());
    for (std::size_t b = 0; b < bodies.size(); ++b)
        if (const std::size_t was = difference.before[b];
            was != noElement && !edit.isAgain(b) && !difference.changed[b])
            kept.homes[b] = before.homes[was];
    addKeptParts(before, edit, kept);
    return kept;
}

void addPart(KnownMotion& known, const PartPointer& part, const Solved& solved,
             const std::vector<std::size_t>& bodies) {
    known.parts.push_back({part, bodies});
    for (UnitPointer& unit : unitsOf(part, solved, bodies, known.version->connections.group))
        known.units.push_back(std::move(unit));
    for (std::size_t p = 0; p < bodies.size(); ++p)
        known.homes[bodies[p]] = {part, p};
}

PartPointer partOf(const std::shared_ptr<Reserve>& reserve, const Solved& solved) {
    auto part = std::make_shared<SolvedPart>(*reserve->problem, solved);
    if (!reserve->isTooLarge())
        part->reserve = reserve;
    return part;
}

// By body before: it moves otherwise now, or is not there.
std::vector<bool> changingBodies(const scene::Version& before, const scene::Version& now) {
    const scene::Difference difference = scene::differenceBetween(before, now);
    std::vector<bool> changing;
    for (const std::size_t after : difference.after)
        changing.push_back(after == noElement || difference.changed[after]);
    return changing;
}

} // namespace

struct Resimulation::Implementation {
    Result update(const VersionPointer& version, const Options& options, const Observer& observer);
    Result solveWhole(const VersionPointer& version, const Options& options,
                      const Observer& observer);
    std::optional<Result> solveParts(const KnownMotion& before,
                                     const std::vector<std::size_t>& unclear, Statistics sum,
                                     const VersionPointer& version, const Options& options,
                                     const Observer& observer);
    std::optional<Result> solvePart(const KnownMotion& before, const VersionPointer& version,
                                    const Options& options, const Observer& observer, Edit& edit,
                                    Statistics& sum, KnownMotion& next, bool& open);

    std::optional<KnownMotion> known;
    Options knownOptions;
    Work work;
};

Result Resimulation::Implementation::update(const VersionPointer& version, const Options& options,
                                            const Observer& observer) {
    work = {};
    const bool inParts =
        known && isSolvedInParts(*version, options) &&
        areKnown(options.parameters, *version->scene) && sameMethods(knownOptions, options) &&
        scene::sameButFinish(known->version->scene->simulator, version->scene->simulator);
    const double finish = version->scene->simulator.finish;
    if (!inParts || !(finish >= version->scene->simulator.start) || !std::isfinite(finish))
        return solveWhole(version, options, observer);
    std::optional<Result> result;
    if (finish == known->version->scene->simulator.finish) {
        result = solveParts(*known, {}, {}, version, options, observer);
    } else {
        NewFinish there =
            atFinish(*known, finish, changingBodies(*known->version, *version), observer, add);
        if (there.cancelled)
            return cancelledAt(there.draft, there.work);
        result = solveParts(there.motion, there.unclear, there.work, version, options, observer);
    }
    return result ? std::move(*result) : solveWhole(version, options, observer);
}

Result Resimulation::Implementation::solveWhole(const VersionPointer& version,
                                                const Options& options, const Observer& observer) {
    const double begin = cpuSeconds();
    const std::size_t rounds = work.rounds + 1;
    work = {};
    work.whole = true;
    work.rounds = rounds;
    auto problem = problemOf(*version->scene, options, observer);
    if (auto* refusal = std::get_if<std::vector<std::string>>(&problem)) {
        Result result;
        result.cancelled = refusal->empty();
        result.refusal = std::move(*refusal);
        return result;
    }
    const auto reserve =
        std::make_shared<Reserve>(std::get<std::shared_ptr<Problem>>(std::move(problem)));
    const double posing = cpuSeconds() - begin;
    Solved solved = solve(*reserve->problem, observer, reserve->runs);
    solved.result.statistics.secondsSettingUp += posing;
    std::vector<std::size_t> bodies;
    for (std::size_t b = 0; b < version->scene->bodies.size(); ++b) {
        bodies.push_back(b);
        if (!version->scene->bodies[b].fixed)
            work.solved.push_back(version->scene->bodies[b].name);
    }
    if (!solved.result.cancelled) {
        known.reset();
        if (isSolvedInParts(*version, options) && !solved.isFull) {
            known.emplace().version = version;
            known->isEstimated = solved.result.statistics.errorEstimate.has_value();
            known->homes.resize(bodies.size());
            addPart(*known, partOf(reserve, solved), solved, bodies);
            known->index();
            knownOptions = options;
        }
    }
    return std::move(solved.result);
}

// One round: what the edit marks is solved, and who came near it is marked. An answer ends it all:
// it was cancelled.
std::optional<Result> Resimulation::Implementation::solvePart(
    const KnownMotion& before, const VersionPointer& version, const Options& options,
    const Observer& observer, Edit& edit, Statistics& sum, KnownMotion& next, bool& open) {
    const std::vector<std::size_t> bodies = edit.chosen();
    next = keptOf(before, edit, version);
    auto problem = problemOf(scene::partOf(*version, bodies), ofParts(options), observer);
    if (const auto* refusal = std::get_if<std::vector<std::string>>(&problem)) {
        if (!refusal->empty())
            return std::nullopt;
        Result result;
        result.cancelled = true;
        result.statistics = sum;
        return result;
    }
    const auto reserve =
        std::make_shared<Reserve>(std::get<std::shared_ptr<Problem>>(std::move(problem)));
    Observer drafts{.cancelled = observer.cancelled, .progress = {}};
    const auto beside = [&](const MotionPointer& motion) {
        return composeDraft(next, dynamic_cast<const ComputedMotion&>(*motion), bodies);
    };
    if (observer.progress)
        drafts.progress = [&](const MotionPointer& motion) { observer.progress(beside(motion)); };
    ++work.rounds;
    Solved solved = solve(*reserve->problem, drafts, reserve->runs);
    add(solved.result.statistics, sum);
    if (solved.result.cancelled)
        return cancelledAt(beside(solved.result.motion), sum);
    const PartPointer part = partOf(reserve, solved);
    open = version->scene->simulator.collisions && edit.markWhoComesNear(*part, bodies);
    if (!open)
        addPart(next, part, solved, bodies);
    return std::nullopt;
}

// None: it cannot be done in parts.
std::optional<Result> Resimulation::Implementation::solveParts(
    const KnownMotion& before, const std::vector<std::size_t>& unclear, Statistics sum,
    const VersionPointer& version, const Options& options, const Observer& observer) {
    Edit edit(before, *version);
    for (const std::size_t body : unclear)
        if (const std::size_t now = edit.difference().after[body]; now != noElement)
            edit.mark(now);
    KnownMotion next;
    if (edit.solvesNothing())
        next = keptOf(before, edit, version);
    for (bool open = !edit.solvesNothing(); open;) {
        if (!edit.isPossible())
            return std::nullopt;
        const std::size_t rounds = work.rounds;
        if (auto result = solvePart(before, version, options, observer, edit, sum, next, open))
            return result;
        if (work.rounds == rounds) // a refusal: all of them are wanted
            return std::nullopt;
    }
    if (next.mayBeFull(mostBytes()))
        return std::nullopt;
    for (std::size_t b = 0; b < version->scene->bodies.size(); ++b)
        if (edit.isAgain(b))
            work.solved.push_back(version->scene->bodies[b].name);
        else if (!version->scene->bodies[b].fixed)
            ++work.kept;
    next.index();
    known = std::move(next);
    knownOptions = options;
    return compose(*known, std::move(sum));
}

Resimulation::Resimulation() : implementation_(std::make_unique<Implementation>()) {}
Resimulation::~Resimulation() = default;
Resimulation::Resimulation(Resimulation&&) noexcept = default;
Resimulation& Resimulation::operator=(Resimulation&&) noexcept = default;

Result Resimulation::update(std::shared_ptr<const scene::Scene> scene, const Options& options,
                            const Observer& observer) {
    const double begin = cpuSeconds();
    try {
        Result result = implementation_->update(
            std::make_shared<const scene::Version>(inForce(std::move(scene), options)), options,
            observer);
        result.statistics.seconds = cpuSeconds() - begin;
        return result;
    } catch (...) { // no memory: what is kept may be half of it
        implementation_->known.reset();
        throw;
    }
}

const Resimulation::Work& Resimulation::work() const { return implementation_->work; }

std::string Resimulation::Work::print() const {
    std::string text = whole ? "all solved:" : "solved:";
    for (const std::string& name : solved)
        text += " " + name;
    return text + "; kept: " + std::to_string(kept) + "; rounds: " + std::to_string(rounds);
}

} // namespace simulation
