#include "authoring/command_testing.h"
#include "authoring/table_nodes.h"

namespace authoring {

namespace {

// The body of a memo, or of another class, after a command.
std::string inMemo(const std::string& body, const Command& command,
                   const std::string& className = "CMEMO") {
    const std::string head = "DOCUMENT " + className + "\n<" + className + "><BODY>";
    const std::string tail = "</BODY></" + className + ">\n";
    return cut(after(head + body + tail, command), head, tail);
}

Command in(Result (*command)(const Manuscript&, Selection, Direction), Direction direction) {
    return [=](const Manuscript& manuscript, Selection selection) {
        return command(manuscript, selection, direction);
    };
}

const Command up = in(moveRow, Direction::backward), down = in(moveRow, Direction::forward);
const Command left = in(moveColumn, Direction::backward),
              right = in(moveColumn, Direction::forward);

} // namespace

TEST(Tables, AreMadeWithHeaderAndCaption) {
    const auto table = [](const Manuscript& manuscript, Selection selection) {
        return insertTable(manuscript, selection, {1, 2, true, true, "On {it}"});
    };
    EXPECT_EQ(inMemo("<P>{|}</P>", table), "<TABLE>\n<CAPTION>{On \\{it\\}}</CAPTION>\n"
                                           "<R KIND=\"header\"><C>{|}</C><C>{}</C></R>\n</TABLE>");
    // In a report the first row is one.
    EXPECT_EQ(inMemo("<P>{|}</P>", table, "REPORT"),
              "<TABLE>\n<CAPTION>{On \\{it\\}}</CAPTION>\n<R><C>{|}</C><C>{}</C></R>\n</TABLE>");
    const auto plain = [](const Manuscript& manuscript, Selection selection) {
        return insertTable(manuscript, selection, {1, 1});
    };
    EXPECT_EQ(inMemo("<P>{|}</P>", plain, "REPORT"),
              "<TABLE>\n<R KIND=\"body\"><C>{|}</C></R>\n</TABLE>");
}

TEST(Tables, CellsAreAlignedAndANewRowIsAsTheOneBesideIt) {
    const auto align = [](const char* how) {
        return [how](const Manuscript& manuscript, Selection selection) {
            return alignCells(manuscript, selection, how);
        };
    };
    const std::string one = "<TABLE><R><C>{a}</C><C>{|b}</C></R></TABLE>";
    const std::string centred = "<TABLE><R><C>{a}</C><C ALIGN=\"center\">{|b}</C></R></TABLE>";
    EXPECT_EQ(inMemo(one, align("center")), centred);
    EXPECT_EQ(inMemo(centred, align("")), one);
    EXPECT_EQ(inMemo("<TABLE><R><C>{[a}</C><C>{b|}</C></R></TABLE>", align("right")),
              "<TABLE><R><C ALIGN=\"right\">{[a}</C><C ALIGN=\"right\">{b|}</C></R></TABLE>");
    EXPECT_EQ(inMemo("<P>{a|}</P>", align("right")), "refused: The caret is in no table.");
    EXPECT_EQ(inMemo("<TABLE>\n<R><C>{a}</C><C ALIGN=\"right\">{b|}</C></R>\n</TABLE>",
                     in(insertRow, Direction::forward)),
              "<TABLE>\n<R><C>{a}</C><C ALIGN=\"right\">{b}</C></R>\n"
              "<R><C>{}</C><C ALIGN=\"right\">{|}</C></R>\n</TABLE>");
}

TEST(Tables, RowsAndColumnsMove) {
    const std::string table = "<TABLE>\n<R><C>{a}</C><C>{b|}</C></R>\n<R><C>{c}</C><C>{d}</C></R>"
                              "\n<R><C>{e}</C></R>\n</TABLE>";
    EXPECT_EQ(inMemo(table, down), "<TABLE>\n<R><C>{c}</C><C>{d}</C></R>\n<R><C>{a}</C><C>{b|}</C>"
                                   "</R>\n<R><C>{e}</C></R>\n</TABLE>");
    EXPECT_EQ(inMemo(table, up), "refused: This is the first row.");
    EXPECT_EQ(inMemo(table, left), "<TABLE>\n<R><C>{b|}</C><C>{a}</C></R>\n<R><C>{d}</C><C>{c}</C>"
                                   "</R>\n<R><C>{e}</C></R>\n</TABLE>");
    EXPECT_EQ(inMemo(table, right), "refused: This is the last column.");
    // Selected rows go together.
    EXPECT_EQ(inMemo("<TABLE><R><C>{a[}</C></R><R><C>{b|}</C></R><R><C>{c}</C></R></TABLE>", down),
              "<TABLE><R><C>{c}</C></R><R><C>{a[}</C></R><R><C>{b|}</C></R></TABLE>");
    const std::string joined = "<TABLE><R><C ROWS=\"2\">{a}</C><C>{b}</C></R><R><C>{c|}</C></R>"
                               "<R><C>{d}</C><C>{e}</C></R></TABLE>";
    EXPECT_EQ(inMemo(joined, down),
              "<TABLE><R><C>{d}</C><C>{e}</C></R><R><C ROWS=\"2\">{a}</C><C>{b}</C></R>"
              "<R><C>{c|}</C></R></TABLE>");
    EXPECT_EQ(
        inMemo("<TABLE WIDTHS=\"10mm auto 7mm\"><R><C>{a|}</C><C>{b}</C><C>{c}</C></R></TABLE>",
               right),
        "<TABLE WIDTHS=\"auto 10mm 7mm\"><R><C>{b}</C><C>{a|}</C><C>{c}</C></R></TABLE>");
}

TEST(Tables, CellsAreJoinedAndSplit) {
    EXPECT_EQ(inMemo("<TABLE><R><C>{a[}</C><C>{b}</C></R><R><C>{c}</C><C>{d|}</C></R></TABLE>",
                     joinCells),
              "<TABLE><R><C COLUMNS=\"2\" ROWS=\"2\"><P>{|a}</P><P>{b}</P><P>{c}</P><P>{d}</P></C>"
              "</R><R></R></TABLE>");
    EXPECT_EQ(inMemo("<TABLE><R><C>{[}</C><C><E>{b|}</E></C><C>{c}</C></R></TABLE>", joinCells),
              "<TABLE><R><C COLUMNS=\"2\"><E>{|b}</E></C><C>{c}</C></R></TABLE>");
    EXPECT_EQ(inMemo("<TABLE><R><C>{a|}</C></R></TABLE>", joinCells),
              "refused: Select several cells of the table first.");
    EXPECT_EQ(inMemo("<TABLE><R><C COLUMNS=\"2\" ROWS=\"2\">{|a}</C><C>{b}</C></R>"
                     "<R><C>{c}</C></R></TABLE>",
                     splitCell),
              "<TABLE><R><C>{|a}</C><C>{}</C><C>{b}</C></R><R><C>{}</C><C>{}</C><C>{c}</C></R>"
              "</TABLE>");
    EXPECT_EQ(inMemo("<TABLE><R><C>{a|}</C></R></TABLE>", splitCell),
              "refused: This cell was not joined of several.");
}

TEST(Tables, JoinedCellsFollowRowsAndColumns) {
    const std::string wide = "<TABLE><R><C COLUMNS=\"2\">{a}</C></R><R><C>{b|}</C><C>{c}</C></R>"
                             "</TABLE>";
    EXPECT_EQ(
        inMemo(wide, in(insertColumn, Direction::forward)),
        "<TABLE><R><C COLUMNS=\"3\">{a}</C></R><R><C>{b}</C><C>{|}</C><C>{c}</C></R></TABLE>");
    EXPECT_EQ(inMemo(wide, removeColumn), "<TABLE><R><C>{a}</C></R><R><C>{|c}</C></R></TABLE>");
    const std::string tall = "<TABLE><R><C ROWS=\"2\">{a}</C><C>{b|}</C></R><R><C>{c}</C></R>"
                             "</TABLE>";
    EXPECT_EQ(inMemo(tall, in(insertRow, Direction::forward)),
              "<TABLE><R><C ROWS=\"3\">{a}</C><C>{b}</C></R>\n<R><C>{|}</C></R><R><C>{c}</C></R>"
              "</TABLE>");
    EXPECT_EQ(inMemo(tall, removeRow), "<TABLE><R><C>{a}</C><C>{|c}</C></R></TABLE>");
}

TEST(Tables, AreRemoved) {
    const std::string table = "<TABLE><R><C>{a|}</C></R></TABLE>";
    EXPECT_EQ(inMemo("<P>{b}</P>\n" + table, removeTable), "<P>{b|}</P>");
    EXPECT_EQ(
        inMemo("<FIGURE>" + table + "<CAPTION>{c}</CAPTION></FIGURE>\n<P>{b}</P>", removeTable),
        "\n<P>{|b}</P>");
    EXPECT_EQ(inMemo(table, removeTable), "<P>{|}</P>");
    EXPECT_EQ(inMemo(table, removeRow), "refused: These are all rows. Remove the table instead.");
}

TEST(Tables, HeadersAreToggled) {
    const std::string table = "<TABLE><R><C>{a|}</C></R><R><C>{b}</C></R></TABLE>";
    const std::string headed = "<TABLE><R KIND=\"header\"><C>{a|}</C></R><R><C>{b}</C></R></TABLE>";
    EXPECT_EQ(inMemo(table, toggleHeader), headed);
    EXPECT_EQ(inMemo(headed, toggleHeader), table);
    EXPECT_EQ(inMemo(table, toggleHeader, "REPORT"),
              "<TABLE><R KIND=\"body\"><C>{a|}</C></R><R><C>{b}</C></R></TABLE>");
}

TEST(Tables, WidthsAreAttributes) {
    const auto width = [](double points) {
        return [points](const Manuscript& manuscript, Selection selection) {
            return setColumnWidth(manuscript, selection, points);
        };
    };
    EXPECT_EQ(inMemo("<TABLE><R><C>{a}</C><C>{b|}</C></R></TABLE>", width(72)),
              "<TABLE WIDTHS=\"auto 25.4mm\"><R><C>{a}</C><C>{b|}</C></R></TABLE>");
    EXPECT_EQ(inMemo("<TABLE ID=\"x\" WIDTHS=\"auto 25.4mm\"><R><C>{a}</C><C>{b|}</C></R></TABLE>",
                     width(0)),
              "<TABLE ID=\"x\"><R><C>{a}</C><C>{b|}</C></R></TABLE>");
}

TEST(Tables, SeveralCellsAreSelectedAsARectangle) {
    const std::string table = "<TABLE><R><C>{a}</C><C>{b[}</C></R><R><C>{c}</C><C>{d|}</C></R>"
                              "</TABLE>";
    const auto erased = [](const Manuscript& manuscript, Selection selection) {
        return erase(manuscript, selection, Direction::forward);
    };
    EXPECT_EQ(inMemo(table, erased),
              "<TABLE><R><C>{a}</C><C>{|}</C></R><R><C>{c}</C><C>{}</C></R></TABLE>");
    const auto strong = [](const Manuscript& manuscript, Selection selection) {
        return toggle(manuscript, selection, schemas::ContainerRole::strong);
    };
    EXPECT_EQ(
        inMemo("<TABLE><R><C>{[a}</C><C>{b}</C></R><R><C>{c|}</C><C>{d}</C></R></TABLE>", strong),
        "<TABLE><R><C><B>{[a}</B></C><C>{b}</C></R><R><C><B>{c|}</B></C><C>{d}</C></R></TABLE>");
    const auto part = [](TablePart which) {
        return [which](const Manuscript& manuscript, Selection selection) {
            return selectInTable(manuscript, selection, which);
        };
    };
    const std::string one =
        "<TABLE><R><C>{a}</C><C>{b}</C></R><R><C>{c|}</C><C>{d}</C></R></TABLE>";
    EXPECT_EQ(inMemo(one, part(TablePart::column)),
              "<TABLE><R><C>{[a}</C><C>{b}</C></R><R><C>{c|}</C><C>{d}</C></R></TABLE>");
    EXPECT_EQ(inMemo(one, part(TablePart::row)),
              "<TABLE><R><C>{a}</C><C>{b}</C></R><R><C>{[c}</C><C>{d|}</C></R></TABLE>");
    EXPECT_EQ(inMemo(one, part(TablePart::table)),
              "<TABLE><R><C>{[a}</C><C>{b}</C></R><R><C>{c}</C><C>{d|}</C></R></TABLE>");
}

} // namespace authoring
