// Pictures of files in a writing view: pasted, dropped, named, resized; and where they are kept.
#include "reading/block_text.h"
#include "view/resizing.h"
#include "writing/writing_testing.h"

#include <QClipboard>
#include <QFileInfo>
#include <QMimeData>

namespace writing {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

class PicturesTest : public WritingTest {
protected:
    static QImage picture() {
        QImage image(90, 60, QImage::Format_RGB32);
        image.fill(Qt::red);
        return image;
    }
    void paste() const {
        auto* data = new QMimeData;
        data->setImageData(picture());
        QApplication::clipboard()->setMimeData(data);
        action("paste")->trigger();
    }
    // FILE of the first image.
    std::string source() const {
        const std::string& bytes = document().bytes();
        const std::size_t from = bytes.find("FILE=\"") + 6;
        return bytes.substr(from, bytes.find('"', from) - from);
    }
    QString path() const {
        return QFileInfo(document().fileName()).absolutePath() + "/" +
               QString::fromStdString(source());
    }
    void clickOnImage() const {
        ASSERT_TRUE(waitFor(
            [&] { return view().isLaidOut() && !view().pages().pages.front()->objects.empty(); }));
        const layout::PlacedObject& object = view().pages().pages.front()->objects.front();
        QTest::mouseClick(view().viewport(), Qt::LeftButton, {},
                          view().inViewport(0, object.rect).center().toPoint());
    }
};

TEST_F(PicturesTest, APastedPictureIsAFileBesideTheDocument) {
    write(paragraph("One"));
    const std::string before = document().bytes();
    goTo("}</TEXT></PARAGRAPH>\n</BODY>");
    paste();
    EXPECT_THAT(body(), HasSubstr("<FIGURE><IMAGE FILE=\"pictures/picture-"));
    EXPECT_EQ(QImage(path()).size(), picture().size());
    // What is undone is not lost.
    const QString file = path();
    document().undo();
    EXPECT_EQ(document().bytes(), before);
    EXPECT_TRUE(QFileInfo::exists(file));
    document().redo();
    EXPECT_THAT(body(), HasSubstr("IMAGE"));
    // Saved elsewhere, the document has it there, too.
    QTemporaryDir other;
    ASSERT_TRUE(document().saveAs(other.filePath("copy.ens")));
    EXPECT_EQ(path(), other.filePath(QString::fromStdString(source())));
    EXPECT_TRUE(QFileInfo::exists(path()));
    EXPECT_TRUE(QFileInfo::exists(file));
    EXPECT_EQ(window_->document().images().fault(source()), "");
}

// In the line it is one letter for the caret, and a word for those who do not see it.
TEST_F(PicturesTest, TheCaretPassesAnImageInTheLine) {
    write("<PARAGRAPH><TEXT>{ab}</TEXT><IMAGE FILE=\"ball.png\" ALT=\"A ball\"></IMAGE>"
          "<TEXT>{cd}</TEXT></PARAGRAPH>\n");
    ASSERT_TRUE(picture().save(QFileInfo(document().fileName()).absolutePath() + "/ball.png"));
    const std::size_t before = document().bytes().find("ab}") + 2;
    const std::size_t behind = document().bytes().find("{cd}") + 1;
    const auto caret = [&] { return view().text().cursor().selection()->caret; };
    view().text().cursor().set({before, before});
    const QRectF left = *view().text().caretRect();
    press(Qt::Key_Right);
    EXPECT_EQ(caret(), behind);
    const QRectF right = *view().text().caretRect();
    const QRectF image = view().inViewport(0, view().pages().pages.front()->objects.front().rect);
    EXPECT_NEAR(left.center().x(), image.left(), 1);
    EXPECT_NEAR(right.center().x(), image.right(), 1);
    press(Qt::Key_Left);
    EXPECT_EQ(caret(), before);
    view().selectAll();
    view().copy();
    const QMimeData* copy = QApplication::clipboard()->mimeData();
    EXPECT_THAT(copy->text().toStdString(), HasSubstr("ab[A ball]cd"));
    EXPECT_THAT(copy->html().toStdString(), HasSubstr("ab[A ball]cd"));
    EXPECT_EQ(reading::BlockText(document(), view().model()->blocks.back()).text().toStdString(),
              "abA ballcd");
    clickOnImage();
    ASSERT_TRUE(view::sizedUnit(view()));
    EXPECT_FALSE(view::sizedUnit(view())->hasEdges);
    press(Qt::Key_Delete);
    EXPECT_THAT(body(), Not(HasSubstr("IMAGE")));
}

TEST_F(PicturesTest, DroppedFilesOfPicturesComeIn) {
    write(paragraph("One"));
    QTemporaryDir folder;
    ASSERT_TRUE(picture().save(folder.filePath("Red Ball.png")));
    goTo("One"); // a picture may not stand in the subject, where the caret is
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(folder.filePath("Red Ball.png"))});
    view().writing().drop(data, view().text().caretRect()->center(), std::nullopt);
    EXPECT_THAT(body(), HasSubstr("FILE=\"pictures/red-ball-"));
    EXPECT_TRUE(QFileInfo::exists(path()));
    EXPECT_EQ(QFileInfo(path()).absolutePath(),
              QFileInfo(document().fileName()).absolutePath() + "/pictures");
    const QString first = path();
    // A second document beside it shows another picture: neither takes what is the other's.
    const QString own = QFileInfo(first).absolutePath() + "/not-ours.png";
    ASSERT_TRUE(picture().save(own));
    QTemporaryDir other;
    ASSERT_TRUE(document().saveAs(other.filePath("copy.ens")));
    EXPECT_EQ(path(), other.filePath(QString::fromStdString(source())));
    EXPECT_EQ(QImage(path()).size(), picture().size());
    EXPECT_TRUE(QFileInfo::exists(first));
    EXPECT_EQ(QDir(other.filePath("pictures")).entryList(QDir::Files).size(), 1);
}

TEST_F(PicturesTest, AnImageIsSelectedNamedAndResized) {
    write(paragraph("One"));
    goTo("}</TEXT></PARAGRAPH>\n</BODY>");
    paste();
    const auto isMissed = [&] {
        for (const session::ListedFault& fault : window_->document().faults())
            if (fault.message.contains("alternative text"))
                return true;
        return false;
    };
    EXPECT_TRUE(isMissed());
    clickOnImage();
    ASSERT_TRUE(view::sizedUnit(view()));
    answering("imageWords", [](QDialog& dialog) {
        dialog.findChild<QLineEdit*>("alternative")->setText("A red ball");
        dialog.accept();
    });
    EXPECT_THAT(body(), HasSubstr("ALT=\"A red ball\""));
    EXPECT_FALSE(isMissed());
    const QRectF place = view::sizedUnit(view())->place;
    const QPoint corner = place.bottomRight().toPoint();
    QWidget* pages = view().viewport();
    QTest::mousePress(pages, Qt::LeftButton, {}, corner);
    QTest::mouseMove(pages, corner + QPoint(10, 8));
    QTest::mouseMove(pages, corner + QPoint(30, 20));
    QTest::mouseRelease(pages, Qt::LeftButton, {}, corner + QPoint(30, 20));
    EXPECT_THAT(body(), HasSubstr("WIDTH=\""));
    EXPECT_THAT(body(), Not(HasSubstr("HEIGHT")));
    document().undo();
    EXPECT_THAT(body(), Not(HasSubstr("WIDTH")));
    press(Qt::Key_Delete);
    EXPECT_THAT(body(), Not(HasSubstr("IMAGE")));
}

} // namespace
} // namespace writing
