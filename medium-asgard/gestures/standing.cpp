#include "gestures/standing.h"

#include "collision/separation.h"
#include "framing/extent.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace gestures {

namespace {

struct Standing {
    ShapePointer shape;
    geometry::Pose pose;
    geometry::Box box;
    bool isEndless = false;
};

class Others {
public:
    Others(const render::Drawing& drawing, const geometry::Shape& shape,
           std::optional<std::size_t> but = std::nullopt)
        : shape_(shape), touch_(1e-6 * geometry::radiusAbout(shape, Vector::Zero())) {
        const scene::Scene& scene = *drawing.scene;
        std::map<std::string, ShapePointer> known;
        for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
            if (i == but)
                continue;
            const scene::Body& body = scene.bodies[i];
            const auto [one, isNew] = known.try_emplace(body.shape);
            if (isNew)
                one->second = shapeOf(scene, body.name);
            if (!one->second)
                continue;
            const geometry::Pose pose =
                render::poseOf(scene, drawing.motion.get(), i, drawing.time);
            all_.push_back(
                {one->second, pose, geometry::bounds(*one->second, pose), isEndless(*one->second)});
        }
    }

    [[nodiscard]] bool isFree(const geometry::Pose& pose) const {
        const geometry::Box box = geometry::bounds(shape_, pose);
        return std::ranges::none_of(all_, [&](const Standing& other) {
            return (other.isEndless || other.box.intersects(box)) && overlaps(pose, other);
        });
    }

private:
    [[nodiscard]] bool overlaps(const geometry::Pose& pose, const Standing& other) const {
        const auto rotation = pose.attitude.toRotationMatrix();
        const auto its = other.pose.attitude.toRotationMatrix();
        const Vector between = other.pose.position - pose.position;
        for (const geometry::Part& part : shape_.parts)
            for (const geometry::Part& one : other.shape->parts) {
                collision::WarmStart cold;
                const auto apart = collision::separate({&part, rotation, Vector::Zero()},
                                                       {&one, its, between}, cold);
                if (apart.gap < -touch_)
                    return true;
            }
        return false;
    }

    const geometry::Shape& shape_;
    double touch_; // less than that is none
    std::vector<Standing> all_;
};

// Numbers of steps along two axes, the nearest first.
const std::vector<Eigen::Vector2i>& around() {
    static const std::vector<Eigen::Vector2i> all = [] {
        constexpr int most = 25;
        std::vector<Eigen::Vector2i> made;
        for (int i = -most; i <= most; ++i)
            for (int k = -most; k <= most; ++k)
                made.emplace_back(i, k);
        std::ranges::stable_sort(made, {}, [](const auto& one) { return one.squaredNorm(); });
        return made;
    }();
    return all;
}

} // namespace

std::optional<Vector> standingFree(const render::Drawing& drawing, const geometry::Shape& shape,
                                   const geometry::Pose& wanted, const render::GroundPlane& ground,
                                   double step) {
    const Others others(drawing, shape);
    const geometry::Box box = geometry::bounds(shape, wanted);
    const double width = std::max(box.sizes()[ground.across[0]], box.sizes()[ground.across[1]]);
    const double stride = step * std::max(1.0, std::ceil(width / 10 / step)); // round, too
    const double reach = 2.5 * std::max(width, stride); // further away it is not what is meant
    for (const Eigen::Vector2i& steps : around()) {
        if (stride * steps.cast<double>().norm() > reach)
            break;
        geometry::Pose pose = wanted;
        for (int k = 0; k < 2; ++k)
            pose.position[ground.across[static_cast<std::size_t>(k)]] += steps[k] * stride;
        if (others.isFree(pose))
            return pose.position;
    }
    return std::nullopt;
}

bool isInsideOfOthers(const scene::Scene& scene, const geometry::Shape& shape,
                      const geometry::Pose& pose, std::size_t but) {
    render::Drawing start;
    start.scene = &scene;
    return !Others(start, shape, but).isFree(pose);
}

} // namespace gestures
