// Scenes and motions for the tests: built in code, so that what they show is known exactly.
#pragma once

#include "framing/body_places.h"

#include <functional>
#include <string>
#include <vector>

namespace render {

// A motion in closed form: the state of each body as a function of time.
class GivenMotion : public simulation::Motion {
public:
    using Law = std::function<simulation::BodyState(double time)>;
    GivenMotion(double finish, std::vector<Law> laws) : finish_(finish), laws_(std::move(laws)) {}

    double start() const override { return 0; }
    double finish() const override { return finish_; }
    double computed() const override { return finish_; }
    bool draft() const override { return false; }
    std::size_t bodies() const override { return laws_.size(); }
    simulation::BodyState at(std::size_t body, double time) const override {
        return laws_[body](time);
    }
    std::optional<simulation::Stop> stop(std::size_t) const override { return stopped; }
    Vector centroid(std::size_t) const override { return Vector::Zero(); }
    double mass(std::size_t) const override { return 1; }
    const std::vector<simulation::Impact>& impacts() const override { return impacts_; }
    std::vector<double> jumps(std::size_t) const override { return jumpTimes; }
    std::optional<double> errorEstimate() const override { return std::nullopt; }
    std::optional<double> predictableUntil() const override { return std::nullopt; }
    const std::vector<std::string>& notes() const override { return notes_; }

    std::vector<double> jumpTimes;
    std::optional<simulation::Stop> stopped; // all bodies

private:
    double finish_;
    std::vector<Law> laws_;
    std::vector<simulation::Impact> impacts_;
    std::vector<std::string> notes_;
};

inline simulation::BodyState placed(const Vector& position) {
    simulation::BodyState state;
    state.position = position;
    return state;
}

// Adds a body with a shape of its own, one part.
inline scene::Body& addBody(scene::Scene& scene, const scene::Part& part, const Vector& place,
                            const scene::Color& color) {
    scene::ShapeSet shape;
    shape.name = "shape" + std::to_string(scene.shapeSets.size());
    shape.parts = {part};
    scene.shapeSets.push_back(shape);
    scene::Body body;
    body.name = "body" + std::to_string(scene.bodies.size());
    body.shape = shape.name;
    body.initialPosition = place;
    body.appearance.color = color;
    scene.bodies.push_back(body);
    return scene.bodies.back();
}

inline scene::Part sphere(double radius) {
    scene::Part part;
    part.shape = scene::SphereShape{radius};
    return part;
}

inline scene::Part box(const Vector& edges) {
    scene::Part part;
    part.shape = scene::BoxShape{edges};
    return part;
}

} // namespace render
