#include "files/failing_files.h"

#include <cstdlib>
#include <filesystem>

#include <sys/wait.h>
#include <unistd.h>

namespace files {

Folder::Folder() {
    std::string made = std::filesystem::temp_directory_path() / "files-XXXXXX";
    path_ = ::mkdtemp(made.data());
}

Folder::~Folder() { std::filesystem::remove_all(path_); }

pid_t deadProcess() {
    const pid_t child = ::fork();
    if (child == 0)
        ::_exit(0);
    ::waitpid(child, nullptr, 0);
    return child;
}

} // namespace files
