#include "terminal/terminal.h"

#include "text/printable.h"

#include <cstdio>
#include <string>

#include <unistd.h>

namespace terminal {

namespace {

bool put(std::FILE* stream, std::string_view bytes) {
    return std::fwrite(bytes.data(), 1, bytes.size(), stream) == bytes.size() &&
           std::fflush(stream) == 0;
}

} // namespace

void complain(std::string_view message) { put(stderr, text::message(message)); }

void say(std::string_view message) { put(stdout, text::message(message)); }

bool print(std::string_view text) { return put(stdout, text::printable(text)); }

bool pass(std::string_view bytes) { return put(stdout, bytes); }

bool isTerminal() { return ::isatty(STDOUT_FILENO) == 1; }

bool errorsAreATerminal() { return ::isatty(STDERR_FILENO) == 1; }

Progress::~Progress() {
    if (shown_ > 0)
        put(stderr, "\r" + std::string(shown_, ' ') + "\r");
}

void Progress::show(std::string_view line) {
    const std::string text = text::oneLine(line);
    const std::size_t rest = shown_ > text.size() ? shown_ - text.size() : 0;
    put(stderr, "\r" + text + std::string(rest, ' '));
    shown_ = text.size();
}

} // namespace terminal
