// Many edits in many windows at once, undone and redone, against a plain string and a plain stack.
//
// Seven kinds of edits in six windows of one scene: drafts and numbers in two language viewers,
// handles and sliders in two graphical ones, a trajectory editor, a shape editor. Their gestures
// last: between the moves of one come typing, undo, saving and the moves of others. Of each gesture
// the model is told only which edits it asks for (test_undo_model.h).
//
// ASGARD_UNDO_SEQUENCES and ASGARD_INTERLEAVED_EDITS set how many (a hundredth of what
// tests/edits/undo_at_length.sh asks for otherwise; 0: none), ASGARD_SEED where they begin.
#include "editing/random_corpus.h"
#include "element_edits/deletion.h"
#include "gestures/handle_meaning.h"
#include "point_edits/shape_points.h"
#include "views/test_desk.h"

#include <QMessageBox>
#include <QSlider>
#include <QTemporaryDir>

#include <array>
#include <fstream>
#include <numeric>
#include <sstream>

namespace views {
namespace {

class RandomUndoTest : public testing::Test, protected Desk {
protected:
    static void SetUpTestSuite() { theApplication(); }

    void begin(const std::string& text) {
        handsOff();
        for (std::size_t i = 0; i < texts.size(); ++i)
            drop(i);
        document.reset();
        document.setText(text, "Begin");
        model.begin("", text, document.revision());
        firstRevision = model.revision();
        arrive();
        compare();
    }

    // --- graphical viewers
    void picture(Seen& seen) {
        SceneDisplay& display = seen.display();
        PictureEditing& editing = display.editing();
        if (seen.button == Qt::NoButton && !seen.byKeys)
            return take(seen);
        const std::size_t what = below(8);
        if (what == 0) {
            cancelled(&seen, editing.asked());
            press(display, Qt::Key_Escape);
            seen.byKeys = false; // a button stays down
        } else if (what < 3) {
            const auto asked = editing.asked();
            if (seen.byKeys)
                letGo(display, Qt::Key_Shift);
            else
                send(display, QEvent::MouseButtonRelease, seen.at, seen.button);
            finished(&seen, asked);
            seen.button = Qt::NoButton;
            seen.byKeys = false;
        } else if (what == 3 && editing.dragging()) {
            press(display, std::vector<int>{Qt::Key_Z, Qt::Key_X, Qt::Key_A}[below(3)]);
            previewed(&seen, editing.asked());
        } else if (seen.byKeys) {
            pressArrow(seen);
        } else {
            seen.at = nearby(seen.at);
            send(display, QEvent::MouseMove, seen.at, seen.button);
            previewed(&seen, editing.asked());
        }
    }
    void pressArrow(Seen& seen) {
        press(seen.display(), Qt::Key_Left + static_cast<int>(below(4)), Qt::ShiftModifier);
        previewed(&seen, seen.display().editing().asked());
    }
    void take(Seen& seen) {
        SceneDisplay& display = seen.display();
        const auto& handles = display.handles().handles;
        if (handles.empty())
            return;
        const render::Handle handle = handles[below(handles.size())];
        const std::size_t what = below(8);
        if (what == 0 && document.sceneIsCurrent())
            return remove(seen, handle);
        if (what == 1 && document.sceneIsCurrent()) {
            display.editing().choose(handle.kind, handle.element, handle.part);
            pressArrow(seen);
            seen.byKeys = display.editing().dragging();
            return;
        }
        const bool fromPoint = handle.kind == render::HandleKind::trajectoryPoint && below(3) == 0;
        seen.at = display.fromPixels(display.sight().pixels(handle.place));
        seen.button = fromPoint ? Qt::MiddleButton : Qt::LeftButton;
        send(display, QEvent::MouseButtonPress, seen.at, seen.button);
        if (!display.editing().dragging())
            seen.button = Qt::NoButton;
        else
            ASSERT_EQ(display.editing().asked()->since, model.revision());
    }
    void remove(Seen& seen, const render::Handle& handle) {
        SceneDisplay& display = seen.display();
        display.editing().choose(handle.kind, handle.element, handle.part);
        const auto marked = display.editing().marked();
        ASSERT_TRUE(marked);
        std::vector<editing::Element> elements = document.selected();
        const editing::Element its = gestures::elementOf(*marked);
        if (std::ranges::find(elements, its) == elements.end())
            elements = {its};
        std::string after = model.text();
        bool whole = true; // not only a point of it
        if (marked->kind == render::HandleKind::trajectoryPoint) {
            const editing::TrajectoryEdits edits(model.text(), document.shown().scene,
                                                 marked->element);
            const std::size_t point = gestures::pointOf(edits, *marked);
            const editing::Answer answer = edits.remove(point);
            const auto onCurve =
                std::ranges::count_if(edits.points(), [](const auto& one) { return one.onCurve; });
            if (answer.possible())
                after = text::applied(after, answer.edits);
            whole = !answer.possible() && edits.points()[point].onCurve && onCurve <= 2;
        }
        if (whole)
            if (const auto deletion = editing::deletionOf(model.text(), scene(), elements);
                deletion.possible())
                after = text::applied(after, deletion.edits);
        press(display, Qt::Key_Delete);
        removals += after == model.text() ? 0 : 1;
        model.change(after);
    }
    void slide(Seen& seen) {
        QSlider* held = seen.sliders->slider(QString::fromStdString(seen.slider));
        if (!seen.slider.empty() && (!held || !held->isSliderDown())) {
            seen.slider.clear(); // its parameter is gone
        } else if (!seen.slider.empty() && below(3) == 0) {
            const auto asked = seen.sliders->asked();
            held->setSliderDown(false);
            finished(seen.sliders, asked);
            seen.slider.clear();
        } else if (!seen.slider.empty()) {
            held->setSliderPosition(static_cast<int>(below(1000)));
            previewed(seen.sliders, seen.sliders->asked());
        } else if (!scene().parameters.empty()) {
            seen.slider = scene().parameters[below(scene().parameters.size())].name;
            QSlider* slider = seen.sliders->slider(QString::fromStdString(seen.slider));
            if (slider && slider->isEnabled())
                slider->setSliderDown(true);
            else
                seen.slider.clear();
        }
    }

    // --- the editors of trajectories and shapes
    void curve() {
        if (!graph) {
            const auto& all = scene().trajectories;
            if (all.empty())
                return;
            curves.showTrajectory(QString::fromStdString(all[below(all.size())].name));
            const auto shown =
                std::ranges::find(all, curves.trajectory().toStdString(), &scene::Trajectory::name);
            if (shown == all.end())
                return;
            const auto points = editing::controlPointsOf(shown->curves);
            const int component = static_cast<int>(below(3));
            const auto& point = points[below(points.size())];
            graph = &curves.graph(component);
            graphAt = graph->place(point.time, point.place[component]);
            return send(*graph, QEvent::MouseButtonPress, graphAt, Qt::LeftButton, {});
        }
        const auto asked = curves.asked();
        if (const std::size_t what = below(8); what == 0) {
            press(curves, Qt::Key_Escape);
            cancelled(&curves, asked);
        } else if (what < 3) {
            send(*graph, QEvent::MouseButtonRelease, graphAt, Qt::LeftButton, {});
            finished(&curves, asked);
            graph = nullptr;
        } else {
            graphAt = nearby(graphAt);
            send(*graph, QEvent::MouseMove, graphAt, Qt::LeftButton,
                 below(3) == 0 ? Qt::ShiftModifier : Qt::NoModifier);
            previewed(&curves, curves.asked());
        }
    }
    void shape() {
        ShapeDisplay& display = shapes.display();
        if (!shapeHeld) {
            if (scene().shapeSets.empty())
                return;
            shapes.showShape(
                QString::fromStdString(scene().shapeSets[below(scene().shapeSets.size())].name));
            if (shapes.draft().empty())
                return;
            const auto points =
                editing::pointsOf(shapes.draft()[below(shapes.draft().size())].part);
            shapeAt = display.position(points[below(points.size())]);
            shapeHeld = true;
            return send(display, QEvent::MouseButtonPress, shapeAt, Qt::LeftButton);
        }
        const auto asked = shapes.asked();
        if (const std::size_t what = below(8); what == 0) {
            press(display, Qt::Key_Escape);
            cancelled(&shapes, asked);
        } else if (what < 3) {
            send(display, QEvent::MouseButtonRelease, shapeAt, Qt::LeftButton);
            finished(&shapes, asked);
            shapeHeld = false;
            answerOffers(asked);
        } else {
            shapeAt = nearby(shapeAt);
            send(display, QEvent::MouseMove, shapeAt, Qt::LeftButton);
            previewed(&shapes, shapes.asked());
        }
    }
    void answerOffers(const std::optional<Asked>& asked) {
        for (QMessageBox* box : shapes.findChildren<QMessageBox*>()) {
            const bool taken = below(2) == 0;
            const std::string before = model.text();
            for (QAbstractButton* button : box->buttons())
                if ((box->buttonRole(button) == QMessageBox::AcceptRole) == taken)
                    button->click();
            if (taken)
                model.change(text::applied(before, asked->answer.offers.front().edits));
            delete box;
        }
    }

    // What is held is let go where it is.
    void handsOff() {
        for (std::size_t i = 0; i < texts.size(); ++i)
            endCounting(i);
        for (Seen& seen : scenes) {
            const auto asked = seen.display().editing().asked();
            if (seen.byKeys)
                letGo(seen.display(), Qt::Key_Shift);
            else if (seen.button != Qt::NoButton)
                send(seen.display(), QEvent::MouseButtonRelease, seen.at, seen.button);
            finished(&seen, asked);
            seen.byKeys = false;
            seen.button = Qt::NoButton;
            const auto slid = seen.sliders->asked();
            if (QSlider* held = seen.sliders->slider(QString::fromStdString(seen.slider)))
                held->setSliderDown(false);
            finished(seen.sliders, slid);
            seen.slider.clear();
        }
        if (graph) {
            const auto asked = curves.asked();
            send(*graph, QEvent::MouseButtonRelease, graphAt, Qt::LeftButton, {});
            finished(&curves, asked);
            graph = nullptr;
        }
        if (shapeHeld) {
            const auto asked = shapes.asked();
            send(shapes.display(), QEvent::MouseButtonRelease, shapeAt, Qt::LeftButton);
            finished(&shapes, asked);
            shapeHeld = false;
            answerOffers(asked);
        }
    }

    // --- all together
    void undo() {
        const std::size_t from = below(3);
        if (from < scenes.size() && scenes[from].undo->isEnabled())
            scenes[from].undo->trigger();
        else
            document.undo();
        model.undo();
    }
    void redo() {
        const std::size_t from = below(3);
        if (from < scenes.size() && scenes[from].redo->isEnabled())
            scenes[from].redo->trigger();
        else
            document.redo();
        model.redo();
    }
    void save() {
        const QString path = folder.filePath("scene.al");
        ASSERT_EQ(document.save(path).sentence, "");
        model.endGesture();
        std::ifstream file(path.toStdString(), std::ios::binary);
        std::ostringstream bytes;
        bytes << file.rdbuf();
        ASSERT_EQ(bytes.str(), model.text());
        ASSERT_FALSE(document.isModified());
    }
    enum class Act {
        type,
        update,
        drop,
        undoTyping,
        count,
        endCounting,
        picture,
        slide,
        curve,
        shape,
        save,
        redo,
        undo,
        arrive
    };
    static constexpr std::size_t kinds = static_cast<std::size_t>(Act::arrive) + 1;
    Act any() {
        // A hand mostly goes on, and most others come between its gestures.
        const bool holds = last == Act::count || last == Act::picture || last == Act::slide ||
                           last == Act::curve || last == Act::shape;
        if (holds && below(3) > 0)
            return last;
        which = below(2);
        // Who cannot take hold of anything waits, or takes back what cannot be read.
        if (!document.sceneIsCurrent() && below(2) == 0)
            return meaningOf(model.text())->usable ? Act::arrive : Act::undo;
        static constexpr std::array<std::size_t, kinds> shares = {36, 12, 4,  8, 24, 12, 48,
                                                                  40, 24, 24, 1, 11, 24, 36};
        static constexpr std::size_t all =
            std::accumulate(shares.begin(), shares.end(), std::size_t{0});
        std::size_t kind = 0;
        for (std::size_t at = below(all); at >= shares[kind]; ++kind)
            at -= shares[kind];
        return static_cast<Act>(kind);
    }
    void make(Act act) {
        const std::size_t i = which;
        switch (act) {
        case Act::type:
            return type(i);
        case Act::update:
            return update(i);
        case Act::drop:
            return drop(i);
        case Act::undoTyping:
            return undoTyping(i);
        case Act::count:
            return count(i);
        case Act::endCounting:
            return endCounting(i);
        case Act::picture:
            return picture(scenes[i]);
        case Act::slide:
            return slide(scenes[i]);
        case Act::curve:
            return curve();
        case Act::shape:
            return shape();
        case Act::save:
            return save();
        case Act::redo:
            return redo();
        case Act::undo:
            return undo();
        case Act::arrive:
            return arrive(below(10) == 0);
        }
    }
    // True: it changed the document's text, or a draft.
    bool edit() {
        const int before = model.revision();
        const std::string one = model.drafts[0].text, two = model.drafts[1].text;
        const Act act = last = any();
        make(act);
        compare();
        const bool changed = model.revision() != before || model.drafts[0].text != one ||
                             model.drafts[1].text != two;
        changes[static_cast<std::size_t>(act)] += changed ? 1 : 0;
        return changed;
    }
    // All back, all forth: the first bytes and the last.
    void thereAndBack() {
        handsOff();
        compare();
        while (model.canUndo() && !HasFatalFailure()) {
            document.undo();
            model.undo();
            compare();
        }
        ASSERT_EQ(document.text(), model.first());
        while (model.canRedo() && !HasFatalFailure()) {
            document.redo();
            model.redo();
            compare();
        }
        ASSERT_EQ(document.text(), model.last());
    }

    QTemporaryDir folder;
    std::array<long, kinds> changes{}; // that changed something
    long removals = 0;
    Act last = Act::arrive; // and of which viewer
    std::size_t which = 0;
};

const std::string all = "simulator -finish 2\nshape_set s -desc {-sub {-sphere 1}}\n"
                        "shape_set tip -desc {-sub {-convex {{0 0 0} {2 0 0} {0 2 0} {0 0 2}}}}\n"
                        "parameter g -value 2 -min 0 -max 9 ;# pull\n"
                        "body b1 s -init_pos {-5 0 0} -mass 2 ;# first\n"
                        "body b2 tip -init_pos {  1.50   2e0 +3 } -init_dpos {0 0 1}\n"
                        "force -body b1 -gravitational {0 -9.81 0}\n"
                        "force -body b2 -x {g} -y {-10 * b1.mass} -z 3\n"
                        "link -body1 b1 -offset1 {1 0 0} -x 0 -y 0 -z 0 -tightness 50\n"
                        "lightsource sun -pos {0 5 0} -direction {0 -1 0}\n"
                        "trajectory T -points {{0 1 2 3} {1 4 5 6} {2 7 8 9}}\n";

TEST_F(RandomUndoTest, SequencesOverWindowsUndoToTheFirstBytesAndRedoToTheLast) {
    const auto corpus = editing::corpus();
    const long sequences = setting("ASGARD_UNDO_SEQUENCES", 1000);
    for (long i = 0; i < sequences && !HasFatalFailure(); ++i) {
        begin(below(2) == 0 ? all : corpus[below(corpus.size())].text);
        for (std::size_t steps = 1 + below(16); steps > 0 && !HasFatalFailure(); --steps)
            edit();
        thereAndBack();
        ASSERT_FALSE(HasFatalFailure()) << "sequence " << i;
    }
}

TEST_F(RandomUndoTest, InterleavedEditsInSixWindowsAreTheModels) {
    const auto corpus = editing::corpus();
    const long wanted = setting("ASGARD_INTERLEAVED_EDITS", 10000);
    long since = 200;
    for (long i = 0; i < wanted && !HasFatalFailure(); ++since) {
        // Texts that grew or cannot be read any more make way for a new one, all of it undone
        // first.
        if (model.text().size() > 3000 || since >= 200) {
            if (i > 0)
                thereAndBack();
            begin(below(3) > 0 ? all : corpus[below(corpus.size())].text);
            since = 0;
        }
        i += edit() ? 1 : 0;
        ASSERT_FALSE(HasFatalFailure()) << "edit " << i;
    }
    if (wanted > 0)
        thereAndBack();
    if (wanted < 1000)
        return;
    for (const Act act : {Act::type, Act::update, Act::drop, Act::count, Act::picture, Act::slide,
                          Act::curve, Act::shape, Act::redo, Act::undo})
        EXPECT_GT(changes[static_cast<std::size_t>(act)], wanted / 500) << static_cast<int>(act);
    EXPECT_GT(removals, wanted / 1000);
    EXPECT_GT(model.overtaken(), wanted / 500);
}

} // namespace
} // namespace views
