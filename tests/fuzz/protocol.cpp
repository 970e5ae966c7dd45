// Any bytes come through the pipe between a host and a medium; what is understood of them is said
// again and understood as the same.
#include "input.h"
#include "require.h"

#include "ipc/channel.h"

namespace {

constexpr ipc::Integer mostAwaited = 3;

// All of it at both ends of a pipe, in pieces of any size.
template <class Channel, class Request> void receive(fuzz::Input sizes, std::string_view bytes) {
    Channel channel;
    int answers = 0;
    for (ipc::Integer i = 0; i < mostAwaited; ++i)
        channel.request(Request{}, [&](const auto&) { ++answers; });
    const std::size_t step = 1 + sizes.below(64);
    for (std::size_t at = 0; at < bytes.size(); at += step) {
        channel.feed(bytes.substr(at, step));
        while (channel.next()) {
        }
    }
    const std::size_t unanswered = channel.unanswered();
    FUZZ_REQUIRE(answers + static_cast<int>(unanswered) >= mostAwaited);
    channel.close("over");
    FUZZ_REQUIRE(channel.unanswered() == 0);
}

template <class Call, class Decode>
void sayAgain(const ipc::Decoded<Call>& decoded, const Decode& decode) {
    if (const auto* asked = std::get_if<ipc::Asked<Call>>(&decoded)) {
        const std::string said = ipc::encodeRequest(7, asked->call);
        const auto again = decode(said);
        FUZZ_REQUIRE(std::holds_alternative<ipc::Asked<Call>>(again));
        FUZZ_REQUIRE(ipc::encodeRequest(7, std::get<ipc::Asked<Call>>(again).call) == said);
    } else if (const auto* told = std::get_if<ipc::Told<Call>>(&decoded)) {
        const std::string said = ipc::encodeNotification(told->call);
        const auto again = decode(said);
        FUZZ_REQUIRE(std::holds_alternative<ipc::Told<Call>>(again));
        FUZZ_REQUIRE(ipc::encodeNotification(std::get<ipc::Told<Call>>(again).call) == said);
    } else if (const auto* violation = std::get_if<ipc::Violation>(&decoded)) {
        FUZZ_REQUIRE(!violation->sentence.empty());
    }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    // Most inputs are a body without a header.
    const std::string framed =
        bytes.starts_with("Content") ? std::string(bytes) : ipc::framed(bytes);
    if (size % 2 == 0)
        receive<ipc::HostChannel, ipc::ValueRead>({data, size}, framed);
    else
        receive<ipc::MediumChannel, ipc::EditUndo>({data, size}, framed);
    constexpr ipc::Integer calls =
        std::min(std::variant_size_v<ipc::ToMedium>, std::variant_size_v<ipc::ToHost>);
    const ipc::AwaitedCall awaited = [](ipc::Integer id) {
        return id >= 0 && id < calls ? std::optional(static_cast<std::size_t>(id)) : std::nullopt;
    };
    const auto byMedium = [&](std::string_view b) { return ipc::decodeForMedium(b, awaited); };
    const auto byHost = [&](std::string_view b) { return ipc::decodeForHost(b, awaited); };
    sayAgain<ipc::ToMedium>(byMedium(bytes), byMedium);
    sayAgain<ipc::ToHost>(byHost(bytes), byHost);
    return 0;
}
