// How is a medium's process started so that it can do no harm by what it inherits?
// Its environment holds only what is named here, and its descriptors are 0, 1, 2 and the frames. It
// is the child of a keeper (medium_keeper.cpp), which ends it and all that it started: when it
// ends, when the host asks for it, and when the thread that launched it ends. So launch() must be
// called from a thread that lives as long as the process: PipeThread.
#pragma once

#include <string>
#include <sys/types.h>
#include <vector>

namespace media {

struct Launch {
    std::string program; // a path
    std::vector<std::string> arguments;
    std::vector<std::string> environment; // NAME=value
    int frames = -1;                      // becomes descriptor 3
};

struct Launched {
    pid_t process = -1;         // its keeper, which ends as the medium does
    int processDescriptor = -1; // readable when all of it has ended
    int toMedium = -1;
    int fromMedium = -1;
    int log = -1;
    std::string error; // a sentence when process is -1
};

inline constexpr int framesDescriptor = 3;

// The keeper is beside this program; without it nothing is launched.
[[nodiscard]] Launched launch(const Launch& request);

// Ends a medium and everything that it started, soon: processDescriptor tells when.
void askToEnd(const Launched& medium);
// For a keeper that takes too long, since a medium makes processes without end. The kernel ends the
// medium with it, but not what left its session.
void endWithKeeper(const Launched& medium);
// Waits for an end that is there or was asked for.
[[nodiscard]] int reap(const Launched& medium); // the medium's wait status

// "was ended by signal 11 (Segmentation fault)", "ended with exit code 3"
[[nodiscard]] std::string describeEnd(int waitStatus);
[[nodiscard]] bool couldNotStart(int waitStatus); // there was no program

} // namespace media
