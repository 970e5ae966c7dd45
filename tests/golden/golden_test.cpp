// The documents of this folder as they come onto paper, compared with the texts beside them.
// GOLDEN_WRITE=1 writes these anew: tests/golden/rebaseline does, and shows what is other.
#include "formulas/font.h"
#include "golden/page_text.h"
#include "paragraphs/typeface.h"
#include "session/presented.h"

#include <gmock/gmock.h>

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFontInfo>

namespace golden {
namespace {

const QString folder = QStringLiteral(SOURCE_DIR "/tests/golden");

std::string contentOf(const QString& file) {
    QFile from(file);
    return from.open(QIODevice::ReadOnly) ? from.readAll().toStdString() : std::string();
}

class GoldenTest : public ::testing::Test {
protected:
    std::string pagesOf(const QString& name, const QString& presentation) {
        document::Document::Loaded loaded =
            document::Document::load(folder + '/' + name + QStringLiteral(".ens"));
        EXPECT_TRUE(loaded.document) << loaded.failure.toStdString();
        if (!loaded.document)
            return {};
        session::OpenDocument document(std::move(loaded.document), schemas_, media_);
        const session::Presented presented(document, presentation);
        while (!presented.isComplete())
            QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
        return textOf(presented.pages());
    }

    schemas::Schemas schemas_ = schemas::Schemas::builtIn();
    media::PipeThread pipes_;
    media::LiveMedia media_{media::Registry::read({}), QString(), pipes_}; // no medium at all
};

TEST_F(GoldenTest, TheFontsAreThoseOfThePackages) {
    for (const auto& [family, font] :
         {std::pair("serif", "Linux Libertine O"), std::pair("sans", "Inter"),
          std::pair("mono", "DejaVu Sans Mono")}) {
        schemas::TextStyle style;
        style.family = family;
        EXPECT_EQ(QFontInfo(paragraphs::fontOf(style)).family().toStdString(), font)
            << "packaging/packages.txt names the fonts that the pages of this folder have";
    }
    EXPECT_TRUE(formulas::Font::standard());
}

TEST_F(GoldenTest, EachDocumentStandsOnItsPages) {
    const bool isWriting = qEnvironmentVariableIsSet("GOLDEN_WRITE");
    const QStringList documents = QDir(folder).entryList({"*.ens"}, QDir::Files);
    EXPECT_GE(documents.size(), 12);
    for (const QString& document : documents) {
        const QString name = document.chopped(4);
        // A new document begins with its default presentation; an empty file asks for another one.
        QStringList texts = QDir(folder).entryList({name + ".*.pages"}, QDir::Files);
        if (texts.isEmpty())
            texts.append(name + ".default.pages");
        for (const QString& text : texts) {
            const QString file = folder + '/' + text;
            const QString presentation = text.section('.', 1, 1);
            const std::string now = pagesOf(name, presentation);
            const std::string was = contentOf(file);
            if (isWriting && now != was) {
                QFile to(file);
                ASSERT_TRUE(to.open(QIODevice::WriteOnly)) << file.toStdString();
                to.write(now.data(), static_cast<qint64>(now.size()));
                continue;
            }
            const std::string difference = differenceOf(was, now);
            EXPECT_EQ(difference, "")
                << "tests/golden/" << text.toStdString() << ": " << difference
                << "Is this meant? tests/golden/rebaseline writes the texts anew and shows all.";
        }
    }
}

TEST(GoldenTextTest, ADifferenceTellsItsFirstLines) {
    EXPECT_EQ(differenceOf("a\nb\n", "a\nb\n"), "");
    EXPECT_EQ(differenceOf("a\nb\nc\n", "a\nx\nc\n"), "line 2\n- b\n- c\n+ x\n+ c\n");
    EXPECT_EQ(differenceOf("a\n", "a\nb\n"), "line 2\n+ b\n");
    EXPECT_EQ(differenceOf("", "a\n"), "line 1\n+ a\n");
}

} // namespace
} // namespace golden
