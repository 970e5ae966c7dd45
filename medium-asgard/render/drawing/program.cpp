#include "drawing/program.h"

#include <algorithm>
#include <array>

namespace render {

namespace {

std::string compile(const Gl& gl, GLuint shader, const std::vector<const char*>& sources) {
    gl.ShaderSource(shader, static_cast<GLsizei>(sources.size()), sources.data(), nullptr);
    gl.CompileShader(shader);
    GLint done = 0;
    gl.GetShaderiv(shader, GL_COMPILE_STATUS, &done);
    if (done == GL_TRUE)
        return "";
    std::string log(4096, '\0');
    GLsizei length = 0;
    gl.GetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), &length, log.data());
    log.resize(static_cast<std::size_t>(length));
    return log.empty() ? "the shader does not compile" : log;
}

} // namespace

Program::~Program() { gl_.DeleteProgram(program_); }

void Program::giveShadow(std::span<const LightSight> sights) const {
    std::array<float, 16 * mostShadowMaps> matrices{};
    std::array<float, mostShadowMaps> texels{}, softness{};
    for (std::size_t i = 0; i < sights.size(); ++i) {
        std::ranges::copy(sights[i].columns(), matrices.begin() + static_cast<long>(16 * i));
        texels[i] = static_cast<float>(sights[i].texel);
        softness[i] = static_cast<float>(sights[i].softness);
    }
    const auto count = static_cast<GLsizei>(sights.size());
    gl_.UniformMatrix4fv(place("toMap"), count, GL_FALSE, matrices.data());
    gl_.Uniform2f(place("texel"), texels[0], texels[1]);
    gl_.Uniform2f(place("softness"), softness[0], softness[1]);
    gl_.Uniform1i(place("maps"), count);
    gl_.Uniform1i(place("samples"), sights.front().samples);
    gl_.Uniform1i(place("shadowMap"), 0);
}

std::string Program::build(const char* vertexSource,
                           const std::vector<const char*>& fragmentSources) {
    const GLuint vertex = gl_.CreateShader(GL_VERTEX_SHADER);
    const GLuint fragment = gl_.CreateShader(GL_FRAGMENT_SHADER);
    program_ = gl_.CreateProgram();
    std::string fault = compile(gl_, vertex, {vertexSource});
    if (fault.empty())
        fault = compile(gl_, fragment, fragmentSources);
    if (fault.empty()) {
        gl_.AttachShader(program_, vertex);
        gl_.AttachShader(program_, fragment);
        gl_.LinkProgram(program_);
        GLint done = 0;
        gl_.GetProgramiv(program_, GL_LINK_STATUS, &done);
        if (done != GL_TRUE)
            fault = "the shader does not link";
    }
    gl_.DeleteShader(vertex);
    gl_.DeleteShader(fragment);
    return fault;
}

} // namespace render
