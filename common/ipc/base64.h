// Pixels in a JSON string (RFC 4648, padded): for hosts and media that share no memory.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ipc {

[[nodiscard]] std::string toBase64(std::span<const std::byte> bytes);
// None for anything but whole padded groups of the alphabet.
[[nodiscard]] std::optional<std::vector<std::byte>> fromBase64(std::string_view text);

} // namespace ipc
