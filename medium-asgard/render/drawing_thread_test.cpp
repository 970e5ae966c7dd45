// The order of what a thread draws, while the test holds its first picture.
#include "render/drawing_thread.h"

#include <gmock/gmock.h>

#include <future>
#include <string>

namespace render {
namespace {

using testing::ElementsAre;

class DrawingThreadTest : public testing::Test {
protected:
    // The thread is busy until letGo().
    void hold() {
        std::promise<void> begun;
        thread_.before([&, begun = &begun, go = go_.get_future().share()] {
            begun->set_value();
            go.wait();
        });
        begun.get_future().wait();
    }
    void letGo() {
        go_.set_value();
        thread_.run([] {});
    }
    void draw(const int& customer, const std::string& what) {
        thread_.draw(&customer, [this, what] { done_.push_back(what); });
    }

    std::promise<void> go_;
    std::vector<std::string> done_; // the thread's, until it is waited for
    DrawingThread thread_;
    int one_ = 1, other_ = 2;
};

TEST_F(DrawingThreadTest, TheNewestOfEachIsDrawnAndTheLongestWaitingFirst) {
    hold();
    draw(one_, "one, first");
    draw(other_, "other");
    draw(one_, "one, second");
    letGo();
    std::promise<void> spare;
    thread_.inSpareTime([&] { spare.set_value(); }); // behind all pictures
    spare.get_future().wait();
    EXPECT_THAT(done_, ElementsAre("one, second", "other"));
}

TEST_F(DrawingThreadTest, WhatIsTakenBackIsNotDrawn) {
    hold();
    EXPECT_FALSE(thread_.takeBack(&one_));
    draw(one_, "one");
    draw(other_, "other");
    EXPECT_TRUE(thread_.takeBack(&one_));
    EXPECT_FALSE(thread_.takeBack(&one_));
    letGo();
    std::promise<void> spare;
    thread_.inSpareTime([&] { spare.set_value(); });
    spare.get_future().wait();
    EXPECT_THAT(done_, ElementsAre("other"));
}

TEST_F(DrawingThreadTest, WhatIsHeldByAPictureIsLetGoOnTheThread) {
    std::thread::id let;
    const auto held = [&] {
        return std::shared_ptr<void>(nullptr, [&](void*) { let = std::this_thread::get_id(); });
    };
    std::thread::id its;
    thread_.run([&] { its = std::this_thread::get_id(); });
    hold();
    thread_.draw(&one_, [kept = held()] {});
    thread_.draw(&one_, [] {}); // replaced
    letGo();
    thread_.run([] {}); // behind what was let go
    EXPECT_EQ(let, its);
}

// Of work that was replaced in spare time, and of what waits when the thread ends.
TEST(DrawingThread, WhatIsNeverDoneIsLetGoOnTheThread) {
    std::vector<std::thread::id> let;
    const auto held = [&] {
        return std::shared_ptr<void>(nullptr,
                                     [&](void*) { let.push_back(std::this_thread::get_id()); });
    };
    std::thread::id its;
    {
        std::promise<void> begun;
        DrawingThread thread;
        thread.run([&] { its = std::this_thread::get_id(); });
        thread.draw(&its, [&] {
            begun.set_value();
            std::this_thread::sleep_for(std::chrono::milliseconds(50));
        });
        begun.get_future().wait();
        thread.inSpareTime([kept = held()] {});
        thread.inSpareTime([kept = held()] {});
        thread.draw(&let, [kept = held()] {});
        thread.before([kept = held()] {});
    }
    EXPECT_THAT(let, ElementsAre(its, its, its, its));
}

TEST(DrawingThread, ItsEndIsOnTheThreadAndDrawsNothingMore) {
    std::thread::id its, last;
    bool drawn = false;
    {
        std::promise<void> begun, go;
        DrawingThread thread([&] { last = std::this_thread::get_id(); });
        thread.run([&] { its = std::this_thread::get_id(); });
        thread.draw(&its, [&] {
            begun.set_value();
            std::this_thread::sleep_for(std::chrono::milliseconds(50));
        });
        begun.get_future().wait();
        thread.draw(&its, [&] { drawn = true; });
    }
    EXPECT_EQ(last, its);
    EXPECT_FALSE(drawn);
}

} // namespace
} // namespace render
