// How long may a string of a message be, and how many items may a list have?
// fields.h gives every string and list one of these; a field without one does not compile. The
// reader refuses what is longer. The writer cuts what is only shown to people; the rest is for the
// sender to keep to.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace ipc {

struct Length {
    std::size_t most = 0; // bytes
    bool isShown = false; // to people, who lose nothing that matters when it is cut
};

struct Count {
    std::size_t most = 0;
    bool isShown = false;
    Length each = {}; // of a list of strings
};

inline constexpr Length longestName{1 << 10};              // what is compared, never shown
inline constexpr Length longestLabel{1 << 10, true};       // a menu's entry, a title, a name
inline constexpr Length longestSentence{4 << 10, true};    // what is wrong, how far it is
inline constexpr Length longestInput{4 << 10};             // what one key or input method types
inline constexpr Length longestState{4 << 10};             // of a rendition, in its medium's words
inline constexpr Length longestExpression{4 << 10};        // whose value is asked for
inline constexpr Length longestText{std::size_t{8} << 20}; // of a subdocument, an edit, a script
inline constexpr Length longestPicture{std::size_t{64} << 20}; // base64: a whole message

inline constexpr Count mostEntries{1000, true};     // of a menu, of a list of presentations
inline constexpr Count mostDiagnostics{1000, true}; // of one text
inline constexpr Count mostParameters{1000};
inline constexpr Count mostExpressions{1000, false, longestExpression}; // and their values
inline constexpr Count mostOffers{1000, true};                          // of values
inline constexpr Count mostFields{100}, mostWays{100, true};            // of a question
inline constexpr Count mostChangedLines{100, true}; // that its values would make
inline constexpr Count mostFieldValues{100, false, longestInput};
inline constexpr Count mostValueFaults{1000, false, longestSentence};
inline constexpr Count mostCapabilities{100, false, longestName};
inline constexpr Count mostEdits{10'000}; // of one change
inline constexpr Count mostKeys{16};      // buttons and modifiers that are down at one time
inline constexpr Count twoSlots{2};

// At most `most` bytes of it, whole characters, with an ellipsis in place of what was cut.
[[nodiscard]] std::string shortened(std::string_view text, Length length);

} // namespace ipc
