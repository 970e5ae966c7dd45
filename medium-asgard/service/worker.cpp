#include "service/worker.h"

#include <algorithm>
#include <new>

#include <sys/eventfd.h>
#include <unistd.h>

namespace service {

Worker::Worker(Tools tools)
    : tools_(std::move(tools)), descriptor_(eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC)) {}

Worker::~Worker() {
    {
        const std::lock_guard lock(mutex_);
        ending_ = cancelled_ = true;
    }
    wake_.notify_all();
    tools_.cancelReading();
    if (thread_.joinable())
        thread_.join();
    close(descriptor_);
}

void Worker::start(std::string text, ParameterValues parameters) {
    {
        const std::lock_guard lock(mutex_);
        ++newest_;
        next_.reset();
        news_ = {};
        busy_ = true;
    }
    tools_.cancelReading(); // before the new job can be taken: it must not hit that one
    {
        const std::lock_guard lock(mutex_);
        next_ = Job{std::move(text), std::move(parameters)};
        cancelled_ = false;
        if (!thread_.joinable())
            thread_ = std::thread([this] { run(); });
    }
    wake_.notify_all();
}

void Worker::cancel() {
    {
        const std::lock_guard lock(mutex_);
        cancelled_ = true;
    }
    tools_.cancelReading();
}

bool Worker::busy() const {
    const std::lock_guard lock(mutex_);
    return busy_;
}

News Worker::collect() {
    std::uint64_t count = 0;
    [[maybe_unused]] const auto drained = read(descriptor_, &count, sizeof count);
    const std::lock_guard lock(mutex_);
    if (news_.refusal)
        busy_ = false;
    return std::exchange(news_, {});
}

bool Worker::superseded(unsigned number) const {
    const std::lock_guard lock(mutex_);
    return number != newest_ || cancelled_;
}

void Worker::publish(unsigned number, const std::function<void(News&)>& add) {
    {
        const std::lock_guard lock(mutex_);
        if (number != newest_)
            return;
        add(news_);
    }
    wake();
}

void Worker::wake() const {
    const std::uint64_t one = 1;
    [[maybe_unused]] const auto written = write(descriptor_, &one, sizeof one);
}

void Worker::run() {
    for (;;) {
        Job job;
        unsigned number = 0;
        {
            std::unique_lock lock(mutex_);
            wake_.wait(lock, [this] { return ending_ || next_; });
            if (ending_)
                return;
            job = std::move(*next_);
            next_.reset();
            number = newest_;
        }
        perform(job, number);
    }
}

// The overrides outlive an edit that removes their parameter: then they are left out.
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

void Worker::perform(const Job& job, unsigned number) {
    ParameterValues parameters = job.parameters;
    script::ReadResult reading = readWith(parameters, job.text);
    // A reading that a newer job cancelled says nothing about the text.
    if (superseded(number))
        return publish(number, [](News& news) {
            news.refusal.emplace();
            news.cancelled = true;
        });
    const bool usable = reading.usable;
    const auto scene = std::make_shared<const scene::Scene>(std::move(reading.scene));
    publish(number, [&](News& news) {
        news.diagnostics = std::move(reading.diagnostics);
        if (usable)
            news.scene = scene;
        else
            news.refusal.emplace();
    });
    if (!usable)
        return;
    simulation::Options options;
    options.parameters = parameters;
    simulation::Observer observer;
    observer.cancelled = [this, number] { return superseded(number); };
    observer.progress = [this, number](simulation::MotionPointer motion) {
        publish(number, [&](News& news) { news.motion = std::move(motion); });
    };
    simulation::Result result;
    try {
        result = tools_.simulate(scene, options, observer);
    } catch (const std::bad_alloc&) {
        result.refusal.emplace_back("the motion needs more memory than its process may have");
    }
    publish(number, [&](News& news) {
        if (result.motion)
            news.motion = std::move(result.motion);
        news.refusal = std::move(result.refusal);
        news.cancelled = result.cancelled;
        news.statistics = result.statistics;
    });
}

} // namespace service
