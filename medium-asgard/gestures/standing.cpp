#include "gestures/standing.h"

#include "collision/separation.h"
#include "framing/extent.h"
#include "surroundings/ground.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace gestures {

namespace {

struct Standing {
    ShapePointer shape;
    geometry::Pose pose;
    geometry::Box box;
    bool isEndless = false;
};

// Of the surfaces, from the second towards the first.
collision::Separation apart(const geometry::Shape& shape, const geometry::Pose& pose,
                            const Standing& other) {
    const auto rotation = pose.attitude.toRotationMatrix();
    const auto its = other.pose.attitude.toRotationMatrix();
    const Vector between = other.pose.position - pose.position;
    collision::Separation least;
    least.gap = std::numeric_limits<double>::infinity();
    for (const geometry::Part& part : shape.parts)
        for (const geometry::Part& one : other.shape->parts) {
            collision::WarmStart cold;
            const auto found =
                collision::separate({&part, rotation, Vector::Zero()}, {&one, its, between}, cold);
            if (found.gap < least.gap)
                least = found;
        }
    return least;
}

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
            return (other.isEndless || other.box.intersects(box)) &&
                   apart(shape_, pose, other).gap < -touch_;
        });
    }

private:
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

// How far a shape that is turned so reaches along a direction, from its origin.
double reachOf(const geometry::Shape& shape, const Vector& along,
               const geometry::Quaternion& attitude) {
    const geometry::Quaternion level = geometry::Quaternion::FromTwoVectors(along, Vector::UnitY());
    return geometry::bounds(shape, {Vector::Zero(), level * attitude}).max().y();
}

// Bodies at the start, of which some get another shape.
class Resized {
public:
    Resized(const scene::Scene& scene, std::size_t shapeSet, const std::vector<scene::Part>& parts)
        : scene_(scene), extent_(render::extentOf(scene, nullptr)),
          ground_(render::groundHeight(extent_)), ways_(scene.bodies.size()) {
        scene::Scene after;
        after.shapeSets = {scene.shapeSets[shapeSet]};
        after.shapeSets.front().parts = parts;
        after.bodies.resize(1);
        for (const scene::Body& body : scene.bodies) {
            const bool isOfIt = body.shape == scene.shapeSets[shapeSet].name;
            after.bodies.front() = body;
            const geometry::Pose pose{body.initialPosition, body.initialAttitude};
            const ShapePointer shape = shapeOf(scene, body.name);
            before_.push_back({shape, pose,
                               shape ? geometry::bounds(*shape, pose) : geometry::Box(),
                               shape && isEndless(*shape)});
            after_.push_back(isOfIt ? shapeOf(after, body.name) : shape);
        }
    }

    [[nodiscard]] Vector wayOf(std::size_t body) {
        std::optional<Vector>& way = ways_[body];
        if (!way) {
            way = Vector::Zero(); // of what stands on itself, through others
            if (!isHeld(scene_.bodies[body].name) && canStand(body))
                if (const auto support = supportOf(body))
                    way = standingOn(*support, body);
        }
        return *way;
    }

private:
    struct Support {
        std::optional<std::size_t> body; // none: the grid
        Vector up;                       // out of its surface
    };

    [[nodiscard]] bool canStand(std::size_t body) const {
        return before_[body].shape && after_[body] && !before_[body].isEndless;
    }
    [[nodiscard]] bool isHeld(const std::string& name) const {
        const auto joins = [&](const scene::Joint& joint) {
            return joint.body1 == name || joint.body2 == name;
        };
        const auto ties = [&](const scene::Rope& rope) {
            return std::ranges::find(rope.points, name, &scene::Rope::Point::body) !=
                   rope.points.end();
        };
        return std::ranges::any_of(scene_.joints, joins) ||
               std::ranges::any_of(scene_.ropes, ties) ||
               std::ranges::find(scene_.constraints, name, &scene::Constraint::body) !=
                   scene_.constraints.end();
    }
    // Of several the one that looks up most.
    [[nodiscard]] std::optional<Support> supportOf(std::size_t body) const {
        constexpr double steepest = 0.5, touch = 1e-3; // of its size
        const Standing& own = before_[body];
        const double least = touch * geometry::radiusAbout(*own.shape, Vector::Zero());
        const geometry::Box near(own.box.min().array() - least, own.box.max().array() + least);
        std::optional<Support> found;
        if (std::abs(own.pose.position.dot(extent_.ground) - ground_ -
                     reachOf(*own.shape, -extent_.ground, own.pose.attitude)) <= least)
            found = {std::nullopt, extent_.ground};
        for (std::size_t i = 0; i < before_.size(); ++i) {
            const Standing& other = before_[i];
            if (i == body || !other.shape || !(other.isEndless || other.box.intersects(near)))
                continue;
            const auto between = apart(*own.shape, own.pose, other);
            const double up = between.normal.dot(extent_.ground);
            if (std::abs(between.gap) <= least && up > steepest &&
                (!found || up > found->up.dot(extent_.ground)))
                found = {i, between.normal};
        }
        return found;
    }
    [[nodiscard]] Vector standingOn(const Support& support, std::size_t body) {
        const auto grown = [this](std::size_t which, const Vector& along) {
            const geometry::Quaternion& attitude = before_[which].pose.attitude;
            return before_[which].shape == after_[which] || !after_[which]
                       ? 0.0
                       : reachOf(*after_[which], along, attitude) -
                             reachOf(*before_[which].shape, along, attitude);
        };
        double apart = grown(body, -support.up); // along the normal
        if (support.body)
            apart += grown(*support.body, support.up);
        const Vector& upright = extent_.ground; // along an axis: the other numbers stay short
        const Vector way = apart / support.up.dot(upright) * upright;
        return support.body ? Vector(way + wayOf(*support.body)) : way;
    }

    const scene::Scene& scene_;
    render::Extent extent_;
    double ground_;
    std::vector<Standing> before_;
    std::vector<ShapePointer> after_;
    std::vector<std::optional<Vector>> ways_;
};

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

std::optional<Vector> touchingBeside(const render::Drawing& drawing, const geometry::Shape& shape,
                                     const geometry::Pose& wanted, std::size_t body,
                                     const Vector& out) {
    const scene::Scene& scene = *drawing.scene;
    const ShapePointer its = shapeOf(scene, scene.bodies[body].name);
    if (!its || isEndless(*its))
        return std::nullopt;
    const Standing other{its, render::poseOf(scene, drawing.motion.get(), body, drawing.time),
                         geometry::Box(), false};
    const auto isApart = [&](double by) {
        return apart(shape, {wanted.position + by * out, wanted.attitude}, other).gap >= 0;
    };
    constexpr int pieces = 256, halvings = 50;
    const double size =
        geometry::radiusAbout(shape, Vector::Zero()) + geometry::radiusAbout(*its, Vector::Zero());
    const double piece = (isApart(0) ? -2 : 2) * size / pieces;
    double before = 0, after = 0;
    for (int i = 1; after == 0; ++i) {
        if (i > pieces)
            return std::nullopt;
        if (isApart(i * piece) != (piece < 0))
            after = i * piece;
        else
            before = i * piece;
    }
    double inside = piece < 0 ? after : before, outside = piece < 0 ? before : after;
    for (int i = 0; i < halvings; ++i) {
        const double middle = (inside + outside) / 2;
        (isApart(middle) ? outside : inside) = middle;
    }
    return wanted.position + outside * out;
}

bool isInsideOfOthers(const scene::Scene& scene, const geometry::Shape& shape,
                      const geometry::Pose& pose, std::size_t but) {
    render::Drawing start;
    start.scene = &scene;
    return !Others(start, shape, but).isFree(pose);
}

std::vector<editing::Wish> standingStill(const scene::Scene& scene, std::size_t shapeSet,
                                         const std::vector<scene::Part>& parts) {
    Resized resized(scene, shapeSet, parts);
    std::vector<editing::Wish> wishes;
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        const Vector way = resized.wayOf(i), from = scene.bodies[i].initialPosition;
        if (way.isZero(1e-12))
            continue;
        const Vector to = from + way;
        wishes.push_back({.element = {editing::Kind::body, i},
                          .option = "-init_pos",
                          .path = {},
                          .values = {to.x(), to.y(), to.z()},
                          .resolution = 1e-9,
                          .absent = {0, 0, 0},
                          .now = {from.x(), from.y(), from.z()},
                          .offers = false});
    }
    return wishes;
}

} // namespace gestures
