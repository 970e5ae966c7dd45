#include "ipc/framing.h"

#include <algorithm>
#include <charconv>
#include <optional>

namespace ipc {
namespace {

constexpr std::string_view endOfHeader = "\r\n\r\n";

char lowered(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

bool isContentLength(std::string_view name) {
    constexpr std::string_view expected = "content-length";
    return std::ranges::equal(name, expected, {}, lowered);
}

bool isToken(std::string_view name) {
    return !name.empty() && std::ranges::all_of(name, [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
               c == '-' || c == '_';
    });
}

std::string_view withoutBlanks(std::string_view text) {
    while (!text.empty() && text.front() == ' ')
        text.remove_prefix(1);
    while (!text.empty() && text.back() == ' ')
        text.remove_suffix(1);
    return text;
}

std::optional<std::size_t> wholeNumber(std::string_view text) {
    std::size_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size() || text.empty())
        return std::nullopt;
    return value;
}

} // namespace

std::string framed(std::string_view body) {
    std::string message = "Content-Length: " + std::to_string(body.size());
    message += endOfHeader;
    message += body;
    return message;
}

void FrameDecoder::feed(std::string_view bytes, std::deque<std::string>& bodies) {
    while (!bytes.empty() && fault_.empty())
        bytes.remove_prefix(inBody_ ? takeBody(bytes, bodies) : takeHeader(bytes));
}

std::size_t FrameDecoder::takeHeader(std::string_view bytes) {
    const std::size_t before = header_.size();
    const std::size_t room = longestHeader - before;
    header_.append(bytes.substr(0, room));
    // The end may have begun in the bytes before.
    const std::size_t from = before < endOfHeader.size() ? 0 : before - endOfHeader.size();
    const std::size_t end = header_.find(endOfHeader, from);
    if (end == std::string::npos) {
        if (header_.size() == longestHeader)
            fail("a header of more than 1 KiB");
        else if (before == 0 && !isToken(std::string_view(header_).substr(0, 1)))
            fail("bytes where a header Content-Length: was expected");
        return std::min(bytes.size(), room);
    }
    header_.resize(end);
    readHeader();
    header_.clear();
    return end + endOfHeader.size() - before;
}

void FrameDecoder::readHeader() {
    std::optional<std::size_t> length;
    for (std::string_view rest = header_; !rest.empty();) {
        const std::size_t end = std::min(rest.find("\r\n"), rest.size());
        const std::string_view line = rest.substr(0, end);
        rest.remove_prefix(std::min(end + 2, rest.size()));
        const std::size_t colon = line.find(':');
        if (colon == std::string_view::npos || !isToken(line.substr(0, colon)))
            return fail("a header line that is not NAME: VALUE");
        if (!isContentLength(line.substr(0, colon)))
            continue;
        if (length)
            return fail("a header with two lengths");
        length = wholeNumber(withoutBlanks(line.substr(colon + 1)));
        if (!length)
            return fail("a Content-Length that is not a whole number");
    }
    if (!length)
        return fail("a header without Content-Length");
    if (*length > longestBody)
        return fail("a message of " + std::to_string(*length) + " bytes, more than 64 MiB");
    expected_ = *length;
    if (expected_ == 0)
        return fail("an empty message");
    inBody_ = true;
}

std::size_t FrameDecoder::takeBody(std::string_view bytes, std::deque<std::string>& bodies) {
    const std::size_t taken = std::min(bytes.size(), expected_ - body_.size());
    body_.append(bytes.substr(0, taken));
    if (body_.size() == expected_) {
        bodies.push_back(std::move(body_));
        body_ = {};
        inBody_ = false;
    }
    return taken;
}

void FrameDecoder::fail(std::string sentence) {
    fault_ = std::move(sentence);
    header_ = {};
    body_ = {};
}

} // namespace ipc
