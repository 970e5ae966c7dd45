#include "layout/frames.h"

#include "paragraphs/measure.h"
#include "paragraphs/typeface.h"

#include <algorithm>
#include <map>

namespace layout {

using paragraphs::fromPoints;

// Boxes come from outside to inside, in order of their first blocks, and lie in each other or
// beside each other.
Frames::Frames(const model::Model& model)
    : boxes_(model.boxes), nested_(boxes_.size()), innermost_(model.blocks.size(), none),
      above_(model.blocks.size(), 0), edges_(model.blocks.size(), 0) {
    std::vector<std::size_t> open;
    std::size_t block = 0;
    const auto goTo = [&](std::size_t to) {
        for (; block < std::min(to, innermost_.size()); ++block) {
            while (!open.empty() && boxes_[open.back()].last < block)
                open.pop_back();
            if (!open.empty())
                innermost_[block] = open[std::min<std::size_t>(open.size(), deepest) - 1];
        }
        while (!open.empty() && boxes_[open.back()].last < to)
            open.pop_back();
    };
    for (std::size_t b = 0; b < boxes_.size(); ++b) {
        goTo(boxes_[b].first);
        if (!open.empty())
            nested_[b].outer = open.back();
        open.push_back(b);
    }
    goTo(innermost_.size());
    for (std::size_t b = boxes_.size(); b-- > 0;) {
        const model::Box& box = boxes_[b];
        const double padding = fromPoints(box.padding);
        nested_[b].before += padding;
        nested_[b].after += padding;
        if (box.first < above_.size()) {
            above_[box.first] += padding;
            edges_[box.first] += 1;
        }
        if (box.last < edges_.size())
            edges_[box.last] += std::uint64_t{1} << 32;
        const std::size_t outer = nested_[b].outer;
        if (outer != none && boxes_[outer].first == box.first)
            nested_[outer].before += nested_[b].before;
        if (outer != none && boxes_[outer].last == box.last)
            nested_[outer].after += nested_[b].after;
    }
}

// Boxes lie in each other: with the same ones around both blocks, and as many that begin and end
// there, it is the same ones that do.
bool Frames::Comparison::same(std::size_t blockOfA, std::size_t blockOfB) {
    return a_.edges_[blockOfA] == b_.edges_[blockOfB] &&
           a_.above_[blockOfA] == b_.above_[blockOfB] &&
           sameBox(a_.innermost_[blockOfA], b_.innermost_[blockOfB]);
}

// Of at most `deepest` that lie in each other.
bool Frames::Comparison::sameBox(std::size_t ofA, std::size_t ofB) {
    if (ofA == none || ofB == none)
        return ofA == ofB;
    if (matched_[ofB] != none)
        return matched_[ofB] == ofA;
    const model::Box &a = a_.boxes_[ofA], &b = b_.boxes_[ofB];
    const Nested &inA = a_.nested_[ofA], &inB = b_.nested_[ofB];
    const bool looksSame = a.indentLeft == b.indentLeft && a.indentRight == b.indentRight &&
                           a.padding == b.padding && a.background == b.background &&
                           a.border == b.border && inA.before == inB.before &&
                           inA.after == inB.after;
    if (!looksSame || !sameBox(inA.outer, inB.outer))
        return false;
    matched_[ofB] = ofA;
    return true;
}

std::vector<FramePiece> Frames::on(const std::vector<Placed>& page, double left, double width,
                                   std::size_t& boxesVisited) const {
    struct Extent {
        double from = 1e300, to = -1e300;
        bool first = false, last = false;
    };
    std::map<std::size_t, Extent> extents;
    const auto cover = [&](std::size_t box, const Extent& part, bool first, bool last) {
        Extent& whole = extents[box];
        whole.from = std::min(whole.from, part.from);
        whole.to = std::max(whole.to, part.to);
        whole.first |= first;
        whole.last |= last;
        ++boxesVisited;
    };
    for (const Placed& placed : page) {
        const std::size_t box = innermost_[placed.block];
        if (box != none)
            cover(box, {placed.top, placed.bottom},
                  placed.firstOfBlock && placed.block == boxes_[box].first,
                  placed.lastOfBlock && placed.block == boxes_[box].last);
    }
    // A box has a lower number than those in it.
    for (auto at = extents.end(); at != extents.begin();) {
        --at;
        const std::size_t outer = nested_[at->first].outer;
        if (outer != none)
            cover(outer, at->second,
                  at->second.first && boxes_[outer].first == boxes_[at->first].first,
                  at->second.last && boxes_[outer].last == boxes_[at->first].last);
    }
    std::vector<FramePiece> frames;
    for (const auto& [index, extent] : extents) {
        const model::Box& box = boxes_[index];
        FramePiece frame;
        frame.background = box.background;
        frame.border = box.border;
        frame.border.top &= extent.first; // a box that goes on is open where the page ends
        frame.border.bottom &= extent.last;
        frame.rect = QRectF(
            QPointF(left + fromPoints(box.indentLeft), extent.from - nested_[index].before),
            QPointF(left + width - fromPoints(box.indentRight), extent.to + nested_[index].after));
        frames.push_back(frame);
    }
    return frames;
}

} // namespace layout
