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
    enum class Keeps : std::uint8_t { always, whereItFits };
    // The next pictures have these, as long as what falls falls along the same axis; none: as their
    // scene's motion has them. The ground gives way to bodies that are a floor, and `whereItFits`
    // stays only under everything and not far below.
    void keep(const std::optional<Surroundings>& last, Keeps ground = Keeps::always);
    // Draws and reads back. False when the context was lost; then make a new renderer.
    [[nodiscard]] bool draw(const Drawing& drawing, const Image& into);
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
