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
    // How much of the last picture's surroundings the next one has. The sun stays while it stands
    // as high; the ground stays until a body is a floor or gravity has another direction.
    // `whereItFits`: the ground goes, too, where something lies below it, or all lies far above.
    enum class Keeps : std::uint8_t { nothing, whereItFits, all };
    // Draws and reads back. False when the context was lost; then make a new renderer. `last`: of
    // the picture before, and then of this one.
    [[nodiscard]] bool draw(const Drawing& drawing, const Image& into,
                            std::optional<Surroundings>* last = nullptr,
                            Keeps keeps = Keeps::nothing);
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
