// Landlock by its system calls: the kernel's header may be older than the kernel.
#include "confinement/fences.h"

#include <cerrno>
#include <cstdint>
#include <cstring>

#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace confinement {

namespace {

constexpr long createRuleset = 444;
constexpr long restrictSelf = 446;
constexpr std::uint32_t askVersion = 1;
constexpr int firstWithSignals = 6;
constexpr std::uint64_t scopeOfSockets = 1, scopeOfSignals = 2; // abstract UNIX sockets

struct Ruleset { // struct landlock_ruleset_attr, as of version 6
    std::uint64_t files = 0;
    std::uint64_t network = 0; // version 4
    std::uint64_t scoped = 0;  // version 6
};

// What each version handles. With no rule at all, what is handled is denied.
Ruleset everything(int version) {
    Ruleset ruleset;
    ruleset.files = (1u << 13) - 1; // execute ... make symbolic link
    if (version >= 2)
        ruleset.files |= 1u << 13; // refer: link and rename across directories
    if (version >= 3)
        ruleset.files |= 1u << 14; // truncate
    if (version >= 5)
        ruleset.files |= 1u << 15; // ioctl on devices opened later
    if (version >= 4)
        ruleset.network = 3; // bind and connect TCP
    if (version >= firstWithSignals)
        ruleset.scoped = scopeOfSockets | scopeOfSignals;
    return ruleset;
}

std::size_t sizeFor(int version) { return version >= 6 ? 24 : version >= 4 ? 16 : 8; }

long versionHere() { return syscall(createRuleset, nullptr, 0, askVersion); }

std::string restrictTo(const Ruleset& ruleset, long version) {
    const long fd = syscall(createRuleset, &ruleset, sizeFor(static_cast<int>(version)), 0);
    if (fd < 0)
        return std::string("Landlock: ") + std::strerror(errno);
    const long done = syscall(restrictSelf, fd, 0);
    const int error = errno;
    close(static_cast<int>(fd));
    return done == 0 ? "" : std::string("Landlock: ") + std::strerror(error);
}

} // namespace

std::string forbidPaths(Role, int& landlockVersion) {
    const long version = versionHere();
    if (version < 1)
        return "no Landlock in this kernel";
    landlockVersion = static_cast<int>(version);
    return restrictTo(everything(landlockVersion), version);
}

std::string keepSignalsInside() {
    const long version = versionHere();
    if (version < firstWithSignals)
        return "this kernel does not bound signals (Landlock " + std::to_string(version) + ")";
    if (prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0)
        return "privileges can still be gained";
    return restrictTo({.scoped = scopeOfSignals}, version);
}

} // namespace confinement
