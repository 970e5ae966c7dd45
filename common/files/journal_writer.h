// Keeps one document's text in the journal, on a thread of its own: a disk that takes long holds up
// nobody who types.
#pragma once

#include "files/journal.h"

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>

namespace files {

class JournalWriter {
public:
    // `failed` is called on the writer's thread, with a sentence, once until keeping works again.
    using Failed = std::function<void(const std::string& sentence)>;
    // After each text that was written there is a pause, so that typing writes a few times a
    // second; a forgotten text goes at once.
    JournalWriter(FileSystem& files, std::string folder, Failed failed,
                  std::chrono::milliseconds pause = std::chrono::milliseconds(300));
    ~JournalWriter(); // does first what was asked for; a kept text then stays
    JournalWriter(const JournalWriter&) = delete;
    JournalWriter& operator=(const JournalWriter&) = delete;

    // As soon as pause and disk allow; of what is asked for meanwhile the newest is done.
    void keep(Kept kept);
    void forget();
    // The content kept at `place` is this document's from now on.
    void adopt(std::unique_ptr<Place> place);
    void finish(); // returns when what was asked for is done

    // Of what is kept; "" while nothing is. As of the last finish().
    [[nodiscard]] std::string path();

private:
    void run();
    void perform(std::optional<Kept> kept);
    [[nodiscard]] std::string claim();

    FileSystem& files_;
    std::string folder_;
    Failed failed_;
    std::chrono::milliseconds pause_;
    std::unique_ptr<Place> place_; // the thread's while busy_
    bool hasFailed_ = false;

    std::mutex mutex_; // of what follows
    std::condition_variable changed_;
    std::optional<std::optional<Kept>> asked_; // nothing in it: to forget
    bool busy_ = false, ends_ = false;
    int hurry_ = 0;      // those who wait in finish()
    std::thread thread_; // from the first keep() on
};

} // namespace files
