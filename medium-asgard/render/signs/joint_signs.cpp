#include "signs/joint_signs.h"

#include "framing/joint_places.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace render {
namespace {

using scene::JointType;

// Of radius 1, from -1 to 1 along z.
scene::Part cylinder() {
    constexpr int sides = 20;
    scene::HullShape hull;
    for (int i = 0; i < sides; ++i)
        for (const double z : {-1.0, 1.0})
            hull.points.emplace_back(std::cos(2 * M_PI * i / sides), std::sin(2 * M_PI * i / sides),
                                     z);
    return {hull, Vector::Zero(), Vector::Zero(), {}};
}

const scene::Part& ballPart() {
    static const scene::Part part{scene::SphereShape{1}, Vector::Zero(), Vector::Zero(), {}};
    return part;
}
const scene::Part& blockPart() {
    static const scene::Part part{
        scene::BoxShape{Vector::Ones()}, Vector::Zero(), Vector::Zero(), {}};
    return part;
}
const scene::Part& pinPart() {
    static const scene::Part part = cylinder();
    return part;
}

// The axes of a frame whose third is along n.
Eigen::Matrix3d framed(const Vector& n, const Vector& across) {
    Eigen::Matrix3d axes;
    axes << across, n.cross(across), n;
    return axes;
}

// One joint on its way into the picture. Lengths are in pixels of a picture 480 high.
class Sign {
public:
    Sign(JointSigns& signs, const Frame& frame, const scene::Joint& joint, const JointPlace& place,
         double pixel)
        : signs_(signs), frame_(frame), joint_(joint), place_(place), pixel_(pixel) {}

    void draw();
    // A thin line to a body that the joint lies outside of, as far as its surface: the rod of a
    // pendulum, which nothing else shows.
    void arm(const JointEnd& end, double radius);

private:
    void hinge();
    void slider();
    void ball();
    void sleeve();
    void cross();
    void square();
    void rod();
    void range(const Vector& middle);

    // World lengths.
    void solid(const scene::Part& part, const Vector& place, const Eigen::Matrix3d& axes,
               const Vector& scale);
    void stroke(const Vector& from, const Vector& to, double width = 1.8, float alphaFrom = 1,
                float alphaTo = 1);
    void arc(const Vector& middle, const Vector& u, const Vector& v, double from, double to,
             float alphaFrom = 1, float alphaTo = 1);
    [[nodiscard]] double px(double pixels) const { return pixels * pixel_; }
    [[nodiscard]] const JointEnd& first() const { return place_.ends[0]; }
    [[nodiscard]] const JointEnd& second() const { return place_.ends[1]; }

    JointSigns& signs_;
    const Frame& frame_;
    const scene::Joint& joint_;
    const JointPlace& place_;
    double pixel_; // world
};

void Sign::solid(const scene::Part& part, const Vector& place, const Eigen::Matrix3d& axes,
                 const Vector& scale) {
    Solid solid;
    solid.part = &part;
    solid.linear = frame_.linear() * axes * scale.asDiagonal();
    solid.place = solid.middle = frame_.toView(place);
    solid.radius = frame_.camera().scale * scale.maxCoeff();
    solid.color = Eigen::Vector3d(jointColor.red, jointColor.green, jointColor.blue).cast<float>();
    solid.shininess = 0.3F;
    signs_.solids.push_back(solid);
}

void Sign::stroke(const Vector& from, const Vector& to, double width, float alphaFrom,
                  float alphaTo) {
    signs_.strokes.push_back(
        {frame_.toView(from), frame_.toView(to), alphaFrom, alphaTo, frame_.stroke(width)});
}

// From one angle to the other, u being 0 and v a quarter of a turn.
void Sign::arc(const Vector& middle, const Vector& u, const Vector& v, double from, double to,
               float alphaFrom, float alphaTo) {
    const int parts = std::max(2, static_cast<int>(std::ceil(std::abs(to - from) / 0.26)));
    const auto at = [&](int i) -> Vector {
        const double angle = from + (to - from) * i / parts;
        return middle + std::cos(angle) * u + std::sin(angle) * v;
    };
    const auto alpha = [&](int i) {
        return alphaFrom +
               (alphaTo - alphaFrom) * static_cast<float>(i) / static_cast<float>(parts);
    };
    for (int i = 0; i < parts; ++i)
        stroke(at(i), at(i + 1), 1.8, alpha(i), alpha(i + 1));
}

void Sign::hinge() {
    const Vector middle = first().point, n = first().carried(place_.axis), u = acrossOf(n);
    solid(pinPart(), middle, framed(n, u), Vector(px(2.4), px(2.4), px(8)));
    arc(middle, px(7.5) * u, px(7.5) * n.cross(u), 0, 2 * M_PI);
    range(middle);
}

// The angles that -limits allows, from where body 1's centre is when q is 0, and a hand that points
// there now. A side without a limit fades out.
void Sign::range(const Vector& middle) {
    const scene::JointCoordinate& q = joint_.coordinates.at(0);
    if (!q.lower && !q.upper)
        return;
    const double reach = px(14);
    const Vector n = second().carried(place_.axis);
    const Vector zero = place_.unturned();
    const Vector u = second().carried(zero), v = n.cross(u);
    const auto stop = [&](double angle) {
        const Vector out = std::cos(angle) * u + std::sin(angle) * v;
        stroke(middle + 0.7 * reach * out, middle + 1.3 * reach * out);
    };
    const double open = 2 * M_PI / 3, turn = 2 * M_PI;
    const double lower = q.lower.value_or(*q.upper - open) - q.from;
    const double upper = std::min(q.upper.value_or(lower + q.from + open) - q.from, lower + turn);
    arc(middle, reach * u, reach * v, lower, upper, q.lower ? 1 : 0, q.upper ? 1 : 0);
    if (q.lower)
        stop(*q.lower - q.from);
    if (q.upper)
        stop(*q.upper - q.from);
    const Vector hand = first().carried(zero);
    stroke(middle + px(7.5) * hand, middle + 1.15 * reach * hand, 1.2);
}

void Sign::slider() {
    const Vector n = second().carried(place_.axis);
    const Vector zero = second().point + n * place_.axis.dot(place_.apart);
    const double now = (first().point - zero).dot(n);
    const Vector sight = frame_.linear().transpose() * Vector::UnitZ(); // towards the viewer
    Vector across = n.cross(sight);
    across = across.norm() > 1e-3 * sight.norm() ? across.normalized() : acrossOf(n);
    const scene::JointCoordinate& q = joint_.coordinates.at(0);
    // Its block is in between the stops also where it touches one.
    const double half = px(4);
    const double lowest = q.lower.value_or(q.from) - q.from;
    const double highest = q.upper.value_or(q.from) - q.from;
    const double lower =
        q.lower ? *q.lower - q.from - half : std::min({0.0, now, highest}) - px(16);
    const double upper = q.upper ? *q.upper - q.from + half : std::max({0.0, now, lowest}) + px(16);
    for (const double side : {-1.0, 1.0}) {
        const Vector beside = zero + side * px(3.4) * across;
        const double middle = 0.5 * (lower + upper);
        stroke(beside + middle * n, beside + lower * n, 1.8, 1, q.lower ? 1 : 0.25F);
        stroke(beside + middle * n, beside + upper * n, 1.8, 1, q.upper ? 1 : 0.25F);
    }
    const auto stop = [&](double at) {
        stroke(zero + at * n - px(7) * across, zero + at * n + px(7) * across, 2.4);
    };
    if (q.lower)
        stop(lower);
    if (q.upper)
        stop(upper);
    const Vector along = first().carried(place_.axis);
    solid(blockPart(), first().point, framed(along, acrossOf(along)),
          Vector(px(4.4), px(4.4), 2 * half));
}

// The cup belongs to body 2 and opens towards body 1.
void Sign::ball() {
    const Vector middle = first().point;
    solid(ballPart(), middle, Eigen::Matrix3d::Identity(), Vector::Constant(px(3.8)));
    const Vector open = place_.towards.norm() > 0
                            ? Vector(second().carried(place_.towards.normalized()))
                            : Vector(-Vector::UnitY());
    const Vector sight = (frame_.linear().transpose() * Vector::UnitZ()).normalized();
    Vector u = open.cross(sight);
    u = u.norm() > 1e-3 ? u.normalized() : acrossOf(open);
    const double reach = px(6.4);
    arc(middle, reach * u, -reach * open, 0, M_PI);
    arc(middle, reach * u, reach * open.cross(u), 0, 2 * M_PI, 0.5F, 0.5F);
}

void Sign::sleeve() {
    const Vector n = first().carried(place_.axis), middle = first().point, u = acrossOf(n);
    const double half = px(13);
    solid(pinPart(), middle, framed(n, u), Vector(px(1.3), px(1.3), half));
    solid(pinPart(), middle, framed(n, u), Vector(px(4.2), px(4.2), px(5)));
    if (joint_.type != JointType::screw)
        return;
    constexpr int turns = 6, corners = 10;
    const double hand = joint_.pitch < 0 ? -1 : 1;
    const auto at = [&](int i) -> Vector {
        const double angle = hand * 2 * M_PI * i / corners;
        return middle + (2.0 * i / (turns * corners) - 1) * half * n +
               px(2.8) * (std::cos(angle) * u + std::sin(angle) * n.cross(u));
    };
    for (int i = 0; i < turns * corners; ++i)
        stroke(at(i), at(i + 1), 1.2);
}

void Sign::cross() {
    const Vector other = joint_.axis2 ? Vector(second().pose.attitude * joint_.axis2->normalized())
                                      : second().carried(acrossOf(place_.axis));
    for (const Vector& n : {first().carried(place_.axis), other})
        solid(pinPart(), first().point, framed(n, acrossOf(n)), Vector(px(1.6), px(1.6), px(8)));
    solid(ballPart(), first().point, Eigen::Matrix3d::Identity(), Vector::Constant(px(2.8)));
}

void Sign::square() {
    const Vector n = second().carried(place_.axis), u = acrossOf(n), v = n.cross(u);
    const Vector middle = first().point;
    const double half = px(9);
    std::array<Vector, 4> corners;
    for (std::size_t i = 0; i < 4; ++i)
        corners[i] = middle + half * (i == 0 || i == 3 ? 1 : -1) * u + half * (i < 2 ? 1 : -1) * v;
    for (std::size_t i = 0; i < 4; ++i)
        stroke(corners[i], corners[(i + 1) % 4]);
    stroke(middle, middle + px(8) * n, 1.4);
    solid(ballPart(), middle, Eigen::Matrix3d::Identity(), Vector::Constant(px(2.4)));
}

void Sign::rod() {
    stroke(first().point, second().point, 2.4);
    for (const Vector& point : {first().point, second().point})
        solid(ballPart(), point, Eigen::Matrix3d::Identity(), Vector::Constant(px(2.8)));
}

void Sign::arm(const JointEnd& end, double radius) {
    const Vector way = end.pose.position - end.point;
    const double length = way.norm() - radius;
    if (length > px(4))
        stroke(end.point, end.point + length * way.normalized(), 1.6);
}

void Sign::draw() {
    switch (joint_.type) {
    case JointType::fixed:
        solid(blockPart(), first().point, first().pose.attitude.toRotationMatrix(),
              Vector::Constant(px(7)));
        break;
    case JointType::hinge:
        hinge();
        break;
    case JointType::slider:
        slider();
        break;
    case JointType::cylindrical:
    case JointType::screw:
        sleeve();
        break;
    case JointType::universal:
        cross();
        break;
    case JointType::ball:
        ball();
        break;
    case JointType::planar:
        square();
        break;
    case JointType::distance:
        rod();
        break;
    }
}

} // namespace

namespace {

bool isAboutAPoint(JointType type) {
    return type == JointType::hinge || type == JointType::ball || type == JointType::universal;
}

double radiusOf(const scene::Scene& scene, std::size_t body) {
    double radius = 0;
    for (const Ball& ball : outlineOf(scene, scene.bodies[body]))
        radius = std::max(radius, ball.center.norm() + ball.radius);
    return radius;
}

} // namespace

JointSigns jointSignsOf(const Drawing& drawing, const Extent& extent, const Frame& frame) {
    JointSigns signs;
    const auto& joints = drawing.scene->joints;
    const JointPlaces places(*drawing.scene, drawing.motion.get());
    constexpr double usual = 24;
    const double crowd =
        std::max(0.35, std::min(1.0, std::sqrt(usual / std::max<double>(joints.size(), 1))));
    for (const scene::Joint& joint : joints) {
        const auto place = places.at(joint, drawing.time);
        if (!place || !place->ends[0].point.allFinite() || !place->ends[1].point.allFinite() ||
            (drawing.motion && gapOf(joint, *place) > 0.01 * extent.size))
            continue;
        const double z = frame.toView(place->ends[0].point).z();
        const double onScreen = frame.stroke(1) / std::max(frame.pixels(1, z), 1e-12);
        // A sign is some 14 pixels across: a twelfth of the scene at most.
        const double pixel =
            std::min(crowd * onScreen / frame.camera().scale, extent.size / 12 / 14);
        Sign sign(signs, frame, joint, *place, pixel);
        for (const JointEnd& end : place->ends)
            if (end.body && isAboutAPoint(joint.type))
                sign.arm(end, radiusOf(*drawing.scene, *end.body));
        sign.draw();
    }
    return signs;
}

} // namespace render
