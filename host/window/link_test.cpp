#include "window/link.h"

#include <gtest/gtest.h>

namespace window {
namespace {

QString placeOf(const QString& target) {
    const std::optional<Link> link = linkTo(target);
    return link ? link->place : QStringLiteral("none");
}

TEST(Link, IsShownAsTheHostThatIsAsked) {
    EXPECT_EQ(placeOf("https://example.org/a?b#c"), "https://example.org");
    EXPECT_EQ(placeOf("HTTP://Example.ORG:8080"), "http://example.org:8080");
    // The part before @ is a name to log in with.
    EXPECT_EQ(placeOf("https://bank.example@evil.example/"), "https://evil.example");
    EXPECT_EQ(placeOf("https://bank.example:secret@evil.example/"), "https://evil.example");
}

TEST(Link, ShowsLettersThatLookLikeOthersAsPunycode) {
    EXPECT_EQ(placeOf(QStringLiteral("https://b\u0430nk.example")), "https://xn--bnk-6cd.example");
    EXPECT_FALSE(placeOf(QStringLiteral("https://\u202Egro.example")).contains(QChar(0x202E)));
}

TEST(Link, OfMarkupStaysText) {
    EXPECT_EQ(placeOf("https://evil.example/<b>https://bank.example</b>"), "https://evil.example");
    EXPECT_EQ(placeOf("mailto:a@b.example?subject=x"), "mailto:a@b.example");
    EXPECT_EQ(placeOf("mailto:<img src=\"/dev/zero\">"), "mailto:%3Cimg%20src=%22/dev/zero%22%3E");
}

TEST(Link, ToAnythingElseIsNone) {
    for (const char* target :
         {"file:///etc/passwd", "javascript:alert(1)", "figure-3", "", "https:", "https:///path",
          "http://a b", "mailto:", "ftp://example.org"})
        EXPECT_EQ(placeOf(target), "none") << target;
}

} // namespace
} // namespace window
