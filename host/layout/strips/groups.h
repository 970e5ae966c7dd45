// Strips of the text that must stand on one page, if they fit, read one group after the other.
#pragma once

#include "strips/flow.h"

namespace layout {

// Between two groups: what is read from here on is the same each time.
struct GroupStart {
    Flow::Place at;
    // Goes on with a group that was taller than a page: strips are for themselves, but for the
    // first two lines and the last two of a paragraph.
    bool tooTall = false;
    bool operator==(const GroupStart&) const = default;
};

struct Group {
    GroupStart start;
    std::vector<Strip> strips{};
    double height = 0; // without what stands above it, without notes
    bool mayFloat = false;
};

class Groups {
public:
    Groups(const Surroundings& in, const model::Blocks& blocks)
        : pageHeight_(in.pageHeight), flow_(in, blocks) {}

    // No more is read of a group than a page takes: what is taller cannot be kept together.
    // Made::pause: read again to go on.
    [[nodiscard]] Made read(Group& group);
    [[nodiscard]] GroupStart next() const { return {ahead_ ? aheadAt_ : flow_.place(), tooTall_}; }
    void seek(const GroupStart& start);
    // So many blocks were read, the last of them perhaps in part.
    [[nodiscard]] std::size_t reached() const;

private:
    [[nodiscard]] Made readStrip(Strip& strip);
    void append(Strip strip);

    double pageHeight_ = 0;
    Flow flow_;
    Group group_;                // that is being read
    std::optional<Strip> ahead_; // read, and of the next group
    Flow::Place aheadAt_;
    std::optional<Flow::Place> from_; // of the strip that is being read
    bool tooTall_ = false;
};

} // namespace layout
