// The output of batch commands: a file, or standard output for "-".
#pragma once

#include <cstdio>
#include <string>

namespace batch {

class Output {
public:
    // Opens the file for writing; good() says whether that went well.
    explicit Output(const std::string& file);
    ~Output();
    Output(const Output&) = delete;
    Output& operator=(const Output&) = delete;

    [[nodiscard]] bool good() const { return stream_ != nullptr; }
    // For tables, whose names are cells (table.h); what else is text goes through write().
    [[nodiscard]] std::FILE* stream() const { return stream_; }
    // Text, in a form that a terminal may get. False: not all was written.
    [[nodiscard]] bool write(const std::string& text);
    // Everything has arrived; false with a sentence on standard error otherwise.
    [[nodiscard]] bool finish(bool written);

private:
    std::string name_;
    std::FILE* stream_;
};

} // namespace batch
