#include "script/wire.h"

#include <bit>
#include <cstring>

namespace script {

namespace {

constexpr std::uint64_t commandTag = 0x434d4421; // "CMD!"
constexpr std::uint64_t endTag = 0x454e4421;     // "END!"

} // namespace

void Encoder::number(std::uint64_t value) {
    char bytes[8];
    std::memcpy(bytes, &value, sizeof value);
    out_.append(bytes, sizeof bytes);
}

void Encoder::text(std::string_view text) {
    number(text.size());
    out_.append(text);
}

void Encoder::real(double value) { number(std::bit_cast<std::uint64_t>(value)); }

std::uint64_t Decoder::number() {
    std::uint64_t value = 0;
    if (rest_.size() < sizeof value) {
        good_ = false;
        rest_ = {};
        return 0;
    }
    std::memcpy(&value, rest_.data(), sizeof value);
    rest_.remove_prefix(sizeof value);
    return value;
}

std::string_view Decoder::text() {
    const std::uint64_t size = number();
    if (!good_ || size > rest_.size()) {
        good_ = false;
        rest_ = {};
        return {};
    }
    const std::string_view text = rest_.substr(0, size);
    rest_.remove_prefix(size);
    return text;
}

double Decoder::real() { return std::bit_cast<double>(number()); }

std::size_t Decoder::count(std::size_t bytesEach) {
    const std::uint64_t count = number();
    if (count > rest_.size() / bytesEach) {
        good_ = false;
        rest_ = {};
        return 0;
    }
    return count;
}

std::string encode(const Request& request) {
    std::string bytes;
    Encoder encoder(bytes);
    encoder.number(static_cast<std::uint64_t>(request.commands));
    encoder.number(request.parameters.size());
    for (const auto& [name, value] : request.parameters) {
        encoder.text(name);
        encoder.real(value);
    }
    encoder.text(request.text);
    return bytes;
}

std::optional<Request> decodeRequest(std::string_view bytes) {
    Decoder decoder(bytes);
    Request request;
    request.commands = static_cast<std::int64_t>(decoder.number());
    const std::size_t count = decoder.count(16);
    for (std::size_t i = 0; i < count && decoder.good(); ++i) {
        const std::string_view name = decoder.text();
        request.parameters[std::string(name)] = decoder.real();
    }
    request.text = decoder.text();
    if (!decoder.good() || !decoder.atEnd())
        return std::nullopt;
    return request;
}

void RecordingWriter::command(std::uint64_t offset, std::uint64_t caller,
                              const std::vector<std::string_view>& words) {
    Encoder encoder(bytes_);
    encoder.number(commandTag);
    encoder.number(offset);
    encoder.number(caller);
    encoder.number(words.size());
    for (const std::string_view word : words)
        encoder.text(word);
    ++commands_;
}

void RecordingWriter::end(const Recording& ending) {
    Encoder encoder(bytes_);
    encoder.number(endTag);
    encoder.number(static_cast<std::uint64_t>(ending.ending));
    encoder.text(ending.message);
    encoder.text(ending.executing);
    encoder.number(ending.offset);
    encoder.number(ending.candidates.size());
    for (const std::string_view name : ending.candidates)
        encoder.text(name);
}

namespace {

bool decodeCommand(Decoder& decoder, Recording& recording) {
    RecordedCommand command;
    command.offset = decoder.number();
    command.caller = decoder.number();
    const std::size_t words = decoder.count(8);
    command.words.reserve(words);
    for (std::size_t i = 0; i < words && decoder.good(); ++i)
        command.words.push_back(decoder.text());
    if (!decoder.good() || command.words.empty())
        return false;
    recording.commands.push_back(std::move(command));
    return recording.commands.size() <= mostRecordedCommands;
}

bool decodeEnd(Decoder& decoder, Recording& recording) {
    const std::uint64_t ending = decoder.number();
    recording.message = decoder.text();
    recording.executing = decoder.text();
    recording.offset = decoder.number();
    const std::size_t candidates = decoder.count(8);
    for (std::size_t i = 0; i < candidates && decoder.good(); ++i)
        recording.candidates.push_back(decoder.text());
    if (!decoder.good() || !decoder.atEnd() ||
        ending > static_cast<std::uint64_t>(Ending::commandLimit))
        return false;
    recording.ending = static_cast<Ending>(ending);
    return true;
}

} // namespace

std::optional<DecodedRecording> decodeRecording(std::string_view bytes) {
    Decoder decoder(bytes);
    DecodedRecording decoded;
    while (!decoder.atEnd()) {
        const std::uint64_t tag = decoder.number();
        if (!decoder.good())
            return decoded; // broken off
        if (tag == endTag) {
            if (!decodeEnd(decoder, decoded.recording))
                return std::nullopt;
            decoded.complete = true;
            return decoded;
        }
        if (tag != commandTag)
            return std::nullopt;
        if (!decodeCommand(decoder, decoded.recording)) {
            if (decoder.atEnd())
                return decoded; // broken off
            return std::nullopt;
        }
    }
    return decoded;
}

} // namespace script
