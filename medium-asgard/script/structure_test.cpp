// Commands and words by our walk, checked against Tcl's own parser and by hand.
#include "script/instrument.h"
#include "script/structure.h"

#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tcl.h>

namespace script {
namespace {

std::string_view slice(std::string_view text, Range range) {
    return text.substr(range.from, range.to - range.from);
}

// "name/word/word" per command, "|" between words, two blanks more for each level.
std::string dump(const std::string& text) {
    const Structure structure = structureOf(text);
    std::string out;
    for (const Command& command : structure.commands) {
        for (int p = command.parent; p >= 0;
             p = structure.commands[static_cast<std::size_t>(p)].parent)
            out += "  ";
        for (std::size_t i = 0; i < command.words.size(); ++i) {
            const Word& word = command.words[i];
            out += (i == 0 ? "" : "|") + std::string(slice(text, word.range)) +
                   (word.literal ? "" : "*");
        }
        out += "\n";
    }
    for (const Fault& fault : structure.faults)
        out += "fault at " + std::to_string(fault.range.from) + ": " + fault.message + "\n";
    return out;
}

struct Case {
    const char* text;
    const char* commands;
};

class Walk : public ::testing::TestWithParam<Case> {};

TEST_P(Walk, FindsCommandsAndWords) { EXPECT_EQ(dump(GetParam().text), GetParam().commands); }

// A star marks a word whose value is computed.
INSTANTIATE_TEST_SUITE_P(
    All, Walk,
    ::testing::Values(
        Case{"", ""}, Case{"a b;c", "a|b\nc\n"}, Case{"# x\na # b", "a|#|b\n"},
        Case{"a {b c} \"d e\" $f g[h i]j", "a|{b c}|\"d e\"|$f*|g[h i]j*\n  h|i\n"},
        Case{"a \\\n b", "a|b\n"}, Case{"a {b \\\n c}", "a|{b \\\n c}*\n"},
        Case{"a ${b c} $d(e f)", "a|${b c}*|$d(e f)*\n"}, Case{"a$ $", "a$|$\n"},
        Case{"a b\\;c", "a|b\\;c*\n"}, Case{"a {*}$b {*}{c d}", "a|{*}$b*|c|d\n"},
        Case{"foreach i {1 2} {body b$i x}", "foreach|i|{1 2}|{body b$i x}\n  body|b$i*|x\n"},
        Case{"if {[a]} {b} elseif 1 {c} else {d}",
             "if|{[a]}|{b}|elseif|1|{c}|else|{d}\n  a\n  b\n  c\n  d\n"},
        Case{"if 1 then {b}", "if|1|then|{b}\n  b\n"},
        Case{"while {[a] < {[no]}} {b}", "while|{[a] < {[no]}}|{b}\n  a\n  b\n"},
        Case{"for {a} {$i < [b]} {c} {d}", "for|{a}|{$i < [b]}|{c}|{d}\n  a\n  b\n  c\n  d\n"},
        Case{"proc p {x y} {a}", "proc|p|{x y}|{a}\n  a\n"},
        Case{"switch -exact -- $x {a {b} c - d {e}}",
             "switch|-exact|--|$x*|{a {b} c - d {e}}\n  b\n  e\n"},
        Case{"switch $x a {b} c {d}", "switch|$x*|a|{b}|c|{d}\n  b\n  d\n"},
        Case{"catch {a} m; eval {b}; uplevel 1 {c}; namespace eval n {d}",
             "catch|{a}|m\n  a\neval|{b}\n  b\nuplevel|1|{c}\n  c\nnamespace|eval|n|{d}\n  d\n"},
        Case{"try {a} on error {m o} {b} trap X m {c} finally {d}",
             "try|{a}|on|error|{m o}|{b}|trap|X|m|{c}|finally|{d}\n  a\n  b\n  c\n  d\n"},
        Case{"dict for {k v} $d {a}", "dict|for|{k v}|$d*|{a}\n  a\n"},
        Case{"lmap x $l {a}; expr {[b] + 1}", "lmap|x|$l*|{a}\n  a\nexpr|{[b] + 1}\n  b\n"},
        Case{"set x [list [a] [b]]", "set|x|[list [a] [b]]*\n  list|[a]*|[b]*\n    a\n    b\n"},
        Case{"[a] b", "[a]*|b\n  a\n"}, Case{"a\r\nb c\r\n", "a\nb|c\n"},
        Case{"a {b", "a\nfault at 2: this brace is never closed\n"},
        Case{"a \"b", "a\nfault at 2: this quote is never closed\n"},
        Case{"a [b", "a\n  b\nfault at 2: this bracket is never closed\n"},
        Case{"a {b}c", "a\nfault at 5: a blank is missing after this word's closing brace\n"},
        Case{"proc p {} {a \"}\nb", "proc|p|{}|{a \"}\n  a\nb\nfault at 13: this quote is never "
                                    "closed\n"}));

TEST(Structure, FindsTheCommandAtAByte) {
    const std::string text = "foreach i {1 2} {body a}";
    const Structure structure = structureOf(text);
    EXPECT_EQ(structure.at(0)->name(text), "foreach");
    EXPECT_EQ(structure.at(18)->name(text), "body");
    EXPECT_EQ(structure.at(24), nullptr);
    EXPECT_EQ(structure.startingAt(17)->name(text), "body");
    EXPECT_EQ(structure.startingAt(18), nullptr);
}

TEST(Structure, EndsAtItsDepth) {
    const std::string nested(100'000, '[');
    const Structure structure = structureOf("a " + nested);
    ASSERT_FALSE(structure.faults.empty());
    EXPECT_THAT(structure.faults[0].message, ::testing::HasSubstr("nested"));
    EXPECT_LE(structure.commands.size(), 101u);
}

// --- against Tcl's parser -------------------------------------------------------------------

struct Reference {
    std::vector<std::string> words;
    bool failed = false;
};

Reference byTcl(const std::string& text) {
    Reference result;
    const char* at = text.data();
    const char* end = at + text.size();
    while (at < end) {
        Tcl_Parse parse;
        if (Tcl_ParseCommand(nullptr, at, static_cast<int>(end - at), 0, &parse) != TCL_OK) {
            result.failed = true;
            return result;
        }
        for (int i = 0, token = 0; i < parse.numWords; ++i) {
            const Tcl_Token& word = parse.tokenPtr[token];
            result.words.push_back(std::to_string(word.start - text.data()) + "+" +
                                   std::to_string(word.size) +
                                   (word.type == TCL_TOKEN_SIMPLE_WORD ? "L" : ""));
            token += word.numComponents + 1;
        }
        at = parse.commandStart + parse.commandSize;
        Tcl_FreeParse(&parse);
    }
    return result;
}

Reference byUs(const std::string& text) {
    Reference result;
    const Structure structure = structureOf(text);
    std::size_t failedAt = text.size() + 1;
    for (const Fault& fault : structure.faults)
        failedAt = std::min(failedAt, fault.range.from);
    result.failed = !structure.faults.empty();
    for (const Command& command : structure.commands) {
        if (command.parent >= 0 || command.range.to > failedAt)
            continue;
        for (const Word& word : command.words)
            result.words.push_back(std::to_string(word.range.from) + "+" +
                                   std::to_string(word.range.to - word.range.from) +
                                   (word.literal ? "L" : ""));
    }
    return result;
}

// Texts of pieces that mean something to Tcl, without lone dollars (a literal to us, two tokens to
// Tcl) and {*} (split by both, compared by hand above).
std::string randomText(std::mt19937& random) {
    static const std::vector<std::string> pieces = {
        "a",     "b ",    " ",       "\n",  ";",    "{",        "}",   "[",  "]",
        "\"",    "$v",    "${v}",    "$v(", ")",    "\\\n",     "\\{", "\\", "#",
        "{a b}", "[c d]", "\"e f\"", "\t",  "\r\n", "\xc3\xa9", "::x", "{}"};
    std::string text;
    const int count = 1 + static_cast<int>(random() % 14);
    for (int i = 0; i < count; ++i)
        text += pieces[random() % pieces.size()];
    return text;
}

TEST(Structure, AgreesWithTclOnRandomTexts) {
    std::mt19937 random(20260101);
    int whole = 0;
    for (int i = 0; i < 100'000; ++i) {
        const std::string text = randomText(random);
        if (text.ends_with('\\')) // a literal to us, two tokens to Tcl
            continue;
        const Reference theirs = byTcl(withPlainContinuations(text));
        const Reference ours = byUs(text);
        ASSERT_EQ(theirs.failed, ours.failed) << ::testing::PrintToString(text);
        if (theirs.failed) // Tcl refuses a command as a whole; what precedes it must agree
            continue;
        ASSERT_EQ(theirs.words, ours.words) << ::testing::PrintToString(text);
        ++whole;
    }
    EXPECT_GT(whole, 10'000);
}

// --- lists ----------------------------------------------------------------------------------

TEST(List, AgreesWithTclOnRandomTexts) {
    std::mt19937 random(7);
    int whole = 0;
    for (int i = 0; i < 50'000; ++i) {
        const std::string text = randomText(random);
        int count = 0;
        const char** elements = nullptr;
        const bool good = Tcl_SplitList(nullptr, text.c_str(), &count, &elements) == TCL_OK;
        const ElementList ours = elementsOf(text);
        ASSERT_EQ(good, ours.fault.empty()) << ::testing::PrintToString(text);
        if (!good)
            continue;
        ASSERT_EQ(static_cast<std::size_t>(count), ours.elements.size());
        for (int k = 0; k < count; ++k) {
            const Element& element = ours.elements[static_cast<std::size_t>(k)];
            ASSERT_EQ(element.value, elements[k]) << ::testing::PrintToString(text);
            if (element.literal) {
                ASSERT_EQ(slice(text, element.content), element.value);
            }
        }
        Tcl_Free(reinterpret_cast<char*>(elements));
        ++whole;
    }
    EXPECT_GT(whole, 10'000);
}

// --- marks ----------------------------------------------------------------------------------

TEST(Instrument, MarksTclsCommandsBeforeAndOthersAround) {
    const std::string text = "set x 1\nforeach i {1} {body b$i s}";
    EXPECT_EQ(instrumented(text, structureOf(text), "@"),
              "@ 0;set x 1\n@ 8;foreach i {1} {@ 23 body b$i s}");
}

TEST(Instrument, TakesItsMarksOutAgain) {
    const std::string text = "if {[f] > 0} {\n  body \"[g]\" s ;# c\n}\nh {a b}\n";
    const std::string mark = markFor(text);
    EXPECT_EQ(withoutMarks(instrumented(text, structureOf(text), mark), mark), text);
}

TEST(Instrument, ChoosesAMarkThatTheTextLacks) {
    const std::string taken = "\xee\x80\x80 \xee\x80\x81";
    EXPECT_EQ(markFor("a"), "\xee\x80\x80");
    EXPECT_EQ(markFor(taken), "\xee\x80\x82");
}

TEST(Instrument, ContinuesLinesOfOtherSystems) {
    EXPECT_EQ(withPlainContinuations("a \\\r\n b\r\n"), "a \\\n  b\r\n");
    EXPECT_EQ(withPlainContinuations("a \\\\\r\n"), "a \\\\\r\n");
}

} // namespace
} // namespace script
