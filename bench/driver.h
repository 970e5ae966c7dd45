// Our engine on a scene's text: what is timed is split as others' times are. `motion` is the run
// that is delivered, from its first step on; `with estimate` adds the runs that its error is
// estimated from; `all` adds equations, partition and code. Reading the text is not in any.
#pragma once

#include "measurement.h"

#include "script/reader.h"
#include "simulation/simulation.h"

#include <functional>
#include <string>
#include <vector>

namespace bench {

class Driver {
public:
    explicit Driver(const Measurement& m) : m_(m) {}

    [[nodiscard]] const Measurement& measurement() const { return m_; }
    // Ends the program, with the reader's message, where the text has an error.
    [[nodiscard]] scene::Scene read(const std::string& text);
    // errorOf: of a motion; the name of the scene may have more names with other errors. A run that
    // takes more than `longest` seconds is cut off, its error is no number, and smaller accuracies
    // are left out.
    void run(const std::string& name, const scene::Scene& scene,
             const std::vector<double>& accuracies,
             const std::function<double(const simulation::Motion&)>& errorOf,
             double longest = 60) const;

private:
    const Measurement& m_;
    script::Reader reader_;
};

} // namespace bench
