// Typographic signs from a keyboard's letters, by language.
#include "typography/typed_signs.h"

#include <gtest/gtest.h>

namespace typography {
namespace {

// The line after each letter of it was typed.
QString typedLine(QStringView letters, QStringView language) {
    QString line;
    for (const QChar letter : letters) {
        line += letter;
        if (const auto made = signTyped(line, language))
            line = line.chopped(made->letters) + made->text;
    }
    return line;
}

struct Typed {
    const char* language;
    const char* letters;
    const char* line;
};

const Typed typed[] = {
    {"", "\"so\", he said", "“so”, he said"},
    {"en", "a (\"b\") 'c' don't \"the dogs' 'x'\"", "a (“b”) ‘c’ don’t “the dogs’ ‘x’”"},
    {"de", "er sagt: \"so\", \"'s geht's'\"", "er sagt: „so“, „‚s geht’s‘“"},
    {"de-CH", "\"so\"", "«so»"},
    {"fr", "il dit \"l'eau\" !", "il dit «\u202Fl’eau\u202F»\u202F!"},
    {"fr", "ainsi : oui ; a:b", "ainsi\u00A0: oui\u202F; a:b"},
    {"sv", "\"så\" 'så'", "”så” ’så’"},
    {"es", "\"sí\"", "«sí»"},
    {"it", "\"l'acqua\"", "«l’acqua»"},
    {"pl", "\"tak\"", "„tak”"},
    {"nl", "\"ja\" 'nee'", "“ja” ‘nee’"},
    {"xx", "\"a\"", "\"a\""},
    {"en", "pages 3--5, so---no, a -- b", "pages 3–5, so—no, a – b"},
    {"en", "-5 and (-5) and x=-1, 3-5, a-5, e-5", "−5 and (−5) and x=−1, 3-5, a-5, e-5"},
    {"en", "and... .... v1.2.3", "and… …. v1.2.3"},
    {"en", "6' 5\" tall, \"of 5\"", "6' 5\" tall, “of 5”"},
    {"en", "rock 'n' roll !", "rock ‘n’ roll !"},
    {"en", "----", "—-"},
};

TEST(TypedSigns, BecomeThoseOfTheLanguage) {
    for (const Typed& one : typed)
        EXPECT_EQ(typedLine(QString::fromUtf8(one.letters), QString::fromUtf8(one.language))
                      .toStdString(),
                  one.line)
            << one.language << ": " << one.letters;
}

TEST(TypedSigns, NothingIsMadeBehindWhatWasTakenBack) {
    EXPECT_EQ(signTyped(u"---", u"en"), std::nullopt);
    EXPECT_EQ(signTyped(u"....", u"en"), std::nullopt);
    EXPECT_EQ(signTyped(u"-52", u"en"), std::nullopt);
    EXPECT_EQ(signTyped(u"", u"en"), std::nullopt);
    EXPECT_EQ(signTyped(u"\uFFFC\"", u"en"), (SignMade{1, QStringLiteral("”")}));
}

} // namespace
} // namespace typography
