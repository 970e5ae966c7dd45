// Where does one message end and the next begin?
//
// A message is `Content-Length: N\r\n\r\n` and N bytes (docs/medium-protocol.md, "Transport").
// Header lines of other names are read over. The decoder takes any split of the bytes, keeps no
// more than it was given, and stops for good at the first byte that cannot be the protocol.
#pragma once

#include <cstddef>
#include <deque>
#include <string>
#include <string_view>

namespace ipc {

inline constexpr std::size_t longestHeader = 1024;
inline constexpr std::size_t longestBody = std::size_t{64} << 20;

// Header and body, ready to be written.
[[nodiscard]] std::string framed(std::string_view body);

class FrameDecoder {
public:
    // Appends the bodies that these bytes complete. Does nothing after a fault.
    void feed(std::string_view bytes, std::deque<std::string>& bodies);

    // The sentence that says what was wrong with the bytes; empty while all is well.
    [[nodiscard]] const std::string& fault() const { return fault_; }
    // True between two messages: here an end of the stream loses nothing.
    [[nodiscard]] bool atBoundary() const { return !inBody_ && header_.empty(); }

private:
    // Both return how many of the bytes they took.
    std::size_t takeHeader(std::string_view bytes);
    std::size_t takeBody(std::string_view bytes, std::deque<std::string>& bodies);
    void readHeader();
    void fail(std::string sentence);

    std::string header_, body_, fault_;
    std::size_t expected_ = 0; // length of the body that is being read
    bool inBody_ = false;
};

} // namespace ipc
