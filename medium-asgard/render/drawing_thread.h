// A thread to draw on: a renderer belongs to it, and whoever wants a picture goes on meanwhile.
//
// A customer (a window, a rendition) has at most one picture that is not begun; a newer one takes
// its place and its turn. Customers have their turns in the order in which they asked; one whose
// picture was taken back asks anew. What a piece of work holds is let go on this thread, also of
// work that is never done: an old motion may be large.
#pragma once

#include <condition_variable>
#include <functional>
#include <map>
#include <mutex>
#include <thread>
#include <vector>

namespace render {

class DrawingThread {
public:
    using Customer = const void*;
    using Work = std::function<void()>;

    // `atEnd`: the last piece of work, so that what belongs to the thread ends there.
    explicit DrawingThread(Work atEnd = {});
    ~DrawingThread(); // the picture that is begun is waited for, those that wait are not begun
    DrawingThread(const DrawingThread&) = delete;
    DrawingThread& operator=(const DrawingThread&) = delete;

    void draw(Customer customer, Work work);
    // Its picture is not begun any more. False: none was waiting; one may be being drawn.
    bool takeBack(Customer customer);
    void before(Work work);      // the next picture; in the order of these calls
    void run(const Work& work);  // the same, and waits for it
    void inSpareTime(Work work); // when no picture waits; a newer one replaces it

private:
    struct Wish {
        Work work;
        unsigned turn = 0;
    };
    void serve();
    [[nodiscard]] Work next(); // empty: there is nothing to do

    std::mutex mutex_;
    std::condition_variable wished_;
    std::map<Customer, Wish> wishes_; // under mutex_, as what follows
    std::vector<Work> before_;
    Work spare_, atEnd_;
    unsigned turn_ = 0;
    bool stop_ = false;
    std::thread thread_; // the first to go
};

} // namespace render
