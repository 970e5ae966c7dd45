#include "strips/groups.h"

#include <algorithm>

namespace layout {

void Groups::seek(const GroupStart& start) {
    flow_.seek(start.at);
    tooTall_ = start.tooTall;
    group_ = {};
    ahead_.reset();
    from_.reset();
}

std::size_t Groups::reached() const {
    const Flow::Place place = flow_.place();
    return place.block + (place.strip > 0 ? 1 : 0);
}

void Groups::append(Strip strip) {
    std::vector<Strip>& strips = group_.strips;
    if (strips.empty())
        group_.mayFloat = strip.mayFloat && !tooTall_;
    else
        group_.height += std::max(strips.back().after, strip.before);
    group_.height += strip.cells ? 2 * pageHeight_ : strip.height;
    strips.push_back(std::move(strip));
}

// Its beginning is kept until all of it is read: all that the flow passes before counts for it.
Made Groups::readStrip(Strip& strip) {
    if (ahead_) {
        strip = std::move(*std::exchange(ahead_, {}));
        from_ = aheadAt_;
        return Made::strip;
    }
    if (!from_)
        from_ = flow_.place();
    return flow_.next(strip);
}

Made Groups::read(Group& group) {
    for (;;) {
        const bool tooTall = tooTall_;
        Strip strip;
        const Made made = readStrip(strip);
        if (made == Made::pause || (made == Made::end && group_.strips.empty()))
            return made;
        if (made == Made::end) {
            group = std::exchange(group_, {});
            return Made::strip;
        }
        const Flow::Place at = *std::exchange(from_, {});
        if (strip.breakBefore) {
            tooTall_ = false;
            if (!group_.strips.empty()) {
                ahead_ = std::move(strip);
                aheadAt_ = at;
                group = std::exchange(group_, {});
                return Made::strip;
            }
        }
        if (group_.strips.empty())
            group_.start = {at, tooTall};
        const bool keeps = strip.keepWithNext;
        const bool linesGoOn = strip.keepWithNextLine;
        const bool endsBlock = strip.lastOfBlock;
        append(std::move(strip));
        // A figure that floats takes all of its caption along: the text behind it may come before.
        const bool goesOn = keeps || (group_.mayFloat && !endsBlock);
        tooTall_ = goesOn && (tooTall_ || group_.height > pageHeight_);
        if (group_.height > pageHeight_)
            group_.mayFloat = false;
        if (!goesOn || (tooTall_ && !linesGoOn)) {
            group = std::exchange(group_, {});
            return Made::strip;
        }
    }
}

} // namespace layout
