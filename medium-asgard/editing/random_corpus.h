// Scenes as authors write them, for random edits: comments, loops, procedures, expressions, odd
// spacing; and what of each no gesture may rewrite.
#pragma once

#include <set>
#include <string>
#include <vector>

namespace editing {

struct CorpusScene {
    std::string text;
    // "body \"b1\"": all of it; "body \"b1\" -init_pos": that option.
    std::set<std::string> readOnly;
    // Of these the first two values are one number of the text: it may become another, for both.
    std::set<std::string> oneNumberTwice = {};
};

[[nodiscard]] inline std::vector<CorpusScene> corpus() {
    const std::string shapes = "shape_set s -desc {-sub {-sphere 1}}\n";
    return {
        {"# plain\n" + shapes +
             "body b1 s -init_pos {-5 0 0} -mass 2 ;# first {not a brace\n"
             "body b2 s -init_pos {  1.50   2e0 +3 } -init_dpos {0 0 1}; # second\n"
             "force -body b1 -gravitational {0 -9.81 0}\n"
             "force -body b2 -x 0 -y {-10 * b1.mass} -z {3}\n"
             "link -body1 b1 -offset1 {1 0 0} -x 0 -y 0 -z 0 -tightness 50\n"
             "lightsource sun -pos {0 5 0} -direction {0 -1 0}\n"
             "trajectory T -points {\n  {0 1 2 3}\n  {1 4 5 6} {2   7 8 9}\n}\n",
         {}},
        {"\t set h 1.25 ;# height\n" + shapes +
             "parameter g -value 2 -min -1000 -max 1000 -label {pull of \"g\"}\n"
             "body ball \\\n   -shape s \\\n   -init_pos \"0 $h 2\" \\\n   -mass 2 ;# continued\n"
             "body other s -init_pos [list 1 $g 3] -init_rot {0 0 0}\n"
             "force -body ball -x 0 -y {g} -z 0 -offset {0 1 0}\n"
             "force -body other -y {-10 * ball.mass * t} -x {sin(t)}\n",
         {"the force of line 10 -y", "the force of line 10 -x"}},
        {shapes + "foreach i {1 2 3} {   # a row\n    body b$i s -init_pos \"$i 0 0\"\n}\n"
                  "foreach n {only} {\n\tbody $n s -init_pos {7 8 9}\n}\n"
                  "for {set k 0} {$k < 2} {incr k} { force -body b1 -y $k }\n"
                  "if {1} {body last s -init_pos {3 3 3}} else {body never s}\n",
         {"body \"b1\"", "body \"b2\"", "body \"b3\"", "the force of line 8"}},
        {shapes + "proc pair {name x} {\n  body ${name}1 s -init_pos \"$x 0 0\"\n"
                  "  body ${name}2 s -init_pos {0 4 0} -init_dpos \"0 $x 0\"\n}\n"
                  "pair a 3 ;# left\npair b 9\nproc once {} { body c s -init_pos {1 1 1} }\nonce\n",
         {"body \"a1\"", "body \"a2\"", "body \"b1\"", "body \"b2\""}},
        {shapes + "set a [expr {1 + 2}]\nset v {4 5 6}\nset x 1\n"
                  "body b1 s -init_pos [list $a 0 0]\nbody b2 s -init_pos $v\n"
                  "body b3 s -init_pos \"$x $x 1\"\nbody b4 s -init_pos {0 0 0};body b5 s\n"
                  "incr y\nbody b6 s -init_pos \"$y 0 0\" -init_drot {0 0 1}\n",
         {"body \"b1\" -init_pos", "body \"b3\" -init_pos", "body \"b6\" -init_pos"},
         {"body \"b3\" -init_pos"}},
        // Loops whose numbers are read twice, counted on, or make names.
        {shapes +
             "set xs {1 2}\nset h 1\n"
             "foreach x $xs {body a[incr n] s -init_pos \"$x $h -5\"}\n"
             "foreach x $xs {body c[incr m] s -init_pos \"5 [expr {$x + 1}] -5\"}\n"
             "for {set k 0} {$k < 4} {incr k 2} {\n"
             "  body d$k s -init_pos \"$k 0 0\"\n  body e[incr j] s -init_pos \"$k 1 0\"\n}\n"
             "foreach y {1 2} {set y [expr {$y * 2}]; body f$y s -init_pos \"$y 0 0\"}\n"
             "foreach {n z} {g 1 i 2} {body $n s -init_pos \"$z [expr {2 * $z}] 0\"}\n"
             "foreach {n z} {p 1 q 2} {body $n s -init_pos \"$z 0 0\" -init_dpos \"$z 0 0\"}\n",
         {"body \"a1\"", "body \"a2\"", "body \"c1\"", "body \"c2\"", "body \"d0\"", "body \"d2\"",
          "body \"e1\"", "body \"e2\"", "body \"f2\"", "body \"f4\"", "body \"g\"", "body \"i\"",
          "body \"p\"", "body \"q\""}},
        {"eval \"shape_set s -desc {-sub {-box {1 1 1}}}\"\r\nbody b1 s -init_pos {1 2 3}\r\n"
         "eval {body b2 s}\r\neval \"body b3 s -init_pos {1 1 1}\"\r\n"
         "trajectory P -points [list {0 0 0 0} {1 1 1 1}]\r\n",
         {"body \"b3\"", "trajectory \"P\" -points"}},
        {"# \xc3\xa4\xe2\x82\xac \xf0\x9f\x8e\xb1 other alphabets\n" + shapes +
             "trajectory Q -bezier {{0 1 {0 0 0} {1 1 1} {2 0 0}} {2 3 {5 5 5}}}\n"
             "body \xc3\xa4 s -init_pos {1 2 3} ;# \xe2\x82\xac\n"
             "constrain \xc3\xa4 -pos Q\nplot p -values {t}\n"
             "view v -pos {0 0 0} -scale 1\n",
         {}},
    };
}

} // namespace editing
