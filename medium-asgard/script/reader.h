// Scene text in, scene and diagnostics out, whatever the text holds.
//
// Text is a Tcl script and runs only in a disposable confined process: an evaluator, forked from a
// server that was forked before this process saw any document. A script that loops, grows, nests
// or attacks ends with its evaluator, and the diagnostics say so. A server that ended is started
// again, and a warning says so.
//
// Reference: dissertation 4.2; docs/scene-language.md; architecture, "Processes".
#pragma once

#include "scene/diagnostic.h"
#include "scene/scene.h"

#include <chrono>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace script {

struct ReadResult {
    scene::Scene scene;                         // what could be read; usable only when `usable`
    std::vector<scene::Diagnostic> diagnostics; // by place
    bool usable = false;                        // no errors (warnings do not count)
};

struct Limits {
    std::chrono::milliseconds wallClock{3000};
    std::size_t bytes = 256u << 20;
    long cpuSeconds = 2;
    long commands = 10'000'000;
    // Of evaluator servers that ended: so many within this time, and no more before it is over.
    int restarts = 3;
    std::chrono::milliseconds restartsWithin{60'000};
};

// The evaluator servers. Start them before the process opens files of a document, threads or
// displays.
class Reader {
public:
    // Forks the servers. Errors of the system (no more processes) are reported by read().
    explicit Reader(Limits limits = {});
    ~Reader(); // ends the servers and their evaluators
    Reader(const Reader&) = delete;
    Reader& operator=(const Reader&) = delete;

    // Blocks until the evaluation ends or its limits end it; thread-safe, one at a time.
    // `parameters` override the values of `parameter` commands; unknown names are errors.
    // A reading during which the server ends is tried once more.
    [[nodiscard]] ReadResult read(std::string_view text,
                                  const std::map<std::string, double>& parameters = {});
    // Ends the evaluation that runs now, if any; its read() returns with an error. Any thread.
    void cancel();

private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
};

} // namespace script
