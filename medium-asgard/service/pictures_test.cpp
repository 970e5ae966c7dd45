// Pictures that take as long as the test lets them, and a host that does not wait.
#include "service/testing.h"

#include <gmock/gmock.h>

#include <fstream>

#include <poll.h>
#include <unistd.h>

namespace service {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

class SlowPicturesTest : public testing::Test {
protected:
    SlowPicturesTest() {
        Platform platform;
        platform.tools.read = [](const std::string&, const ParameterValues&) {
            script::ReadResult result;
            result.usable = true;
            result.scene = pushedBallScene(1);
            return result;
        };
        platform.tools.cancelReading = [] {};
        platform.tools.simulate = [](const auto& scene, const auto&, const auto&) {
            return simulation::simulate(*scene, {});
        };
        platform.draw = [this](const render::Drawing& drawing, const render::Image& image,
                               const Around&) { return draw(drawing, image); };
        session.emplace(std::move(platform), medium);
        ask(ipc::Initialize{});
        ask(ipc::SubdocumentLoad{"pushed", 1});
        until([&] { return !session->subdocument().computing(); });
    }
    ~SlowPicturesTest() override { letAll(); }

    bool draw(const render::Drawing& drawing, const render::Image& image) { // on its thread
        std::unique_lock lock(mutex_);
        begun_.push_back(drawing.time);
        changed_.notify_all();
        changed_.wait(lock, [&] { return let_ > 0 || letsAll_; });
        --let_;
        image.pixels.back() = std::byte{1}; // its memory is there
        return !isLost_;
    }
    void let(int pictures) {
        const std::lock_guard lock(mutex_);
        let_ += pictures;
        changed_.notify_all();
    }
    void letAll() {
        const std::lock_guard lock(mutex_);
        letsAll_ = true;
        changed_.notify_all();
    }
    std::vector<double> begun() {
        const std::lock_guard lock(mutex_);
        return begun_;
    }
    void lose() {
        const std::lock_guard lock(mutex_);
        isLost_ = true;
    }

    void exchange() {
        medium.feed(std::string(host.outgoing()));
        host.sent(host.outgoing().size());
        while (const auto call = medium.next())
            session->receive(*call, now);
        session->attend(now);
        host.feed(std::string(medium.outgoing()));
        medium.sent(medium.outgoing().size());
        while (auto call = host.next())
            if (const auto* heard = std::get_if<ipc::Told<ipc::ToHost>>(&*call))
                if (const auto* frame = std::get_if<ipc::RenditionFrame>(&heard->call))
                    frames.push_back(*frame);
        ASSERT_EQ(host.fault(), "");
        ASSERT_EQ(medium.fault(), "");
    }
    template <class F> void until(F condition) {
        const Instant end = Clock::now() + seconds(20);
        while (!condition()) {
            ASSERT_LT(Clock::now(), end) << "waited too long";
            pollfd news{session->descriptor(), POLLIN, 0};
            poll(&news, 1, 5);
            now += milliseconds(5);
            exchange();
        }
    }
    template <class R> void ask(R request) {
        service::request(host, std::move(request), answers);
        exchange();
    }
    void create(ipc::Integer id, int size = 20) {
        ipc::RenditionCreate create;
        create.rendition = id;
        create.width = create.height = size;
        ask(create);
        host.notify(ipc::RenditionShow{id});
        exchange();
    }
    ipc::RenditionResize resize(ipc::Integer id, int size) {
        ipc::RenditionResize resize;
        resize.rendition = id;
        resize.width = resize.height = size;
        return resize;
    }
    void seek(double time) {
        now += milliseconds(200);
        ask(ipc::TimeSeek{time});
    }

    ipc::HostChannel host;
    ipc::MediumChannel medium;
    Instant now = Clock::now();
    std::vector<ipc::RenditionFrame> frames;
    std::vector<std::string> answers;
    std::optional<Session> session;

private:
    std::mutex mutex_;
    std::condition_variable changed_;
    std::vector<double> begun_; // times of the pictures
    int let_ = 0;
    bool letsAll_ = false, isLost_ = false;
};

TEST_F(SlowPicturesTest, TheHostIsAnsweredWhileAPictureIsDrawn) {
    create(1);
    until([&] { return begun().size() == 1; });
    answers.clear();
    ask(ipc::Ping{});
    ask(ipc::TimePause{});
    EXPECT_THAT(answers, ElementsAre("ping", "time/pause"));
    EXPECT_THAT(frames, IsEmpty());
    let(1);
    until([&] { return frames.size() == 1; });
    EXPECT_EQ(frames[0].serial, 1);
}

TEST_F(SlowPicturesTest, TheNewestTimeIsDrawnNextAndThoseBetweenAreNot) {
    create(1);
    until([&] { return begun().size() == 1; });
    seek(1);
    seek(2);
    seek(3);
    EXPECT_THAT(begun(), SizeIs(1));
    let(2);
    until([&] { return frames.size() == 2; });
    EXPECT_THAT(begun(), ElementsAre(0, 3));
    EXPECT_THAT((std::vector{frames[0].time, frames[1].time}), ElementsAre(0, 3));
    EXPECT_NE(frames[0].slot, frames[1].slot);
}

// Of this process.
std::size_t bytesInUse() {
    std::size_t all = 0, resident = 0;
    std::ifstream("/proc/self/statm") >> all >> resident;
    return resident * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

// However often it becomes the newest while another is drawn.
TEST_F(SlowPicturesTest, APictureThatWaitsHasNoMemory) {
    constexpr int size = 2000;
    create(1);
    until([&] { return begun().size() == 1; });
    const std::size_t before = bytesInUse();
    create(2, size);
    for (int i = 1; i <= 20; ++i)
        seek(0.1 * i);
    EXPECT_LT(bytesInUse(), before + 4UL * size * size);
    let(1);
    until([&] { return begun().size() == 2; });
    EXPECT_THAT(begun(), ElementsAre(0, testing::DoubleNear(2, 1e-9)));
}

TEST_F(SlowPicturesTest, APictureThatWaitsForAnothersIsTheNewestToo) {
    create(1);
    until([&] { return begun().size() == 1; });
    create(2);
    seek(1);
    seek(2);
    let(1);
    until([&] { return begun().size() == 2; });
    EXPECT_THAT(begun(), ElementsAre(0, 2));
    let(1); // the other's, before the first is drawn again
    until([&] { return frames.size() == 2; });
    EXPECT_EQ(frames[1].rendition, 2);
    EXPECT_EQ(frames[1].serial, 1);
}

TEST_F(SlowPicturesTest, AResizeIsAnsweredWhenItsSlotsAreFreeAndTheOldSizeIsNotShown) {
    create(1);
    until([&] { return begun().size() == 1; });
    answers.clear();
    ask(resize(1, 30));
    ask(resize(1, 40));
    ask(ipc::Ping{});
    EXPECT_THAT(answers, ElementsAre("ping"));
    let(1);
    until([&] { return answers.size() == 3; });
    EXPECT_THAT(frames, IsEmpty());
    let(1);
    until([&] { return frames.size() == 1; });
    EXPECT_EQ(frames[0].width, 40);
    EXPECT_EQ(frames[0].serial, 1);
}

TEST_F(SlowPicturesTest, ADestroyedRenditionIsAnsweredWhenItsSlotsAreFree) {
    create(1);
    until([&] { return begun().size() == 1; });
    create(2); // waits
    answers.clear();
    ask(ipc::RenditionDestroy{2});
    EXPECT_THAT(answers, ElementsAre("rendition/destroy"));
    ask(ipc::RenditionDestroy{1});
    EXPECT_THAT(answers, SizeIs(1));
    create(1, 30); // of the same number
    let(1);
    until([&] { return answers.size() == 3; });
    until([&] { return begun().size() == 2; });
    EXPECT_THAT(frames, IsEmpty());
    let(1);
    until([&] { return frames.size() == 1; });
    EXPECT_EQ(frames[0].width, 30);
    EXPECT_FALSE(session->draws());
}

TEST_F(SlowPicturesTest, WhatIsHiddenMeanwhileIsNotShown) {
    create(1);
    until([&] { return begun().size() == 1; });
    host.notify(ipc::RenditionHide{1});
    exchange();
    let(1);
    until([&] { return !session->draws(); });
    EXPECT_THAT(frames, IsEmpty());
    now += milliseconds(200);
    host.notify(ipc::RenditionShow{1});
    let(1);
    until([&] { return frames.size() == 1; });
}

TEST_F(SlowPicturesTest, WhatIsHiddenWhileItWaitsIsNotDrawn) {
    create(1);
    until([&] { return begun().size() == 1; });
    create(2); // waits
    host.notify(ipc::RenditionHide{2});
    exchange();
    seek(1);
    let(1);
    until([&] { return frames.size() == 1; });
    EXPECT_EQ(frames[0].rendition, 1);
    let(1);
    until([&] { return frames.size() == 2; }); // the first's next
    EXPECT_THAT(begun(), ElementsAre(0, 1));
    now += milliseconds(200);
    host.notify(ipc::RenditionShow{2});
    let(1);
    until([&] { return frames.size() == 3; });
    EXPECT_EQ(frames[2].rendition, 2);
    EXPECT_FALSE(session->draws());
}

TEST_F(SlowPicturesTest, ALostContextIsSaidToThoseWhoAskNext) {
    create(1);
    until([&] { return begun().size() == 1; });
    lose();
    let(1);
    until([&] { return !session->draws(); });
    EXPECT_THAT(frames, IsEmpty());
    answers.clear();
    ipc::RenditionSnapshot snapshot;
    snapshot.width = snapshot.height = 10;
    ask(snapshot);
    EXPECT_THAT(answers, ElementsAre("rendition/snapshot: the graphics driver lost its state"));
}

TEST_F(SlowPicturesTest, SnapshotsAreTakenOneAfterTheOther) {
    ipc::RenditionSnapshot snapshot;
    snapshot.width = snapshot.height = 10;
    snapshot.time = 1;
    answers.clear();
    ask(snapshot);
    until([&] { return begun().size() == 1; });
    for (const double time : {2.0, 3.0}) {
        snapshot.time = time;
        ask(snapshot);
    }
    ask(ipc::Ping{});
    EXPECT_THAT(answers, ElementsAre("ping"));
    let(3);
    until([&] { return answers.size() == 4; });
    EXPECT_THAT(begun(), ElementsAre(1, 2, 3));
}

TEST_F(SlowPicturesTest, ASessionThatEndsWaitsForThePictureThatIsDrawn) {
    create(1);
    until([&] { return begun().size() == 1; });
    create(2);
    std::thread later([&] {
        std::this_thread::sleep_for(milliseconds(20));
        letAll();
    });
    session.reset();
    later.join();
    EXPECT_THAT(begun(), SizeIs(1));
}

} // namespace
} // namespace service
