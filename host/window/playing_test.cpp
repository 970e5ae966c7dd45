// Play begins at the start, and plays everything that is seen and can be played.
#include "window/window_testing.h"

#include <QToolButton>

namespace window {
namespace {

class PlayingTest : public WindowTest {
protected:
    // The play bar of the tool area, when something has time.
    static controls::PlayBar* barOf(DocumentWindow& window) {
        auto* bar = window.findChild<QToolBar*>("tools")->findChild<controls::PlayBar*>();
        return waitFor([&] { return bar->isVisible(); }) ? bar : nullptr;
    }
    static void press(controls::PlayBar& bar) { bar.findChild<QToolButton*>()->click(); }
    static bool isAtPoster(DocumentWindow& window, double poster) {
        return waitFor([&] {
            return hasPicture(window, 0) && live(window, 0).time() &&
                   live(window, 0).time()->time == poster;
        });
    }
    // The times that are told while it plays, from the first on that is not the poster's.
    static bool playsFromTheStart(DocumentWindow& window) {
        return waitFor([&] {
            const ipc::TimeChanged& time = *live(window, 0).time();
            return time.playing && time.time < 25;
        });
    }
};

TEST_F(PlayingTest, TheFirstPlayBeginsAtTheStartByTheBar) {
    DocumentWindow* window = open(memo(scripted("duration 50", "POSTER=\"49.9\"")));
    ASSERT_TRUE(isAtPoster(*window, 49.9));
    controls::PlayBar* bar = barOf(*window);
    ASSERT_TRUE(bar);
    press(*bar);
    EXPECT_TRUE(playsFromTheStart(*window));
}

TEST_F(PlayingTest, TheFirstPlayBeginsAtTheStartByTheMediumsOwnMenu) {
    DocumentWindow* window = open(memo(scripted("duration 50", "POSTER=\"40\"")));
    ASSERT_TRUE(isAtPoster(*window, 40));
    live(*window, 0).invoke("play", nullptr);
    EXPECT_TRUE(playsFromTheStart(*window));
}

TEST_F(PlayingTest, TheFirstPlayBeginsAtTheStartBeforeAnythingIsKnown) {
    DocumentWindow* window = open(memo(scripted("duration 50", "POSTER=\"40\"")));
    application_.playWhenLoaded(window->document());
    ASSERT_TRUE(waitFor([&] { return live(*window, 0).time().has_value(); }));
    EXPECT_TRUE(playsFromTheStart(*window));
}

TEST_F(PlayingTest, WhatWasLookedForByHandIsPlayedFromThere) {
    DocumentWindow* window = open(memo(scripted("duration 50", "POSTER=\"10\"")));
    ASSERT_TRUE(isAtPoster(*window, 10));
    live(*window, 0).seek(30);
    ASSERT_TRUE(isAtPoster(*window, 30));
    live(*window, 0).play();
    ASSERT_TRUE(waitFor([&] { return live(*window, 0).time()->playing; }));
    EXPECT_GE(live(*window, 0).time()->time, 30);
    // So does the second play.
    live(*window, 0).pause();
    ASSERT_TRUE(waitFor([&] { return !live(*window, 0).time()->playing; }));
    live(*window, 0).play();
    ASSERT_TRUE(waitFor([&] { return live(*window, 0).time()->playing; }));
    EXPECT_GE(live(*window, 0).time()->time, 30);
}

TEST_F(PlayingTest, AFaultyFigureBeforeTheOthersIsNoObstacle) {
    DocumentWindow* window = open(memo(scripted("fault 1 1 nothing") + scripted("duration 50")));
    ASSERT_TRUE(waitFor([&] { return hasPicture(*window, 0) && live(*window, 1).time(); }));
    controls::PlayBar* bar = barOf(*window);
    ASSERT_TRUE(bar);
    press(*bar);
    EXPECT_TRUE(waitFor([&] { return live(*window, 1).time()->playing; }));
    // The medium's menu too.
    live(*window, 1).pause();
    ASSERT_TRUE(waitFor([&] { return !live(*window, 1).time()->playing; }));
    window->commands().refresh();
    QAction* play = window->commands().menuOf(nth(*window, 0))->actions().first();
    ASSERT_EQ(play->text(), "Play");
    ASSERT_TRUE(play->isEnabled());
    play->trigger();
    EXPECT_TRUE(waitFor([&] { return live(*window, 1).time()->playing; }));
}

// The medium says what can be done there when it has heard of the click.
TEST_F(PlayingTest, TheMenuAtThePointerHasTheCommandsOfWhatIsThere) {
    DocumentWindow* window = open(memo(scripted("thing Paint It")));
    ASSERT_TRUE(waitFor([&] { return hasPicture(*window, 0); }));
    const QPointF at = window->view().placeOf(nth(*window, 0)).topLeft() + QPointF(60, 60);
    QTest::mouseClick(window->view().viewport(), Qt::RightButton, {}, at.toPoint());
    QMenu* menu = nullptr;
    ASSERT_TRUE(waitFor([&] {
        menu = window->findChild<QMenu*>("figureContext");
        return menu != nullptr;
    }));
    EXPECT_TRUE(std::ranges::any_of(
        menu->actions(), [](const QAction* action) { return action->text() == "Paint It"; }));
    menu->close();
}

// A command that wants to know more asks; it is done when the medium takes what was typed.
TEST_F(PlayingTest, ACommandOfAMediumAsks) {
    DocumentWindow* window = open(memo(scripted("asks How Many")));
    ASSERT_TRUE(waitFor([&] { return hasPicture(*window, 0); }));
    const auto ask = [&]() -> QDialog* {
        window->commands().refresh();
        for (QAction* action : window->commands().menuOf(nth(*window, 0))->actions())
            if (action->text() == "How Many")
                action->trigger();
        QDialog* dialog = nullptr;
        EXPECT_TRUE(waitFor([&] {
            dialog = window->findChild<QDialog*>("questionDialog");
            return dialog && dialog->isVisible();
        }));
        return dialog;
    };
    const auto text = [&] { return window->document().document().text(nth(*window, 0)); };
    QPointer<QDialog> dialog = ask();
    auto* field = dialog->findChild<QLineEdit*>("answer1");
    ASSERT_TRUE(field);
    EXPECT_EQ(field->text(), "1");
    EXPECT_EQ(dialog->windowTitle(), "How many");
    QLabel* refusal = dialog->findChild<QLabel*>("questionRefusal");
    EXPECT_FALSE(refusal->isVisible());
    field->setText("12");
    QTest::keyClick(field, Qt::Key_Return);
    ASSERT_TRUE(waitFor([&] { return refusal->isVisible(); }));
    EXPECT_EQ(refusal->text(), "From 1 to 9, please.");
    EXPECT_EQ(field->text(), "12"); // to be mended
    // While it is typed, the dialog shows the line that it makes; nothing is done yet.
    auto* changes = dialog->findChild<QLabel*>("questionChanges");
    EXPECT_FALSE(changes->isVisible());
    field->selectAll();
    QTest::keyClicks(field, "7");
    ASSERT_TRUE(waitFor([&] { return changes->isVisible(); }));
    EXPECT_TRUE(changes->text().contains("<b>chosen 7</b>")) << changes->text().toStdString();
    EXPECT_FALSE(refusal->isVisible());
    EXPECT_EQ(text().find("chosen"), std::string::npos);
    QTest::keyClicks(field, "7");
    ASSERT_TRUE(waitFor([&] { return refusal->isVisible(); }));
    EXPECT_FALSE(changes->isVisible());
    QTest::keyClick(field, Qt::Key_Backspace);
    QTest::keyClick(field, Qt::Key_Return); // also before the trial is answered
    ASSERT_TRUE(waitFor([&] { return dialog.isNull(); }));
    EXPECT_TRUE(waitFor([&] { return text().ends_with("chosen 7"); }));
    dialog = ask();
    dialog->findChild<QLineEdit*>("answer1")->setText("no");
    dialog->accept();
    QPushButton* way = nullptr;
    ASSERT_TRUE(waitFor([&] {
        for (QPushButton* one : dialog->findChildren<QPushButton*>())
            way = one->text() == "Take 5" ? one : way;
        return way != nullptr;
    }));
    way->click();
    ASSERT_TRUE(waitFor([&] { return dialog.isNull(); }));
    EXPECT_TRUE(waitFor([&] { return text().ends_with("chosen 7\nchosen 5"); }));
    dialog = ask();
    QTest::keyClick(dialog, Qt::Key_Escape);
    EXPECT_TRUE(waitFor([&] { return dialog.isNull(); }));
}

TEST_F(PlayingTest, FiguresOfEveryMediumPlayTogether) {
    const QByteArray second =
        "<PARAGRAPH><DOCUMENT>\nDOCUMENT OTHER\n<OTHER WIDTH=\"300\" HEIGHT=\"200\"><SCRIPT>{"
        "duration 60}</SCRIPT></OTHER>\n</DOCUMENT></PARAGRAPH>\n";
    DocumentWindow* window = open(memo(scripted("duration 50") + second));
    ASSERT_TRUE(waitFor([&] {
        return live(*window, 0).time() && live(*window, 1).time() && hasPicture(*window, 1);
    }));
    EXPECT_NE(live(*window, 0).manifest().documentClass, live(*window, 1).manifest().documentClass);
    controls::PlayBar* bar = barOf(*window);
    ASSERT_TRUE(bar);
    press(*bar);
    EXPECT_TRUE(waitFor(
        [&] { return live(*window, 0).time()->playing && live(*window, 1).time()->playing; }));
    press(*bar); // and stop together
    EXPECT_TRUE(waitFor(
        [&] { return !live(*window, 0).time()->playing && !live(*window, 1).time()->playing; }));
    // The chosen figure is played alone.
    click(*window, 1);
    press(*bar);
    EXPECT_TRUE(waitFor([&] { return live(*window, 1).time()->playing; }));
    EXPECT_FALSE(live(*window, 0).time()->playing);
}

} // namespace
} // namespace window
