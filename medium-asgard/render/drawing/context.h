// An OpenGL 3.3 core context that needs no window, no display server and no graphics processor.
//
// EGL's surfaceless platform first (Mesa, llvmpipe included), then its device platform (NVIDIA).
// The default display is never asked for: without a server it fails (docs/feasibility.md 3).
#pragma once

#include <EGL/egl.h>

#include <memory>
#include <string>
#include <variant>

namespace render {

class Context {
public:
    // A context, current in this thread, or the sentence that says why there is none.
    [[nodiscard]] static std::variant<std::unique_ptr<Context>, std::string> create();
    ~Context();
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;

    // False when the context is lost.
    [[nodiscard]] bool makeCurrent() const;

private:
    Context(EGLDisplay display, EGLContext context) : display_(display), context_(context) {}

    EGLDisplay display_;
    EGLContext context_;
};

} // namespace render
