#include "session/picture_home.h"

#include <gtest/gtest.h>

#include <QBuffer>
#include <QDir>
#include <QFile>
#include <QImage>
#include <QTemporaryDir>

#include <sys/stat.h>

namespace session {
namespace {

QByteArray picture(Qt::GlobalColor color) {
    QImage image(8, 6, QImage::Format_RGB32);
    image.fill(color);
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    image.save(&buffer, "PNG");
    return bytes;
}

QByteArray read(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

class PictureHomeTest : public ::testing::Test {
protected:
    QString at(const std::string& source) const {
        return home_.folder() + "/" + QString::fromStdString(source);
    }
    QTemporaryDir folder_, other_;
    void setDocument(const QString& file) {
        home_ = PictureHome(file, folder_.filePath("unsaved"));
    }
    PictureHome home_{{}, folder_.filePath("unsaved")};
};

TEST_F(PictureHomeTest, APictureIsOneFileHoweverOftenItComes) {
    setDocument(other_.filePath("a.ens"));
    const auto first = home_.keep(picture(Qt::red), "/x/My Photo.PNG");
    ASSERT_EQ(first.fault, "");
    EXPECT_TRUE(first.source.starts_with("pictures/my-photo-")) << first.source;
    EXPECT_TRUE(first.source.ends_with(".png"));
    EXPECT_EQ(home_.keep(picture(Qt::red), "/x/My Photo.PNG").source, first.source);
    EXPECT_NE(home_.keep(picture(Qt::blue), "/x/My Photo.PNG").source, first.source);
    EXPECT_EQ(QDir(other_.filePath("pictures")).entryList(QDir::Files).size(), 2);
    EXPECT_EQ(read(at(first.source)), picture(Qt::red));
    EXPECT_TRUE(home_.keep(picture(Qt::red), "").source.starts_with("pictures/picture-"));
    EXPECT_TRUE(home_.keep(picture(Qt::red), "../../..").source.starts_with("pictures/picture-"));
}

TEST_F(PictureHomeTest, WhatIsNoPictureIsRefused) {
    setDocument(other_.filePath("a.ens"));
    EXPECT_NE(home_.keep("no picture", "a.png").fault, "");
    EXPECT_NE(home_.keepFile(other_.filePath("missing.png")).fault, "");
    ASSERT_EQ(::mkfifo(QFile::encodeName(other_.filePath("pipe.png")).constData(), 0600), 0);
    EXPECT_NE(home_.keepFile(other_.filePath("pipe.png")).fault, ""); // and nobody waits
    EXPECT_FALSE(QDir(other_.filePath("pictures")).exists());
}

TEST_F(PictureHomeTest, PicturesFollowTheDocumentToItsFile) {
    const auto kept = home_.keep(picture(Qt::red), "a.png");
    ASSERT_EQ(kept.fault, "");
    EXPECT_TRUE(QFile::exists(folder_.filePath("unsaved/") + QString::fromStdString(kept.source)));
    const QString from = home_.folder();
    setDocument(other_.filePath("deep/a.ens"));
    EXPECT_EQ(home_.bring({kept.source, "gone.png"}, from), QStringList());
    EXPECT_EQ(read(at(kept.source)), picture(Qt::red));
}

// A document of a stranger brings no files of its reader along.
TEST_F(PictureHomeTest, NothingFromOutsideTheFolderIsBrought) {
    QFile secret(folder_.filePath("secret.png"));
    ASSERT_TRUE(secret.open(QIODevice::WriteOnly));
    secret.write(picture(Qt::red));
    secret.close();
    QDir(folder_.path()).mkpath("document");
    QFile::link(folder_.filePath("secret.png"), folder_.filePath("document/link.png"));
    setDocument(other_.filePath("a.ens"));
    EXPECT_EQ(home_.bring({"../secret.png", folder_.filePath("secret.png").toStdString(),
                           "x/../../secret.png", "link.png"},
                          folder_.filePath("document")),
              QStringList());
    EXPECT_TRUE(QDir(other_.path()).isEmpty());
    // And a file that is there stays as it is.
    QFile own(other_.filePath("own.png"));
    ASSERT_TRUE(own.open(QIODevice::WriteOnly));
    own.write("mine");
    own.close();
    ASSERT_TRUE(QFile::copy(folder_.filePath("secret.png"), folder_.filePath("document/own.png")));
    EXPECT_EQ(home_.bring({"own.png"}, folder_.filePath("document")), QStringList());
    EXPECT_EQ(read(other_.filePath("own.png")), "mine");
}

} // namespace
} // namespace session
