// (text, element, name, text)
#include "editing/test_reading.h"
#include "element_edits/renaming.h"

namespace editing {
namespace {

using ::testing::HasSubstr;

std::string with(const std::string& text, const Element& element, const std::string& name) {
    const Answer answer = renamed(text, *readScene(text), element, name);
    EXPECT_EQ(answer.reason, "");
    const std::string after = text::applied(text, answer.edits);
    (void)readScene(after);
    return after;
}

const std::string text = "# b is a body; b.x its place\n"
                         "shape_set b_shape -desc {-sub {-sphere 0.5}}\n"
                         "body b b_shape -init_pos {1 2 0}\n"
                         "instance c -shape b_shape -init_pos {4 2 0}\n"
                         "trajectory way -points {{0 0 0 0} {1 1 0 0}}\n"
                         "force -body b -y {-9.81 * b.mass + 0 * c.x}\n"
                         "joint pin -type hinge -axis {0 0 1} -body1 b -body2 c "
                         "-motor {-b.wz - abs(b.x)}\n"
                         "rope r -points {{b {0 0.5 0}} {0 5 0} {c {0 0.5 0}}}\n"
                         "contact -body1 b -body2 c -friction 0.5\n"
                         "link -body1 c -x 0 -y {b.y} -z 0 -tightness 5\n"
                         "plot p -values {b.x {b.y + c.y} pin.q} -labels {b c {b.x}}\n";

TEST(Renaming, ABodyGetsItsNameWhereverItIsMentioned) {
    const std::string after = with(text, {Kind::body, 0}, "ball");
    EXPECT_EQ(after, "# b is a body; b.x its place\n"
                     "shape_set b_shape -desc {-sub {-sphere 0.5}}\n"
                     "body ball b_shape -init_pos {1 2 0}\n"
                     "instance c -shape b_shape -init_pos {4 2 0}\n"
                     "trajectory way -points {{0 0 0 0} {1 1 0 0}}\n"
                     "force -body ball -y {-9.81 * ball.mass + 0 * c.x}\n"
                     "joint pin -type hinge -axis {0 0 1} -body1 ball -body2 c "
                     "-motor {-ball.wz - abs(ball.x)}\n"
                     "rope r -points {{ball {0 0.5 0}} {0 5 0} {c {0 0.5 0}}}\n"
                     "contact -body1 ball -body2 c -friction 0.5\n"
                     "link -body1 c -x 0 -y {ball.y} -z 0 -tightness 5\n"
                     "plot p -values {ball.x {ball.y + c.y} pin.q} -labels {b c {b.x}}\n");
}

TEST(Renaming, ShapesAndJoints) {
    EXPECT_THAT(with(text, {Kind::shapeSet, 0}, "sphere"),
                HasSubstr("body b sphere -init_pos {1 2 0}\ninstance c -shape sphere "));
    EXPECT_THAT(with(text, {Kind::joint, 0}, "axle"), HasSubstr("{b.x {b.y + c.y} axle.q}"));
}

TEST(Renaming, AParameterAlsoAsAVariable) {
    const std::string with_k = "parameter k -value 2 -min 0 -max 5\n"
                               "shape_set s -desc {-sub {-sphere 1}}\n"
                               "body a s -mass $k -init_pos \"${k} 0 [expr {2 * $k}]\"\n"
                               "force -body a -x {k * a.mass}\n";
    EXPECT_EQ(with(with_k, {Kind::parameter, 0}, "stiff"),
              "parameter stiff -value 2 -min 0 -max 5\n"
              "shape_set s -desc {-sub {-sphere 1}}\n"
              "body a s -mass $stiff -init_pos \"${stiff} 0 [expr {2 * $stiff}]\"\n"
              "force -body a -x {stiff * a.mass}\n");
}

TEST(Renaming, AContactWithoutANameGetsOne) {
    EXPECT_THAT(with(text, {Kind::contact, 0}, "touch"), HasSubstr("contact touch -body1 b"));
}

TEST(Renaming, SaysWhyNot) {
    const auto scene = readScene(text);
    EXPECT_THAT(renamed(text, *scene, {Kind::body, 0}, "c").reason,
                HasSubstr("\"c\" is the name of something else"));
    EXPECT_THAT(renamed(text, *scene, {Kind::body, 0}, "2b").reason, HasSubstr("no digit first"));
    EXPECT_THAT(renamed(text, *scene, {Kind::body, 0}, "").reason, HasSubstr("needed"));
    EXPECT_EQ(renamed(text, *scene, {Kind::force, 0}, "f").reason, "A force has no name.");
    const std::string loop = "shape_set s -desc {-sub {-sphere 1}}\n"
                             "foreach i {1 2} {\n  body b$i s\n}\n";
    EXPECT_EQ(renamed(loop, *readScene(loop), {Kind::body, 1}, "x").reason,
              "Body \"b2\" is one of 2 that line 3 makes.");
}

} // namespace
} // namespace editing
