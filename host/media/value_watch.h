// The expressions whose values a medium tells as its time goes on, over all of its processes.
//
// Each set of expressions has a subscription of its own, so that a report of an older set, which
// was on its way, is not taken for one of the newer.
#pragma once

#include "ipc/messages.h"

#include <optional>
#include <string>
#include <vector>

namespace media {

class ValueWatch {
public:
    // LIMIT: so many are told while they change. Media tell up to 30 times a second, and so many
    // values are well within what a medium may say.
    static constexpr std::size_t most = 100;

    struct Commands { // for the process that lives, in this order
        std::optional<ipc::ValueUnsubscribe> end;
        std::optional<ipc::ValueSubscribe> begin;
    };
    // From now on; of more than `most` the first ones.
    [[nodiscard]] Commands watch(std::vector<std::string> expressions);
    [[nodiscard]] std::optional<ipc::ValueSubscribe> forNextProcess() const;

    enum class Heard { taken, old, faulty };
    [[nodiscard]] Heard told(const ipc::ValueChanged& report);

    [[nodiscard]] const std::vector<std::string>& expressions() const { return expressions_; }
    // As many as expressions; empty: nothing was told of this set yet.
    [[nodiscard]] const ipc::Values& values() const { return values_; }

private:
    ipc::Integer id_ = 0; // of the set
    std::vector<std::string> expressions_;
    ipc::Values values_;
};

} // namespace media
