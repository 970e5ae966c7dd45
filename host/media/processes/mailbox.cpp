#include "processes/mailbox.h"

namespace media {

void Mailbox::append(Letter&& letter) {
    bytes_ += letter.bytes;
    letters_.push_back(std::move(letter));
    if (receiver_ && !rung_)
        rung_ = QMetaObject::invokeMethod(receiver_, slot_, Qt::QueuedConnection);
}

bool Mailbox::push(Letter letter) {
    const std::lock_guard lock(mutex_);
    if (letters_.size() >= mostMessages || (!letters_.empty() && bytes_ + letter.bytes > mostBytes))
        return false;
    append(std::move(letter));
    return true;
}

void Mailbox::pushAlways(Letter letter) {
    const std::lock_guard lock(mutex_);
    append(std::move(letter));
}

bool Mailbox::take(Letter& letter) {
    const std::lock_guard lock(mutex_);
    rung_ = false;
    if (letters_.empty())
        return false;
    letter = std::move(letters_.front());
    letters_.pop_front();
    bytes_ -= letter.bytes;
    return true;
}

void Mailbox::ring() {
    const std::lock_guard lock(mutex_);
    if (receiver_ && !rung_)
        rung_ = QMetaObject::invokeMethod(receiver_, slot_, Qt::QueuedConnection);
}

void Mailbox::detach() {
    const std::lock_guard lock(mutex_);
    receiver_ = nullptr;
}

void Mailbox::await(ipc::Integer id, std::size_t call) {
    const std::lock_guard lock(mutex_);
    awaited_[id] = call;
}

std::optional<std::size_t> Mailbox::awaited(ipc::Integer id) {
    const std::lock_guard lock(mutex_);
    const auto found = awaited_.find(id);
    if (found == awaited_.end())
        return std::nullopt;
    const std::size_t call = found->second;
    awaited_.erase(found);
    return call;
}

} // namespace media
