#include "gestures/standing.h"

#include "collision/separation.h"
#include "framing/extent.h"

#include <algorithm>
#include <map>

namespace gestures {

namespace {

struct Standing {
    ShapePointer shape;
    geometry::Pose pose;
    geometry::Box box;
    bool isEndless = false;
};

bool isEndless(const geometry::Shape& shape) {
    return std::ranges::any_of(shape.parts, &geometry::Part::isPlane);
}

class Others {
public:
    Others(const render::Drawing& drawing, const geometry::Shape& shape)
        : shape_(shape), touch_(1e-6 * geometry::radiusAbout(shape, Vector::Zero())) {
        const scene::Scene& scene = *drawing.scene;
        std::map<std::string, ShapePointer> known;
        for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
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

} // namespace

std::optional<Vector> standingFree(const render::Drawing& drawing, const geometry::Shape& shape,
                                   const geometry::Pose& wanted, const render::GroundPlane& ground,
                                   double step) {
    constexpr int most = 300; // steps
    const Others others(drawing, shape);
    for (int steps = 0; steps <= most; ++steps)
        for (const int axis : ground.across)
            for (const double way : {-step, step}) {
                geometry::Pose pose = wanted;
                pose.position[axis] += steps * way;
                if (others.isFree(pose))
                    return pose.position;
            }
    return std::nullopt;
}

} // namespace gestures
