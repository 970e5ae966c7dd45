// The lines of a text that is edited: places as lines and columns, without reading the text again.
//
// Lines and columns are those of Places. An edit costs the reading of the bytes that came, and a
// move of the starts of the lines behind it; a place costs the reading of its line.
#pragma once

#include "text/edit.h"
#include "text/places.h"

#include <string_view>
#include <vector>

namespace text {

class Lines {
public:
    explicit Lines(std::string_view text = {});

    // Ordered edits made the text `after` of the text so far.
    void follow(const Edits& edits, std::string_view after);
    // `text` is the text so far. Past its end, the place of the end.
    [[nodiscard]] Position at(std::size_t offset, std::string_view text) const;
    // Of many, which ascend: a line is read once.
    [[nodiscard]] std::vector<Position> at(const std::vector<std::size_t>& offsets,
                                           std::string_view text) const;

private:
    void follow(const Edit& edit, std::size_t now, std::string_view after);

    std::vector<std::size_t> starts_; // the first one is behind a byte-order mark
};

} // namespace text
