// A linked shader program.
#pragma once

#include "drawing/frame.h"
#include "drawing/gl.h"

#include <span>
#include <string>
#include <vector>

namespace render {

class Program {
public:
    explicit Program(const Gl& gl) : gl_(gl) {}
    ~Program();
    Program(const Program&) = delete;
    Program& operator=(const Program&) = delete;

    // "" or what the driver's compiler said.
    [[nodiscard]] std::string build(const char* vertexSource,
                                    const std::vector<const char*>& fragmentSources);
    void use() const { gl_.UseProgram(program_); }
    // The uniforms of a program with shadowFunctions (shaders.h); the maps are texture 0.
    void giveShadow(std::span<const LightSight> sights) const;
    [[nodiscard]] GLint place(const char* uniform) const {
        return gl_.GetUniformLocation(program_, uniform);
    }

private:
    const Gl& gl_;
    GLuint program_ = 0;
};

} // namespace render
