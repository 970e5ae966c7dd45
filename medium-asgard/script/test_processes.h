// The children of processes, as the system tells them; for tests.
#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <sys/types.h>

namespace script::testing {

// "" where there is no such process or field.
inline std::string statusOf(pid_t process, const std::string& field) {
    std::ifstream file("/proc/" + std::to_string(process) + "/status");
    for (std::string line; std::getline(file, line);)
        if (line.starts_with(field + ":\t"))
            return line.substr(field.size() + 2);
    return "";
}

// Those that live, in the order of their numbers.
inline std::vector<pid_t> childrenOf(pid_t parent) {
    std::vector<pid_t> children;
    for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
        const std::string name = entry.path().filename();
        if (name.find_first_not_of("0123456789") == std::string::npos &&
            statusOf(std::stoi(name), "PPid") == std::to_string(parent) &&
            !statusOf(std::stoi(name), "State").starts_with("Z"))
            children.push_back(std::stoi(name));
    }
    std::sort(children.begin(), children.end());
    return children;
}

} // namespace script::testing
