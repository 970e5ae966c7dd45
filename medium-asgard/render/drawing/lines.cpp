#include "drawing/lines.h"

#include "drawing/shaders.h"

#include <cstddef>

namespace render {

Lines::~Lines() {
    gl_.DeleteVertexArrays(1, &array_);
    gl_.DeleteBuffers(1, &buffer_);
}

std::string Lines::build() {
    if (std::string fault = program_.build(lineVertexShader, {lineFragmentShader}); !fault.empty())
        return fault;
    gl_.GenVertexArrays(1, &array_);
    gl_.GenBuffers(1, &buffer_);
    gl_.BindVertexArray(array_);
    gl_.BindBuffer(GL_ARRAY_BUFFER, buffer_);
    const struct {
        GLint count;
        std::size_t offset;
    } attributes[] = {{3, offsetof(Segment, from)},
                      {3, offsetof(Segment, to)},
                      {4, offsetof(Segment, colorFrom)},
                      {4, offsetof(Segment, colorTo)},
                      {2, offsetof(Segment, width)}};
    for (GLuint i = 0; i < 5; ++i) {
        gl_.EnableVertexAttribArray(i);
        gl_.VertexAttribPointer(i, attributes[i].count, GL_FLOAT, GL_FALSE, sizeof(Segment),
                                asPointer(attributes[i].offset));
        gl_.VertexAttribDivisor(i, 1);
    }
    return "";
}

void Lines::begin(const Frame& frame, const std::array<float, 16>& projection) {
    projection_ = projection;
    halfSize_ = frame.halfSize();
    limit_ = frame.eye().z() - 0.02;
    segments_.clear();
}

void Lines::add(Eigen::Vector3d from, Eigen::Vector3d to, const Ink& ink, float alphaTo) {
    const double limit = limit_;
    if (from.z() > limit && to.z() > limit)
        return;
    if (from.z() > limit)
        from += (limit - from.z()) / (to.z() - from.z()) * (to - from);
    if (to.z() > limit)
        to += (limit - to.z()) / (from.z() - to.z()) * (from - to);
    Segment s{};
    for (int i = 0; i < 3; ++i) {
        s.from[i] = static_cast<float>(from[i]);
        s.to[i] = static_cast<float>(to[i]);
        s.colorFrom[i] = s.colorTo[i] = ink.color[i];
    }
    s.colorFrom[3] = ink.alpha;
    s.colorTo[3] = alphaTo;
    s.width[0] = s.width[1] = ink.width;
    segments_.push_back(s);
}

void Lines::addPointed(const Eigen::Vector3d& from, const Eigen::Vector3d& to, const Ink& ink) {
    const std::size_t before = segments_.size();
    add(from, to, ink);
    if (segments_.size() > before)
        segments_.back().width[1] = 0;
}

void Lines::show(float nearer, float opacity) const {
    if (segments_.empty())
        return;
    program_.use();
    gl_.UniformMatrix4fv(program_.place("projection"), 1, GL_FALSE, projection_.data());
    gl_.Uniform2f(program_.place("halfSize"), halfSize_.x(), halfSize_.y());
    gl_.Uniform1f(program_.place("nearer"), nearer);
    gl_.Uniform1f(program_.place("opacity"), opacity);
    gl_.BindVertexArray(array_);
    gl_.BindBuffer(GL_ARRAY_BUFFER, buffer_);
    gl_.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(segments_.size() * sizeof(Segment)),
                   segments_.data(), GL_STREAM_DRAW);
    gl_.DrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(segments_.size()));
}

} // namespace render
