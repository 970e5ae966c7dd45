// Random keys, pointer and window moves in all windows of a scene.
//
// Windows lie partly off the screen and are as small or large as they like; texts are short, long,
// faulty or none. Once in a while the hand rests: then all windows agree with the text
// (test_agreement.h), undo leads to the first bytes, redo to the last. ctest runs it at the device
// scales 1, 2 and 3 (QT_SCALE_FACTOR).
//
// ASGARD_WINDOW_ACTIONS sets how many (tests/desktop/windows_at_length.sh asks for a million),
// ASGARD_SEED where they begin, ASGARD_REST_AFTER how many lie between two rests. What ends the
// program, waits without end, or disagrees, prints the seed and the last actions. Waiting is
// counted in turns and in the processor's time, so that a busy machine is no fault.
#include "language/scene_editor.h"
#include "shapes/shape_editor.h"
#include "start/first_page.h"
#include "trajectories/trajectory_editor.h"
#include "viewers/scene_files.h"
#include "views/test_agreement.h"

#include <gtest/gtest.h>

#include <QContextMenuEvent>
#include <QDialog>
#include <QFileDialog>
#include <QMouseEvent>
#include <QPointer>
#include <QScreen>
#include <QTemporaryDir>
#include <QThread>
#include <QTimer>
#include <QWheelEvent>

#include <array>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <random>

#include <execinfo.h>
#include <sys/time.h>
#include <unistd.h>

namespace views {
namespace {

long setting(const char* name, long otherwise) {
    const char* text = std::getenv(name);
    return text ? std::atol(text) : otherwise;
}

// --- the last actions, for the one who looks for what ended the program ------------------------

std::array<std::array<char, 160>, 32> actions;
std::size_t actionCount = 0;

template <class... Words> void note(const char* format, Words... words) {
    auto& line = actions[actionCount++ % actions.size()];
    std::snprintf(line.data(), line.size(), format, words...);
}

void printActions() {
    const std::size_t first = actionCount > actions.size() ? actionCount - actions.size() : 0;
    for (std::size_t i = first; i < actionCount; ++i) {
        const auto& line = actions[i % actions.size()];
        for (const std::string_view part : {std::string_view(line.data()), std::string_view("\n")})
            if (write(STDERR_FILENO, part.data(), part.size()) < 0)
                return;
    }
}

void printCalls() {
    std::array<void*, 120> calls{}; // for addr2line
    backtrace_symbols_fd(calls.data(), backtrace(calls.data(), static_cast<int>(calls.size())),
                         STDERR_FILENO);
}

// The scene's text, which says what is computed: of a document that lives as long as the test.
const SceneDocument* documentOfTest = nullptr;

void ended(int signal) {
    std::signal(signal, SIG_DFL);
    printActions();
    printCalls();
    if (documentOfTest) {
        const std::string& text = documentOfTest->text();
        if (write(STDERR_FILENO, text.data(), text.size()) < 0)
            std::raise(SIGKILL);
    }
    std::raise(signal);
}

// An action that takes that much of the processor's time does not end: SIGPROF does.
void watchNext() {
    constexpr itimerval most{{}, {100, 0}}; // s
    setitimer(ITIMER_PROF, &most, nullptr);
}

constexpr std::array ends{SIGSEGV, SIGABRT, SIGFPE, SIGBUS, SIGILL, SIGPROF};

// A platform without windows says at each step that it has none; the last actions are lost in that.
QtMessageHandler usually = nullptr;

void tellAllElse(QtMsgType type, const QMessageLogContext& context, const QString& text) {
    if (!text.startsWith(QLatin1String("This plugin does not support")))
        usually(type, context, text);
}

// --- texts ---------------------------------------------------------------------------------------

std::string longText(int bodies) {
    std::string text = ballScene + "parameter g -value 2 -min 0 -max 9\n";
    for (int i = 0; i < bodies; ++i)
        text += "body n" + std::to_string(i) + " ball -init_pos {" + std::to_string(i) +
                " 0.25 -1e-3} ;# one of many\n";
    return text;
}

std::string wideText(int points) {
    std::string text = ballScene + "trajectory wide -points {";
    for (int i = 0; i < points; ++i)
        text += "{" + std::to_string(i) + " 1 2.5 -3} ";
    return text + "}\n# \xc3\xa4\xe2\x82\xac\xf0\x9f\x98\x80 " + std::string(3000, 'x') + "\n";
}

const std::string manyKinds =
    "simulator -finish 2\r\nshape_set s -desc {-sub {-sphere 1}}\r\n"
    "shape_set tip -desc {-sub {-points {{0 0 0} {2 0 0} {0 2 0} {0 0 2}}}}\r\n"
    "parameter g -value 2 -min 0 -max 9 ;# pull\r\nbody b1 s -init_pos {-5 0 0} -mass 2\r\n"
    "body b2 tip -init_pos {1.5 2 3}\r\nforce -body b1 -gravitational {0 -9.81 0}\r\n"
    "link -body1 b1 -offset1 {1 0 0} -x 0 -y 0 -z 0 -tightness 50\r\n"
    "trajectory T -points {{0 1 2 3} {1 4 5 6} {2 7 8 9}}\r\nview v -eye {0 0 9}\r\n"
    "lightsource sun -pos {0 5 0} -direction {0 -1 0}\r\nplot p -values {b1.x}\r\n";

std::vector<std::string> largeTexts() { return {longText(400), wideText(2000)}; }
std::vector<std::string> texts() {
    return {"",
            "x",
            ballScene,
            manyKinds,
            longText(30),
            wideText(100),
            "for {set i 0} {$i < 5} {incr i} {\n    body b$i ball -init_pos {$i 0 0}\n}\n" +
                ballScene,
            ballScene + "body b9 nothing\nforce {{{\n",
            std::string(500, '\n')};
}

// --- the hand ------------------------------------------------------------------------------------

class WindowFuzzTest : public testing::Test {
protected:
    static void SetUpTestSuite() {
        theApplication();
        usually = qInstallMessageHandler(tellAllElse);
        QApplication::setQuitOnLastWindowClosed(false);
        WindowPicture::setPatience(std::chrono::milliseconds(12)); // as in the program
    }

    static void TearDownTestSuite() { qInstallMessageHandler(usually); }

    void SetUp() override {
        ASSERT_TRUE(folder_.isValid());
        ASSERT_EQ(chdir(folder_.path().toUtf8().constData()), 0);
        open();
        begin();
        connect();
        documentOfTest = &editor_.document();
        for (const int signal : ends)
            std::signal(signal, ended);
    }
    void TearDown() override {
        constexpr itimerval never{};
        setitimer(ITIMER_PROF, &never, nullptr);
        documentOfTest = nullptr;
        for (const int signal : ends)
            std::signal(signal, SIG_DFL);
    }

    std::size_t below(std::size_t n) {
        return std::uniform_int_distribution<std::size_t>(0, n - 1)(random_);
    }
    bool rarely(std::size_t oneOf) { return below(oneOf) == 0; }
    int between(int low, int high) {
        return std::uniform_int_distribution<int>(low, high)(random_);
    }
    template <class One, std::size_t n> One any(const std::array<One, n>& all) {
        return all[below(n)];
    }

    // Dialogs and menus have event loops of their own: the next action is due before this one ends.
    void act() {
        if (left_ <= 0 || sinceRest_ >= restAfter_)
            return rest();
        --left_;
        ++sinceRest_;
        watchNext();
        QTimer::singleShot(0, &timer_, [this] { act(); });
        actOnce();
    }
    void actOnce() {
        closeDialogsOfFiles();
        if (QWidget* modal = QApplication::activeModalWidget(); modal && rarely(25)) {
            note("close the dialog %s", modal->metaObject()->className());
            modal->close();
            return;
        }
        const std::size_t what = below(100);
        if (what < 52)
            key();
        else if (what < 88)
            pointer();
        else if (what < 94)
            moveWindow();
        else
            changeAll();
    }
    // A dialog, a menu or a drag from one window to another has a loop of its own, whoever began
    // it: an action, or a timer that an action started.
    static bool isWithinAnother() { return QThread::currentThread()->loopLevel() > 1; }
    // Once the loops of all dialogs and menus have ended.
    void rest() {
        if (isWithinAnother()) {
            closeQuestions();
            endDrag();
        }
        if (isWithinAnother() || held_) {
            constexpr int pause = 5, most = 12'000; // ms, turns: two loops wait 20 s each
            if (++turns_ > most)
                return fail(whatWaits());
            QTimer::singleShot(pause, &timer_, [this] { rest(); });
            letGo(); // which may ask something
            return;
        }
        turns_ = 0;
        watchNext();
        if (const std::string found = disagreementNow(); !found.empty())
            return fail(found);
        sinceRest_ = 0;
        if (left_ <= 0)
            return loop_.quit();
        QTimer::singleShot(0, &timer_, [this] { act(); });
    }
    // No destructors: a loop that hangs would hang in them, too.
    void fail(const std::string& found) {
        std::fprintf(stderr, "Failure: %s\n%s\n", found.c_str(), editor_.document().text().c_str());
        printActions();
        printCalls();
        std::fflush(nullptr);
        std::_Exit(EXIT_FAILURE);
    }
    std::string whatWaits() const {
        const auto named = [](const QWidget* one) {
            return one ? one->metaObject()->className() : "none";
        };
        return "something waits: " + std::to_string(QThread::currentThread()->loopLevel()) +
               " loops of events, held: " + named(held_) +
               ", dialog: " + named(QApplication::activeModalWidget()) +
               ", menu: " + named(QApplication::activePopupWidget());
    }
    // Whose window has gone with the button down: it takes keys to anybody, and nobody else this
    // one.
    void endDrag() {
        QKeyEvent escape(QEvent::KeyPress, Qt::Key_Escape, Qt::NoModifier);
        QApplication::sendEvent(&timer_, &escape);
    }
    static void closeQuestions() {
        for (QWidget* window : QApplication::topLevelWidgets())
            if (window->isVisible() && (window->isModal() || window->inherits("QMenu") ||
                                        window == QApplication::activePopupWidget()))
                window->close();
    }
    std::string disagreementNow() {
        ++rests_;
        QTimer questions; // of what an action has still to come
        QObject::connect(&questions, &QTimer::timeout, &timer_, [] { closeQuestions(); });
        questions.start(20); // ms
        std::string found = disagreement(editor_);
        return found.empty() ? disagreementOfUndo(editor_, first_) : found;
    }
    void letGo() {
        QWidget* from = heldNow();
        held_ = nullptr;
        if (from)
            send(*from, QEvent::MouseButtonRelease, {0, 0}, button_, Qt::NoModifier);
    }

    // A random hand could take files away in them.
    static void closeDialogsOfFiles() {
        for (QWidget* window : QApplication::topLevelWidgets())
            if (auto* dialog = qobject_cast<QDialog*>(window);
                dialog && (dialog->inherits("QFileDialog") || dialog->inherits("QPrintDialog")))
                dialog->reject();
    }

    // --- where
    QWidget* anyWindow() {
        if (QWidget* modal = QApplication::activeModalWidget())
            return modal;
        QList<QWidget*> shown;
        for (QWidget* window : QApplication::topLevelWidgets())
            if (window->isVisible() && (window->windowFlags() & Qt::ToolTip) != Qt::ToolTip)
                shown.push_back(window);
        return shown.isEmpty()
                   ? nullptr
                   : shown[static_cast<qsizetype>(below(static_cast<std::size_t>(shown.size())))];
    }
    // An open menu takes the pointer, also from the button that opened it and is still held.
    QWidget* heldNow() const {
        QWidget* popup = held_ ? QApplication::activePopupWidget() : nullptr;
        return popup && held_->window() != popup ? popup : held_.data();
    }
    // A hand elsewhere closes them first. Otherwise a button could open the menu again that it has
    // open: Qt knows one loop of a menu alone, and the other one would never end.
    static void closeMenus() {
        for (QWidget* popup = nullptr;
             QApplication::activePopupWidget() && QApplication::activePopupWidget() != popup;) {
            popup = QApplication::activePopupWidget();
            popup->close();
        }
    }
    QWidget* anyWidget() {
        if (QWidget* popup = QApplication::activePopupWidget(); popup && !rarely(4))
            return popup;
        closeMenus();
        QWidget* window = anyWindow();
        if (!window)
            return nullptr;
        QList<QWidget*> shown;
        for (QWidget* one : window->findChildren<QWidget*>())
            if (one->isVisible() && !one->isWindow())
                shown.push_back(one);
        // What is edited in is met more often than buttons.
        QList<QWidget*> wanted;
        for (QWidget* one : shown)
            for (const char* kind :
                 {"views::SceneDisplay", "views::SceneEditor", "views::ShapeDisplay",
                  "views::TrajectoryGraph", "views::TimeStrip", "views::TimeBar"})
                if (one->inherits(kind) ||
                    (one->parentWidget() && one->parentWidget()->inherits(kind)))
                    wanted.push_back(one);
        const QList<QWidget*>& from = !wanted.isEmpty() && !rarely(3) ? wanted : shown;
        return from.isEmpty()
                   ? window
                   : from[static_cast<qsizetype>(below(static_cast<std::size_t>(from.size())))];
    }

    // --- keys
    void key() {
        QPointer<QWidget> to = QApplication::activePopupWidget();
        if (!to)
            to = QApplication::focusWidget();
        if (!to || rarely(20)) {
            to = anyWidget();
            if (!to)
                return;
            to->setFocus();
        }
        static constexpr std::array<int, 24> keys{
            Qt::Key_Return, Qt::Key_Backspace, Qt::Key_Backspace, Qt::Key_Delete, Qt::Key_Left,
            Qt::Key_Right,  Qt::Key_Up,        Qt::Key_Down,      Qt::Key_Home,   Qt::Key_End,
            Qt::Key_End,    Qt::Key_PageUp,    Qt::Key_PageDown,  Qt::Key_Tab,    Qt::Key_Backtab,
            Qt::Key_Escape, Qt::Key_Space,     Qt::Key_F1,        Qt::Key_F3,     Qt::Key_F7,
            Qt::Key_F8,     Qt::Key_Insert,    Qt::Key_Menu,      Qt::Key_F10};
        static constexpr std::array<Qt::KeyboardModifiers::enum_type, 5> modifiers{
            Qt::NoModifier, Qt::ShiftModifier, Qt::ControlModifier, Qt::AltModifier,
            Qt::NoModifier};
        const std::size_t what = below(10);
        Qt::KeyboardModifiers with = any(modifiers);
        if (rarely(8))
            with |= any(modifiers);
        const char* const in = to->metaObject()->className();
        if (what < 4) {
            const int one = any(keys);
            note("key %x with %x in %s", static_cast<unsigned>(one), with.toInt(), in);
            const bool held = rarely(6);
            if (held)
                QTest::keyPress(to, static_cast<Qt::Key>(one), with);
            else
                QTest::keyClick(to, static_cast<Qt::Key>(one), with);
        } else if (what < 5) {
            const char letter = static_cast<char>(between('A', 'Z'));
            note("Ctrl+%c with %x in %s", letter, with.toInt(), in);
            QTest::keyClick(to, letter, Qt::ControlModifier | with);
        } else if (what < 7) {
            static constexpr std::array<const char*, 18> pieces{
                "body ",
                "force -bo",
                "-init_pos {1 2 ",
                "}",
                "{",
                "\"",
                "trajectory t -points {{0 0 0 0} {",
                "[",
                "$g",
                "b1.",
                "-0.25",
                "# ",
                ";",
                "for",
                "link -",
                "view ",
                "shape_set q -desc {-sub {-box {1 1 1}}}",
                "1e"};
            const char* piece = any(pieces);
            note("type \"%s\" in %s", piece, in);
            for (const char* c = piece; *c != 0 && to; ++c)
                QTest::keyClick(to, *c);
        } else {
            const char c = static_cast<char>(between(32, 126));
            note("key '%c' in %s", c, in);
            QTest::keyClick(to, c);
        }
    }

    // --- pointer
    void send(QWidget& to, QEvent::Type type, const QPointF& at, Qt::MouseButton button,
              Qt::KeyboardModifiers with) {
        buttons_.setFlag(button, type != QEvent::MouseButtonRelease && button != Qt::NoButton);
        QMouseEvent event(type, at, to.mapToGlobal(at),
                          type == QEvent::MouseMove ? Qt::NoButton : button, buttons_, with);
        QApplication::sendEvent(&to, &event);
    }
    void pointer() {
        static constexpr std::array<Qt::MouseButton, 5> buttons{
            Qt::LeftButton, Qt::LeftButton, Qt::LeftButton, Qt::MiddleButton, Qt::RightButton};
        static constexpr std::array<Qt::KeyboardModifiers::enum_type, 4> modifiers{
            Qt::NoModifier, Qt::ShiftModifier, Qt::ShiftModifier, Qt::ControlModifier};
        const Qt::KeyboardModifiers with = any(modifiers);
        QPointer<QWidget> to = held_ ? heldNow() : anyWidget();
        if (!to)
            return;
        const int beyond = rarely(6) ? 3000 : 4;
        const QPointF at(between(-beyond, to->width() + beyond),
                         between(-beyond, to->height() + beyond));
        const char* const in = to->metaObject()->className();
        const std::size_t what = below(10);
        note("pointer %d at %.0f %.0f with %x in %s%s", static_cast<int>(what), at.x(), at.y(),
             with.toInt(), in, held_ ? ", held" : "");
        if (held_) {
            if (what < 6)
                return send(*to, QEvent::MouseMove, at, Qt::NoButton, with);
            held_ = nullptr;
            return send(*to, QEvent::MouseButtonRelease, at, button_, with);
        }
        if (what < 4) {
            held_ = to;
            button_ = any(buttons);
            send(*to, QEvent::MouseMove, at, Qt::NoButton, with);
            if (to)
                send(*to, QEvent::MouseButtonPress, at, button_, with);
        } else if (what < 6) {
            send(*to, QEvent::MouseMove, at, Qt::NoButton, with);
        } else if (what < 7) {
            send(*to, QEvent::MouseButtonDblClick, at, Qt::LeftButton, with);
            if (to)
                send(*to, QEvent::MouseButtonRelease, at, Qt::LeftButton, with);
        } else if (what < 8) {
            QContextMenuEvent event(QContextMenuEvent::Mouse, at.toPoint(),
                                    to->mapToGlobal(at.toPoint()), with);
            QApplication::sendEvent(to, &event);
        } else if (what < 9) {
            QWheelEvent event(at, to->mapToGlobal(at), {}, {0, 120 * between(-3, 3)}, Qt::NoButton,
                              with, Qt::NoScrollPhase, false);
            QApplication::sendEvent(to, &event);
        } else {
            QHelpEvent event(QEvent::ToolTip, at.toPoint(), to->mapToGlobal(at.toPoint()));
            QApplication::sendEvent(to, &event);
        }
    }

    // --- windows
    // It is told before the text comes.
    void begin() { first_ = editor_.document().savedText(); }
    void connect() {
        QObject::connect(&editor_.document(), &SceneDocument::opened, &timer_, [this] { begin(); });
    }
    void moveWindow() {
        QWidget* window = anyWindow();
        if (!window)
            return;
        const QRect screen = QGuiApplication::primaryScreen()->geometry();
        if (rarely(2)) {
            const QSize size = rarely(4)   ? QSize(1, 1)
                               : rarely(6) ? QSize(between(40, 1400), between(40, 1100))
                                           : QSize(between(40, 700), between(40, 500));
            note("resize %s to %d %d", window->metaObject()->className(), size.width(),
                 size.height());
            window->resize(size);
        } else {
            const int beyond = rarely(4) ? 3000 : 200;
            const QPoint to(between(screen.left() - beyond, screen.right() + beyond),
                            between(screen.top() - beyond, screen.bottom() + beyond));
            note("move %s to %d %d", window->metaObject()->className(), to.x(), to.y());
            window->move(to);
        }
    }
    void open() {
        if (editor_.graphicalViewers().isEmpty())
            editor_.openGraphicalViewer()->showUsualPanes();
        if (editor_.languageViewers().isEmpty())
            editor_.openLanguageViewer();
        if (editor_.languageViewers().size() > 2)
            editor_.languageViewers().front()->dropDraft(),
                editor_.languageViewers().front()->close();
        if (editor_.graphicalViewers().size() > 2) {
            GraphicalViewer* oldest = editor_.graphicalViewers().front();
            if (LanguageViewer* text = oldest->text())
                text->dropDraft();
            oldest->close();
        }
        editor_.openTrajectoryEditor();
        editor_.openShapeEditor();
        switch (below(6)) {
        case 0:
            return void(editor_.openPlots());
        case 1:
            return editor_.graphicalViewers().back()->showTour();
        case 2:
            return void(editor_.openMainWindow());
        case 3:
            return openFirstPage();
        default:
            return;
        }
    }
    void openFirstPage() {
        if (page_)
            return page_->raise();
        page_ = new FirstPage(samplesOf(manifestOfProgram()), {}, nullptr);
        QObject::connect(page_, &FirstPage::newWanted, &timer_, [this] { files_.newScene(); });
        QObject::connect(page_, &FirstPage::sampleWanted, &timer_, [this](const Sample& sample) {
            QFile file(sample.path);
            if (file.open(QIODevice::ReadOnly))
                files_.newScene(file.readAll().toStdString(), sample.title);
        });
        page_->show();
    }
    void changeAll() {
        const std::size_t what = below(8);
        note("change %d", static_cast<int>(what));
        SceneDocument& document = editor_.document();
        if (what < 2) {
            static const std::vector<std::string> usual = texts(), large = largeTexts();
            const auto& all = rarely(30) ? large : usual;
            document.setText(all[below(all.size())], "Edit");
        } else if (what < 3) {
            document.undo();
        } else if (what < 4) {
            document.redo();
        } else if (what < 5) {
            open();
        } else if (what < 6) {
            dark_ = !dark_;
            QPalette palette;
            palette.setColor(QPalette::Base, dark_ ? QColor(30, 30, 30) : Qt::white);
            palette.setColor(QPalette::Text, dark_ ? Qt::white : Qt::black);
            QApplication::setPalette(palette);
        } else { // the end of a text that is scrolled
            for (LanguageViewer* viewer : editor_.languageViewers())
                QTest::keyClick(&viewer->editor(), Qt::Key_End, Qt::ControlModifier);
        }
    }

    QTemporaryDir folder_;
    QObject timer_;
    QEventLoop loop_;
    TestWorkshop made_;
    Editor editor_{made_.workshop()};
    SceneFiles& files_ = editor_.beginSession();
    QPointer<FirstPage> page_;
    std::string first_; // the text that all undo leads to
    std::mt19937_64 random_{static_cast<std::uint64_t>(setting("ASGARD_SEED", 1))};
    QPointer<QWidget> held_; // the button is down in it
    Qt::MouseButton button_ = Qt::LeftButton;
    Qt::MouseButtons buttons_;
    bool dark_ = false;
    int turns_ = 0; // of a rest that has to wait for a dialog or a menu
    long left_ = setting("ASGARD_WINDOW_ACTIONS", 5'000);
    long restAfter_ = setting("ASGARD_REST_AFTER", 400), sinceRest_ = 0, rests_ = 0;
};

TEST_F(WindowFuzzTest, NothingThatAHandDoesEndsTheProgram) {
    const long wanted = left_;
    note("seed %ld, scale %s", setting("ASGARD_SEED", 1),
         qPrintable(qEnvironmentVariable("QT_SCALE_FACTOR", "1")));
    QTimer::singleShot(0, &timer_, [this] { act(); });
    loop_.exec();
    EXPECT_EQ(left_, 0);
    EXPECT_GE(rests_, wanted / restAfter_);
    EXPECT_GT(actionCount, static_cast<std::size_t>(wanted) / 2);
}

} // namespace
} // namespace views
