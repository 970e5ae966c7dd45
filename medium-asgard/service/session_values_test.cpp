// Values, parameters and charts that a session tells.
#include "service/session_testing.h"

namespace service {
namespace {

using namespace held;

TEST_F(SessionTest, ValuesAreReadWithASentenceForEachThatHasNone) {
    load("empty");
    computedTo(10);
    until([&] { return told->state == ipc::MotionState::current; });
    const ipc::Values read = values({"2*t", "c.x"}, 1.0);
    // This motion has no state to read.
    EXPECT_THAT(read.faults, ElementsAre("it has no value at this time", HasSubstr("\"c.x\"")));
    EXPECT_THAT(values({"2*t"}, 11.0).faults,
                ElementsAre("there is no motion at 11 s: it is known from 0 s to 10 s"));
    EXPECT_EQ(session->valueSource().built(), 1u);
    // Those of a faulty text are not told as its own.
    load("faulty", 2);
    until([&] { return told->state == ipc::MotionState::stale; });
    answers.clear();
    (void)values({"2*t"}, 1.0);
    EXPECT_THAT(answers, ElementsAre(HasSubstr("the text is faulty")));
}

TEST_F(SessionTest, ValuesOfASubscriptionAreToldAtOnceAndWhenTheyChange) {
    load("empty");
    computedTo(10);
    until([&] { return told->state == ipc::MotionState::current; });
    ask(ipc::ValueSubscribe{7, {"c.x"}});
    ASSERT_THAT(valueReports, testing::SizeIs(1));
    EXPECT_EQ(valueReports[0].id, 7);
    EXPECT_THAT(valueReports[0].faults, ElementsAre(HasSubstr("\"c.x\"")));
    ask(ipc::ValueSubscribe{8, {"d.x"}}); // told at once
    ASSERT_THAT(valueReports, testing::SizeIs(2));
    ask(ipc::TimeSeek{5}); // nothing of them is another one
    EXPECT_THAT(valueReports, testing::SizeIs(2));
}

// While a slider is dragged: x = p t^2 / 2 holds in each report.
TEST_F(SessionTest, AParameterIsToldWithTheMotionThatItMade) {
    load("pushed");
    computedTo(10);
    until([&] { return told->state == ipc::MotionState::current; });
    ask(ipc::TimeSeek{2});
    ask(ipc::ValueSubscribe{7, {"p", "b.x"}});
    for (const double p : {3.0, 4.0}) {
        world.allow(0);
        host.notify(ipc::ParameterSet{"p", p});
        exchange();
        ask(ipc::ValueUnsubscribe{7}); // what is asked now is of the motion before
        ask(ipc::ValueSubscribe{7, {"p", "b.x"}});
        EXPECT_LT(valueReports.back().values[0], p);
        computedTo(10);
        until([&] { return told->state == ipc::MotionState::current; });
        until([&] {
            now += milliseconds(100);
            return valueReports.back().values[0] == p;
        });
    }
    for (const ipc::ValueChanged& report : valueReports)
        EXPECT_NEAR(report.values[1], 2 * report.values[0], 1e-6);
    EXPECT_EQ(session->valueSource().built(), 3u); // once for each scene
}

TEST_F(SessionTest, AChartIsShownAndTakenWhenItsPlotsHaveBeenSampled) {
    load("a");
    computedTo(10);
    ipc::RenditionCreate create;
    create.rendition = 1;
    create.presentation = "chart";
    create.width = create.height = 20;
    ask(create);
    host.notify(ipc::RenditionShow{1});
    until([&] { return frames.size() == 1; });
    answers.clear();
    ipc::RenditionSnapshot snapshot;
    snapshot.presentation = "chart";
    snapshot.width = snapshot.height = 20;
    ask(snapshot);
    until([&] { return !answers.empty(); });
    EXPECT_THAT(answers, ElementsAre("rendition/snapshot"));
}

TEST_F(SessionTest, AParameterKeepsToItsBoundsAndDoesNotSpoilATextWithoutIt) {
    load("p");
    computedTo(10);
    until([&] { return told->state == ipc::MotionState::current; });
    host.notify(ipc::ParameterSet{"p", 5});
    host.notify(ipc::ParameterSet{"q", 5}); // there is none
    exchange();
    EXPECT_THAT(session->subdocument().parameters(), ElementsAre(std::pair("p", 2.0)));
    until([&] { return told->state == ipc::MotionState::current; });
    load("a", 2);
    until([&] { return diagnostics->revision == 2 && told->state == ipc::MotionState::current; });
    EXPECT_THAT(diagnostics->items, IsEmpty());
}

} // namespace
} // namespace service
