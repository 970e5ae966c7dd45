// Threads that do independent pieces of work side by side.
//
// Which thread does which piece is left to chance: a piece may touch only what no other does, and
// then the result is the same for any number of threads. Threads are started when first needed and
// sleep in between, until they are told to rest.
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace solution {

class Workers {
public:
    // The calling thread is one of them. 0: as many as the machine has cores.
    explicit Workers(std::size_t threads);
    ~Workers();
    Workers(const Workers&) = delete;
    Workers& operator=(const Workers&) = delete;

    [[nodiscard]] std::size_t threads() const { return threads_; }
    // Ends the threads until they are needed again.
    void rest();

    // Calls work(i) for each i < count, once; `meanwhile` every millisecond on the calling thread
    // while it waits for the others. An exception of a piece is thrown here, when all are done.
    void forEach(std::size_t count, const std::function<void(std::size_t)>& work,
                 const std::function<void()>& meanwhile);

private:
    void start();
    void serve(std::size_t seen); // jobs
    void takePieces();

    std::size_t threads_;
    std::vector<std::thread> others_;
    std::mutex mutex_;
    std::condition_variable begin_, done_;
    std::size_t job_ = 0;  // how many jobs there were
    std::size_t busy_ = 0; // threads at work on the job, besides the calling one
    bool ends_ = false;
    std::exception_ptr thrown_;

    const std::function<void(std::size_t)>* work_ = nullptr;
    std::size_t count_ = 0;
    std::atomic<std::size_t> next_ = 0;
};

} // namespace solution
