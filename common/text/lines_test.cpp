#include "text/lines.h"

#include <gtest/gtest.h>

#include <random>

namespace text {

// The lines of a text that followed edits are those that Places reads in it.
TEST(Lines, AreThoseOfPlacesAfterEveryEdit) {
    std::mt19937_64 random(70);
    const auto below = [&](std::size_t bound) {
        return static_cast<std::size_t>(random() % bound);
    };
    const auto someText = [&](std::size_t most) {
        static constexpr std::string_view pieces[] = {
            "\n", "\r", "\r\n", "a", "b", "\u00e4", "\u20ac", "\xff", "\xef\xbb\xbf"};
        std::string text;
        for (std::size_t count = below(most + 1); count > 0; --count)
            text += pieces[below(std::size(pieces))];
        return text;
    };
    for (int round = 0; round < 200; ++round) {
        std::string text = someText(60);
        Lines lines(text);
        for (int step = 0; step < 30; ++step) {
            Edits edits;
            for (std::size_t from = below(8); from <= text.size() && edits.size() < 6;) {
                const std::size_t to = std::min(from + below(4), text.size());
                edits.push_back({{from, to}, someText(4)});
                from = to + (to == edits.back().range.from ? 1 : 0) + below(12);
            }
            ASSERT_TRUE(areOrdered(edits, text.size()));
            text = applied(text, edits);
            lines.follow(edits, text);
            const Places places(text);
            std::vector<std::size_t> some;
            std::vector<Position> expected;
            for (std::size_t at = 0; at <= text.size() + 1; at += below(3)) {
                ASSERT_EQ(lines.at(at, text), places.at(at)) << at;
                some.push_back(at);
                expected.push_back(places.at(at));
            }
            ASSERT_EQ(lines.at(some, text), expected);
        }
    }
}

} // namespace text
