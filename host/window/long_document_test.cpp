// Long documents and pictures of files: the window lives, and shows what there is.
#include "session/presented.h"
#include "window/window_testing.h"

#include <sys/stat.h>

namespace window {
namespace {

QByteArray paragraphs(int count) {
    QByteArray text;
    for (int i = 0; i < count; ++i)
        text += "<PARAGRAPH>{line " + QByteArray::number(i) + "}</PARAGRAPH>\n";
    return text;
}

TEST_F(WindowTest, ALongDocumentIsShownWhileItIsLaidOut) {
    DocumentWindow* window = open(memo(paragraphs(session::Presented::firstSteps * 3 / 2)));
    view::DocumentView& view = window->view();
    EXPECT_FALSE(view.isLaidOut());
    const std::size_t first = view.pages().pages.size();
    EXPECT_GE(first, 10u);
    EXPECT_GT(view.verticalScrollBar()->maximum(), 0);
    ASSERT_TRUE(waitFor([&] { return view.isLaidOut(); }));
    EXPECT_GT(view.pages().pages.size(), first);
    view.find("line 5999");
    EXPECT_EQ(view.foundCount(), 1);
}

// Pages that come before what one reads move it, and the view moves with it.
TEST_F(WindowTest, TheWordsThatOneReadsStayWhenPagesBeforeThemChange) {
    DocumentWindow* window = open(memo(paragraphs(1500)));
    view::DocumentView& view = window->view();
    ASSERT_TRUE(waitFor([&] { return view.isLaidOut(); }));
    QScrollBar* bar = view.verticalScrollBar();
    view.find("line 1000");
    ASSERT_GT(bar->value(), 0);
    const int before = bar->value();
    document::Document& document = window->document().document();
    const auto insert = [&](const std::string& behind, const std::string& text) {
        const std::size_t at = document.bytes().find(behind) + behind.size();
        ASSERT_EQ(document.edit({{{at, at}, text}}, "test"), document::EditResult::applied);
        ASSERT_TRUE(waitFor([&] { return view.isLaidOut(); }));
        QCoreApplication::processEvents();
    };
    insert("{line 10}</PARAGRAPH>\n", paragraphs(200).replace("line", "more").toStdString());
    EXPECT_GT(bar->value(), before + view.viewport()->height());
    const int moved = bar->value();
    view.find("line 1000"); // would scroll to it, were it out of sight
    EXPECT_EQ(bar->value(), moved);

    // Pages out of sight are not painted.
    QCoreApplication::processEvents();
    const int painted = view.pagesPainted();
    insert("{line 20", "x");
    EXPECT_EQ(view.pagesPainted(), painted);
    insert("{line 1000", "x");
    ASSERT_TRUE(waitFor([&] { return view.pagesPainted() > painted; }));
    EXPECT_EQ(bar->value(), moved);
}

TEST_F(WindowTest, WindowsOfOnePresentationShareItsPages) {
    DocumentWindow* one = open(memo(paragraphs(10)));
    DocumentWindow* two = application_.addWindow(one->shared());
    ASSERT_FALSE(two->view().pages().pages.empty());
    EXPECT_EQ(one->view().pages().pages.front(), two->view().pages().pages.front());
}

TEST_F(WindowTest, ALongDocumentIsClosedWhileItIsLaidOut) {
    QPointer<DocumentWindow> window =
        open(memo(paragraphs(session::Presented::firstSteps * 3 / 2)));
    EXPECT_FALSE(window->view().isLaidOut());
    window->close();
    ASSERT_TRUE(waitFor([&] { return window.isNull(); }));
}

TEST_F(WindowTest, APictureIsShownWhenItIsDecodedAndNothingWaitsForAPipe) {
    QImage red(600, 400, QImage::Format_RGB32);
    red.fill(Qt::red);
    ASSERT_TRUE(red.save(folder_.filePath("red.png")));
    ASSERT_EQ(::mkfifo(QFile::encodeName(folder_.filePath("fifo.png")).constData(), 0600), 0);
    DocumentWindow* window = open(memo("<FIGURE><IMAGE FILE=\"fifo.png\"></IMAGE></FIGURE>\n"
                                       "<FIGURE><IMAGE FILE=\"red.png\"></IMAGE></FIGURE>\n"
                                       "<FIGURE><IMAGE FILE=\"red.png\"></IMAGE></FIGURE>\n"));
    const auto redPixels = [&] {
        const QImage shown = window->view().viewport()->grab().toImage();
        int count = 0;
        for (int y = 0; y < shown.height(); y += 10)
            for (int x = 0; x < shown.width(); x += 10)
                count += shown.pixelColor(x, y) == QColor(Qt::red);
        return count;
    };
    ASSERT_TRUE(waitFor([&] { return redPixels() > 1000; }));
    EXPECT_EQ(window->document().images().decodes(), 1);
    bool isSaid = false;
    for (const session::ListedFault& fault : window->document().faults())
        isSaid |= fault.message.contains("fifo.png") && fault.position.line == 5;
    EXPECT_TRUE(isSaid);
}

} // namespace
} // namespace window
