#include "source/shown_bytes.h"

#include "sgml/random_document.h"
#include "source/stretches.h"

#include <gtest/gtest.h>

namespace source {
namespace {

TEST(ShownBytes, EveryLineEndIsOneLetterAndWhatHasNoPictureIsASign) {
    EXPECT_EQ(shown("a\r\nb\rc\nd\te"), "a\nb\nc\nd\te");
    EXPECT_EQ(shown(std::string("\0\x1b\x7f", 3)), u"\u2400\u241b\u2421");
    EXPECT_EQ(shown("a\xff\xe2\x80\xa9z"), u"a\ufffd\ufffdz"); // no UTF-8; a paragraph's end
    EXPECT_EQ(shown("\xf0\x9f\x8e\xac"), u"\U0001F3AC");
}

TEST(ShownBytes, LettersLeadToTheirBytes) {
    const std::string bytes = "a\r\n\xc3\xa4\xf0\x9f\x8e\xac\xffz";
    ASSERT_EQ(lettersIn(bytes), 7);
    const std::size_t places[] = {0, 1, 3, 5, 9, 9, 10, 11, 11};
    for (int letters = 0; letters < 9; ++letters)
        EXPECT_EQ(bytesOf(bytes, letters), places[letters]) << letters;
}

TEST(ShownBytes, TypedLineEndsAreThoseOfTheText) {
    EXPECT_EQ(lineEndOf("a\r\nb\n"), "\r\n");
    EXPECT_EQ(lineEndOf("a\rb"), "\r");
    EXPECT_EQ(lineEndOf("ab"), "\n");
    EXPECT_EQ(spelled(QString::fromUtf8("ä\nb\n"), "\r\n"), "\xc3\xa4\r\nb\r\n");
}

// The letters outside of the stretches are the same before and after, whatever is edited.
TEST(Stretches, LettersOutsideStay) {
    sgml::RandomDocument random(7);
    const std::string pieces[] = {"\r", "\n", "\r\n", "\xc3", "\xa4", "\xc3\xa4", "\xe2\x80", "a"};
    for (int round = 0; round < 3000; ++round) {
        std::string before;
        for (int i = 0; i < 12; ++i)
            before += pieces[random.below(std::size(pieces))];
        text::Edits edits;
        for (std::size_t at = 0; edits.size() < 3;) {
            const std::size_t from = at + random.below(4);
            const std::size_t to = from + random.below(3);
            if (to > before.size())
                break;
            edits.push_back({{from, to}, pieces[random.below(std::size(pieces))]});
            at = to;
        }
        const std::string after = text::applied(before, edits);
        QString was = shown(before), is;
        std::size_t at = 0;
        std::string restored;
        for (const Stretch& stretch : stretchesOf(after, text::inverse(before, edits))) {
            const std::string same = after.substr(at, stretch.now.from - at);
            restored += same + stretch.before;
            is += shown(same) + shown(stretch.before);
            at = stretch.now.to;
        }
        ASSERT_EQ(restored + after.substr(at), before);
        ASSERT_EQ(is + shown(after.substr(at)), was);
    }
}

} // namespace
} // namespace source
