#include "batch/input.h"

#include "batch/command.h"
#include "files/read.h"
#include "physics/assembly.h"
#include "reports/report.h"
#include "script/locate.h"
#include "terminal/terminal.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <sstream>

namespace batch {
namespace {

constexpr std::size_t mostTimes = 50'000'000;
// LIMIT: what is read of one input. What a scene may have, script::Reader says.
constexpr std::size_t longestInput = std::size_t{64} << 20;

std::string_view withoutBlanks(std::string_view text) {
    constexpr std::string_view blanks = " \t\r\n";
    const std::size_t begin = text.find_first_not_of(blanks);
    if (begin == std::string_view::npos)
        return {};
    return text.substr(begin, text.find_last_not_of(blanks) + 1 - begin);
}

std::string quoted(std::string_view text) { return "\"" + std::string(text) + "\""; }

} // namespace

int refuse(const Refusal& refusal) {
    if (!refusal.message.empty())
        terminal::complain("asgard: " + refusal.message);
    for (const std::string& fault : refusal.faults)
        terminal::complain(fault);
    return refusal.exitCode;
}

std::variant<std::string, Refusal> contentOf(const std::string& file) {
    files::FileSystem& system = files::FileSystem::real();
    files::ReadFile input =
        file == "-" ? files::readStandardInput(system, longestInput)
                    : files::readFile(system, file, longestInput, files::Source::stream);
    if (!input.read)
        return Refusal{failure, (file == "-" ? "standard input" : file) + ": " + input.reason};
    return std::move(input.bytes);
}

std::variant<SceneText, Refusal> readScene(script::Reader& reader, const std::string& file,
                                           const std::map<std::string, double>& parameters) {
    auto content = contentOf(file);
    if (auto* refusal = std::get_if<Refusal>(&content))
        return *refusal;
    SceneText scene{
        file == "-" ? "standard input" : file, std::get<std::string>(std::move(content)), {}};
    scene.reading = reader.read(scene.text, parameters);
    if (scene.reading.usable && scene.reading.scene.bodies.empty()) {
        scene::Diagnostic nothing;
        nothing.severity = scene::Severity::warning;
        nothing.message = "the scene has no body, so nothing moves";
        scene.reading.diagnostics.push_back(std::move(nothing));
    }
    return scene;
}

std::vector<std::string> faultsOf(const SceneText& scene) {
    std::vector<std::string> all;
    for (const scene::Diagnostic& diagnostic : scene.reading.diagnostics)
        all.push_back(placed(scene, diagnostic));
    return all;
}

std::string placed(const SceneText& scene, scene::Diagnostic said) {
    for (const std::string_view button : {physics::closeButton, physics::partButton})
        if (const auto at = said.message.rfind(button); at != std::string::npos) // there is none
            said.message.replace(at, button.size(), "\"asgard assemble SCENE\"");
    script::locate(text::Places(scene.text), said);
    return scene::formatted(said, scene.file, scene.text);
}

Refusal refusalOf(const SceneText& scene, const std::vector<std::string>& sentences) {
    Refusal refusal;
    for (const std::string& sentence : sentences)
        refusal.faults.push_back(placed(scene, simulation::faultOf(scene.reading.scene, sentence)));
    return refusal;
}

bool tell(const SceneText& scene, const simulation::Motion& motion) {
    bool stopped = false;
    for (const scene::Diagnostic& said : simulation::reportOf(scene.reading.scene, motion)) {
        terminal::complain(placed(scene, said));
        stopped = stopped || said.severity == scene::Severity::error;
    }
    return stopped;
}

std::optional<Refusal> unusable(const SceneText& scene) {
    if (!scene.reading.usable)
        return Refusal{failure, {}, faultsOf(scene)};
    for (const std::string& fault : faultsOf(scene))
        terminal::complain(fault);
    return std::nullopt;
}

std::optional<double> numberOf(std::string_view text) {
    text = withoutBlanks(text);
    if (text.starts_with('+'))
        text.remove_prefix(1);
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value))
        return std::nullopt;
    return value;
}

std::variant<std::map<std::string, double>, Refusal>
settings(const std::vector<std::string>& written) {
    std::map<std::string, double> values;
    for (const std::string& setting : written) {
        const std::size_t equals = setting.find('=');
        const auto value = equals == std::string::npos
                               ? std::nullopt
                               : numberOf(std::string_view(setting).substr(equals + 1));
        if (!value || equals == 0)
            return Refusal{wrongUsage,
                           "--set wants NAME=VALUE with a number, not " + quoted(setting)};
        values[setting.substr(0, equals)] = *value;
    }
    return values;
}

std::optional<Refusal> outOfBounds(const scene::Scene& scene,
                                   const std::map<std::string, double>& parameters) {
    const auto written = [](double value) {
        char text[40];
        std::snprintf(text, sizeof text, "%g", value);
        return std::string(text);
    };
    for (const scene::Parameter& parameter : scene.parameters) {
        const auto set = parameters.find(parameter.name);
        if (set == parameters.end())
            continue;
        if (parameter.minimum && set->second < *parameter.minimum)
            return Refusal{failure, "--set " + parameter.name + ": " + written(set->second) +
                                        " is under its minimum " + written(*parameter.minimum)};
        if (parameter.maximum && set->second > *parameter.maximum)
            return Refusal{failure, "--set " + parameter.name + ": " + written(set->second) +
                                        " is over its maximum " + written(*parameter.maximum)};
    }
    return std::nullopt;
}

std::variant<OpenScene, Refusal> openScene(script::Reader& reader, const std::string& file,
                                           const std::vector<std::string>& written) {
    auto parameters = settings(written);
    if (const auto* refusal = std::get_if<Refusal>(&parameters))
        return *refusal;
    auto& values = std::get<std::map<std::string, double>>(parameters);
    auto read = readScene(reader, file, values);
    if (const auto* refusal = std::get_if<Refusal>(&read))
        return *refusal;
    auto& scene = std::get<SceneText>(read);
    if (const auto refusal = unusable(scene))
        return *refusal;
    if (const auto refusal = outOfBounds(scene.reading.scene, values))
        return *refusal;
    return OpenScene{std::move(scene), std::move(values)};
}

std::variant<std::vector<double>, Refusal> timesAt(const std::string& range) {
    const std::size_t first = range.find(':'), second = range.find(':', first + 1);
    const Refusal wrong{wrongUsage,
                        "--at wants T0:DT:T1 with DT > 0 and T1 >= T0, not " + quoted(range)};
    if (first == std::string::npos || second == std::string::npos)
        return wrong;
    const auto from = numberOf(std::string_view(range).substr(0, first));
    const auto step = numberOf(std::string_view(range).substr(first + 1, second - first - 1));
    const auto to = numberOf(std::string_view(range).substr(second + 1));
    if (!from || !step || !to || *step <= 0 || *to < *from)
        return wrong;
    const double count = std::floor((*to - *from) / *step + 1e-9);
    if (!(count < static_cast<double>(mostTimes)))
        return Refusal{wrongUsage, "--at " + range + " are too many times"};
    std::vector<double> times;
    for (std::size_t i = 0; i <= static_cast<std::size_t>(count); ++i) {
        const double time = *from + *step * static_cast<double>(i);
        // The last one is T1 itself, not what sums to it.
        times.push_back(std::abs(time - *to) <= 1e-9 * *step ? *to : time);
    }
    return times;
}

std::variant<std::vector<double>, Refusal> timesIn(const std::string& text,
                                                   const std::string& file) {
    std::vector<double> times;
    std::istringstream lines(text);
    std::string line;
    for (int number = 1; std::getline(lines, line); ++number) {
        line.resize(std::min(line.find('#'), line.size()));
        std::ranges::replace(line, ',', ' ');
        std::istringstream words(line);
        for (std::string word; words >> word;) {
            const auto time = numberOf(word);
            if (!time)
                return Refusal{failure, file + ":" + std::to_string(number) +
                                            ": error: " + quoted(word) + " is not a time"};
            times.push_back(*time);
        }
    }
    return times;
}

std::vector<double> usualTimes(double start, double finish) {
    std::vector<double> times;
    constexpr int intervals = 100;
    for (int i = 0; i <= intervals; ++i)
        times.push_back(i == intervals ? finish : start + (finish - start) * i / intervals);
    return times;
}

std::vector<std::string> quantitiesIn(std::string_view list) {
    std::vector<std::string> quantities;
    std::size_t begin = 0;
    int depth = 0;
    for (std::size_t i = 0; i <= list.size(); ++i) {
        if (i < list.size() && (list[i] != ',' || depth > 0)) {
            depth += list[i] == '(' ? 1 : list[i] == ')' ? -1 : 0;
            continue;
        }
        quantities.emplace_back(withoutBlanks(list.substr(begin, i - begin)));
        begin = i + 1;
    }
    return quantities;
}

} // namespace batch
