#include "source/line_marks.h"

#include "source/shown_bytes.h"

#include <algorithm>

namespace source {

std::size_t lineAfter(std::string_view bytes, std::size_t start) {
    const std::size_t end = bytes.find_first_of("\r\n", start);
    if (end == std::string_view::npos)
        return bytes.size();
    return end + (bytes.substr(end).starts_with("\r\n") ? 2 : 1);
}

std::vector<LineMarks> lineMarksOf(std::string_view bytes, std::size_t start, int lines,
                                   const std::vector<Mark>& marks) {
    std::vector<LineMarks> result;
    auto mark = marks.begin();
    for (int i = 0; i < lines; ++i) {
        const std::size_t end = lineAfter(bytes, start);
        LineMarks& line = result.emplace_back();
        std::size_t at = start; // and so many letters before it
        int letters = 0;
        const auto lettersTo = [&](std::size_t to) {
            letters += lettersIn(bytes.substr(at, to - at));
            at = to;
            return letters;
        };
        while (mark != marks.end() && mark->range.to <= start)
            ++mark;
        for (auto one = mark; one != marks.end() && one->range.from < end; ++one) {
            const int from = lettersTo(std::max(one->range.from, at));
            const int to = lettersTo(std::clamp(one->range.to, at, end));
            if (to > from)
                line.push_back({from, to - from, one->kind});
        }
        start = end;
    }
    return result;
}

} // namespace source
