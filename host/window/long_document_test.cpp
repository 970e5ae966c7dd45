// Long documents and pictures of files: the window lives, and shows what there is.
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
    DocumentView& view = window->view();
    EXPECT_FALSE(view.isLaidOut());
    const std::size_t first = view.pages().pages.size();
    EXPECT_GE(first, 10u);
    EXPECT_GT(view.verticalScrollBar()->maximum(), 0);
    ASSERT_TRUE(waitFor([&] { return view.isLaidOut(); }));
    EXPECT_GT(view.pages().pages.size(), first);
    view.find("line 5999");
    EXPECT_EQ(view.foundCount(), 1);
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
