#include "framing/extent.h"

#include "framing/joint_places.h"
#include "framing/rope_lines.h"
#include "framing/standing_points.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <limits>

namespace render {

using geometry::Pose;

namespace {

using Box = Eigen::AlignedBox3d;

std::vector<double> sampleTimes(const simulation::Motion* motion, std::size_t outlinePoints) {
    if (motion == nullptr)
        return {0};
    // OPTIMIZATION: many bodies make one picture together; fewer times of each are enough.
    const std::size_t count =
        std::clamp<std::size_t>(50000 / std::max<std::size_t>(outlinePoints, 1), 12, 240);
    const double start = motion->start(), length = motion->computed() - start;
    std::vector<double> times;
    for (std::size_t i = 0; i <= count; ++i)
        times.push_back(start + length * static_cast<double>(i) / static_cast<double>(count));
    return times;
}

bool finite(const Pose& pose) {
    return pose.position.allFinite() && pose.attitude.coeffs().allFinite();
}

// What one body does over the motion.
struct Path {
    Box centers;                  // of the shape's origin
    Vector spin = Vector::Zero(); // the angle turned about each axis, to and fro alike
    double own = 0;               // the same about the axis that its shape is round about
    std::vector<Pose> poses;

    [[nodiscard]] bool travels() const {
        return !centers.isEmpty() &&
               centers.sizes().maxCoeff() > 1e-9 * (1 + centers.center().norm());
    }
    [[nodiscard]] bool turns() const { return spin.sum() > 1e-6; } // more than rounding does
    [[nodiscard]] bool spins() const { return own > 1e-6; }
};

// One place more. `axis`: that its shape is round about, in its frame, or 0.
void follow(Path& path, const scene::Scene& scene, const simulation::Motion* motion,
            std::size_t body, double time, double interval, const Vector& axis) {
    const Pose pose = poseOf(scene, motion, body, time);
    if (!finite(pose))
        return;
    path.centers.extend(pose.position);
    path.poses.push_back(pose);
    if (motion == nullptr || body >= motion->bodies())
        return;
    const Vector velocity = motion->at(body, time).angularVelocity;
    path.spin += interval * velocity.cwiseAbs();
    path.own += interval * std::abs(velocity.dot(pose.attitude * axis));
}

struct Survey {
    std::vector<std::vector<Ball>> outlines; // of each body
    std::vector<Path> paths;
};

Survey surveyOf(const scene::Scene& scene, const simulation::Motion* motion) {
    Survey survey;
    std::size_t points = 0;
    std::vector<Vector> axes;
    for (const scene::Body& body : scene.bodies) {
        axes.push_back(axisOf(scene, body).value_or(Vector::Zero()));
        survey.outlines.push_back(outlineOf(scene, body));
        points += survey.outlines.back().size();
    }
    const std::vector<double> times = sampleTimes(motion, points);
    const double interval = times.size() > 1 ? times[1] - times[0] : 0;
    survey.paths.resize(scene.bodies.size());
    for (const double time : times) // bodies share what a motion works out for a time
        for (std::size_t i = 0; i < scene.bodies.size(); ++i)
            follow(survey.paths[i], scene, motion, i, time, interval, axes[i]);
    return survey;
}

Box around(const Ball& ball) {
    return {ball.center.array() - ball.radius, ball.center.array() + ball.radius};
}

void keep(Extent& extent, const Ball& ball) {
    extent.balls.push_back(ball);
    extent.box.extend(around(ball));
}

// Of what wanders off only what happens near the others; where it starts always.
void keepPath(Extent& extent, const Path& path, const std::vector<Ball>& outline,
              const std::optional<Box>& near) {
    for (std::size_t i = 0; i < path.poses.size(); ++i) {
        const Pose& pose = path.poses[i];
        if (i > 0 && near && !near->contains(pose.position))
            continue;
        for (const Ball& ball : outline)
            keep(extent, {pose.toWorld(ball.center), ball.radius});
        // What does not move was sampled just as often, and is the same each time.
        if (!path.travels() && !path.turns())
            return;
    }
}

// Bodies that fly far from where all the others stay would make these too small to see. Bodies are
// taken by how far they get, least first; as soon as the next one gets further than `far` times the
// size of what there is so far, and at least half are in, it and the rest are wanderers. Returns
// the room near the others, or nothing when nobody wanders.
std::optional<Box> roomOfTheOthers(const Survey& survey, const std::vector<bool>& belongs,
                                   std::vector<bool>& wanders) {
    constexpr double far = 1.6;
    Box room;
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < survey.paths.size(); ++i) {
        if (!belongs[i] || survey.paths[i].poses.empty())
            continue;
        order.push_back(i);
        for (const Ball& ball : survey.outlines[i])
            room.extend(around({survey.paths[i].poses.front().toWorld(ball.center), ball.radius}));
    }
    const auto reach = [&](std::size_t i) { return survey.paths[i].centers.sizes().maxCoeff(); };
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return reach(a) < reach(b); });
    for (std::size_t k = 0; k < order.size(); ++k) {
        const double size = room.sizes().maxCoeff();
        if (k > 0 && 2 * k >= order.size() && reach(order[k]) > far * size) {
            for (std::size_t rest = k; rest < order.size(); ++rest)
                wanders[order[rest]] = true;
            const Vector margin = Vector::Constant(0.15 * size);
            return Box(room.min() - margin, room.max() + margin);
        }
        room.extend(survey.paths[order[k]].centers);
    }
    return std::nullopt;
}

// Times the size of the motion: of what is fixed and larger, as a wide floor, not all is shown.
constexpr double much = 4;

// A fixed body near the motion belongs to the picture, a table with the ball that falls on it. Of
// one that is much larger, what lies near the motion does.
void keepNear(Extent& extent, const Box& moving, const Pose& pose,
              const std::vector<Ball>& outline) {
    constexpr double beside = 0.35; // times the motion's size
    std::vector<Ball> balls;
    Box whole;
    for (const Ball& ball : outline) {
        balls.push_back({pose.toWorld(ball.center), ball.radius});
        whole.extend(around(balls.back()));
    }
    const double size = moving.sizes().maxCoeff();
    const Box near(moving.min().array() - beside * size, moving.max().array() + beside * size);
    const Box shown = near.intersection(whole);
    if (shown.isEmpty())
        return;
    if (whole.sizes().maxCoeff() > much * size) {
        balls.clear();
        for (int i = 0; i < 8; ++i)
            balls.push_back({shown.corner(static_cast<Box::CornerType>(i)), 0});
    }
    for (const Ball& ball : balls)
        keep(extent, ball);
}

// Of half spaces of bodies that stand, what lies under or beside the motion.
void keepPlanes(Extent& extent, const scene::Scene& scene, const scene::Body& body,
                const Pose& pose) {
    const scene::ShapeSet* shape = scene::findShapeSet(scene, body.shape);
    if (shape == nullptr || extent.box.isEmpty())
        return;
    const Vector middle = extent.box.center();
    const double reach = extent.box.sizes().maxCoeff();
    for (const scene::Part& part : shape->parts) {
        if (!std::holds_alternative<scene::PlaneShape>(part.shape))
            continue;
        const Vector up =
            pose.attitude * geometry::fromRotationVector(part.rotation) * Vector::UnitY();
        const double height = up.dot(middle - pose.toWorld(part.position));
        if (std::abs(height) <= reach)
            keep(extent, {middle - height * up, 0});
    }
}

// The axis along which nothing goes and about which alone anything turns, if there is one.
std::optional<Vector> flatAlong(const std::vector<Path>& paths, const std::vector<bool>& moves,
                                const Vector& up) {
    Box all;
    Vector travel = Vector::Zero(), spin = Vector::Zero();
    for (std::size_t i = 0; i < paths.size(); ++i) {
        if (paths[i].centers.isEmpty() || !moves[i])
            continue;
        all.extend(paths[i].centers);
        travel = travel.cwiseMax(paths[i].centers.sizes());
        spin += paths[i].spin;
    }
    if (all.isEmpty() || travel.maxCoeff() <= 0)
        return std::nullopt;
    const double size = std::max(all.sizes().maxCoeff(), travel.maxCoeff());
    // Depth first: a motion along one line can be seen from the front.
    for (int axis : {2, 0, 1}) {
        const Vector n = Vector::Unit(axis);
        if (std::abs(n.dot(up)) > 0.5)
            continue;
        const double other = spin.sum() - spin[axis];
        if (all.sizes()[axis] < 1e-3 * size && other <= 1e-6 * (spin.sum() + 1e-9))
            return n;
    }
    return std::nullopt;
}

// "-10 * b1.mass": numbers and masses, nothing that changes.
bool isWeight(const std::string& expression) {
    bool mass = false;
    for (std::size_t i = 0; i < expression.size();) {
        const auto c = static_cast<unsigned char>(expression[i]);
        if (std::isalpha(c) == 0 && c != '_') {
            const bool number = std::isdigit(c) != 0 || c == '.';
            ++i;
            while (number && i < expression.size() &&
                   (std::isalnum(static_cast<unsigned char>(expression[i])) != 0 ||
                    expression[i] == '.'))
                ++i; // the exponent's letter belongs to the number
            continue;
        }
        std::size_t end = i;
        while (end < expression.size() &&
               (std::isalnum(static_cast<unsigned char>(expression[end])) != 0 ||
                expression[end] == '_' || expression[end] == '.' || expression[end] == ':'))
            ++end;
        if (!expression.substr(i, end - i).ends_with(".mass"))
            return false;
        mass = true;
        i = end;
    }
    return mass;
}

bool isZero(const std::string& expression) {
    return expression.find_first_not_of("0.+- \t\n") == std::string::npos;
}

} // namespace

Vector upOf(const scene::Scene& scene) { return againstGravity(scene).value_or(Vector::UnitY()); }

std::optional<Vector> againstGravity(const scene::Scene& scene) {
    std::array<int, 6> votes{}; // against -x, +x, -y, ...
    for (const scene::Force& force : scene.forces) {
        if (force.couple)
            continue;
        if (const auto* g = std::get_if<scene::GravitationalForce>(&force.kind)) {
            Eigen::Index axis = 0;
            if (g->acceleration.cwiseAbs().maxCoeff(&axis) > 0)
                ++votes[static_cast<std::size_t>(2 * axis + (g->acceleration[axis] > 0))];
        } else if (const auto* c = std::get_if<scene::ComponentForce>(&force.kind)) {
            // "-10 * b1.mass" along one axis alone is how scenes write gravity.
            const auto given = std::count_if(c->components.begin(), c->components.end(),
                                             [](const auto& e) { return !isZero(e); });
            for (std::size_t axis = 0; axis < 3 && given == 1; ++axis) {
                const std::string& e = c->components[axis];
                if (!isZero(e) && isWeight(e))
                    ++votes[2 * axis + (e.find('-') == std::string::npos)];
            }
        }
    }
    const auto most = std::max_element(votes.begin(), votes.end());
    if (*most == 0)
        return std::nullopt;
    const auto winner = most - votes.begin();
    return Vector(Vector::Unit(winner / 2)) * (winner % 2 == 0 ? 1.0 : -1.0);
}

namespace {

// The direction to the side of a wide flat box on which all bodies that are not fixed stand.
std::optional<Vector> sideOfAll(const scene::Scene& scene, const Vector& middle, const Vector& half,
                                Eigen::Index thin) {
    constexpr double near = 0.25; // of a body's height
    std::array<bool, 2> standOn{true, true};
    bool any = false;
    for (const scene::Body& body : scene.bodies) {
        if (body.fixed)
            continue;
        any = true;
        Box box;
        for (const Ball& ball : outlineOf(scene, body))
            box.extend(
                around({body.initialPosition + body.initialAttitude * ball.center, ball.radius}));
        const Vector apart = box.center() - middle;
        const double gap = std::abs(apart[thin]) - half[thin] - box.sizes()[thin] / 2;
        Vector beside = apart.cwiseAbs() - half;
        beside[thin] = 0;
        const bool isOn =
            !box.isEmpty() && beside.maxCoeff() <= 0 && std::abs(gap) <= near * box.sizes()[thin];
        standOn[0] = standOn[0] && isOn && apart[thin] > 0;
        standOn[1] = standOn[1] && isOn && apart[thin] < 0;
    }
    if (!any || (!standOn[0] && !standOn[1]))
        return std::nullopt;
    return Vector(Vector::Unit(thin) * (standOn[0] ? 1.0 : -1.0));
}

// A table tells the ground's direction in a scene in which nothing falls: a wide flat box that is
// fixed, with all free bodies on it.
std::optional<Vector> tableNormal(const scene::Scene& scene) {
    double largest = 0;
    std::optional<Vector> normal;
    for (const scene::Body& body : scene.bodies) {
        const scene::ShapeSet* shape = scene::findShapeSet(scene, body.shape);
        if (!body.fixed || shape == nullptr || body.initialAttitude.vec().norm() > 1e-9)
            continue;
        for (const scene::Part& part : shape->parts) {
            const auto* box = std::get_if<scene::BoxShape>(&part.shape);
            Eigen::Index thin = 0;
            if (box == nullptr || !part.rotation.isZero() || box->edges.minCoeff(&thin) <= 0)
                continue;
            const double area = box->edges.prod() / box->edges[thin];
            const double narrow = std::min(box->edges[(thin + 1) % 3], box->edges[(thin + 2) % 3]);
            if (area <= largest || box->edges[thin] >= 0.25 * narrow)
                continue;
            if (const auto side =
                    sideOfAll(scene, body.initialPosition + part.position, box->edges / 2, thin)) {
                largest = area;
                normal = side;
            }
        }
    }
    return normal;
}

Extent directionsOf(const scene::Scene& scene) {
    Extent extent;
    const std::optional<Vector> up = againstGravity(scene);
    extent.up = up.value_or(Vector::UnitY());
    extent.ground = up ? *up : tableNormal(scene).value_or(extent.up);
    return extent;
}

// Of the lowest point.
double heightOf(const Box& box, const Vector& up) {
    return box.center().dot(up) - box.sizes().dot(up.cwiseAbs()) / 2;
}

// The parts of an extent that follow from its balls.
void settle(Extent& extent) {
    const bool isEmpty = extent.box.isEmpty();
    if (isEmpty)
        keep(extent, {Vector::Zero(), 1});
    extent.size = std::max(extent.box.sizes().maxCoeff(), 1e-9);
    extent.lowest = heightOf(extent.box, extent.ground);
    if (isEmpty) // where a first body stands
        extent.lowest = 0;
}

double lowestOfFixed(const scene::Scene& scene, const Survey& survey, const Extent& extent) {
    double lowest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < survey.paths.size(); ++i)
        if (scene.bodies[i].fixed && !extent.moves[i] && !survey.paths[i].poses.empty())
            for (const Ball& ball : survey.outlines[i])
                lowest = std::min(
                    lowest, survey.paths[i].poses.front().toWorld(ball.center).dot(extent.ground) -
                                ball.radius);
    return lowest;
}

// The room of what moves where it starts, what holds it, and what stands near it, fixed or not.
Box startOf(const Survey& survey, const Extent& extent, const std::vector<Vector>& anchors,
            double near) {
    Box start;
    const auto outline = [&](std::size_t i) {
        Box box;
        if (!survey.paths[i].poses.empty())
            for (const Ball& ball : survey.outlines[i])
                box.extend(
                    around({survey.paths[i].poses.front().toWorld(ball.center), ball.radius}));
        return box;
    };
    for (std::size_t i = 0; i < survey.paths.size(); ++i)
        if (extent.moves[i])
            start.extend(outline(i));
    if (start.isEmpty())
        return start;
    for (const Vector& anchor : anchors)
        start.extend(anchor);
    const double size = start.sizes().maxCoeff();
    const Box beside(start.min().array() - near * size, start.max().array() + near * size);
    for (std::size_t i = 0; i < survey.paths.size(); ++i)
        if (!extent.moves[i])
            start.extend(beside.intersection(outline(i)));
    return start;
}

// Something level without an end catches all that is still above it.
bool hasEndlessFloor(const scene::Scene& scene, const Vector& up) {
    return std::ranges::any_of(scene.bodies, [&](const scene::Body& body) {
        const scene::ShapeSet* shape = scene::findShapeSet(scene, body.shape);
        return body.fixed && shape != nullptr &&
               std::ranges::any_of(shape->parts, [&](const scene::Part& part) {
                   return std::holds_alternative<scene::PlaneShape>(part.shape) &&
                          up.dot(body.initialAttitude *
                                 geometry::fromRotationVector(part.rotation) * Vector::UnitY()) >
                              0.999;
               });
    });
}

// It comes below that height for good, and still falls when the motion ends, about as fast as ever.
bool dropsBelow(const Path& path, double height, const Vector& up) {
    bool isBelow = false;
    double last = 0, most = 0;
    for (std::size_t k = 1; k < path.poses.size(); ++k) {
        const double now = path.poses[k].position.dot(up);
        if (isBelow && now >= height)
            return false;
        isBelow = now < height;
        last = path.poses[k - 1].position.dot(up) - now;
        most = std::max(most, last);
    }
    return isBelow && last > 0.9 * most;
}

// Ends the paths of bodies that drop out of sight, as nothing catches them, while one still sees
// them beside the place where they start. Returns which they are.
std::vector<bool> cutFalls(Survey& survey, const scene::Scene& scene, const Extent& extent,
                           const std::vector<Vector>& anchors) {
    constexpr double far = 5, seen = 1; // times the size of the start
    std::vector<bool> falls(survey.paths.size());
    const Vector& up = extent.up;
    const Box start = startOf(survey, extent, anchors, far);
    if (start.isEmpty() || !againstGravity(scene) || hasEndlessFloor(scene, up))
        return falls;
    const double size = start.sizes().maxCoeff();
    const double lowest = heightOf(start, up) - seen * size;
    const double below =
        std::min(heightOf(start, up) - far * size, lowestOfFixed(scene, survey, extent));
    for (std::size_t i = 0; i < survey.paths.size(); ++i) {
        Path& path = survey.paths[i];
        falls[i] = extent.moves[i] && dropsBelow(path, below, up);
        if (!falls[i])
            continue;
        const auto out = std::ranges::find_if(
            path.poses, [&](const Pose& pose) { return pose.position.dot(up) < lowest; });
        path.poses.erase(out, path.poses.end());
        path.centers.setEmpty();
        for (const Pose& pose : path.poses)
            path.centers.extend(pose.position);
    }
    return falls;
}

enum class Falls { cut, whole };

Extent extentWith(const scene::Scene& scene, const simulation::Motion* motion, Falls wanted) {
    Extent extent = directionsOf(scene);
    Survey survey = surveyOf(scene, motion);
    bool anyMoves = false;
    for (const scene::Body& body : scene.bodies)
        extent.fixed.push_back(body.fixed);
    for (const Path& path : survey.paths) {
        extent.turns.push_back(path.turns());
        extent.spins.push_back(path.spins());
        extent.moves.push_back(path.travels() || path.turns());
        anyMoves = anyMoves || extent.moves.back();
    }
    extent.planeNormal = flatAlong(survey.paths, extent.moves, extent.up);
    std::vector<Vector> anchors = anchorsOf(scene, motion);
    std::ranges::copy(jointAnchorsOf(scene, motion), std::back_inserter(anchors));
    std::ranges::copy(ropeAnchorsOf(scene), std::back_inserter(anchors));
    std::vector<bool> belongs, wanders(survey.paths.size()), falls(survey.paths.size());
    if (wanted == Falls::cut)
        falls = cutFalls(survey, scene, extent, anchors);
    for (std::size_t i = 0; i < survey.paths.size(); ++i)
        belongs.push_back(!anyMoves || extent.moves[i] || !scene.bodies[i].fixed);
    if (std::ranges::find(falls, true) != falls.end())
        extent.planeNormal.reset(); // straight on, the ground would be seen from below
    const std::optional<Box> room = roomOfTheOthers(survey, belongs, wanders);
    Extent dropping; // below what the ground is for
    for (std::size_t i = 0; i < survey.paths.size(); ++i) {
        if (!belongs[i])
            continue;
        const auto& near = wanders[i] ? room : std::nullopt;
        keepPath(extent, survey.paths[i], survey.outlines[i], falls[i] ? Box() : near);
        if (falls[i])
            keepPath(dropping, survey.paths[i], survey.outlines[i], near);
    }
    const Box moving = extent.box.merged(dropping.box);
    for (std::size_t i = 0; i < survey.paths.size(); ++i)
        if (!belongs[i] && !survey.paths[i].poses.empty())
            keepNear(extent, moving, survey.paths[i].poses.front(), survey.outlines[i]);
    for (std::size_t i = 0; i < survey.paths.size(); ++i)
        if (!survey.paths[i].poses.empty())
            keepPlanes(extent, scene, scene.bodies[i], survey.paths[i].poses.front());
    for (const Vector& anchor : anchors)
        keep(extent, {anchor, 0});
    settle(extent);
    const double lowest = extent.lowest;
    for (const Ball& ball : dropping.balls)
        keep(extent, ball);
    settle(extent);
    extent.lowest = lowest;
    extent.lowestStands =
        lowestOfFixed(scene, survey, extent) <= extent.lowest + 1e-3 * extent.size;
    return extent;
}

} // namespace

Extent extentOf(const scene::Scene& scene, const simulation::Motion* motion) {
    return extentWith(scene, motion, Falls::cut);
}

Extent extentAt(const scene::Scene& scene, const simulation::Motion* motion, double time,
                const std::vector<std::size_t>& bodies) {
    Extent extent = directionsOf(scene);
    std::vector<std::size_t> all = bodies;
    if (all.empty())
        for (std::size_t i = 0; i < scene.bodies.size(); ++i)
            all.push_back(i);
    const auto poseNow = [&](std::size_t i) { return poseOf(scene, motion, i, time); };
    for (const std::size_t i : all)
        if (i < scene.bodies.size() && finite(poseNow(i)))
            for (const Ball& ball : outlineOf(scene, scene.bodies[i]))
                keep(extent, {poseNow(i).toWorld(ball.center), ball.radius});
    for (const std::size_t i : all)
        if (i < scene.bodies.size() && finite(poseNow(i)))
            keepPlanes(extent, scene, scene.bodies[i], poseNow(i));
    settle(extent);
    return extent;
}

Extent extentOfAll(const scene::Scene& scene, const simulation::Motion* motion) {
    Extent extent = extentWith(scene, motion, Falls::whole);
    const double size = extent.size;
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        if (extent.moves[i])
            continue;
        const geometry::Pose pose = poseOf(scene, motion, i, 0);
        Box whole;
        for (const Ball& ball : outlineOf(scene, scene.bodies[i]))
            whole.extend(around({pose.toWorld(ball.center), ball.radius}));
        if (whole.isEmpty() || whole.sizes().maxCoeff() > much * size)
            continue;
        for (const Ball& ball : outlineOf(scene, scene.bodies[i]))
            keep(extent, {pose.toWorld(ball.center), ball.radius});
    }
    settle(extent);
    return extent;
}

} // namespace render
