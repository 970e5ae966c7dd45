#include "handles/handle_layout.h"

#include "drawing/frame.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>

namespace render {

namespace {

using Pixels = Eigen::Vector2d;
using Box = Eigen::AlignedBox2d;

double strokeOf(Size size) { return Frame(Drawing{}, size).stroke(1); }

// Groups of indices whose pairs, directly or one by one, are too near to each other.
std::vector<std::vector<std::size_t>> crowds(const std::vector<Pixels>& places,
                                             const std::vector<double>& radii) {
    std::vector<std::size_t> order(places.size());
    std::iota(order.begin(), order.end(), 0);
    std::ranges::sort(order, {}, [&](std::size_t i) { return places[i].x(); });
    std::vector<std::size_t> leader(places.size());
    std::iota(leader.begin(), leader.end(), 0);
    const auto find = [&](std::size_t i) {
        while (leader[i] != i)
            i = leader[i] = leader[leader[i]];
        return i;
    };
    const double widest = radii.empty() ? 0 : *std::ranges::max_element(radii);
    for (std::size_t a = 0; a < order.size(); ++a)
        for (std::size_t b = a + 1; b < order.size(); ++b) {
            const std::size_t i = order[a], j = order[b];
            if (places[j].x() - places[i].x() > 2 * widest)
                break;
            // One sees and reaches half of the one below.
            if ((places[i] - places[j]).norm() < 0.5 * (radii[i] + radii[j]))
                leader[std::max(find(i), find(j))] = std::min(find(i), find(j));
        }
    std::vector<std::vector<std::size_t>> groups(places.size());
    for (std::size_t i = 0; i < places.size(); ++i)
        groups[find(i)].push_back(i);
    std::erase_if(groups, [](const auto& group) { return group.size() < 2; });
    return groups;
}

double overlap(const Box& a, const Box& b) {
    const Box both = a.intersection(b);
    return both.isEmpty() ? 0 : both.sizes().prod();
}

} // namespace

Pixels standOf(const Handle& handle, const Camera& camera, Size size) {
    return toPixels(camera, size, handle.place) + handle.aside;
}

void keepInside(HandleSet& set, const Camera& camera, Size size) {
    const double margin = 12 * strokeOf(size);
    const Box inside(Pixels(margin, margin), Pixels(size.width - margin, size.height - margin));
    for (Handle& handle : set.handles) {
        if (!handle.isArrow() || !inside.contains(toPixels(camera, size, handle.base)) ||
            inside.contains(toPixels(camera, size, handle.place)))
            continue;
        // Perspective: the head's way over the picture is straight, but not even.
        double least = 0, most = 1;
        for (int i = 0; i < 24; ++i) {
            const double part = (least + most) / 2;
            const Vector place = handle.base + part * (handle.place - handle.base);
            (inside.contains(toPixels(camera, size, place)) ? least : most) = part;
        }
        handle.place = handle.base + least * (handle.place - handle.base);
        handle.perUnit *= least;
        handle.cut = true;
    }
}

void spread(HandleSet& set, const Camera& camera, Size size) {
    const double stroke = strokeOf(size);
    std::vector<std::size_t> movable;
    std::vector<Pixels> places;
    std::vector<double> radii;
    for (std::size_t i = 0; i < set.handles.size(); ++i) {
        if (!set.handles[i].movable)
            continue;
        movable.push_back(i);
        places.push_back(toPixels(camera, size, set.handles[i].place));
        radii.push_back(stroke * radiusOf(set.handles[i].kind));
    }
    constexpr std::size_t most = 6;
    for (std::vector<std::size_t>& group : crowds(places, radii)) {
        std::ranges::stable_sort(group, std::greater(), [&](std::size_t i) { return radii[i]; });
        const std::size_t around = std::min(group.size() - 1, most);
        const double away = radii[group[0]] + radii[group[1]] + 4 * stroke;
        // Wide enough for all of them side by side.
        const double ring =
            std::max(away, (radii[group[1]] + 1.5 * stroke) /
                               std::sin(M_PI / std::max<double>(static_cast<double>(around), 2)));
        for (std::size_t k = 0; k < around; ++k) {
            const double angle =
                -M_PI / 4 + 2 * M_PI * static_cast<double>(k) / static_cast<double>(around);
            const std::size_t index = group[k + 1];
            set.handles[movable[index]].aside =
                places[group[0]] - places[index] + ring * Pixels(std::cos(angle), std::sin(angle));
        }
        std::size_t folded = 0;
        for (std::size_t k = around + 1; k < group.size(); ++k) {
            Handle& handle = set.handles[movable[group[k]]];
            handle.folded = handle.kind != HandleKind::trajectoryPoint &&
                            (places[group[k]] - places[group[0]]).norm() < ring;
            folded += handle.folded ? 1 : 0;
        }
        Handle& largest = set.handles[movable[group[0]]];
        if (folded > 0 && largest.label.empty())
            largest.label = "+" + std::to_string(folded);
    }
}

std::vector<Box> placedLabels(std::span<const LabelWish> wishes, const Box& picture, double gap) {
    std::vector<Box> placed;
    for (const LabelWish& wish : wishes) {
        const Pixels half = wish.size / 2;
        Box best;
        double least = std::numeric_limits<double>::infinity();
        // Upper right first, then clockwise but for straight up and down last.
        constexpr std::array<std::array<double, 2>, 8> sides{
            {{1, -1}, {1, 0}, {1, 1}, {-1, -1}, {-1, 0}, {-1, 1}, {0, -1}, {0, 1}}};
        for (std::size_t i = 0; i < sides.size(); ++i) {
            const Pixels side(sides[i][0], sides[i][1]);
            const Pixels middle = wish.point + side.cwiseProduct(half + Pixels(gap, gap));
            const Box box(Pixels(middle - half), Pixels(middle + half));
            double cost = 1e-3 * static_cast<double>(i) * wish.size.prod();
            for (const Box& other : placed)
                cost += 3 * overlap(box, other);
            for (const LabelWish& other : wishes)
                cost += overlap(
                    box, Box(Pixels(other.point.array() - gap), Pixels(other.point.array() + gap)));
            cost += 2 * (wish.size.prod() - overlap(box, picture));
            if (cost < least) {
                least = cost;
                best = box;
            }
        }
        placed.push_back(best);
    }
    return placed;
}

} // namespace render
