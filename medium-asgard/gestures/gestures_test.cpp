// (text, gesture, text) without a window: who drags is not known here.
#include "gestures/grasp.h"
#include "gestures/handle_drag.h"
#include "gestures/handle_meaning.h"
#include "gestures/new_point.h"

#include "script/reader.h"

#include <gmock/gmock.h>

namespace gestures {
namespace {

using render::Handle;
using render::HandleKind;
using ::testing::HasSubstr;
using Button = render::CameraControl::Button;

script::Reader& reader() {
    static script::Reader shared;
    return shared;
}

// A scene seen along z, as large as the picture.
class Stage {
public:
    explicit Stage(const std::string& text) { read(text); }

    void read(const std::string& text) {
        text_ = text;
        const script::ReadResult result = reader().read(text);
        EXPECT_TRUE(result.usable) << text;
        scene_ = std::make_shared<const scene::Scene>(result.scene);
    }
    [[nodiscard]] const std::string& text() const { return text_; }
    [[nodiscard]] const scene::Scene& scene() const { return *scene_; }
    [[nodiscard]] Sight sight() const {
        render::Camera camera;
        camera.scale = 0.5;
        return {camera, {800, 800}};
    }
    [[nodiscard]] render::Drawing drawing() const {
        render::Drawing drawing;
        drawing.scene = scene_.get();
        drawing.camera = sight().camera;
        for (bool render::Display::*kind :
             {&render::Display::positionHandles, &render::Display::velocityHandles,
              &render::Display::forceHandles, &render::Display::linkHandles,
              &render::Display::jointHandles, &render::Display::trajectories})
            drawing.display.*kind = true;
        return drawing;
    }
    [[nodiscard]] render::HandleSet handles() const {
        return render::Handles(*scene_, nullptr)
            .at(0, drawing().display, sight().camera, sight().size);
    }
    [[nodiscard]] Handle handle(HandleKind kind, std::size_t part = 0) const {
        for (const Handle& one : handles().handles)
            if (one.kind == kind && one.part == part)
                return one;
        throw std::runtime_error("no such handle");
    }
    Ground ground() {
        return {text_, scene_, nullptr,
                [this](const std::string& text) { previews.push_back(text); },
                [this](const std::string& text, const std::string& label) {
                    finished = text;
                    labels.push_back(label);
                }};
    }
    // In two moves, so that there is something on the way.
    void drag(const Handle& handle, const Vector& to) {
        const Eigen::Vector2d from = sight().pixels(handle.place), target = sight().pixels(to);
        HandleDrag drag(ground(), sight(), handle, from);
        drag.move((from + target) / 2);
        drag.move(target);
        words = drag.words();
        drag.finish();
        read(finished);
    }
    [[nodiscard]] std::optional<Grasp> grasp(Button button, const Vector& at) const {
        return graspAt(drawing(), handles(), sight(), button, sight().pixels(at), handleReach);
    }

    std::vector<std::string> previews, labels;
    std::string finished, words;

private:
    std::string text_;
    std::shared_ptr<const scene::Scene> scene_;
};

const std::string ball = "shape_set ball -desc {-sub {-sphere 0.5}}\n";

// What lies across the line of sight is dragged, and keeps the digits that it has along it.
TEST(Gestures, CoordinatesThatAreNotDraggedKeepTheirDigits) {
    Stage stage("trajectory T -points {{0 -1 0.123456 0.12345} {1 0.5 0 0.12345}}\n");
    stage.drag(stage.handle(HandleKind::trajectoryPoint), {-0.5, 0.123456, 0.12345});
    EXPECT_EQ(stage.text(), "trajectory T -points {{0 -0.5 0.123456 0.12345} {1 0.5 0 0.12345}}\n");
    Stage curves("trajectory T -bezier {{0 1 {-1 0 0.12345} {-0.5 0.1 0.2} {0.1 0.2 0.3} "
                 "{0.5 0 0.12345}}}\n");
    curves.drag(curves.handle(HandleKind::trajectoryPoint, 3), {0.5, 0.25, 0.12345});
    EXPECT_EQ(curves.text(), "trajectory T -bezier {{0 1 {-1 0 0.12345} {-0.5 0.1 0.2} "
                             "{0.1 0.45 0.3} {0.5 0.25 0.12345}}}\n");
}

// The arrow's head of a force's trajectory is dragged to where the arrow has that value.
TEST(Gestures, TheTrajectoryOfAForceIsDraggedByItsArrows) {
    const std::string before = ball + "body b1 ball -init_pos {1 0 0}\n";
    Stage stage(before + "trajectory push -points {{0 0 0 0} {1 0 40 0}}\n"
                         "force -body b1 -trajectory push\n");
    const Handle head = stage.handle(HandleKind::trajectoryPoint, 1);
    EXPECT_LT((head.valueAt(head.place) - Vector(0, 40, 0)).norm(), 1e-9);
    stage.drag(head, head.placeOf({0, 20, 0}));
    EXPECT_EQ(stage.text(), before + "trajectory push -points {{0 0 0 0} {1 0 20 0}}\n"
                                     "force -body b1 -trajectory push\n");
}

TEST(Gestures, ADragIsPreviewsAndOneTextWithALabel) {
    Stage stage(ball + "body b1 ball -init_pos {-1   0 0} ;# left\n");
    stage.drag(stage.handle(HandleKind::position), {0.5, 0.25, 0});
    EXPECT_EQ(stage.text(), ball + "body b1 ball -init_pos {0.5   0.25 0} ;# left\n");
    EXPECT_EQ(stage.previews.size(), 2U);
    EXPECT_EQ(stage.labels, std::vector<std::string>{"Move b1"});
    EXPECT_EQ(stage.words, "b1: position 0.500 0.250 0.000; moved 1.521");
}

TEST(Gestures, WhatAnExpressionMakesStaysAndSaysWhy) {
    const std::string before = ball + "body b1 ball -init_pos [list [expr {1 - 2}] 0 0]\n";
    Stage stage(before);
    stage.drag(stage.handle(HandleKind::position), {0.5, 0, 0});
    EXPECT_EQ(stage.text(), before);
    EXPECT_TRUE(stage.previews.empty());
    EXPECT_THAT(stage.words, HasSubstr("is computed by [expr {1 - 2}]"));
}

static_assert(!std::is_copy_constructible_v<HandleDrag> &&
              !std::is_move_constructible_v<HandleDrag> && !std::is_move_assignable_v<HandleDrag>);

// No text makes one; a gesture on it asks for what is not there, and is told so.
TEST(Gestures, ATrajectoryWithoutPointsHasNoneToBeMoved) {
    scene::Scene scene;
    scene.trajectories.emplace_back().name = "T";
    const Handle handle{.kind = HandleKind::trajectoryPoint};
    const auto wishes = wishesFor(scene, handle, {1, 2, 3}, 0.01, false);
    ASSERT_EQ(wishes.size(), 1U);
    EXPECT_TRUE(wishes[0].path.empty());
    EXPECT_FALSE(
        editing::Mapper("", std::make_shared<const scene::Scene>(scene)).answer(wishes).possible());
}

TEST(Gestures, CancelledTheTextIsAsItWas) {
    const std::string before = ball + "body b1 ball\n";
    Stage stage(before);
    const Handle handle = stage.handle(HandleKind::position);
    HandleDrag drag(stage.ground(), stage.sight(), handle, std::nullopt);
    drag.nudge({30, 0});
    drag.push(20);
    EXPECT_NE(drag.place().x(), 0);
    EXPECT_LT(drag.place().z(), 0); // away from the viewer
    drag.cancel();
    EXPECT_EQ(stage.finished, before);
    EXPECT_EQ(stage.labels, std::vector<std::string>{""});
}

TEST(Gestures, AForceIsDraggedByItsHeadInItsOwnForm) {
    Stage stage(ball + "body b1 ball -mass 2\nforce -body b1 -x 0 -y {-10 * b1.mass} -z 0\n");
    const Handle head = stage.handle(HandleKind::forceHead);
    stage.drag(head, head.base + 0.5 * (head.place - head.base));
    EXPECT_THAT(stage.text(), HasSubstr(" * b1.mass} -z 0\n"));
    const auto& force = std::get<scene::ComponentForce>(stage.scene().forces[0].kind);
    EXPECT_NEAR(std::stod(force.components[1]), -5, 0.1);
}

TEST(Gestures, TheEndOfALinkStaysOnItsBody) {
    Stage stage(ball + "body b1 ball\n"
                       "link -body1 b1 -offset1 {0 0 0.5} -x 1 -y 0 -z 0 -tightness 10\n");
    stage.drag(stage.handle(HandleKind::linkEnd), {0.3, 0, 0.4});
    EXPECT_NEAR(stage.scene().links[0].first.offset->norm(), 0.5, 0.01);
    EXPECT_GT(stage.scene().links[0].first.offset->x(), 0.2);
}

TEST(Gestures, ThePointOfAJointMovesOnBothOfItsBodies) {
    Stage stage(ball +
                "body b1 ball\nbody b2 ball -init_pos {1 0 0} -init_rot {0 0 1.5707963267948966}\n"
                "joint p -type hinge -body1 b1 -offset1 {0.5 0 0} -body2 b2 -offset2 {0 0.5 0}\n");
    stage.drag(stage.handle(HandleKind::jointPoint), {0.5, 0.25, 0});
    EXPECT_THAT(stage.text(), HasSubstr("-offset1 {0.5 0.25 0} -body2 b2 -offset2 {0.25 0.5 0}\n"));
    EXPECT_EQ(stage.words, "p: point 0.500 0.250 0.000; moved 0.25");
    EXPECT_EQ(stage.labels, std::vector<std::string>{"Change the point of p"});
    // Without -offset2 it is where offset1 stands.
    stage.read(ball + "body b1 ball\njoint p -type ball -body1 b1\n");
    stage.drag(stage.handle(HandleKind::jointPoint), {0, 0.75, 0});
    EXPECT_THAT(stage.text(), HasSubstr("joint p -type ball -body1 b1 -offset1 {0 0.75 0}\n"));
}

TEST(Gestures, AnAxisAndBothEndsOfADistanceAreDragged) {
    Stage stage(ball + "body b1 ball\njoint p -type slider -body1 b1 -axis {1 0 0}\n");
    const Handle axis = stage.handle(HandleKind::jointAxis);
    stage.drag(axis, {0, (axis.place - axis.base).norm(), 0});
    EXPECT_THAT(stage.text(), HasSubstr("-axis {0 1 0}\n"));
    stage.read(ball + "body b1 ball\njoint p -type distance -body1 b1 -offset2 {0 1 0}\n");
    stage.drag(stage.handle(HandleKind::jointPoint, 1), {0.5, 1, 0});
    EXPECT_THAT(stage.text(), HasSubstr("-body1 b1 -offset2 {0.5 1 0}\n"));
}

// Its handle stands as far out as the rope is slack; none of a belt.
TEST(Gestures, ARopesLengthIsDraggedAndNoShorterThanItMeasures) {
    const std::string bob = ball + "body bob ball -init_pos {2 0 0}\n";
    const auto dragged = [&](const std::string& rope, double by) {
        Stage stage(bob + "rope r -points {{0 0 0} {bob}}" + rope + "\n");
        const Handle handle = stage.handle(HandleKind::ropeLength, 0);
        stage.drag(handle, handle.place + Vector(by, 0, 0));
        return stage.scene().ropes[0].length.value_or(0);
    };
    EXPECT_NEAR(dragged("", 0.5), 2.5, 0.01); // written where nothing stood
    EXPECT_NEAR(dragged(" -length 2.25", 0.5), 2.75, 0.01);
    EXPECT_NEAR(dragged(" -length 2.25", -0.1), 2.15, 0.01);
    EXPECT_EQ(dragged(" -length 2.25", -1), 2);
    Stage slack(bob + "rope r -points {{0 0 0} {bob}} -length 2.25\n");
    Stage taut(bob + "rope r -points {{0 0 0} {bob}}\n");
    const Handle handle = slack.handle(HandleKind::ropeLength, 0);
    EXPECT_NEAR(handle.place.x() - taut.handle(HandleKind::ropeLength, 0).place.x(), 0.25, 1e-12);
    EXPECT_EQ(quantityOf(slack.scene(), handle), "length");
}

// However far a limit is dragged, the text can be read, and a hinge has whole degrees.
TEST(Gestures, ALimitLetsTheJointBeWhereItIsAtTheStart) {
    constexpr double degree = M_PI / 180;
    const auto dragged = [](const std::string& joint, std::size_t part, double to) {
        Stage stage(ball + "body b1 ball -init_pos {1 0 0}\njoint p -body1 b1 " + joint + "\n");
        const Handle handle = stage.handle(HandleKind::jointLimit, part);
        const Vector local = handle.frame.toLocal(handle.place);
        stage.drag(handle,
                   handle.frame.toWorld(
                       stage.scene().joints[0].type == scene::JointType::hinge
                           ? Vector(local.norm() * std::cos(to), local.norm() * std::sin(to), 0)
                           : Vector(0, 0, to)));
        return stage.scene().joints[0].coordinates[0];
    };
    const std::string hinge = "-type hinge -offset1 {-1 0 0} -limits ", slider = "-type slider ";
    EXPECT_EQ(dragged(hinge + "{-0.5 0.7}", 0, 1).lower, 0);
    EXPECT_EQ(dragged(hinge + "{-0.5 0.7}", 1, -0.8).upper, 0);
    EXPECT_NEAR(*dragged(hinge + "{-0.5 0.7}", 0, -0.9).lower, -52 * degree, 1e-6);
    EXPECT_NEAR(*dragged(hinge + "{-0.5 0.7} -from 0.7", 0, 0.5).lower, 40 * degree, 1e-6);
    EXPECT_NEAR(*dragged(hinge + "{0 1} -from 0", 1, -0.5).upper, degree, 1e-6);
    // 17 degrees would be written as a little more.
    EXPECT_NEAR(*dragged(hinge + "{-0.5 0.7} -from 0.29670597283903605", 0, 0.5).lower, 16 * degree,
                1e-6);
    const auto rail = dragged(slider + "-axis {1 0 0} -limits {-0.5 1} -from 0.0777", 0, 0.5);
    EXPECT_LE(*rail.lower, 0.0777);
    EXPECT_GT(*rail.lower, 0.05);
    EXPECT_EQ(dragged(slider + "-axis {1 0 0} -limits {-0.5 1}", 1, -2).upper, 0);
}

TEST(Gestures, ButtonsTakeHoldOfHandlesBodiesAndPoints) {
    const Stage stage(ball + "body b1 ball -init_pos {-1 0 0} -init_dpos {0 0.8 0}\n"
                             "trajectory T -points {{0 1 0 0} {1 1 1 0}}\n");
    EXPECT_EQ(stage.grasp(Button::left, stage.handle(HandleKind::velocity).place)->handle.kind,
              HandleKind::velocity);
    EXPECT_EQ(stage.grasp(Button::left, {-1, 0, 0})->handle.kind, HandleKind::position);
    // Beside the handles: the body itself.
    EXPECT_EQ(stage.grasp(Button::left, {-1.3, 0, 0})->handle.kind, HandleKind::position);
    EXPECT_EQ(stage.grasp(Button::middle, {-1.3, 0, 0})->handle.kind, HandleKind::orientation);
    EXPECT_EQ(stage.grasp(Button::right, {-1.3, 0, 0})->what, Grasp::What::roll);
    EXPECT_EQ(stage.grasp(Button::left, {1, 1, 0})->what, Grasp::What::drag);
    EXPECT_EQ(stage.grasp(Button::middle, {1, 1, 0})->what, Grasp::What::newPoint);
    EXPECT_EQ(stage.grasp(Button::right, {1, 1, 0})->what, Grasp::What::removePoint);
    EXPECT_FALSE(stage.grasp(Button::left, {0, -1.5, 0}));
}

TEST(Gestures, ANewPointComesBeforeOrAfterByTheDirection) {
    Stage stage(ball + "body b1 ball\ntrajectory T -points {{0 -1 0 0} {1 0 0 0} {2 1 0 0}}\n");
    const Handle middle = stage.handle(HandleKind::trajectoryPoint, 1);
    NewPoint point(stage.ground(), stage.sight(), middle);
    point.move(stage.sight().pixels({0.5, 0.25, 0}));
    EXPECT_EQ(point.words(), "T: new point at 1.5 s: 0.5 0.25 0");
    point.finish();
    stage.read(stage.finished);
    ASSERT_EQ(stage.scene().trajectories[0].points.size(), 4U);
    EXPECT_EQ(stage.scene().trajectories[0].points[2].first, 1.5);
    EXPECT_EQ(stage.labels, std::vector<std::string>{"New point of T"});
}

} // namespace
} // namespace gestures
