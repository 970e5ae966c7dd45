#include "drawing/gl.h"

#include <EGL/egl.h>

namespace render {

std::string Gl::load() {
#define RENDER_GL_LOAD(type, name)                                                                 \
    name = reinterpret_cast<type>(eglGetProcAddress("gl" #name));                                  \
    if ((name) == nullptr)                                                                         \
        return "gl" #name;
    RENDER_GL_FUNCTIONS(RENDER_GL_LOAD)
#undef RENDER_GL_LOAD
    return "";
}

} // namespace render
