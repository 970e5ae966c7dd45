#include "placing/told_heaps.h"

#include <algorithm>
#include <cstdio>
#include <numeric>
#include <utility>

namespace simulation {
namespace {

// By body: the least one of those that pairs connect it with.
std::vector<std::size_t> rootsOf(const scene::Scene& scene,
                                 const std::map<collision::Pair, double>& sizes) {
    std::vector<std::size_t> above(scene.bodies.size());
    std::iota(above.begin(), above.end(), 0);
    const auto rootOf = [&](std::size_t body) {
        while (above[body] != body)
            body = above[body];
        return body;
    };
    for (const auto& [pair, size] : sizes)
        if (!isHeld(scene, pair.first) && !isHeld(scene, pair.second)) {
            const auto [low, high] = std::minmax({rootOf(pair.first), rootOf(pair.second)});
            above[high] = low;
        }
    std::vector<std::size_t> roots;
    for (std::size_t b = 0; b < above.size(); ++b)
        roots.push_back(rootOf(b));
    return roots;
}

std::string namesIn(const scene::Scene& scene, const collision::Pair& pair) {
    const auto [one, other] =
        scene.bodies[pair.first].fixed ? collision::Pair(pair.second, pair.first) : pair;
    return "\"" + scene.bodies[one].name + "\" and \"" + scene.bodies[other].name + "\"";
}

} // namespace

bool isHeld(const scene::Scene& scene, std::size_t body) {
    return scene.bodies[body].fixed ||
           std::ranges::any_of(scene.constraints, [&](const scene::Constraint& of) {
               return of.body == scene.bodies[body].name;
           });
}

std::vector<ToldHeap> toldHeaps(const scene::Scene& scene,
                                const std::map<collision::Pair, double>& sizes) {
    constexpr double rounding = 1e-6; // of a size: of equal ones the first pair is told
    const std::vector<std::size_t> roots = rootsOf(scene, sizes);
    std::map<std::pair<std::size_t, std::size_t>, ToldHeap> heaps; // of held bodies by pair
    for (const auto& [pair, size] : sizes) {
        const bool isFirstHeld = isHeld(scene, pair.first);
        const std::size_t root = roots[isFirstHeld ? pair.second : pair.first];
        const bool isApart = isFirstHeld && isHeld(scene, pair.second);
        const auto [found, isNew] =
            heaps.try_emplace({root, isApart ? pair.first : root}, ToldHeap{pair, size, {}});
        ToldHeap& heap = found->second;
        if (isNew)
            continue;
        if (size > (1 + rounding) * heap.size) {
            heap.others.push_back(std::exchange(heap.first, pair));
            heap.size = size;
        } else {
            heap.others.push_back(pair);
        }
    }
    std::vector<ToldHeap> all;
    for (auto& [key, heap] : heaps) {
        std::ranges::sort(heap.others);
        all.push_back(std::move(heap));
    }
    return all;
}

std::vector<std::size_t> bodiesIn(const ToldHeap& heap) {
    std::vector<std::size_t> bodies{heap.first.first, heap.first.second};
    for (const auto& [first, second] : heap.others)
        bodies.insert(bodies.end(), {first, second});
    return bodies;
}

std::string bodiesOf(const scene::Scene& scene, const collision::Pair& pair) {
    return "Bodies " + namesIn(scene, pair);
}

std::string lengthOf(double length) {
    char text[40];
    std::snprintf(text, sizeof text, "%.3g", length);
    return text;
}

std::string othersOf(const scene::Scene& scene, const ToldHeap& heap, std::string_view compared) {
    constexpr std::size_t few = 3;
    const std::size_t count = heap.others.size();
    if (count == 0)
        return "";
    std::string text = std::to_string(count) + (count == 1 ? " more pair " : " more pairs ");
    text += compared;
    if (count <= few)
        for (const collision::Pair& pair : heap.others)
            text += (pair == heap.others.front() ? " (" : ", ") + namesIn(scene, pair) +
                    (pair == heap.others.back() ? ")" : "");
    return text + "; they ";
}

} // namespace simulation
