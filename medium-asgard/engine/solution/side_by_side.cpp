#include "solution/side_by_side.h"

#include "batches/alike_steps.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace solution {

namespace {

using Lanes = AlikeSteps::Lanes;

constexpr std::size_t fewest = 4; // fewer are faster alone

class SideBySide {
public:
    // `mustStep`: each of them a step at least.
    SideBySide(std::span<Component* const> components, bool mustStep, double until,
               const std::function<bool(double)>& goesOn)
        : waiting_(components), mustStep_(mustStep), until_(until), goesOn_(goesOn) {}

    // Those that have other equations now, and go on side by side among each other.
    [[nodiscard]] std::vector<Component*> advance() {
        for (std::size_t lane = 0; lane < AlikeSteps::lanes; ++lane)
            fill(lane, next(), mustStep_);
        while (taken_ >= fewest && goesOn())
            step();
        for (std::size_t lane = 0; lane < AlikeSteps::lanes; ++lane) {
            const bool mustStep = lanes_[lane].mustStep;
            if (Component* const component = empty(lane))
                advanceAlone(*component, mustStep, false);
        }
        while (Component* const component = next())
            advanceAlone(*component, mustStep_, false);
        return std::move(changed_);
    }

private:
    [[nodiscard]] Component* next() {
        if (waiting_.empty())
            return nullptr;
        Component* const first = waiting_.front();
        waiting_ = waiting_.subspan(1);
        return first;
    }
    // Asks once for each step, in which all lanes take part.
    [[nodiscard]] bool goesOn() {
        for (const Lane& lane : lanes_)
            if (lane.component)
                return goes_ = goes_ && goesOn_(lane.component->time());
        return goes_;
    }
    [[nodiscard]] bool isDone(const Component& component, bool mustStep) const {
        return component.ended() || !(mustStep || component.time() < until_);
    }
    // To its end, or until it may be stepped with others. True: it may.
    bool advanceAlone(Component& component, bool mustStep, bool toStride) {
        for (;; mustStep = false) {
            if (isDone(component, mustStep))
                return false;
            if (toStride && component.isInStride() &&
                component.equations().model().function().hasCodeForLanes())
                return true;
            if (!(goes_ = goes_ && goesOn_(component.time())))
                return false;
            (void)component.waitsFor();
            component.step();
        }
    }

    // With this component if it comes into stride, else with the next that does.
    void fill(std::size_t lane, Component* component, bool mustStep) {
        for (; component; component = next(), mustStep = mustStep_) {
            if (!advanceAlone(*component, mustStep, true))
                continue;
            const auto& model = component->equations().bound()->model;
            if (!steps_) {
                model_ = model;
                steps_.emplace(component->integration().stride(), component->control(),
                               model->function());
                values_.resize(component->equations().size());
            }
            if (model != model_)
                changed_.push_back(component);
            else if (!steps_->takes(component->integration().stride(), component->control()))
                advanceAlone(*component, mustStep, false);
            else
                return enter(lane, *component, mustStep);
        }
    }
    void enter(std::size_t lane, Component& component, bool mustStep) {
        steps_->enter(lane, component.integration().stride(), component.control(),
                      component.equations().constants());
        lanes_[lane] = {.component = &component, .mustStep = mustStep};
        ++taken_;
    }

    Component* empty(std::size_t lane) {
        Component* const component = lanes_[lane].component;
        if (!component)
            return nullptr;
        for (std::size_t n = 0; n < values_.size(); ++n)
            values_[n] = steps_->state(lane, n);
        steps_->leave(lane);
        component->leaveStride(values_);
        lanes_[lane] = {};
        --taken_;
        return component;
    }

    // It goes on by itself for a step at least.
    void letGo(std::size_t lane) {
        Component* const component = empty(lane);
        if ((goes_ = goes_ && goesOn_(component->time()))) {
            (void)component->waitsFor();
            component->step();
        }
        refill(lane, *component);
    }
    void refill(std::size_t lane, Component& component) {
        if (!goes_)
            return;
        if (advanceAlone(component, false, true))
            fill(lane, &component, false);
        else
            fill(lane, next(), mustStep_);
    }

    void step() {
        std::array<double, AlikeSteps::lanes> h{};
        for (std::size_t lane = 0; lane < AlikeSteps::lanes; ++lane) {
            if (!lanes_[lane].component)
                continue;
            std::optional<double> to = lanes_[lane].component->integration().strideEnd();
            while (lanes_[lane].component && !to) {
                letGo(lane);
                if (lanes_[lane].component)
                    to = lanes_[lane].component->integration().strideEnd();
            }
            if (to) {
                lanes_[lane].to = *to;
                h[lane] = *to - lanes_[lane].component->time();
            }
        }
        Lanes alone = 0;
        const Lanes accepted = judged(steps_->attempt(h), h, alone);
        steps_->dense(accepted);
        for (std::size_t lane = 0; lane < AlikeSteps::lanes; ++lane)
            if (accepted & AlikeSteps::of(lane))
                take(lane, h[lane]);
        steps_->proceed(accepted);
        for (std::size_t lane = 0; lane < AlikeSteps::lanes; ++lane)
            conclude(lane, h[lane], accepted, alone);
    }

    // Of the ordinary ones those that are accepted; what is to be made again alone joins `alone`.
    [[nodiscard]] Lanes judged(Lanes ordinary, std::span<const double> h, Lanes& alone) {
        Lanes accepted = 0;
        for (std::size_t lane = 0; lane < AlikeSteps::lanes; ++lane) {
            Component* const component = lanes_[lane].component;
            const Lanes here = AlikeSteps::of(lane);
            if (!component)
                continue;
            if (!(ordinary & here)) {
                alone |= here;
                continue;
            }
            const Attempt attempt = steps_->judge(lane);
            lanes_[lane].next = attempt.next;
            if (attempt.outcome == Attempt::Outcome::accepted)
                accepted |= here;
            else if (!component->integration().refuseStride(attempt, h[lane]))
                end(lane, attempt, h[lane]);
        }
        return accepted;
    }

    // No shorter step can be made.
    void end(std::size_t lane, const Attempt& attempt, double h) {
        Component* const component = empty(lane);
        component->endStride(attempt, h);
        refill(lane, *component);
    }

    void take(std::size_t lane, double h) {
        Component& component = *lanes_[lane].component;
        steps_->columns(lane, component.integration().columns());
        component.takeStride(h, lanes_[lane].to, lanes_[lane].next);
        lanes_[lane].mustStep = false;
    }

    void conclude(std::size_t lane, double h, Lanes accepted, Lanes alone) {
        Component* const component = lanes_[lane].component;
        if (!component)
            return;
        const Lanes here = AlikeSteps::of(lane);
        if (alone & here)
            return letGo(lane);
        if (!(accepted & here))
            return;
        const bool changes = component->integration().changesAfterStride(h, steps_->crossing(lane));
        if (!changes && component->time() < until_)
            return;
        (void)empty(lane);
        if (changes)
            component->changeMethodAfterStride();
        refill(lane, *component);
    }

    struct Lane {
        Component* component = nullptr;
        bool mustStep = false;
        double to = 0, next = 0; // where its step ends, and how long the one after it may be
    };
    std::span<Component* const> waiting_;
    bool mustStep_;
    double until_;
    const std::function<bool(double)>& goesOn_;
    bool goes_ = true;
    std::optional<AlikeSteps> steps_;
    std::array<Lane, AlikeSteps::lanes> lanes_;
    std::size_t taken_ = 0;
    std::vector<double> values_;
    std::shared_ptr<const ComponentModel> model_;
    std::vector<Component*> changed_;
};

using Alike = std::map<const ComponentModel*, std::vector<Component*>>;

Alike alikeOf(std::span<Component* const> components) {
    Alike alike;
    for (Component* const component : components)
        alike[&component->equations().model()].push_back(component);
    return alike;
}

} // namespace

void advanceSideBySide(std::span<Component* const> components, double until,
                       const std::function<bool(double)>& goesOn) {
    std::vector<Component*> waiting(components.begin(), components.end());
    for (bool mustStep = true; !waiting.empty(); mustStep = false) {
        std::vector<Component*> changed;
        for (const auto& [model, alike] : alikeOf(waiting))
            std::ranges::copy(SideBySide(alike, mustStep, until, goesOn).advance(),
                              std::back_inserter(changed));
        waiting = std::move(changed);
    }
}

} // namespace solution
