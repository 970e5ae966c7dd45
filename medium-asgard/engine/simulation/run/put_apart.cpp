#include "run/put_apart.h"

#include "collision/hollow_separation.h"
#include "collision/separation.h"
#include "meetings/may_meet.h"
#include "motion/groups.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace simulation {
namespace {

using geometry::Vector;

constexpr double meant = 1e-4;   // of the smaller one's size: deeper than this they overlap
constexpr double nothing = 1e-9; // of the same: less is rounding
constexpr std::size_t mostRounds = 1000;

double sizeOf(const geometry::Shape& shape) {
    const auto isPlane = [](const geometry::Part& part) { return part.isPlane(); };
    return std::ranges::any_of(shape.parts, isPlane) ? HUGE_VAL
                                                     : geometry::radiusAbout(shape, Vector::Zero());
}

class Start {
public:
    Start(scene::Scene& scene, std::span<const geometry::Shape> shapes)
        : scene_(scene), shapes_(shapes), groups_(scene.bodies.size()) {
        std::vector<char> stands(scene.bodies.size(), 0);
        for (std::size_t body = 0; body < stands.size(); ++body) {
            sizes_.push_back(sizeOf(shapes[body]));
            stands[body] = scene.bodies[body].fixed;
        }
        const auto indexOf = [&](const std::string& name) {
            return static_cast<std::size_t>(scene::findBody(scene, name) - scene.bodies.data());
        };
        for (const scene::Constraint& held : scene.constraints)
            stands[indexOf(held.body)] = 1;
        for (const scene::Joint& joint : scene.joints) {
            if (!joint.body2)
                stands[indexOf(joint.body1)] = 1;
            else
                groups_.join(indexOf(joint.body1), indexOf(*joint.body2));
        }
        stands_.resize(stands.size(), 0);
        for (std::size_t body = 0; body < stands.size(); ++body)
            if (stands[body])
                stands_[groups_.root(body)] = 1;
    }

    void putApart() {
        findNear();
        for (std::size_t round = 0; round < mostRounds && moveOnce(); ++round) {
        }
    }

private:
    using Pair = std::pair<std::size_t, std::size_t>;

    [[nodiscard]] bool stands(std::size_t body) { return stands_[groups_.root(body)] != 0; }
    [[nodiscard]] double smaller(const Pair& pair) const {
        return std::min(sizes_[pair.first], sizes_[pair.second]);
    }
    // Those that overlap, and those that what is moved apart may come upon.
    void findNear() {
        const MayMeet mayMeet(scene_);
        const std::size_t count = scene_.bodies.size();
        for (std::size_t a = 0; a < count; ++a)
            for (std::size_t b = a + 1; b < count; ++b) {
                const double reach = (1 + meant) * (sizes_[a] + sizes_[b]);
                const Vector between =
                    scene_.bodies[a].initialPosition - scene_.bodies[b].initialPosition;
                const bool isNear = between.squaredNorm() <= reach * reach;
                if (isNear && smaller({a, b}) < HUGE_VAL && mayMeet(a, b) &&
                    groups_.root(a) != groups_.root(b) && !(stands(a) && stands(b)) &&
                    !isMeant({a, b}))
                    near_.emplace_back(a, b);
            }
    }
    [[nodiscard]] collision::Posed posed(std::size_t body, std::size_t part,
                                         const Vector& origin) const {
        const scene::Body& of = scene_.bodies[body];
        return {.part = &shapes_[body].parts[part],
                .rotation = of.initialAttitude.toRotationMatrix(),
                .offset = of.initialPosition - origin};
    }
    // Of all parts the deepest; none, where nothing overlaps.
    [[nodiscard]] collision::Separation deepest(const Pair& pair) const {
        collision::Separation least{.gap = 0};
        const Vector origin = scene_.bodies[pair.second].initialPosition;
        for (std::size_t i = 0; i < shapes_[pair.first].parts.size(); ++i)
            for (std::size_t j = 0; j < shapes_[pair.second].parts.size(); ++j) {
                const auto first = posed(pair.first, i, origin);
                const auto second = posed(pair.second, j, origin);
                if (first.part->isPlane() && second.part->isPlane())
                    continue;
                collision::WarmStart cold;
                if (const auto now = collision::separate(first, second, cold); now.gap < least.gap)
                    least = now;
            }
        return least;
    }
    [[nodiscard]] bool isMeant(const Pair& pair) const {
        return -deepest(pair).gap > meant * smaller(pair);
    }
    // False: all are apart.
    bool moveOnce() {
        bool isAny = false;
        for (const Pair& pair : near_) {
            const collision::Separation now = deepest(pair);
            if (-now.gap <= nothing * smaller(pair))
                continue;
            isAny = true;
            const bool isFirst = !stands(pair.first), isSecond = !stands(pair.second);
            const double share = isFirst && isSecond ? 0.5 : 1;
            if (isFirst)
                move(pair.first, -share * now.gap * now.normal);
            if (isSecond)
                move(pair.second, share * now.gap * now.normal);
        }
        return isAny;
    }
    void move(std::size_t body, const Vector& way) {
        for (std::size_t other = 0; other < scene_.bodies.size(); ++other)
            if (groups_.root(other) == groups_.root(body))
                scene_.bodies[other].initialPosition += way;
    }

    scene::Scene& scene_;
    std::span<const geometry::Shape> shapes_;
    Groups groups_;
    std::vector<char> stands_; // by root
    std::vector<double> sizes_;
    std::vector<Pair> near_;
};

} // namespace

void putApart(scene::Scene& scene, std::span<const geometry::Shape> shapes) {
    if (scene.simulator.collisions && scene.bodies.size() > 1)
        Start(scene, shapes).putApart();
}

} // namespace simulation
