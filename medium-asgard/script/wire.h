// The messages in the pipes between reader, evaluator server and evaluator.
//
//     reader -> server -> evaluator:  request    {limit of commands, parameters, text}
//     evaluator -> server -> reader:  recording  {scene commands that ran, how the script ended}
//
// A recording comes from a process that ran a stranger's script: nothing in it is believed.
// Decoding checks every length against the bytes that are there before it allocates, and keeps
// views.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace script {

constexpr std::uint64_t noOffset = ~std::uint64_t{0};
constexpr std::size_t mostRecordedBytes = std::size_t{32} << 20;
constexpr std::size_t mostRecordedCommands = 100'000;

struct Request {
    std::int64_t commands = 0;
    std::map<std::string, double> parameters;
    std::string text;
};

// One run of one scene command, its words substituted.
struct RecordedCommand {
    std::uint64_t offset = noOffset; // where the command stands in the text, if it does
    std::uint64_t caller = noOffset; // of the command of the text that was running
    std::vector<std::string_view> words;
};

enum class Ending : std::uint8_t { complete, error, timeLimit, commandLimit };

struct Recording {
    std::vector<RecordedCommand> commands;
    Ending ending = Ending::complete;
    std::string_view message;                 // of a Tcl error
    std::string_view executing;               // the beginning of the command that failed
    std::uint64_t offset = noOffset;          // of the command that was started last
    std::vector<std::string_view> candidates; // names that exist, for suggestions
};

[[nodiscard]] std::string encode(const Request& request);
[[nodiscard]] std::optional<Request> decodeRequest(std::string_view bytes);

// Appends to a buffer of bytes.
class Encoder {
public:
    explicit Encoder(std::string& out) : out_(out) {}
    void number(std::uint64_t value);
    void text(std::string_view text);
    void real(double value);

private:
    std::string& out_;
};

// Reads what Encoder wrote. Past the end, or after a length that the rest cannot hold, everything
// is zero and empty, and `good()` is false.
class Decoder {
public:
    explicit Decoder(std::string_view bytes) : rest_(bytes) {}
    std::uint64_t number();
    std::string_view text();
    double real();
    // A count of things that take at least `bytesEach`.
    std::size_t count(std::size_t bytesEach);
    [[nodiscard]] bool good() const { return good_; }
    [[nodiscard]] bool atEnd() const { return rest_.empty(); }

private:
    std::string_view rest_;
    bool good_ = true;
};

// A recording as the evaluator writes it: commands one by one, then the ending.
class RecordingWriter {
public:
    void command(std::uint64_t offset, std::uint64_t caller,
                 const std::vector<std::string_view>& words);
    void end(const Recording& ending); // its commands are not read
    [[nodiscard]] const std::string& bytes() const { return bytes_; }
    [[nodiscard]] std::size_t commands() const { return commands_; }

private:
    std::string bytes_;
    std::size_t commands_ = 0;
};

// Views into `bytes`. What is not a recording yields nothing; one that breaks off has what is whole
// and `complete` false.
struct DecodedRecording {
    Recording recording;
    bool complete = false;
};
[[nodiscard]] std::optional<DecodedRecording> decodeRecording(std::string_view bytes);

} // namespace script
