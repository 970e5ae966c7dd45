#include "meetings/neighbourhood.h"

#include <iterator>

namespace simulation {
namespace {

constexpr double roomAround = 0.5; // of the radius, about boxes of short windows
constexpr double mostRoom = 4;     // a box in the tree is at most so much larger than needed

} // namespace

void grow(geometry::Box& box, double by) {
    box.min() -= geometry::Vector::Constant(by);
    box.max() += geometry::Vector::Constant(by);
}

bool Neighbourhood::enterTree(std::size_t body, const geometry::Box& box, bool isFlight) {
    const double room = roomAround * records_[body].radius;
    const bool isShort = box.diagonal().norm() < 4 * records_[body].radius;
    if (tree.contains(body) && tree.box(body).contains(box) &&
        tree.box(body).diagonal().norm() < box.diagonal().norm() + mostRoom * room)
        return false;
    geometry::Box leaf = box;
    if (isShort && !isFlight)
        grow(leaf, room);
    tree.put(body, leaf);
    return true;
}

geometry::Box Neighbourhood::leafOfBlock(std::size_t body) const {
    geometry::Box leaf = cells.block(body);
    grow(leaf, (1 + slack_) * records_[body].radius +
                   boxRounding * (leaf.min().cwiseAbs() + leaf.max().cwiseAbs()).maxCoeff());
    return leaf;
}

void Neighbourhood::takeFound(std::size_t body) {
    std::erase_if(found_, [&](std::size_t other) {
        const bool bothStand = ended_[body] && (ended_[other] || records_[other].isFixed);
        return bothStand || !mayMeet(body, other);
    });
    std::ranges::sort(found_);
    partners_[body] = found_;
    for (const std::size_t other : found_)
        if (!records_[other].isFixed)
            partners_[other].insert(std::ranges::lower_bound(partners_[other], body), body);
}

void Neighbourhood::leave(std::size_t body) {
    ended_[body] = true;
    if (tree.contains(body))
        tree.remove(body);
    if (cells.contains(body))
        cells.remove(body);
    for (const std::size_t other : partners_[body])
        std::erase(partners_[other], body);
    partners_[body].clear();
}

std::vector<std::size_t> Neighbourhood::all(std::size_t body) const {
    std::vector<std::size_t> partners;
    std::ranges::copy_if(partners_[body], std::back_inserter(partners),
                         [this](std::size_t other) { return !ended_[other]; });
    if (cells.contains(body))
        cells.forEachNear(body, [&](std::size_t other) {
            if (mayMeet(body, other))
                partners.push_back(other);
        });
    std::ranges::sort(partners);
    return partners;
}

} // namespace simulation
