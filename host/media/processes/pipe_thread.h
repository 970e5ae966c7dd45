// One thread reads and writes the pipes of all media, and is their parent.
// It lives as long as the program: media are launched from it (their death is tied to it), their
// bytes are split into messages and parsed in it, and these messages reach the interface thread
// through mailboxes. So the interface thread never waits for a medium, not even for its start, and
// never parses what a medium sent. It watches their memory, too.
#pragma once

#include "processes/launcher.h"
#include "processes/mailbox.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <sys/types.h>
#include <thread>
#include <vector>

namespace media {

class PipeThread {
public:
    using Link = std::uint64_t;

    PipeThread();
    ~PipeThread(); // ends every medium, and waits for it
    PipeThread(const PipeThread&) = delete;
    PipeThread& operator=(const PipeThread&) = delete;

    // Starts a medium; `frames` must stay open until the mailbox says `started` or `ended`.
    [[nodiscard]] Link start(Launch launch, std::shared_ptr<Mailbox> mailbox);
    // False when so much is unsent that the medium obviously does not read.
    [[nodiscard]] bool send(Link link, std::string framed);
    [[nodiscard]] std::size_t unsent(Link link) const; // messages
    void closeInput(Link link);                        // after what is unsent
    // Ends it now. Its mailbox gets `ended` with `why` when nothing of it is left.
    void end(Link link, std::string why);

    // The parent of processes that were asked to end and that nobody waits for.
    [[nodiscard]] QObject& departing() { return *departing_; }
    // Processes that have been started and not yet been reaped.
    [[nodiscard]] int alive() const;

    // The memory that all media may hold together; usualMemory() at first. While they hold more,
    // the one that holds the most is ended.
    void setMostMemory(std::size_t bytes);
    [[nodiscard]] std::size_t mostMemory() const;
    // Another medium fits, as far as is known of those that are there: memory.h.
    [[nodiscard]] bool hasRoom() const;
    // How the memory of a process is measured; memoryOf() at first. Called in this thread.
    void setMeasure(std::function<std::size_t(pid_t)> measure);

private:
    struct Shared;
    class Loop;
    std::shared_ptr<Shared> shared_;
    std::thread thread_;
    std::unique_ptr<QObject> departing_ = std::make_unique<QObject>();
};

} // namespace media
