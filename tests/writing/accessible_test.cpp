// What screen readers get of a document: its parts, their text, and what changes, by the interfaces
// that the accessibility bus has.
#include "accessibility/accessible_view.h"
#include "reading/block_text.h"
#include "writing/writing_testing.h"

#include <QAccessible>

namespace writing {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::vector<std::string> heard; // events, as words

void hear(QAccessibleEvent& event) {
    const QAccessibleInterface* of = event.accessibleInterface();
    if (!of || of->object()) // widgets
        return;
    std::string what;
    if (auto* come = dynamic_cast<QAccessibleTextInsertEvent*>(&event))
        what = "+" + come->textInserted().toStdString() + " at " +
               std::to_string(come->changePosition());
    else if (auto* gone = dynamic_cast<QAccessibleTextRemoveEvent*>(&event))
        what = "-" + gone->textRemoved().toStdString() + " at " +
               std::to_string(gone->changePosition());
    else if (auto* selected = dynamic_cast<QAccessibleTextSelectionEvent*>(&event))
        what = "selected " + std::to_string(selected->selectionStart()) + " to " +
               std::to_string(selected->selectionEnd());
    else if (auto* caret = dynamic_cast<QAccessibleTextCursorEvent*>(&event))
        what = "caret " + std::to_string(caret->cursorPosition());
    else if (event.type() == QAccessible::Focus)
        what = "focus";
    else if (event.type() == QAccessible::ObjectCreated)
        what = "new";
    else if (event.type() == QAccessible::ObjectDestroyed)
        what = "gone";
    heard.push_back(what);
}

class AccessibleTest : public WritingTest {
protected:
    AccessibleTest() {
        heard.clear();
        accessibility::AccessibleView::heard = hear;
    }
    ~AccessibleTest() override { accessibility::AccessibleView::heard = nullptr; }

    [[nodiscard]] QAccessibleInterface* pages() const {
        return QAccessible::queryAccessibleInterface(&view());
    }
    // All parts with a role, in order.
    static void collect(QAccessibleInterface* in, QAccessible::Role role,
                        std::vector<QAccessibleInterface*>& found) {
        for (int i = 0; i < in->childCount(); ++i) {
            QAccessibleInterface* part = in->child(i);
            ASSERT_TRUE(part);
            if (part->object())
                continue;
            EXPECT_EQ(part->parent(), in);
            EXPECT_EQ(in->indexOfChild(part), i);
            if (part->role() == role)
                found.push_back(part);
            collect(part, role, found);
        }
    }
    [[nodiscard]] std::vector<QAccessibleInterface*> parts(QAccessible::Role role) const {
        std::vector<QAccessibleInterface*> found;
        collect(pages(), role, found);
        return found;
    }
    static std::string textOf(QAccessibleInterface* part) {
        QAccessibleTextInterface* of = part->textInterface();
        return of ? of->text(0, of->characterCount()).toStdString() : "no text";
    }
};

TEST_F(AccessibleTest, EachPartHasItsRoleItsNameAndItsText) {
    window_ = open("DOCUMENT REPORT\n<REPORT><SECTION><HEADING>{One}</HEADING>"
                   "<PARAGRAPH><TEXT>{See }</TEXT><LINK TO=\"http://a\">{there}</LINK>"
                   "<TEXT>{ and }</TEXT><FORMULA>{x^2}</FORMULA></PARAGRAPH>"
                   "<LIST><ITEM>{first}</ITEM><ITEM>{second}</ITEM></LIST>"
                   "<FIGURE><IMAGE FILE=\"a.png\" ALT=\"A tree\"></IMAGE>"
                   "<CAPTION>{Tree}</CAPTION></FIGURE>"
                   "<TABLE><CAPTION>{Sizes}</CAPTION><ROW><CELL>{Body}</CELL><CELL>{Size}</CELL>"
                   "</ROW><ROW><CELL>{Earth}</CELL><CELL>{1}</CELL></ROW></TABLE>"
                   "</SECTION></REPORT>\n");
    ASSERT_TRUE(waitFor([&] { return view().isLaidOut(); }));
    EXPECT_EQ(pages()->role(), QAccessible::Document);
    const auto headings = parts(QAccessible::Heading);
    ASSERT_EQ(headings.size(), 1u);
    EXPECT_EQ(textOf(headings[0]), "1 One");
    EXPECT_EQ(headings[0]->text(QAccessible::Description), "Level 1");
    EXPECT_TRUE(headings[0]->state().expanded);
    EXPECT_EQ(headings[0]->parent()->role(), QAccessible::Section);
    EXPECT_EQ(headings[0]->parent()->text(QAccessible::Name), "1 One");
    const auto links = parts(QAccessible::Link);
    ASSERT_EQ(links.size(), 1u);
    EXPECT_EQ(links[0]->text(QAccessible::Name), "there");
    EXPECT_EQ(textOf(links[0]->parent()), "See there and x squared");
    const auto items = parts(QAccessible::ListItem);
    ASSERT_EQ(items.size(), 2u);
    EXPECT_EQ(items[0]->parent()->role(), QAccessible::List);
    const auto graphics = parts(QAccessible::Graphic);
    ASSERT_EQ(graphics.size(), 1u);
    EXPECT_EQ(graphics[0]->text(QAccessible::Name), "A tree");
    EXPECT_EQ(graphics[0]->parent()->text(QAccessible::Name), "Figure 1: Tree");
    const auto tables = parts(QAccessible::Table);
    ASSERT_EQ(tables.size(), 1u);
    EXPECT_EQ(tables[0]->text(QAccessible::Name), "Table 1: Sizes");
    QAccessibleTableInterface* table = tables[0]->tableInterface();
    ASSERT_TRUE(table);
    EXPECT_EQ(table->rowCount(), 2);
    EXPECT_EQ(table->columnCount(), 2);
    EXPECT_EQ(table->cellAt(1, 0)->text(QAccessible::Name), "Earth");
    EXPECT_EQ(table->cellAt(0, 0)->role(), QAccessible::ColumnHeader);
    const auto headers = table->cellAt(1, 1)->tableCellInterface()->columnHeaderCells();
    ASSERT_EQ(headers.size(), 1);
    EXPECT_EQ(headers[0]->text(QAccessible::Name), "Size");
    // Where a point is, there is the part.
    const QPoint middle = headings[0]->textInterface()->characterRect(3).center();
    EXPECT_EQ(pages()->childAt(middle.x(), middle.y()), headings[0]);
    EXPECT_TRUE(headings[0]->rect().contains(middle));
}

TEST_F(AccessibleTest, ItsCaretAndWhatIsSelectedAreThoseOfTheView) {
    write(paragraph("One \u00E4 two") + "<LIST KIND=\"number\"><ITEM>{item}</ITEM></LIST>");
    const auto paragraphs = parts(QAccessible::Paragraph);
    const auto one = std::ranges::find(paragraphs, "One \u00E4 two", textOf);
    ASSERT_NE(one, paragraphs.end());
    QAccessibleTextInterface& of = *(*one)->textInterface();
    EXPECT_TRUE((*one)->state().editable);
    goTo("two");
    EXPECT_EQ(of.cursorPosition(), 6);
    EXPECT_TRUE((*one)->state().focused);
    EXPECT_EQ(pages()->focusChild(), *one);
    EXPECT_EQ(of.offsetAtPoint(of.characterRect(6).center()), 6);
    int from = -1, to = -1;
    EXPECT_THAT(of.attributes(1, &from, &to).toStdString(), HasSubstr("font-size:11pt"));
    QAccessibleInterface* item = parts(QAccessible::ListItem).at(0);
    EXPECT_EQ(textOf(item), "1. item");
    EXPECT_EQ(item->textInterface()->cursorPosition(), -1);
    item->textInterface()->setCursorPosition(3);
    type("an ");
    EXPECT_THAT(body(), HasSubstr("{an item}"));
    EXPECT_EQ(textOf(item), "1. an item");
    of.setSelection(0, 6, 9);
    EXPECT_EQ(of.selectionCount(), 1);
    press(Qt::Key_Delete);
    EXPECT_EQ(textOf(*one), "One \u00E4 ");
}

TEST_F(AccessibleTest, AKeyIsToldAsItsLetterAndReadsItsParagraphAlone) {
    QByteArray body;
    for (int i = 0; i < 400; ++i)
        body += paragraph("Some words of paragraph " + QByteArray::number(i));
    write(body);
    goTo("paragraph 7}");
    (void)parts(QAccessible::Paragraph);
    press(Qt::Key_Right);
    heard.clear();
    const std::size_t letters = reading::BlockText::letters;
    type("x");
    EXPECT_THAT(heard, ElementsAre("+x at 15", "caret 16"));
    EXPECT_LE(reading::BlockText::letters - letters, 200u);
    heard.clear();
    press(Qt::Key_Backspace);
    EXPECT_THAT(heard, ElementsAre("-x at 15", "caret 15"));
    heard.clear();
    press(Qt::Key_Right, Qt::ShiftModifier);
    EXPECT_THAT(heard, ElementsAre("caret 16", "selected 15 to 16"));
    heard.clear();
    press(Qt::Key_Down);
    EXPECT_THAT(heard, ::testing::Contains("focus"));
    heard.clear();
    // Of 400 paragraphs not all may be laid out at once: what takes longer follows.
    const auto isHeard = [](const char* word) { return std::ranges::count(heard, word) > 0; };
    press(Qt::Key_Return);
    EXPECT_TRUE(waitFor([&] { return isHeard("new") && isHeard("focus"); }));
    heard.clear();
    document().undo();
    EXPECT_TRUE(waitFor([&] { return isHeard("gone"); }));
}

TEST_F(AccessibleTest, ALineIsTheOneOfThePage) {
    write(paragraph("Here are so many words that they take more than one line of the page, since "
                    "a page is no wider than this, and the sentence goes on and on."));
    QAccessibleInterface* part = parts(QAccessible::Paragraph).back();
    QAccessibleTextInterface& of = *part->textInterface();
    int from = -1, to = -1;
    const QString first = of.textAtOffset(3, QAccessible::LineBoundary, &from, &to);
    EXPECT_EQ(from, 0);
    EXPECT_GT(to, 20);
    EXPECT_LT(to, of.characterCount());
    EXPECT_TRUE(first.startsWith("Here are"));
    const QString second = of.textAfterOffset(3, QAccessible::LineBoundary, &from, &to);
    EXPECT_GT(from, 20);
    EXPECT_FALSE(second.isEmpty());
}

TEST_F(AccessibleTest, ALinkIsFollowedAndAFigureChosen) {
    write("<PARAGRAPH><LINK TO=\"http://example.org/\">{there}</LINK></PARAGRAPH>\n" +
          scripted("duration 4", "ALT=\"A box\""));
    QObject::disconnect(&view(), &view::DocumentView::linkActivated, window_, nullptr); // it asks
    QString followed;
    QObject::connect(&view(), &view::DocumentView::linkActivated, &view(),
                     [&](const QString& target) { followed = target; });
    parts(QAccessible::Link)
        .at(0)
        ->actionInterface()
        ->doAction(QAccessibleActionInterface::pressAction());
    EXPECT_EQ(followed, "http://example.org/");
    QAccessibleInterface* figure = nullptr;
    for (const QAccessible::Role role : {QAccessible::Graphic, QAccessible::Animation})
        for (QAccessibleInterface* one : parts(role))
            figure = one;
    ASSERT_TRUE(figure);
    EXPECT_EQ(figure->text(QAccessible::Name), "A box");
    heard.clear();
    figure->actionInterface()->doAction(QAccessibleActionInterface::pressAction());
    EXPECT_EQ(view().chosen(), nth(*window_, 0));
    EXPECT_THAT(heard, ElementsAre("focus"));
    EXPECT_EQ(pages()->focusChild(), figure);
}

} // namespace
} // namespace writing
