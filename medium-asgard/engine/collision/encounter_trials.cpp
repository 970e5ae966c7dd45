#include "collision/encounter_trials.h"

#include "collision/separation.h"
#include "geometry/hull.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace collision {

namespace {

double uniform(std::mt19937_64& random, double from, double to) {
    return std::uniform_real_distribution<double>(from, to)(random);
}

Vector drawVector(std::mt19937_64& random) {
    return {uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, -1, 1)};
}

geometry::Shape drawShape(std::mt19937_64& random) {
    geometry::Shape shape;
    switch (random() % 7) {
    case 0:
    case 1:
        shape.parts.push_back(geometry::spherePart(uniform(random, 0.05, 0.5)));
        break;
    case 2: // plate
        shape.parts.push_back(geometry::polyhedronPart(geometry::box({1, 1, 1e-3})));
        break;
    case 3: // rod
        shape.parts.push_back(geometry::polyhedronPart(geometry::box({2, 0.05, 0.05})));
        break;
    case 4: // dumb-bell
        shape.parts.push_back(geometry::spherePart(0.2, {-0.5, 0, 0}));
        shape.parts.push_back(geometry::polyhedronPart(geometry::box({0.3, 0.3, 0.3}),
                                                       {{0.5, 0, 0}, Quaternion::Identity()}));
        break;
    case 5: {
        std::vector<Vector> points;
        for (int i = 0; i < 12; ++i)
            points.push_back(0.5 * drawVector(random).normalized());
        const auto hull = geometry::convexHull(points);
        shape.parts.push_back(geometry::polyhedronPart(std::get<geometry::Hull>(hull).polyhedron));
        break;
    }
    default:
        shape.parts.push_back(geometry::polyhedronPart(geometry::box({0.6, 0.5, 0.4})));
    }
    return shape;
}

geometry::Shape drawCurvedShape(std::mt19937_64& random) {
    const double r = uniform(random, 0.05, 0.5), h = uniform(random, 0.05, 1);
    switch (random() % 7) {
    case 0:
        return {{geometry::capsulePart(r, h)}};
    case 1: // needle
        return {{geometry::capsulePart(0.01, 1)}};
    case 2:
        return {{geometry::cylinderPart(r, h)}};
    case 3: // coin
        return {{geometry::cylinderPart(0.5, random() % 2 ? 1e-3 : 0.05)}};
    case 4:
        return {{geometry::conePart(r, h)}};
    case 5: // a drum with a cone on it
        return {{geometry::cylinderPart(r, 0.4),
                 geometry::conePart(r, 0.4, {{0, 0.4, 0}, Quaternion::Identity()})}};
    default:
        return {{geometry::ellipsoidPart({r, h, uniform(random, 0.05, 0.7)})}};
    }
}

FlyingBody drawBody(std::mt19937_64& random, bool isCurved) {
    FlyingBody body;
    body.form = isCurved ? drawCurvedShape(random) : drawShape(random);
    body.attitude = random() % 3 ? geometry::fromRotationVector(3 * drawVector(random))
                                 : Quaternion::Identity();
    if (random() % 2)
        body.spin = std::pow(10, uniform(random, -1, 2.3)) * drawVector(random).normalized();
    if (random() % 4 == 0)
        body.acceleration = 10 * drawVector(random);
    return body;
}

struct Oracle {
    const FlyingBody& first;
    const FlyingBody& second;

    // Depth of overlap is negative; of all pairs of parts the least.
    [[nodiscard]] double gapAt(double t) const {
        const Pose a = poseAt(first, t), b = poseAt(second, t);
        double least = std::numeric_limits<double>::infinity();
        for (const geometry::Part& p : first.form.parts)
            for (const geometry::Part& q : second.form.parts) {
                WarmStart cold;
                const Posed x{&p, a.attitude.toRotationMatrix(), a.position - b.position};
                const Posed y{&q, b.attitude.toRotationMatrix(), Vector::Zero()};
                least = std::min(least, separate(x, y, cold).gap);
            }
        return least;
    }

    // The least gap near the middle one of three samples, by golden section.
    [[nodiscard]] std::pair<double, double> deepest(double low, double high) const {
        const double ratio = (std::sqrt(5.0) - 1) / 2;
        double x = high - ratio * (high - low), y = low + ratio * (high - low);
        double fx = gapAt(x), fy = gapAt(y);
        for (int i = 0; i < 60 && high - low > 1e-15; ++i)
            if (fx < fy) {
                high = y;
                y = x;
                fy = fx;
                x = high - ratio * (high - low);
                fx = gapAt(x);
            } else {
                low = x;
                x = y;
                fx = fy;
                y = low + ratio * (high - low);
                fy = gapAt(y);
            }
        return fx < fy ? std::pair(x, fx) : std::pair(y, fy);
    }
};

// When the bodies' bounding spheres overlap: outside of that nothing needs sampling.
Interval nearInterval(const Meeting& m) {
    const double reach = geometry::radiusAbout(m.first.form, Vector::Zero()) +
                         geometry::radiusAbout(m.second.form, Vector::Zero());
    Interval near{m.until, 0};
    const double step = m.until / 400;
    for (int i = 0; i <= 400; ++i) {
        const double t = i * step;
        const double distance =
            (positionAt(m.first.pieceAt(t), t) - positionAt(m.second.pieceAt(t), t)).norm();
        if (distance < 1.1 * reach) {
            near.from = std::min(near.from, std::max(0.0, t - step));
            near.to = std::max(near.to, std::min(m.until, t + step));
        }
    }
    return near;
}

Meeting meetingOf(std::mt19937_64& random, FlyingBody first, FlyingBody second) {
    Meeting m{std::move(first), std::move(second), 1};
    // The first flies past the second at about the middle of the interval.
    const double speed = std::pow(10, uniform(random, 0, 3));
    const Vector way = drawVector(random).normalized();
    const double reach = geometry::radiusAbout(m.first.form, Vector::Zero()) +
                         geometry::radiusAbout(m.second.form, Vector::Zero());
    const double aside = random() % 3 ? uniform(random, 0, 1) : uniform(random, 0.9, 1.01);
    m.until = 8 * reach / speed;
    m.first.velocity = speed * way;
    m.first.position = way.unitOrthogonal() * (aside * reach) - way * (4 * reach);
    m.first.acceleration *= std::min(1.0, speed / 10);
    m.second.acceleration *= std::min(1.0, speed / 10);
    return m;
}

} // namespace

Meeting drawMeeting(std::mt19937_64& random) {
    FlyingBody first = drawBody(random, false);
    return meetingOf(random, std::move(first), drawBody(random, false));
}

Meeting drawCurvedMeeting(std::mt19937_64& random) {
    FlyingBody first = drawBody(random, true);
    const bool areBoth = random() % 2 == 0;
    return meetingOf(random, std::move(first), drawBody(random, areBoth));
}

MeetingResult checkMeeting(const Meeting& m) {
    const double size = geometry::radiusAbout(m.first.form, Vector::Zero()) +
                        geometry::radiusAbout(m.second.form, Vector::Zero());
    const double tolerance = 1e-9 * size;
    const Encounter e = timeOfImpact(m.first, m.second, {0, m.until});
    MeetingResult result{"", e.hit.has_value(), e.evaluations};
    const Oracle oracle{m.first, m.second};
    if (e.hit) {
        const double gap = oracle.gapAt(e.hit->time);
        if (std::abs(gap) > tolerance)
            result.fault = "invented: the gap at the hit is " + std::to_string(gap / size);
        if (!(e.hit->contact.closingSpeed > 0))
            result.fault = "the surfaces do not approach at the hit";
    }
    const Interval near = nearInterval(m);
    const double end = std::min(near.to, e.hit ? e.hit->time : near.to);
    const int samples = 300;
    double before = std::numeric_limits<double>::infinity(), now = before;
    for (int i = 0; i <= samples && near.from < end; ++i) {
        const double t = near.from + (end - near.from) * i / samples;
        const double step = (end - near.from) / samples;
        const double next = oracle.gapAt(t);
        double deepest = next;
        if (i > 1 && now <= before && now <= next && now < 0.05 * size)
            deepest = oracle.deepest(t - 2 * step, t).second;
        if (deepest < -tolerance)
            result.fault = "missed: overlap of " + std::to_string(-1e9 * deepest / size) +
                           "e-9 of the size at or before " + std::to_string(t / m.until) +
                           " of the time";
        before = now;
        now = next;
    }
    return result;
}

} // namespace collision
