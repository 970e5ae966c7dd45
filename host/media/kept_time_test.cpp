#include "media/kept_time.h"

#include <gtest/gtest.h>

namespace media {
namespace {

ipc::TimeChanged at(double time, bool playing = false) {
    ipc::TimeChanged told;
    told.start = 1;
    told.finish = 5;
    told.time = time;
    told.playing = playing;
    return told;
}

bool isNothing(const KeptTime::Commands& commands) {
    return !commands.rate && !commands.seek && !commands.play;
}

TEST(KeptTime, APosterStandsUntilItIsPlayedAndPlayingBeginsAtTheStart) {
    KeptTime time;
    time.setPoster(3);
    EXPECT_EQ(time.forNextProcess().seek->time, 3);
    EXPECT_FALSE(time.forNextProcess().play);
    EXPECT_TRUE(isNothing(time.told(at(1)))); // it has not been there yet
    EXPECT_TRUE(isNothing(time.told(at(3))));
    const KeptTime::Commands begun = time.told(at(3, true));
    EXPECT_EQ(begun.seek->time, 1);
    EXPECT_TRUE(begun.play);
    EXPECT_TRUE(isNothing(time.told(at(1, true)))); // once
}

TEST(KeptTime, ATimeThatWasLookedForIsPlayedOnFromThere) {
    KeptTime byCommand, byKey;
    for (KeptTime* time : {&byCommand, &byKey}) {
        time->setPoster(3);
        EXPECT_TRUE(isNothing(time->told(at(3))));
    }
    byCommand.chosenByHand();
    EXPECT_TRUE(isNothing(byKey.told(at(2)))); // in the medium
    for (KeptTime* time : {&byCommand, &byKey})
        EXPECT_TRUE(isNothing(time->told(at(2, true))));
}

TEST(KeptTime, APosterBeyondTheEndIsTheEnd) {
    KeptTime time;
    time.setPoster(99);
    EXPECT_TRUE(isNothing(time.told(at(5))));
    EXPECT_EQ(time.told(at(5, true)).seek->time, 1);
}

TEST(KeptTime, TheNextProcessGoesOnWhereTheLastOneStood) {
    KeptTime time;
    EXPECT_TRUE(isNothing(time.forNextProcess()));
    ipc::TimeChanged told = at(4, true);
    told.rate = 2;
    told.loop = true;
    EXPECT_TRUE(isNothing(time.told(told)));
    const KeptTime::Commands next = time.forNextProcess();
    EXPECT_EQ(next.rate->rate, 2);
    EXPECT_TRUE(next.rate->loop);
    EXPECT_EQ(next.seek->time, 4);
    EXPECT_TRUE(next.play);
}

} // namespace
} // namespace media
