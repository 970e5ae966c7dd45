#include "render/drawing_thread.h"

#include <algorithm>
#include <future>
#include <utility>

namespace render {

DrawingThread::DrawingThread(Work atEnd) : atEnd_(std::move(atEnd)), thread_([this] { serve(); }) {}

DrawingThread::~DrawingThread() {
    {
        const std::lock_guard lock(mutex_);
        stop_ = true;
    }
    wished_.notify_one();
    thread_.join();
}

void DrawingThread::draw(Customer customer, Work work) {
    {
        const std::lock_guard lock(mutex_);
        Wish& wish = wishes_[customer];
        if (!wish.work)
            wish.turn = ++turn_;
        else // let go over there
            before_.push_back([replaced = std::move(wish.work)] {});
        wish.work = std::move(work);
    }
    wished_.notify_one();
}

bool DrawingThread::takeBack(Customer customer) {
    const std::lock_guard lock(mutex_);
    const auto wish = wishes_.find(customer);
    if (wish == wishes_.end())
        return false;
    before_.push_back([replaced = std::move(wish->second.work)] {});
    wishes_.erase(wish);
    wished_.notify_one();
    return true;
}

void DrawingThread::before(Work work) {
    {
        const std::lock_guard lock(mutex_);
        before_.push_back(std::move(work));
    }
    wished_.notify_one();
}

void DrawingThread::run(const Work& work) {
    const auto done = std::make_shared<std::promise<void>>();
    before([done, &work] {
        work();
        done->set_value();
    });
    done->get_future().wait();
}

void DrawingThread::inSpareTime(Work work) {
    {
        const std::lock_guard lock(mutex_);
        before_.push_back([replaced = std::move(spare_)] {});
        spare_ = std::move(work);
    }
    wished_.notify_one();
}

DrawingThread::Work DrawingThread::next() {
    if (!before_.empty())
        return [all = std::exchange(before_, {})] {
            for (const Work& work : all)
                work();
        };
    const auto first =
        std::ranges::min_element(wishes_, {}, [](const auto& wish) { return wish.second.turn; });
    if (first == wishes_.end())
        return std::exchange(spare_, {});
    Work work = std::move(first->second.work);
    wishes_.erase(first);
    return work;
}

void DrawingThread::serve() {
    std::unique_lock lock(mutex_);
    while (true) {
        Work work;
        wished_.wait(lock, [&] { return stop_ || (work = next()); });
        if (stop_)
            break;
        lock.unlock();
        work();
        work = {};
        lock.lock();
    }
    lock.unlock();
    wishes_.clear(); // nobody asks any more
    before_.clear();
    spare_ = {};
    if (atEnd_)
        atEnd_();
}

} // namespace render
