// What entries of Create write of what was shown to them.
#include "recipes/recipes.h"

#include "script/reader.h"

#include <gmock/gmock.h>

namespace views {
namespace {

using editing::NewElement;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::SizeIs;

class RecipesTest : public testing::Test {
protected:
    void read(const std::string& text) {
        static script::Reader reader;
        text_ = text;
        script::ReadResult result = reader.read(text);
        ASSERT_TRUE(result.usable);
        scene_ = std::move(result.scene);
    }
    [[nodiscard]] std::vector<NewElement> made(const Recipe& recipe,
                                               const std::vector<Indicated>& shown = {}) const {
        return recipe.make(text_, scene_, shown);
    }
    static Indicated onBody(std::size_t body) {
        Indicated shown;
        shown.given = true;
        shown.body = body;
        shown.resolution = 0.01;
        return shown;
    }

    std::string text_;
    scene::Scene scene_;
};

const std::string stars = "shape_set star -desc {-sub {-sphere 0.5}}\n"
                          "body a star -init_pos {-2 0 0}\n"
                          "body b star -init_pos {2 0 0}\n"
                          "body rock star -init_pos {0 3 0} -fixed 1\n";

TEST_F(RecipesTest, EachStepOfARecipeHasItsPrompt) {
    for (const Recipe& recipe :
         {newBody(BasicShape::box), newForce(false, 1), newLink(Wanted::body),
          newJoint(scene::JointType::hinge), newRope(), newLight(true), newTrajectory()}) {
        EXPECT_THAT(recipe.steps, Not(IsEmpty())) << recipe.label.toStdString();
        for (const Step& step : recipe.steps)
            EXPECT_FALSE(step.prompt.isEmpty()) << recipe.label.toStdString();
    }
    EXPECT_THAT(weightForAll({0, -9.81, 0}).steps, IsEmpty());
}

// Also after one of them is deleted.
TEST_F(RecipesTest, ANewBodyHasTheColourThatTheFewestHave) {
    Indicated place;
    place.given = true;
    const auto colorAfter = [&](const std::string& text) {
        read(text);
        const auto elements = made(newBody(BasicShape::box), {place});
        const auto& words = elements.back().words;
        const auto color = std::ranges::find(words, "-color");
        return color == words.end() ? std::string() : *(color + 1);
    };
    const std::string two = stars + "body c star -color indianred\nbody d star -color goldenrod\n";
    EXPECT_EQ(colorAfter(stars), "steelblue");
    EXPECT_EQ(colorAfter(two), "steelblue");
    EXPECT_EQ(colorAfter(two + "body e star -color steelblue\n"), "seagreen");
    EXPECT_EQ(colorAfter(stars + "body d star -color goldenrod\nbody e star -color steelblue\n"),
              "indianred");
}

TEST_F(RecipesTest, AForceActsWhereItsBodyWasShown) {
    read(stars);
    Indicated shown = onBody(1);
    shown.onBody = {0.5, 0, 0};
    const auto force = made(newForce(false, 1), {shown, {}});
    ASSERT_THAT(force, SizeIs(1));
    EXPECT_THAT(force[0].words, testing::Contains("{0.5 0 0}"));
    shown.atCenter = true; // which is what is meant without an offset
    EXPECT_THAT(made(newForce(false, 1), {shown, {}})[0].words,
                Not(testing::Contains("{0.5 0 0}")));
}

TEST_F(RecipesTest, WhatHasItsWeightGetsNoSecondOne) {
    read(stars + "force -body a -gravitational {0 -9.81 0}\n");
    EXPECT_EQ(commonGravity(scene_), std::nullopt); // b has none
    EXPECT_THAT(made(weightForAll({0, -9.81, 0})), SizeIs(1));
    read(text_ + "force -body b -gravitational {0 -9.81 0}\n");
    EXPECT_EQ(commonGravity(scene_), Vector(0, -9.81, 0));
    EXPECT_THAT(made(weightForAll({0, -9.81, 0})), IsEmpty());
}

TEST_F(RecipesTest, AttractionIsOfEachPairThatCanMoveByOneConstant) {
    read(stars);
    const auto all = made(attractionOfAll());
    // A parameter; a and b on each other, and the rock on both.
    ASSERT_THAT(all, SizeIs(5));
    EXPECT_EQ(all[0].kind, editing::Kind::parameter);
    for (std::size_t i = 1; i < all.size(); ++i)
        EXPECT_EQ(all[i].kind, editing::Kind::force);
}

} // namespace
} // namespace views
