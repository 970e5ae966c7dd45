// The time from a key to the painted letter, in a paragraph in the middle of a long report. Drives
// a real document window without a display. The time is that of the edit, the model, the layout and
// the painting of what has changed, by the clock on the wall, since one thread does all of it;
// beside each key runs a loop of arithmetic, so that a busy machine shows, and the time of this
// thread alone is told. The goal is 5 ms at the 99th percentile.
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

// Some four sections to a page, as long as asked for.
QByteArray report(int sections) {
    QByteArray bytes = "DOCUMENT REPORT\n<REPORT>\n<TITLE>{A long report}</TITLE>\n";
    for (int i = 0; i < sections; ++i) {
        const QByteArray number = QByteArray::number(i);
        bytes += "<SECTION><HEADING>{Section number " + number +
                 "}</HEADING>\n<PARAGRAPH><TEXT>{Here " + number;
        for (int word = 0; word < 120; ++word)
            bytes += " word" + QByteArray::number((i * 31 + word * 17) % 997);
        bytes += "}</TEXT></PARAGRAPH>\n</SECTION>\n";
    }
    return bytes + "</REPORT>\n";
}

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

void measure(int sections, int keys) {
    QTemporaryDir folder;
    const QString name = folder.filePath("report.ens");
    QFile file(name);
    if (!file.open(QIODevice::WriteOnly) || file.write(report(sections)) < 0)
        stop("no file could be written");
    file.close();
    window::Application application({}, folder.filePath("journal").toStdString());
    window::DocumentWindow* window = application.open(name);
    if (window == nullptr)
        stop("the report could not be opened");
    view::DocumentView& view = window->view();
    while (!view.isLaidOut())
        QCoreApplication::processEvents();
    document::Document& document = window->document().document();
    const std::size_t at = document.bytes().find("Here " + std::to_string(sections / 2)) + 4;
    view.setFocus();
    view.setWriting(true);
    view.text().cursor().set({at, at});
    view.text().showCaret();
    QCoreApplication::processEvents();
    bench::Paints paints(*view.viewport());
    std::vector<double> times, handled, worked, loops;
    for (int i = 0; i < keys; ++i) {
        const QString letter(QChar(i % 6 == 5 ? ' ' : 'a' + i % 26));
        QKeyEvent key(QEvent::KeyPress, 'A', Qt::NoModifier, letter);
        const int before = paints.count;
        const auto begin = Clock::now();
        const double worked0 = processorTime();
        QApplication::sendEvent(&view, &key);
        handled.push_back(since(begin));
        while (paints.count == before) {
            if (since(begin) > 10'000)
                stop("waited for 10 s for a painted letter");
            QCoreApplication::processEvents();
        }
        times.push_back(since(begin));
        worked.push_back(processorTime() - worked0);
        QCoreApplication::processEvents();
        loops.push_back(loop());
    }
    std::printf("%zu pages, %zu bytes, typing on page %zu\n", view.pages().pages.size(),
                document.bytes().size(),
                view.pagePointAt(view.text().caretRect().value_or(QRectF()).center()).first + 1);
    print("key to painted letter", times);
    print("  of it until the event returns", handled);
    print("  of it at work", worked);
    print("loop of arithmetic beside it", loops);
    for (int i = 0; document.canUndo() && i < keys; ++i)
        document.undo();
}

} // namespace

int main(int argc, char** argv) {
    qputenv("QT_QPA_PLATFORM", "offscreen");
    const QApplication app(argc, argv);
    const bool smoke = argc > 1 && QByteArray(argv[1]) == "--smoke";
    measure(4, smoke ? 5 : 500);
    if (!smoke)
        measure(2700, 500);
    std::fflush(stdout);
    std::_Exit(0);
}
