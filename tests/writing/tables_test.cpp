// Tables and pictures in a writing view, by pointer and keys.
#include "strips/stock.h"
#include "view/resizing.h"
#include "writing/writing_testing.h"

#include <QClipboard>
#include <QMimeData>
#include <QSpinBox>

namespace writing {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

const QByteArray table = "<TABLE><ROW><CELL>{one}</CELL><CELL>{two}</CELL></ROW>\n"
                         "<ROW><CELL>{three}</CELL><CELL>{four}</CELL></ROW></TABLE>\n";

class TablesTest : public WritingTest {
protected:
    // The place of the border behind a column, in the viewport.
    [[nodiscard]] QPoint border(std::size_t column) const {
        const layout::PlacedRows& rows = view().pages().pages.front()->tables.front();
        double x = rows.left;
        for (std::size_t c = 0; c <= column; ++c)
            x += rows.columns->widths[c];
        return view().inViewport(0, {x, (rows.top + rows.bottom) / 2, 0, 0}).topLeft().toPoint();
    }
    void drag(QPoint from, QPoint to) const {
        QWidget* pages = view().viewport();
        QTest::mousePress(pages, Qt::LeftButton, {}, from);
        QTest::mouseMove(pages, (from + to) / 2);
        QTest::mouseMove(pages, to);
        QTest::mouseRelease(pages, Qt::LeftButton, {}, to);
    }
};

TEST_F(TablesTest, ATableIsAskedForAndWritten) {
    write(paragraph(""));
    goTo("}</TEXT></PARAGRAPH>\n</BODY>");
    answering("insertTable", [](QDialog& dialog) {
        dialog.findChild<QSpinBox*>("rows")->setValue(2);
        dialog.findChild<QSpinBox*>("columns")->setValue(2);
        dialog.findChild<QLineEdit*>("caption")->setText("Masses");
        dialog.accept();
    });
    type("a");
    press(Qt::Key_Tab);
    type("b");
    press(Qt::Key_Down);
    type("d");
    press(Qt::Key_Backtab, Qt::ShiftModifier);
    type("c");
    EXPECT_THAT(body(), HasSubstr("<TABLE WIDTHS=\""));
    EXPECT_THAT(body(), HasSubstr("mm\">\n<CAPTION>{Masses}</CAPTION>\n"
                                  "<ROW KIND=\"header\"><CELL>{a}</CELL><CELL>{b}</CELL></ROW>\n"
                                  "<ROW><CELL>{c}</CELL><CELL>{d}</CELL></ROW>\n</TABLE>\n"));
    press(Qt::Key_Up, Qt::AltModifier);
    EXPECT_THAT(body(), HasSubstr("</CAPTION>\n<ROW><CELL>{c}"));
    press(Qt::Key_Right, Qt::AltModifier);
    EXPECT_THAT(body(), HasSubstr("<ROW><CELL>{d}</CELL><CELL>{c}</CELL></ROW>"));
}

TEST_F(TablesTest, TheMenuOffersWhatIsAllowedAndSaysWhyNot) {
    write(paragraph("text") + table);
    auto* menu = window_->findChild<QMenu*>("table");
    ASSERT_TRUE(menu);
    goTo("text");
    Q_EMIT menu->aboutToShow();
    EXPECT_FALSE(action("rowBelow")->isEnabled());
    EXPECT_THAT(action("rowBelow")->toolTip().toStdString(), HasSubstr("in no table"));
    EXPECT_TRUE(action("insertTable")->isEnabled());
    Q_EMIT menu->aboutToHide();
    goTo("two");
    Q_EMIT menu->aboutToShow();
    EXPECT_TRUE(action("rowBelow")->isEnabled());
    EXPECT_FALSE(action("joinCells")->isEnabled());
    EXPECT_FALSE(action("headerRow")->isChecked());
    Q_EMIT menu->aboutToHide();
    action("headerRow")->trigger();
    Q_EMIT menu->aboutToShow();
    EXPECT_TRUE(action("headerRow")->isChecked());
}

TEST_F(TablesTest, ABorderIsDraggedAndTakenBack) {
    write(table);
    const std::string before = document().bytes();
    const QPoint from = border(0);
    drag(from, from + QPoint(10, 0)); // the column behind it keeps some width
    EXPECT_THAT(body(), HasSubstr("<TABLE WIDTHS=\""));
    EXPECT_TRUE(waitFor([&] { return std::abs(border(0).x() - from.x() - 10) <= 1; })) << body();
    QTest::mouseDClick(view().viewport(), Qt::LeftButton, {}, border(0));
    EXPECT_THAT(body(), HasSubstr("<TABLE WIDTHS=\"auto "));
    document().undo();
    document().undo();
    EXPECT_EQ(document().bytes(), before);
    drag(border(1), border(1) + QPoint(0, 5)); // not moved: no change
    EXPECT_EQ(document().bytes(), before);
}

TEST_F(TablesTest, SelectedColumnsAreCopiedAndErased) {
    write(table);
    goTo("three");
    action("selectColumn")->trigger();
    action("copy")->trigger();
    const QMimeData* copied = QApplication::clipboard()->mimeData();
    EXPECT_EQ(copied->text(), "one\nthree");
    action("cut")->trigger();
    EXPECT_THAT(body(), HasSubstr("<ROW><CELL>{}</CELL><CELL>{two}</CELL></ROW>"));
    EXPECT_THAT(body(), HasSubstr("<ROW><CELL>{}</CELL><CELL>{four}</CELL></ROW>"));
}

TEST_F(TablesTest, AFigureIsResizedByItsCorner) {
    write(scripted("animation"));
    const document::SubdocumentId id = document().subdocuments().front();
    const QRectF place = view().placeOf(id);
    QTest::mouseClick(view().viewport(), Qt::LeftButton, {}, place.center().toPoint());
    ASSERT_EQ(view().chosen(), id);
    ASSERT_TRUE(view::sizedUnit(view()));
    const QPoint corner = place.bottomRight().toPoint();
    drag(corner, corner + QPoint(-30, -20));
    const auto width = [&] { return document().subdocument(id)->width.value_or(0); };
    EXPECT_LT(width(), 300);
    EXPECT_NEAR(document().subdocument(id)->height.value_or(0) / width(), 2.0 / 3, 0.02);
    document().undo();
    EXPECT_EQ(width(), 300);
}

} // namespace
} // namespace writing
