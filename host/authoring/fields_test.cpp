#include "authoring/command_testing.h"

namespace authoring {

namespace {

Command tab(Direction direction) {
    return [direction](const Manuscript& manuscript, Selection selection) {
        return goToField(manuscript, selection, direction);
    };
}

std::string reportForm(const std::string& inside) {
    return "DOCUMENT REPORT\n<REPORT>" + inside + "</REPORT>";
}

} // namespace

TEST(Fields, EnterLeadsThroughAnEmptyForm) {
    const std::string rest = "<S><H>{}</H><P><T>{}</T></P></S>";
    const auto form = [&](const std::string& title, const std::string& author) {
        return reportForm("<TITLE>{" + title + "}</TITLE><AUTHOR>{" + author + "}</AUTHOR>" + rest);
    };
    EXPECT_EQ(after(form("Falling|", ""), breakParagraph), form("Falling", "|"));
    EXPECT_EQ(after(form("T", "Me|"), breakParagraph),
              reportForm("<TITLE>{T}</TITLE><AUTHOR>{Me}</AUTHOR>"
                         "<S><H>{|}</H><P><T>{}</T></P></S>"));
    EXPECT_EQ(
        after(reportForm("<TITLE>{T}</TITLE><S><H>{One|}</H><P><T>{}</T></P></S>"), breakParagraph),
        reportForm("<TITLE>{T}</TITLE><S><H>{One}</H><P><T>{|}</T></P></S>"));
}

TEST(Fields, EnterMakesAParagraphWhereTheNextLineIsWritten) {
    EXPECT_EQ(after(reportForm("<S><H>{One|}</H><P>{text}</P></S>"), breakParagraph),
              reportForm("<S><H>{One}</H>\n<P>{|}</P><P>{text}</P></S>"));
    EXPECT_EQ(after(reportForm("<P>{One|}</P><P>{}</P>"), breakParagraph),
              reportForm("<P>{One}</P>\n<P>{|}</P><P>{}</P>"));
}

TEST(Fields, TabGoesToTheNextFieldOrEmptyLineAndBack) {
    const std::string memo = "DOCUMENT CMEMO\n<CMEMO><TO>{A|}</TO><FROM>{Me}</FROM><BODY><P>{}</P>"
                             "<P>{x}</P></BODY></CMEMO>";
    const std::string from = "DOCUMENT CMEMO\n<CMEMO><TO>{A}</TO><FROM>{Me|}</FROM><BODY><P>{}</P>"
                             "<P>{x}</P></BODY></CMEMO>";
    const std::string text = "DOCUMENT CMEMO\n<CMEMO><TO>{A}</TO><FROM>{Me}</FROM><BODY><P>{|}</P>"
                             "<P>{x}</P></BODY></CMEMO>";
    EXPECT_EQ(after(memo, tab(Direction::forward)), from);
    EXPECT_EQ(after(from, tab(Direction::forward)), text);
    EXPECT_EQ(after(text, tab(Direction::backward)), from);
    EXPECT_EQ(after(from, tab(Direction::backward)), memo);
    EXPECT_EQ(after(memo, tab(Direction::backward)), "refused: No field is before this.");
    EXPECT_EQ(after(reportForm("<P>{a|}</P><P>{}</P>"), tab(Direction::forward)),
              "refused: The caret is in no field.");
}

} // namespace authoring
