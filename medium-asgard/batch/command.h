// The commands of `asgard` that open no window: simulate, explain, study, check,
// assemble, render
// (docs/command-line.md).
//
// Each takes its arguments as they were written and returns the exit code: 0, 1 when the work
// failed, 2 when it was asked for wrongly. Sentences go to standard error, results to standard
// output or a file; nothing is written when the request is refused.
#pragma once

#include "script/reader.h"

#include <optional>
#include <string>
#include <vector>

namespace batch {

inline constexpr int success = 0, failure = 1, wrongUsage = 2;

struct SimulateArguments {
    std::string scene;
    std::string csv = "-";
    std::optional<std::string> at, times, quantities;
    bool only = false;
    std::optional<double> accuracy, finish;
    std::string method;
    std::optional<double> fixedStep;
    bool whole = false, noEvents = false;
    bool verbose = false;         // the line about the accuracy is written without it, too
    std::optional<int> threads;   // none: as many as the machine has cores
    std::optional<double> memory; // MB that may be kept of a run
    std::vector<std::string> set;
    std::optional<std::string> stats, events;
};

struct ExplainArguments {
    std::string scene;
    std::optional<std::string> json;
    std::optional<std::string> expressions; // a body or one of its unknowns
    bool all = false;                       // nothing is cut
    std::vector<std::string> set;
};

struct StudyArguments {
    std::string scene;
    std::string csv = "-";
    std::optional<std::string> methods, accuracies, steps, reference, output;
    double limit = 2; // CPU seconds for each run
    std::vector<std::string> set;
};

struct AssembleArguments {
    std::string scene;
    std::optional<std::string> output; // none: the scene's own file
};

struct CheckArguments {
    std::string scene;
};

struct RenderArguments {
    std::string scene;
    std::optional<double> time, from, to, fps;
    std::string size = "640x480";
    std::string view;
    bool wireframe = false;
    std::string background; // as -color of a shape; "": white
    std::string output;
};

[[nodiscard]] int studyCommand(script::Reader& reader, const StudyArguments& arguments);
[[nodiscard]] int simulateCommand(script::Reader& reader, const SimulateArguments& arguments);
[[nodiscard]] int explainCommand(script::Reader& reader, const ExplainArguments& arguments);
[[nodiscard]] int assembleCommand(script::Reader& reader, const AssembleArguments& arguments);
[[nodiscard]] int checkCommand(script::Reader& reader, const CheckArguments& arguments);
[[nodiscard]] int renderCommand(script::Reader& reader, const RenderArguments& arguments);

} // namespace batch
