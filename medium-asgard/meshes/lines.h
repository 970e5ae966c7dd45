// Words of a text file with their lines, for readers that say where something is wrong.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace meshes {

class Words {
public:
    explicit Words(std::string_view text) : text_(text) {}

    // The next word of the text, or of the line; "" at the end of it.
    std::string_view next();
    std::string_view nextInLine();
    // To the next line that is not empty; false: there is none. A `\` at the end of a line goes on
    // in the next one.
    bool nextLine();
    void skipLine();
    [[nodiscard]] std::size_t line() const { return line_; } // of the last word

private:
    bool skipBlanks(bool alsoLines);

    std::string_view text_;
    std::size_t at_ = 0, line_ = 1;
};

// Decimal and finite, with an optional sign; nothing else.
[[nodiscard]] std::optional<double> numberOf(std::string_view word);
// A word as a sentence shows it: short, and without what no one can read.
[[nodiscard]] std::string shown(std::string_view word);
[[nodiscard]] bool isWord(std::string_view word, std::string_view lowerCase);

} // namespace meshes
