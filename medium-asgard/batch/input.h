// The input of batch commands: scenes, parameter settings, lists of times and of quantities.
#pragma once

#include "motion/motion.h"
#include "script/reader.h"

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace batch {

// A command that cannot go on: its exit code, and what standard error gets: one sentence, or faults
// with their places.
struct Refusal {
    int exitCode = 1;
    std::string message{};
    std::vector<std::string> faults{};
};

// Says it on standard error. Returns its exit code.
[[nodiscard]] int refuse(const Refusal& refusal);

// The bytes of a file, a pipe or a device, or of standard input for "-". Of more than 64 MB, an
// input without end too, nothing is taken.
[[nodiscard]] std::variant<std::string, Refusal> contentOf(const std::string& file);

struct SceneText {
    std::string file, text;
    script::ReadResult reading;
};
// The scene, readable or not, with the parameters set.
[[nodiscard]] std::variant<SceneText, Refusal>
readScene(script::Reader& reader, const std::string& file,
          const std::map<std::string, double>& parameters = {});
// Each diagnostic with its place and its line.
[[nodiscard]] std::vector<std::string> faultsOf(const SceneText& scene);
// A diagnostic of a run, with its place and its line.
[[nodiscard]] std::string placed(const SceneText& scene, scene::Diagnostic said);
// Why nothing could be computed: each sentence at its place.
[[nodiscard]] Refusal refusalOf(const SceneText& scene, const std::vector<std::string>& sentences);
// The faults and notes of a motion, on standard error. True when something stopped.
[[nodiscard]] bool tell(const SceneText& scene, const simulation::Motion& motion);
// The reason why a scene cannot be worked with; none when it can. Warnings are printed either way.
[[nodiscard]] std::optional<Refusal> unusable(const SceneText& scene);

// NAME=VALUE each.
[[nodiscard]] std::variant<std::map<std::string, double>, Refusal>
settings(const std::vector<std::string>& written);
// A setting outside its parameter's bounds.
[[nodiscard]] std::optional<Refusal> outOfBounds(const scene::Scene& scene,
                                                 const std::map<std::string, double>& parameters);

// A scene that can be worked with, its parameters set as `written` on the command line.
struct OpenScene {
    SceneText scene;
    std::map<std::string, double> parameters;
};
[[nodiscard]] std::variant<OpenScene, Refusal>
openScene(script::Reader& reader, const std::string& file, const std::vector<std::string>& written);

[[nodiscard]] std::optional<double> numberOf(std::string_view text);

// T0:DT:T1, up to T1 inclusive (within 1e-9 DT).
[[nodiscard]] std::variant<std::vector<double>, Refusal> timesAt(const std::string& range);
// Numbers with blanks or commas between them; # starts a comment.
[[nodiscard]] std::variant<std::vector<double>, Refusal> timesIn(const std::string& text,
                                                                 const std::string& file);
// 101 equal ones.
[[nodiscard]] std::vector<double> usualTimes(double start, double finish);

// Split at commas outside parentheses; blanks around each are dropped.
[[nodiscard]] std::vector<std::string> quantitiesIn(std::string_view list);

} // namespace batch
