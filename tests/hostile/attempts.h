// Raw system calls that a compromised process would try. None destroys anything where it succeeds.
#pragma once

#include <string>
#include <vector>

namespace hostile {

// What stops it where the filter on calls is not in force.
enum class Also {
    nothing, // only the filter
    paths,   // Landlock too
    limits,  // resource limits too
};

struct Attempt {
    std::string name;
    bool (*succeeds)();
    Also also = Also::nothing;
    bool ordinary = false;  // any process may do it where nothing is confined
    bool playerMay = false; // a player needs it, and it reaches nothing
};

[[nodiscard]] const std::vector<Attempt>& attempts();

// Set before the attempts run: a process that is not ours to touch, the first of a group of its
// own, and a port that listens.
extern int otherProcess;
extern int listeningPort;
// A descriptor of the file "canary", open in the process that starts confined ones.
extern int inheritedDescriptor;

} // namespace hostile
