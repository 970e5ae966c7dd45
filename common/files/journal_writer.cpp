#include "files/journal_writer.h"

#include <utility>

namespace files {

JournalWriter::JournalWriter(FileSystem& files, std::string folder, Failed failed,
                             std::chrono::milliseconds pause)
    : files_(files), folder_(std::move(folder)), failed_(std::move(failed)), pause_(pause) {}

JournalWriter::~JournalWriter() {
    {
        const std::lock_guard lock(mutex_);
        ends_ = true;
    }
    changed_.notify_all();
    if (thread_.joinable())
        thread_.join();
}

void JournalWriter::keep(Kept kept) {
    {
        const std::lock_guard lock(mutex_);
        asked_ = std::optional(std::move(kept));
        if (!thread_.joinable())
            thread_ = std::thread([this] { run(); });
    }
    changed_.notify_all();
}

void JournalWriter::forget() {
    {
        const std::lock_guard lock(mutex_);
        if (!thread_.joinable()) { // nothing was ever kept here, but perhaps adopted
            perform({});
            return;
        }
        asked_ = std::optional<Kept>();
    }
    changed_.notify_all();
}

void JournalWriter::adopt(std::unique_ptr<Place> place) {
    finish();
    if (place_)
        place_->remove();
    place_ = std::move(place);
}

void JournalWriter::finish() {
    std::unique_lock lock(mutex_);
    ++hurry_;
    changed_.notify_all();
    changed_.wait(lock, [this] { return !busy_ && !asked_; });
    --hurry_;
}

std::string JournalWriter::path() {
    finish();
    return place_ ? place_->path() : std::string();
}

void JournalWriter::run() {
    std::unique_lock lock(mutex_);
    auto next = std::chrono::steady_clock::now();
    for (;;) {
        changed_.wait(lock, [this] { return ends_ || asked_; });
        if (!asked_)
            return;
        changed_.wait_until(lock, next,
                            [this] { return ends_ || hurry_ > 0 || !asked_->has_value(); });
        std::optional<Kept> kept = std::move(*asked_);
        asked_.reset();
        busy_ = true;
        lock.unlock();
        perform(std::move(kept));
        next = std::chrono::steady_clock::now() + pause_;
        lock.lock();
        busy_ = false;
        changed_.notify_all();
    }
}

std::string JournalWriter::claim() {
    if (place_)
        return {};
    Place::Claimed claimed = Place::claim(files_, folder_);
    if (const auto* fault = std::get_if<std::string>(&claimed))
        return *fault + ".";
    place_ = std::move(std::get<std::unique_ptr<Place>>(claimed));
    return {};
}

void JournalWriter::perform(std::optional<Kept> kept) {
    if (!kept) {
        if (place_)
            place_->remove();
        place_.reset();
        return;
    }
    std::string fault = claim();
    if (fault.empty()) {
        const auto since = std::chrono::system_clock::now().time_since_epoch();
        kept->at = std::chrono::duration_cast<std::chrono::seconds>(since).count();
        fault = place_->keep(*kept);
    }
    if (fault.empty())
        hasFailed_ = false;
    else if (!std::exchange(hasFailed_, true) && failed_)
        failed_("Unsaved changes cannot be kept in " + folder_ + ": " + fault);
}

} // namespace files
