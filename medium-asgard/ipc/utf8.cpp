#include "ipc/wire.h"
#include "utf8/characters.h"

namespace ipc {

std::string asUtf8(std::string_view text) {
    std::string valid(text);
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t length = utf8::characterLength(text.substr(at));
        if (length == 0)
            valid[at] = '?';
        at += length == 0 ? 1 : length;
    }
    return valid;
}

std::string shortened(std::string_view text, Length length) {
    constexpr std::string_view ellipsis = "\xe2\x80\xa6";
    if (text.size() <= length.most)
        return std::string(text);
    const auto isInside = [&](std::size_t at) { // a character, behind its first byte
        return (static_cast<unsigned char>(text[at]) & 0xc0) == 0x80;
    };
    std::size_t end = length.most - ellipsis.size();
    while (end > 0 && isInside(end))
        --end;
    return std::string(text.substr(0, end)) += ellipsis;
}

} // namespace ipc
