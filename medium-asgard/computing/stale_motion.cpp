#include "computing/stale_motion.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string_view>

namespace computing {

namespace {

using simulation::BodyState;
using simulation::MotionPointer;

class StaleMotion final : public simulation::Motion {
public:
    StaleMotion(MotionPointer old, std::shared_ptr<const scene::Scene> scene)
        : old_(std::move(old)), scene_(std::move(scene)), start_(old_->start()),
          led_(scene_->bodies.size()) {
        if (const double now = scene_->simulator.start; now > start_ && now <= old_->computed())
            start_ = now;
        std::set<std::string_view> names;
        for (const scene::Constraint& one : scene_->constraints)
            names.insert(one.body);
        for (std::size_t i = 0; i < led_.size(); ++i)
            led_[i] = names.contains(scene_->bodies[i].name);
    }

    // Never wrapped twice, however long a gesture is.
    [[nodiscard]] const MotionPointer& old() const { return old_; }

    [[nodiscard]] double start() const override { return start_; }
    [[nodiscard]] double finish() const override { return old_->finish(); }
    [[nodiscard]] double computed() const override { return old_->computed(); }
    [[nodiscard]] bool draft() const override { return true; }
    [[nodiscard]] std::size_t bodies() const override { return old_->bodies(); }
    [[nodiscard]] BodyState at(std::size_t body, double time) const override {
        BodyState state = old_->at(body, time);
        if (time > start_ || led_[body])
            return state;
        const scene::Body& now = scene_->bodies[body];
        state.attitude = now.initialAttitude;
        state.position = now.initialPosition + now.initialAttitude * old_->centroid(body);
        state.velocity = now.initialVelocity;
        state.angularVelocity = now.initialAngularVelocity;
        return state;
    }
    [[nodiscard]] std::optional<simulation::Stop> stop(std::size_t body) const override {
        return old_->stop(body);
    }
    [[nodiscard]] geometry::Vector centroid(std::size_t body) const override {
        return old_->centroid(body);
    }
    [[nodiscard]] double mass(std::size_t body) const override { return old_->mass(body); }
    [[nodiscard]] const std::vector<simulation::Impact>& impacts() const override {
        return old_->impacts();
    }
    [[nodiscard]] std::vector<double> jumps(std::size_t body) const override {
        std::vector<double> all = old_->jumps(body);
        const geometry::Vector here = at(body, start_).position;
        if (!here.isApprox(old_->at(body, start_).position)) // it stands elsewhere, and comes back
            all.insert(all.begin(), std::nextafter(start_, finish()));
        return all;
    }
    [[nodiscard]] std::optional<double> errorEstimate() const override { return std::nullopt; }
    [[nodiscard]] std::optional<double> predictableUntil() const override {
        return old_->predictableUntil();
    }
    [[nodiscard]] const std::vector<std::string>& notes() const override { return old_->notes(); }

private:
    MotionPointer old_;
    std::shared_ptr<const scene::Scene> scene_;
    double start_;          // the scene's, where the old motion knows it
    std::vector<bool> led_; // by a trajectory: who knows where that puts it
};

} // namespace

MotionPointer staleMotion(const scene::Scene& before, const MotionPointer& motion,
                          std::shared_ptr<const scene::Scene> now) {
    const bool fits =
        motion && motion->bodies() == now->bodies.size() &&
        std::ranges::equal(before.bodies, now->bodies, {}, &scene::Body::name, &scene::Body::name);
    if (!fits)
        return nullptr;
    const auto* stale = dynamic_cast<const StaleMotion*>(motion.get());
    return std::make_shared<const StaleMotion>(stale ? stale->old() : motion, std::move(now));
}

} // namespace computing
