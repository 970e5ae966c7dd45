#include "run/open_run.h"

#include "events/collision_source.h"
#include "placing/placing.h"
#include "run/cpu_seconds.h"
#include "run/jams.h"
#include "run/nudge.h"
#include "run/rope_notes.h"
#include "run/stops.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <set>

namespace simulation {
namespace {

std::shared_ptr<const solution::TakenMotion> motionOf(const Problem& problem, const Run& before,
                                                      const std::vector<bool>& taken) {
    auto motion = std::make_shared<solution::TakenMotion>();
    motion->histories = before.histories;
    motion->components = before.statistics.componentList;
    for (const std::size_t owner : ownersOf(problem))
        motion->unknowns.push_back(taken[owner]);
    return motion;
}

// What the motion that was taken has cost: its part of all evaluations then.
double secondsOf(const Run& before, const solution::TakenMotion& taken) {
    double all = 1, part = 0;
    for (const auto& component : before.statistics.componentList) {
        const auto evaluations = static_cast<double>(component.evaluations);
        all += evaluations;
        part += taken.unknowns[component.unknowns[0]] ? evaluations : 0;
    }
    return before.secondsMoving * part / all;
}

// By body. What decides when hops end follows the tolerance of each body, as its steps do, so that
// runs which are compared differ in it too.
std::vector<ContactResolution>
resolutionOf(const Problem& problem, const std::vector<double>& tolerances, Rounding rounding) {
    std::vector<ContactResolution> resolution;
    resolution.reserve(tolerances.size());
    for (const double tolerance : tolerances)
        resolution.push_back(resolutionFor({.accuracy = problem.accuracy(),
                                            .firstTolerance = firstTolerance(problem.accuracy()),
                                            .tolerance = tolerance,
                                            .isNudged = rounding == Rounding::nudged}));
    return resolution;
}

// What a step from the finish on, or one for a reader, ran into: all is known up to there. What an
// event does at the finish counts.
bool endsLater(const solution::Stop& stop, double start, double finish) {
    using enum solution::Stop::Reason;
    const bool isEvent = stop.reason == source || stop.reason == tooManyEvents;
    return stop.time > finish || (stop.time == finish && finish > start && !isEvent);
}

} // namespace

// Islands in which nothing was hit or touched, nothing stopped and nothing is to be solved again.
std::vector<bool> untouchedIn(const Problem& problem, const Run& before,
                              const std::vector<bool>& again) {
    const std::size_t bodies = problem.bodies->size();
    std::vector<bool> islands(bodies, true);
    for (const Impact& impact : before.impacts)
        islands[before.island[impact.first]] = islands[before.island[impact.second]] = false;
    for (const auto& entry : before.contacts.entries())
        for (const std::size_t body : entry->moving)
            islands[before.island[body]] = false;
    for (const auto& [body, stop] : before.stops)
        islands[before.island[body]] = false;
    for (std::size_t b = 0; b < bodies; ++b)
        if (again[b])
            islands[before.island[b]] = false;
    std::vector<bool> taken(bodies);
    for (std::size_t b = 0; b < bodies; ++b)
        taken[b] = islands[before.island[b]] && !(*problem.bodies)[b].isFixed;
    return taken;
}

struct OpenRun::Machinery {
    std::optional<CollisionSource> collisions;
    std::optional<NudgedSource> nudged;
    std::optional<solution::Solver> solver;
};

OpenRun::OpenRun(const Problem& problem, std::vector<double> tolerances, Rounding rounding, Use use,
                 std::vector<bool> taken)
    : problem_(problem), tolerances_(std::move(tolerances)), rounding_(rounding), use_(use),
      taken_(std::move(taken)), published_(problem.start()) {}

OpenRun::~OpenRun() = default;

void OpenRun::makeMachinery(const std::shared_ptr<const solution::TakenMotion>& taken) {
    machinery_ = std::make_unique<Machinery>();
    solution::Options options = solverOptions(problem_, tolerances_);
    options.taken = taken;
    if (use_ == Use::again || observer_.cancelled)
        options.cancelled = [this] { return observer_.cancelled && observer_.cancelled(); };
    if (use_ == Use::again || observer_.progress)
        options.progress = [this](double known) { publish(known); };
    if (observer_.working)
        options.working = [this](double time) {
            if (observer_.working)
                observer_.working(time);
        };
    if (problem_.collides())
        machinery_->collisions.emplace(
            CollisionSource::Collision{problem_.scene, problem_.equations, problem_.shapes},
            problem_.start(), problem_.finish(), resolutionOf(problem_, tolerances_, rounding_),
            options.cancelled);
    solution::EventSource* source = machinery_->collisions ? &*machinery_->collisions : nullptr;
    if (rounding_ == Rounding::nudged) {
        options.initial = nudgedStart(problem_.equations.set);
        if (source)
            source = &machinery_->nudged.emplace(*source, *problem_.bodies, problem_.start());
    }
    machinery_->solver.emplace(problem_.prepared, std::move(options), source);
}

bool OpenRun::canGoOn(const Run* before) const {
    const double finish = problem_.finish();
    // A motion that memory ended on its way to the old finish may well reach the new one.
    const auto isFull = [](const solution::Stop& stop) {
        return stop.reason == solution::Stop::Reason::tooMuchKept;
    };
    if (machinery_ && std::ranges::any_of(machinery_->solver->histories().stops(), isFull))
        return false;
    if (!taken_.empty() && machinery_ && finish > advanced_) {
        const auto untouched = untouchedIn(problem_, *before, std::vector<bool>(taken_.size()));
        for (std::size_t b = 0; b < taken_.size(); ++b)
            if (taken_[b] && !untouched[b])
                return false;
    }
    if (!machinery_ || !machinery_->collisions)
        return true;
    const CollisionRecord& source = machinery_->collisions->record();
    const bool isBack = finish < furthest_ && source.hasEventAt(finish);
    const bool isOnward = finish > advanced_ && source.hasEventAt(advanced_);
    return !isBack && !isOnward;
}

namespace {

void addNotes(const Problem& problem, const CollisionRecord& record, double until, Run& run) {
    std::ranges::copy(overlapSentences(problem.scene, record.overlaps(), Begin::throughEachOther),
                      std::back_inserter(run.notes));
    std::ranges::copy(record.notes(until), std::back_inserter(run.notes));
}

} // namespace

void OpenRun::publish(double known) {
    if (!observer_.progress)
        return;
    // A little soon, so that something moves at once; then a tenth more each time, as what is
    // collected grows.
    const double span = problem_.finish() - problem_.start();
    const double more = std::clamp((known - problem_.start()) / 10, span / 2000, span / 50);
    if (known < published_ + more)
        return;
    published_ = known;
    Run run;
    run.histories = machinery_->solver->snapshot();
    run.equations = machinery_->solver->equations();
    run.notes = problem_.equations.notes;
    if (machinery_->collisions) {
        run.impacts = machinery_->collisions->record().impacts(problem_.finish());
        run.contacts = machinery_->collisions->contactLog().upTo(known);
        addNotes(problem_, machinery_->collisions->record(), problem_.finish(), run);
    }
    run.stops = stopsOf(problem_, *run.histories, run.contacts, known);
    observer_.progress(run.motion(problem_, true));
}

namespace {

// The first of each pair.
void addJamNotes(const Problem& problem, Run& run, double until) {
    if (run.statistics.jams == 0)
        return;
    std::set<std::pair<std::size_t, std::size_t>> told;
    for (const Jam& jam : jamsOf(*run.histories, run.contacts, until)) {
        if (!told.insert(jam.bodies).second)
            continue;
        char at[40];
        std::snprintf(at, sizeof at, "%.6g", jam.time);
        run.notes.push_back("Bodies \"" + problem.scene.bodies[jam.bodies.first].name +
                            "\" and \"" + problem.scene.bodies[jam.bodies.second].name +
                            "\" jam at t = " + at +
                            ": no forces keep them sliding (no solution), since friction presses "
                            "them together faster than they push each other away; an impact "
                            "without a collision stands for their forces.");
    }
}

} // namespace

Run OpenRun::collect(double until) {
    Run run;
    run.histories = machinery_->solver->snapshot();
    run.equations = machinery_->solver->equations();
    if (furthest_ > until || std::ranges::any_of(run.histories->stops(), [&](const auto& stop) {
            return endsLater(stop, problem_.start(), until);
        }))
        run.histories = run.histories->upTo(until);
    run.statistics = machinery_->solver->statistics();
    run.before = std::exchange(counted_, run.statistics);
    run.notes = problem_.equations.notes;
    addRopeNotes(problem_, *run.histories, until, run.notes);
    std::vector<collision::Pair> blocked;
    if (machinery_->collisions) {
        CollisionSource& collisions = *machinery_->collisions;
        const CollisionRecord& record = collisions.record();
        blocked = record.blocked(until);
        run.impacts = record.impacts(until);
        addNotes(problem_, record, until, run);
        run.lostHops = record.lostHops(until);
        run.contacts = collisions.contactLog().upTo(until);
        addJamNotes(problem_, run, until);
        const std::size_t tests = collisions.pairTests();
        run.pairTests = tests - std::exchange(countedPairTests_, tests);
        run.candidates = collisions.candidates();
        if (problem_.options.explain)
            run.supports = collisions.supports();
    }
    run.stops = stopsOf(problem_, *run.histories, run.contacts, until);
    run.island = islandsOf(problem_, run.impacts, run.contacts, blocked);
    run.isIntegrated.assign(problem_.bodies->size(), false);
    const std::vector<std::size_t> owners = ownersOf(problem_);
    for (const solution::Statistics::Integrated& integrated : run.statistics.integrated)
        if (integrated.from < until)
            run.isIntegrated[owners[integrated.unknown]] = true;
    return run;
}

solution::Advance OpenRun::advance(const std::shared_ptr<const solution::TakenMotion>& taken) {
    const double begin = cpuSeconds(), finish = problem_.finish();
    if (machinery_ && machinery_->collisions)
        machinery_->collisions->lengthen(finish);
    if (!machinery_)
        makeMachinery(taken);
    else if (taken)
        machinery_->solver->takeLonger(taken);
    const double ready = cpuSeconds();
    solution::Advance advanced{.reached = finish, .cancelled = false, .disturbed = false};
    if (!(finish <= advanced_)) {
        furthest_ = std::max(furthest_, finish);
        advanced = machinery_->solver->advanceTo(finish);
        if (!advanced.cancelled)
            advanced_ = finish;
    }
    secondsSettingUp_ += ready - begin;
    secondsMoving_ += cpuSeconds() - ready;
    return advanced;
}

void OpenRun::solve(const Observer& observer) {
    observer_ = observer;
    (void)advance(nullptr);
    observer_ = {};
}

Run OpenRun::upToFinish(const Observer& observer, const Run* before) {
    const double finish = problem_.finish();
    observer_ = observer;
    std::shared_ptr<const solution::TakenMotion> taken;
    if (!taken_.empty() && !(finish <= advanced_))
        taken = motionOf(problem_, *before, taken_);
    const solution::Advance advanced = advance(taken);
    const double begin = cpuSeconds();
    Run run = collect(finish);
    run.reached = run.histories->known();
    run.cancelled = advanced.cancelled;
    run.secondsSettingUp = std::exchange(secondsSettingUp_, 0);
    run.secondsMoving = std::exchange(secondsMoving_, 0) + cpuSeconds() - begin +
                        (taken ? secondsOf(*before, *taken) : 0);
    run.isDisturbed = advanced.disturbed;
    run.isTaken = taken_;
    observer_ = {};
    return run;
}

std::size_t OpenRun::bytes() const { return machinery_ ? machinery_->solver->bytes() : 0; }

} // namespace simulation
