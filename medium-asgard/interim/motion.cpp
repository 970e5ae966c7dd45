// INTERIM: bodies that nothing acts on, so that the programs around the engine can be built and
// tried before its facade is there. Built only while the module `simulation` has no sources;
// removed with it.
#include "simulation/simulation.h"

#include <limits>

namespace simulation {
namespace {

class FreeMotion final : public Motion {
public:
    explicit FreeMotion(const scene::Scene& scene)
        : bodies_(scene.bodies), start_(scene.simulator.start), finish_(scene.simulator.finish) {}
    double start() const override { return start_; }
    double finish() const override { return finish_; }
    double computed() const override { return finish_; }
    bool draft() const override { return false; }
    std::size_t bodies() const override { return bodies_.size(); }
    BodyState at(std::size_t body, double time) const override {
        const scene::Body& b = bodies_.at(body);
        const double t = std::clamp(time, start_, finish_) - start_;
        BodyState state;
        state.velocity = b.initialVelocity;
        state.angularVelocity = b.initialAngularVelocity;
        state.position = b.initialPosition + t * b.initialVelocity;
        const double angle = t * b.initialAngularVelocity.norm();
        state.attitude = b.initialAttitude;
        if (angle > 0)
            state.attitude =
                Quaternion(Eigen::AngleAxisd(angle, b.initialAngularVelocity.normalized())) *
                b.initialAttitude;
        return state;
    }
    std::optional<Stop> stop(std::size_t) const override { return std::nullopt; }
    Vector centroid(std::size_t) const override { return Vector::Zero(); }
    double mass(std::size_t) const override { return 1; }
    const std::vector<Impact>& impacts() const override { return impacts_; }
    std::vector<double> jumps(std::size_t) const override { return {}; }
    std::optional<double> errorEstimate() const override { return std::nullopt; }
    std::optional<double> predictableUntil() const override { return std::nullopt; }
    const std::vector<std::string>& notes() const override { return notes_; }

private:
    std::vector<scene::Body> bodies_;
    double start_, finish_;
    std::vector<Impact> impacts_;
    std::vector<std::string> notes_;
};

} // namespace

Result simulate(const scene::Scene& scene, const Options&, const Observer&) {
    return {std::make_shared<FreeMotion>(scene), {}, {}, false};
}

struct Quantities::Implementation {
    std::size_t count;
};
Quantities::Quantities(const scene::Scene&, const Options&, MotionPointer,
                       const std::vector<std::string>& expressions, std::vector<std::string>&)
    : implementation_(new Implementation{expressions.size()}) {}
Quantities::~Quantities() = default;
Quantities::Quantities(Quantities&&) noexcept = default;
Quantities& Quantities::operator=(Quantities&&) noexcept = default;
std::vector<double> Quantities::at(double) const {
    return std::vector<double>(implementation_->count, std::numeric_limits<double>::quiet_NaN());
}

} // namespace simulation
