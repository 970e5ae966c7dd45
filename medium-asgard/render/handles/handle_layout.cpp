#include "handles/handle_layout.h"

#include "drawing/frame.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <string>
#include <utility>

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

namespace {

// Places around a point, ring by ring; the first ring is divided evenly.
class Rings {
public:
    Rings(Pixels middle, double ring, std::size_t count, double apart)
        : middle_(std::move(middle)), ring_(ring), count_(count), apart_(apart) {}

    // The next one that is free; none: they would be further away than `furthest`.
    template <class IsFree> std::optional<Pixels> next(const IsFree& isFree, double furthest) {
        while (ring_ < furthest) {
            if (index_ == count_) {
                index_ = 0;
                ring_ += apart_;
                count_ = static_cast<std::size_t>(2 * M_PI * ring_ / apart_);
            }
            const double angle =
                -M_PI / 4 + 2 * M_PI * static_cast<double>(index_++) / static_cast<double>(count_);
            const Pixels place = middle_ + ring_ * Pixels(std::cos(angle), std::sin(angle));
            if (isFree(place))
                return place;
        }
        return std::nullopt;
    }

private:
    Pixels middle_;
    double ring_;
    std::size_t count_, index_ = 0;
    double apart_;
};

} // namespace

void spread(HandleSet& set, const Camera& camera, Size size,
            const std::optional<HandleName>& opened) {
    const double stroke = strokeOf(size);
    std::vector<Handle*> movable;
    std::vector<Pixels> places;
    std::vector<double> radii;
    for (Handle& handle : set.handles) {
        if (!handle.movable)
            continue;
        movable.push_back(&handle);
        places.push_back(toPixels(camera, size, handle.place));
        radii.push_back(stroke * radiusOf(handle.kind));
    }
    std::vector<std::vector<std::size_t>> groups = crowds(places, radii);
    for (std::vector<std::size_t>& group : groups)
        std::ranges::stable_sort(group, std::greater(), [&](std::size_t i) { return radii[i]; });
    const auto opens = [&](const auto& group) { return movable[group[0]]->name() == opened; };
    // The last keeps clear of all others.
    std::stable_partition(groups.begin(), groups.end(), std::not_fn(opens));
    constexpr std::size_t most = 6;
    const Box picture(Pixels(0, 0), Pixels(size.width, size.height));
    std::vector<Pixels> stands = places;
    for (const std::vector<std::size_t>& group : groups) {
        const Pixels& middle = places[group[0]];
        const std::size_t around = std::min(group.size() - 1, most);
        // Wide enough for all of them side by side.
        const double ring =
            std::max(radii[group[0]] + radii[group[1]] + 4 * stroke,
                     (radii[group[1]] + 1.5 * stroke) /
                         std::sin(M_PI / std::max<double>(static_cast<double>(around), 2)));
        const double apart = 2 * radii[group[1]] + 3 * stroke;
        const auto inside = [&](const Pixels& place) { return picture.contains(place); };
        const auto clear = [&](const Pixels& place) {
            for (std::size_t i = 0; i < stands.size(); ++i)
                if (!movable[i]->folded && (stands[i] - place).norm() < 0.8 * apart)
                    return false;
            return inside(place);
        };
        Rings rings(middle, ring, around, apart);
        Crowd crowd{movable[group[0]]->name(), middle, ring, opens(group)};
        std::size_t folded = 0;
        const auto move = [&](std::size_t index, const std::optional<Pixels>& stand) {
            stands[index] = stand.value_or(middle + ring * Pixels(M_SQRT1_2, -M_SQRT1_2));
            movable[index]->aside = stands[index] - places[index];
            crowd.reach = std::max(crowd.reach, (stands[index] - middle).norm());
        };
        for (std::size_t k = 1; k <= around; ++k)
            move(group[k], rings.next(inside, picture.diagonal().norm()));
        for (std::size_t k = around + 1; k < group.size(); ++k) {
            Handle& handle = *movable[group[k]];
            if (handle.kind == HandleKind::trajectoryPoint ||
                (places[group[k]] - middle).norm() >= ring)
                continue;
            handle.folded = true; // it hinders none of the places
            ++folded;
            const auto stand =
                crowd.isOpen ? rings.next(clear, picture.diagonal().norm()) : std::nullopt;
            if (!stand)
                continue;
            handle.folded = false;
            move(group[k], stand);
        }
        if (folded == 0)
            continue;
        set.crowds.push_back(crowd);
        Handle& largest = *movable[group[0]];
        if (!crowd.isOpen && largest.label.empty())
            largest.label = "+" + std::to_string(folded);
    }
}

std::vector<const Handle*> labelled(const HandleSet& set) {
    std::vector<const Handle*> all;
    for (const Handle& handle : set.handles)
        if (!handle.label.empty() && !handle.folded &&
            (handle.kind != HandleKind::spin || handle.isArrow()))
            all.push_back(&handle);
    return all;
}

namespace {

// About its point, the first place first, straight up and down last; then those farther away.
std::vector<Box> placesOf(const LabelWish& wish) {
    constexpr std::array<std::array<double, 2>, 8> sides{
        {{1, -1}, {1, 0}, {1, 1}, {-1, -1}, {-1, 0}, {-1, 1}, {0, -1}, {0, 1}}};
    const Pixels half = wish.size / 2;
    std::vector<Box> places;
    for (const double ring : {0, 1, 2})
        for (const auto& [across, down] : sides) {
            const Pixels side(across, wish.isBelow ? -down : down);
            const Pixels apart(wish.reach + wish.gap, wish.gap + (across == 0 ? wish.reach : 0));
            const Pixels middle = wish.point + side.cwiseProduct(half + apart + ring * wish.size);
            places.emplace_back(Pixels(middle - half), Pixels(middle + half));
        }
    return places;
}

} // namespace

std::vector<Box> placedLabels(std::span<const LabelWish> wishes, const Box& picture,
                              std::vector<Box> taken) {
    std::vector<Box> points, placed;
    for (const LabelWish& wish : wishes) {
        points.emplace_back(Pixels(wish.point.array() - wish.gap),
                            Pixels(wish.point.array() + wish.gap));
        if (wish.put)
            taken.push_back(*wish.put);
    }
    const auto covered = [](const Box& box, const std::vector<Box>& others) {
        double sum = 0;
        for (const Box& other : others)
            sum += overlap(box, other);
        return sum;
    };
    for (const LabelWish& wish : wishes) {
        const std::vector<Box> places = placesOf(wish);
        Box best = wish.put.value_or(places.front());
        double least = std::numeric_limits<double>::infinity();
        const bool isFree = !wish.put && picture.contains(wish.point);
        for (std::size_t i = 0; isFree && i < places.size(); ++i) {
            const double area = wish.size.prod();
            const double cost = 1e-3 * static_cast<double>(i) * area +
                                3 * covered(places[i], taken) + covered(places[i], points) +
                                2 * (area - overlap(places[i], picture));
            if (cost < least) {
                least = cost;
                best = places[i];
            }
        }
        if (!wish.put)
            taken.push_back(best);
        placed.push_back(best);
    }
    return placed;
}

} // namespace render
