// Texts of documents and media are shown as they are written: no widget takes them for markup.
#include "window/window_testing.h"

#include <QTreeWidget>

namespace window {
namespace {

// A reader that takes this for HTML reads a file that never ends.
const QByteArray hostile = "<img src=\"/dev/zero\">";

// Every label that shows something has its format set, and no tip is HTML with a picture.
void expectPlain(const QWidget& window) {
    for (const QLabel* label : window.findChildren<QLabel*>())
        EXPECT_TRUE(label->text().isEmpty() || label->textFormat() == Qt::PlainText)
            << label->text().toStdString();
    for (const QWidget* widget : window.findChildren<QWidget*>())
        EXPECT_FALSE(Qt::mightBeRichText(widget->toolTip()) && widget->toolTip().contains("<img"))
            << widget->toolTip().toStdString();
    for (const QAction* action : window.findChildren<QAction*>())
        EXPECT_FALSE(Qt::mightBeRichText(action->toolTip()) && action->toolTip().contains("<img"))
            << action->toolTip().toStdString();
}

TEST_F(WindowTest, AFaultIsTheTextThatItIs) {
    DocumentWindow* window = open(memo(scripted("fault 1 1 " + hostile + " & more")));
    auto* list = window->findChild<QTreeWidget*>();
    ASSERT_TRUE(waitFor([&] { return list->topLevelItemCount() == 1; }));
    const QTreeWidgetItem* item = list->topLevelItem(0);
    EXPECT_EQ(item->text(1), hostile + " & more");
    EXPECT_FALSE(item->toolTip(1).contains("<img"));
    expectPlain(*window);
}

TEST_F(WindowTest, AMediumsMenuHasNoMarkupAndNoKeysOfItsOwn) {
    DocumentWindow* window =
        open(memo(scripted("duration 5\nmenu " + hostile + " & [*] more\ncolour 20A040")));
    const auto entry = [&]() -> QAction* {
        for (QAction* action : window->findChildren<QAction*>())
            if (action->text().startsWith("<img"))
                return action;
        return nullptr;
    };
    ASSERT_TRUE(waitFor([&] { return entry() != nullptr; }));
    EXPECT_EQ(entry()->text(), hostile + " && [*] more");
    EXPECT_TRUE(Qt::mightBeRichText(entry()->toolTip())); // escaped, and so shown as it is
    EXPECT_TRUE(entry()->toolTip().contains("&lt;img"));
    expectPlain(*window);
}

TEST_F(WindowTest, ANameOfAFileIsATitleAsItIs) {
    const QString name = folder_.filePath("a & b[*] <b>.ens");
    QFile file(name);
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(memo({}));
    file.close();
    DocumentWindow* window = application_.open(name);
    ASSERT_TRUE(window);
    EXPECT_TRUE(window->windowTitle().contains("a & b[*][*] <b>.ens"));
    for (QMenu* menu : window->findChildren<QMenu*>())
        Q_EMIT menu->aboutToShow();
    bool isListed = false;
    for (const QAction* action : window->findChildren<QAction*>())
        isListed |= action->text() == "a && b[*] <b>.ens";
    EXPECT_TRUE(isListed);
    expectPlain(*window);
}

TEST_F(WindowTest, AQuestionBeforeALinkShowsTheHostThatIsAsked) {
    DocumentWindow* window = open(memo({}));
    const auto asked = [&](const QString& target) {
        QString shown;
        QTimer timer;
        timer.setInterval(5);
        QObject::connect(&timer, &QTimer::timeout, window, [&] {
            auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
            if (!box)
                return;
            timer.stop();
            expectPlain(*box);
            shown = box->text();
            box->button(QMessageBox::No)->click();
        });
        timer.start();
        Q_EMIT window->view().linkActivated(target);
        return shown;
    };
    EXPECT_EQ(asked("https://evil.example/<b>https://bank.example</b><img src=\"/dev/zero\">"),
              "Open https://evil.example?");
    EXPECT_EQ(asked("https://bank.example@evil.example"), "Open https://evil.example?");
    EXPECT_EQ(asked("file:///etc/passwd"), QString()); // no question, and nothing opened
}

} // namespace
} // namespace window
