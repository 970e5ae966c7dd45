#include "filing/printing.h"
#include "onpage/shown.h"
#include "window/window_testing.h"

namespace window {
namespace {

using ::testing::HasSubstr;

TEST_F(WindowTest, TextIsThereAtOnceAndPicturesFollow) {
    DocumentWindow* window = open(memo(scripted("colour 20A040")));
    EXPECT_FALSE(window->view().pages().outline().empty() && window->view().pages().pages.empty());
    EXPECT_FALSE(hasPicture(*window, 0));
    ASSERT_TRUE(waitFor([&] { return hasPicture(*window, 0); }));
    EXPECT_EQ(colourShown(*window, 0), QColor(0x20, 0xA0, 0x40));
    const QSizeF place = window->view().placeOf(nth(*window, 0)).size();
    EXPECT_TRUE(waitFor([&] {
        return picture(*window, 0).size() == (place * window->devicePixelRatioF()).toSize();
    }));
}

TEST_F(WindowTest, ASizeThatNobodyGivesIsTheMediums) {
    DocumentWindow* window =
        open(memo("<PARAGRAPH><DOCUMENT>\nDOCUMENT SCRIPTED\n<SCRIPTED><SCRIPT>{size "
                  "200 90}</SCRIPT></SCRIPTED>\n</DOCUMENT></PARAGRAPH>\n"));
    EXPECT_TRUE(
        waitFor([&] { return window->view().placeOf(nth(*window, 0)).size() == QSizeF(200, 90); }));
}

TEST_F(WindowTest, WindowsOfOneDocumentShareItsProcesses) {
    DocumentWindow* one = open(memo(scripted("colour 802020")));
    DocumentWindow* two = application_.addWindow(one->shared());
    two->view().setZoom(2);
    ASSERT_TRUE(waitFor([&] { return hasPicture(*one, 0) && picture(*two, 0).width() == 600; }));
    EXPECT_EQ(picture(*one, 0).width(), 300);
    EXPECT_EQ(application_.pipes().alive(), 1);
    two->close();
    EXPECT_TRUE(waitFor([&] { return application_.windowsOf(one->document()).size() == 1; }));
    EXPECT_EQ(application_.pipes().alive(), 1);
}

TEST_F(WindowTest, PresentationsDifferFromWindowToWindow) {
    DocumentWindow* one = open(memo(scripted("colour 802020")));
    DocumentWindow* two = application_.addWindow(one->shared());
    const QSizeF before = two->view().pages().size;
    two->resize(700, 700);
    ASSERT_TRUE(waitFor([&] { return two->view().widthZoom() < 1; }));
    two->view().setPresentation("slides");
    EXPECT_NE(two->view().pages().size, before);
    EXPECT_EQ(two->view().zoom(), two->view().widthZoom()); // it is seen whole
    EXPECT_EQ(one->view().pages().size, before);
}

// --- choosing and commands ---------------------------------------------------------------------

TEST_F(WindowTest, AClickChoosesAndKeysMoveTheChoice) {
    DocumentWindow* window = open(memo(scripted("colour 111111") + scripted("colour 222222")));
    ASSERT_TRUE(waitFor([&] { return hasPicture(*window, 0) && hasPicture(*window, 1); }));
    click(*window, 1);
    EXPECT_EQ(window->view().chosen(), nth(*window, 1));
    QTest::keyClick(&window->view(), Qt::Key_Escape);
    EXPECT_EQ(window->view().chosen(), document::noSubdocument);
    window->view().setFocus();
    QTest::keyClick(&window->view(), Qt::Key_Tab);
    EXPECT_EQ(window->view().chosen(), nth(*window, 0));
    QTest::keyClick(&window->view(), Qt::Key_Tab);
    EXPECT_EQ(window->view().chosen(), nth(*window, 1));
    QTest::keyClick(&window->view(), Qt::Key_Backtab);
    EXPECT_EQ(window->view().chosen(), nth(*window, 0));
}

TEST_F(WindowTest, AMenuActsOnTheChosenRenditionElseOnAllVisible) {
    DocumentWindow* window = open(memo(scripted("duration 50") + scripted("duration 60")));
    ASSERT_TRUE(waitFor([&] {
        return !live(*window, 0).menus().empty() && !live(*window, 1).menus().empty() &&
               live(*window, 0).time() && live(*window, 1).time() && hasPicture(*window, 1);
    }));
    window->commands().refresh();
    QMenu* menu = window->commands().menuOf(nth(*window, 0));
    ASSERT_TRUE(menu);
    EXPECT_EQ(menu->title(), "&Scripted"); // Alt+S opens it
    QStringList labels;
    for (const QAction* action : menu->actions())
        labels << action->text();
    EXPECT_EQ(labels, QStringList({"Play", "Show Handles", "Crash", "Open Editor"}));

    click(*window, 1);
    menu->actions().first()->trigger();
    ASSERT_TRUE(waitFor([&] { return live(*window, 1).time()->playing; }));
    EXPECT_FALSE(live(*window, 0).time()->playing);
    window->view().choose(document::noSubdocument);
    menu->actions().first()->trigger();
    EXPECT_TRUE(waitFor([&] { return live(*window, 0).time()->playing; }));
}

TEST_F(WindowTest, TheToolAreaBelongsToTheMediumInUse) {
    DocumentWindow* window = open(memo(scripted("duration 50\nmenu Refresh")));
    EXPECT_TRUE(waitFor([&] { return window->commands().toolOwner() == "SCRIPTED"; }));
    ASSERT_TRUE(waitFor([&] { return live(*window, 0).time().has_value(); }));
    auto* bar = window->findChild<QToolBar*>("tools");
    const auto hasTool = [&] {
        return std::ranges::any_of(bar->actions(),
                                   [](const QAction* one) { return one->text() == "Refresh"; });
    };
    EXPECT_TRUE(waitFor(hasTool));
    // They go with the medium's last figure, and come back with it.
    document::Document& document = window->document().document();
    const std::size_t from = document.bytes().find("<PARAGRAPH>"),
                      to = document.bytes().find("</BODY>");
    ASSERT_EQ(document.edit({{{from, to}, ""}}, "Delete"), document::EditResult::applied);
    EXPECT_TRUE(waitFor([&] { return !hasTool(); }));
    EXPECT_EQ(window->commands().toolOwner(), "");
    document.undo();
    EXPECT_TRUE(waitFor(hasTool));
}

TEST_F(WindowTest, ThePlayBarIsOnlyUnderThePointer) {
    DocumentWindow* window = open(memo(scripted("duration 50") + scripted("colour 123456")));
    ASSERT_TRUE(waitFor([&] { return live(*window, 0).time() && hasPicture(*window, 1); }));
    auto* bar = window->view().viewport()->findChild<controls::PlayBar*>();
    EXPECT_FALSE(bar->isVisible());
    const auto over = [&](std::size_t n) {
        QTest::mouseMove(window->view().viewport(),
                         window->view().placeOf(nth(*window, n)).center().toPoint());
        QCoreApplication::processEvents();
    };
    over(0);
    EXPECT_TRUE(bar->isVisible());
    over(1); // a medium without time has none
    EXPECT_FALSE(bar->isVisible());
    over(0); // nor one that has ended: what happened is said there
    EXPECT_TRUE(bar->isVisible());
    live(*window, 0).invoke("crash", nullptr);
    ASSERT_TRUE(waitFor([&] { return live(*window, 0).condition() == media::Condition::failed; }));
    EXPECT_FALSE(bar->isVisible());
}

TEST_F(WindowTest, KeysThatAMediumDoesNotUseAreTheHosts) {
    QByteArray text;
    for (int i = 0; i < 100; ++i)
        text += "<PARAGRAPH><TEXT>{line}</TEXT></PARAGRAPH>\n";
    DocumentWindow* window = open(memo(scripted("colour 010101") + text), {900, 500});
    ASSERT_TRUE(waitFor([&] { return hasPicture(*window, 0); }));
    click(*window, 0);
    QTest::keyClick(&window->view(), Qt::Key_End);
    EXPECT_TRUE(waitFor([&] { return window->view().verticalScrollBar()->value() > 500; }));
}

// --- what is seen ------------------------------------------------------------------------------

TEST_F(WindowTest, ARenditionOutOfSightIsHidden) {
    QByteArray text;
    for (int i = 0; i < 200; ++i)
        text += "<PARAGRAPH><TEXT>{line}</TEXT></PARAGRAPH>\n";
    DocumentWindow* window = open(memo(scripted("duration 100") + text), {900, 500});
    ASSERT_TRUE(waitFor([&] { return hasPicture(*window, 0) && live(*window, 0).time(); }));
    live(*window, 0).play();
    const auto pictures = [&] { return picture(*window, 0).cacheKey(); };
    const auto first = pictures();
    ASSERT_TRUE(waitFor([&] { return pictures() != first; }));
    window->view().verticalScrollBar()->setValue(600);
    // The medium plays on from each of these times, and says so after what it has drawn before.
    const auto seek = [&](double time) {
        live(*window, 0).seek(time);
        EXPECT_TRUE(waitFor([&] { return live(*window, 0).time()->time >= time; }));
    };
    seek(10);
    const auto hidden = pictures(); // that which was on its way has come
    for (const double time : {20, 30, 40})
        seek(time);
    EXPECT_EQ(pictures(), hidden);
    window->view().verticalScrollBar()->setValue(0);
    EXPECT_TRUE(waitFor([&] { return pictures() != hidden; }));
}

TEST_F(WindowTest, AThousandSubdocumentsOpenAtOnceWithEightProcesses) {
    QByteArray many;
    for (int i = 0; i < 1000; ++i)
        many += scripted("colour " + QByteArray::number(0x100000 + i, 16));
    QElapsedTimer elapsed;
    elapsed.start();
    DocumentWindow* window = open(memo(many), {900, 3000});
    window->document().media().setMostLive(8);
    RecordProperty("open_ms", static_cast<int>(elapsed.elapsed()));
    // More are seen than may live: each has its turn, and keeps its picture.
    ASSERT_GT(window->view().visibleSubdocuments().size(), 8u);
    const auto allSeenHavePictures = [&] {
        for (const document::SubdocumentId id : window->view().visibleSubdocuments())
            if (window->view().rendition(id)->picture().isNull())
                return false;
        return true;
    };
    ASSERT_TRUE(waitFor(allSeenHavePictures));
    EXPECT_TRUE(waitFor([&] { return children().size() <= 8u; }));
    window->view().verticalScrollBar()->setValue(window->view().verticalScrollBar()->maximum());
    ASSERT_TRUE(waitFor([&] { return hasPicture(*window, 999) && allSeenHavePictures(); }));
    EXPECT_TRUE(waitFor([&] { return children().size() <= 8u; }));
}

TEST_F(WindowTest, WordsAreFoundWhereTheyStand) {
    QByteArray lines;
    for (int i = 0; i < 150; ++i)
        lines += "<PARAGRAPH><TEXT>{line " + QByteArray::number(i) + "}</TEXT></PARAGRAPH>\n";
    DocumentWindow* window = open(memo(lines + "<PARAGRAPH><TEXT>{the Needle}</TEXT></PARAGRAPH>\n"
                                               "<PARAGRAPH><TEXT>{a needle}</TEXT></PARAGRAPH>\n"),
                                  {900, 500});
    for (QAction* one : window->findChildren<QAction*>())
        if (one->shortcut() == QKeySequence(QKeySequence::Find))
            one->trigger();
    auto* bar = window->findChild<panes::FindBar*>();
    ASSERT_TRUE(bar && bar->isVisible());
    QTest::keyClicks(&bar->field(), "needle");
    EXPECT_EQ(bar->says(), "1 of 2");
    const QScrollBar* scroll = window->view().verticalScrollBar();
    EXPECT_GT(scroll->value(), 500); // it is seen
    QTest::keyClick(&bar->field(), Qt::Key_Return);
    EXPECT_EQ(bar->says(), "2 of 2");
    QTest::keyClick(&bar->field(), Qt::Key_Return, Qt::ShiftModifier);
    EXPECT_EQ(bar->says(), "1 of 2");
    const QImage marked = window->view().viewport()->grab().toImage();
    bar->field().setText("nothing like it");
    EXPECT_EQ(bar->says(), "Not found");
    EXPECT_NE(window->view().viewport()->grab().toImage(), marked);
    QTest::keyClick(&bar->field(), Qt::Key_Escape);
    EXPECT_FALSE(bar->isVisible());
    EXPECT_EQ(window->view().foundCount(), 0);
}

// --- what goes wrong ---------------------------------------------------------------------------

TEST_F(WindowTest, ACrashedMediumKeepsItsPictureAndStartsOnAClick) {
    DocumentWindow* window = open(memo(scripted("colour 3060A0") + scripted("colour A06030")));
    ASSERT_TRUE(waitFor([&] { return hasPicture(*window, 0) && hasPicture(*window, 1); }));
    const std::string before = window->document().document().bytes();
    live(*window, 0).invoke("crash", nullptr);
    ASSERT_TRUE(waitFor([&] { return live(*window, 0).condition() == media::Condition::failed; }));
    EXPECT_TRUE(hasPicture(*window, 0));
    view::Shown shown;
    shown.id = nth(*window, 0);
    EXPECT_THAT(view::noticeOf(window->document(), shown).title.toStdString(),
                HasSubstr("was ended by signal 11"));
    EXPECT_EQ(live(*window, 1).condition(), media::Condition::live);
    EXPECT_EQ(window->document().document().bytes(), before);
    auto* pane = window->findChild<panes::FaultsPane*>();
    EXPECT_TRUE(waitFor([&] { return pane->count() == 1; }));
    click(*window, 0);
    EXPECT_TRUE(waitFor([&] { return live(*window, 0).condition() == media::Condition::live; }));
    EXPECT_TRUE(waitFor([&] { return pane->count() == 0; }));
}

TEST_F(WindowTest, AFaultyTextSaysSoWithItsLineInTheFile) {
    DocumentWindow* window = open(memo(scripted("colour 0000FF\ncolur 1")));
    ASSERT_TRUE(waitFor([&] { return !live(*window, 0).diagnostics().items.empty(); }));
    const auto faults = window->document().faultsOf(nth(*window, 0));
    ASSERT_EQ(faults.size(), 1u);
    EXPECT_EQ(faults[0].position.line, 8);
    EXPECT_EQ(faults[0].position.column, 1);
    auto* pane = window->findChild<panes::FaultsPane*>();
    EXPECT_TRUE(waitFor([&] { return pane->count() == 1; }));
}

TEST_F(WindowTest, ABrokenFileIsShownWithItsFaults) {
    DocumentWindow* window = open("DOCUMENT CMEMO\n<CMEMO>\n<SUBJECT>{Half");
    auto* pane = window->findChild<panes::FaultsPane*>();
    EXPECT_TRUE(waitFor([&] { return pane->count() > 0 && pane->isVisible(); }));
    const auto says = [](DocumentWindow* of, const QString& words) {
        return std::ranges::any_of(of->findChildren<QLabel*>(), [&](const QLabel* label) {
            return label->isVisible() && label->text().contains(words);
        });
    };
    EXPECT_TRUE(says(window, QStringLiteral("This file is damaged.")));
    DocumentWindow* marked = open("\xEF\xBB\xBF<CMEMO>\n<SUBJECT>{Half");
    EXPECT_TRUE(waitFor([&] { return says(marked, QStringLiteral("This file is damaged.")); }));
    DocumentWindow* scene = open("simulator -finish 5\nbody b s\n");
    EXPECT_TRUE(waitFor([&] { return says(scene, QStringLiteral("no document")); }));
}

TEST_F(WindowTest, AnUnknownMediumIsABoxWithItsText) {
    DocumentWindow* window = open(
        memo("<PARAGRAPH><DOCUMENT>\nDOCUMENT FILM\n<FILM ALT=\"The sea\"><REEL>{x}</REEL></FILM>\n"
             "</DOCUMENT></PARAGRAPH>\n"));
    view::Shown shown;
    shown.id = nth(*window, 0);
    const view::Notice notice = view::noticeOf(window->document(), shown);
    EXPECT_EQ(notice.title, "No medium for FILM is installed.");
    EXPECT_EQ(notice.text, "The sea");
}

// The window answers while a medium starts, hangs and is ended.
TEST_F(WindowTest, NothingHoldsTheWindow) {
    DocumentWindow* window = open(memo(scripted("behave hang") + scripted("behave busy") +
                                       scripted("behave flood") + scripted("colour 00FF00")));
    const Heartbeat beat;
    ASSERT_TRUE(waitFor([&] {
        return live(*window, 0).condition() == media::Condition::failed &&
               live(*window, 1).condition() == media::Condition::failed &&
               live(*window, 2).condition() == media::Condition::failed;
    }));
    EXPECT_EQ(live(*window, 3).condition(), media::Condition::live);
    RecordProperty("longest_ms", static_cast<int>(beat.longest()));
    std::printf("longest wait for the event loop: %lld ms\n",
                static_cast<long long>(beat.longest()));
    // It was not waiting for any of them all the time.
    EXPECT_GT(beat.count(), 100);
}

TEST_F(WindowTest, ANameWithoutAnEndingGetsTheDocuments) {
    DocumentWindow* window = open("DOCUMENT CMEMO\n<CMEMO>\n</CMEMO>\n");
    const QString wanted = folder_.filePath("two");
    QTimer timer, refusing; // the one may wait for what the other ends
    QObject::connect(&refusing, &QTimer::timeout, [] {
        if (auto* question = qobject_cast<QMessageBox*>(QApplication::activeModalWidget()))
            question->reject(); // none is expected
    });
    QObject::connect(&timer, &QTimer::timeout, [&] {
        auto* dialog = window->findChild<QFileDialog*>();
        if (!dialog || !dialog->isVisible())
            return;
        dialog->findChild<QLineEdit*>()->setText(wanted);
        for (auto* view : dialog->findChildren<QAbstractItemView*>())
            view->clearSelection(); // as typing does, where the window has the focus
        if (dialog->selectedFiles().value(0) == wanted + ".ens")
            static_cast<QDialog*>(dialog)->accept();
    });
    refusing.start(20);
    timer.start(20);
    EXPECT_TRUE(window->saveAs());
    EXPECT_TRUE(QFile::exists(wanted + ".ens"));
    EXPECT_FALSE(QFile::exists(wanted));
}

TEST_F(WindowTest, APdfHasThePictures) {
    DocumentWindow* window = open(memo(scripted("colour 20A040")));
    const QString pdf = folder_.filePath("out.pdf");
    window->printing().exportTo(pdf, {});
    ASSERT_TRUE(waitFor([&] { return QFile::exists(pdf); }));
    QFile file(pdf);
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    EXPECT_THAT(file.readAll().toStdString(), HasSubstr("/Subtype /Image"));
}

// --- kills -------------------------------------------------------------------------------------

// Media are killed at random moments of a session that plays, scrolls, edits and undoes. KILLS sets
// how many; a thousand are run before a release.
TEST_F(WindowTest, SurvivesKillsAtRandomMoments) {
    const int kills =
        qEnvironmentVariableIsSet("KILLS") ? qEnvironmentVariableIntValue("KILLS") : 10;
    std::mt19937 random(20260);
    DocumentWindow* window =
        open(memo(scripted("duration 30\ncolour 203040") + scripted("duration 20\ncolour 405060") +
                  scripted("colour 607080")));
    document::Document& of = window->document().document();
    const std::string original = of.bytes();
    std::vector<double> restartMs;
    for (int done = 0; done < kills;) {
        const auto n = static_cast<std::size_t>(random() % 3);
        const document::SubdocumentId id = nth(*window, n);
        switch (random() % 6) {
        case 0:
            live(*window, n).play();
            break;
        case 1:
            live(*window, n).seek(random() % 20);
            break;
        case 2:
            of.editText(id, of.subdocument(id)->revision, {{{0, 0}, "\n"}}, "Line");
            break;
        case 3:
            of.undo();
            break;
        case 4:
            window->view().setZoom(0.5 + (random() % 20) / 10.0);
            break;
        case 5:
            click(*window, n);
            break;
        }
        QTest::qWait(static_cast<int>(random() % 40));
        const std::vector<pid_t> alive = children();
        if (alive.empty() || random() % 2)
            continue;
        kill(alive[random() % alive.size()], SIGKILL);
        ++done;
        QElapsedTimer restart;
        for (std::size_t i = 0; i < 3; ++i)
            if (live(*window, i).condition() == media::Condition::failed) {
                EXPECT_THAT(live(*window, i).reason().toStdString(), HasSubstr("signal 9"));
                restart.start();
                live(*window, i).start();
                ASSERT_TRUE(waitFor(
                    [&] { return live(*window, i).condition() == media::Condition::live; }));
                restartMs.push_back(static_cast<double>(restart.elapsed()));
            }
        for (std::size_t i = 0; i < 3; ++i)
            EXPECT_EQ(live(*window, i).text().toStdString(), of.text(nth(*window, i)));
    }
    while (of.canUndo())
        of.undo();
    EXPECT_EQ(of.bytes(), original);
    std::sort(restartMs.begin(), restartMs.end());
    if (!restartMs.empty())
        std::printf("%d kills, %zu restarts, median %.0f ms, 95 %% below %.0f ms\n", kills,
                    restartMs.size(), restartMs[restartMs.size() / 2],
                    restartMs[restartMs.size() * 95 / 100]);
}

TEST_F(WindowTest, TheTitleIsTheDocumentsAndElseItsFiles) {
    DocumentWindow* window = open(memo("").replace("{Test}", "{A [*] plan\n of\x1b ours}"));
    EXPECT_EQ(window->windowTitle(), "A [*][*] plan of ours (1.ens)[*] - Ensemble");
    document::Document& of = window->document().document();
    const std::size_t at = of.bytes().find("{A ");
    const std::size_t end = of.bytes().find('}', at);
    of.edit({{{at + 1, end}, "Another"}}, "Edit");
    EXPECT_TRUE(waitFor([&] { return window->windowTitle().startsWith("Another (1.ens)"); }));
    EXPECT_TRUE(window->isWindowModified());
    of.edit({{{at + 1, at + 8}, ""}}, "Edit");
    EXPECT_TRUE(waitFor([&] { return window->windowTitle() == "1.ens[*] - Ensemble"; }));
    EXPECT_EQ(application_.openNew()->windowTitle(), "Untitled[*] - Ensemble");
}

} // namespace
} // namespace window
