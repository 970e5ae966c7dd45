#include "meshes/convex_parts.h"

#include "meshes/cuts.h"
#include "meshes/hulls.h"

#include <algorithm>
#include <optional>

namespace meshes {

namespace {

constexpr double exactly = 1e-9;       // of the size: how near to a plane is in it
constexpr double nothing = 1e-7;       // of the volume: not worth a cut
constexpr std::size_t mostPlanes = 48; // of concave edges
// Points of which hulls are compared: roughly for all cuts, well for the best of them, and in
// between for the many pairs that could be joined.
constexpr std::size_t rough = 40, paired = 80, well = 200, looks = 8;
constexpr double worthwhile = 0.3; // of the surplus: a cut that takes away less only divides it

double squareOfLength(const std::vector<Vector>& points) {
    Eigen::AlignedBox3d box;
    for (const Vector& p : points)
        box.extend(p);
    return box.diagonal().squaredNorm();
}

// A convex part of the result, or what will be cut further.
struct Part {
    std::vector<Vector> points; // of its hull
    double volume = 0, hull = 0;
    Piece piece;
    const Solid* solid = nullptr; // of which it is a piece; null: not to be cut
    [[nodiscard]] double surplus() const { return std::max(0.0, hull - volume); }
};

double surplusOf(const std::vector<Part>& parts) {
    double all = 0;
    for (const Part& part : parts)
        all += part.surplus();
    return all;
}

Part partOf(Piece piece, const Solid* solid) {
    Part part;
    part.volume = piece.volume();
    part.points = hullPoints(piece.points());
    part.hull = hullVolume(part.points);
    part.piece = std::move(piece);
    part.solid = solid;
    return part;
}

class Work {
public:
    Work(const Solids& solids, const Wanted& wanted, const GoOn& goOn)
        : solids_(solids), wanted_(wanted), goOn_(goOn) {}

    ConvexParts all() {
        begin();
        if (!result_.cancelled)
            cut();
        if (!result_.cancelled)
            join();
        for (const Part& part : parts_) {
            result_.parts.push_back(fewerPoints(part.points, wanted_.points));
            result_.partsVolume += hullVolume(result_.parts.back());
        }
        return std::move(result_);
    }

private:
    void begin() {
        for (const Solid& solid : solids_.solids) {
            if (!goesOn(0))
                return;
            Part part = partOf(pieceOf(solid), &solid);
            concave_.push_back(concavePlanes(solid, mostPlanes));
            if (part.points.empty())
                ++result_.flat;
            else
                parts_.push_back(std::move(part));
        }
        for (const Mesh& open : solids_.open) {
            if (!goesOn(0))
                return;
            Part part;
            part.points = hullPoints(open.vertices);
            part.hull = part.volume = hullVolume(part.points);
            if (part.points.empty())
                ++result_.flat;
            else
                parts_.push_back(std::move(part));
        }
        for (const Part& part : parts_)
            result_.volume += part.volume;
    }

    [[nodiscard]] bool goesOn(double share) {
        result_.cancelled = result_.cancelled || (goOn_ && !goOn_(share));
        return !result_.cancelled;
    }

    // Twice as many as are wanted: joining them finds better ones than stopping would.
    void cut() {
        const std::size_t most = std::max<std::size_t>(2 * wanted_.parts, 8);
        while (parts_.size() < most && surplusOf(parts_) > wanted_.surplus * result_.volume) {
            auto worst = parts_.end();
            for (auto part = parts_.begin(); part != parts_.end(); ++part)
                if (part->solid && part->surplus() > nothing * result_.volume &&
                    (worst == parts_.end() || part->surplus() > worst->surplus()))
                    worst = part;
            share_ = 0.8 * static_cast<double>(parts_.size()) / static_cast<double>(most);
            if (worst == parts_.end() || !goesOn(share_))
                return;
            if (auto halves = best(*worst)) {
                *worst = std::move(halves->first);
                parts_.push_back(std::move(halves->second));
            } else {
                worst->solid = nullptr;
            }
        }
    }

    struct Trial {
        Plane plane;
        double left = 0; // surplus of both sides; and a little for each that is not convex yet
        // The same, each by its share of the hulls and by how long it is: little where the surplus
        // is divided, and a ring is cut through rather than into two flat ones.
        double held = 0;
    };
    [[nodiscard]] std::optional<Trial> tried(const Part& part, const Plane& plane,
                                             std::size_t points) const {
        Trial trial{plane};
        double hulls = 0, concave = 0;
        for (const Plane& side : {plane, plane.flipped()}) {
            const Piece piece = below(part.piece, side, *part.solid, tolerance(*part.solid));
            const double volume = piece.volume();
            const std::vector<Vector> outer = extremes(piece.points(), points);
            const double hull = hullVolume(outer);
            if (!(volume > nothing * part.volume) || !(hull > 0))
                return std::nullopt;
            const double surplus = std::max(0.0, hull - volume);
            const bool isConvex = surplus <= nothing * part.volume;
            trial.left += surplus + (isConvex ? 0 : 0.02 * part.surplus());
            trial.held += surplus * hull * squareOfLength(outer);
            hulls += hull;
            concave += isConvex ? 0 : 1;
        }
        trial.held *= concave / hulls;
        return trial;
    }
    // By what is left, where a cut takes much of the surplus away; else by how it is divided, so
    // that the cuts after it can.
    static void sort(std::vector<Trial>& trials, double surplus) {
        std::ranges::stable_sort(trials, {}, &Trial::left);
        if (!trials.empty() && trials[0].left > (1 - worthwhile) * surplus)
            std::ranges::stable_sort(trials, {}, &Trial::held);
    }
    std::optional<std::pair<Part, Part>> best(const Part& part) {
        const auto number = static_cast<std::size_t>(part.solid - solids_.solids.data());
        std::vector<Trial> trials;
        const auto planes = cutsOf(part.points, concave_[number], tolerance(*part.solid));
        for (const Plane& plane : planes) {
            if (!goesOn(share_))
                return std::nullopt;
            if (const auto trial = tried(part, plane, rough))
                trials.push_back(*trial);
        }
        sort(trials, part.surplus());
        trials.resize(std::min(trials.size(), looks));
        for (Trial& trial : trials)
            if (const auto better = tried(part, trial.plane, well))
                trial = *better;
        sort(trials, part.surplus());
        if (trials.empty())
            return std::nullopt;
        const auto half = [&](const Plane& side) {
            return partOf(below(part.piece, side, *part.solid, tolerance(*part.solid)), part.solid);
        };
        return std::pair(half(trials[0].plane), half(trials[0].plane.flipped()));
    }
    static double tolerance(const Solid& solid) {
        return exactly * extentOf(solid.surface).maxCoeff();
    }

    // What the common hull of two parts has more than the two.
    static double more(const Part& a, const Part& b) {
        std::vector<Vector> points = a.points;
        points.insert(points.end(), b.points.begin(), b.points.end());
        return hullVolume(extremes(points, paired)) - a.hull - b.hull;
    }

    struct Pair {
        std::size_t a, b;
        double more;
    };
    void join() {
        std::vector<Pair> pairs;
        for (std::size_t a = 0; a < parts_.size(); ++a)
            for (std::size_t b = a + 1; b < parts_.size(); ++b) {
                if (!goesOn(0.8 +
                            0.2 * static_cast<double>(a) / static_cast<double>(parts_.size())))
                    return;
                pairs.push_back({a, b, more(parts_[a], parts_[b])});
            }
        std::vector<bool> gone(parts_.size());
        std::size_t count = parts_.size();
        double surplus = surplusOf(parts_);
        const double allowed =
            std::max(wanted_.surplus * result_.volume, surplus) + nothing * result_.volume;
        while (count > 1 && goesOn(0.99)) {
            const auto least = std::ranges::min_element(pairs, {}, &Pair::more);
            if (count <= wanted_.parts && surplus + least->more > allowed)
                break;
            const std::size_t a = least->a, b = least->b;
            surplus += std::max(0.0, least->more);
            parts_[a] = joined(parts_[a], parts_[b]);
            gone[b] = true;
            --count;
            std::erase_if(pairs, [&](const Pair& one) { return one.a == b || one.b == b; });
            for (Pair& one : pairs)
                if (one.a == a || one.b == a)
                    one.more = more(parts_[one.a], parts_[one.b]);
        }
        std::vector<Part> kept;
        for (std::size_t i = 0; i < parts_.size(); ++i)
            if (!gone[i])
                kept.push_back(std::move(parts_[i]));
        parts_ = std::move(kept);
    }
    static Part joined(const Part& a, const Part& b) {
        Part part;
        part.points = a.points;
        part.points.insert(part.points.end(), b.points.begin(), b.points.end());
        part.points = hullPoints(part.points);
        part.hull = hullVolume(part.points);
        part.volume = a.volume + b.volume;
        return part;
    }

    const Solids& solids_;
    Wanted wanted_;
    const GoOn& goOn_;
    std::vector<Part> parts_;
    std::vector<std::vector<Plane>> concave_; // of each solid
    double share_ = 0;
    ConvexParts result_;
};

} // namespace

ConvexParts convexParts(const Solids& solids, const Wanted& wanted, const GoOn& goOn) {
    return Work(solids, wanted, goOn).all();
}

} // namespace meshes
