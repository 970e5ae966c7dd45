#include "text/printable.h"

#include "text/characters.h"

#include <gtest/gtest.h>

#include <random>

namespace text {
namespace {

using namespace std::string_literals;

TEST(Printable, ControlCharactersBecomeVisibleSigns) {
    EXPECT_EQ(printable("\033]0;owned\007"), "␛]0;owned␇");
    EXPECT_EQ(printable("a\0b\x7f"s), "a␀b␡");
    EXPECT_EQ(printable("\u0085\u009b31m"), "\uFFFD\uFFFD31m");
    EXPECT_EQ(printable("\x9b"
                        "31m"),
              "\uFFFD31m"); // the same in one byte
}

TEST(Printable, LineEndsAndTabsStay) {
    EXPECT_EQ(printable("a\n\tb\r\nc"), "a\n\tb\nc");
    EXPECT_EQ(printable("good\rbad"), "good␍bad"); // it would write over the line
}

TEST(Printable, WhatIsNoUtf8IsOneSignForEachByte) {
    EXPECT_EQ(printable("\xff\xc0\x80"), "\uFFFD\uFFFD\uFFFD");
    EXPECT_EQ(printable("\xe2\x82"), "\uFFFD\uFFFD"); // cut off
    EXPECT_EQ(printable("Größe €𝄞"), "Größe €𝄞");
}

TEST(Printable, DirectionsAreShownWhereTheLineIsOurs) {
    EXPECT_EQ(printable("\u202Eexe.ens\u2066x\u200F"), "\uFFFDexe.ens\uFFFDx\uFFFD");
    EXPECT_EQ(printable("\u202Bשלום\u202C\033", Direction::kept), "\u202Bשלום\u202C␛");
}

TEST(Printable, ANameIsOneLine) { EXPECT_EQ(oneLine("a\nb\t.ens"), "a␊b␉.ens"); }

TEST(Printable, ALineEndInAMessageForgesNone) {
    EXPECT_EQ(message("f:1:1: error: a\nf:2:1: error: forged"),
              "f:1:1: error: a\n    f:2:1: error: forged\n");
    EXPECT_EQ(message("m\n    line\n    ^~\n"), "m\n    line\n    ^~\n"); // an excerpt stays
    EXPECT_EQ(message("m\n\n  x"), "m\n\n      x\n");
    EXPECT_EQ(message(""), "");
}

TEST(Printable, RandomBytesLeaveNothingThatATerminalObeys) {
    std::mt19937 random(7);
    for (int round = 0; round < 2000; ++round) {
        std::string bytes(random() % 40, '\0');
        for (char& byte : bytes)
            byte = static_cast<char>(random() % 4 == 0 ? random() % 0xa0 : random());
        for (const std::string& text : {printable(bytes), oneLine(bytes), message(bytes)})
            for (std::size_t at = 0; at < text.size();) {
                const std::size_t length = characterLength(std::string_view(text).substr(at));
                ASSERT_GT(length, 0U);
                const char32_t code = codePoint(std::string_view(text).substr(at, length));
                ASSERT_TRUE(code == '\n' || code == '\t' || (code >= 0x20 && code < 0x7f) ||
                            code >= 0xa0)
                    << std::hex << static_cast<unsigned>(code);
                at += length;
            }
    }
}

} // namespace
} // namespace text
