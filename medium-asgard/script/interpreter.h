// A Tcl interpreter that has the commands of scenes and nothing that reaches outside.
//
// Tcl's commands are an allow-list (commands.h); all others are deleted, not hidden, and those that
// authors may look for say why they are missing. Scene commands record their words and make
// nothing: elements are made of the recording, in another process.
//
// Runs in an evaluator only: a hostile script can crash or exhaust the process that it runs in.
#pragma once

#include "script/wire.h"

#include <atomic>
#include <memory>
#include <string>

namespace script {

// The progress of an evaluation that never answers, as the process that waits can see it.
struct Progress {
    std::atomic<std::uint64_t> offset{noOffset}; // of the command that runs
};

class Interpreter {
public:
    explicit Interpreter(Progress& progress);
    ~Interpreter();
    Interpreter(const Interpreter&) = delete;
    Interpreter& operator=(const Interpreter&) = delete;

    // Once. The bytes of a recording.
    const std::string& evaluate(const Request& request);
    // The recording so far, when there is no memory to end it.
    [[nodiscard]] const std::string& recorded() const;

private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
};

} // namespace script
