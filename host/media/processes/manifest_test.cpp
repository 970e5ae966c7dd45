#include "processes/manifest.h"

#include <gmock/gmock.h>

#include <QDir>
#include <QFile>
#include <QTemporaryDir>

namespace media {
namespace {

using ::testing::HasSubstr;

const QByteArray good =
    R"({"name":"A","class":"C","storage":"S","command":["a","--b"],"protocol":[1,2],"newText":"t"})";

std::string faultOf(QByteArray json) {
    QString fault;
    EXPECT_FALSE(readManifest(json, fault));
    return fault.toStdString();
}

TEST(Manifest, IsReadWhole) {
    QString fault;
    const auto manifest = readManifest(good, fault);
    ASSERT_TRUE(manifest);
    EXPECT_EQ(manifest->name, "A");
    EXPECT_EQ(manifest->documentClass, "C");
    EXPECT_EQ(manifest->storage, "S");
    EXPECT_EQ(manifest->command, QStringList({"a", "--b"}));
    EXPECT_EQ(manifest->protocolMax, 2);
    EXPECT_EQ(manifest->newText, "t");
}

TEST(Manifest, FaultsAreSentences) {
    EXPECT_THAT(faultOf("{"), HasSubstr("byte 1:"));
    EXPECT_THAT(faultOf("[]"), HasSubstr("\"name\" must be"));
    EXPECT_THAT(faultOf(QByteArray(good).replace("\"C\"", "7")), HasSubstr("\"class\" must be"));
    EXPECT_THAT(faultOf(QByteArray(good).replace("\"--b\"", "1")),
                HasSubstr("\"command\" must be"));
    EXPECT_THAT(faultOf(QByteArray(good).replace("[1,2]", "[2,1]")), HasSubstr("\"protocol\""));
}

TEST(Manifest, SaysWhatNewOnesBeginWith) {
    const QByteArray more =
        QByteArray(good).replace("}", R"(,"title":"Thing","size":[300,200],"newEditor":"open",
                "samples":[{"file":"s/a.x","title":"A","about":"An a","time":2,
                            "group":"Letters"},
                           {"file":"b.x","title":"B"}],
                "files":{"title":"Things","endings":["x","y"]}})");
    QString fault;
    const auto manifest = readManifest(more, fault);
    ASSERT_TRUE(manifest) << fault.toStdString();
    EXPECT_EQ(manifest->title, "Thing");
    EXPECT_EQ(manifest->size, QSizeF(300, 200));
    EXPECT_EQ(manifest->newEditor, "open");
    ASSERT_EQ(manifest->samples.size(), 2);
    EXPECT_EQ(manifest->samples[0].about, "An a");
    EXPECT_EQ(manifest->samples[0].time, 2);
    EXPECT_FALSE(manifest->samples[1].time);
    EXPECT_EQ(manifest->samples[0].group, "Letters");
    EXPECT_EQ(manifest->samples[1].group, "");
    EXPECT_EQ(manifest->filesTitle, "Things");
    EXPECT_EQ(manifest->fileEndings, QStringList({"x", "y"}));
    Manifest placed = *manifest;
    placed.file = "/media/m.medium.json";
    EXPECT_EQ(fileOf(placed, placed.samples[0]), "/media/s/a.x");
    EXPECT_EQ(readManifest(good, fault)->title, "A"); // its name
}

TEST(Manifest, FaultsOfWhatMayBeLeftOutAreSentences) {
    const auto with = [](const QByteArray& member) {
        return QByteArray(good).replace("}", "," + member + "}");
    };
    EXPECT_THAT(faultOf(with(R"("title":3)")), HasSubstr("\"title\" must be a string"));
    EXPECT_THAT(faultOf(with(R"("size":[0,3])")), HasSubstr("\"size\" must be"));
    EXPECT_THAT(faultOf(with(R"("files":{"title":"x"})")), HasSubstr("\"files\" must have"));
    EXPECT_THAT(faultOf(with(R"("samples":[{"title":"A","file":"a.x","group":4}])")),
                HasSubstr("\"group\" of a sample must be a string"));
    for (const char* file : {"/etc/passwd", "../a.x", "a/../../b.x", ""})
        EXPECT_THAT(
            faultOf(with(R"("samples":[{"title":"A","file":")" + QByteArray(file) + R"("}])")),
            HasSubstr("each of \"samples\" must have"))
            << file;
}

void write(const QString& path, const QByteArray& bytes) {
    QFile file(path);
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(bytes);
}

TEST(Registry, TheFirstOfAClassWinsAndAFaultyOneIsReported) {
    QTemporaryDir one, two;
    write(one.filePath("a.medium.json"), good);
    write(one.filePath("b.medium.json"), "{");
    write(two.filePath("c.medium.json"), QByteArray(good).replace("\"A\"", "\"B\""));
    write(two.filePath("d.medium.json"), QByteArray(good).replace("\"C\"", "\"D\""));
    const Registry registry = Registry::read({one.path(), "/nowhere", two.path()});
    ASSERT_TRUE(registry.forClass("C"));
    EXPECT_EQ(registry.forClass("C")->name, "A");
    EXPECT_TRUE(registry.forClass("D"));
    EXPECT_FALSE(registry.forClass("E"));
    ASSERT_EQ(registry.faults().size(), 1);
    EXPECT_THAT(registry.faults()[0].toStdString(), HasSubstr("b.medium.json: byte 1:"));
}

TEST(Registry, AProgramIsLookedUpBesideTheManifestFirst) {
    QTemporaryDir folder;
    write(folder.filePath("sh"), "#!/bin/sh\n");
    QFile::setPermissions(folder.filePath("sh"), QFile::ReadOwner | QFile::ExeOwner);
    Manifest manifest;
    manifest.command = QStringList{"sh"};
    manifest.file = folder.filePath("a.medium.json");
    EXPECT_EQ(programOf(manifest, {}), folder.filePath("sh"));
    manifest.file = "/nowhere/a.medium.json";
    EXPECT_TRUE(programOf(manifest, {}).endsWith("/bin/sh"));
    manifest.command = QStringList{"no/such"};
    EXPECT_EQ(programOf(manifest, {}), QString());
}

} // namespace
} // namespace media
