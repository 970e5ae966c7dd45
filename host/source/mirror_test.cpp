#include "source/document_mirror.h"

#include "document/random_report.h"
#include "source/letters.h"
#include "source/shown_bytes.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QTest>
#include <QTextBlock>

namespace source {
namespace {

class MirrorTest : public ::testing::Test {
protected:
    void show(const std::string& bytes) {
        document_ = std::make_unique<document::Document>(bytes);
        edit_ = std::make_unique<QPlainTextEdit>();
        mirror_ = std::make_unique<DocumentMirror>(*document_, *edit_);
        mirror_->start();
        while (!mirror_->isComplete())
            QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
    }
    [[nodiscard]] std::string letters() const {
        return lettersOf(*edit_->document()).toStdString();
    }
    [[nodiscard]] std::string wanted() const {
        std::string_view bytes = document_->bytes();
        if (bytes.starts_with("\xEF\xBB\xBF"))
            bytes.remove_prefix(3);
        return shown(bytes).toStdString();
    }
    void put(std::size_t offset) const { mirror_->select({offset, offset}); }
    void putAt(const std::string& words) const { put(document_->bytes().find(words)); }
    void type(const char* keys) const { QTest::keyClicks(edit_.get(), keys); }

    std::unique_ptr<document::Document> document_;
    std::unique_ptr<QPlainTextEdit> edit_;
    std::unique_ptr<DocumentMirror> mirror_;
};

const std::string memo = "DOCUMENT CMEMO\n<CMEMO><TO>{you}</TO>\n<BODY>\n"
                         "<PARAGRAPH>{one}</PARAGRAPH>\n</BODY></CMEMO>\n";

TEST_F(MirrorTest, AnEditOfTheDocumentMovesNothingElse) {
    show(memo);
    EXPECT_EQ(letters(), wanted());
    putAt("one");
    const QTextBlock caret = edit_->textCursor().block();
    document_->edit({{{23, 26}, "ME\n"}, {{40, 40}, "<X>"}}, "test");
    EXPECT_EQ(letters(), wanted());
    EXPECT_EQ(edit_->textCursor().block(), caret);
    EXPECT_EQ(mirror_->offsetOf(edit_->textCursor().position()), document_->bytes().find("one"));
    document_->undo();
    EXPECT_EQ(letters(), memo);
}

TEST_F(MirrorTest, WhatIsTypedIsOneStepOfTheDocumentUntilAPause) {
    show(memo);
    putAt("one");
    type("a <b");
    EXPECT_EQ(letters(), wanted());
    EXPECT_NE(document_->bytes().find("{a <bone}"), std::string::npos);
    EXPECT_EQ(document_->steps(), 1u);
    QTest::keyClick(edit_.get(), Qt::Key_Backspace);
    QTest::keyClick(edit_.get(), Qt::Key_Return);
    EXPECT_NE(document_->bytes().find("{a <\none}"), std::string::npos);
    document_->undo();
    EXPECT_EQ(document_->bytes(), memo);
    EXPECT_EQ(letters(), memo);
    EXPECT_EQ(document_->undoLabel(), "");
    document_->redo();
    EXPECT_EQ(letters(), wanted());
}

// Undo restores the caret that the step began with.
TEST_F(MirrorTest, UndoKnowsTheCaret) {
    show(memo);
    std::optional<document::Selection> restored;
    QObject::connect(document_.get(), &document::Document::selectionRestored, edit_.get(),
                     [&](const document::Selection& selection) { restored = selection; });
    putAt("one");
    const std::size_t at = document_->bytes().find("one");
    type("x");
    document_->undo();
    EXPECT_EQ(restored, (document::Selection{at, at}));
    document_->redo();
    EXPECT_EQ(restored, (document::Selection{at + 1, at + 1}));
}

TEST_F(MirrorTest, LineEndsStayThoseOfTheFile) {
    show("DOCUMENT CMEMO\r\n<CMEMO>\r\n</CMEMO>\r\n");
    putAt("</CMEMO>");
    QTest::keyClick(edit_.get(), Qt::Key_Return);
    type("x");
    EXPECT_EQ(document_->bytes(), "DOCUMENT CMEMO\r\n<CMEMO>\r\n\r\nx</CMEMO>\r\n");
    EXPECT_EQ(letters(), wanted());
}

// A whole text that is taken away and comes again.
TEST_F(MirrorTest, AllIsReplaced) {
    show(memo);
    edit_->selectAll();
    QTest::keyClick(edit_.get(), Qt::Key_Delete);
    EXPECT_EQ(document_->bytes(), "");
    edit_->insertPlainText("DOCUMENT REPORT\n<REPORT>");
    EXPECT_EQ(document_->bytes(), "DOCUMENT REPORT\n<REPORT>");
    document_->undo();
    document_->undo();
    EXPECT_EQ(letters(), memo);
}

// All edit at random; both hold the same in the end, and the bytes that nobody touched
// stay.
TEST_F(MirrorTest, RandomTypingAndEditsKeepBothInStep) {
    const QString pieces[] = {"<",  ">", "{",  "}",       "\"",         "\n", "a",
                              "\r", "ä", "\t", "</TEXT>", QString("🎬"), "=",  QChar(0x202E)};
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
        document::Author author(seed);
        std::string bytes = author.report(6);
        if (seed % 3 == 0)
            bytes = "\xEF\xBB\xBF" + bytes + "\r\n\xff\xe2\x80\xa8\r<\r\n";
        show(bytes);
        for (int step = 0; step < 60; ++step) {
            const auto size = [&] { return edit_->document()->characterCount() - 1; };
            // No caret stands between the two halves of a letter.
            const auto upTo = [&](int most) {
                const int at = static_cast<int>(author.below(static_cast<std::size_t>(most) + 1));
                return at - (edit_->document()->characterAt(at).isLowSurrogate() ? 1 : 0);
            };
            switch (author.below(8)) {
            case 0:
                document_->undo();
                break;
            case 1:
                document_->redo();
                break;
            case 2:
            case 3:
                (void)document_->edit(author.edit(document_->tree()), "Edit");
                break;
            default: {
                QTextCursor cursor(edit_->document());
                cursor.setPosition(upTo(size()));
                if (author.below(2) == 0)
                    cursor.setPosition(upTo(std::min(size(), cursor.position() + 4)),
                                       QTextCursor::KeepAnchor);
                edit_->setTextCursor(cursor);
                edit_->insertPlainText(pieces[author.below(std::size(pieces))]);
            }
            }
            ASSERT_EQ(letters(), wanted()) << seed << " " << step;
            const int at = upTo(size());
            ASSERT_EQ(mirror_->positionOf(mirror_->offsetOf(at)), at) << seed << " " << step;
        }
        while (document_->canUndo())
            document_->undo();
        ASSERT_EQ(document_->bytes(), bytes) << seed;
        ASSERT_EQ(letters(), wanted());
    }
}

// A letter costs the same at the end of a long document as in a short one.
TEST_F(MirrorTest, AKeyReadsItsLineAndNotTheDocument) {
    std::string body;
    while (body.size() < 10 * DocumentMirror::sliceBytes)
        body += "<PARAGRAPH>{" + std::to_string(body.size()) + "}</PARAGRAPH>\n";
    show("DOCUMENT CMEMO\n<CMEMO><BODY>\n" + body +
         "<PARAGRAPH>{here}</PARAGRAPH>\n</BODY></CMEMO>");
    EXPECT_GE(mirror_->slices(), 10);
    EXPECT_EQ(letters(), wanted());
    const auto work = [] { return lettersRead() + text::bytesPlaced(); };
    constexpr std::size_t most = 20'000; // some hundred lines; the document has 14,000
    for (const char* words : {"{100", "here"}) {
        putAt(words);
        std::size_t before = work();
        type("x");
        EXPECT_LT(work() - before, most) << words;
        before = work();
        const std::size_t at = document_->bytes().find(words);
        document_->edit({{{at, at}, "y"}}, "test");
        EXPECT_LT(work() - before, most) << words;
    }
    EXPECT_EQ(letters(), wanted());
}

// A long text comes in slices again, and the caret is where it was.
TEST_F(MirrorTest, ALongEditComesInSlices) {
    show(memo);
    putAt("</CMEMO>");
    const std::size_t at = memo.find("<PARAGRAPH>");
    std::string body;
    while (body.size() < 3 * DocumentMirror::sliceBytes)
        body += "<PARAGRAPH>{more}</PARAGRAPH>\n";
    document_->edit({{{at, at}, body}}, "test");
    EXPECT_FALSE(mirror_->isComplete());
    document_->edit({{{at, at}, "<X>"}}, "test"); // meanwhile
    while (!mirror_->isComplete())
        QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
    EXPECT_EQ(letters(), wanted());
    EXPECT_EQ(mirror_->selection().caret, document_->bytes().find("</CMEMO>"));
}

} // namespace
} // namespace source

int main(int argc, char** argv) {
    qputenv("QT_QPA_PLATFORM", "offscreen");
    const QApplication application(argc, argv);
    testing::InitGoogleTest(&argc, argv);
    return RUN_ALL_TESTS();
}
