// Where each element stands in the text, how often its command ran, which words may be rewritten.
#include "script/reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace script {
namespace {

Reader& reader() {
    static Reader shared;
    return shared;
}

// "NAME runs N LINE:COLUMN `COMMAND` OPTION=WORD ..." per body, a star after a computed word.
std::string bodies(const std::string& text) {
    const ReadResult result = reader().read(text);
    std::string out;
    const auto slice = [&](scene::Range range) {
        return text.substr(range.from, range.to - range.from);
    };
    for (const scene::Body& body : result.scene.bodies) {
        const scene::Source& source = body.source;
        out += body.name + " runs " + std::to_string(source.runs) + " " +
               std::to_string(source.line) + ":" + std::to_string(source.column) + " `" +
               slice(source.command) + "`";
        for (const scene::Argument& argument : source.arguments)
            out +=
                " " + argument.option + "=" + slice(argument.word) + (argument.literal ? "" : "*");
        out += "\n";
    }
    for (const scene::Diagnostic& diagnostic : result.diagnostics)
        out += diagnostic.message + "\n";
    return out;
}

struct SpanCase {
    const char* name;
    const char* text;
    const char* expected;
};

class Spans : public ::testing::TestWithParam<SpanCase> {};

TEST_P(Spans, AreKnown) {
    const std::string shape = "shape_set s -desc {-sub {-sphere 1}}\n";
    EXPECT_EQ(bodies(shape + GetParam().text), GetParam().expected);
}

INSTANTIATE_TEST_SUITE_P(
    All, Spans,
    ::testing::Values(
        SpanCase{"Literal", "body b1 s -init_pos {-5 0 0} -mass 10",
                 "b1 runs 1 2:1 `body b1 s -init_pos {-5 0 0} -mass 10` =b1 =s -init_pos={-5 0 0} "
                 "-mass=10\n"},
        SpanCase{"Loop", "foreach i {1 2 3} {\n  body b$i s -mass 1\n}",
                 "b1 runs 3 3:3 `body b$i s -mass 1` =b$i* =s -mass=1\n"
                 "b2 runs 3 3:3 `body b$i s -mass 1` =b$i* =s -mass=1\n"
                 "b3 runs 3 3:3 `body b$i s -mass 1` =b$i* =s -mass=1\n"},
        SpanCase{"ProcedureCalledTwice", "proc p {n} {body $n s}\np a\np b",
                 "a runs 2 2:13 `body $n s` =$n* =s\nb runs 2 2:13 `body $n s` =$n* =s\n"},
        SpanCase{"IfTaken", "if {1} {body a s} else {body b s}", "a runs 1 2:9 `body a s` =a =s\n"},
        SpanCase{"InASubstitution", "set r [body a s]", "a runs 1 2:8 `body a s` =a =s\n"},
        SpanCase{"InEvalOfBraces", "eval {body a s}", "a runs 1 2:7 `body a s` =a =s\n"},
        SpanCase{"InACondition", "if {[body a s] ne {}} {}", "a runs 1 2:6 `body a s` =a =s\n"},
        SpanCase{"WithSubstitutionsInside", "body a s -init_pos [list 1 [expr {1 + 1}] 0]",
                 "a runs 1 2:1 `body a s -init_pos [list 1 [expr {1 + 1}] 0]` =a =s "
                 "-init_pos=[list 1 [expr {1 + 1}] 0]*\n"},
        SpanCase{
            "Computed", "set m 5; body a s -mass $m -init_pos \"$m 0 0\" -init_dpos \"1 0 0\"",
            "a runs 1 2:10 `body a s -mass $m -init_pos \"$m 0 0\" -init_dpos \"1 0 0\"` =a =s "
            "-mass=$m* -init_pos=\"$m 0 0\"* -init_dpos=\"1 0 0\"\n"},
        SpanCase{"ExpandedLiteral", "body a s {*}{-mass 6 -color red}",
                 "a runs 1 2:1 `body a s {*}{-mass 6 -color red}` =a =s -mass=6 -color=red\n"},
        SpanCase{"ExpandedComputed", "set o {-mass 6}; body a s -ct 1 {*}$o -density 2",
                 "a runs 1 2:18 `body a s -ct 1 {*}$o -density 2` =a =s -ct=1 -mass={*}$o* "
                 "-density=2\n"},
        SpanCase{"ContinuedInBraces", "body a s -init_pos {1 \\\n 2 3}",
                 "a runs 1 2:1 `body a s -init_pos {1 \\\n 2 3}` =a =s -init_pos={1 \\\n 2 3}*\n"},
        SpanCase{"ContinuedLine", "body a s \\\n  -mass 2",
                 "a runs 1 2:1 `body a s \\\n  -mass 2` =a =s -mass=2\n"},
        SpanCase{"CarriageReturns", "body a s \\\r\n  -mass 2\r\nbody b s\r\n",
                 "a runs 1 2:1 `body a s \\\r\n  -mass 2` =a =s -mass=2\n"
                 "b runs 1 4:1 `body b s` =b =s\n"},
        SpanCase{"OtherAlphabets", "set x \"\xc3\xa4\xe2\x82\xac\"; body a s -color red",
                 "a runs 1 2:13 `body a s -color red` =a =s -color=red\n"},
        SpanCase{"DynamicEval", "eval \"body dyn s -mass 2\"",
                 "dyn runs 0 2:1 `` =eval* =eval* -mass=eval*\n"},
        SpanCase{"IndirectName", "set c body; $c a s", "a runs 1 2:13 `$c a s` =a =s\n"},
        SpanCase{"SwitchBody", "switch b {a {body x s} b {body y s}}",
                 "y runs 1 2:27 `body y s` =y =s\n"},
        SpanCase{"CatchAndTry", "catch {body a s}; try {body b s} finally {body c s}",
                 "a runs 1 2:8 `body a s` =a =s\nb runs 1 2:24 `body b s` =b =s\n"
                 "c runs 1 2:43 `body c s` =c =s\n"},
        SpanCase{"Namespace", "namespace eval n {body a s}", "a runs 1 2:19 `body a s` =a =s\n"},
        SpanCase{"InstanceIsBody", "instance a s", "a runs 1 2:1 `instance a s` =a =s\n"},
        SpanCase{"ShapeByOption", "body a -shape s",
                 "a runs 1 2:1 `body a -shape s` =a -shape=s\n"},
        SpanCase{
            "MarksDoNotShowInBodies",
            "proc p {} {body a s}\nproc q {} [info body p]\nif {[info body p] eq \"body a s\"} "
            "q",
            "a runs 0 4:1 `` =if* =if*\n"},
        SpanCase{"MarksDoNotShowInErrors", "proc p {} {error [info level 0]}\np", "p\n"},
        SpanCase{
            "MarksDoNotShowInErrorInfo",
            "catch {body}; proc p {} {nosuch 1}\ncatch p m o\n"
            "error x[string map {\"\\n\" |} [dict get $o -errorinfo]]",
            "body wants a name, and nothing follows it\n"
            "xinvalid command name \"nosuch\"|    while executing|\"nosuch 1\"|    invoked from "
            "within|\"nosuch 1\"|    (procedure \"p\" line 1)|    invoked from within|\"p\"\n"},
        SpanCase{"AtIsAnOrdinaryName", "proc @ {n} {body $n s}; @ a",
                 "a runs 1 2:13 `body $n s` =$n* =s\n"},
        SpanCase{"UserCommandsKeepControlFlow",
                 "proc p {} {foreach i {1 2 3} {if {$i == 2} {return $i}}}\nbody b[p] s",
                 "b2 runs 1 3:1 `body b[p] s` =b[p]* =s\n"},
        SpanCase{"UplevelReachesTheCaller",
                 "proc repeat {n script} {for {set i 0} {$i < $n} {incr i} {uplevel 1 $script}}\n"
                 "set k 0\nrepeat 2 {body b[incr k] s}",
                 "b1 runs 0 2:59 `` =uplevel* =uplevel*\nb2 runs 0 2:59 `` =uplevel* =uplevel*\n"}),
    [](const auto& one) { return std::string(one.param.name); });

TEST(Source, OfUnmappedElementsHasTheLineOfTheirCaller) {
    const ReadResult result =
        reader().read("shape_set s -desc {-sub {-sphere 1}}\n\neval \"body dyn s\"\n");
    ASSERT_EQ(result.scene.bodies.size(), 1u);
    const scene::Source& source = result.scene.bodies[0].source;
    EXPECT_FALSE(source.command.known());
    EXPECT_EQ(source.line, 3);
    EXPECT_EQ(source.column, 1);
}

// One number of a list: its own bytes, inside the word.
TEST(Source, OfAFaultInsideAListIsThatElement) {
    const std::string text = "shape_set s -desc {\n  -sub {-pos {1 2 x} -sphere 1}\n}\n";
    const ReadResult result = reader().read(text);
    ASSERT_EQ(result.diagnostics.size(), 1u);
    EXPECT_EQ(result.diagnostics[0].range, (scene::Range{text.find('x'), text.find('x') + 1}));
    EXPECT_EQ(result.diagnostics[0].line, 2);
    EXPECT_EQ(result.diagnostics[0].column, 19);
}

TEST(Source, OfAByteOrderMarkIsBlank) {
    const ReadResult result =
        reader().read("\xef\xbb\xbfshape_set s -desc {-sub {-sphere 1}}\nbody b s");
    ASSERT_TRUE(result.usable);
    EXPECT_EQ(result.scene.bodies[0].source.line, 2);
}

TEST(Reader, RefusesWhatIsNoText) {
    for (const std::string& text : {std::string("a\0b", 3), std::string("body \xff"),
                                    std::string("\xc0\x80"), std::string("\xed\xa0\x80")}) {
        const ReadResult result = reader().read(text);
        ASSERT_EQ(result.diagnostics.size(), 1u);
        EXPECT_EQ(result.diagnostics[0].line, 1);
    }
    EXPECT_FALSE(reader().read(std::string(17 << 20, ' ')).usable);
}

} // namespace
} // namespace script
