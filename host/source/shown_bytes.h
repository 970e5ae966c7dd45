// The letters that show the bytes of a text, and the bytes behind the letters.
//
// A line end (LF, CR LF, CR) is one letter, LF, and a tab is a tab. Bytes without a picture
// (control characters, marks of direction, bytes that are no UTF-8) are shown as one sign each.
// Letters are counted as Qt counts them: units of UTF-16. A text begins and ends between two
// letters.
#pragma once

#include <QString>

#include <string>
#include <string_view>

namespace source {

[[nodiscard]] QString shown(std::string_view bytes);
// How many letters that are.
[[nodiscard]] int lettersIn(std::string_view bytes);
// The bytes that the first letters show; all of them, where there are fewer letters.
[[nodiscard]] std::size_t bytesOf(std::string_view bytes, int letters);

// Typed letters as bytes. `lineEnd`: that of the text that they come into.
[[nodiscard]] std::string spelled(const QString& letters, std::string_view lineEnd);
// The first one of a text; LF, where there is none.
[[nodiscard]] std::string_view lineEndOf(std::string_view bytes);

// How many letters this thread has made or counted, for tests.
[[nodiscard]] std::size_t& lettersRead();

} // namespace source
