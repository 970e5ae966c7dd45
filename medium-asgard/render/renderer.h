// Draws a scene at a time into pixels.
//
// One renderer for documents, windows and files: EGL surfaceless, its own framebuffer, core profile
// 3.3, no Qt. A Renderer owns one GL context and belongs to the thread that made it.
#pragma once

#include "drawing/drawing.h"
#include "surroundings/grid.h"

#include <cstdint>
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

    struct Surroundings {
        std::optional<GroundPlane> ground; // none: there is no grid
        Vector sun = Vector::UnitY();      // the direction to it
    };
    // Draws and reads back, with the surroundings that the scene's motion asks for. False when the
    // context was lost; then make a new renderer.
    [[nodiscard]] bool draw(const Drawing& drawing, const Image& into);
    enum class Keeps : std::uint8_t { nothing, whereItFits, all };
    // One of several pictures that follow each other: it keeps the `last` surroundings as long as
    // what falls falls along the same axis, and tells its own. The ground gives way to bodies that
    // are a floor; `whereItFits` it stays only under everything and not far below.
    [[nodiscard]] bool draw(const Drawing& drawing, const Image& into,
                            std::optional<Surroundings>& last, Keeps keeps);
    [[nodiscard]] const Surroundings& surroundings() const; // of the last picture

    [[nodiscard]] int maximumSamples() const;
    [[nodiscard]] int maximumSize() const;
    [[nodiscard]] std::string description() const; // driver and version, for About

private:
    Renderer();
    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
};

} // namespace render
