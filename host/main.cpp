// ensemble: reads, shows, plays, prints and saves compound documents. See docs/command-line.md.
#include "console/check.h"
#include "console/check_medium.h"
#include "console/convert.h"
#include "plain/qt_messages.h"
#include "screen/display.h"
#include "screen/numbers.h"
#include "terminal/terminal.h"
#include "window/application.h"

#include <QApplication>
#include <QCommandLineParser>
#include <QTimer>

namespace {

constexpr const char* usage =
    "usage: ensemble [--play] [DOCUMENT ...]           open documents\n"
    "       ensemble --convert-to pdf|png|text [--output FILE|DIR] [--presentation NAME]\n"
    "                DOCUMENT\n"
    "       ensemble --check DOCUMENT                  every fault of the document and its "
    "subdocuments\n"
    "       ensemble --check-medium COMMAND...         the conformance test of the medium "
    "protocol\n"
    "       ensemble --help | --version\n";

int wrong(const QString& sentence) {
    terminal::complain("ensemble: " + sentence.toStdString());
    terminal::complain(usage);
    return console::wrongUsage;
}

int convert(const QCommandLineParser& options) {
    const QString format = options.value("convert-to");
    if (format == "html" || format == "markdown") {
        terminal::complain("ensemble: " + format.toStdString() +
                           " is not written yet: pdf, png and text are");
        return console::wrongUsage;
    }
    if (format != "pdf" && format != "png" && format != "text")
        return wrong("--convert-to wants pdf, png or text");
    if (options.positionalArguments().size() != 1)
        return wrong("--convert-to wants one document");
    return console::convert({format, options.positionalArguments().first(), options.value("output"),
                             options.value("presentation")});
}

int openWindows(QApplication& application, const QCommandLineParser& options) {
    window::dress();
    window::Application windows;
    bool opened = false;
    for (const QString& file : options.positionalArguments())
        if (window::DocumentWindow* made = windows.open(file)) {
            opened = true;
            if (options.isSet("play"))
                windows.playWhenLoaded(made->document());
        }
    if (options.positionalArguments().isEmpty())
        opened = windows.openNew() != nullptr;
    QTimer::singleShot(0, &windows, [&windows] { windows.offerRecovered(); });
    return opened ? application.exec() : console::failure;
}

// Batch commands need no display; windows without one are said to be impossible, in words.
int run(QApplication& application, const QStringList& arguments, const std::string& displayFault) {
    const qsizetype medium = arguments.indexOf("--check-medium");
    if (medium == 1)
        return arguments.size() < 3 ? wrong("--check-medium wants a command")
                                    : console::checkMedium(arguments.mid(2));
    QCommandLineParser options;
    options.addOptions({{"convert-to", {}, "format"},
                        {"output", {}, "file"},
                        {"presentation", {}, "name"},
                        {"check", {}},
                        {"play", {}},
                        {"help", {}},
                        {"version", {}}});
    if (!options.parse(arguments))
        return wrong(options.errorText());
    if (options.isSet("help") || options.isSet("version")) {
        const std::string version =
            "ensemble " + application.applicationVersion().toStdString() + "\n";
        return terminal::print(options.isSet("help") ? usage : version) ? console::success
                                                                        : console::failure;
    }
    if (options.isSet("convert-to"))
        return convert(options);
    if (options.isSet("check"))
        return options.positionalArguments().size() == 1
                   ? console::check(options.positionalArguments().first())
                   : wrong("--check wants one document");
    if (options.isSet("output"))
        return wrong("--output belongs to --convert-to");
    if (options.isSet("presentation"))
        return wrong("--presentation belongs to --convert-to");
    if (!displayFault.empty()) {
        terminal::complain("ensemble: " + displayFault + "; --convert-to and --check need none");
        return console::failure;
    }
    return openWindows(application, options);
}

bool isBatch(int argc, char** argv) {
    for (int i = 1; i < argc; ++i)
        for (const char* option :
             {"--convert-to", "--check", "--check-medium", "--help", "--version"})
            if (QByteArray(argv[i]).startsWith(option))
                return true;
    return false;
}

} // namespace

int main(int argc, char** argv) {
    screen::keepNumbersC();
    const std::string displayFault = screen::displayFault();
    if (isBatch(argc, argv) || !displayFault.empty())
        qputenv("QT_QPA_PLATFORM", "offscreen");
    // Standard error of a batch command is for its own messages: not for hints of Qt about the
    // desktop.
    plain::printQtMessages("ensemble", isBatch(argc, argv) ? plain::QtMessages::errors
                                                           : plain::QtMessages::all);
    QApplication application(argc, argv);
    QApplication::setApplicationName("ensemble");
    QApplication::setOrganizationName("ensemble");
    QApplication::setApplicationVersion(ENSEMBLE_VERSION);
    return run(application, application.arguments(), displayFault);
}
