#include "surroundings/backdrop.h"

#include "drawing/shaders.h"
#include "framing/studio.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace render {

namespace {

using Shade = Eigen::Vector3f;

struct Stop {
    double at; // view units above the horizon
    Shade shade;
};

// The colours straight ahead, from the horizon upwards and downwards.
std::array<Stop, 7> stopsOf(const StudioColors& s) {
    return {{{-30, s.near},
             {-1.5, s.near},
             {-0.10, s.far},
             {0.03, s.haze},
             {0.55, s.low},
             {3.5, s.high},
             {30, s.high}}};
}

} // namespace

std::optional<Horizon> horizonOf(const Frame& frame, const Vector& upInView) {
    // Lines of sight (x, y, -D) that are level: up . (x, y, -D) = 0.
    const double across = upInView.head<2>().norm();
    if (frame.camera().orthographic || across < 0.05)
        return std::nullopt;
    return Horizon{upInView.head<2>() / across, eyeDistance * upInView.z() / across};
}

Backdrop::~Backdrop() {
    gl_.DeleteVertexArrays(1, &array_);
    gl_.DeleteBuffers(1, &buffer_);
}

std::string Backdrop::build() {
    if (std::string fault = program_.build(backdropVertexShader, {backdropFragmentShader});
        !fault.empty())
        return fault;
    gl_.GenVertexArrays(1, &array_);
    gl_.GenBuffers(1, &buffer_);
    gl_.BindVertexArray(array_);
    gl_.BindBuffer(GL_ARRAY_BUFFER, buffer_);
    for (GLuint i = 0; i < 2; ++i) {
        gl_.EnableVertexAttribArray(i);
        gl_.VertexAttribPointer(i, i == 0 ? 2 : 3, GL_FLOAT, GL_FALSE, 5 * sizeof(float),
                                asPointer(2 * i * sizeof(float)));
    }
    return "";
}

void Backdrop::show(const Frame& frame, const Vector& upInView, bool dark) const {
    const StudioColors& shades = studioColors(dark);
    std::vector<Stop> stops;
    Horizon horizon;
    if (const auto seen = horizonOf(frame, upInView)) {
        horizon = *seen;
        const auto all = stopsOf(shades);
        stops.assign(all.begin(), all.end());
    } else if (frame.camera().orthographic) {
        stops = {{-4, shades.far}, {-1.2, shades.far}, {1.4, shades.low}, {4, shades.low}};
    } else {
        const Shade& one = upInView.z() > 0 ? shades.near : shades.high;
        stops = {{-4, one}, {4, one}};
    }
    const double units = 2 * pixelsPerUnit(frame.size());
    const Eigen::Vector2d toClip(units / frame.size().width, -units / frame.size().height);
    const Eigen::Vector2d along(horizon.toSky.y(), -horizon.toSky.x());
    const double reach = 2 * Eigen::Vector2d(toClip.cwiseInverse()).norm();
    std::vector<float> vertices;
    for (const Stop& stop : stops)
        for (const double side : {-reach, reach}) {
            const Eigen::Vector2d place =
                toClip.cwiseProduct((horizon.offset + stop.at) * horizon.toSky + side * along);
            vertices.insert(vertices.end(),
                            {static_cast<float>(place.x()), static_cast<float>(place.y()),
                             stop.shade.x(), stop.shade.y(), stop.shade.z()});
        }
    program_.use();
    gl_.BindVertexArray(array_);
    gl_.BindBuffer(GL_ARRAY_BUFFER, buffer_);
    gl_.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices.size() * sizeof(float)),
                   vertices.data(), GL_STREAM_DRAW);
    gl_.DepthMask(GL_FALSE);
    gl_.Disable(GL_CULL_FACE);
    gl_.DrawArrays(GL_TRIANGLE_STRIP, 0, static_cast<GLsizei>(2 * stops.size()));
    gl_.Enable(GL_CULL_FACE);
    gl_.DepthMask(GL_TRUE);
}

} // namespace render
