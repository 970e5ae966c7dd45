#include "resimulation/new_finish.h"

#include "resimulation/composition.h"

#include <algorithm>

namespace simulation {
namespace {

using scene::noElement;

std::shared_ptr<const scene::Version> endingAt(double finish, const scene::Version& version) {
    auto scene = std::make_shared<scene::Scene>(*version.scene);
    scene->simulator.finish = finish;
    return std::make_shared<const scene::Version>(std::move(scene));
}

class Continuation {
public:
    Continuation(const KnownMotion& known, double finish, const std::vector<bool>& isChanging,
                 const Observer& observer, const AddWork& add)
        : known_(known), finish_(finish), isChanging_(isChanging), observer_(observer), add_(add),
          isUnclear_(known.version->scene->bodies.size()) {
        made_.motion.version = endingAt(finish, *known.version);
        made_.motion.isEstimated = known.isEstimated;
        made_.motion.homes = known.homes;
    }

    NewFinish made();

private:
    [[nodiscard]] const scene::Scene& scene() const { return *known_.version->scene; }
    [[nodiscard]] bool isLonger() const { return finish_ > scene().simulator.finish; }
    [[nodiscard]] bool isChanging(const PlacedPart& placed) const;
    [[nodiscard]] bool takePart(const PlacedPart& placed);
    void leavePart(const PlacedPart& placed);
    void addUnits(const PartPointer& part, const Solved& solved,
                  const std::vector<std::size_t>& bodies, const std::vector<bool>& marked);
    void markMeetings();
    void markMeetings(std::size_t body, const PlacedPart& part, std::size_t place,
                      const std::vector<std::size_t>& beside);
    [[nodiscard]] std::vector<std::size_t> besides(const PlacedPart& part) const;
    void markUnit(std::size_t body);
    void mark(std::size_t body) {
        if (body != noElement && !scene().bodies[body].fixed)
            isUnclear_[body] = true;
    }
    [[nodiscard]] MotionPointer beside(const PlacedPart& placed, const MotionPointer& draft) const;

    const KnownMotion& known_;
    double finish_;
    const std::vector<bool>& isChanging_;
    const Observer& observer_;
    const AddWork& add_;
    std::vector<bool> isUnclear_;
    NewFinish made_;
};

MotionPointer Continuation::beside(const PlacedPart& placed, const MotionPointer& draft) const {
    KnownMotion others = known_;
    others.version = made_.motion.version;
    std::erase_if(others.units, [&](const UnitPointer& unit) { return unit->part == placed.part; });
    for (Home& home : others.homes)
        if (home.part == placed.part)
            home = {};
    return composeDraft(others, dynamic_cast<const ComputedMotion&>(*draft), placed.bodies);
}

bool Continuation::isChanging(const PlacedPart& placed) const {
    return std::ranges::any_of(
        placed.bodies, [this](std::size_t body) { return body != noElement && isChanging_[body]; });
}

// All of it is to be solved again.
void Continuation::leavePart(const PlacedPart& placed) {
    made_.motion.parts.push_back(placed);
    for (const std::size_t body : placed.bodies)
        mark(body);
}

// False: it was cancelled.
bool Continuation::takePart(const PlacedPart& placed) {
    constexpr std::size_t soon = 1000; // questions whether to go on
    KnownMotion& motion = made_.motion;
    if (!placed.part->reserve) {
        leavePart(placed);
        return true;
    }
    Reserve& reserve = *placed.part->reserve;
    reserve.problem->scene.simulator.finish = finish_;
    const bool isPerhapsInVain = isLonger() && isChanging(placed);
    std::size_t asked = 0;
    bool takesLong = false;
    Observer drafts;
    drafts.cancelled = [&] {
        takesLong = isPerhapsInVain && ++asked > soon;
        return takesLong || (observer_.cancelled && observer_.cancelled());
    };
    if (observer_.progress)
        drafts.progress = [&](const MotionPointer& draft) {
            observer_.progress(beside(placed, draft));
        };
    const Solved solved = solve(*reserve.problem, drafts, reserve.runs);
    add_(solved.result.statistics, made_.work);
    if (solved.result.cancelled && takesLong) {
        leavePart(placed);
        return true;
    }
    if (solved.result.cancelled) {
        made_.cancelled = true;
        made_.draft = beside(placed, solved.result.motion);
        return false;
    }
    auto part = std::make_shared<SolvedPart>(*reserve.problem, solved);
    if (!reserve.isTooLarge())
        part->reserve = placed.part->reserve;
    addUnits(part, solved, placed.bodies, reserve.runs.marked());
    motion.parts.push_back({part, placed.bodies});
    for (std::size_t p = 0; p < placed.bodies.size(); ++p)
        if (const std::size_t body = placed.bodies[p];
            body != noElement && known_.homes[body].part == placed.part)
            motion.homes[body] = {part, p};
    return true;
}

// Who came near one that moves otherwise now is not known. Those alone are of no interest.
void Continuation::addUnits(const PartPointer& part, const Solved& solved,
                            const std::vector<std::size_t>& bodies,
                            const std::vector<bool>& marked) {
    for (UnitPointer& unit : unitsOf(part, solved, bodies, known_.version->connections.group)) {
        bool isClear = true;
        for (std::size_t i = 0; i < unit->bodies.size(); ++i)
            isClear = isClear && unit->bodies[i] != noElement && !marked[unit->places[i]];
        if (isClear)
            made_.motion.units.push_back(std::move(unit));
        else
            for (const std::size_t body : unit->bodies)
                mark(body);
    }
}

void Continuation::markUnit(std::size_t body) {
    mark(body);
    if (const std::size_t unit = made_.motion.unitOf[body]; unit != noElement)
        for (const std::size_t other : made_.motion.units[unit]->bodies)
            mark(other);
}

// `beside`: bodies of other parts.
void Continuation::markMeetings(std::size_t body, const PlacedPart& part, std::size_t place,
                                const std::vector<std::size_t>& beside) {
    for (const std::size_t other : beside) {
        const Home& home = made_.motion.homes[other];
        if (!home.part || !mayMeet(scene(), body, other))
            continue;
        if (meet(*part.part, place, *home.part, home.place)) {
            markUnit(body);
            markUnit(other);
        }
    }
}

std::vector<std::size_t> Continuation::besides(const PlacedPart& part) const {
    std::vector<bool> isInPart(scene().bodies.size());
    for (const std::size_t body : part.bodies)
        if (body != noElement)
            isInPart[body] = true;
    std::vector<std::size_t> found;
    for (std::size_t body = 0; body < isInPart.size(); ++body)
        if (!isInPart[body])
            found.push_back(body);
    return found;
}

// Of bodies that were not solved together.
void Continuation::markMeetings() {
    made_.motion.index();
    for (const PlacedPart& part : made_.motion.parts) {
        const std::vector<std::size_t> beside = besides(part);
        for (std::size_t p = 0; p < part.bodies.size(); ++p)
            if (part.bodies[p] != noElement && !scene().bodies[part.bodies[p]].fixed)
                markMeetings(part.bodies[p], part, p, beside);
    }
}

NewFinish Continuation::made() {
    for (const PlacedPart& placed : known_.parts)
        if (!takePart(placed))
            return std::move(made_);
    if (isLonger() && scene().simulator.collisions && made_.motion.parts.size() > 1)
        markMeetings();
    made_.motion.index();
    for (std::size_t b = 0; b < isUnclear_.size(); ++b)
        if (isUnclear_[b])
            made_.unclear.push_back(b);
    return std::move(made_);
}

} // namespace

NewFinish atFinish(const KnownMotion& known, double finish, const std::vector<bool>& isChanging,
                   const Observer& observer, const AddWork& add) {
    return Continuation(known, finish, isChanging, observer, add).made();
}

} // namespace simulation
