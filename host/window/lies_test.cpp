// The most that media may say, and the window's answers to it. How long the window is held is
// printed and recorded; a test shares its machine, so what is compared is what was done.
#include "window/window_testing.h"

namespace window {
namespace {

class LiesTest : public WindowTest {
protected:
    // Opens a document of a medium that says this when it is asked for its editor, and waits until
    // it has said so.
    DocumentWindow* hear(const QByteArray& lie, const std::function<bool(DocumentWindow&)>& heard) {
        DocumentWindow* window = open(memo(scripted("colour 102030")));
        EXPECT_TRUE(waitFor([&] { return hasPicture(*window, 0); }));
        const Heartbeat beat;
        live(*window, 0).edit({{0, 0, "behave lie " + lie.toStdString() + "\n"}}, {});
        EXPECT_TRUE(waitFor([&] { return heard(*window); })) << lie.toStdString();
        std::printf("%s: longest wait for the event loop: %lld ms\n", lie.constData(),
                    static_cast<long long>(beat.longest()));
        return window;
    }
};

TEST_F(LiesTest, AFullListOfFaultsIsPlacedOnce) {
    DocumentWindow* window = hear("diagnostics 1000 4096", [&](DocumentWindow& of) {
        return of.findChild<panes::FaultsPane*>()->count() == 1000;
    });
    const auto& faults = window->document().faultsOf(nth(*window, 0));
    ASSERT_EQ(faults.size(), 1000u);
    window->view().viewport()->repaint();
    EXPECT_EQ(&window->document().faultsOf(nth(*window, 0)), &faults); // it was kept
    EXPECT_EQ(faults[0].message.size(), 4096);
    window->close();
}

TEST_F(LiesTest, FullMenusAreBuiltAndOnlySomeToolsAreShown) {
    for (const char* what : {"menu", "icons", "groups"}) {
        DocumentWindow* window = hear(QByteArray(what) + " 1000 1024", [&](DocumentWindow& of) {
            QMenu* menu = of.commands().menuOf(nth(of, 0));
            return menu && menu->actions().size() == 1000;
        });
        const auto* tools = window->findChild<QToolBar*>("tools");
        EXPECT_LT(tools->actions().size(), MediumCommands::mostTools + 20); // and the host's own
        const QMenu* menu = window->commands().menuOf(nth(*window, 0));
        EXPECT_LE(menu->findChildren<QMenu*>().size(), MediumCommands::mostGroups);
        window->close();
    }
}

} // namespace
} // namespace window
