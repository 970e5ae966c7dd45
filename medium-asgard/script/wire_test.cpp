// Recordings come from a process that ran a stranger's script.
#include "script/wire.h"

#include <random>

#include <gtest/gtest.h>

namespace script {
namespace {

std::string someRecording() {
    RecordingWriter writer;
    writer.command(12, 12, {"body", "b1", "rod", "-init_pos", "1 2 3"});
    writer.command(noOffset, 40, {"force", "-body", "b1", "-x", ""});
    Recording ending;
    ending.ending = Ending::error;
    ending.message = "can't read \"x\"";
    ending.executing = "set y $x";
    ending.offset = 40;
    ending.candidates = {"y", "z"};
    writer.end(ending);
    return writer.bytes();
}

TEST(Wire, ReadsWhatItWrote) {
    const std::string bytes = someRecording();
    const auto decoded = decodeRecording(bytes);
    ASSERT_TRUE(decoded && decoded->complete);
    const Recording& recording = decoded->recording;
    ASSERT_EQ(recording.commands.size(), 2u);
    EXPECT_EQ(recording.commands[0].offset, 12u);
    EXPECT_EQ(recording.commands[0].words[4], "1 2 3");
    EXPECT_EQ(recording.commands[1].offset, noOffset);
    EXPECT_EQ(recording.ending, Ending::error);
    EXPECT_EQ(recording.candidates.size(), 2u);

    Request request;
    request.commands = 7;
    request.parameters = {{"g", 9.81}};
    request.text = "body";
    const auto back = decodeRequest(encode(request));
    ASSERT_TRUE(back);
    EXPECT_EQ(back->parameters.at("g"), 9.81);
    EXPECT_EQ(back->text, "body");
}

TEST(Wire, KeepsWhatIsWholeOfARecordingThatBreaksOff) {
    const std::string bytes = someRecording();
    for (std::size_t length = 0; length < bytes.size(); ++length) {
        const auto decoded = decodeRecording(std::string_view(bytes).substr(0, length));
        ASSERT_FALSE(decoded && decoded->complete) << length;
        if (decoded) {
            EXPECT_LE(decoded->recording.commands.size(), 2u);
        }
    }
}

TEST(Wire, NeverBelievesALength) {
    std::string bytes = someRecording();
    for (std::size_t at = 0; at + 8 <= bytes.size(); at += 8)
        for (const std::uint64_t length : {~std::uint64_t{0}, std::uint64_t{1} << 63,
                                           std::uint64_t{1} << 32, std::uint64_t{1}}) {
            std::string broken = bytes;
            broken.replace(at, 8, reinterpret_cast<const char*>(&length), 8);
            const auto decoded = decodeRecording(broken);
            if (decoded) {
                EXPECT_LE(decoded->recording.commands.size(), 3u);
            }
        }
}

TEST(Wire, SurvivesRandomBytes) {
    std::mt19937 random(11);
    const std::string good = someRecording();
    int complete = 0;
    for (int i = 0; i < 100'000; ++i) {
        std::string bytes = good;
        const int changes = 1 + static_cast<int>(random() % 4);
        for (int k = 0; k < changes; ++k)
            bytes[random() % bytes.size()] = static_cast<char>(random() % 256);
        if (random() % 4 == 0)
            bytes.resize(random() % bytes.size());
        const auto decoded = decodeRecording(bytes);
        if (!decoded)
            continue;
        complete += decoded->complete ? 1 : 0;
        std::size_t read = 0; // every view lies inside
        for (const RecordedCommand& command : decoded->recording.commands)
            for (const std::string_view word : command.words) {
                ASSERT_GE(word.data(), bytes.data());
                ASSERT_LE(word.data() + word.size(), bytes.data() + bytes.size());
                read += word.size();
            }
        ASSERT_LE(read, bytes.size());
    }
    EXPECT_GT(complete, 0); // changes inside words leave a recording
}

} // namespace
} // namespace script
