#include "meshes/solids.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <unordered_map>

namespace meshes {

namespace {

using Triangle = std::array<std::uint32_t, 3>;

// Who passes an undirected edge, and which way.
struct Passing {
    std::vector<std::uint32_t> along, against; // triangles, from the lesser vertex to the greater
    [[nodiscard]] bool balanced() const { return along.size() == against.size(); }
};

using Edges = std::unordered_map<std::uint64_t, Passing>;

Edges edgesOf(const Mesh& mesh) {
    Edges edges;
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t a = mesh.triangles[t][k], b = mesh.triangles[t][(k + 1) % 3];
            Passing& edge = edges[std::uint64_t{std::min(a, b)} << 32U | std::max(a, b)];
            (a < b ? edge.along : edge.against).push_back(t);
        }
    return edges;
}

std::size_t unbalanced(const Edges& edges) {
    return static_cast<std::size_t>(
        std::ranges::count_if(edges, [](const auto& one) { return !one.second.balanced(); }));
}

// Sets of triangles that share edges.
class Groups {
public:
    explicit Groups(std::size_t count) : parents_(count) {
        std::iota(parents_.begin(), parents_.end(), 0U);
    }
    std::uint32_t of(std::uint32_t one) {
        while (parents_[one] != one)
            one = parents_[one] = parents_[parents_[one]];
        return one;
    }
    void join(std::uint32_t a, std::uint32_t b) { parents_[of(a)] = of(b); }

private:
    std::vector<std::uint32_t> parents_;
};

std::vector<Mesh> piecesOf(const Mesh& mesh, const Edges& edges) {
    Groups groups(mesh.triangles.size());
    for (const auto& [key, edge] : edges) {
        const std::uint32_t first = edge.along.empty() ? edge.against[0] : edge.along[0];
        for (const auto* side : {&edge.along, &edge.against})
            for (const std::uint32_t t : *side)
                groups.join(first, t);
    }
    // In the order of the file.
    std::unordered_map<std::uint32_t, std::size_t> numbers;
    std::vector<Mesh> pieces;
    std::vector<std::unordered_map<std::uint32_t, std::uint32_t>> vertices;
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto [at, fresh] = numbers.try_emplace(groups.of(t), pieces.size());
        if (fresh) {
            pieces.emplace_back();
            vertices.emplace_back();
        }
        Mesh& piece = pieces[at->second];
        Triangle one{};
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t v = mesh.triangles[t][k];
            const auto [own, isNew] = vertices[at->second].try_emplace(
                v, static_cast<std::uint32_t>(piece.vertices.size()));
            if (isNew)
                piece.vertices.push_back(mesh.vertices[v]);
            one[k] = own->second;
        }
        piece.triangles.push_back(one);
    }
    return pieces;
}

// Neighbours pass their common edge in opposite directions from now on; false: they cannot, or some
// edge has not two triangles.
bool agree(Mesh& piece) {
    const Edges edges = edgesOf(piece);
    std::vector<std::vector<std::pair<std::uint32_t, bool>>> next(piece.triangles.size());
    for (const auto& [key, edge] : edges) {
        if (edge.along.size() + edge.against.size() != 2)
            return false;
        const bool same = !edge.balanced();
        const std::uint32_t a = edge.along.empty() ? edge.against[0] : edge.along[0];
        const std::uint32_t b = !same                ? edge.against[0]
                                : edge.along.empty() ? edge.against[1]
                                                     : edge.along[1];
        next[a].emplace_back(b, same);
        next[b].emplace_back(a, same);
    }
    std::vector<int> turned(piece.triangles.size(), -1);
    std::vector<std::uint32_t> front = {0};
    turned[0] = 0;
    while (!front.empty()) {
        const std::uint32_t t = front.back();
        front.pop_back();
        for (const auto& [other, same] : next[t]) {
            const int wanted = same ? 1 - turned[t] : turned[t];
            if (turned[other] < 0) {
                turned[other] = wanted;
                front.push_back(other);
            } else if (turned[other] != wanted) {
                return false; // a Moebius strip, a Klein bottle
            }
        }
    }
    for (std::size_t t = 0; t < piece.triangles.size(); ++t)
        if (turned[t] == 1)
            std::swap(piece.triangles[t][1], piece.triangles[t][2]);
    return true;
}

void turn(Mesh& mesh) {
    for (Triangle& t : mesh.triangles)
        std::swap(t[1], t[2]);
}

void append(Mesh& mesh, const Mesh& more) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), more.vertices.begin(), more.vertices.end());
    for (const Triangle& t : more.triangles)
        mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
}

// Of each closed piece: a solid of its own, or a cavity of the smallest one around it.
// Nothing when it is told to end.
std::vector<Solid> nested(std::vector<Mesh> closed, const GoOn& goOn) {
    double all = 0;
    for (const Mesh& piece : closed)
        all += volumeOf(piece);
    std::vector<Solid> solids;
    std::vector<Mesh> inward;
    for (Mesh& piece : closed) {
        if (all < 0)
            turn(piece); // the whole file is inside out
        const double volume = volumeOf(piece);
        if (volume > 0)
            solids.push_back({std::move(piece), volume});
        else if (volume < 0)
            inward.push_back(std::move(piece));
    }
    for (std::size_t i = 0; i < inward.size(); ++i) {
        Mesh& piece = inward[i];
        Solid* around = nullptr;
        for (Solid& solid : solids) {
            if (goOn &&
                !goOn(0.5 + 0.5 * static_cast<double>(i) / static_cast<double>(inward.size())))
                return {};
            if (windingNumber(solid.surface, piece.vertices[0]) > 0.5 &&
                (!around || solid.volume < around->volume))
                around = &solid;
        }
        const double volume = -volumeOf(piece);
        if (around && around->volume > volume) {
            append(around->surface, piece);
            around->volume -= volume;
        } else {
            turn(piece);
            solids.push_back({std::move(piece), volume});
        }
    }
    return solids;
}

} // namespace

double volumeOf(const Mesh& surface) {
    if (surface.vertices.empty())
        return 0;
    const Vector origin = surface.vertices[0];
    double six = 0;
    for (const Triangle& t : surface.triangles)
        six += (surface.vertices[t[0]] - origin)
                   .dot((surface.vertices[t[1]] - origin).cross(surface.vertices[t[2]] - origin));
    return six / 6;
}

// The solid angle of each triangle (Van Oosterom and Strackee 1983), over that of the sphere.
double windingNumber(const Mesh& surface, const Vector& place) {
    double angle = 0;
    for (const Triangle& t : surface.triangles) {
        const Vector a = surface.vertices[t[0]] - place, b = surface.vertices[t[1]] - place,
                     c = surface.vertices[t[2]] - place;
        const double la = a.norm(), lb = b.norm(), lc = c.norm();
        angle += 2 * std::atan2(a.dot(b.cross(c)),
                                la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
    }
    return angle / (4 * std::numbers::pi);
}

Solids solidsOf(const Mesh& mesh, const GoOn& goOn) {
    Solids result;
    const auto goesOn = [&](double share) {
        result.cancelled = result.cancelled || (goOn && !goOn(share));
        return !result.cancelled;
    };
    if (!goesOn(0))
        return result;
    Mesh whole = welded(mesh);
    Edges edges = edgesOf(whole);
    if (unbalanced(edges) > 0 && goesOn(0.1)) {
        Mesh closer = welded(mesh, 1e-6 * extentOf(mesh).maxCoeff());
        Edges now = edgesOf(closer);
        if (unbalanced(now) < unbalanced(edges)) {
            whole = std::move(closer);
            edges = std::move(now);
        }
    }
    if (!goesOn(0.3))
        return result;
    std::vector<Mesh> closed, pieces = piecesOf(whole, edges);
    result.pieces = pieces.size();
    if (pieces.size() > mostPieces)
        return result; // who lies in whom takes the square of their number
    for (Mesh& piece : pieces) {
        if (!goesOn(0.4))
            return result;
        if (unbalanced(edgesOf(piece)) == 0 || agree(piece)) {
            closed.push_back(std::move(piece));
        } else {
            result.openEdges += unbalanced(edgesOf(piece));
            result.open.push_back(std::move(piece));
        }
    }
    result.solids = nested(std::move(closed), goesOn);
    return result;
}

} // namespace meshes
