#include "surroundings/backdrop.h"

#include "drawing/shaders.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace render {

namespace {

using Shade = Eigen::Vector3f;

struct Shades {
    Shade near, far, haze, low, high; // ground, horizon, sky
};

const Shades& shadesOf(bool dark) {
    static const Shades light{{0.855F, 0.862F, 0.870F},
                              {0.915F, 0.920F, 0.926F},
                              {0.958F, 0.963F, 0.970F},
                              {0.915F, 0.938F, 0.965F},
                              {0.760F, 0.835F, 0.915F}};
    static const Shades night{{0.128F, 0.132F, 0.140F},
                              {0.185F, 0.191F, 0.202F},
                              {0.262F, 0.278F, 0.305F},
                              {0.205F, 0.222F, 0.252F},
                              {0.100F, 0.115F, 0.145F}};
    return dark ? night : light;
}

struct Stop {
    double at; // view units above the horizon
    Shade shade;
};

// The colours straight ahead, from the horizon upwards and downwards.
std::array<Stop, 7> stopsOf(const Shades& s) {
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

bool isDark(const scene::Color& c) { return 0.3 * c.red + 0.6 * c.green + 0.1 * c.blue < 0.45; }

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
    const Shades& shades = shadesOf(dark);
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
