// Work that is not saved when a program ends is offered by the next one. A program that ends
// without its windows being closed is an Application that is destroyed; tests/host kills real ones.
#include "window/window_testing.h"

#include <fstream>
#include <sys/stat.h>

namespace window {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

class RecoveryTest : public testing::Test {
protected:
    void SetUp() override {
        QFile file(path_);
        ASSERT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(saved_);
    }
    [[nodiscard]] std::string journal() const {
        return home_.filePath("state/ensemble/unsaved").toStdString();
    }
    [[nodiscard]] QStringList kept() const {
        return QDir(QString::fromStdString(journal())).entryList(QDir::Files | QDir::Hidden);
    }
    [[nodiscard]] QByteArray fileContent() const {
        QFile file(path_);
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }
    static void edit(DocumentWindow& window, const std::string& text) {
        document::Document& of = window.document().document();
        const std::size_t at = of.bytes().find("{Test}");
        ASSERT_EQ(of.edit({{{at + 1, at + 5}, text}}, "Edit"), document::EditResult::applied);
    }
    // A program that is edited in, and ends without a word.
    void editAndEnd(const std::string& text = "Other") {
        Application program({}, journal());
        edit(*program.open(path_), text);
    }
    // The sentences of the questions that a program asks, each answered by a click.
    static QStringList offer(Application& program, const QString& button) {
        QStringList asked;
        QTimer answers;
        QObject::connect(&answers, &QTimer::timeout, &answers, [&] {
            auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
            if (!box)
                return;
            asked << box->text() + " " + box->informativeText();
            for (QAbstractButton* one : box->buttons())
                if (one->text() == button)
                    one->click();
        });
        answers.start(10);
        program.offerRecovered();
        return asked;
    }
    static std::string bytes(const DocumentWindow& window) {
        return window.document().document().bytes();
    }

    QTemporaryDir home_;
    const QString path_ = home_.filePath("memo.ens");
    const QByteArray saved_ = memo("");
    const std::string edited_ = QByteArray(saved_).replace("{Test}", "{Other}").toStdString();
};

TEST_F(RecoveryTest, AnEditIsOnTheDiskAtOnceForTheUserAlone) {
    Application program({}, journal());
    DocumentWindow* window = program.open(path_);
    EXPECT_THAT(kept(), IsEmpty());
    edit(*window, "Other");
    window->document().unsaved()->finish();
    ASSERT_THAT(kept(), SizeIs(2));
    const std::string file = journal() + "/" + kept()[0].toStdString();
    const auto text =
        files::decoded(files::readFile(files::FileSystem::real(), file, 100'000).bytes);
    EXPECT_EQ(std::get<files::Kept>(text).text, edited_);
    EXPECT_EQ(fileContent(), saved_);
    struct stat status {};
    ASSERT_EQ(::stat(file.c_str(), &status), 0);
    EXPECT_EQ(status.st_mode & 0777, 0600u);
}

TEST_F(RecoveryTest, EditsThatNeverRestAreKept) {
    Application program({}, journal());
    DocumentWindow* window = program.open(path_);
    document::Document& of = window->document().document();
    const std::size_t at = of.bytes().find("{Test}");
    int edits = 0;
    const auto onDisk = [&] {
        for (const QString& name : kept())
            if (name.endsWith(".kept"))
                return files::readFile(files::FileSystem::real(),
                                       journal() + "/" + name.toStdString(), 100'000)
                    .bytes;
        return std::string();
    };
    // Text typed after the first text was handed over comes to the disk while typing goes on.
    EXPECT_TRUE(waitFor([&] {
        of.edit({{{at + 1, at + 1}, "x"}}, "Type", "typing");
        ++edits;
        return onDisk().find("xxxxx") != std::string::npos;
    }));
    EXPECT_GT(edits, 5);
}

TEST_F(RecoveryTest, NothingIsKeptOfWhatIsSavedUndoneOrGivenUp) {
    Application program({}, journal());
    DocumentWindow* window = program.open(path_);
    const auto isKept = [&] {
        window->document().unsaved()->finish();
        return !kept().empty();
    };
    edit(*window, "Other");
    EXPECT_TRUE(isKept());
    window->document().document().undo();
    EXPECT_TRUE(waitFor([&] { return !isKept(); }));
    window->document().document().redo();
    EXPECT_TRUE(waitFor(isKept));
    EXPECT_TRUE(window->save());
    EXPECT_TRUE(waitFor([&] { return !isKept(); }));
    window->document().document().undo();
    EXPECT_TRUE(waitFor(isKept));
    QTimer::singleShot(0, window, [] {
        auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
        ASSERT_TRUE(box);
        box->button(QMessageBox::Discard)->click();
    });
    QPointer<DocumentWindow> closed(window);
    window->close();
    EXPECT_TRUE(waitFor([&] { return !closed; }));
    EXPECT_THAT(kept(), IsEmpty());
}

TEST_F(RecoveryTest, WhatWasNotSavedIsOfferedAndOpensAsOneChange) {
    editAndEnd();
    Application program({}, journal());
    program.openNew();
    const QStringList asked = offer(program, "&Recover");
    ASSERT_THAT(asked, SizeIs(1));
    EXPECT_THAT(asked[0].toStdString(),
                testing::MatchesRegex(
                    "memo.ens was not saved before Ensemble stopped (at|on) .*[0-9][0-9]:[0-9][0-9]"
                    "\\. Recover it\\? Its file stays as it is until you save\\."));
    DocumentWindow* window = program.open(path_); // it is open already
    document::Document& of = window->document().document();
    EXPECT_EQ(bytes(*window), edited_);
    EXPECT_TRUE(of.isModified());
    EXPECT_TRUE(window->view().isWriting()); // as whoever changed it
    EXPECT_EQ(fileContent(), saved_);
    EXPECT_TRUE(waitFor([&] { // the empty memo that nobody touched has gone
        return QApplication::topLevelWidgets().count(window) == 1 &&
               program.windowsOf(window->document()).size() == 1;
    }));
    window->document().unsaved()->finish();
    EXPECT_THAT(kept(), SizeIs(2)); // until it is saved
    of.undo();
    EXPECT_EQ(bytes(*window), saved_.toStdString());
    EXPECT_FALSE(of.isModified());
    of.redo();
    EXPECT_TRUE(window->save());
    EXPECT_EQ(fileContent().toStdString(), edited_);
    EXPECT_TRUE(waitFor([&] {
        window->document().unsaved()->finish();
        return kept().empty();
    }));
}

TEST_F(RecoveryTest, TheWindowThatHasTheFileAlreadyTakesTheText) {
    editAndEnd();
    Application program({}, journal());
    DocumentWindow* window = program.open(path_);
    EXPECT_THAT(offer(program, "&Recover"), SizeIs(1));
    EXPECT_EQ(bytes(*window), edited_);
    EXPECT_EQ(window->document().document().undoLabel(), "Recover");
}

// A program that is killed at any moment of it leaves one text, not two.
TEST_F(RecoveryTest, ATextIsInOnePlaceWhileItIsRecovered) {
    editAndEnd();
    Application program({}, journal());
    DocumentWindow* window = program.open(path_);
    qsizetype most = 0;
    QObject::connect(&window->document().document(), &document::Document::changed, window, [&] {
        window->document().unsaved()->finish();
        most = std::max(most, kept().size());
    });
    EXPECT_THAT(offer(program, "&Recover"), SizeIs(1));
    EXPECT_EQ(bytes(*window), edited_);
    EXPECT_EQ(most, 2); // the text and its lock
}

TEST_F(RecoveryTest, LaterAsksAgainAndDiscardNeverAgain) {
    editAndEnd();
    EXPECT_THAT(kept(), SizeIs(2));
    for (int i = 0; i < 2; ++i) {
        Application program({}, journal());
        EXPECT_THAT(offer(program, "&Later"), SizeIs(1));
    }
    Application program({}, journal());
    EXPECT_THAT(offer(program, "&Discard"), SizeIs(1));
    EXPECT_THAT(kept(), IsEmpty());
    EXPECT_EQ(fileContent(), saved_);
}

TEST_F(RecoveryTest, AFileThatIsAnotherByNowIsNotOverwrittenUnasked) {
    editAndEnd();
    const QByteArray anothers = memo("<PARAGRAPH><TEXT>{another's}</TEXT></PARAGRAPH>\n");
    {
        QFile file(path_);
        ASSERT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(anothers);
    }
    Application program({}, journal());
    const QStringList asked = offer(program, "&Recover");
    ASSERT_THAT(asked, SizeIs(1));
    EXPECT_TRUE(asked[0].endsWith("saving asks before it replaces it.")) << asked[0].toStdString();
    DocumentWindow* window = program.open(path_);
    EXPECT_EQ(window->document().document().save().refusal, files::Refusal::changed);
    EXPECT_EQ(fileContent(), anothers);
    window->document().document().undo();
    EXPECT_EQ(bytes(*window), anothers.toStdString());
}

// Text that was typed in a medium's window and is no change of the document yet.
TEST_F(RecoveryTest, DraftsAreKeptAndTheirWindowsOpenAgain) {
    const QByteArray scripts = memo(scripted("colour 3060A0\nkeep NEWS"));
    {
        QFile file(path_);
        ASSERT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(scripts);
    }
    const auto figure = [](DocumentWindow& window) -> media::LiveSubdocument& {
        return *window.document().live(window.document().document().subdocuments().at(0));
    };
    {
        Application program({}, journal());
        DocumentWindow* window = program.open(path_);
        ASSERT_TRUE(waitFor([&] { return figure(*window).hasLoaded(); }));
        EXPECT_THAT(kept(), IsEmpty());
        figure(*window).invoke("editor", nullptr);
        ASSERT_TRUE(waitFor([&] {
            window->document().unsaved()->finish();
            return kept().size() == 2;
        }));
        EXPECT_FALSE(window->document().document().isModified());
    }
    for (int crash = 0; crash < 2; ++crash) {
        Application program({}, journal());
        const QStringList asked = offer(program, "&Recover");
        ASSERT_THAT(asked, SizeIs(1));
        EXPECT_TRUE(asked[0].endsWith("with what was typed in them.")) << asked[0].toStdString();
        if (crash == 0)
            continue; // this one ends before the window is open again
        DocumentWindow* window = program.open(path_);
        ASSERT_TRUE(waitFor([&] { return figure(*window).takesDrafts(); }));
        EXPECT_EQ(window->document().drafts(), QStringList("Scripted"));
        figure(*window).takeDrafts();
        document::Document& of = window->document().document();
        EXPECT_TRUE(waitFor([&] { return of.bytes().find("NEWSNEWS") != std::string::npos; }));
    }
}

TEST_F(RecoveryTest, TwoTextsOfOneFileAreBothOpened) {
    editAndEnd("One");
    editAndEnd("Two");
    Application program({}, journal());
    EXPECT_THAT(offer(program, "&Recover"), SizeIs(2));
    std::string all;
    for (QWidget* widget : QApplication::topLevelWidgets())
        if (auto* window = qobject_cast<DocumentWindow*>(widget))
            all += bytes(*window);
    EXPECT_THAT(all, testing::AllOf(HasSubstr("{One}"), HasSubstr("{Two}")));
}

TEST_F(RecoveryTest, ATextWithoutAFileIsOfferedToo) {
    {
        Application program({}, journal());
        DocumentWindow* window = program.openNew();
        window->document().document().edit({{{0, 0}, "\n"}}, "Edit");
    }
    Application program({}, journal());
    const QStringList asked = offer(program, "&Recover");
    ASSERT_THAT(asked, SizeIs(1));
    EXPECT_THAT(asked[0].toStdString(), HasSubstr("A document without a name was not saved"));
    EXPECT_THAT(asked[0].toStdString(), HasSubstr("It has no file yet."));
}

TEST_F(RecoveryTest, ATextWithoutAFileIsNamedByItsTitle) {
    {
        Application program({}, journal());
        DocumentWindow* window = program.openNew();
        document::Document& of = window->document().document();
        const std::size_t at = of.bytes().find("</SUBJECT>");
        ASSERT_NE(at, std::string::npos);
        const std::size_t from = of.bytes().rfind("<SUBJECT", at);
        of.edit({{{from, at}, "<SUBJECT>{Clocks}"}}, "Edit");
    }
    Application program({}, journal());
    const QStringList asked = offer(program, "&Recover");
    ASSERT_THAT(asked, SizeIs(1));
    EXPECT_THAT(asked[0].toStdString(), HasSubstr("“Clocks” was not saved before"));
}

TEST_F(RecoveryTest, WhatCannotBeReadIsSaidAndHoldsUpNothing) {
    editAndEnd();
    for (const QString& name : kept())
        if (name.endsWith(".kept"))
            std::ofstream(journal() + "/" + name.toStdString()) << "unsaved-text 1\ntext 5\nab";
    Application program({}, journal());
    EXPECT_THAT(offer(program, "&Recover"), IsEmpty());
    QString said;
    for (QWidget* widget : QApplication::topLevelWidgets())
        if (auto* box = qobject_cast<QMessageBox*>(widget)) {
            said = box->text();
            box->close(); // else no other window has the pointer
        }
    EXPECT_THAT(said.toStdString(), HasSubstr("cannot be read: it is damaged. It is in "));
}

} // namespace
} // namespace window
