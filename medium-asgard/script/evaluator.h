// The two processes behind a Reader: the server, and one evaluator per reading.
//
// The server is forked before its parent has seen a document. It keeps one evaluator ready: forked,
// its interpreter made, confined, waiting for a text. A request goes to that evaluator as it is;
// what it answers goes back as it is; then it is ended, whatever it does, and the next is made
// ready. The server understands neither, so that a hostile script meets no parser of ours outside
// its own process and the reader's.
//
// The reader's process cannot start another server once it is confined or has threads. A server
// can: its image of memory is the one from before any document (servers.h).
//
// Each message begins with a Header. requests: evaluate (a Request), cancel, another server.
// replies: a Status in the header and the recording's bytes, as far as they came.
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

enum class Kind : std::uint32_t { evaluate = 1, cancel = 2, another = 3 };

// How an evaluation ended. The last three are the reader's words, never a server's.
enum class End : std::uint32_t {
    exited,
    signalled,
    outOfTime,
    cancelled,
    tooMuch,
    notStarted,
    serverEnded,   // twice
    endedTooOften, // no other is started for some time
    noServer       // nor a spare
};

constexpr int exitOutOfMemory = 77;

// The descriptors of a server. Another server goes to the reader through `arrivals` (processes.h).
struct ServerEnds {
    int requests = -1;
    int replies = -1;
    int arrivals = -1;
};

// The work of this process from here on; never returns. `parent` is the process that forked this
// one. A spare makes no evaluator ready before it is asked for something.
[[noreturn]] void serveEvaluations(const ServerEnds& ends, int parent, const Limits& limits,
                                   bool spare);

} // namespace script
