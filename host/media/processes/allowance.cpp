#include "processes/allowance.h"

#include <algorithm>

namespace media {

namespace {

std::size_t entriesOf(const ipc::ToHost& call) {
    return std::visit(
        [](const auto& message) -> std::size_t {
            if constexpr (requires { message.menus; })
                return message.menus.size();
            else if constexpr (requires { message.items; })
                return message.items.size();
            else if constexpr (requires { message.edits; })
                return message.edits.size();
            else if constexpr (requires { message.values; })
                return message.values.size();
            else
                return 0;
        },
        call);
}

} // namespace

bool Allowance::spend(const ipc::Decoded<ipc::ToHost>& message, std::size_t bytes,
                      Clock::time_point now) {
    const double seconds = std::chrono::duration<double>(now - last_).count();
    last_ = now;
    left_.bytes = std::min(atOnce.bytes, left_.bytes + perSecond.bytes * seconds);
    left_.items = std::min(atOnce.items, left_.items + perSecond.items * seconds);
    if (std::holds_alternative<ipc::Answered>(message))
        return true;
    std::size_t items = 1;
    bool isFrame = false;
    if (const auto* told = std::get_if<ipc::Told<ipc::ToHost>>(&message)) {
        items += entriesOf(told->call);
        isFrame = std::holds_alternative<ipc::RenditionFrame>(told->call);
    } else if (const auto* asked = std::get_if<ipc::Asked<ipc::ToHost>>(&message)) {
        items += entriesOf(asked->call);
    }
    left_.items -= static_cast<double>(items);
    left_.bytes -= isFrame ? 0 : static_cast<double>(bytes);
    return left_.items >= 0 && left_.bytes >= 0;
}

} // namespace media
