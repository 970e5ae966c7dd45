#include "processes/memory.h"

#include <algorithm>
#include <charconv>
#include <dirent.h>
#include <fstream>
#include <numeric>
#include <string>
#include <sys/stat.h>
#include <unistd.h>

namespace media {

namespace {

// LIMIT: of children of children of children no more than this is counted.
constexpr int deepest = 8;

std::string folderOf(pid_t process) { return "/proc/" + std::to_string(process); }

// "RssAnon:	  1234 kB" of /proc/PID/status, which is readable for confined processes, too.
std::size_t ownMemory(pid_t process) {
    std::ifstream status(folderOf(process) + "/status");
    std::size_t own = 0, shared = 0;
    for (std::string line; std::getline(status, line);) {
        const auto value = [&](const char* name) -> std::size_t {
            const std::string start = std::string(name) + ":";
            return line.starts_with(start) ? std::stoull(line.substr(start.size())) << 10 : 0;
        };
        own += value("RssAnon") + value("VmSwap");
        shared += value("RssShmem");
    }
    // Its frames, where it need not have mapped what it wrote. LIMIT: a confined process hides
    // them; then what it has mapped counts.
    struct stat frames {};
    if (stat((folderOf(process) + "/fd/3").c_str(), &frames) == 0 && S_ISREG(frames.st_mode))
        shared = std::max(shared, static_cast<std::size_t>(frames.st_blocks) * 512);
    return own + shared;
}

std::vector<pid_t> childrenOf(pid_t process) {
    std::vector<pid_t> children;
    const std::string tasks = folderOf(process) + "/task";
    DIR* folder = opendir(tasks.c_str());
    if (!folder)
        return children;
    while (const dirent* task = readdir(folder)) {
        std::ifstream file(tasks + "/" + task->d_name + "/children");
        for (pid_t child = 0; file >> child;)
            children.push_back(child);
    }
    closedir(folder);
    return children;
}

std::size_t memoryOfTree(pid_t process, int depth) {
    std::size_t sum = ownMemory(process);
    if (depth < deepest)
        for (const pid_t child : childrenOf(process))
            sum += memoryOfTree(child, depth + 1);
    return sum;
}

} // namespace

std::size_t memoryOf(pid_t process) { return memoryOfTree(process, 0); }

std::optional<std::size_t> tooLarge(const std::vector<std::size_t>& held, std::size_t most) {
    if (std::accumulate(held.begin(), held.end(), std::size_t{0}) <= most)
        return std::nullopt;
    return static_cast<std::size_t>(std::ranges::max_element(held) - held.begin());
}

bool hasRoom(const std::vector<std::size_t>& held, std::size_t unmeasured, std::size_t most) {
    if (held.empty())
        return true;
    const std::size_t sum = std::accumulate(held.begin(), held.end(), std::size_t{0});
    return sum + (unmeasured + 1) * *std::ranges::max_element(held) <= most;
}

std::size_t usualMemory() {
    const auto machine = static_cast<std::size_t>(std::max(0L, sysconf(_SC_PHYS_PAGES))) *
                         static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
    return std::min(std::size_t{1536} << 20, machine / 2);
}

} // namespace media
