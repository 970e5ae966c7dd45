#include "document/check.h"

#include <gtest/gtest.h>

namespace document {

namespace {

// One line for each: "file:line:column: error: text".
std::string formatted(const std::vector<sgml::Fault>& faults, const std::string& file) {
    std::string lines;
    for (const sgml::Fault& fault : faults)
        lines += sgml::formatted(fault, file) + "\n";
    return lines;
}

} // namespace

TEST(Check, ListsEverythingInOrderOfPlace) {
    const Document document(
        "DOCUMENT REPORT\n"
        "<REPORT><TITLE>{x}</TITLE>\n"
        "<SECTION ID=\"a\"><PARAGRAPH>{x}</PARAGRAPH></SECTION>\n"
        "<SECTION ID=\"a\"><HEADING>{x}</HEADING><PARAGRAPH><REF TO=\"b\"></REF></PARAGRAPH>\n"
        "<DOCUMENT>DOCUMENT MOVIE\n<MOVIE WIDTH=\"-1\" ALIGN=\"top\"></MOVIE></DOCUMENT>\n"
        "<PARAGRAPH><VALUE OF=\"c\"></VALUE></PARAGRAPH>\n"
        "</SECTION>stray</REPORT>\n");
    EXPECT_EQ(
        formatted(documentFaults(document, schemas::Schemas::builtIn(), {"ANIMATION"}), "r.ens"),
        "r.ens:3:17: warning: <PARAGRAPH> does not belong here in <SECTION>; expected HEADING\n"
        "r.ens:4:1: warning: the ID a is given twice; the first counts\n"
        "r.ens:4:50: warning: nothing has the ID b that this refers to\n"
        "r.ens:6:1: warning: no medium is known for class MOVIE; it is kept as it is\n"
        "r.ens:6:8: warning: WIDTH wants a number from 1 to 20000 (1/96 inch)\n"
        "r.ens:6:19: warning: ALIGN wants left, center, right or inline\n"
        "r.ens:7:12: warning: no subdocument has the ID c\n"
        "r.ens:8:11: error: text outside braces: \"stray\"\n");
}

} // namespace document
