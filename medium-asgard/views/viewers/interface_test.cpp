// The interface's thread is never held up, however heavy the scene: what goes through all of a
// scene or of its text is done elsewhere, or once for what happened, however many bodies there are.
// How long it takes is bench/latency's question.
#include "handles/handles.h"
#include "script/structure.h"
#include "viewers/editor.h"
#include "views/test_workshop.h"

#include <gtest/gtest.h>

namespace views {
namespace {

constexpr int bodies = 600;

std::string crowd() {
    std::string text = "simulator -finish 1 -collisions 0\nshape_set ball -desc {-sub {-sphere "
                       "0.3}}\n";
    for (int i = 0; i < bodies; ++i)
        text += "body b" + std::to_string(i) + " ball -init_pos {" + std::to_string(i % 60) + " " +
                std::to_string(i / 60) + " 0} -init_dpos {0 0 1}\n";
    return text;
}

class InterfaceTest : public testing::Test {
protected:
    static void SetUpTestSuite() { theApplication(); }
    void SetUp() override {
        WindowPicture::setPatience(std::chrono::milliseconds(12));
        for (auto signal : {&SceneDocument::sceneChanged, &SceneDocument::motionChanged,
                            &SceneDocument::diagnosticsChanged})
            QObject::connect(&document(), signal, [this] { ++news_; });
        viewer_ = editor_.openGraphicalViewer();
        editor_.openLanguageViewer();
        document().setText(crowd(), "Edit");
        ASSERT_TRUE(settle(document()));
        setsBefore_ = render::Handles::setsComputed();
        render::Display shown = display().display();
        shown.positionHandles = true;
        display().setDisplay(shown);
        ASSERT_TRUE(waitFor([&] { return display().handles().handles.size() == bodies; }));
        news_ = 0;
    }
    void TearDown() override {
        // Nothing is read, simulated or looked for in a picture where windows wait.
        EXPECT_EQ(made_.onTheInterface, 0);
        EXPECT_EQ(render::Handles::setsComputed(), setsBefore_);
        WindowPicture::setPatience(std::chrono::seconds(60));
    }

    SceneDocument& document() { return editor_.document(); }
    SceneDisplay& display() { return viewer_->display(); }
    void send(QEvent::Type type, QPoint at, Qt::MouseButton button) {
        QMouseEvent event(type, at, display().mapToGlobal(at), button, Qt::LeftButton,
                          Qt::ShiftModifier);
        QApplication::sendEvent(&display(), &event);
    }
    // How many times that goes through the whole text.
    static std::size_t structuresOf(const std::function<void()>& work) {
        const std::size_t before = script::structuresMade();
        work();
        return script::structuresMade() - before;
    }
    // The same for what comes of it, for each of the news that came.
    void expectLittleOfNews() {
        const std::size_t all = structuresOf([&] { ASSERT_TRUE(settle(document())); });
        EXPECT_LE(all, 2 * (1 + static_cast<std::size_t>(news_))) << news_ << " news";
    }

    TestWorkshop made_;
    Editor editor_{made_.workshop()};
    GraphicalViewer* viewer_ = nullptr;
    std::size_t setsBefore_ = 0;
    int news_ = 0;
};

TEST_F(InterfaceTest, ADragGoesThroughTheTextOnceForEachWindow) {
    const QPoint from = display().fromPixels(display().sight().pixels({30, 5, 0})).toPoint();
    EXPECT_LE(structuresOf([&] { send(QEvent::MouseButtonPress, from, Qt::LeftButton); }), 2U);
    std::size_t events = 0, most = 0;
    for (int i = 1; i <= 15; ++i) {
        const QPoint at = from + QPoint(2 * i, i);
        most = std::max(most, structuresOf([&] { send(QEvent::MouseMove, at, Qt::NoButton); }));
        events += structuresOf([] { QCoreApplication::processEvents(); });
    }
    EXPECT_NE(document().text(), crowd());
    EXPECT_LE(most, 2U);
    // What is drawn or marked after a move may go through its text once more.
    EXPECT_LE(events, 2 * (15 + static_cast<std::size_t>(news_))) << news_ << " news";
    const QPoint to = from + QPoint(30, 15);
    EXPECT_LE(structuresOf([&] { send(QEvent::MouseButtonRelease, to, Qt::LeftButton); }), 2U);
    expectLittleOfNews();
}

TEST_F(InterfaceTest, SelectingEverythingAndUndoGoThroughTheTextOnceForEachWindow) {
    std::vector<editing::Element> all;
    for (std::size_t i = 0; i < bodies; ++i)
        all.push_back({editing::Kind::body, i});
    EXPECT_LE(structuresOf([&] {
                  document().select(all);
                  display().repaint();
              }),
              2U);
    document().setText(crowd() + "body last ball\n", "Edit");
    EXPECT_LE(structuresOf([&] { document().undo(); }), 2U);
    EXPECT_EQ(document().text(), crowd());
    expectLittleOfNews();
    EXPECT_EQ(document().selected().size(), std::size_t{bodies});
}

TEST_F(InterfaceTest, PlayingDoesNotLookAtTheText) {
    EXPECT_EQ(structuresOf([&] {
                  viewer_->playback().seek(0.5);
                  QCoreApplication::processEvents();
              }),
              0U);
}

} // namespace
} // namespace views
