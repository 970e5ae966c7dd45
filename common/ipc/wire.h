// Messages to JSON-RPC 2.0 bodies and back.
//
// Reading checks every field: a field that is missing, of the wrong type or out of range is named
// in a sentence, and nothing half read is returned. Unknown fields are read over. A body is refused
// before it is parsed when it nests or branches beyond any message of the protocol.
//
// Strings that are not UTF-8 are sent with '?' for each wrong byte, so that offsets stay right.
#pragma once

#include "ipc/bounds.h"
#include "ipc/messages.h"

#include <functional>
#include <string>
#include <string_view>

namespace ipc {

using Id = std::variant<Integer, std::string>; // ours are numbers, a stranger's may be strings

template <class Call> struct Asked { // a request
    Id id;
    Call call;
};
template <class Call> struct Told { // a notification
    Call call;
};
struct Answered {
    Integer id = 0;
    std::variant<AnyResult, Error> outcome;
};
// A request that cannot be served: the answer that it gets. Not a reason to close.
struct Unanswerable {
    Id id;
    Error error;
};
struct Ignored {}; // a notification of an unknown name
// Not the protocol: the sentence says why. A reason to close.
struct Violation {
    std::string sentence;
};

template <class Call>
using Decoded = std::variant<Asked<Call>, Told<Call>, Answered, Unanswerable, Ignored, Violation>;

// Which request an identifier of ours belongs to: its place in the variant of calls that we send.
using AwaitedCall = std::function<std::optional<std::size_t>(Integer id)>;

[[nodiscard]] std::string encodeRequest(Integer id, const ToMedium& call);
[[nodiscard]] std::string encodeRequest(Integer id, const ToHost& call);
[[nodiscard]] std::string encodeNotification(const ToMedium& call);
[[nodiscard]] std::string encodeNotification(const ToHost& call);
[[nodiscard]] std::string encodeAnswer(const Id& id, const AnyResult& result);
[[nodiscard]] std::string encodeError(const Id& id, const Error& error);

// Messages that a medium reads: calls of the host, and answers to its own.
[[nodiscard]] Decoded<ToMedium> decodeForMedium(std::string_view body, const AwaitedCall& awaited);
// Messages that a host reads.
[[nodiscard]] Decoded<ToHost> decodeForHost(std::string_view body, const AwaitedCall& awaited);

} // namespace ipc
