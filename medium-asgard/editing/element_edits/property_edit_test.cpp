// (text, option, typed, text): the fields of a form.
#include "editing/test_reading.h"
#include "element_edits/attitude.h"
#include "element_edits/property_edit.h"

#include <set>

namespace editing {
namespace {

using geometry::Vector;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Optional;

const std::string shape = "shape_set s -desc {-sub {-sphere 0.5}}\n";

const OptionHint& option(const scene::Scene& scene, const Element& element,
                         const std::string& name) {
    return *hintOf(hintOf(scene, element), name);
}

std::string with(const std::string& text, const std::vector<Element>& elements,
                 const std::string& name, const std::vector<std::optional<std::string>>& parts) {
    const auto scene = readScene(text);
    const Answer answer =
        Properties(text, scene).set(elements, option(*scene, elements.front(), name), parts);
    EXPECT_EQ(answer.reason, "") << text;
    return text::applied(text, answer.edits);
}

std::vector<std::string> shown(const std::string& text, const Element& element,
                               const std::string& name) {
    const auto scene = readScene(text);
    return Properties(text, scene).valueOf(element, option(*scene, element, name)).parts;
}

const Element first{Kind::body, 0};

TEST(Properties, ANumberIsWrittenWhereItStands) {
    EXPECT_EQ(with(shape + "body b s -mass 2 ;# kg\n", {first}, "-mass", {"3"}),
              shape + "body b s -mass 3 ;# kg\n");
    EXPECT_EQ(with(shape + "body b s -init_pos {1 2 3}\n", {first}, "-init_pos",
                   {std::nullopt, "5", std::nullopt}),
              shape + "body b s -init_pos {1 5 3}\n");
}

TEST(Properties, WhatIsMissingIsAddedAndWhatIsEmptiedGoes) {
    EXPECT_EQ(with(shape + "body b s ;# one\n", {first}, "-mass", {"3"}),
              shape + "body b s -mass 3 ;# one\n");
    EXPECT_EQ(with(shape + "body b s\n", {first}, "-init_dpos", {"", "2", ""}),
              shape + "body b s -init_dpos {0 2 0}\n");
    EXPECT_EQ(with(shape + "body b s -mass 3 \\\n  -restitution 0.5 -fixed 1\n", {first},
                   "-restitution", {""}),
              shape + "body b s -mass 3 -fixed 1\n");
    EXPECT_EQ(
        with(shape + "body b s -init_pos {1 2 3} -mass 3\n", {first}, "-init_pos", {"", "", ""}),
        shape + "body b s -mass 3\n");
}

TEST(Properties, AVariableIsChangedWhereItIsSetAndShownAsANumber) {
    const std::string text = "set h 2\n" + shape + "body b s -mass 1 -init_pos \"0 $h 0\"\n";
    EXPECT_THAT(shown(text, first, "-init_pos"), ElementsAre("0", "2", "0"));
    EXPECT_EQ(with(text, {first}, "-init_pos", {std::nullopt, "4", std::nullopt}),
              "set h 4\n" + shape + "body b s -mass 1 -init_pos \"0 $h 0\"\n");
}

TEST(Properties, ANameThatAVariableHoldsIsShown) {
    const std::string text =
        shape +
        "set form s\nbody post s\nforeach b {b c} {\n  body $b $form\n"
        "  force -body $b -y 2\n  joint hook$b -type ball -body1 post -body2 $b\n"
        "  contact -body1 $b -body2 post\n  link -body1 $b -x 0 -y 0 -z 0 -tightness 5\n}\n";
    EXPECT_THAT(shown(text, {Kind::body, 1}, "-shape"), ElementsAre("s"));
    EXPECT_THAT(shown(text, {Kind::force, 0}, "-body"), ElementsAre("b"));
    EXPECT_THAT(shown(text, {Kind::force, 1}, "-body"), ElementsAre("c"));
    EXPECT_THAT(shown(text, {Kind::joint, 0}, "-body2"), ElementsAre("b"));
    EXPECT_THAT(shown(text, {Kind::contact, 0}, "-body1"), ElementsAre("b"));
    EXPECT_THAT(shown(text, {Kind::link, 1}, "-body1"), ElementsAre("c"));
    const auto scene = readScene(text);
    EXPECT_THAT(Properties(text, scene)
                    .sharedValue({{Kind::force, 0}, {Kind::force, 1}},
                                 option(*scene, {Kind::force, 0}, "-body")),
                ElementsAre(std::nullopt));
}

TEST(Properties, ALoopMakesOffers) {
    const std::string text = shape + "foreach i {0 3 6} {\n  body b$i s -init_pos \"$i 1 0\"\n}\n";
    const auto scene = readScene(text);
    const Answer answer = Properties(text, scene)
                              .set({{Kind::body, 1}}, option(*scene, first, "-init_pos"),
                                   {std::nullopt, "2", std::nullopt});
    EXPECT_THAT(answer.reason, HasSubstr("is one of 3 that line 3 makes"));
    EXPECT_FALSE(answer.offers.empty());
    EXPECT_THAT(
        Properties(text, scene).set({{Kind::body, 1}}, option(*scene, first, "-mass"), {""}).edits,
        testing::IsEmpty());
}

TEST(Properties, ExpressionsAreTexts) {
    const std::string text = shape + "body b s\nforce -body b -y {-10 * b.mass}\n";
    const Element force{Kind::force, 0};
    EXPECT_THAT(shown(text, force, "-y"), ElementsAre("-10 * b.mass"));
    EXPECT_EQ(with(text, {force}, "-y", {"-5 * b.mass + sin(t)"}),
              shape + "body b s\nforce -body b -y {-5 * b.mass + sin(t)}\n");
    EXPECT_EQ(with(text, {force}, "-y", {"-3"}), shape + "body b s\nforce -body b -y -3\n");
    EXPECT_EQ(with(text, {force}, "-x", {"2 * t"}),
              shape + "body b s\nforce -body b -y {-10 * b.mass} -x {2 * t}\n");
}

TEST(Properties, NamesColoursAndListsAreWritten) {
    const std::string text = shape + "shape_set r -desc {-sub {-sphere 1}}\nbody b s\n";
    EXPECT_EQ(with(text, {first}, "-shape", {"r"}),
              shape + "shape_set r -desc {-sub {-sphere 1}}\nbody b r\n");
    EXPECT_EQ(with(text, {first}, "-color", {"#ff0000"}),
              shape + "shape_set r -desc {-sub {-sphere 1}}\nbody b s -color #ff0000\n");
    EXPECT_EQ(with(text, {first}, "-color", {"1 0 0"}),
              shape + "shape_set r -desc {-sub {-sphere 1}}\nbody b s -color {1 0 0}\n");
}

TEST(Properties, WhatCannotBeAWordIsRefused) {
    const std::string text = shape + "body b s\nforce -body b -y 1\n";
    const auto scene = readScene(text);
    const Element force{Kind::force, 0};
    for (const char* typed : {"{1", "1 } 2", "a \"$x"}) {
        const Answer answer =
            Properties(text, scene).set({force}, option(*scene, force, "-y"), {typed});
        EXPECT_THAT(answer.reason, HasSubstr("do not match")) << typed;
    }
    EXPECT_THAT(Properties(text, scene).set({first}, option(*scene, first, "-shape"), {""}).reason,
                HasSubstr("needs it"));
}

TEST(Properties, SeveralShareWhatIsTheSame) {
    const std::string text = shape + "body a s -mass 2 -init_pos {1 2 0}\n"
                                     "body b s -mass 3 -init_pos {4 2 0}\n";
    const auto scene = readScene(text);
    const std::vector<Element> both{{Kind::body, 0}, {Kind::body, 1}};
    const Properties properties(text, scene);
    EXPECT_THAT(properties.sharedValue(both, option(*scene, first, "-mass")),
                ElementsAre(std::nullopt));
    EXPECT_THAT(properties.sharedValue(both, option(*scene, first, "-init_pos")),
                ElementsAre(std::nullopt, Optional(std::string("2")), Optional(std::string("0"))));
    EXPECT_EQ(with(text, both, "-init_pos", {std::nullopt, "5", std::nullopt}),
              shape + "body a s -mass 2 -init_pos {1 5 0}\n"
                      "body b s -mass 3 -init_pos {4 5 0}\n");
}

TEST(Properties, AJointHasTheOptionsOfItsCoordinates) {
    const std::string text = shape + "body b s\njoint j -type hinge -body1 b -axis {0 0 1}\n"
                                     "joint k -type cylindrical -body1 b -axis {0 0 1}\n"
                                     "joint l -type fixed -body1 b\n"
                                     "joint m -type planar -body1 b\n";
    const auto scene = readScene(text);
    const auto names = [&](std::size_t joint) {
        std::set<std::string_view> all;
        for (const OptionHint* one : optionsOf(*scene, {Kind::joint, joint}))
            all.insert(one->name);
        return all;
    };
    EXPECT_TRUE(names(0).contains("-limits") && !names(0).contains("-limits2"));
    EXPECT_TRUE(names(1).contains("-limits2") && !names(1).contains("-limits"));
    EXPECT_TRUE(!names(2).contains("-motor") && names(2).contains("-offset1"));
    EXPECT_TRUE(names(0).contains("-from") && !names(0).contains("-from1"));
    EXPECT_FALSE(names(2).contains("-from"));
    EXPECT_TRUE(names(3).contains("-from3") && !names(3).contains("-limits1"));
}

TEST(Properties, AnAttitudeIsSoManyDegreesAboutAnAxis) {
    const Turn turn = turnOf(Vector(0, M_PI / 2, 0));
    EXPECT_NEAR(turn.degrees, 90, 1e-12);
    EXPECT_TRUE(turn.axis.isApprox(Vector::UnitY()));
    EXPECT_NEAR(turnOf(Vector(0, 0, 1.5 * M_PI)).degrees, -90, 1e-9);
    EXPECT_NEAR(turnOf(Vector(-M_PI / 2, 0, 0)).degrees, -90, 1e-9); // about x
    EXPECT_TRUE(turnOf(Vector::Zero(), Vector(0, 2, 0)).axis.isApprox(Vector::UnitY()));
    const Turn back = turnOf(Vector(0, 0, -M_PI / 12), Vector(0, 0, 2)); // "-15 about z"
    EXPECT_NEAR(back.degrees, -15, 1e-9);
    EXPECT_TRUE(back.axis.isApprox(Vector::UnitZ()));
    EXPECT_TRUE(rotationVectorOf({180, Vector(0, 0, 2)}).isApprox(Vector(0, 0, M_PI)));
    EXPECT_TRUE(rotationVectorOf({90, Vector::Zero()}).isZero());
}

} // namespace
} // namespace editing
