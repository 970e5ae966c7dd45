// Both ends of a pipe in one test.
#pragma once

#include "service/session.h"

#include <functional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace service {

// The messages of either end reach the other; notifications are taken, requests are kept.
inline void exchangeOnce(ipc::HostChannel& host, ipc::MediumChannel& medium, Session& session,
                         Instant now, std::vector<ipc::Asked<ipc::ToHost>>& asked,
                         const std::function<void(ipc::ToHost)>& take) {
    medium.feed(std::string(host.outgoing()));
    host.sent(host.outgoing().size());
    while (const auto call = medium.next())
        session.receive(*call, now);
    session.attend(now);
    host.feed(std::string(medium.outgoing()));
    medium.sent(medium.outgoing().size());
    while (auto call = host.next())
        if (auto* heard = std::get_if<ipc::Told<ipc::ToHost>>(&*call))
            take(std::move(heard->call));
        else
            asked.push_back(std::get<ipc::Asked<ipc::ToHost>>(*call));
}

} // namespace service
