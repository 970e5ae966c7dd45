#include "batch/reference_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

namespace batch {
namespace {

std::vector<std::string> cellsOf(std::string line) {
    if (line.ends_with('\r'))
        line.pop_back();
    std::vector<std::string> cells(1);
    for (const char c : line) {
        if (c == ',')
            cells.emplace_back();
        else if (c != '"')
            cells.back() += c;
    }
    return cells;
}

struct BodyColumns {
    std::array<std::optional<std::size_t>, 7> at; // x y z qw qx qy qz
};

std::vector<BodyColumns> columnsOf(const std::vector<std::string>& head,
                                   const scene::Scene& scene) {
    static const char* names[] = {"x", "y", "z", "qw", "qx", "qy", "qz"};
    std::vector<BodyColumns> columns(scene.bodies.size());
    for (std::size_t b = 0; b < columns.size(); ++b)
        for (std::size_t k = 0; k < 7; ++k) {
            const auto found = std::ranges::find(head, scene.bodies[b].name + "." + names[k]);
            if (found != head.end())
                columns[b].at[k] = static_cast<std::size_t>(found - head.begin());
        }
    return columns;
}

std::optional<simulation::Trace::Place> placeIn(const std::vector<std::string>& cells,
                                                const BodyColumns& columns) {
    std::array<std::optional<double>, 7> values;
    for (std::size_t k = 0; k < 7; ++k)
        if (columns.at[k] && *columns.at[k] < cells.size())
            values[k] = numberOf(cells[*columns.at[k]]);
    if (!values[0] || !values[1] || !values[2])
        return std::nullopt;
    simulation::Trace::Place place;
    place.position = {*values[0], *values[1], *values[2]};
    if (values[3] && values[4] && values[5] && values[6])
        place.attitude =
            simulation::Quaternion(*values[3], *values[4], *values[5], *values[6]).normalized();
    return place;
}

} // namespace

std::variant<simulation::Trace, Refusal> referenceIn(const std::string& file,
                                                     const scene::Scene& scene) {
    const auto content = contentOf(file);
    if (const auto* refusal = std::get_if<Refusal>(&content))
        return *refusal;
    std::istringstream lines(std::get<std::string>(content));
    std::string line;
    std::getline(lines, line);
    const std::vector<std::string> head = cellsOf(line);
    if (head.empty() || head[0] != "t")
        return Refusal{1, file + ":1:1: error: the first column of a reference is t"};
    const std::vector<BodyColumns> columns = columnsOf(head, scene);
    simulation::Trace trace;
    bool any = false;
    for (std::size_t number = 2; std::getline(lines, line); ++number) {
        const std::vector<std::string> cells = cellsOf(line);
        const auto time = numberOf(cells[0]);
        if (!time)
            return Refusal{1, file + ":" + std::to_string(number) + ":1: error: this is no time"};
        if (*time < scene.simulator.start || *time > scene.simulator.finish)
            continue;
        trace.times.push_back(*time);
        auto& places = trace.places.emplace_back();
        for (const BodyColumns& body : columns)
            places.push_back(placeIn(cells, body));
        any = any || std::ranges::any_of(places, [](const auto& p) { return p.has_value(); });
    }
    if (!any)
        return Refusal{1, file + ": error: no places of the scene's bodies within its motion"};
    return trace;
}

} // namespace batch
