#include "batch/output.h"

#include <cerrno>
#include <cstring>

namespace batch {

Output::Output(const std::string& file)
    : name_(file == "-" ? "standard output" : file),
      stream_(file == "-" ? stdout : std::fopen(file.c_str(), "wb")) {
    if (!stream_)
        std::fprintf(stderr, "asgard: %s: %s\n", name_.c_str(), std::strerror(errno));
}

Output::~Output() {
    if (stream_ && stream_ != stdout)
        std::fclose(stream_);
}

bool Output::finish(bool written) {
    errno = 0;
    const bool flushed = std::fflush(stream_) == 0;
    if (written && flushed)
        return true;
    std::fprintf(stderr, "asgard: %s: %s\n", name_.c_str(),
                 std::strerror(errno == 0 ? EIO : errno));
    return false;
}

} // namespace batch
