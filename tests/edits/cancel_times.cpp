// How long does a simulation go without asking whether it was cancelled, and how long does it take
// to end once it was? Processor time, at most, for each of the given scenes, whose motion is
// watched while it is computed; the second from cancelling at sixteen of its questions.
//
//     cancel_times SCENE.al...
#include "resimulation/resimulation.h"
#include "run/cpu_seconds.h"
#include "script/reader.h"

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <sstream>

namespace {

using simulation::cpuSeconds;

struct Course {
    std::size_t polls = 0;
    double longest = 0, afterLast = 0, all = 0;
};

// `stopAt`: the question that is answered by yes, and all after it; 0: none.
Course courseOf(const std::shared_ptr<const scene::Scene>& scene, std::size_t stopAt) {
    Course course;
    const double begin = cpuSeconds();
    double last = begin;
    bool isStopped = false;
    const auto asked = [&] {
        if (isStopped)
            return true;
        const double now = cpuSeconds();
        course.longest = std::max(course.longest, now - last);
        last = now;
        isStopped = ++course.polls == stopAt;
        return isStopped;
    };
    simulation::Resimulation kept;
    const auto watched = [](const simulation::MotionPointer&) {};
    (void)kept.update(scene, {}, {.cancelled = asked, .progress = watched});
    const double end = cpuSeconds();
    course.afterLast = end - last;
    course.all = end - begin;
    return course;
}

} // namespace

int main(int argc, char** argv) {
    script::Reader reader;
    for (int i = 1; i < argc; ++i) {
        std::stringstream text;
        text << std::ifstream(argv[i]).rdbuf();
        const auto scene = std::make_shared<const scene::Scene>(reader.read(text.str()).scene);
        const Course course = courseOf(scene, 0);
        double cancelling = 0;
        for (std::size_t k = 1; k <= 16; ++k) {
            const std::size_t stopAt = std::max<std::size_t>(1, k * course.polls / 16);
            cancelling = std::max(cancelling, courseOf(scene, stopAt).afterLast);
        }
        std::printf("%-32s %8.1f ms at most between two of %zu, %8.1f ms after the last; %8.1f ms "
                    "from yes to the end; %9.1f ms in all\n",
                    argv[i], 1e3 * course.longest, course.polls, 1e3 * course.afterLast,
                    1e3 * cancelling, 1e3 * course.all);
    }
}
