#include "expression/nearest_name.h"

#include <algorithm>
#include <cctype>
#include <utility>
#include <vector>

namespace expression {
namespace {

char lowered(char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); }

// Cost of writing b for a, in half letters.
int letterCost(char a, char b) { return a == b ? 0 : lowered(a) == lowered(b) ? 1 : 2; }

// Damerau-Levenshtein distance (neighbours swapped once), in half letters; rows of the usual table.
int distance(std::string_view a, std::string_view b) {
    std::vector<int> before, above(b.size() + 1), row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j)
        above[j] = static_cast<int>(2 * j);
    for (std::size_t i = 1; i <= a.size(); ++i) {
        row[0] = static_cast<int>(2 * i);
        for (std::size_t j = 1; j <= b.size(); ++j) {
            row[j] = std::min(
                {above[j] + 2, row[j - 1] + 2, above[j - 1] + letterCost(a[i - 1], b[j - 1])});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                row[j] = std::min(row[j], before[j - 2] + 2);
        }
        before = std::exchange(above, row);
    }
    return above[b.size()];
}

} // namespace

std::string nearestName(std::string_view word, std::span<const std::string> candidates) {
    constexpr std::size_t longestName = 64;
    if (word.empty() || word.size() > longestName)
        return "";
    const std::string* best = nullptr;
    int least = static_cast<int>(2 * std::max<std::size_t>(1, word.size() / 3)) + 1;
    for (const std::string& candidate : candidates) {
        if (candidate.size() > longestName)
            continue;
        const int d = distance(word, candidate);
        if (d < least) {
            least = d;
            best = &candidate;
        }
    }
    return best ? *best : "";
}

} // namespace expression
