#include "script/processes.h"

#include <cerrno>
#include <csignal>
#include <cstring>

#include <fcntl.h>
#include <poll.h>
#include <sched.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

namespace script {

// Not by the C library's fork(), which cannot ask for the descriptor. Its child asks for its own
// number where it needs it, so that nothing stale is left behind.
Child forkChild() {
    Child child;
    child.process = static_cast<pid_t>(
        syscall(SYS_clone, CLONE_PIDFD | SIGCHLD, nullptr, &child.descriptor, nullptr, nullptr));
    if (child.process == 0)
        child.descriptor = -1;
    return child;
}

pid_t forkSibling() {
    return static_cast<pid_t>(
        syscall(SYS_clone, CLONE_PARENT | SIGCHLD, nullptr, nullptr, nullptr, nullptr));
}

int end(Child& child) {
    int status = 0;
    if (child.process > 0) {
        syscall(SYS_pidfd_send_signal, child.descriptor, SIGKILL, nullptr, 0);
        while (waitpid(child.process, &status, 0) < 0 && errno == EINTR) {
        }
        close(child.descriptor);
    }
    child = {};
    return status;
}

bool openPipe(std::array<int, 2>& ends) {
    if (pipe2(ends.data(), O_CLOEXEC) != 0)
        return false;
    for (int& end : ends)
        if (end < 3) {
            const int moved = fcntl(end, F_DUPFD_CLOEXEC, 3);
            close(end);
            end = moved;
        }
    return ends[0] >= 0 && ends[1] >= 0;
}

void closeAll(std::array<int, 2>& ends) {
    for (int& end : ends) {
        if (end >= 0)
            close(end);
        end = -1;
    }
}

bool readAll(int fd, void* bytes, std::size_t count) {
    auto* at = static_cast<char*>(bytes);
    while (count > 0) {
        const ssize_t got = read(fd, at, count);
        if (got < 0 && errno == EINTR)
            continue;
        if (got <= 0)
            return false;
        at += got;
        count -= static_cast<std::size_t>(got);
    }
    return true;
}

bool writeAll(int fd, const void* bytes, std::size_t count) {
    const auto* at = static_cast<const char*>(bytes);
    while (count > 0) {
        const ssize_t put = write(fd, at, count);
        if (put < 0 && errno == EINTR)
            continue;
        if (put <= 0)
            return false;
        at += put;
        count -= static_cast<std::size_t>(put);
    }
    return true;
}

namespace {

// A message whose body is a process's number and whose attachment is two descriptors.
struct Message {
    explicit Message(pid_t& process) : body{&process, sizeof process} {
        header.msg_iov = &body;
        header.msg_iovlen = 1;
        header.msg_control = room.data();
        header.msg_controllen = room.size();
    }
    iovec body;
    alignas(cmsghdr) std::array<char, CMSG_SPACE(2 * sizeof(int))> room{};
    msghdr header{};
};

} // namespace

bool send(int socket, const Sent& sent) {
    pid_t process = sent.process;
    Message message(process);
    cmsghdr* attached = CMSG_FIRSTHDR(&message.header);
    attached->cmsg_level = SOL_SOCKET;
    attached->cmsg_type = SCM_RIGHTS;
    attached->cmsg_len = CMSG_LEN(sizeof sent.descriptors);
    std::memcpy(CMSG_DATA(attached), sent.descriptors.data(), sizeof sent.descriptors);
    return sendmsg(socket, &message.header, MSG_NOSIGNAL) == sizeof process;
}

std::optional<Sent> receive(int socket, int milliseconds) {
    pollfd arriving{socket, POLLIN, 0};
    int ready = -1;
    while ((ready = poll(&arriving, 1, milliseconds)) < 0 && errno == EINTR) {
    }
    Sent sent;
    Message message(sent.process);
    if (ready <= 0 || recvmsg(socket, &message.header, MSG_CMSG_CLOEXEC) != sizeof sent.process)
        return std::nullopt;
    const cmsghdr* attached = CMSG_FIRSTHDR(&message.header);
    if (!attached || attached->cmsg_type != SCM_RIGHTS ||
        attached->cmsg_len != CMSG_LEN(sizeof sent.descriptors))
        return std::nullopt;
    std::memcpy(sent.descriptors.data(), CMSG_DATA(attached), sizeof sent.descriptors);
    return sent;
}

} // namespace script
