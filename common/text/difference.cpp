#include "text/difference.h"

#include "text/characters.h"

#include <algorithm>
#include <cctype>

namespace text {

namespace {

std::size_t commonHead(std::string_view a, std::string_view b) {
    return static_cast<std::size_t>(std::mismatch(a.begin(), a.end(), b.begin(), b.end()).first -
                                    a.begin());
}

std::size_t commonTail(std::string_view a, std::string_view b) {
    return static_cast<std::size_t>(
        std::mismatch(a.rbegin(), a.rend(), b.rbegin(), b.rend()).first - a.rbegin());
}

} // namespace

Edit difference(std::string_view before, std::string_view after) {
    std::size_t head = commonHead(before, after);
    head = std::min(characterStart(before, head), characterStart(after, head));
    std::size_t tail = commonTail(before.substr(head), after.substr(head));
    while (tail > 0 && isContinuation(before[before.size() - tail]))
        --tail;
    return {{head, before.size() - tail},
            std::string(after.substr(head, after.size() - tail - head))};
}

namespace {

bool isWord(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '.' ||
           (static_cast<unsigned char>(c) & 0x80) != 0;
}

using Pieces = std::vector<std::string_view>;

// Each is a word, one or more blanks of one line, or a sign.
Pieces wordsOf(std::string_view text) {
    Pieces pieces;
    for (std::size_t i = 0; i < text.size();) {
        std::size_t end = i + 1;
        if (isWord(text[i]))
            while (end < text.size() && isWord(text[end]))
                ++end;
        else if (text[i] == ' ')
            while (end < text.size() && text[end] == ' ')
                ++end;
        pieces.push_back(text.substr(i, end - i));
        i = end;
    }
    return pieces;
}

// No piece goes on beyond this place.
bool endsPiece(std::string_view text, std::size_t place) {
    if (place == 0 || place == text.size())
        return true;
    const char before = text[place - 1], after = text[place];
    return !(isWord(before) && isWord(after)) && !(before == ' ' && after == ' ');
}

Pieces linesOf(std::string_view text) {
    Pieces lines;
    for (std::size_t i = 0; i < text.size();) {
        const std::size_t end = std::min(text.find('\n', i), text.size() - 1) + 1;
        lines.push_back(text.substr(i, end - i));
        i = end;
    }
    return lines;
}

// Myers' greedy search: `reach[k]` is how far into `a` a path of d differences gets on the diagonal
// a - b = k. The rows are kept to walk back.
class Search {
public:
    Search(const Pieces& a, const Pieces& b)
        : a_(a), b_(b), most_(static_cast<long>(std::min(mostDifferences, a.size() + b.size()))) {}

    // Pairs of equal pieces, as ranges of pieces that differ; false: too many differences.
    bool run(std::vector<std::pair<Range, Range>>& out) {
        const long n = static_cast<long>(a_.size()), m = static_cast<long>(b_.size());
        const long offset = most_ + 1; // of k = 0
        std::vector<long> reach(static_cast<std::size_t>(2 * offset + 1), 0);
        for (long d = 0; d <= most_; ++d) {
            rows_.push_back({reach.begin() + offset - d - 1, reach.begin() + offset + d + 2});
            for (long k = -d; k <= d; k += 2) {
                long x = goesDown(reach.data() + offset, k, d)
                             ? reach[static_cast<std::size_t>(offset + k + 1)]
                             : reach[static_cast<std::size_t>(offset + k - 1)] + 1;
                while (x < n && x - k < m && at(a_, x) == at(b_, x - k))
                    ++x;
                reach[static_cast<std::size_t>(offset + k)] = x;
                if (x >= n && x - k >= m) {
                    walkBack(d, out);
                    return true;
                }
            }
        }
        return false;
    }

private:
    static std::string_view at(const Pieces& pieces, long i) {
        return pieces[static_cast<std::size_t>(i)];
    }
    static bool goesDown(const long* middle, long k, long d) {
        return k == -d || (k != d && middle[k - 1] < middle[k + 1]);
    }

    void walkBack(long d, std::vector<std::pair<Range, Range>>& out) {
        long x = static_cast<long>(a_.size()), y = static_cast<long>(b_.size());
        for (; d > 0; --d) {
            const std::vector<long>& row = rows_[static_cast<std::size_t>(d)];
            const long* middle = row.data() + d + 1;
            const long k = x - y;
            const bool down = goesDown(middle, k, d);
            const long fromK = down ? k + 1 : k - 1;
            const long fromX = middle[fromK], fromY = fromX - fromK;
            add(out, fromX, down ? fromX : fromX + 1, fromY, down ? fromY + 1 : fromY);
            x = fromX;
            y = fromY;
        }
        std::ranges::reverse(out);
    }

    // In front of what was found so far, joined with it where they touch.
    static void add(std::vector<std::pair<Range, Range>>& out, long fromA, long toA, long fromB,
                    long toB) {
        const auto u = [](long i) { return static_cast<std::size_t>(i); };
        if (!out.empty() && out.back().first.from == u(toA) && out.back().second.from == u(toB)) {
            out.back().first.from = u(fromA);
            out.back().second.from = u(fromB);
            return;
        }
        out.push_back({{u(fromA), u(toA)}, {u(fromB), u(toB)}});
    }

    const Pieces &a_, &b_;
    long most_; // differences
    std::vector<std::vector<long>> rows_;
};

std::vector<std::size_t> startsOf(const Pieces& pieces, std::size_t at) {
    std::vector<std::size_t> starts;
    for (const std::string_view piece : pieces) {
        starts.push_back(at);
        at += piece.size();
    }
    starts.push_back(at);
    return starts;
}

// `at`: where the pieces begin. Nothing: they differ in too many pieces.
std::optional<std::vector<Hunk>> hunksOf(Pieces a, Pieces b, std::size_t at = 0) {
    std::size_t head = 0, tail = 0, skipped = at;
    while (head < std::min(a.size(), b.size()) && a[head] == b[head])
        skipped += a[head++].size();
    while (tail < std::min(a.size(), b.size()) - head &&
           a[a.size() - 1 - tail] == b[b.size() - 1 - tail])
        ++tail;
    const auto middle = [&](Pieces& pieces) {
        pieces = {pieces.begin() + static_cast<std::ptrdiff_t>(head),
                  pieces.end() - static_cast<std::ptrdiff_t>(tail)};
    };
    middle(a);
    middle(b);
    std::vector<std::pair<Range, Range>> found;
    if (a.empty() != b.empty())
        found = {{{0, a.size()}, {0, b.size()}}};
    else if (!a.empty() && !Search(a, b).run(found))
        return std::nullopt;
    const auto startsA = startsOf(a, skipped), startsB = startsOf(b, skipped);
    std::vector<Hunk> hunks;
    hunks.reserve(found.size());
    for (const auto& [inA, inB] : found)
        hunks.push_back(
            {{startsA[inA.from], startsA[inA.to]}, {startsB[inB.from], startsB[inB.to]}});
    return hunks;
}

std::string_view in(std::string_view text, Range range) {
    return text.substr(range.from, range.size());
}

// A change of a word in a long text makes pieces of that word alone.
std::optional<std::vector<Hunk>> hunksOfWords(std::string_view a, std::string_view b) {
    const auto endsInBoth = [&](std::size_t inA, std::size_t inB) {
        return endsPiece(a, inA) && endsPiece(b, inB);
    };
    std::size_t head = commonHead(a, b);
    while (!endsInBoth(head, head))
        --head;
    std::size_t tail = commonTail(a.substr(head), b.substr(head));
    while (!endsInBoth(a.size() - tail, b.size() - tail))
        --tail;
    const auto middle = [&](std::string_view text) {
        return text.substr(head, text.size() - tail - head);
    };
    return hunksOf(wordsOf(middle(a)), wordsOf(middle(b)), head);
}

thread_local std::size_t sought = 0;

} // namespace

std::size_t differencesSought() { return sought; }

std::vector<Hunk> differences(std::string_view before, std::string_view after) {
    ++sought;
    if (auto hunks = hunksOfWords(before, after))
        return *hunks;
    const auto lines = hunksOf(linesOf(before), linesOf(after));
    if (!lines)
        return {{{0, before.size()}, {0, after.size()}}};
    std::vector<Hunk> hunks;
    for (const Hunk& line : *lines) {
        auto words = hunksOfWords(in(before, line.before), in(after, line.after));
        if (!words) {
            hunks.push_back(line);
            continue;
        }
        for (Hunk& hunk : *words) {
            for (std::size_t* place : {&hunk.before.from, &hunk.before.to})
                *place += line.before.from;
            for (std::size_t* place : {&hunk.after.from, &hunk.after.to})
                *place += line.after.from;
            hunks.push_back(hunk);
        }
    }
    return hunks;
}

Edits editsBetween(std::string_view before, std::string_view after) {
    Edits edits;
    for (const Hunk& hunk : differences(before, after))
        edits.push_back({hunk.before, std::string(in(after, hunk.after))});
    return edits;
}

} // namespace text
