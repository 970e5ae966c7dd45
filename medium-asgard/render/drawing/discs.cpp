#include "drawing/discs.h"

#include "drawing/shaders.h"

#include <cstddef>

namespace render {

Discs::~Discs() {
    gl_.DeleteVertexArrays(1, &array_);
    gl_.DeleteBuffers(1, &buffer_);
}

std::string Discs::build() {
    if (std::string fault = program_.build(discVertexShader, {discFragmentShader}); !fault.empty())
        return fault;
    gl_.GenVertexArrays(1, &array_);
    gl_.GenBuffers(1, &buffer_);
    gl_.BindVertexArray(array_);
    gl_.BindBuffer(GL_ARRAY_BUFFER, buffer_);
    const struct {
        GLint count;
        std::size_t offset;
    } attributes[] = {{3, offsetof(Instance, middle)},
                      {4, offsetof(Instance, fill)},
                      {4, offsetof(Instance, rim)},
                      {2, offsetof(Instance, radius)}};
    for (GLuint i = 0; i < 4; ++i) {
        gl_.EnableVertexAttribArray(i);
        gl_.VertexAttribPointer(i, attributes[i].count, GL_FLOAT, GL_FALSE, sizeof(Instance),
                                asPointer(attributes[i].offset));
        gl_.VertexAttribDivisor(i, 1);
    }
    return "";
}

void Discs::show(const std::vector<Disc>& discs, const Frame& frame,
                 const std::array<float, 16>& projection, float opacity) const {
    std::vector<Instance> instances;
    for (const Disc& disc : discs) {
        if (disc.middle.z() > frame.eye().z() - 0.02)
            continue; // beside or behind the eye
        Instance one{};
        for (int i = 0; i < 3; ++i)
            one.middle[i] = static_cast<float>(disc.middle[i]);
        for (int i = 0; i < 4; ++i) {
            one.fill[i] = disc.fill[i];
            one.rim[i] = disc.rim[i];
        }
        one.radius[0] = disc.radius;
        one.radius[1] = disc.rimWidth;
        instances.push_back(one);
    }
    if (instances.empty())
        return;
    program_.use();
    gl_.UniformMatrix4fv(program_.place("projection"), 1, GL_FALSE, projection.data());
    gl_.Uniform2f(program_.place("halfSize"), frame.halfSize().x(), frame.halfSize().y());
    gl_.Uniform1f(program_.place("opacity"), opacity);
    gl_.BindVertexArray(array_);
    gl_.BindBuffer(GL_ARRAY_BUFFER, buffer_);
    gl_.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(instances.size() * sizeof(Instance)),
                   instances.data(), GL_STREAM_DRAW);
    gl_.Disable(GL_CULL_FACE);
    gl_.DrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(instances.size()));
    gl_.Enable(GL_CULL_FACE);
}

} // namespace render
