// What entries of Create write of what was shown to them.
#include "recipes/begun_recipe.h"
#include "recipes/recipes.h"

#include "script/reader.h"

#include <gmock/gmock.h>

#include <sstream>

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

TEST_F(RecipesTest, AHingeAsksForABodyInPlainWords) {
    EXPECT_EQ(newJoint(scene::JointType::hinge).steps.front().prompt,
              "Click on the body that the joint holds, such as a wheel or a door.");
}

TEST_F(RecipesTest, EachStepOfARecipeHasItsPrompt) {
    for (const Recipe& recipe :
         {newBody(BasicShape::box), newForce(false, 1), newLink(Wanted::body),
          newJoint(scene::JointType::hinge), newGear(), newRope(), newWheels(), newLight(true),
          newTrajectory()}) {
        EXPECT_THAT(recipe.steps, Not(IsEmpty())) << recipe.label.toStdString();
        for (const Step& step : recipe.steps)
            EXPECT_FALSE(step.prompt.isEmpty()) << recipe.label.toStdString();
    }
    EXPECT_THAT(weightForAll({0, -9.81, 0}).steps, IsEmpty());
}

TEST_F(RecipesTest, SelectedBodiesAloneGetAWeightOnce) {
    read(stars + "force -body a -gravitational {0 -9.81 0}\n");
    const auto made = [&](const std::vector<std::size_t>& bodies) {
        return this->made(weightFor(bodies, {0, -10, 0}));
    };
    ASSERT_THAT(made({0, 1, 2}), SizeIs(1)); // one has it, one is fixed
    EXPECT_THAT(made({0, 1, 2}).front().words,
                ElementsAre("-body", "b", "-gravitational", "{0 -10 0}"));
    EXPECT_THAT(made({}), IsEmpty());
    EXPECT_THAT(weightFor({}, {0, -10, 0}).otherwise.toStdString(), HasSubstr("is selected"));
}

// A ball bounces on it, and it does not fall when gravity comes.
TEST_F(RecipesTest, ATableStandsAndDeadensNothing) {
    read("shape_set s -desc {-sub {-sphere 0.5}}\n");
    Indicated origin;
    origin.given = true;
    Recipe recipe = newBody(editing::libraryShape("Table"));
    const auto made = recipe.make(text_, scene_, {origin});
    ASSERT_THAT(made, SizeIs(2));
    EXPECT_THAT(made[1].words,
                ElementsAre("-init_pos", "{0 0 0}", "-fixed", "1", "-friction", "0.3"));
    recipe = newBody(editing::libraryShape("Cube"));
    EXPECT_THAT(recipe.make(text_, scene_, {origin})[1].words,
                testing::IsSupersetOf({"-restitution", "0"}));
}

TEST_F(RecipesTest, ANewBodyFitsTheViewUntilItsPlaceIsShown) {
    Recipe box = newBody(BasicShape::box);
    box.sized = [](double times) { return newBody(BasicShape::box, times); };
    BegunRecipe begun(box);
    ASSERT_TRUE(begun.ghost());
    gestures::Sight sight{{}, {600, 600}};
    const auto width = [&] { return geometry::bounds(*begun.ghost(), {}).sizes().x(); };
    sight.camera.scale = 1e-2; // far away
    begun.fit(sight, Vector::Zero());
    const double large = width();
    EXPECT_GT(large, 10);
    sight.camera.scale = 1e2;
    begun.fit(sight, Vector::Zero());
    EXPECT_LT(width(), 0.1);
    EXPECT_TRUE(begun.take(onBody(0)));
    begun.fit({{}, {600, 600}}, Vector::Zero());
    EXPECT_LT(width(), 0.1);
}

TEST_F(RecipesTest, ABegunRecipeAsksForItsStepsAndOffersTheOnlyBody) {
    read("shape_set s -desc {-sub {-sphere 0.5}}\nbody only s\n");
    BegunRecipe begun(newLink(Wanted::hold));
    begun.offerBody(scene_, {});
    EXPECT_EQ(begun.step().offered, std::optional<std::size_t>(0));
    EXPECT_THAT(begun.step().otherwise.toStdString(), HasSubstr("only"));
    EXPECT_FALSE(begun.take(onBody(0)));
    EXPECT_THAT(begun.shown(), SizeIs(1));
    EXPECT_FALSE(begun.step().offered);
    EXPECT_TRUE(begun.take(onBody(0)));
}

const std::string works =
    "shape_set rack -desc {-sub {-box {2 0.1 0.1}}}\n"
    "shape_set large -desc {-sub {-rot {1.5707963 0 0} -cylinder {0.4 0.1}}}\n"
    "shape_set small -desc {-sub {-rot {1.5707963 0 0} -cylinder {0.2 0.1}}}\n"
    "shape_set ring -desc {-sub {-rot {1.5707963 0 0} -tube {0.8 0.9 0.1}}}\n"
    "body frame rack -fixed 1 -init_pos {0 9 0}\n"
    "body large large\nbody small small -init_pos {0.6 0 0}\nbody rack rack -init_pos {0 -0.45 0}\n"
    "body ring ring -init_pos {0 0 0}\nbody loose small -init_pos {5 0 0}\n"
    "joint one -type hinge -body1 large -body2 frame\n"
    "joint two -type hinge -body1 small -axis {0 0 -1}\n"
    "joint rail -type slider -body1 rack -axis {1 0 0}\n"
    "joint rim -type hinge -body1 frame -offset1 {0 -9 0} -body2 ring\n";

// Rims go the same way where they touch: a wheel beside the other turns against it, one inside of
// the other with it; an axis that points the other way, and a joint that counts the other body's
// turn, change the sign.
TEST_F(RecipesTest, AGearHasTheRatioOfItsWheels) {
    read(works);
    enum { frame, large, small, rack, ring, loose };
    const auto gear = [&](std::size_t first, std::size_t second) {
        const auto all = made(newGear(), {onBody(first), onBody(second)});
        EXPECT_THAT(all, SizeIs(1));
        return all.front().words;
    };
    EXPECT_THAT(gear(large, small),
                ElementsAre("-joint1", "one", "-joint2", "two", "-ratio", "0.5"));
    EXPECT_EQ(gear(small, large).back(), "2");
    EXPECT_EQ(gear(rack, large).back(), "0.4"); // below the wheel: both to the right
    EXPECT_EQ(gear(large, rack).back(), "2.5");
    EXPECT_EQ(gear(large, ring).back(), "-2"); // it rolls inside
}

TEST_F(RecipesTest, AGearSaysWhichBodiesCannotMesh) {
    read(works);
    const Recipe gear = newGear();
    const auto judged = [&](std::vector<Indicated> shown, std::size_t body) {
        return gear.steps[shown.size()].judge(scene_, shown, onBody(body));
    };
    EXPECT_FALSE(judged({}, 5).isTaken);
    EXPECT_THAT(judged({}, 5).words.toStdString(), HasSubstr("loose neither turns on a hinge"));
    EXPECT_TRUE(judged({}, 1).isTaken);
    EXPECT_FALSE(judged({onBody(1)}, 1).isTaken);
    EXPECT_EQ(judged({onBody(1)}, 2).words, "small, on two: ratio 0.5");
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

const std::string slope = "shape_set slab -desc {-sub {-box {10 0.5 3}}}\n"
                          "shape_set hull -desc {-sub {-box {2 0.5 1.2}}}\n"
                          "body ramp slab -init_rot {0 0 -0.2} -fixed 1\n";

Vector onRamp(double along, double above) {
    return geometry::fromRotationVector({0, 0, -0.2}) * Vector(along, 0.25 + above, 0);
}

std::string carAt(const Vector& place, const std::string& more = "") {
    return "body car hull -init_pos {" + std::to_string(place.x()) + " " +
           std::to_string(place.y()) + " 0} -init_rot {0 0 -0.2}" + more + "\n";
}

std::string wordOf(const NewElement& element, const std::string& option) {
    const auto found = std::ranges::find(element.words, option);
    return found == element.words.end() ? "" : *(found + 1);
}

// At both sides, turned as the body is, and by round numbers of it.
TEST_F(RecipesTest, TwoWheelsStandAtTheSidesOfABodyOnHinges) {
    read(slope + carAt(onRamp(-3, 2), " -init_dpos {1 0 0}"));
    Indicated side = onBody(1);
    side.onBody = {0.703, -0.158, 0.6};
    side.attitude = scene_.bodies[1].initialAttitude;
    const auto all = made(newWheels(), {side});
    ASSERT_THAT(all, SizeIs(5));
    EXPECT_EQ(wordOf(all[0], "-desc"),
              "{-sub {-rot {1.5707963267948966 0 0} -cylinder {0.3 0.15}}}");
    EXPECT_EQ(wordOf(all[1], "-init_rot"), "{0 0 -0.2}");
    EXPECT_EQ(wordOf(all[1], "-init_dpos"), "{1 0 0}");
    EXPECT_THAT(wordOf(all[1], "-init_pos"), testing::EndsWith(" 0.675}"));
    EXPECT_THAT(wordOf(all[2], "-init_pos"), testing::EndsWith(" -0.675}"));
    EXPECT_THAT(all[3].words,
                ElementsAre("-type", "hinge", "-body1", all[1].name, "-body2", "car"));
    EXPECT_THAT(newWheels().moves(scene_, {side}), IsEmpty()); // they reach nothing
    EXPECT_EQ(newWheels().steps[0].judge(scene_, {}, side).words,
              "car: an axle at 0.7 -0.15 0, wheels of radius 0.3");
    side.sight = {1, 0.1, 0}; // from the front
    EXPECT_EQ(wordOf(made(newWheels(), {side})[4], "-axis"), "{1 0 0}");
}

// The second pair has the shape, the height and the colour of the first.
TEST_F(RecipesTest, TheSecondAxleIsLikeTheFirst) {
    read(slope + "shape_set tyre -desc {-sub {-rot {1.5707963267948966 0 0} -cylinder {0.4 0.1}}}\n"
                 "body car hull\nbody w tyre -init_pos {-0.7 -0.2 0.65} -color {1 0 0}\n"
                 "joint pin -type hinge -body1 w -body2 car\n");
    Indicated side = onBody(1);
    side.onBody = {0.7, -0.13, 0.6};
    const auto all = made(newWheels(), {side});
    ASSERT_THAT(all, SizeIs(4));
    EXPECT_EQ(all[0].shape, "tyre");
    EXPECT_EQ(wordOf(all[0], "-init_pos"), "{0.7 -0.2 0.65}");
    EXPECT_EQ(wordOf(all[0], "-color"), "{1 0 0}");
}

// A body that lies on a slope stands on its wheels then, across the slope.
TEST_F(RecipesTest, WheelsThatWouldBeInTheGroundRaiseTheirBody) {
    const Vector lies = onRamp(-3, 0.25);
    read(slope + carAt(lies));
    Indicated side = onBody(1);
    side.onBody = {0.7, -0.15, 0.6};
    side.attitude = scene_.bodies[1].initialAttitude;
    const auto wishes = newWheels().moves(scene_, {side});
    ASSERT_THAT(wishes, SizeIs(1));
    EXPECT_EQ(wishes[0].option, "-init_pos");
    const Vector raised(wishes[0].values[0], wishes[0].values[1], wishes[0].values[2]);
    EXPECT_LT((raised - onRamp(-3, 0.45)).norm(), 1e-5); // 0.3 below the axle
    const auto all = made(newWheels(), {side});
    std::istringstream place(wordOf(all[1], "-init_pos").substr(1));
    Vector wheel;
    place >> wheel.x() >> wheel.y();
    wheel.z() = 0;
    EXPECT_LT((wheel - onRamp(-2.3, 0.3)).norm(), 1e-5);
    EXPECT_THAT(newWheels().steps[0].judge(scene_, {}, side).words.toStdString(),
                HasSubstr("it stands on them"));
    read(slope + carAt(lies) + "joint hook -type ball -body1 car\n"); // it would not hang there
    EXPECT_THAT(newWheels().moves(scene_, {side}), IsEmpty());
    EXPECT_FALSE(newWheels().steps[0].judge(scene_, {}, onBody(0)).isTaken); // the slope is fixed
    EXPECT_THAT(made(newWheels(), {onBody(0)}), IsEmpty());
    read("shape_set ground -desc {-sub {-plane}}\nbody floor ground -fixed 1\n");
    EXPECT_FALSE(newWheels().steps[0].judge(scene_, {}, onBody(0)).isTaken);
}

} // namespace
} // namespace views
