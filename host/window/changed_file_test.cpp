// A file that another program changes while a window shows it.
#include "window/window_testing.h"

#include <QPushButton>

namespace window {
namespace {

class ChangedFileTest : public WindowTest {
protected:
    static void write(const DocumentWindow& window, const QByteArray& bytes) {
        QFile file(window.document().document().fileName());
        ASSERT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(bytes);
    }
    static QByteArray paragraphs(int from, int to) {
        QByteArray text;
        for (int i = from; i < to; ++i)
            text += "<PARAGRAPH>{paragraph number " + QByteArray::number(i) + "}</PARAGRAPH>\n";
        return text;
    }
};

TEST_F(ChangedFileTest, PagesFollowAndMediaGoOn) {
    const QByteArray body = scripted("figure") + paragraphs(0, 200);
    DocumentWindow* window = open(memo(body));
    ASSERT_TRUE(waitFor([&] { return hasPicture(*window, 0); }));
    const std::vector<pid_t> media = children();
    view::DocumentView& view = window->view();
    view.verticalScrollBar()->setValue(view.verticalScrollBar()->maximum() / 2);
    const int value = view.verticalScrollBar()->value();
    const QByteArray changed = memo(scripted("figure") + paragraphs(900, 905) + paragraphs(0, 200));
    write(*window, changed);
    ASSERT_TRUE(waitFor([&] {
        return window->document().document().bytes() == changed.toStdString() &&
               view.verticalScrollBar()->value() > value; // the words stay where they were
    }));
    EXPECT_EQ(children(), media);
    EXPECT_FALSE(window->isWindowModified());
}

TEST_F(ChangedFileTest, ABarAsksWhereBothChangedTheSame) {
    DocumentWindow* window = open(memo(paragraphs(0, 3)));
    document::Document& of = window->document().document();
    const std::size_t at = of.bytes().find("number 1");
    of.edit({{{at, at + 8}, "number eins"}}, "Edit");
    QByteArray theirs = memo(paragraphs(0, 3));
    theirs.replace("number 1", "number un");
    write(*window, theirs);
    auto* bar = window->findChild<QWidget*>("fileBar");
    ASSERT_TRUE(waitFor([&] { return bar->isVisible(); }));
    EXPECT_TRUE(window->findChild<QLabel*>("fileSentence")->text().contains("also where you"));
    const auto shown = [&](const char* name) {
        QStringList texts;
        for (const QLabel* label : bar->findChildren<QLabel*>(name))
            texts << label->text();
        return texts;
    };
    EXPECT_EQ(shown("choiceMine"), QStringList{"paragraph number eins"});
    EXPECT_EQ(shown("choiceTheirs"), QStringList{"paragraph number un"});
    EXPECT_EQ(shown("choiceLine"), QStringList{QString::number(of.tree().position(at).line)});
    EXPECT_TRUE(window->findChild<QWidget*>("fileChoices")->isVisible());
    window->findChild<QPushButton*>("takeTheirs")->click();
    EXPECT_EQ(of.bytes(), theirs.toStdString());
    EXPECT_FALSE(bar->isVisible());
    EXPECT_FALSE(window->isWindowModified());
}

} // namespace
} // namespace window
