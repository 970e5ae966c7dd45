// The requests to a process that wait for their answers.
#pragma once

#include "ipc/wire.h"

#include <functional>
#include <map>
#include <variant>

namespace media {

class Calls {
public:
    using Outcome = std::variant<ipc::AnyResult, ipc::Error>;
    using Done = std::function<void(Outcome)>;

    // The number of the request, which its answer has, too.
    [[nodiscard]] ipc::Integer await(Done done);
    // An answer that nobody waits for is left alone.
    void take(ipc::Answered answered);
    // All of them: they may ask again meanwhile.
    void refuse(const ipc::Error& error);

private:
    ipc::Integer last_ = 0;
    std::map<ipc::Integer, Done> waiting_;
};

} // namespace media
