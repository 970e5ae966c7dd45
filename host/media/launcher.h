// How is a medium's process started so that it can do no harm by what it inherits?
// Its environment holds only what is named here, its descriptors are 0, 1, 2 and the frames, it is
// the leader of its own session (so that its own children can be ended with it), and the kernel
// kills it when the thread that launched it ends. So launch() must be called from a thread that
// lives as long as the process: PipeThread.
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
    pid_t process = -1;
    int processDescriptor = -1; // readable when the process has ended
    int toMedium = -1;
    int fromMedium = -1;
    int log = -1;
    std::string error; // a sentence when process is -1
};

inline constexpr int framesDescriptor = 3;

[[nodiscard]] Launched launch(const Launch& request);

// Ends a process and everything in its session, and waits for it: it is gone or unkillable, so
// this does not wait for anything that the process could do.
int endAndReap(pid_t process); // its wait status

// "was ended by signal 11 (Segmentation fault)", "ended with exit code 3"
[[nodiscard]] std::string describeEnd(int waitStatus);
[[nodiscard]] bool couldNotStart(int waitStatus); // there was no program

} // namespace media
