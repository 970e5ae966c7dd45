#include "ipc/base64.h"
#include "ipc/framing.h"

#include <gmock/gmock.h>

#include <random>

namespace ipc {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

struct Decoding {
    std::deque<std::string> bodies;
    std::string fault;
};

Decoding decodedInPieces(std::string_view bytes, std::size_t pieceLength) {
    FrameDecoder decoder;
    Decoding result;
    for (std::size_t at = 0; at < bytes.size(); at += pieceLength)
        decoder.feed(bytes.substr(at, pieceLength), result.bodies);
    result.fault = decoder.fault();
    return result;
}

TEST(Framing, AnyCutOfTheBytesYieldsTheSameBodies) {
    const std::string stream = framed("{}") + framed(std::string(3000, 'x')) +
                               "Content-Type: x\r\ncontent-length:  5 \r\n\r\nhello" +
                               framed("\r\n\r\n");
    for (std::size_t cut = 0; cut <= stream.size(); ++cut) {
        FrameDecoder decoder;
        std::deque<std::string> bodies;
        decoder.feed(std::string_view(stream).substr(0, cut), bodies);
        decoder.feed(std::string_view(stream).substr(cut), bodies);
        ASSERT_THAT(decoder.fault(), IsEmpty()) << "cut at " << cut;
        ASSERT_THAT(bodies, ElementsAre("{}", std::string(3000, 'x'), "hello", "\r\n\r\n"));
        ASSERT_TRUE(decoder.atBoundary());
    }
    EXPECT_THAT(decodedInPieces(stream, 1).bodies, testing::SizeIs(4));
    EXPECT_THAT(decodedInPieces(stream, 7).bodies, testing::SizeIs(4));
}

TEST(Framing, WhatIsNotAHeaderGetsOneSentence) {
    const std::pair<std::string, std::string> cases[] = {
        {"\x01\x02\x03", "bytes where a header"},
        {"Hello world\r\n\r\n", "not NAME: VALUE"},
        {"Content-Type: a\r\n\r\n", "without Content-Length"},
        {"Content-Length: -1\r\n\r\n", "not a whole number"},
        {"Content-Length: 1e3\r\n\r\n", "not a whole number"},
        {"Content-Length: \r\n\r\n", "not a whole number"},
        {"Content-Length: 99999999999999999999999\r\n\r\n", "not a whole number"},
        {"Content-Length: 0\r\n\r\n", "empty"},
        {"Content-Length: 5\r\nContent-Length: 5\r\n\r\nhello", "two lengths"},
        {"Content-Length: 67108865\r\n\r\n", "more than 64 MiB"},
        {"Content-Length: 18446744073709551615\r\n\r\n", "more than 64 MiB"},
        {"Content-Length: 2" + std::string(1024, ' '), "more than 1 KiB"},
    };
    for (const auto& [bytes, sentence] : cases)
        for (const std::size_t length : {std::size_t{1}, bytes.size()}) {
            const Decoding result = decodedInPieces(bytes, length);
            EXPECT_THAT(result.fault, HasSubstr(sentence)) << bytes;
            EXPECT_THAT(result.bodies, IsEmpty());
        }
}

TEST(Framing, EverySizeUpToTwoToThe64IsTakenOrRefusedWithoutRoomForIt) {
    for (int bit = 0; bit < 64; ++bit) {
        const std::uint64_t size = std::uint64_t{1} << bit;
        FrameDecoder decoder;
        std::deque<std::string> bodies;
        decoder.feed("Content-Length: " + std::to_string(size) + "\r\n\r\n", bodies);
        EXPECT_EQ(decoder.fault().empty(), size <= longestBody) << size;
    }
}

TEST(Framing, NothingIsTakenAfterAFault) {
    FrameDecoder decoder;
    std::deque<std::string> bodies;
    decoder.feed("garbage\r\n\r\n", bodies);
    const std::string fault = decoder.fault();
    decoder.feed(framed("{}"), bodies);
    EXPECT_THAT(bodies, IsEmpty());
    EXPECT_EQ(decoder.fault(), fault);
}

TEST(Framing, FlippedBitsNeverYieldMoreBytesThanCame) {
    const std::string stream = framed(std::string(100, 'a')) + framed("{\"b\":1}");
    std::mt19937 random(7);
    for (int round = 0; round < 5000; ++round) {
        std::string damaged = stream;
        for (int flips = 1 + static_cast<int>(random() % 4); flips > 0; --flips)
            damaged[random() % damaged.size()] ^= static_cast<char>(1u << random() % 8);
        const Decoding result = decodedInPieces(damaged, 1 + random() % 40);
        std::size_t total = 0;
        for (const std::string& body : result.bodies)
            total += body.size();
        ASSERT_LE(total, damaged.size());
    }
}

TEST(Base64, RoundTripsEveryLengthAndRefusesTheRest) {
    std::mt19937 random(1);
    for (std::size_t length = 0; length < 50; ++length) {
        std::vector<std::byte> bytes(length);
        for (std::byte& b : bytes)
            b = static_cast<std::byte>(random());
        EXPECT_EQ(fromBase64(toBase64(bytes)), bytes);
    }
    const std::byte man[] = {std::byte{'M'}, std::byte{'a'}};
    EXPECT_EQ(toBase64(man), "TWE=");
    for (const char* wrong : {"A", "AA", "AAA", "A===", "AA=A", "AA*A",
                              "\xff"
                              "AAA"})
        EXPECT_FALSE(fromBase64(wrong)) << wrong;
}

} // namespace
} // namespace ipc
