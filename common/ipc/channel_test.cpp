#include "ipc/channel.h"

#include <gmock/gmock.h>

namespace ipc {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

// Moves what one end has to say to the other.
template <class From, class To> void carry(From& from, To& to) {
    const std::string bytes(from.outgoing());
    from.sent(bytes.size());
    to.feed(bytes);
}

std::vector<std::string> callsTaken(MediumChannel& medium) {
    std::vector<std::string> names;
    while (const auto call = medium.next()) {
        const auto name = [](const auto& received) {
            return std::visit([](const auto& c) { return std::string(c.method); }, received.call);
        };
        names.push_back(std::visit(name, *call));
    }
    return names;
}

TEST(Channel, CallsArriveInOrderAndAnswersReachTheirRequests) {
    HostChannel host;
    MediumChannel medium;
    std::vector<std::string> heard;
    host.request(PresentationList{}, [&](Outcome<Presentations> outcome) {
        heard.push_back(std::get<Presentations>(outcome).items.at(0).id);
    });
    host.notify(RenditionShow{3});
    host.request(TimeSeek{2},
                 [&](Outcome<Done> outcome) { heard.push_back(std::get<Error>(outcome).message); });
    carry(host, medium);

    const auto first = std::get<Asked<ToMedium>>(*medium.next());
    EXPECT_TRUE(std::holds_alternative<PresentationList>(first.call));
    const auto second = std::get<Told<ToMedium>>(*medium.next());
    EXPECT_EQ(std::get<RenditionShow>(second.call).rendition, 3);
    const auto third = std::get<Asked<ToMedium>>(*medium.next());
    EXPECT_FALSE(medium.next());

    medium.refuse(third.id, {ErrorCode::notPossible, "no motion yet"});
    medium.answer(first.id, Presentations{{{"picture", "Picture"}}});
    carry(medium, host);
    EXPECT_FALSE(host.next());
    EXPECT_THAT(heard, ElementsAre("no motion yet", "picture"));
    EXPECT_EQ(host.unanswered(), 0u);
}

TEST(Channel, UnknownAndFaultyRequestsAreAnsweredAndDoNotClose) {
    MediumChannel medium;
    medium.feed(framed(R"({"jsonrpc":"2.0","id":"x","method":"fly"})"));
    medium.feed(framed(R"({"jsonrpc":"2.0","id":2,"method":"time/seek","params":{}})"));
    medium.feed(framed(R"({"jsonrpc":"2.0","method":"fly"})"));
    EXPECT_FALSE(medium.next());
    EXPECT_EQ(medium.fault(), "");
    const std::string answers(medium.outgoing());
    EXPECT_THAT(answers, HasSubstr(R"("code":-32601)"));
    EXPECT_THAT(answers, HasSubstr(R"("id":"x")"));
    EXPECT_THAT(answers, HasSubstr(R"("code":-32602)"));
}

TEST(Channel, AThousandAndOneUnreadMessagesAreAFlood) {
    MediumChannel medium;
    const std::string ping = framed(encodeRequest(1, ToMedium(Ping{})));
    for (int i = 0; i < 1000; ++i)
        medium.feed(ping);
    EXPECT_EQ(medium.fault(), "");
    medium.feed(ping);
    EXPECT_THAT(medium.fault(), HasSubstr("flood"));
    EXPECT_FALSE(medium.next());
}

TEST(Channel, ReadingKeepsAnyNumberOfMessagesFromBeingAFlood) {
    MediumChannel medium;
    const std::string ping = framed(encodeRequest(1, ToMedium(Ping{})));
    std::size_t taken = 0;
    for (int i = 0; i < 5000; ++i) {
        medium.feed(ping);
        taken += callsTaken(medium).size();
    }
    EXPECT_EQ(taken, 5000u);
    EXPECT_EQ(medium.fault(), "");
}

TEST(Channel, OneLongMessageIsNoFloodSeveralAre) {
    const std::string text(5 << 20, 'x');
    const std::string load = framed(encodeRequest(1, ToMedium(SubdocumentLoad{text, 1})));
    MediumChannel one;
    one.feed(load);
    EXPECT_THAT(callsTaken(one), ElementsAre("subdocument/load"));
    one.feed(load);
    one.feed(load);
    EXPECT_THAT(one.fault(), HasSubstr("flood"));
}

TEST(Channel, WhoDoesNotReadIsNoticedAndTheQueueStaysBounded) {
    HostChannel host;
    int failed = 0;
    for (int i = 0; i < 3000; ++i)
        host.request(Ping{}, [&](Outcome<Done> outcome) {
            failed += std::get<Error>(outcome).code == static_cast<Integer>(ErrorCode::closed);
        });
    EXPECT_THAT(host.fault(), HasSubstr("does not read"));
    EXPECT_LT(host.outgoing().size(), 200'000u);
    host.close("ended");
    EXPECT_EQ(failed, 3000);
}

TEST(Channel, PartlyWrittenBytesGoOnWhereTheyStopped) {
    HostChannel host;
    MediumChannel medium;
    for (int i = 0; i < 50; ++i) {
        host.request(TimeSeek{i / 3.0}, [](Outcome<Done>) {});
        const std::string piece(host.outgoing().substr(0, 61));
        host.sent(piece.size());
        medium.feed(piece);
    }
    while (!host.outgoing().empty()) {
        const std::string piece(host.outgoing().substr(0, 61));
        host.sent(piece.size());
        medium.feed(piece);
    }
    EXPECT_EQ(callsTaken(medium).size(), 50u);
    EXPECT_EQ(medium.fault(), "");
}

TEST(Channel, ClosingAnswersWhatIsStillAwaited) {
    HostChannel host;
    std::string sentence;
    host.request(Ping{},
                 [&](Outcome<Done> outcome) { sentence = std::get<Error>(outcome).message; });
    host.feed("garbage\r\n\r\n");
    EXPECT_THAT(host.fault(), HasSubstr("not NAME: VALUE"));
    host.close("the medium sent what is not the protocol");
    EXPECT_EQ(sentence, "the medium sent what is not the protocol");
    // Later requests fail at once.
    host.request(Ping{},
                 [&](Outcome<Done> outcome) { sentence = std::get<Error>(outcome).message; });
    EXPECT_THAT(sentence, HasSubstr("not NAME: VALUE"));
}

TEST(Channel, AnAnswerOfTheWrongShapeOrToNothingIsAViolation) {
    HostChannel wrongShape;
    wrongShape.request(Initialize{}, [](Outcome<Initialized>) { FAIL() << "must not be called"; });
    wrongShape.feed(framed(R"({"jsonrpc":"2.0","id":1,"result":[]})"));
    EXPECT_FALSE(wrongShape.next());
    EXPECT_THAT(wrongShape.fault(), HasSubstr("the answer to initialize must be an object"));
    HostChannel toNothing;
    toNothing.feed(framed(R"({"jsonrpc":"2.0","id":1,"result":{}})"));
    EXPECT_FALSE(toNothing.next());
    EXPECT_THAT(toNothing.fault(), HasSubstr("not made"));
}

} // namespace
} // namespace ipc
