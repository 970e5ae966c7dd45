// The values of the vectors that a scene gives by three expressions each: forces, couples, ends of
// links.
#pragma once

#include "geometry/pose.h"
#include "scene/names.h"
#include "simulation/simulation.h"

#include <array>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

namespace render {

using geometry::Vector;
using VectorTexts = std::array<std::string, 3>;

// Null: the force is given in another way.
[[nodiscard]] const VectorTexts* componentsOf(const scene::Force& force);
[[nodiscard]] VectorTexts valuesOf(const std::string& trajectory);

// The expressions that change are prepared when the first of them is asked for.
class VectorValues {
public:
    // Keeps both; the scene must live as long.
    VectorValues(const scene::Scene& scene, simulation::MotionPointer motion)
        : scene_(scene), motion_(std::move(motion)), names_(scene) {}

    // None: it changes.
    [[nodiscard]] std::optional<Vector> constant(const VectorTexts& texts);
    // None: it is not known then.
    [[nodiscard]] std::optional<Vector> at(const VectorTexts& texts, double time);

private:
    void prepare();

    const scene::Scene& scene_;
    simulation::MotionPointer motion_;
    scene::Names names_;
    std::unordered_map<std::string, std::optional<double>> constants_; // none: it changes
    // Of forces and links, in the order in which they are asked for.
    std::vector<std::string> changing_;
    std::optional<simulation::Quantities> quantities_;
    bool isPrepared_ = false;
    std::optional<double> time_; // of the values
    std::vector<double> values_; // of changing_
};

} // namespace render
