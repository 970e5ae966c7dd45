// How do the methods do on this scene? Each runs over accuracies (adaptive) and over fixed steps;
// its error is measured against a reference, and where it fails the study says how.
//
//     not_finite   a force has no finite value, on the way of the reference too
//     unstable     it left all bounds, or its error is larger than what moves; when it was stopped
//                  at the limit: it was a thousand times as far away as anything is
//     newton       the implicit equations were not solved: it stopped there, or more steps were
//                  refused for that than were made
//     ringing      what a velocity is off at the ends of steps goes to and fro over twelve of them
//                  without halving, by more than 1e-6 of the largest speed; with an accuracy,
//                  by more than ten times that, and not of an explicit method, whose steps such an
//                  accuracy keeps at the edge of stability
//     drift        energy that the reference keeps has moved by more than a hundredth of the
//                  largest kinetic energy, between the first quarter of the motion and the last
//     not_reached  it ended early; or, with an accuracy, its error is over ten times that; or, at a
//                  fixed step, over a tenth of what moves, so that no digit is right
//     too_slow     it was stopped at the limit
//
// The first that holds counts; of what was stopped at the limit, unstable or too_slow.
#pragma once

#include "accuracy/accuracy.h"
#include "simulation/simulation.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace simulation {

enum class Status { ok, unstable, ringing, drift, newton, tooSlow, notReached, notFinite };
[[nodiscard]] const char* nameOf(Status status);

struct StudyRow {
    std::string method;
    std::optional<double> accuracy, step; // one of them
    std::optional<double> error = {};     // scaled as the accuracy; none: it did not arrive
    double seconds = 0;                   // CPU, the least of up to three runs
    std::size_t steps = 0, evaluations = 0;
    Status status = Status::ok;
    bool isAuto = false; // what `auto` does for the scene's accuracy, or for the nearest
};

struct StudyResult {
    std::vector<StudyRow> rows;
    double referenceAccuracy = 0;     // of the engine's own reference run
    std::string autoTakes;            // the methods of that row, most steps first; "": no row yet
    std::vector<std::string> refusal; // why there are no rows
};

struct StudyPlan {
    std::vector<std::string> methods;
    std::vector<double> accuracies, steps;
    std::optional<Trace> reference; // instead of the engine's own
    double limit = 2;               // CPU seconds for one run

    std::function<bool()> cancelled = {}; // true: stop soon; the rows so far are the result
    std::function<void(const StudyResult&)> progress = {}; // another row is known
};

// Every method that a study can compare, `auto` first.
[[nodiscard]] std::vector<std::string> studyMethods();

// All methods, accuracies from 1e-2 to 1e-8, and fixed steps of a hundredth of the motion and less.
[[nodiscard]] StudyPlan usualPlan(const scene::Scene& scene);

[[nodiscard]] StudyResult study(const scene::Scene& scene, const Options& options,
                                const StudyPlan& plan);

} // namespace simulation
