#include "batch/output.h"

#include "terminal/terminal.h"
#include "text/printable.h"

#include <cerrno>
#include <cstring>

namespace batch {

Output::Output(const std::string& file)
    : name_(file == "-" ? "standard output" : file),
      stream_(file == "-" ? stdout : std::fopen(file.c_str(), "wb")) {
    if (!stream_)
        terminal::complain("asgard: " + name_ + ": " + std::strerror(errno));
}

Output::~Output() {
    if (stream_ && stream_ != stdout)
        std::fclose(stream_);
}

bool Output::write(const std::string& text) {
    const std::string shown = text::printable(text);
    return std::fwrite(shown.data(), 1, shown.size(), stream_) == shown.size();
}

bool Output::finish(bool written) {
    errno = 0;
    const bool flushed = std::fflush(stream_) == 0;
    if (written && flushed)
        return true;
    terminal::complain("asgard: " + name_ + ": " + std::strerror(errno == 0 ? EIO : errno));
    return false;
}

} // namespace batch
