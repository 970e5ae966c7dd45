#include "meshes/mesh.h"

#include <cmath>
#include <unordered_map>

namespace meshes {

namespace {

struct Key {
    std::array<double, 3> numbers;
    bool operator==(const Key&) const = default;
};

struct KeyHash {
    std::size_t operator()(const Key& key) const {
        std::size_t hash = 0;
        for (const double x : key.numbers)
            hash = hash * 1'099'511'628'211U + std::hash<double>()(x);
        return hash;
    }
};

} // namespace

Mesh welded(const Mesh& mesh, double tolerance) {
    Mesh result;
    std::unordered_map<Key, std::uint32_t, KeyHash> known;
    std::vector<std::uint32_t> now;
    now.reserve(mesh.vertices.size());
    for (const Vector& p : mesh.vertices) {
        Key key{};
        for (std::size_t k = 0; k < 3; ++k) {
            const double x = p[static_cast<int>(k)];
            key.numbers[k] = (tolerance > 0 ? std::round(x / tolerance) : x) + 0.0; // no -0
        }
        const auto [at, fresh] =
            known.try_emplace(key, static_cast<std::uint32_t>(result.vertices.size()));
        if (fresh)
            result.vertices.push_back(p);
        now.push_back(at->second);
    }
    for (const auto& t : mesh.triangles) {
        const std::array<std::uint32_t, 3> one = {now[t[0]], now[t[1]], now[t[2]]};
        if (one[0] != one[1] && one[1] != one[2] && one[2] != one[0])
            result.triangles.push_back(one);
    }
    return result;
}

Vector extentOf(const Mesh& mesh) {
    Eigen::AlignedBox3d box;
    for (const Vector& p : mesh.vertices)
        box.extend(p);
    return box.isEmpty() ? Vector(Vector::Zero()) : Vector(box.sizes());
}

} // namespace meshes
