// The patterns that say where words of a language may be divided: Liang's method, as TeX has it.
//
// A pattern is some letters with numbers between them; a word has the largest number of all
// patterns that it contains at each place, and may be divided where that is odd. The files are
// those of LibreOffice (packages hyphen-*): the first line names their signs, then one pattern a
// line. LIMIT: patterns that change letters where a word is divided are left out.
#pragma once

#include <QString>

#include <string>
#include <unordered_map>
#include <vector>

namespace typography {

class Patterns {
public:
    // A file that cannot be read has none.
    explicit Patterns(const QString& file);

    // The letters of a word, in small letters, before which it may be divided.
    [[nodiscard]] std::vector<int> placesIn(const QString& word) const;
    [[nodiscard]] std::size_t count() const { return numbers_.size(); }

private:
    struct Hash {
        using is_transparent = void;
        std::size_t operator()(std::u16string_view text) const {
            return std::hash<std::u16string_view>()(text);
        }
    };
    void add(const QString& line);

    // By its letters: the numbers before each and behind the last.
    std::unordered_map<std::u16string, std::string, Hash, std::equal_to<>> numbers_;
    std::size_t longest_ = 0; // letters of a pattern
    int leastBefore_ = 2, leastBehind_ = 2;
};

} // namespace typography
