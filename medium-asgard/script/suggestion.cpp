#include "script/suggestion.h"

#include <algorithm>
#include <numeric>

namespace script {

namespace {

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

// Optimal string alignment: Levenshtein's distance with exchanged neighbours counted once.
std::size_t distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> before(b.size() + 1), last(b.size() + 1), now(b.size() + 1);
    std::iota(last.begin(), last.end(), std::size_t{0});
    for (std::size_t i = 1; i <= a.size(); ++i) {
        now[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const bool same = lower(a[i - 1]) == lower(b[j - 1]);
            now[j] = std::min({last[j] + 1, now[j - 1] + 1, last[j - 1] + (same ? 0 : 1)});
            if (i > 1 && j > 1 && lower(a[i - 1]) == lower(b[j - 2]) &&
                lower(a[i - 2]) == lower(b[j - 1]))
                now[j] = std::min(now[j], before[j - 2] + 1);
        }
        std::swap(before, last);
        std::swap(last, now);
    }
    return last[b.size()];
}

// What begins with most of it: "-gravity", "-gravitational".
std::string sameBeginning(std::string_view written, std::span<const std::string> existing) {
    constexpr std::size_t least = 5;
    std::string best;
    std::size_t longest = std::max(least, (3 * written.size() + 3) / 4) - 1;
    for (const std::string& name : existing) {
        std::size_t common = 0;
        while (common < std::min(name.size(), written.size()) &&
               lower(name[common]) == lower(written[common]))
            ++common;
        if (common > longest) {
            longest = common;
            best = name;
        }
    }
    return best;
}

} // namespace

std::string nearest(std::string_view written, std::span<const std::string> existing) {
    std::string best;
    if (written.empty() || written.size() > 60)
        return best;
    std::size_t least = std::max<std::size_t>(1, written.size() / 3) + 1;
    for (const std::string& name : existing) {
        if (name.size() > written.size() + least || written.size() > name.size() + least)
            continue;
        const std::size_t d = distance(written, name);
        if (d < least && d < written.size()) { // something is left of what was written
            least = d;
            best = name;
        }
    }
    return best.empty() ? sameBeginning(written, existing) : best;
}

std::string suggestionFor(std::string_view written, std::span<const std::string> existing,
                          std::string_view kind, std::size_t mostListed) {
    constexpr std::size_t mostBesideOne = 12;
    std::string text;
    if (const std::string near = nearest(written, existing); !near.empty())
        text = "did you mean \"" + near + "\"?";
    if (existing.empty())
        return text;
    if (existing.size() > mostBesideOne && !text.empty())
        return text;
    std::string list;
    for (std::size_t i = 0; i < existing.size() && i < mostListed; ++i)
        list += (i == 0 ? "" : ", ") + existing[i];
    if (existing.size() > mostListed)
        list += ", ...";
    return text + (text.empty() ? "" : " ") + "(" + std::string(kind) + ": " + list + ")";
}

} // namespace script
