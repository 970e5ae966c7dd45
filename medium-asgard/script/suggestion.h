// "did you mean ...", when something that exists is close to what was written.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace script {

// The nearest of what exists, or "" when none is near: at most a third of the letters differ
// (inserted, left out, replaced, or two neighbours exchanged); else what shares three quarters of
// its beginning.
[[nodiscard]] std::string nearest(std::string_view written, std::span<const std::string> existing);

// `did you mean "sphere"? (shape sets here: rod, sphere)`; without a near one only what there is;
// "" when there is nothing. `kind`: "shape sets here". A longer list ends with "...".
[[nodiscard]] std::string suggestionFor(std::string_view written,
                                        std::span<const std::string> existing,
                                        std::string_view kind, std::size_t mostListed = 12);

} // namespace script
