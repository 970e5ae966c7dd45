#include "ipc/bounds.h"

#include "text/characters.h"

namespace ipc {

std::string shortened(std::string_view text, Length length) {
    constexpr std::string_view ellipsis = "\xe2\x80\xa6";
    if (text.size() <= length.most)
        return std::string(text);
    const std::size_t end = text::characterStart(text, length.most - ellipsis.size());
    return std::string(text.substr(0, end)) += ellipsis;
}

} // namespace ipc
