// How an engine of fixed steps or given accuracy plays the cases: it builds a world from a case's
// description, and rows of error and cost follow.
#pragma once

#include "cases.h"
#include "measurement.h"

#include <functional>
#include <memory>

namespace bench::contacts {

class World {
public:
    World() = default;
    virtual ~World() = default;
    World(const World&) = delete;
    World& operator=(const World&) = delete;

    // Goes on by `span`, in steps as the world was built with; counts them in steps().
    virtual void advance(double span) = 0;
    [[nodiscard]] virtual Place centre(std::size_t body) const = 0;
    [[nodiscard]] long steps() const { return steps_; }

protected:
    void count(long steps) { steps_ += steps; }

private:
    long steps_ = 0;
};

// `parameter` is the step or the accuracy. Null: this engine cannot play that case so.
using Build = std::function<std::unique_ptr<World>(const Case&, double parameter)>;

struct Way {
    std::string setting;
    std::vector<double> parameters; // the coarsest first
    Build build;
    std::vector<Feature> lacks{}; // a case that needs one of them has no row
};

// advance() goes on by the same span so many times.
inline constexpr int piecesOfRun = 100;

inline const std::vector<double> usualSteps = {1.0 / 60,   1.0 / 240, 1.0 / 1000,
                                               1.0 / 4000, 1e-4,      1e-5};

// Plays every wanted case in every way. A run is cut off after some seconds; then the row has no
// error, and finer parameters are left out.
void playAll(const Measurement& m, const std::vector<Way>& ways);

// The couple of a hinge's spring, for engines without one; they may tell the angle to a whole turn.
[[nodiscard]] double springCouple(const Joint& hinge, double angle);

// The number of steps of about `step` in `span`: at least one.
[[nodiscard]] long stepsIn(double span, double step);

} // namespace bench::contacts
