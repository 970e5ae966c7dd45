// The values of expressions along a motion.
#pragma once

#include "motion/motion.h"
#include "run/options.h"
#include "scene/scene.h"

#include <memory>
#include <string>
#include <vector>

namespace simulation {

// The unknowns that these expressions read, as Quantities does; faulty ones read none.
[[nodiscard]] std::vector<std::size_t> unknownsRead(const scene::Scene& scene,
                                                    const std::vector<std::string>& expressions);

// Quantities: any expression of the scene language, and scene.energy, scene.px .. scene.lz,
// events.collisions, read from a motion (command-line contract, "simulate").
class Quantities {
public:
    // Faulty expressions are reported in `faults`, one sentence each.
    Quantities(const scene::Scene& scene, const Options& options, MotionPointer motion,
               const std::vector<std::string>& expressions, std::vector<std::string>& faults);
    ~Quantities();
    Quantities(Quantities&&) noexcept;
    Quantities& operator=(Quantities&&) noexcept;

    // Of each expression: the sentence why it is faulty, "" of a sound one.
    [[nodiscard]] const std::vector<std::string>& faults() const;
    // One value per expression, at a time in start..computed; NaN where it is not defined, and of a
    // faulty one.
    [[nodiscard]] std::vector<double> at(double time) const;

private:
    friend class ReadableScene;
    struct Implementation;
    explicit Quantities(std::unique_ptr<Implementation> implementation);
    std::unique_ptr<Implementation> implementation_;
};

// A scene of which quantities are read again and again: of several motions, by any expressions. It
// builds the scene's equations once, which costs more than all else. It grows with each new
// expression. It belongs to one thread.
class ReadableScene {
public:
    explicit ReadableScene(const scene::Scene& scene, const Options& options = {});
    ~ReadableScene();
    ReadableScene(ReadableScene&&) noexcept;
    ReadableScene& operator=(ReadableScene&&) noexcept;

    // Why nothing can be read of the scene, one sentence each: nothing when it can.
    [[nodiscard]] const std::vector<std::string>& faults() const;
    [[nodiscard]] Quantities quantities(const MotionPointer& motion,
                                        const std::vector<std::string>& expressions);

private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
};

} // namespace simulation
