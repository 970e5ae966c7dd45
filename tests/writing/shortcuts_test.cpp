// One key means one thing in a window.
#include "writing/writing_testing.h"

#include <QMap>
#include <QStatusBar>

namespace writing {
namespace {

class ShortcutsTest : public WritingTest {
protected:
    // Of all commands that are enabled, those that share a key.
    [[nodiscard]] QStringList shared() const {
        QMap<QString, QStringList> named;
        for (const QAction* action : window_->findChildren<QAction*>())
            for (const QKeySequence& keys : action->shortcuts())
                if (action->isEnabled() && action->shortcutContext() != Qt::WidgetShortcut)
                    named[keys.toString()] << action->objectName() + ' ' + action->text();
        QStringList result;
        for (auto one = named.begin(); one != named.end(); ++one)
            if (one->size() > 1)
                result << one.key() + ": " + one->join(", ");
        return result;
    }
};

TEST_F(ShortcutsTest, NoTwoCommandsShareAKey) {
    write(paragraph("One") + scripted("colour 20A040"));
    EXPECT_EQ(shared(), QStringList());
    ASSERT_TRUE(waitFor([&] { return hasPicture(*window_, 0); }));
    view().choose(nth(*window_, 0));
    EXPECT_EQ(shared(), QStringList());
    view().choose(document::noSubdocument);
    action("write")->trigger();
    ASSERT_FALSE(view().isWriting());
    EXPECT_EQ(shared(), QStringList());
}

// The scripted medium asks for Ctrl+G, which goes to a page in every window.
TEST_F(ShortcutsTest, AMediumGetsTheKeysThatTheWindowDoesNotUse) {
    write(paragraph("One") + scripted("colour 20A040"));
    const auto ofEntry = [&](const QString& label) -> const QAction* {
        for (const QAction* action : window_->findChildren<QAction*>())
            if (action->text() == label)
                return action;
        return nullptr;
    };
    ASSERT_TRUE(waitFor([&] { return ofEntry("Open Editor") != nullptr; }));
    EXPECT_EQ(ofEntry("Open Editor")->shortcut(), QKeySequence());
    EXPECT_EQ(ofEntry("Show Handles")->shortcut(), QKeySequence("Ctrl+Alt+H"));
    EXPECT_EQ(action("goToPage")->shortcut(), QKeySequence("Ctrl+G"));
    EXPECT_EQ(shared(), QStringList());
}

TEST_F(ShortcutsTest, TheOldKeysOfTheClipboardWork) {
    write(paragraph("One two"));
    goTo("two");
    press(Qt::Key_End, Qt::ShiftModifier);
    press(Qt::Key_Insert, Qt::ControlModifier);
    press(Qt::Key_Delete, Qt::ShiftModifier);
    EXPECT_EQ(body(), paragraph("One ").toStdString());
    press(Qt::Key_Insert, Qt::ShiftModifier);
    press(Qt::Key_Insert, Qt::ShiftModifier);
    EXPECT_EQ(body(), paragraph("One twotwo").toStdString());
    goTo("One");
    press(Qt::Key_Delete, Qt::ShiftModifier); // nothing is selected
    EXPECT_EQ(body(), paragraph("One twotwo").toStdString());
}

} // namespace
} // namespace writing
