// Scenes and motions for the tests: built in code, so that what they show is known exactly.
#pragma once

#include "render/renderer.h"

#include <functional>
#include <string>
#include <vector>

namespace render {

// A motion in closed form: the state of each body as a function of time.
class GivenMotion : public simulation::Motion {
public:
    using Law = std::function<simulation::BodyState(double time)>;
    GivenMotion(double finish, std::vector<Law> laws) : finish_(finish), laws_(std::move(laws)) {}

    double start() const override { return 0; }
    double finish() const override { return finish_; }
    double computed() const override { return finish_; }
    bool draft() const override { return false; }
    std::size_t bodies() const override { return laws_.size(); }
    simulation::BodyState at(std::size_t body, double time) const override {
        return laws_[body](time);
    }
    std::optional<simulation::Stop> stop(std::size_t) const override { return std::nullopt; }
    Vector centroid(std::size_t) const override { return Vector::Zero(); }
    double mass(std::size_t) const override { return 1; }
    const std::vector<simulation::Impact>& impacts() const override { return impacts_; }
    std::vector<double> jumps(std::size_t) const override { return jumpTimes; }
    std::optional<double> errorEstimate() const override { return std::nullopt; }
    std::optional<double> predictableUntil() const override { return std::nullopt; }
    const std::vector<std::string>& notes() const override { return notes_; }

    std::vector<double> jumpTimes;

private:
    double finish_;
    std::vector<Law> laws_;
    std::vector<simulation::Impact> impacts_;
    std::vector<std::string> notes_;
};

// A picture in memory.
struct Picture {
    Size size;
    std::vector<std::byte> bytes;

    explicit Picture(Size s)
        : size(s),
          bytes(4 * static_cast<std::size_t>(s.width) * static_cast<std::size_t>(s.height)) {}
    Image image() { return {bytes, 4 * static_cast<std::size_t>(size.width), size}; }
    // 0xRRGGBB
    unsigned at(int x, int y) const {
        const std::size_t i =
            4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(size.width) +
                 static_cast<std::size_t>(x));
        return std::to_integer<unsigned>(bytes[i + 2]) << 16 |
               std::to_integer<unsigned>(bytes[i + 1]) << 8 | std::to_integer<unsigned>(bytes[i]);
    }
};

} // namespace render
