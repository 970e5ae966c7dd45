#include "collision/turning_axis.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace collision {
namespace {

constexpr double shorter = 8;      // times, each window than the one before
constexpr double shortest = 1e-12; // of what is left
constexpr double onAxis = 1e-6;   // of the part's size: features that touch the other along an axis
constexpr double crossing = 1e-3; // edges that are nearer to parallel do not cross

using Series = std::vector<double>; // of powers of (time - t) / left
using Vectors = std::vector<Vector>;
using Quaternions = std::vector<Quaternion>;

// Coefficients of powers of (time - from) / scale become those of (time - t) / left.
template <typename Value>
std::vector<Value> movedTo(std::vector<Value> c, const MotionPiece& piece, double t, double left) {
    const double by = (t - piece.from) / piece.scale, longer = left / piece.scale;
    for (std::size_t i = 0; i + 1 < c.size(); ++i)
        for (std::size_t k = c.size() - 1; k-- > i;)
            c[k] += by * c[k + 1];
    double power = 1;
    for (Value& term : c) {
        term *= power;
        power *= longer;
    }
    return c;
}

Quaternions attitudeOf(const MotionPiece& piece, double t, double left) {
    Quaternions result;
    for (const Eigen::Vector4d& q : movedTo(piece.attitude, piece, t, left))
        result.emplace_back(q[0], q[1], q[2], q[3]);
    return result;
}

void add(Series& sum, const Series& more, double factor) {
    sum.resize(std::max(sum.size(), more.size()), 0);
    for (std::size_t k = 0; k < more.size(); ++k)
        sum[k] += factor * more[k];
}

Series product(const Series& a, const Series& b) {
    Series result(a.size() + b.size() - 1, 0);
    for (std::size_t i = 0; i < a.size(); ++i)
        for (std::size_t j = 0; j < b.size(); ++j)
            result[i + j] += a[i] * b[j];
    return result;
}

Series dot(const Vectors& a, const Vectors& b) {
    Series result(a.size() + b.size() - 1, 0);
    for (std::size_t i = 0; i < a.size(); ++i)
        for (std::size_t j = 0; j < b.size(); ++j)
            result[i + j] += a[i].dot(b[j]);
    return result;
}

Vectors cross(const Vectors& a, const Vectors& b) {
    Vectors result(a.size() + b.size() - 1, Vector::Zero());
    for (std::size_t i = 0; i < a.size(); ++i)
        for (std::size_t j = 0; j < b.size(); ++j)
            result[i + j] += a[i].cross(b[j]);
    return result;
}

Series squareOf(const Quaternions& q) {
    Series result(2 * q.size() - 1, 0);
    for (std::size_t i = 0; i < q.size(); ++i)
        for (std::size_t j = 0; j < q.size(); ++j)
            result[i + j] += q[i].dot(q[j]);
    return result;
}

// q v q*: the turned vector, times |q|^2.
Vectors turned(const Quaternions& q, const Vector& v) {
    Vectors result(2 * q.size() - 1, Vector::Zero());
    const Quaternion pure(0, v.x(), v.y(), v.z());
    for (std::size_t i = 0; i < q.size(); ++i)
        for (std::size_t j = 0; j < q.size(); ++j)
            result[i + j] += (q[i] * pure * q[j].conjugate()).vec();
    return result;
}

struct Bounds {
    double least = 0, atEnd = 0;
};

// Over 0 <= s <= window.
Bounds boundsOf(const Series& c, double window) {
    const std::size_t n = c.size() - 1;
    Series scaled = c;
    double power = 1;
    for (double& term : scaled) {
        term *= power;
        power *= window;
    }
    Bounds bounds{.least = HUGE_VAL, .atEnd = 0};
    for (std::size_t i = 0; i <= n; ++i) {
        double ratio = 1; // C(i,k) / C(n,k)
        bounds.atEnd = 0;
        for (std::size_t k = 0; k <= i; ++k) {
            bounds.atEnd += ratio * scaled[k];
            ratio *=
                static_cast<double>(i - k) / static_cast<double>(std::max<std::size_t>(n - k, 1));
        }
        bounds.least = std::min(bounds.least, bounds.atEnd);
    }
    return bounds;
}

class Apart {
public:
    explicit Apart(const ApartQuestion& question)
        : q_(question), sides_{Side(question.pair.first, question),
                               Side(question.pair.second, question)} {}

    double find() {
        for (const std::size_t owner : {0, 1})
            if (sides_[owner].part.turns())
                take(alongFace(owner));
        if (!sides_[0].part.turns() || !sides_[1].part.turns())
            tryEdges();
        return best_ * q_.left;
    }

private:
    struct Side {
        Side(const PartMotion& motion, const ApartQuestion& q)
            : part(motion), attitude(attitudeOf(motion.piece, q.t, q.left)),
              square(squareOf(attitude)),
              path(movedTo(motion.piece.position, motion.piece, q.t, q.left)) {}
        // From the pivot, times `square`.
        [[nodiscard]] Vectors lever(const Vector& point) const {
            return turned(attitude, point - part.pivot);
        }
        [[nodiscard]] Vectors along(const Vector& direction) const {
            return turned(attitude, direction);
        }
        [[nodiscard]] const std::vector<Vector>& vertices() const {
            return part.part->core.vertices;
        }
        const PartMotion& part;
        Quaternions attitude;
        Series square;
        Vectors path;
    };
    struct Edge {
        Vector from, to; // in the part's frame
    };

    // Of the second pivot from the first.
    [[nodiscard]] Vectors away() const {
        Vectors result = sides_[1].path;
        const Vectors& own = sides_[0].path;
        result.resize(std::max(result.size(), own.size()), Vector::Zero());
        for (std::size_t k = 0; k < own.size(); ++k)
            result[k] -= own[k];
        return result;
    }

    // The longest window over which all of these are positive.
    void take(const std::vector<Series>& distances) {
        double window = std::min(q_.firstWindow / q_.left, 1.0);
        while (window > std::max(shortest, best_)) {
            const bool isApart = std::ranges::all_of(distances, [&](const Series& distance) {
                const Bounds bounds = boundsOf(distance, window);
                return bounds.least >= -q_.unnoticed / 4 && bounds.atEnd >= 0;
            });
            if (isApart)
                best_ = window;
            window /= shorter;
        }
    }

    // Distances of the other's vertices from the owner's side.
    [[nodiscard]] std::vector<Series> alongFace(std::size_t owner) const {
        const Side &own = sides_[owner], &other = sides_[1 - owner];
        const Vector outward = owner == 0 ? Vector(-q_.normal) : q_.normal;
        const Vectors normal = own.along(attitudeAt(own.part.piece, q_.t).conjugate() * outward);
        Series path = product(dot(normal, away()), other.square);
        if (owner == 1)
            for (double& term : path)
                term = -term;
        const Series square = product(own.square, other.square);
        std::vector<Series> distances;
        double nearest = HUGE_VAL;
        for (const Vector& vertex : other.vertices()) {
            Series distance = dot(normal, other.lever(vertex));
            add(distance, path, 1);
            nearest = std::min(nearest, distance[0] / square[0]);
            distances.push_back(std::move(distance));
        }
        for (Series& distance : distances)
            add(distance, square, q_.gap - nearest);
        return distances;
    }

    void tryEdges() {
        const std::vector<Edge> ofFirst = touchingEdges(0), ofSecond = touchingEdges(1);
        for (const Edge& a : ofFirst)
            for (const Edge& b : ofSecond)
                if (const auto distances = acrossEdges(a, b); !distances.empty())
                    take(distances);
    }

    // Edges that lie furthest out along the normal.
    [[nodiscard]] std::vector<Edge> touchingEdges(std::size_t which) const {
        const PartMotion& part = sides_[which].part;
        const Vector outward = attitudeAt(part.piece, q_.t).conjugate() *
                               (which == 0 ? Vector(-q_.normal) : q_.normal);
        const auto& core = part.part->core;
        const double least =
            outward.dot(core.vertices[geometry::support(core, outward, 0)]) - onAxis * part.reach;
        std::vector<Edge> edges;
        for (const geometry::Edge& edge : core.edges) {
            const Vector &from = core.vertices[edge.from], &to = core.vertices[edge.to];
            if (outward.dot(from) >= least && outward.dot(to) >= least)
                edges.push_back({from, to});
        }
        return edges;
    }

    // How far each part lies on its own side of the two edges' common perpendicular, and the edges
    // from each other. Empty: they do not cross.
    [[nodiscard]] std::vector<Series> acrossEdges(const Edge& a, const Edge& b) const {
        const Side &first = sides_[0], &second = sides_[1];
        Vectors axis = cross(first.along((a.to - a.from).normalized()),
                             second.along((b.to - b.from).normalized()));
        const double length = axis[0].norm();
        if (length < crossing)
            return {};
        const double sign = axis[0].dot(q_.normal) > 0 ? 1 : -1;
        for (Vector& term : axis)
            term *= sign / length;
        std::vector<Series> distances;
        for (const Vector& vertex : first.vertices())
            if (vertex != a.from && vertex != a.to)
                distances.push_back(dot(axis, first.along(vertex - a.from)));
        for (const Vector& vertex : second.vertices())
            if (vertex != b.from && vertex != b.to)
                distances.push_back(dot(axis, second.along(b.from - vertex)));
        Series between = product(dot(axis, first.lever(a.from)), second.square);
        add(between, product(dot(axis, second.lever(b.from)), first.square), -1);
        const Series square = product(first.square, second.square);
        add(between, product(dot(axis, away()), square), -1);
        // Of edges that are next to parallel the perpendicular may lie far off the normal: along it
        // the gap is less.
        add(between, square, std::min(q_.gap - between[0] / square[0], 0.0));
        distances.push_back(std::move(between));
        return distances;
    }

    const ApartQuestion& q_;
    std::array<Side, 2> sides_;
    double best_ = 0;
};

} // namespace

double apartFor(const ApartQuestion& question) {
    return question.left > 0 ? Apart(question).find() : 0;
}

} // namespace collision
