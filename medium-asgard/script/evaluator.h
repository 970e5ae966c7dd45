// The two processes behind a Reader: the server, and one evaluator per reading.
//
// The server is forked before its parent has seen a document. It keeps one evaluator ready: forked,
// its interpreter made, confined, waiting for a text. A request goes to that evaluator as it is;
// what it answers goes back as it is; then it is ended, whatever it does, and the next is made
// ready. The server understands neither, so that a hostile script meets no parser of ours outside
// its own process and the reader's.
//
// Each message begins with a Header. requests: evaluate (a Request), cancel. replies: a Status in
// the header and the recording's bytes, as far as they came.
#pragma once

#include "script/reader.h"

#include <cstdint>

namespace script {

struct Header {
    static constexpr std::uint32_t magicNumber = 0x41534731; // "ASG1"
    std::uint32_t magic = magicNumber;
    std::uint32_t kind = 0; // of a request: Kind; of a reply: End
    std::uint64_t serial = 0;
    std::uint64_t bytes = 0;    // that follow
    std::uint64_t progress = 0; // of a reply: the offset of the command that ran last
    std::int32_t status = 0;    // of a reply: exit code or signal
    std::int32_t unused = 0;
};

enum class Kind : std::uint32_t { evaluate = 1, cancel = 2 };

// How an evaluator ended.
enum class End : std::uint32_t { exited, signalled, outOfTime, cancelled, tooMuch, notStarted };

constexpr int exitOutOfMemory = 77;

// What this process does from here on; never returns. `requests` and `replies` are descriptors,
// `parent` the process that forked this one.
[[noreturn]] void serveEvaluations(int requests, int replies, int parent, const Limits& limits);

// Reads or writes everything, over interruptions. False at the end of the pipe or an error.
bool readAll(int fd, void* bytes, std::size_t count);
bool writeAll(int fd, const void* bytes, std::size_t count);

} // namespace script
