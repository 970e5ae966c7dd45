// Many edits in many viewers, undone and redone, against a model that keeps all texts.
//
// Six viewers work on one scene: two language viewers' drafts, two pictures, the sliders, the
// trajectory editor. The model of the document is the list of its texts; that of a draft is what
// was typed, merged with what others did. ASGARD_UNDO_SEQUENCES and ASGARD_INTERLEAVED_EDITS set
// how many (a hundredth of what tests/edits/undo_at_length.sh asks for otherwise), ASGARD_SEED
// where they begin.
#include "editing/random_corpus.h"
#include "gestures/grasp.h"
#include "gestures/handle_drag.h"
#include "gestures/new_point.h"
#include "views/draft.h"
#include "views/number_drag.h"
#include "views/parameters_panel.h"
#include "views/test_workshop.h"
#include "views/trajectory_drag.h"

#include <gmock/gmock.h>

#include <QTemporaryDir>

#include <cstdlib>
#include <fstream>
#include <random>
#include <sstream>

namespace views {
namespace {

long setting(const char* name, long otherwise) {
    const char* text = std::getenv(name);
    return text ? std::atol(text) : otherwise;
}

// A language viewer's draft, and what it should say.
struct Viewer {
    explicit Viewer(SceneDocument& document)
        : draft(editor, document), numbers(editor, document, draft) {}
    SceneEditor editor;
    Draft draft;
    NumberDrag numbers;
    std::string base, text;
};

class RandomUndoTest : public testing::Test {
protected:
    static void SetUpTestSuite() { theApplication(); }

    RandomUndoTest() {
        for (Viewer* viewer : {&one, &two})
            viewer->base = viewer->text = document.text();
        QObject::connect(&document, &SceneDocument::textChanged, [this] { follow(); });
    }

    std::size_t below(std::size_t n) {
        return std::uniform_int_distribution<std::size_t>(0, n - 1)(random);
    }
    double number(double size) {
        return std::uniform_real_distribution<double>(-size, size)(random);
    }

    // --- the model
    void begin(const std::string& text) {
        for (Viewer* viewer : {&one, &two})
            drop(*viewer);
        document.reset();
        document.setText(text, "Begin");
        texts = {"", text};
        at = 1;
        became(text);
    }
    // What anyone's gesture, typing or undo made of the document, on its way too.
    void follow() {
        const std::string& text = document.text();
        for (Viewer* viewer : {&one, &two}) {
            if (viewer->text == viewer->base || viewer->text == text)
                viewer->text = text;
            else
                viewer->text = editing::applied(
                    viewer->text, editing::merged(viewer->base, viewer->text, text).edits);
            viewer->base = text;
        }
    }
    void became(const std::string& text) {
        ASSERT_EQ(document.text(), text);
        for (const Viewer* viewer : {&one, &two}) {
            ASSERT_EQ(viewer->editor.bytes(), viewer->text);
            ASSERT_EQ(viewer->draft.edited(), viewer->text != text);
        }
    }
    // One step of undo, or none where the text is as it was.
    void changed(const std::string& text) {
        if (text != texts[at]) {
            texts.resize(++at);
            texts.push_back(text);
        }
        became(text);
        ASSERT_EQ(document.canUndo(), at > 0);
        ASSERT_EQ(document.canRedo(), at + 1 < texts.size());
    }

    // --- the scene, when it can be had
    bool ready() {
        if (document.sceneIsCurrent())
            return !document.shown().scene->bodies.empty();
        const script::ReadResult read = theReader().read(document.text());
        Computed computed;
        computed.shown.scene =
            read.usable ? std::make_shared<const scene::Scene>(read.scene) : document.shown().scene;
        computed.diagnostics = read.diagnostics;
        computed.current = read.usable;
        document.setComputed(computed);
        return read.usable && !read.scene.bodies.empty();
    }
    const scene::Scene& scene() { return *document.shown().scene; }

    // --- what the viewers do
    void type(Viewer& viewer) {
        static const std::vector<std::string> pieces = {
            "# \xc3\xa4\n", " ", "1", "\n", "x", ";", "2.5", "set q 3\n", "# {n}\n", "\t"};
        const std::string before = viewer.text;
        std::size_t from = below(before.size() + 1);
        while (from > 0 && from < before.size() && (before[from] & 0xC0) == 0x80)
            --from;
        std::size_t to = std::min(before.size(), from + (below(3) == 0 ? below(4) : 0));
        while (to < before.size() && (before[to] & 0xC0) == 0x80)
            ++to;
        const std::string& piece = pieces[below(pieces.size())];
        viewer.editor.replace({from, to}, piece);
        viewer.text = before.substr(0, from) + piece + before.substr(to);
        ASSERT_EQ(viewer.editor.bytes(), viewer.text);
        ASSERT_EQ(viewer.draft.edited(), viewer.text != viewer.base);
    }
    void submit(Viewer& viewer) {
        const std::string text = viewer.text;
        viewer.draft.submit();
        changed(text);
    }
    void drop(Viewer& viewer) {
        viewer.draft.drop();
        viewer.text = viewer.base;
        ASSERT_EQ(viewer.editor.bytes(), viewer.text);
    }
    // Back to where nothing was typed, and forward again: the draft is as it was.
    void undoTyping(Viewer& viewer) {
        const std::string typed = viewer.text;
        int steps = 0;
        for (; viewer.draft.canUndo() && steps < 20; ++steps)
            viewer.draft.undo();
        while (steps-- > 0) {
            ASSERT_TRUE(viewer.draft.canRedo());
            viewer.draft.redo();
        }
        ASSERT_EQ(viewer.editor.bytes(), typed);
        ASSERT_EQ(viewer.draft.edited(), typed != viewer.base);
    }
    void countNumber(Viewer& viewer) {
        const std::size_t place =
            viewer.text.find_first_of("0123456789", below(viewer.text.size() + 1));
        if (place == std::string::npos || viewer.draft.edited())
            return;
        viewer.editor.select({place, place});
        if (!viewer.numbers.count(static_cast<int>(below(9)) - 4))
            return;
        const std::string text = document.text();
        viewer.numbers.finish();
        ASSERT_EQ(text, document.text());
        changed(text);
    }

    gestures::Sight sight(bool fromTheSide) const {
        render::Camera camera;
        camera.scale = fromTheSide ? 0.03 : 0.2;
        if (fromTheSide)
            camera.rotation = render::facing({1, 0.3, 0.2}, {0, 1, 0});
        return {camera, {640, 480}};
    }
    // In several moves; now and then it is given up, or undone while it goes on.
    void drag(bool fromTheSide) {
        if (!ready())
            return;
        render::Display shown;
        for (bool render::Display::*kind :
             {&render::Display::positionHandles, &render::Display::orientationHandles,
              &render::Display::velocityHandles, &render::Display::spinHandles,
              &render::Display::forceHandles, &render::Display::linkHandles,
              &render::Display::lightHandles, &render::Display::trajectories})
            shown.*kind = true;
        const render::HandleSet set = render::Handles(scene(), nullptr).at(0, shown);
        if (set.handles.empty())
            return;
        const render::Handle& handle = set.handles[below(set.handles.size())];
        const std::string before = document.text();
        const auto from = sight(fromTheSide).pixels(handle.place);
        const bool given = below(8) == 0;
        const bool point = handle.kind == render::HandleKind::trajectoryPoint && below(3) == 0;
        const auto go = [&](auto& gesture) {
            for (std::size_t i = 1 + below(3); i > 0; --i)
                gesture.move(from + Eigen::Vector2d(number(80), number(80)));
            if (given)
                gesture.cancel();
            else
                gesture.finish();
        };
        if (point) {
            gestures::NewPoint gesture(document.ground(), sight(fromTheSide), handle);
            go(gesture);
        } else {
            gestures::HandleDrag gesture(document.ground(), sight(fromTheSide), handle, from);
            go(gesture);
        }
        if (given) {
            ASSERT_EQ(document.text(), before);
        }
        changed(document.text());
    }
    void slide() {
        if (!ready() || scene().parameters.empty())
            return;
        QSlider* slider = sliders.slider(QString::fromStdString(scene().parameters[0].name));
        if (!slider || !slider->isEnabled())
            return;
        slider->setSliderDown(true);
        for (std::size_t i = 1 + below(3); i > 0; --i)
            slider->setSliderPosition(
                static_cast<int>(below(static_cast<std::size_t>(slider->maximum()))));
        slider->setSliderDown(false);
        changed(document.text());
    }
    void dragCurve() {
        if (!ready() || scene().trajectories.empty())
            return;
        TrajectoryDrag gesture(document, 0);
        const auto& points = gesture.edits().points();
        if (points.empty())
            return;
        const std::size_t point = below(points.size());
        const std::string before = document.text();
        if (const std::size_t what = below(6); what == 0) {
            (void)gesture.add(points[point].time + number(1), {number(3), number(3), number(3)});
        } else if (what == 1) {
            (void)gesture.remove(point);
        } else {
            for (std::size_t i = 1 + below(3); i > 0; --i)
                gesture.move(point, points[point].time + number(0.3),
                             {number(5), number(5), number(5)}, below(2) == 0);
            if (what == 2) {
                gesture.cancel();
                ASSERT_EQ(document.text(), before);
            } else {
                gesture.finish();
            }
        }
        changed(document.text());
    }
    void undo() {
        document.undo();
        at -= at > 0 ? 1 : 0;
        became(texts[at]);
    }
    void redo() {
        document.redo();
        at += at + 1 < texts.size() ? 1 : 0;
        became(texts[at]);
    }
    void save() {
        const QString path = folder.filePath("scene.al");
        ASSERT_EQ(document.save(path), QString());
        std::ifstream file(path.toStdString(), std::ios::binary);
        std::ostringstream bytes;
        bytes << file.rdbuf();
        ASSERT_EQ(bytes.str(), texts[at]);
        ASSERT_FALSE(document.isModified());
    }

    void act() {
        Viewer& viewer = below(2) == 0 ? one : two;
        switch (below(16)) {
        case 0:
        case 1:
        case 2:
            return type(viewer);
        case 3:
        case 4:
            return submit(viewer);
        case 5:
            return below(3) == 0 ? drop(viewer) : undoTyping(viewer);
        case 6:
            return countNumber(viewer);
        case 7:
        case 8:
            return drag(false);
        case 9:
            return drag(true);
        case 10:
            return slide();
        case 11:
            return dragCurve();
        case 12:
            return below(20) == 0 ? save() : redo();
        case 13:
            return redo();
        default:
            return undo();
        }
    }
    // All back, all forth: the first bytes and the last.
    void thereAndBack() {
        while (at > 0 && !HasFatalFailure())
            undo();
        ASSERT_EQ(document.text(), "");
        ASSERT_FALSE(document.canUndo());
        while (at + 1 < texts.size() && !HasFatalFailure())
            redo();
        ASSERT_EQ(document.text(), texts.back());
        ASSERT_FALSE(document.canRedo());
    }

    std::mt19937_64 random{static_cast<std::uint64_t>(setting("ASGARD_SEED", 1))};
    SceneDocument document{Workshop{}};
    Viewer one{document}, two{document};
    ParametersPanel sliders{document};
    QTemporaryDir folder;
    std::vector<std::string> texts; // all of the document's, undone ones too
    std::size_t at = 0;
};

const std::string all = "simulator -finish 2\nshape_set s -desc {-sub {-sphere 1}}\n"
                        "parameter g -value 2 -min 0 -max 9 ;# pull\n"
                        "body b1 s -init_pos {-5 0 0} -mass 2 ;# first\n"
                        "body b2 s -init_pos {  1.50   2e0 +3 } -init_dpos {0 0 1}\n"
                        "force -body b1 -gravitational {0 -9.81 0}\n"
                        "force -body b2 -x {g} -y {-10 * b1.mass} -z 3\n"
                        "link -body1 b1 -offset1 {1 0 0} -x 0 -y 0 -z 0 -tightness 50\n"
                        "lightsource sun -pos {0 5 0} -direction {0 -1 0}\n"
                        "trajectory T -points {{0 1 2 3} {1 4 5 6} {2 7 8 9}}\n";

TEST_F(RandomUndoTest, SequencesOverViewersUndoToTheFirstBytesAndRedoToTheLast) {
    const auto corpus = editing::corpus();
    const long sequences = setting("ASGARD_UNDO_SEQUENCES", 1000);
    for (long i = 0; i < sequences && !HasFatalFailure(); ++i) {
        begin(below(2) == 0 ? all : corpus[below(corpus.size())].text);
        for (std::size_t steps = 1 + below(8); steps > 0 && !HasFatalFailure(); --steps)
            act();
        thereAndBack();
        ASSERT_FALSE(HasFatalFailure()) << "sequence " << i;
    }
}

TEST_F(RandomUndoTest, InterleavedEditsInSixViewersAreTheModels) {
    begin(all);
    const long edits = setting("ASGARD_INTERLEAVED_EDITS", 10000);
    for (long i = 0; i < edits && !HasFatalFailure(); ++i) {
        act();
        ASSERT_FALSE(HasFatalFailure()) << "edit " << i;
        // Texts that grew or cannot be read any more make way for a new one, all of it undone
        // first.
        if (document.text().size() > 3000 || i % 200 == 199) {
            thereAndBack();
            begin(all);
        }
    }
    thereAndBack();
}

} // namespace
} // namespace views
