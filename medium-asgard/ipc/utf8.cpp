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

} // namespace ipc
