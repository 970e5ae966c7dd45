#include "processes/calls.h"

#include <utility>

namespace media {

ipc::Integer Calls::await(Done done) {
    waiting_[++last_] = std::move(done);
    return last_;
}

void Calls::take(ipc::Answered answered) {
    const auto found = waiting_.find(answered.id);
    if (found == waiting_.end())
        return;
    const Done done = std::move(found->second);
    waiting_.erase(found);
    done(std::move(answered.outcome));
}

void Calls::refuse(const ipc::Error& error) {
    for (const auto& [id, done] : std::exchange(waiting_, {}))
        done(error);
}

} // namespace media
