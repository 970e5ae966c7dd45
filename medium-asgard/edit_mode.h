// The medium's process in mode `edit`: the same session, beside windows in which the author works.
//
// The text is the host's. What a window changes is proposed to the host and becomes the text when
// it accepts; what the host changes (undo, redo, another view) arrives in every window.
#pragma once

#include "script/reader.h"
#include "service/serve.h"

namespace asgard {

// Whether windows can be opened here: empty, or the sentence why not.
[[nodiscard]] std::string noDisplay();

// One reader for several users on several threads: a user's cancel ends only what that user reads.
class SharedReader {
public:
    explicit SharedReader(script::Reader& reader) : reader_(reader) {}
    [[nodiscard]] script::ReadResult read(int user, std::string_view text,
                                          const std::map<std::string, double>& parameters = {});
    void cancel(int user);

private:
    script::Reader& reader_;
    std::mutex turn_;  // held while reading
    std::mutex mutex_; // guards reads_
    int reads_ = 0;    // the user whose text is read; 0: none's
};

// Opens the windows that menu entries name; made once the mode is known.
class Windows {
public:
    virtual ~Windows() = default;
    virtual std::optional<std::string> open(const std::string& entry) = 0;
};

// Serves until the connection is closed. `windows` points to the windows meanwhile.
void serveWithWindows(service::Connection& connection, SharedReader& reader, int user,
                      Windows*& windows);

} // namespace asgard
