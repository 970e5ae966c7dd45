// Words of a text file with their lines, for readers that say where something is wrong.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace meshes {

// Whether a `\` at the end of a line goes on in the next one: in OBJ files it does, in STL files it
// is the end of a name ("solid C:\models\").
enum class Continued { no, byBackslash };

class Words {
public:
    Words(std::string_view text, Continued continued) : text_(text), continued_(continued) {}

    // The next word of the text, or of the line; "" at the end of it.
    std::string_view next();
    std::string_view nextInLine();
    // To the next line that is not empty; false: there is none.
    bool nextLine();
    void skipLine();
    [[nodiscard]] std::size_t line() const { return line_; } // of the last word
    [[nodiscard]] double share() const {                     // of the text that is read, 0..1
        return text_.empty() ? 1 : static_cast<double>(at_) / static_cast<double>(text_.size());
    }

private:
    bool skipBlanks(bool alsoLines);
    [[nodiscard]] bool continuesAt(std::size_t at) const; // a `\` that ends a line goes on there

    std::string_view text_;
    Continued continued_;
    std::size_t at_ = 0, line_ = 1;
};

// Decimal and finite, with an optional sign; nothing else.
[[nodiscard]] std::optional<double> numberOf(std::string_view word);
// A word as a sentence shows it: short, and without what no one can read.
[[nodiscard]] std::string shown(std::string_view word);
[[nodiscard]] bool isWord(std::string_view word, std::string_view lowerCase);

} // namespace meshes
