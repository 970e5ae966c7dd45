#include "computing/worker.h"

#include "computing/memory.h"

#include <algorithm>
#include <new>
#include <utility>

namespace computing {

namespace {

// Every now and then: has the process grown by more than so much since the motion was begun?
class MemoryWatch {
public:
    explicit MemoryWatch(std::size_t most) : most_(most), before_(residentBytes()) {}
    [[nodiscard]] bool isOver() { // on any thread
        if (isOver_)
            return true;
        constexpr auto pause = std::chrono::milliseconds(100);
        const auto now = Clock::now().time_since_epoch().count();
        auto next = next_.load();
        if (now < next ||
            !next_.compare_exchange_strong(next, now + Clock::duration(pause).count()))
            return false;
        if (residentBytes() > before_ + most_)
            isOver_ = true;
        return isOver_;
    }
    [[nodiscard]] bool wasOver() const { return isOver_; }
    [[nodiscard]] bool hasGrown() const {
        constexpr std::size_t much = std::size_t{100} << 20;
        return residentBytes() > before_ + much;
    }

private:
    std::size_t most_, before_;
    std::atomic<Clock::rep> next_ = 0;
    std::atomic<bool> isOver_ = false;
};

} // namespace

Worker::Worker(Tools tools, std::function<void()> wake)
    : tools_(std::move(tools)), wake_(std::move(wake)) {}

Worker::~Worker() {
    {
        const std::lock_guard lock(mutex_);
        stop_ = true;
    }
    wakeReading_.notify_one();
    wakeMoving_.notify_one();
    tools_.cancelReading();
    if (reading_.joinable())
        reading_.join();
    if (moving_.joinable())
        moving_.join();
}

void Worker::start(const std::string& text, Order order) {
    {
        const std::lock_guard lock(mutex_);
        text_ = text;
        waiting_ = true;
        ++serial_;
        if (order.haste == Haste::now)
            lastUrgent_ = serial_.load();
        const bool isLong = Clock::now() - began_ > longestReading;
        // Within the lock, so that it is not the new text whose reading ends.
        if (reads_ && (isLong || order.haste == Haste::now))
            tools_.cancelReading();
        order_ = std::move(order);
        if (!reading_.joinable()) {
            reading_ = std::thread([this] { readOn(); });
            moving_ = std::thread([this] { moveOn(); });
        }
    }
    wakeReading_.notify_one();
}

void Worker::cancel() {
    const std::lock_guard lock(mutex_);
    cancelled_ = serial_.load();
    if (reads_)
        tools_.cancelReading();
}

std::vector<News> Worker::collect() {
    const std::lock_guard lock(newsMutex_);
    return std::exchange(news_, {});
}

void Worker::tell(News news) {
    {
        const std::lock_guard lock(newsMutex_);
        if (!news_.empty() && std::holds_alternative<Progress>(news_.back()) &&
            std::holds_alternative<Progress>(news))
            news_.back() = std::move(news);
        else
            news_.push_back(std::move(news));
    }
    wake_();
}

bool Worker::overtaken(unsigned serial, Clock::time_point began, Clock::duration most) const {
    return stop_ || serial < lastUrgent_ || (serial != serial_ && Clock::now() - began > most);
}

void Worker::readOn() {
    std::unique_lock lock(mutex_);
    while (true) {
        wakeReading_.wait(lock, [this] { return stop_ || waiting_; });
        if (stop_)
            return;
        waiting_ = false;
        const std::string text = text_;
        const unsigned serial = serial_;
        Order order = order_;
        began_ = Clock::now();
        reads_ = true;
        lock.unlock();
        read(text, serial, std::move(order));
        lock.lock();
        reads_ = false;
    }
}

// The values outlive an edit that removes their parameter: then they are left out.
script::ReadResult Worker::readWith(ParameterValues& parameters, const std::string& text) const {
    script::ReadResult reading = tools_.read(text, parameters);
    if (reading.usable || parameters.empty())
        return reading;
    script::ReadResult plain = tools_.read(text, {});
    const auto unknown = [&](const auto& entry) {
        return std::ranges::find(plain.scene.parameters, entry.first, &scene::Parameter::name) ==
               plain.scene.parameters.end();
    };
    if (!plain.usable || std::erase_if(parameters, unknown) == 0)
        return reading;
    return parameters.empty() ? plain : tools_.read(text, parameters);
}

void Worker::read(const std::string& text, unsigned serial, Order order) {
    const Clock::time_point began = Clock::now();
    script::ReadResult result;
    if (!isCancelled(serial))
        result = readWith(order.parameters, text);
    // A reading that was cancelled says nothing about the text.
    if (overtaken(serial, began, longestReading))
        return;
    if (isCancelled(serial)) {
        Moved moved;
        moved.serial = serial;
        moved.result.cancelled = true;
        return tell(std::move(moved));
    }
    Reading reading;
    reading.serial = serial;
    reading.text = text;
    reading.diagnostics = std::move(result.diagnostics);
    if (result.usable)
        reading.scene = std::make_shared<const scene::Scene>(std::move(result.scene));
    std::optional<simulation::Result> known;
    if (reading.scene && !order.moves)
        known = former_.of(text, order.parameters, order.haste == Haste::gesture);
    reading.moves = reading.scene && (order.moves || known);
    std::optional<Job> job;
    if (reading.moves)
        job = Job{serial, text, reading.scene, std::move(order), std::move(known)};
    tell(std::move(reading));
    if (!job)
        return;
    {
        const std::lock_guard lock(mutex_);
        job_ = std::move(job);
    }
    wakeMoving_.notify_one();
}

void Worker::moveOn() {
    std::unique_lock lock(mutex_);
    while (true) {
        wakeMoving_.wait(lock, [this] { return stop_ || job_; });
        if (stop_)
            return;
        const Job job = *std::exchange(job_, std::nullopt);
        lock.unlock();
        if (job.serial >= lastUrgent_)
            move(job);
        lock.lock();
    }
}

void Worker::move(const Job& job) {
    const Clock::time_point began = Clock::now();
    const auto over = [&] { return overtaken(job.serial, began, job.order.overlap); };
    simulation::Observer observer;
    MemoryWatch memory(job.order.mostBytes);
    observer.cancelled = [&] { return isCancelled(job.serial) || over() || memory.isOver(); };
    observer.progress = [&](simulation::MotionPointer motion) {
        if (!over())
            tell(Progress{job.serial, job.scene, std::move(motion), Clock::now() - began});
    };
    simulation::Options options;
    options.threads = 0; // as many as there are cores
    options.parameters = job.order.parameters;
    Moved moved;
    moved.serial = job.serial;
    moved.scene = job.scene;
    try {
        const bool isGesture = job.order.haste == Haste::gesture;
        auto former = job.known || job.order.anew
                          ? job.known
                          : former_.of(job.text, options.parameters, isGesture);
        if (former) {
            moved.result = std::move(*former);
        } else {
            moved.result = tools_.simulate(job.scene, options, observer);
            former_.add(job.text, options.parameters, moved.result, job.scene->bodies.size(),
                        isGesture);
        }
    } catch (const std::bad_alloc&) {
        moved.result.refusal.emplace_back("the motion needs more memory than its process may have");
    }
    moved.lasted = Clock::now() - began;
    if (memory.wasOver() && moved.result.cancelled) {
        moved.result.cancelled = false;
        moved.result.refusal.push_back("the motion up to here takes more than " +
                                       std::to_string(job.order.mostBytes >> 20) +
                                       " MB, which is the limit");
    }
    if (memory.hasGrown())
        returnFreeMemory();
    if (!stop_)
        tell(std::move(moved));
}

} // namespace computing
