#include "drawing/program.h"

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

void Program::giveShadow(const LightSight& sight) const {
    const std::array<float, 16> matrix = sight.columns();
    gl_.UniformMatrix4fv(place("toMap"), 1, GL_FALSE, matrix.data());
    gl_.Uniform1f(place("texel"), static_cast<float>(sight.texel));
    gl_.Uniform1f(place("softness"), static_cast<float>(sight.softness));
    gl_.Uniform1i(place("samples"), sight.samples);
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
