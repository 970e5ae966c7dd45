#include "session/images.h"

#include <gmock/gmock.h>

#include <QCoreApplication>
#include <QDir>
#include <QElapsedTimer>
#include <QFile>
#include <QTemporaryDir>

#include <sys/stat.h>

namespace session {
namespace {

using ::testing::HasSubstr;

class ImagesTest : public ::testing::Test {
protected:
    ImagesTest() { images_.setDocument(folder_.filePath("a.ens")); }

    void writePicture(const QString& name, QSize size, const QColor& color = Qt::red) const {
        QImage image(size, QImage::Format_RGB32);
        image.fill(color);
        ASSERT_TRUE(image.save(folder_.filePath(name)));
    }
    void write(const QString& name, const QByteArray& bytes) const {
        QFile file(folder_.filePath(name));
        ASSERT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(bytes);
    }
    QImage imageWhenReady(const std::string& source, QSize wanted) {
        (void)images_.image(source, wanted);
        while (images_.isWaiting())
            QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
        return images_.image(source, wanted);
    }
    std::string faultOf(const std::string& source) { return images_.fault(source).toStdString(); }

    QTemporaryDir folder_;
    Images images_;
};

TEST_F(ImagesTest, AFileIsDecodedOnceForAllItsFigures) {
    writePicture("a.png", {1600, 1200});
    for (int i = 0; i < 250; ++i) {
        EXPECT_EQ(images_.size("a.png"), QSize(1600, 1200));
        (void)images_.image("a.png", {400, 300});
    }
    const QImage image = imageWhenReady("./a.png", {400, 300}); // the same file
    EXPECT_EQ(image.size(), QSize(400, 300));                   // and no more of it than is needed
    EXPECT_EQ(images_.decodes(), 1);
    EXPECT_EQ(image.pixelColor(10, 10), QColor(Qt::red));
    EXPECT_EQ(images_.imageNow("a.png", {300, 200}).cacheKey(), image.cacheKey());
    EXPECT_EQ(images_.decodes(), 1);
}

// A half of one pixel, rounded, is one pixel again.
TEST_F(ImagesTest, OneOfASinglePixelIsShownSmallerThanItIs) {
    for (const QSize size : {QSize(1, 1), QSize(1, 9), QSize(9, 1)}) {
        const QString name = QStringLiteral("%1x%2.png").arg(size.width()).arg(size.height());
        writePicture(name, size);
        EXPECT_EQ(images_.imageNow(name.toStdString(), {1, 1}).size(), size);
        EXPECT_EQ(images_.imageNow(name.toStdString(), {0, 0}).size(), size);
    }
}

TEST_F(ImagesTest, MoreOfItIsDecodedWhenMoreIsNeededAndWhenTheFileChanges) {
    writePicture("a.png", {1600, 1200});
    EXPECT_EQ(imageWhenReady("a.png", {100, 100}).width(), 200);
    EXPECT_EQ(imageWhenReady("a.png", {1000, 700}).width(), 1600);
    EXPECT_EQ(images_.decodes(), 2);
    writePicture("a.png", {800, 400}, Qt::blue);
    EXPECT_EQ(images_.size("a.png"), QSize(800, 400));
    EXPECT_EQ(imageWhenReady("a.png", {800, 400}).pixelColor(1, 1), QColor(Qt::blue));
    EXPECT_EQ(images_.decodes(), 3);
}

TEST_F(ImagesTest, WhatIsNoRegularFileIsNotWaitedFor) {
    ASSERT_EQ(::mkfifo(QFile::encodeName(folder_.filePath("fifo.png")).constData(), 0600), 0);
    QDir(folder_.path()).mkdir("folder.png");
    EXPECT_TRUE(images_.size("fifo.png").isEmpty());
    EXPECT_THAT(faultOf("fifo.png"), HasSubstr("no file that can be read"));
    EXPECT_THAT(faultOf("folder.png"), HasSubstr("no file that can be read"));
    EXPECT_TRUE(QFile::link("/dev/zero", folder_.filePath("zero.png")));
    EXPECT_THAT(faultOf("zero.png"), HasSubstr("not in the document's folder"));
    EXPECT_THAT(faultOf("/dev/zero"), HasSubstr("not in the document's folder"));
    EXPECT_TRUE(images_.image("fifo.png", {10, 10}).isNull());
    EXPECT_EQ(images_.decodes(), 0);
}

TEST_F(ImagesTest, WhatIsTooLargeUnknownDamagedOrMissingIsSaid) {
    QFile large(folder_.filePath("large.png"));
    ASSERT_TRUE(large.open(QIODevice::WriteOnly));
    ASSERT_TRUE(large.resize(Images::mostBytes + 1)); // takes no room on the disk
    EXPECT_THAT(faultOf("large.png"), HasSubstr("longer than 64 MiB"));
    EXPECT_THAT(faultOf("no.png"), HasSubstr("There is no picture no.png"));
    EXPECT_THAT(faultOf(""), HasSubstr("names no file"));
    write("text.png", QByteArray("no picture"));
    EXPECT_THAT(faultOf("text.png"), HasSubstr("no picture that is known"));
    write("drawing.svg",
          QByteArray("<svg xmlns='http://www.w3.org/2000/svg' width='9' height='9'/>"));
    EXPECT_THAT(faultOf("drawing.svg"), HasSubstr("no picture that is known"));
    write("many.bmp", QByteArray::fromHex("424d3600000000000000360000002800000010270000102700000100"
                                          "1800000000000000000000000000000000000000000000000000"));
    EXPECT_THAT(faultOf("many.bmp"), HasSubstr("64 million pixels"));
    writePicture("whole.png", {300, 300});
    QFile whole(folder_.filePath("whole.png"));
    ASSERT_TRUE(whole.open(QIODevice::ReadOnly));
    write("cut.png", whole.readAll().left(whole.size() * 2 / 3));
    EXPECT_EQ(images_.size("cut.png"), QSize(300, 300)); // as its header says
    EXPECT_TRUE(imageWhenReady("cut.png", {300, 300}).isNull());
    EXPECT_THAT(faultOf("cut.png"), HasSubstr("damaged"));
    EXPECT_TRUE(imageWhenReady("cut.png", {300, 300}).isNull());
    EXPECT_EQ(images_.decodes(), 1);
}

TEST_F(ImagesTest, OneThatEndsWhileItDecodesIsGone) {
    writePicture("a.png", {3000, 3000});
    auto images = std::make_unique<Images>();
    images->setDocument(folder_.filePath("a.ens"));
    (void)images->image("a.png", {3000, 3000});
    images.reset();
    QCoreApplication::processEvents();
}

} // namespace
} // namespace session
