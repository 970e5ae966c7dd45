// Where handles and labels stand that would cover each other or leave the picture.
#include "framing/test_scenes.h"
#include "handles/handle_layout.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace render {
namespace {

using Pixels = Eigen::Vector2d;

HandleSet handlesAt(const std::vector<Vector>& places, HandleKind kind) {
    HandleSet set;
    for (const Vector& place : places)
        set.handles.push_back({kind, set.handles.size(), 0, place, place});
    return set;
}

TEST(HandleLayout, HandlesInOnePlaceStandSideBySide) {
    const Size size{640, 480};
    const Camera camera;
    for (const std::size_t count : {2U, 3U, 6U}) {
        HandleSet set = handlesAt(std::vector(count, Vector(0.1, 0.2, 0)), HandleKind::velocity);
        set.handles.push_back({HandleKind::position, 9, 0, {0.1, 0.2, 0}, {0.1, 0.2, 0}});
        set.handles.push_back({HandleKind::position, 9, 0, {-0.5, 0, 0}, {-0.5, 0, 0}});
        spread(set, camera, size);
        EXPECT_TRUE(set.handles[count].aside.isZero()); // the largest stays
        EXPECT_TRUE(set.handles[count + 1].aside.isZero());
        for (std::size_t i = 0; i < set.handles.size(); ++i)
            for (std::size_t j = 0; j < i; ++j)
                EXPECT_GT(
                    (standOf(set.handles[i], camera, size) - standOf(set.handles[j], camera, size))
                        .norm(),
                    8)
                    << count;
    }
}

// A small car has dozens: a few are seen, and come out as one comes nearer.
TEST(HandleLayout, OfALargeCrowdAFewAreSeenUntilOneComesNearer) {
    const Size size{640, 480};
    std::vector<Vector> places;
    for (int i = 0; i < 20; ++i)
        places.emplace_back(0.2 * (i % 5), 0.2 * (i / 5), 0);
    const auto seen = [&](double scale, HandleKind kind) {
        HandleSet set = handlesAt(places, kind);
        spread(set, Camera{.scale = scale}, size);
        const auto count = std::ranges::count(set.handles, false, &Handle::folded);
        const auto labels = std::ranges::count_if(
            set.handles, [](const Handle& one) { return !one.label.empty(); });
        if (kind == HandleKind::velocity) {
            EXPECT_EQ(labels, count < 20 ? 1 : 0) << scale;
        }
        return count;
    };
    EXPECT_EQ(seen(0.01, HandleKind::velocity), 7);
    EXPECT_EQ(seen(1, HandleKind::velocity), 20);
    EXPECT_EQ(seen(0.01, HandleKind::trajectoryPoint), 20); // a path is one
}

double nearest(const HandleSet& set, const Camera& camera, Size size) {
    double least = 1e9;
    for (const Handle& one : set.handles)
        for (const Handle& other : set.handles)
            if (&one != &other && !one.folded && !other.folded)
                least = std::min(
                    least, (standOf(one, camera, size) - standOf(other, camera, size)).norm());
    return least;
}

// Those that are seen stay where they are; the others come out around them.
TEST(HandleLayout, ACrowdThatIsOpenShowsAllOfIt) {
    const Size size{640, 480};
    const Camera camera;
    HandleSet folded = handlesAt(std::vector(25, Vector(0.1, 0.2, 0)), HandleKind::velocity);
    folded.handles.push_back({HandleKind::position, 9, 0, {0.1, 0.2, 0}, {0.1, 0.2, 0}});
    // Another one, where the second ring would be.
    folded.handles.push_back({HandleKind::velocity, 30, 0, {0.25, 0.2, 0}, {0.25, 0.2, 0}});
    HandleSet open = folded;
    spread(folded, camera, size);
    ASSERT_EQ(folded.crowds.size(), 1U);
    EXPECT_FALSE(folded.crowds[0].isOpen);
    EXPECT_EQ(folded.handles[25].label, "+19");
    EXPECT_EQ(folded.crowds[0].largest, folded.handles[25].name());

    spread(open, camera, size, folded.crowds[0].largest);
    ASSERT_EQ(open.crowds.size(), 1U);
    EXPECT_TRUE(open.crowds[0].isOpen);
    EXPECT_GT(open.crowds[0].reach, folded.crowds[0].reach);
    EXPECT_EQ(open.handles[25].label, "");
    EXPECT_EQ(std::ranges::count(open.handles, true, &Handle::folded), 0);
    EXPECT_GT(nearest(open, camera, size), 8);
    for (std::size_t i = 0; i < open.handles.size(); ++i) {
        if (!folded.handles[i].folded) {
            EXPECT_EQ(open.handles[i].aside, folded.handles[i].aside) << i;
        }
        EXPECT_LE((standOf(open.handles[i], camera, size) - open.crowds[0].middle).norm(),
                  i == 26 ? 1e9 : open.crowds[0].reach + 1e-9);
    }
    // Of another crowd, or one that is gone, nothing is open.
    HandleSet other = handlesAt(std::vector(25, Vector(0.1, 0.2, 0)), HandleKind::velocity);
    spread(other, camera, size, HandleName{HandleKind::position, 9, 0});
    EXPECT_EQ(std::ranges::count(other.handles, true, &Handle::folded), 18);
}

TEST(HandleLayout, ACrowdAtTheRimStandsInThePicture) {
    const Size size{640, 480};
    const Camera camera;
    const Vector corner = toWorld(camera, size, {4, 4}, 0);
    HandleSet set = handlesAt(std::vector(25, corner), HandleKind::velocity);
    spread(set, camera, size, set.handles[0].name());
    for (const Handle& one : set.handles) {
        const Pixels stand = standOf(one, camera, size);
        EXPECT_FALSE(one.folded);
        EXPECT_GE(stand.minCoeff(), 0);
        EXPECT_LE(stand.x(), 640);
        EXPECT_LE(stand.y(), 480);
    }
    EXPECT_GT(nearest(set, camera, size), 8);
}

TEST(HandleLayout, HeadsOutsideThePictureAreBroughtInside) {
    const Size size{640, 480};
    Camera camera;
    camera.rotation = geometry::fromRotationVector({0.3, 0.2, 0});
    HandleSet set;
    set.handles.push_back({HandleKind::velocity, 0, 0, {0, 0, 0}, {40, 3, -2}, 2});
    set.handles.push_back({HandleKind::velocity, 1, 0, {0, 0, 0}, {0.4, 0, 0}, 2});
    set.handles.push_back({HandleKind::velocity, 2, 0, {40, 0, 0}, {41, 0, 0}, 2});
    const HandleSet before = set;
    keepInside(set, camera, size);
    const Pixels head = toPixels(camera, size, set.handles[0].place);
    EXPECT_GT(head.x(), 0);
    EXPECT_LT(head.x(), 640);
    EXPECT_TRUE(set.handles[0].cut);
    // It means the same value.
    EXPECT_LT((set.handles[0].place / set.handles[0].perUnit - Vector(20, 1.5, -1)).norm(), 1e-9);
    EXPECT_EQ(set.handles[1].place, before.handles[1].place);
    EXPECT_EQ(set.handles[2].place, before.handles[2].place); // its foot is not seen either
    EXPECT_FALSE(set.handles[1].cut);
}

// A body that fills the picture has handles of its attitude, too.
TEST(HandleLayout, TheHeadsOfAnAttitudeAreBroughtInside) {
    const Size size{640, 480};
    HandleSet set;
    set.handles.push_back({HandleKind::orientation, 0, 0, {0, 0, 0}, {0, 30, 0}, 30});
    keepInside(set, Camera(), size);
    EXPECT_GT(toPixels(Camera(), size, set.handles[0].place).y(), 0);
    EXPECT_NEAR(set.handles[0].place.y() / set.handles[0].perUnit, 1, 1e-9);
}

TEST(HandleLayout, LabelsAvoidEachOther) {
    const Eigen::AlignedBox2d picture(Pixels(0, 0), Pixels(400, 300));
    std::vector<LabelWish> wishes;
    for (const Pixels& point :
         {Pixels(200, 150), Pixels(204, 152), Pixels(206, 148), Pixels(396, 4), Pixels(3, 297)})
        wishes.push_back({point, {50, 14}, 6});
    const auto boxes = placedLabels(wishes, picture);
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        EXPECT_TRUE(picture.contains(boxes[i])) << i;
        EXPECT_LT(boxes[i].squaredExteriorDistance(wishes[i].point), 20 * 20);
        for (std::size_t j = 0; j < i; ++j)
            EXPECT_TRUE(boxes[i].intersection(boxes[j]).isEmpty()) << i << ' ' << j;
    }
    EXPECT_TRUE(placedLabels({}, picture).empty());
}

TEST(HandleLayout, LabelsAvoidOneThatSomebodyPutThereAndLeaveWhatTheyAreOfInSight) {
    const Eigen::AlignedBox2d picture(Pixels(0, 0), Pixels(400, 300));
    LabelWish wish{{200, 150}, {50, 14}, 6, 30, true};
    auto boxes = placedLabels(std::vector{wish}, picture);
    EXPECT_EQ(boxes[0].min(), Pixels(236, 156)); // to the lower right
    LabelWish put{{20, 20}, {50, 14}};
    put.put.emplace(Pixels(240, 120), Pixels(290, 180));
    boxes = placedLabels(std::vector{wish, put}, picture);
    EXPECT_EQ(boxes[1].min(), Pixels(240, 120));
    EXPECT_EQ(boxes[0].max().x(), 164); // on the other side
    boxes = placedLabels(std::vector{wish}, picture, {Eigen::AlignedBox2d(*put.put)});
    EXPECT_EQ(boxes[0].max().x(), 164); // beside what another has taken, too
    wish.point = {-20, 150};
    EXPECT_EQ(placedLabels(std::vector{wish}, picture)[0].min(), Pixels(16, 156)); // it follows
}

} // namespace
} // namespace render
