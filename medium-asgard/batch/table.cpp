#include "batch/table.h"

#include "text/printable.h"

#include <array>
#include <charconv>
#include <cmath>

namespace batch {
namespace {

constexpr std::array bodyColumns{"x",  "y",  "z",  "dx", "dy", "dz", "qw",
                                 "qx", "qy", "qz", "wx", "wy", "wz"};

std::array<double, bodyColumns.size()> values(const simulation::BodyState& s) {
    return {s.position.x(),       s.position.y(), s.position.z(),        s.velocity.x(),
            s.velocity.y(),       s.velocity.z(), s.attitude.w(),        s.attitude.x(),
            s.attitude.y(),       s.attitude.z(), s.angularVelocity.x(), s.angularVelocity.y(),
            s.angularVelocity.z()};
}

std::string header(const scene::Scene& scene, const Columns& columns) {
    std::string line = "t";
    if (columns.bodies)
        for (const scene::Body& body : scene.bodies)
            for (const char* column : bodyColumns)
                line += "," + cell(body.name + "." + column);
    for (const std::string& quantity : columns.quantities)
        line += "," + cell(quantity);
    return line + "\n";
}

void addBody(std::string& line, const simulation::Motion& motion, std::size_t body, double time,
             Digits digits) {
    const auto stop = motion.stop(body);
    if (stop && time > stop->time) {
        line.append(bodyColumns.size(), ',');
        return;
    }
    for (const double value : values(motion.at(body, time)))
        line += "," + cell(value, digits);
}

} // namespace

std::string cell(const std::string& name) {
    std::string text = text::printable(name);
    if (text.find_first_of(",\"\r\n") == std::string::npos)
        return text;
    std::string quoted = "\"";
    for (const char c : text)
        quoted += c == '"' ? "\"\"" : std::string(1, c);
    return quoted + "\"";
}

std::string cell(double value, Digits digits) {
    if (std::isnan(value))
        return "";
    char text[40];
    if (digits == Digits::shortest)
        return {text, std::to_chars(text, text + sizeof text, value).ptr};
    const int length = std::snprintf(text, sizeof text, "%.17g", value);
    return {text, static_cast<std::size_t>(length)};
}

bool writeTable(std::FILE* file, const scene::Scene& scene, const simulation::Motion& motion,
                const simulation::Quantities& quantities, const Columns& columns,
                const std::vector<double>& times) {
    std::string line = header(scene, columns);
    bool written = std::fwrite(line.data(), 1, line.size(), file) == line.size();
    for (const double time : times) {
        if (time > motion.computed())
            continue;
        line = cell(time, columns.digits);
        if (columns.bodies)
            for (std::size_t body = 0; body < scene.bodies.size(); ++body)
                addBody(line, motion, body, time, columns.digits);
        if (!columns.quantities.empty())
            for (const double value : quantities.at(time))
                line += "," + cell(value, columns.digits);
        line += "\n";
        written = written && std::fwrite(line.data(), 1, line.size(), file) == line.size();
    }
    return std::fflush(file) == 0 && written;
}

} // namespace batch
