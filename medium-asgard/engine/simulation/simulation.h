// The engine's facade: a scene in, motion out.
//
// simulate() is the whole of it for batch use. Interactive use calls it on a worker thread with an
// Observer: progress publishes partial motion, cancelled() is polled at least every few
// milliseconds. The same scene and options give the same bits, whatever the thread, the observer
// or the machine's load.
#pragma once

#include "scene/scene.h"
#include "simulation/explanation.h"
#include "simulation/motion.h"

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace simulation {

struct Options {
    std::optional<double> accuracy; // overrides the scene's
    std::optional<double> finish;
    std::string method = ""; // "" : the scene's
    std::optional<double> fixedStep;
    bool whole = false;      // one component for the whole scene (dissertation 5.2.1, 5.2.4)
    bool eventDriven = true; // false: finish each component before the next (5.2.4, case 5)
    int threads = 1;         // 0: as many as the machine has cores; the motion is the same
    // These expressions are all that will be read of the motion, as Quantities: an orientation that
    // neither they nor anything in the scene read is not solved. None: all may be read.
    std::optional<std::vector<std::string>> only = std::nullopt;
    bool explain = false; // fill Result::explanation
    // A body or one of its unknowns ("rod1", "rod1.x"): of its components the explanation has every
    // form of the equations, down to machine code. "": of none.
    std::string phasesOf = "";
    std::map<std::string, double> parameters; // override the scene's values
};

struct Observer {
    std::function<bool()> cancelled;             // true: stop soon, keep what there is
    std::function<void(MotionPointer)> progress; // a longer motion; any thread
    // Every now and then, with the time that is worked at, in whichever run; the caller's thread.
    std::function<void(double time)> working = {};
};

// Work done, for tests and --stats. Counts are portable; seconds are not.
struct ComponentStatistics {
    std::size_t unknowns = 0;
    std::string model;  // "closed-form" | "quadrature" | "linear" | "explicit" | "implicit"
    std::string method; // "dop853", "radau5", ...
    std::size_t steps = 0, evaluations = 0;
};

// Of a motion that was computed further than it is wanted now, what was done beyond its finish
// counts: in the list of components, and in the bytes.
struct Statistics {
    double seconds = 0;        // CPU of the motion
    double secondsSolving = 0; // of these, without making the equations
    // Of the seconds: equations, partition and code of all runs; and the run that is delivered,
    // alone. What is left is the estimate of its error: other runs, and comparing them.
    double secondsSettingUp = 0, secondsMoving = 0;
    std::size_t steps = 0, rejectedSteps = 0, discardedSteps = 0;
    std::size_t unconvergedSteps = 0; // of the rejected: the implicit equations were not solved
    std::size_t evaluations = 0, equationEvaluations = 0, factorisations = 0;
    std::size_t pairTests = 0, collisions = 0;
    std::size_t components = 0, largestComponent = 0, historyBytes = 0;
    double reached = 0;
    std::optional<double> errorEstimate, predictableUntil;
    // The size, in m, of the island with the largest estimate; none: no runs were compared there.
    std::optional<double> movingSize;
    std::vector<ComponentStatistics> componentList;
};
// A motion whose estimate is over this is not predictable from Statistics::predictableUntil on;
// below, it is known, but not to the accuracy.
inline constexpr double unpredictable = 0.03;

struct Result {
    // Null when `refusal` says why nothing could be computed, or when it was cancelled before.
    MotionPointer motion;
    Statistics statistics;
    std::vector<std::string> refusal; // faults that make the scene unusable; then motion is null
    bool cancelled = false;
    std::optional<Explanation> explanation; // when asked for, and not cancelled
};

[[nodiscard]] Result simulate(const scene::Scene& scene, const Options& options = {},
                              const Observer& observer = {});

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
