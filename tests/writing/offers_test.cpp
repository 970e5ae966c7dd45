// The menus keep their word: each command of writing that is offered does something where the caret
// is, and each other one says why it is not offered.
#include "media/live_subdocument.h"
#include "writing/writing_testing.h"

#include <QMimeData>
#include <QStatusBar>
#include <QToolButton>

namespace writing {
namespace {

class OffersTest : public WritingTest {
protected:
    // Each kind of place, by the words that it stands before; figures are chosen.
    struct Place {
        const char* name;
        std::string before{};
        std::optional<std::size_t> figure{};
        std::size_t length = 0; // of what is selected
    };
    static std::vector<Place> places() {
        const std::string formula = "<FORMULA>{x}</FORMULA>";
        return {{"text", "One two"},
                {"end of the text", "}</TEXT><FOOTNOTE>"},
                {"words", "One two", {}, 3},
                {"heading", "Title}"},
                {"cell", "cell}"},
                {"cells", "cell}</CELL><CELL>{other", {}, 21},
                {"caption of a table", "Masses}"},
                {"caption of a figure", "Words}"},
                {"formula in a line", formula, {}, formula.size()},
                {"formula that is a block", "<FORMULA KIND=\"display\">{y}</FORMULA>", {}, 37},
                {"item", "item}"},
                {"footnote", "note}"},
                {"preformatted text", "code}"},
                {"between two figures", "<FIGURE ID=\"second\">"},
                {"figure", {}, 0},
                {"second of two figures", {}, 1},
                {"figure in a paragraph", {}, 2}};
    }

    static QByteArray inFigure(const QByteArray& caption, const QByteArray& attributes = {}) {
        return "<FIGURE" + attributes + ">" +
               scripted("duration 4\ncolour 20A040")
                   .replace("<PARAGRAPH>", "")
                   .replace("</PARAGRAPH>\n", "") +
               caption + "</FIGURE>\n";
    }
    void writeAll() {
        write("<PARAGRAPH><TEXT>{One two}</TEXT><FOOTNOTE>{note}</FOOTNOTE><TEXT>{ end "
              "}</TEXT><FORMULA>{x}</FORMULA></PARAGRAPH>\n"
              "<FORMULA KIND=\"display\">{y}</FORMULA>\n"
              "<TABLE><ROW><CELL>{cell}</CELL><CELL>{other}</CELL></ROW>"
              "<ROW><CELL>{c}</CELL><CELL>{d}</CELL></ROW><CAPTION>{Masses}</CAPTION></TABLE>\n"
              "<LIST><ITEM>{first}</ITEM><ITEM>{item}</ITEM></LIST>\n"
              "<VERBATIM>{code}</VERBATIM>\n" +
              inFigure("<CAPTION>{Words}</CAPTION>") + inFigure({}, " ID=\"second\"") +
              scripted("colour A02040") + "<SECTION><HEADING>{Title}</HEADING>\n" +
              paragraph("Last") + "</SECTION>\n");
        window_->resize(1000, 1600);
        ASSERT_TRUE(waitFor([&] {
            return hasPicture(*window_, 0) && hasPicture(*window_, 1) && hasPicture(*window_, 2) &&
                   live(*window_, 0).time() && live(*window_, 1).time();
        }));
        before_ = document().bytes();
    }
    void stand(const Place& place) const {
        while (document().bytes() != before_ && document().canUndo())
            document().undo();
        ASSERT_EQ(document().bytes(), before_);
        ASSERT_TRUE(waitFor([&] { return view().isLaidOut(); }));
        const std::size_t at = place.figure ? before_.find("Last") : before_.find(place.before);
        ASSERT_NE(at, std::string::npos) << place.name;
        view().text().cursor().set({at, at + place.length});
        view().choose(place.figure ? nth(*window_, *place.figure) : document::noSubdocument);
        window_->activateWindow(); // a dialog may have been
        view().setFocus();
        ASSERT_TRUE(waitFor([&] { return view().hasFocus(); }));
    }

    struct Entry {
        QAction* action;
        std::vector<QMenu*> way; // to open it
    };
    // Of all languages one stands for the others.
    static bool isCommand(const QString& name) {
        const bool isLanguage = name.contains("anguage-");
        return name != "figureHint" && name != "beginWriting" &&
               (!isLanguage || name.endsWith('-') || name.endsWith("-de"));
    }
    static void collect(QMenu* menu, std::vector<QMenu*> way, std::vector<Entry>& all) {
        way.push_back(menu);
        for (QAction* action : menu->actions()) {
            if (action->menu())
                collect(action->menu(), way, all);
            else if (!action->isSeparator() && isCommand(action->objectName()))
                all.push_back({action, way});
        }
    }
    [[nodiscard]] std::vector<Entry> entries() const {
        std::vector<Entry> all;
        for (const char* name : {"insert", "format", "figure", "table"})
            collect(window_->findChild<QMenu*>(name), {}, all);
        return all;
    }
    static void show(const Entry& entry, bool isOpen) {
        for (QMenu* menu : entry.way)
            isOpen ? Q_EMIT menu->aboutToShow() : Q_EMIT menu->aboutToHide();
    }

    // Whether doing it changes the document, opens a dialog or an editor, or moves something.
    [[nodiscard]] bool hasEffect(const std::function<void()>& act) const {
        const auto state = [&] {
            return std::tuple(document().bytes(), view().writing().selection(), view().chosen(),
                              view().writing().isMarked(schemas::ContainerRole::emphasis),
                              view().writing().isMarked(schemas::ContainerRole::strong),
                              view().writing().isMarked(schemas::ContainerRole::code));
        };
        const auto before = state();
        const auto asked = [&] { return answers([](QDialog& dialog) { dialog.reject(); }, act); };
        return asked() || state() != before;
    }

    std::string before_;
};

TEST_F(OffersTest, WhatIsOfferedDoesSomethingAndWhatIsNotSaysWhy) {
    writeAll();
    std::vector<std::string> broken;
    std::size_t offered = 0, refused = 0;
    for (const Place& place : places())
        for (const Entry& entry : entries()) {
            stand(place);
            show(entry, true);
            const std::string what = place.name + (": " + entry.action->objectName()).toStdString();
            const bool isOffered = entry.action->isEnabled(), isSo = entry.action->isChecked();
            const QAction plain(entry.action->text()); // the tip that it has without a reason
            const bool hasReason = entry.action->toolTip() != plain.toolTip();
            show(entry, false);
            ++(isOffered ? offered : refused);
            if (!isOffered && !hasReason)
                broken.push_back(what + " is grey and says nothing");
            const auto isEditing = [&] {
                return entry.action->objectName() == "figureEdit" && waitFor([&] {
                           return live(*window_, place.figure.value_or(0)).windows().open == 1;
                       });
            };
            if (isOffered && !isSo && !hasEffect([&] { entry.action->trigger(); }) && !isEditing())
                broken.push_back(what + " does nothing: " +
                                 window_->statusBar()->currentMessage().toStdString());
        }
    EXPECT_THAT(broken, ::testing::IsEmpty());
    EXPECT_GT(offered, 500U);
    EXPECT_GT(refused, 500U);
}

TEST_F(OffersTest, TheKeysOfTheMenusWorkWhileAFigureHasTheKeyboard) {
    writeAll();
    std::vector<std::string> broken;
    std::size_t pressed = 0;
    for (const Place& place : places())
        for (const Entry& entry : entries()) {
            if (!place.figure || entry.action->shortcut().isEmpty())
                continue;
            stand(place);
            ASSERT_EQ(view().chosen(), nth(*window_, *place.figure));
            window_->statusBar()->clearMessage();
            const QKeyCombination keys = entry.action->shortcut()[0];
            const std::size_t steps = document().steps();
            const bool isDone = hasEffect([&] {
                QTest::keyClick(&view(), keys.key(), keys.keyboardModifiers());
                // Those without Ctrl are the medium's first, which sends them back.
                if (!(keys.keyboardModifiers() & Qt::ControlModifier))
                    (void)waitFor([&] {
                        return document().steps() != steps ||
                               !window_->statusBar()->currentMessage().isEmpty();
                    });
            });
            ++pressed;
            if (!isDone && window_->statusBar()->currentMessage().isEmpty())
                broken.push_back(place.name + (": " + entry.action->objectName()).toStdString());
        }
    EXPECT_THAT(broken, ::testing::IsEmpty());
    EXPECT_GT(pressed, 60U);
}

TEST_F(OffersTest, InAViewForReadingTheMenusSayHowToWrite) {
    writeAll();
    const auto* button = qobject_cast<QToolButton*>(
        window_->findChild<QToolBar*>("tools")->widgetForAction(action("write")));
    ASSERT_TRUE(button);
    EXPECT_EQ(button->toolButtonStyle(), Qt::ToolButtonTextBesideIcon);
    EXPECT_EQ(button->text(), "Write");
    action("write")->trigger();
    ASSERT_FALSE(view().isWriting());
    for (const Entry& entry : entries()) {
        if (entry.way.front()->objectName() == "figure" ||
            entry.action->objectName() == "beginWriting")
            continue;
        EXPECT_TRUE(entry.way.front()->menuAction()->isVisible());
        show(entry, true);
        EXPECT_FALSE(entry.action->isEnabled()) << entry.action->text().toStdString();
        EXPECT_THAT(entry.action->toolTip().toStdString(), ::testing::HasSubstr("for reading"));
        show(entry, false);
    }
    // A key says so, too, and the bar below offers it.
    const auto* bar = window_->findChild<QWidget*>("readingBar");
    EXPECT_FALSE(bar->isVisible());
    press(Qt::Key_B, Qt::ControlModifier);
    EXPECT_TRUE(window_->statusBar()->currentMessage().contains("for reading"));
    EXPECT_TRUE(bar->isVisible());
    EXPECT_EQ(document().bytes(), before_);
    auto* begin = window_->findChild<QMenu*>("insert")->findChild<QAction*>("beginWriting");
    EXPECT_TRUE(begin->isVisible());
    begin->trigger();
    EXPECT_TRUE(view().isWriting());
    EXPECT_FALSE(begin->isVisible());
}

TEST_F(OffersTest, ATableIsInsertedFromTheMenuInsertToo) {
    write(paragraph("One"));
    auto* insert = window_->findChild<QMenu*>("insert");
    QAction* table = action("insertTable");
    ASSERT_TRUE(insert->actions().contains(table));
    goTo("Test}"); // the subject holds none
    Q_EMIT insert->aboutToShow();
    EXPECT_FALSE(table->isEnabled());
    Q_EMIT insert->aboutToHide();
    goTo("One");
    Q_EMIT insert->aboutToShow();
    EXPECT_TRUE(table->isEnabled());
    Q_EMIT insert->aboutToHide();
    answering("insertTable", [](QDialog& dialog) { dialog.accept(); });
    EXPECT_THAT(body(), ::testing::HasSubstr("<TABLE"));
}

TEST_F(OffersTest, AFigureThatIsDroppedOnOrPastedOverIsChosenNoMore) {
    writeAll();
    stand({"figure", {}, 0});
    const std::size_t at = before_.find("two");
    view().text().cursor().set({at, at});
    const QPointF place = view().text().caretRect()->center();
    QMimeData data;
    data.setText("new ");
    view().writing().drop(data, place, {});
    EXPECT_THAT(body(), ::testing::HasSubstr("One new two"));
    EXPECT_EQ(view().chosen(), document::noSubdocument);
}

} // namespace
} // namespace writing
