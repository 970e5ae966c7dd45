#include "document/document.h"

#include <gtest/gtest.h>

#include <QDir>
#include <QTemporaryDir>

#include <fstream>
#include <sstream>

namespace document {

namespace {

using files::FileState;
using files::Refusal;

std::string contentOf(const QString& path) {
    std::ifstream file(path.toStdString(), std::ios::binary);
    std::ostringstream bytes;
    bytes << file.rdbuf();
    return bytes.str();
}

void put(const QString& path, const std::string& bytes) {
    std::ofstream(path.toStdString(), std::ios::binary) << bytes;
}

} // namespace

TEST(Save, ADocumentKnowsWhetherItIsModifiedAndWhetherItsFileChanged) {
    QTemporaryDir folder;
    const QString path = folder.filePath("a.ens");
    put(path, "DOCUMENT A\n<A><DOCUMENT>DOCUMENT B\n<B><S>{old}</S></B></DOCUMENT></A>\n");
    auto loaded = Document::load(path);
    ASSERT_NE(loaded.document, nullptr);
    Document& document = *loaded.document;
    EXPECT_EQ(document.fileState(), FileState::unchanged);
    const SubdocumentId id = document.subdocuments()[0];
    document.editText(id, 0, {{{0, 3}, "new"}}, "Edit");
    EXPECT_TRUE(document.isModified());
    ASSERT_TRUE(document.save());
    EXPECT_FALSE(document.isModified());
    EXPECT_EQ(contentOf(path), document.bytes());
    document.undo(); // the stack outlives saving
    EXPECT_TRUE(document.isModified());
    put(path, "DOCUMENT A\n<A></A>\n");
    EXPECT_EQ(document.fileState(), FileState::changed);
    EXPECT_EQ(document.save().refusal, Refusal::changed);
    EXPECT_EQ(contentOf(path), "DOCUMENT A\n<A></A>\n");
    ASSERT_TRUE(document.save({.evenChanged = true}));
    ASSERT_TRUE(QFile::remove(path));
    EXPECT_EQ(document.fileState(), FileState::removed);
}

TEST(Save, ABrokenDocumentIsNotOverwrittenUnasked) {
    QTemporaryDir folder;
    const QString path = folder.filePath("a.ens");
    put(path, "DOCUMENT A\n<A>{never closed\n");
    auto loaded = Document::load(path);
    ASSERT_TRUE(loaded.document->isBroken());
    EXPECT_EQ(loaded.document->save().refusal, Refusal::broken);
    EXPECT_TRUE(loaded.document->saveAs(folder.filePath("b.ens")));
    EXPECT_TRUE(loaded.document->saveAs(path));
    auto again = Document::load(path);
    EXPECT_EQ(again.document->saveAs(folder.filePath("./a.ens")).refusal, Refusal::broken);
    EXPECT_TRUE(again.document->save({.evenBroken = true}));
}

TEST(Save, AMissingFileIsASentence) {
    const auto loaded = Document::load("/nonexistent/x.ens");
    EXPECT_EQ(loaded.document, nullptr);
    EXPECT_EQ(loaded.failure, "x.ens cannot be read: No such file or directory.");
}

TEST(Recover, IsOneChangeOfTheFile) {
    QTemporaryDir folder;
    const QString path = folder.filePath("a.ens");
    put(path, "DOCUMENT A\n<A>{old}</A>\n");
    const files::KnownFile known = Document::load(path).document->knownFile();
    const auto document = Document::recover(known, "DOCUMENT A\n<A>{new}</A>\n");
    EXPECT_EQ(document->fileName(), path);
    EXPECT_TRUE(document->isModified());
    EXPECT_EQ(document->undoLabel(), "Recover");
    EXPECT_EQ(document->fileState(), FileState::unchanged);
    document->undo();
    EXPECT_EQ(document->bytes(), contentOf(path));
    EXPECT_FALSE(document->isModified());
    document->redo();
    EXPECT_TRUE(document->save());
    EXPECT_EQ(contentOf(path), "DOCUMENT A\n<A>{new}</A>\n");
}

TEST(Recover, SavingAsksWhenTheFileIsAnotherByNow) {
    QTemporaryDir folder;
    const QString path = folder.filePath("a.ens");
    put(path, "DOCUMENT A\n<A>{old}</A>\n");
    const files::KnownFile known = Document::load(path).document->knownFile();
    put(path, "DOCUMENT A\n<A>{another's}</A>\n");
    const auto document = Document::recover(known, "DOCUMENT A\n<A>{new}</A>\n");
    EXPECT_EQ(document->fileState(), FileState::changed);
    EXPECT_EQ(document->save().refusal, Refusal::changed);
    EXPECT_EQ(contentOf(path), "DOCUMENT A\n<A>{another's}</A>\n");
    document->undo();
    EXPECT_EQ(document->bytes(), contentOf(path));
}

TEST(Recover, WithoutItsFileTheTextIsADocumentThatWasNeverSaved) {
    QTemporaryDir folder;
    const std::string text = "DOCUMENT A\n<A>{new}</A>\n";
    const auto untitled = Document::recover({}, text);
    EXPECT_EQ(untitled->bytes(), text);
    EXPECT_TRUE(untitled->isModified());
    EXPECT_EQ(untitled->fileName(), "");
    const QString path = folder.filePath("gone.ens");
    const auto gone = Document::recover({path.toStdString(), {.exists = true}}, text);
    EXPECT_EQ(gone->fileName(), path);
    EXPECT_TRUE(gone->isModified());
    EXPECT_TRUE(gone->save());
    EXPECT_EQ(contentOf(path), text);
}

} // namespace document
