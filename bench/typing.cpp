// The time from a key to the painted letter: in a memo, in a memo while the ten figures that are
// seen play, on page 500 of 1,000, and there again after 10,000 further keys. Drives a real
// document window without a display. The time is that of the edit, the model, the layout and the
// painting of what has changed, by the clock on the wall, since one thread does all of it; beside
// each key runs a loop of arithmetic, so that a busy machine shows, and the time of this thread
// alone is told. The goal is 5 ms at the 99th percentile, and a memory that stays as it is.
//
//     bench_typing [--smoke]
#include "paints.h"

#include "document/document.h"
#include "view/text_hand.h"
#include "window/application.h"
#include "window/document_window.h"

#include <QApplication>
#include <QFile>
#include <QKeyEvent>
#include <QTemporaryDir>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <memory>

#include <malloc.h>

namespace {

using Clock = std::chrono::steady_clock;

// Of this thread.
double processorTime() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) * 1e3 + static_cast<double>(time.tv_nsec) / 1e6;
}

double since(Clock::time_point begin) {
    return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
}

[[noreturn]] void stop(const char* why) {
    std::fprintf(stderr, "bench_typing: %s\n", why);
    std::exit(1);
}

QByteArray words(int seed) {
    QByteArray text;
    for (int word = 0; word < 120; ++word)
        text += " word" + QByteArray::number((seed * 31 + word * 17) % 997);
    return text;
}

// Ten sections to three pages, as long as asked for.
QByteArray report(int sections) {
    QByteArray bytes = "DOCUMENT REPORT\n<REPORT>\n<TITLE>{A long report}</TITLE>\n";
    for (int i = 0; i < sections; ++i) {
        const QByteArray number = QByteArray::number(i);
        bytes += "<SECTION><HEADING>{Section number " + number +
                 "}</HEADING>\n<PARAGRAPH><TEXT>{Here " + number + words(i) +
                 "}</TEXT></PARAGRAPH>\n</SECTION>\n";
    }
    return bytes + "</REPORT>\n";
}

// One paragraph, and figures that play for a long time, so small that all of them are seen.
QByteArray memo(int figures) {
    QByteArray bytes = "DOCUMENT CMEMO\n<CMEMO>\n<SUBJECT>{A memo}</SUBJECT>\n<BODY>\n"
                       "<PARAGRAPH><TEXT>{Here 0" +
                       words(0) + "}</TEXT></PARAGRAPH>\n<PARAGRAPH>";
    for (int i = 0; i < figures; ++i)
        bytes += "<DOCUMENT>\nDOCUMENT ANIMATION\n<ANIMATION WIDTH=\"80\" HEIGHT=\"40\">"
                 "<ASGARD>{simulator -finish 1000\n"
                 "shape_set s -desc \\{-sub \\{-sphere 0.5\\}\\}\n"
                 "body b s -init_pos \\{1 0 0\\}\n"
                 "force -body b -x \\{-4*b.x\\}\n}</ASGARD></ANIMATION>\n</DOCUMENT>";
    return bytes + "</PARAGRAPH>\n</BODY>\n</CMEMO>\n";
}

// The memory that the program holds, in MiB.
double memory() {
    QFile file(QStringLiteral("/proc/self/statm"));
    if (!file.open(QIODevice::ReadOnly))
        stop("the memory is not told");
    return file.readAll().split(' ').at(1).toDouble() * 4096 / (1 << 20);
}

// Of it the part that objects have, in MiB: the heap keeps what was given back to it.
double memoryInUse() { return static_cast<double>(mallinfo2().uordblks) / (1 << 20); }

double loop() {
    const auto begin = Clock::now();
    volatile double x = 0;
    for (int i = 0; i < 1'000'000; ++i)
        x = x + i * 1e-9;
    return since(begin);
}

void print(const char* what, std::vector<double> times) {
    std::ranges::sort(times);
    const auto at = [&](double part) {
        return times[static_cast<std::size_t>(part * static_cast<double>(times.size() - 1))];
    };
    std::printf("%-34s median %6.2f ms   99 %% %6.2f ms   most %6.2f ms   of %zu\n", what, at(0.5),
                at(0.99), at(1), times.size());
}

// A window with a document in which one writes.
class Desk {
public:
    Desk(const QByteArray& bytes, const std::string& where)
        : application_({}, folder_.filePath(QStringLiteral("journal")).toStdString()) {
        const QString name = folder_.filePath(QStringLiteral("document.ens"));
        QFile file(name);
        if (!file.open(QIODevice::WriteOnly) || file.write(bytes) < 0)
            stop("no file could be written");
        file.close();
        window_ = application_.open(name);
        if (window_ == nullptr)
            stop("the document could not be opened");
        window_->resize(900, 1100);
        waitFor("the pages", [&] { return view().isLaidOut(); });
        const std::size_t at = document().bytes().find("Here " + where) + 4;
        view().setFocus();
        view().setWriting(true);
        view().text().cursor().set({at, at});
        view().text().showCaret();
        QCoreApplication::processEvents();
        paints_ = std::make_unique<bench::Paints>(*view().viewport());
    }

    std::size_t countPlaying() {
        const auto plays = [&](document::SubdocumentId id) {
            return live(id) && live(id)->time() && live(id)->time()->playing;
        };
        return static_cast<std::size_t>(std::ranges::count_if(document().subdocuments(), plays));
    }

    // All of them at once: a reader sees them all.
    void playAll() {
        const auto all = document().subdocuments();
        waitFor("all figures to be seen",
                [&] { return view().visibleSubdocuments().size() == all.size(); });
        for (const document::SubdocumentId id : all)
            waitFor("a figure to live", [&] { return live(id) && live(id)->time(); });
        for (const document::SubdocumentId id : all)
            live(id)->play();
        for (const document::SubdocumentId id : all)
            waitFor("a figure to play", [&] { return live(id)->time()->playing; });
        std::printf("%zu figures play\n", countPlaying());
    }

    void measure(int keys) {
        std::vector<double> times, handled, worked, loops, loopsWorked;
        const int painted = paints_->count;
        for (int i = 0; i < keys; ++i) {
            const double worked0 = processorTime();
            const auto begin = Clock::now();
            paints_->within = view().text().caretRect().value_or(QRectF()).toAlignedRect();
            paints_->await();
            type(i);
            handled.push_back(since(begin));
            waitFor("a painted letter", [&] { return paints_->came(); });
            times.push_back(since(begin));
            worked.push_back(processorTime() - worked0);
            QCoreApplication::processEvents();
            const double loop0 = processorTime();
            loops.push_back(loop());
            loopsWorked.push_back(processorTime() - loop0);
        }
        std::printf(
            "%zu pages, %zu bytes, typing on page %zu; %d pictures painted; %.1f MiB\n",
            view().pages().pages.size(), document().bytes().size(),
            view().pagePointAt(view().text().caretRect().value_or(QRectF()).center()).first + 1,
            paints_->count - painted, memory());
        print("key to painted letter", times);
        print("  of it until the event returns", handled);
        print("  of it at work", worked);
        print("loop of arithmetic beside it", loops);
        print("  of it at work", loopsWorked);
    }

    // As a writer does: a new paragraph now and then.
    void typeOn(int keys) {
        constexpr int toAParagraph = 400;
        const double before = memory(), usedBefore = memoryInUse();
        for (int i = 0; i < keys; ++i) {
            if (i % toAParagraph == toAParagraph - 1)
                press(Qt::Key_Return, {});
            else
                type(i);
            QCoreApplication::processEvents();
        }
        std::printf("%d further keys: from %.1f to %.1f MiB resident, from %.1f to %.1f in use\n",
                    keys, before, memory(), usedBefore, memoryInUse());
    }

    ~Desk() {
        while (document().canUndo())
            document().undo();
    }
    Desk(const Desk&) = delete;
    Desk& operator=(const Desk&) = delete;

private:
    template <typename Done> static void waitFor(const char* what, Done done) {
        const auto begin = Clock::now();
        while (!done()) {
            if (since(begin) > 60'000) {
                std::fprintf(stderr, "bench_typing: waited for a minute for %s\n", what);
                std::exit(1);
            }
            QCoreApplication::processEvents();
        }
    }

    void type(int i) { press(Qt::Key_A, QChar(i % 6 == 5 ? ' ' : 'a' + i % 26)); }
    void press(Qt::Key which, const QString& letter) {
        QKeyEvent key(QEvent::KeyPress, which, Qt::NoModifier, letter);
        QApplication::sendEvent(&view(), &key);
    }

    view::DocumentView& view() { return window_->view(); }
    document::Document& document() { return window_->document().document(); }
    media::LiveSubdocument* live(document::SubdocumentId id) {
        return window_->document().live(id);
    }

    QTemporaryDir folder_;
    window::Application application_;
    window::DocumentWindow* window_ = nullptr;
    std::unique_ptr<bench::Paints> paints_;
};

} // namespace

int main(int argc, char** argv) {
    qputenv("QT_QPA_PLATFORM", "offscreen");
    const QApplication app(argc, argv);
    const bool smoke = argc > 1 && QByteArray(argv[1]) == "--smoke";
    const int keys = smoke ? 5 : 500;
    Desk(memo(0), "0").measure(keys);
    {
        Desk desk(memo(smoke ? 1 : 10), "0");
        desk.playAll();
        desk.measure(keys);
        std::printf("%zu figures play still\n", desk.countPlaying());
    }
    if (!smoke) {
        Desk desk(report(3330), "1663");
        desk.measure(keys);
        desk.typeOn(10'000);
        desk.measure(keys);
    }
    std::fflush(stdout);
    std::_Exit(0);
}
