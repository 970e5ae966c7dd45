// Draws a scene at a time into pixels.
//
// One renderer for documents, windows and files: EGL surfaceless, its own framebuffer, core profile
// 3.3, no Qt. A Renderer owns one GL context and belongs to the thread that made it.
#pragma once

#include "drawing/drawing.h"
#include "surroundings/grid.h"

#include <memory>
#include <optional>
#include <string>
#include <variant>

namespace render {

class Renderer {
public:
    // A renderer, or the sentence that says why there is none (no EGL, no driver: names the
    // package).
    [[nodiscard]] static std::variant<std::unique_ptr<Renderer>, std::string> create();
    ~Renderer();

    // The next pictures have the ground there, unless bodies are its floor; none: where their
    // scene's motion has it.
    void keepGround(const std::optional<GroundPlane>& ground);
    // Draws and reads back. False when the context was lost; then make a new renderer.
    [[nodiscard]] bool draw(const Drawing& drawing, const Image& into);
    // The plane of the last picture's grid; none: it has no grid.
    [[nodiscard]] const std::optional<GroundPlane>& ground() const;

    [[nodiscard]] int maximumSamples() const;
    [[nodiscard]] int maximumSize() const;
    [[nodiscard]] std::string description() const; // driver and version, for About

private:
    Renderer();
    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
};

} // namespace render
