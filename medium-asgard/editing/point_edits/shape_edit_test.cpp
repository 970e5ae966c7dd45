// (text, gesture, text) of shapes; and that the text reads as the parts that were wanted.
#include "editing/test_reading.h"
#include "point_edits/shape_edit.h"
#include "point_edits/shape_library.h"
#include "point_edits/shape_points.h"

#include "geometry/hull.h"

#include <gmock/gmock.h>

#include <random>

namespace editing {
namespace {

using geometry::Vector;
using ::testing::HasSubstr;

// The text when the draft of its first shape set is changed so; or the reason why not.
std::string after(const std::string& text,
                  const std::function<void(std::vector<DraftPart>&)>& change) {
    const auto scene = readScene(text);
    auto draft = draftOf(scene->shapeSets.at(0));
    change(draft);
    const Answer answer = become(text, scene, 0, draft);
    return answer.possible() ? text::applied(text, answer.edits) : answer.reason;
}

std::vector<Vector>& points(DraftPart& one) {
    return std::get<scene::HullShape>(one.part.shape).points;
}

const std::string tetra = "# four corners\nshape_set t -desc {\n"
                          "  -sub {-color red  -points {{0 0 0} {1.50 0 0} {0 1 0}  {0 0 1}}}\n"
                          "  -sub {-pos {2 0 0} -sphere 0.5}\n}\nbody b t\n";

TEST(ShapeEditTest, NothingChangedChangesNothing) {
    EXPECT_EQ(after(tetra, [](auto&) {}), tetra);
}

TEST(ShapeEditTest, AMovedVertexRewritesItsNumbersAlone) {
    EXPECT_EQ(after(tetra,
                    [](auto& draft) {
                        points(draft[0])[1] = {1.5, 0, -0.25};
                    }),
              "# four corners\nshape_set t -desc {\n"
              "  -sub {-color red  -points {{0 0 0} {1.50 0 -0.25} {0 1 0}  {0 0 1}}}\n"
              "  -sub {-pos {2 0 0} -sphere 0.5}\n}\nbody b t\n");
}

TEST(ShapeEditTest, VerticesAreAddedAndDeleted) {
    EXPECT_THAT(after(tetra,
                      [](auto& draft) {
                          points(draft[0]).push_back({1, 1, 1});
                      }),
                HasSubstr("{0 1 0}  {0 0 1} {1 1 1}}}\n"));
    EXPECT_THAT(after(tetra,
                      [](auto& draft) {
                          auto& p = points(draft[0]);
                          p.insert(p.begin(), Vector(9, 9, 9));
                      }),
                HasSubstr("-points {{9 9 9} {0 0 0} {1.50 0 0} {0 1 0}  {0 0 1}}}\n"));
    EXPECT_THAT(after(tetra,
                      [](auto& draft) {
                          auto& p = points(draft[0]);
                          p.push_back({1, 1, 1});
                          p.erase(p.begin() + 1);
                          p.push_back({2, 2, 2});
                      }),
                HasSubstr("-points {{0 0 0} {0 1 0} {0 0 1} {1 1 1} {2 2 2}}}\n"));
}

TEST(ShapeEditTest, ASphereIsMovedAndResized) {
    EXPECT_THAT(after(tetra,
                      [](auto& draft) {
                          draft[1].part.position = {2, 3, 0};
                          draft[1].part.shape = scene::SphereShape{0.75};
                      }),
                HasSubstr("  -sub {-pos {2 3 0} -sphere 0.75}\n}"));
    EXPECT_THAT(after("shape_set s -desc {-sub {-sphere 1}}\n",
                      [](auto& draft) {
                          draft[0].part.position = {0, 1, 0};
                      }),
                HasSubstr("{-sub {-pos {0 1 0} -sphere 1}}"));
}

TEST(ShapeEditTest, PartsAreAddedInTheStyleOfTheOthersAndDeleted) {
    scene::Part box;
    box.shape = scene::BoxShape{{1, 2, 3}};
    const auto add = [&](auto& draft) { draft.push_back({box, std::nullopt}); };
    EXPECT_THAT(after(tetra, add), HasSubstr("-sphere 0.5}\n  -sub {-box {1 2 3}}\n}\nbody"));
    EXPECT_EQ(after("shape_set s -desc {-sub {-sphere 1}}\n", add),
              "shape_set s -desc {-sub {-sphere 1} -sub {-box {1 2 3}}}\n");
    EXPECT_EQ(after(tetra, [](auto& draft) { draft.erase(draft.begin()); }),
              "# four corners\nshape_set t -desc {\n"
              "  -sub {-pos {2 0 0} -sphere 0.5}\n}\nbody b t\n");
    EXPECT_EQ(after(tetra, [](auto& draft) { draft.pop_back(); }),
              "# four corners\nshape_set t -desc {\n"
              "  -sub {-color red  -points {{0 0 0} {1.50 0 0} {0 1 0}  {0 0 1}}}\n}\nbody b t\n");
    EXPECT_THAT(after(tetra, [](auto& draft) { draft.clear(); }), HasSubstr("one part at least"));
}

// All other bytes of a round part stay, and -plane has no value.
TEST(ShapeEditTest, RoundPartsAreWrittenInTheirSizes) {
    const std::string wheel = "shape_set w -desc {-sub {-pos {1  0 0} -cylinder {0.5  0.20}}}\n";
    EXPECT_EQ(after(wheel,
                    [](auto& draft) {
                        draft[0].part = withSizes(draft[0].part, {0.75, 0.2});
                    }),
              "shape_set w -desc {-sub {-pos {1  0 0} -cylinder {0.75  0.20}}}\n");
    EXPECT_EQ(after(wheel, [](auto& draft) { draft[0].part.shape = scene::PlaneShape{}; }),
              "shape_set w -desc {-sub {-pos {1  0 0} -plane}}\n");
    const std::string floor = "shape_set f -desc {-sub {-plane -pos {0  1 0}}}\n";
    EXPECT_EQ(after(floor,
                    [](auto& draft) {
                        draft[0].part.position = {0, 2, 0};
                    }),
              "shape_set f -desc {-sub {-plane -pos {0  2 0}}}\n");
    EXPECT_EQ(after(floor, [](auto& draft) { draft[0].part.shape = scene::SphereShape{2}; }),
              "shape_set f -desc {-sub {-sphere 2 -pos {0  1 0}}}\n");
    EXPECT_THAT(after(floor,
                      [](auto& draft) {
                          for (const auto& part : {cone(1, 2), capsule(1, 2), ellipsoid({1, 2, 3}),
                                                   tube(1, 2, 3), bowl(1, 2)})
                              draft.push_back({part, std::nullopt});
                      }),
                HasSubstr("-sub {-cone {1 2}} -sub {-capsule {1 2}} -sub {-ellipsoid {1 2 3}} "
                          "-sub {-tube {1 2 3}} -sub {-bowl {1 2}}"));
}

// What goes together is one stretch of the text, wherever it stands.
TEST(ShapeEditTest, NeighboursAreDeletedTogether) {
    scene::Part box;
    box.shape = scene::BoxShape{{1, 2, 3}};
    const std::string three =
        "shape_set s -desc {-sub {-sphere 1} -sub {-sphere 2}\n -sub {-sphere 3}}\n";
    EXPECT_EQ(after(three, [](auto& draft) { draft.erase(draft.begin(), draft.begin() + 2); }),
              "shape_set s -desc {-sub {-sphere 3}}\n");
    EXPECT_EQ(after(three, [](auto& draft) { draft.erase(draft.begin() + 1, draft.end()); }),
              "shape_set s -desc {-sub {-sphere 1}}\n");
    EXPECT_EQ(after(three,
                    [&](auto& draft) {
                        draft = {{box, std::nullopt}};
                    }),
              "shape_set s -desc {-sub {-box {1 2 3}}}\n");
    EXPECT_EQ(after("shape_set s -desc { -sub {-sphere 1} }\n",
                    [&](auto& draft) {
                        draft = {{box, std::nullopt}};
                    }),
              "shape_set s -desc { -sub {-box {1 2 3}} }\n");
    EXPECT_EQ(after(three,
                    [&](auto& draft) {
                        draft.pop_back();
                        draft.push_back({box, std::nullopt});
                    }),
              "shape_set s -desc {-sub {-sphere 1} -sub {-sphere 2}\n -sub {-box {1 2 3}}}\n");
    const std::string hull = "-face {{0 0 0} {1 0 0} {0 1 0}} -face {{0 0 0} {0 0 1} {1 0 0}} "
                             "-face {{0 0 0} {0 1 0} {0 0 1}} -face {{1 0 0} {0 0 1} {0 1 0}}";
    EXPECT_EQ(after("shape_set f -desc {" + hull + " -sub {-sphere 1}}\n",
                    [](auto& draft) { draft.erase(draft.begin()); }),
              "shape_set f -desc {-sub {-sphere 1}}\n");
}

TEST(ShapeEditTest, AColourGoesWhileAPlaceComes) {
    EXPECT_EQ(after("shape_set s -desc {-sub { -color red -sphere 1}}\n",
                    [](auto& draft) {
                        draft[0].part.appearance.color.reset();
                        draft[0].part.position = {0, 1, 0};
                    }),
              "shape_set s -desc {-sub { -pos {0 1 0}  -sphere 1}}\n");
}

const std::string faces = "shape_set f -desc {-face {-color red {0 0 0} {1 0 0} {0 1 0}} -face {{0 "
                          "0 0} {0 0 1} {1 0 0}}\n"
                          "  -face {{0 0 0} {0 1 0} {0 0 1}} -face {{1 0 0} {0 0 1} {0 1 0}}}\n";

TEST(ShapeEditTest, FacesStayWhileTheirVerticesMove) {
    EXPECT_EQ(after(faces,
                    [](auto& draft) {
                        for (Vector& p : points(draft[0]))
                            if (p == Vector(0, 0, 1))
                                p = {0, 0, 2};
                    }),
              "shape_set f -desc {-face {-color red {0 0 0} {1 0 0} {0 1 0}} "
              "-face {{0 0 0} {0 0 2} {1 0 0}}\n"
              "  -face {{0 0 0} {0 1 0} {0 0 2}} -face {{1 0 0} {0 0 2} {0 1 0}}}\n");
}

TEST(ShapeEditTest, FacesWithAnotherVertexAreWrittenAsPoints) {
    EXPECT_EQ(after(faces,
                    [](auto& draft) {
                        points(draft[0]) = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}};
                    }),
              "shape_set f -desc {-sub {-color {1 0 0} -points {{0 0 0} {1 0 0} {0 1 0} {0 0 1} {1 "
              "1 1}}}}\n");
}

TEST(ShapeEditTest, AVariableIsChangedWhereItIsSet) {
    EXPECT_EQ(after("set d {-sub {-sphere 1}}\nshape_set s -desc $d\n",
                    [](auto& draft) { draft[0].part.shape = scene::SphereShape{2}; }),
              "set d {-sub {-sphere 2}}\nshape_set s -desc $d\n");
}

TEST(ShapeEditTest, WhatIsComputedSaysSoAndCanBeWrittenOut) {
    const std::string text = "set r 1\nshape_set s -desc \"-sub {-sphere [expr {2 * $r}]}\"\n";
    const auto scene = readScene(text);
    auto draft = draftOf(scene->shapeSets.at(0));
    draft[0].part.shape = scene::SphereShape{3};
    const Answer answer = become(text, scene, 0, draft);
    EXPECT_THAT(answer.reason, HasSubstr("-desc of shape set \"s\" is computed"));
    ASSERT_EQ(answer.offers.size(), 1U);
    EXPECT_EQ(text::applied(text, answer.offers[0].edits),
              "set r 1\nshape_set s -desc {-sub {-sphere 3}}\n");
}

TEST(ShapeEditTest, AColourIsWrittenChangedAndTakenAway) {
    const auto colour = [](std::optional<scene::Color> color) {
        return [color](auto& draft) { draft[0].part.appearance.color = color; };
    };
    EXPECT_THAT(after(tetra, colour(scene::Color{0, 0.5, 1})),
                HasSubstr("  -sub {-color {0 0.5 1}  -points {{0"));
    EXPECT_THAT(after(tetra, colour(std::nullopt)), HasSubstr("  -sub {  -points {{0"));
    EXPECT_EQ(after("shape_set s -desc {-sub {-sphere 1}}\n", colour(scene::Color{1, 0, 0})),
              "shape_set s -desc {-sub {-color {1 0 0} -sphere 1}}\n");
}

TEST(ShapeEditTest, ANameChangesWhereItIsUsed) {
    const auto rename = [](const std::string& text) {
        const Answer answer = renamed(text, *readScene(text), 0, "n");
        return answer.possible() ? text::applied(text, answer.edits) : answer.reason;
    };
    EXPECT_EQ(rename("shape_set {s} -desc {-sub {-sphere 1}} ;# s\nbody a s\n"
                     "foreach i {1 2} {body b$i -init_pos \"0 0 $i\" -shape s}\n"),
              "shape_set n -desc {-sub {-sphere 1}} ;# s\nbody a n\n"
              "foreach i {1 2} {body b$i -init_pos \"0 0 $i\" -shape n}\n");
    EXPECT_EQ(rename("set k s\nshape_set s -desc {-sub {-sphere 1}}\nbody a $k\n"),
              "The shape of body \"a\" in line 3 is computed; its name can be changed in the "
              "text.");
}

TEST(ShapePointsTest, AreWhatOneTakesHoldOf) {
    scene::Part ball = sphere(2);
    ball.position = {1, 0, 0};
    EXPECT_EQ(pointsOf(ball).size(), 2U);
    EXPECT_EQ(pointsOf(ball)[1], Vector(3, 0, 0));
    EXPECT_EQ(std::get<scene::SphereShape>(withPoint(ball, 1, {1, 3, 0}).shape).radius, 3);
    EXPECT_EQ(withPoint(ball, 0, {5, 5, 5}).position, Vector(5, 5, 5));
    // A vertex of four faces is one point, and moves in all.
    const auto cut = readScene(faces)->shapeSets[0].parts[0];
    ASSERT_EQ(pointsOf(cut).size(), 4U);
    const scene::Part moved = withPoint(cut, 3, {0, 0, 5});
    EXPECT_EQ(std::ranges::count(std::get<scene::HullShape>(moved.shape).points, Vector(0, 0, 5)),
              3);
}

TEST(ShapePointsTest, OfRoundPartsSetTheirSizes) {
    for (scene::Part part : {cylinder(1, 2), cone(1, 2), capsule(1, 2), ellipsoid({1, 2, 3}),
                             tube(1, 2, 3), bowl(1, 2)}) {
        part.position = {1, 2, 3};
        part.rotation = {0.3, -1, 0.5};
        const auto points = pointsOf(part);
        ASSERT_EQ(points.size(), sizesOf(part).size() + 1);
        for (std::size_t i = 0; i < points.size(); ++i) {
            const auto same = sizesOf(withPoint(part, i, points[i]));
            for (std::size_t k = 0; k < same.size(); ++k)
                EXPECT_NEAR(same[k], sizesOf(part)[k], 1e-14);
        }
        const Vector out = points[0] + 1.5 * (points[1] - points[0]);
        EXPECT_NEAR(sizesOf(withPoint(part, 1, out))[0], 1.5, 1e-14);
        EXPECT_GT(sizesOf(withPoint(part, 2, points[0]))[1], 0);
    }
    EXPECT_EQ(pointsOf(plane()).size(), 1U);
    EXPECT_EQ(withPoint(plane(), 0, {0, 3, 0}).position, Vector(0, 3, 0));
}

TEST(ShapePointsTest, ABoxGrowsFromTheOppositeCorner) {
    scene::Part part = box({2, 2, 2});
    part.rotation = {0, 0, 1.5707963267948966}; // x goes to y
    const auto before = pointsOf(part);
    const scene::Part after = withPoint(part, 8, before[8] + Vector(1, 0, 0));
    EXPECT_LT((pointsOf(after)[1] - before[1]).norm(), 1e-12);
    EXPECT_LT((pointsOf(after)[8] - before[8] - Vector(1, 0, 0)).norm(), 1e-12);
    const scene::Part flat = withPoint(part, 8, before[1] - Vector(1, 1, 1));
    EXPECT_GT(std::get<scene::BoxShape>(flat.shape).edges.minCoeff(), 0); // never inside out
}

TEST(ShapePointsTest, InnerPointsAreFoundAndDropped) {
    scene::Part part = tetrahedron(2);
    part = withNewPoint(withNewPoint(part, {0.1, 0, 0}), {2, 2, -2});
    EXPECT_EQ(innerPoints(part), (std::vector<bool>{false, false, false, false, true, false}));
    EXPECT_EQ(pointsOf(withoutInnerPoints(part)).size(), 5U);
    EXPECT_EQ(pointsOf(withoutPoint(part, 5)).size(), 5U);
    EXPECT_EQ(withoutPoint(tetrahedron(1), 0), tetrahedron(1)); // would be flat
}

TEST(ShapeLibraryTest, EveryShapeIsOneThatTheLanguageTakes) {
    for (const LibraryShape& shape : shapeLibrary()) {
        const auto parts = readScene(shapeSetText("s", shape.parts))->shapeSets.at(0).parts;
        EXPECT_EQ(parts, shape.parts) << shape.name;
        for (const scene::Part& part : parts) {
            const std::vector<bool> inner = innerPoints(part);
            EXPECT_TRUE(std::ranges::none_of(inner, std::identity())) << shape.name;
        }
    }
}

// Its number for a height is that of the floor below it, and of its top, 1 above.
TEST(ShapeLibraryTest, ATableStandsAtItsOrigin) {
    Eigen::AlignedBox3d box;
    for (const scene::Part& part : libraryShape("Table").parts) {
        const Vector half = std::get<scene::BoxShape>(part.shape).edges / 2;
        box.extend(Eigen::AlignedBox3d(part.position - half, part.position + half));
    }
    EXPECT_NEAR(box.min().y(), 0, 1e-12);
    EXPECT_NEAR(box.max().y(), 1, 1e-12);
}

TEST(ShapeLibraryTest, EverydayThingsComeFirst) {
    const auto place = [](const std::string& name) {
        return &libraryShape(name) - shapeLibrary().data();
    };
    for (const char* everyday :
         {"Ball", "Cube", "Floor", "Table", "Plate", "Rod", "Wheel", "Wedge"})
        for (const char* rare : {"T-handle", "Egg", "Tetrahedron", "Icosahedron"})
            EXPECT_LT(place(everyday), place(rare)) << everyday << ", " << rare;
}

// Its points do not lie in one plane.
bool isSolid(const DraftPart& one) {
    const auto* hull = std::get_if<scene::HullShape>(&one.part.shape);
    return !hull || std::holds_alternative<geometry::Hull>(geometry::convexHull(hull->points));
}

// Whatever becomes of the parts: the text reads as them, and the rest of it stays.
TEST(ShapeEditTest, RandomChangesReadAsTheParts) {
    std::mt19937 random(20261120);
    const auto number = [&] {
        return std::round(100 * std::uniform_real_distribution(-3.0, 3.0)(random)) / 100;
    };
    const auto vector = [&] { return Vector(number(), number(), number()); };
    // Two decimals as well: a sum would end in 1.8199999999999998, which is written as 1.82.
    const auto size = [&] { return std::round(100 * (std::abs(number()) + 1)) / 100; };
    for (std::string text : {tetra, faces}) {
        for (int k = 0; k < 150; ++k) {
            const auto scene = readScene(text);
            auto draft = draftOf(scene->shapeSets.at(0));
            DraftPart& one = draft[random() % draft.size()];
            auto* hull = std::get_if<scene::HullShape>(&one.part.shape);
            switch (random() % 8) {
            case 0:
                if (hull)
                    hull->points[random() % hull->points.size()] = vector();
                break;
            case 1:
                if (hull)
                    hull->points.insert(
                        hull->points.begin() +
                            static_cast<std::ptrdiff_t>(random() % (hull->points.size() + 1)),
                        vector());
                break;
            case 2:
                if (hull && hull->points.size() > 6)
                    hull->points.erase(hull->points.begin() +
                                       static_cast<std::ptrdiff_t>(random() % hull->points.size()));
                break;
            case 3:
                one.part.position = vector();
                break;
            case 4:
                one.part.shape = scene::BoxShape{Vector(size(), size(), size())};
                break;
            case 5: {
                scene::Part part;
                part.shape = scene::HullShape{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
                part.position = vector();
                draft.push_back({part, std::nullopt});
                break;
            }
            case 6:
                one.part.appearance.color =
                    random() % 2 == 0 ? std::optional(scene::Color{0, 0.5, 1}) : std::nullopt;
                one.part.position = vector();
                break;
            default: // some that stand one after another, or all but one
                const std::size_t first = random() % draft.size();
                const std::size_t end = first + 1 + random() % (draft.size() - first);
                if (end - first < draft.size())
                    draft.erase(draft.begin() + static_cast<std::ptrdiff_t>(first),
                                draft.begin() + static_cast<std::ptrdiff_t>(end));
            }
            if (!std::ranges::all_of(draft, isSolid))
                continue; // refused, as it would be in any text
            const Answer answer = become(text, scene, 0, draft);
            ASSERT_TRUE(answer.possible()) << answer.reason << text;
            const std::string now = text::applied(text, answer.edits);
            const auto result = reader().read(now);
            ASSERT_TRUE(result.usable) << result.diagnostics.front().message << text << now;
            const auto& parts = result.scene.shapeSets.at(0).parts;
            ASSERT_EQ(parts.size(), draft.size()) << text << now;
            for (std::size_t i = 0; i < parts.size(); ++i)
                EXPECT_EQ(parts[i], draft[i].part) << text << now;
            text = now;
        }
    }
}

} // namespace
} // namespace editing
