// The interface's thread is never held up, however heavy the scene: what it spends between two
// events, in processor time, since the machine may be loaded.
#include "views/editor.h"
#include "views/test_workshop.h"

#include <gtest/gtest.h>

#include <ctime>
#include <iostream>

namespace views {
namespace {

double processorMs() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

// Of what is done under a name the longest piece.
class Pieces {
public:
    void of(const std::string& name, const std::function<void()>& work) {
        const double began = processorMs();
        work();
        double& longest = longest_[name];
        longest = std::max(longest, processorMs() - began);
    }
    // Until all is read and drawn.
    void settle(const std::string& name, SceneDocument& document) {
        ASSERT_TRUE(waitFor([&] {
            of(name, [] { QCoreApplication::processEvents(); });
            return document.work() == Work::none;
        }));
    }
    [[nodiscard]] double longest() const {
        double most = 0;
        for (const auto& [name, ms] : longest_)
            most = std::max(most, ms);
        return most;
    }
    void print() const {
        for (const auto& [name, ms] : longest_)
            std::cout << "    " << name << ": " << ms << " ms\n";
    }

private:
    std::map<std::string, double> longest_;
};

std::string crowd(int bodies) {
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
    void SetUp() override { SceneDisplay::setPatience(std::chrono::milliseconds(12)); }
    void TearDown() override { SceneDisplay::setPatience(std::chrono::seconds(60)); }
};

TEST_F(InterfaceTest, IsNotHeldUpByThousandsOfBodies) {
    TestWorkshop made;
    Editor editor{made.workshop()};
    Pieces pieces;
    SceneDocument& document = editor.document();
    GraphicalViewer* viewer = nullptr;
    pieces.of("open the graphical viewer", [&] { viewer = editor.openGraphicalViewer(); });
    pieces.of("open the language viewer", [&] { editor.openLanguageViewer(); });
    pieces.of("set the text", [&] { document.setText(crowd(3000), "Edit"); });
    pieces.settle("read the text", document);
    SceneDisplay& display = viewer->display();
    render::Display shown = display.display();
    shown.positionHandles = true;
    pieces.of("show handles", [&] { display.setDisplay(shown); });
    ASSERT_TRUE(waitFor([&] {
        pieces.of("draw", [] { QCoreApplication::processEvents(); });
        return display.handles().handles.size() == 3000;
    }));
    const QPoint from = display.fromPixels(display.sight().pixels({30, 20, 0})).toPoint();
    const auto send = [&](QEvent::Type type, QPoint at, Qt::MouseButton button) {
        QMouseEvent event(type, at, display.mapToGlobal(at), button, Qt::LeftButton,
                          Qt::ShiftModifier);
        QApplication::sendEvent(&display, &event);
    };
    pieces.of("press", [&] { send(QEvent::MouseButtonPress, from, Qt::LeftButton); });
    for (int i = 1; i <= 15; ++i) {
        pieces.of("drag", [&] { send(QEvent::MouseMove, from + QPoint(2 * i, i), Qt::NoButton); });
        pieces.of("events while it is dragged", [] { QCoreApplication::processEvents(); });
    }
    pieces.of("release",
              [&] { send(QEvent::MouseButtonRelease, from + QPoint(30, 15), Qt::LeftButton); });
    pieces.settle("events after it", document);
    EXPECT_NE(document.text(), crowd(3000));
    pieces.of("select all", [&] {
        std::vector<editing::Element> all;
        for (std::size_t i = 0; i < 3000; ++i)
            all.push_back({editing::Kind::body, i});
        document.select(all);
        display.repaint();
    });
    pieces.of("undo", [&] { document.undo(); });
    pieces.settle("events after undo", document);
    pieces.of("play", [&] {
        for (int i = 0; i < 1; ++i)
            viewer->playback().seek(0.5);
        QCoreApplication::processEvents();
    });
    EXPECT_EQ(document.text(), crowd(3000));
    pieces.print();
    EXPECT_LT(pieces.longest(), 50);
}

} // namespace
} // namespace views
