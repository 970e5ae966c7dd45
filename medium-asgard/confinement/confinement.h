// Confines this process for good: from now on it may do as little as its role needs.
//
// Four fences, one behind the other; a kernel that lacks one still has the others, and each says
// whether it is in force. None needs a privilege, and none can be taken down again.
//   limits        resources: memory, processor time, descriptors, size of files, no core file
//   privileges    no new ones by running programs; the process cannot be read or traced by others
//   paths         Landlock with no rules: no path can be opened, made, changed or run; no TCP
//                 port bound or connected; no signal or abstract socket outside
//   calls         a filter (seccomp) that lets through the listed system calls and no other
// And death: a process of ours ends when the one that started it ends.
//
// Method and measurements: docs/numbers; Linux: landlock(7), seccomp(2), prctl(2), getrlimit(2).
// LIMIT: Landlock binds the calling thread and those it starts later; threads that a graphics
// driver started before are held by the filter, which is set for all threads, and by
// keepSignalsInside(), which is called before the driver starts.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>

namespace confinement {

enum class Role {
    evaluator, // runs one hostile script: memory, time, the two pipes; nothing else
    server,    // keeps evaluators: starts and ends its own children; parses nothing
    player,    // draws and computes: threads, timers, the graphics device that is already open
};

// Which fences to set up. All, but for the tests that show what each one stops.
struct Fences {
    bool limits = true;
    bool privileges = true;
    bool paths = true;
    bool calls = true;
    bool operator==(const Fences&) const = default;
};

struct Limits {
    std::optional<std::size_t> memory;      // bytes of address space
    std::optional<long> cpuSeconds;         // SIGXCPU at the limit, SIGKILL a second later
    std::optional<std::size_t> descriptors; // open at one time
};

struct Report {
    Fences inForce;
    int landlockVersion = 0; // the kernel's; 0: it has none
    std::string missing;     // why each fence that is not in force is not; "" when all are
};

// Confines the calling process. A fence that fails is left out and reported; the others hold.
[[nodiscard]] Report confine(Role role, const Limits& limits, Fences wanted = {});

// No signal from this process, its later threads and its later children reaches any other, for
// good; nor can they trace any other. Call it first of all, before there are threads and children.
// Nothing else is forbidden, but for gaining privileges by running programs. Returns why it is not
// so (Linux before 6.12), or "".
[[nodiscard]] std::string keepSignalsInside();

// The report that confine() would give here, tried out in a process that ends at once. For About
// boxes; call it before this process is confined itself.
[[nodiscard]] Report tryOut(Role role, const Limits& limits);

// Ends this process with SIGKILL when the thread that started it ends. If that has already
// happened (`parent` is not the parent any more), ends it now.
void dieWithParent(int parent);

// Closes every descriptor but these.
void closeDescriptorsExcept(std::span<const int> keep);

// Removes every variable of the environment.
void emptyEnvironment();

} // namespace confinement
