#include "attempts.h"

#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstring>

#include <arpa/inet.h>
#include <fcntl.h>
#include <linux/capability.h>
#include <linux/kcmp.h>
#include <mqueue.h>
#include <sched.h>
#include <sys/inotify.h>
#include <sys/ioctl.h>
#include <sys/ipc.h>
#include <sys/mman.h>
#include <sys/mount.h>
#include <sys/msg.h>
#include <sys/prctl.h>
#include <sys/ptrace.h>
#include <sys/resource.h>
#include <sys/sem.h>
#include <sys/shm.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <sys/xattr.h>
#include <unistd.h>

namespace hostile {

int otherProcess = 0;
int listeningPort = 0;
int inheritedDescriptor = -1;

namespace {

bool good(long result) { return result >= 0; }

bool opens(const char* path, int flags) { return good(open(path, flags, 0600)); }

bool forks(long pid) {
    if (pid == 0)
        _exit(0);
    return pid > 0;
}

bool connects(int family) {
    const int fd = socket(family, SOCK_STREAM, 0);
    if (fd < 0)
        return false;
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<std::uint16_t>(listeningPort));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    return connect(fd, reinterpret_cast<sockaddr*>(&address), sizeof address) == 0;
}

bool runs(int how) {
    char program[] = "/bin/true";
    char* arguments[] = {program, nullptr};
    char* none[] = {nullptr};
    if (how == 0)
        execve(program, arguments, none);
    else
        syscall(SYS_execveat, AT_FDCWD, program, arguments, none, 0);
    return false; // a program that runs exits with 0, which counts as success
}

bool readsMemoryOf(pid_t process) {
    char local[8];
    static char remote[8];
    iovec here{local, sizeof local};
    iovec there{remote, sizeof remote};
    return process_vm_readv(process, &here, 1, &there, 1, 0) > 0;
}

bool writesMemoryOf(pid_t process) {
    static char bytes[8];
    iovec here{bytes, sizeof bytes};
    iovec there{bytes, sizeof bytes};
    return process_vm_writev(process, &here, 1, &there, 1, 0) > 0;
}

std::string procOf(pid_t process, const char* file) {
    return "/proc/" + std::to_string(process) + "/" + file;
}

bool ringIsMade() {
    char parameters[256] = {};
    return good(syscall(SYS_io_uring_setup, 2, parameters));
}

bool programOfTheKernelIsLoaded() {
    char attributes[128] = {};
    return good(syscall(SYS_bpf, 0, attributes, sizeof attributes)); // makes a map
}

// A pipe that sends a signal to another when something is written into it.
bool endsByOwnedPipe(bool (*own)(int pipe)) {
    int ends[2];
    return pipe(ends) == 0 && own(ends[0]) && fcntl(ends[0], F_SETSIG, SIGKILL) == 0 &&
           fcntl(ends[0], F_SETFL, O_ASYNC) == 0 && write(ends[1], "x", 1) == 1;
}

bool ownsForThread(int pipe) {
    const f_owner_ex owner{F_OWNER_TID, otherProcess};
    return fcntl(pipe, F_SETOWN_EX, &owner) == 0;
}

bool ownsSocket() {
    int pair[2];
    return socketpair(AF_UNIX, SOCK_STREAM, 0, pair) == 0 &&
           ioctl(pair[0], FIOSETOWN, &otherProcess) == 0;
}

bool setsSchedule(pid_t process, int schedule, int priority) {
    sched_param parameters{};
    parameters.sched_priority = priority;
    return sched_setscheduler(process, schedule, &parameters) == 0;
}

bool setsScheduleByAttributes() {
    std::uint32_t attributes[12] = {sizeof attributes, SCHED_BATCH};
    return good(syscall(SYS_sched_setattr, otherProcess, attributes, 0));
}

bool setsProcessors() {
    cpu_set_t first;
    CPU_ZERO(&first);
    CPU_SET(0, &first);
    return sched_setaffinity(otherProcess, sizeof first, &first) == 0;
}

bool movesPages() {
    static int page = 0;
    void* pages[1] = {&page};
    const int nodes[1] = {0};
    int status[1] = {};
    return good(syscall(SYS_move_pages, otherProcess, 1, pages, nodes, status, 0));
}

bool opensQueue() {
    const bool opened =
        good(mq_open("/escaped", O_CREAT | O_RDWR, mode_t{0600}, static_cast<mq_attr*>(nullptr)));
    mq_unlink("/escaped");
    return opened;
}

bool queuesForThread() {
    siginfo_t info{};
    info.si_code = SI_QUEUE;
    return good(syscall(SYS_rt_tgsigqueueinfo, otherProcess, otherProcess, SIGCONT, &info));
}

bool usesInherited() {
    return inheritedDescriptor >= 0 && fcntl(inheritedDescriptor, F_GETFD) != -1;
}

} // namespace

const std::vector<Attempt>& attempts() {
    using enum Also;
    static const std::vector<Attempt> all = {
        // files
        {"read the password file", [] { return opens("/etc/passwd", O_RDONLY); }, paths, true},
        {"read a file here", [] { return opens("canary", O_RDONLY); }, paths, true},
        {"write a file here", [] { return opens("canary", O_WRONLY); }, paths, true},
        {"make a file", [] { return opens("escaped", O_CREAT | O_WRONLY); }, paths, true},
        {"creat", [] { return good(creat("escaped2", 0600)); }, paths, true},
        {"open a folder", [] { return opens(".", O_RDONLY | O_DIRECTORY); }, paths, true},
        {"open2",
         [] {
             std::uint64_t how[3] = {O_RDONLY, 0, 0};
             return good(syscall(SYS_openat2, AT_FDCWD, "canary", how, sizeof how));
         },
         paths, true},
        {"make a folder", [] { return good(mkdir("escaped3", 0700)); }, paths, true},
        {"remove a folder",
         [] {
             mkdir("escaped4", 0700);
             return good(rmdir("escaped4"));
         },
         paths, true},
        {"remove a file", [] { return good(unlink("spare1")); }, paths, true},
        {"rename a file", [] { return good(rename("spare2", "spare3")); }, paths, true},
        {"link a file", [] { return good(link("canary", "escaped5")); }, paths, true},
        {"symbolic link", [] { return good(symlink("canary", "escaped6")); }, paths, true},
        {"make a pipe file", [] { return good(mkfifo("escaped7", 0600)); }, paths, true},
        {"truncate a file", [] { return good(truncate("spare4", 0)); }, nothing, true},
        {"change a file's mode", [] { return good(chmod("canary", 0600)); }, nothing, true},
        {"touch a file", [] { return good(utimensat(AT_FDCWD, "canary", nullptr, 0)); }, nothing,
         true},
        {"set an attribute of a file",
         [] { return good(setxattr("canary", "user.x", "y", 1, 0)); }},
        {"ask for a file's size",
         [] {
             struct stat status {};
             return good(stat("canary", &status));
         },
         nothing, true},
        {"ask whether a file is there", [] { return good(access("canary", F_OK)); }, nothing, true},
        {"read a symbolic link",
         [] {
             char path[100];
             return good(readlink("/proc/self/exe", path, sizeof path));
         },
         nothing, true},
        {"change the folder", [] { return good(chdir("/")); }, nothing, true},
        {"change the root", [] { return good(chroot("/")); }},
        {"where am I",
         [] {
             char path[4096];
             return syscall(SYS_getcwd, path, sizeof path) > 0;
         },
         nothing, true},
        {"watch a folder", [] { return good(inotify_add_watch(inotify_init1(0), ".", IN_CREATE)); },
         nothing, true},
        {"mount",
         [] {
             const bool mounted = good(mount("none", "mounted", "tmpfs", 0, nullptr));
             umount2("mounted", MNT_DETACH);
             return mounted;
         },
         paths},
        {"open by handle",
         [] {
             char handle[128] = {};
             return good(syscall(SYS_open_by_handle_at, AT_FDCWD, handle, 0));
         }},
        // /proc and devices
        {"read the environment", [] { return opens("/proc/self/environ", O_RDONLY); }, paths, true},
        {"read one's own maps", [] { return opens("/proc/self/maps", O_RDONLY); }, paths, true},
        {"write one's own memory", [] { return opens("/proc/self/mem", O_RDWR); }, paths},
        {"read another's memory file",
         [] { return opens(procOf(otherProcess, "mem").c_str(), O_RDONLY); }, paths},
        {"read another's command line",
         [] { return opens(procOf(otherProcess, "cmdline").c_str(), O_RDONLY); }, paths, true},
        {"list one's descriptors", [] { return opens("/proc/self/fd", O_RDONLY); }, paths, true},
        {"open a terminal", [] { return opens("/dev/tty", O_RDWR); }, paths},
        {"open the null device", [] { return opens("/dev/null", O_RDWR); }, paths, true},
        // programs and processes
        {"run a program", [] { return runs(0); }, paths, true},
        {"run a program by descriptor", [] { return runs(1); }, paths, true},
        {"fork", [] { return forks(syscall(SYS_fork)); }, nothing, true},
        {"fork by clone",
         [] { return forks(syscall(SYS_clone, SIGCHLD, nullptr, nullptr, nullptr, 0)); }, nothing,
         true},
        {"fork by clone3",
         [] {
             std::uint64_t how[11] = {};
             how[4] = SIGCHLD;
             return forks(syscall(SYS_clone3, how, sizeof how));
         },
         nothing, true},
        {"new user namespace", [] { return good(unshare(CLONE_NEWUSER)); }},
        {"join a namespace", [] { return good(setns(0, 0)); }},
        {"trace another",
         [] { return good(ptrace(PTRACE_SEIZE, otherProcess, nullptr, nullptr)); }},
        {"be traced", [] { return good(ptrace(PTRACE_TRACEME, 0, nullptr, nullptr)); }, nothing,
         true},
        {"read another's memory", [] { return readsMemoryOf(otherProcess); }},
        {"write another's memory", [] { return writesMemoryOf(otherProcess); }},
        {"signal another", [] { return good(kill(otherProcess, SIGCONT)); }, nothing, true},
        {"signal all", [] { return good(kill(-1, 0)); }, nothing, true},
        {"signal another's thread",
         [] { return good(syscall(SYS_tgkill, otherProcess, otherProcess, SIGCONT)); }, nothing,
         true},
        {"queue a signal", [] { return good(sigqueue(otherProcess, SIGCONT, sigval{})); }, nothing,
         true},
        {"descriptor of a process", [] { return good(syscall(SYS_pidfd_open, otherProcess, 0)); },
         limits, true},
        {"signal another as a thread",
         [] { return good(syscall(SYS_tkill, otherProcess, SIGCONT)); }, nothing, true},
        {"queue a signal for another's thread", [] { return queuesForThread(); }, nothing, true},
        // Without a signal, or with one that the kernel sends: a descriptor's owner, what slows,
        // what limits.
        {"end another as a pipe's owner",
         [] {
             return endsByOwnedPipe([](int pipe) { return !fcntl(pipe, F_SETOWN, otherProcess); });
         },
         nothing, true},
        {"end another's group as a pipe's owner",
         [] {
             return endsByOwnedPipe([](int pipe) { return !fcntl(pipe, F_SETOWN, -otherProcess); });
         },
         nothing, true},
        {"end another's thread as a pipe's owner", [] { return endsByOwnedPipe(ownsForThread); },
         nothing, true},
        {"another as a socket's owner", [] { return ownsSocket(); }, limits, true},
        {"slow another by its schedule", [] { return setsSchedule(otherProcess, SCHED_IDLE, 0); },
         nothing, true},
        {"slow another by attributes", [] { return setsScheduleByAttributes(); }, nothing, true},
        {"another's parameters",
         [] {
             const sched_param parameters{};
             return sched_setparam(otherProcess, &parameters) == 0;
         },
         nothing, true},
        {"another's processors", [] { return setsProcessors(); }, nothing, true},
        {"another's priority",
         [] { return setpriority(PRIO_PROCESS, static_cast<id_t>(otherProcess), 19) == 0; },
         nothing, true},
        {"another group's priority",
         [] { return setpriority(PRIO_PGRP, static_cast<id_t>(otherProcess), 19) == 0; }, nothing,
         true},
        {"another's priority at the disk",
         [] { return good(syscall(SYS_ioprio_set, 1, otherProcess, 3 << 13)); }, nothing, true},
        {"more of the processor than others get", [] { return setsSchedule(0, SCHED_FIFO, 1); }},
        {"a priority before others", [] { return setpriority(PRIO_PROCESS, 0, -5) == 0; }},
        {"another's limits",
         [] {
             const rlimit none{0, 0};
             return prlimit(otherProcess, RLIMIT_CORE, &none, nullptr) == 0;
         },
         nothing, true},
        {"read another's limits",
         [] {
             rlimit now{};
             return prlimit(otherProcess, RLIMIT_CORE, nullptr, &now) == 0;
         },
         nothing, true},
        {"compare with another",
         [] { return good(syscall(SYS_kcmp, getpid(), otherProcess, KCMP_VM, 0, 0)); }},
        {"another's locks",
         [] {
             void* head = nullptr;
             std::size_t size = 0;
             return good(syscall(SYS_get_robust_list, otherProcess, &head, &size));
         }},
        {"move another's pages", [] { return movesPages(); }},
        {"a queue with a name", [] { return opensQueue(); }},
        // network
        {"socket", [] { return good(socket(AF_INET, SOCK_STREAM, 0)); }, limits, true},
        {"local socket", [] { return good(socket(AF_UNIX, SOCK_STREAM, 0)); }, limits, true},
        {"kernel socket", [] { return good(socket(AF_NETLINK, SOCK_RAW, 0)); }, limits, true},
        {"pair of sockets",
         [] {
             int pair[2];
             return good(socketpair(AF_UNIX, SOCK_STREAM, 0, pair));
         },
         limits, true},
        {"connect", [] { return connects(AF_INET); }, limits, true},
        // the kernel
        {"memory file", [] { return good(memfd_create("x", 0)); }, limits, true},
        {"asynchronous ring", [] { return ringIsMade(); }, limits},
        {"program for the kernel", [] { return programOfTheKernelIsLoaded(); }, limits},
        {"page fault handler", [] { return good(syscall(SYS_userfaultfd, 1)); }, limits},
        {"counters",
         [] {
             char attributes[128] = {};
             attributes[4] = static_cast<char>(sizeof attributes);
             return good(syscall(SYS_perf_event_open, attributes, 0, -1, -1, 0));
         }},
        {"key", [] { return good(syscall(SYS_add_key, "user", "x", "y", 1, -2)); }},
        {"keyring", [] { return good(syscall(SYS_keyctl, 0, -3, 1)); }},
        {"shared memory",
         [] {
             const int id = shmget(IPC_PRIVATE, 4096, IPC_CREAT | 0600);
             if (id >= 0)
                 shmctl(id, IPC_RMID, nullptr);
             return id >= 0;
         },
         nothing, true},
        {"message queue",
         [] {
             const int id = msgget(IPC_PRIVATE, IPC_CREAT | 0600);
             if (id >= 0)
                 msgctl(id, IPC_RMID, nullptr);
             return id >= 0;
         },
         nothing, true},
        {"semaphores",
         [] {
             const int id = semget(IPC_PRIVATE, 1, IPC_CREAT | 0600);
             if (id >= 0)
                 semctl(id, 0, IPC_RMID);
             return id >= 0;
         },
         nothing, true},
        {"allow tracing again", [] { return good(prctl(PR_SET_DUMPABLE, 1, 0, 0, 0)); }, nothing,
         true},
        {"outlive the parent", [] { return good(prctl(PR_SET_PDEATHSIG, 0, 0, 0, 0)); }, nothing,
         true},
        {"raise a limit",
         [] {
             const rlimit files{64, 64};
             return good(setrlimit(RLIMIT_NOFILE, &files));
         }},
        {"become root", [] { return good(setresuid(0, 0, 0)); }},
        {"look at capabilities",
         [] {
             __user_cap_header_struct header{_LINUX_CAPABILITY_VERSION_3, 0};
             __user_cap_data_struct data[2];
             return good(syscall(SYS_capget, &header, data));
         },
         nothing, true},
        {"name the machine",
         [] { // its own name again
             char name[256] = {};
             return gethostname(name, sizeof name - 1) == 0 &&
                    good(sethostname(name, strlen(name)));
         }},
        {"type into the terminal",
         [] {
             char c = ' ';
             return good(syscall(SYS_ioctl, 0, 0x5412 /* TIOCSTI */, &c));
         }},
        {"run what was written", // W^X
         [] {
             return mmap(nullptr, 4096, PROT_READ | PROT_WRITE | PROT_EXEC,
                         MAP_PRIVATE | MAP_ANONYMOUS, -1, 0) != MAP_FAILED;
         },
         nothing, true, true},
        {"take a gigabyte",
         [] {
             return mmap(nullptr, std::size_t{1} << 30, PROT_READ | PROT_WRITE,
                         MAP_PRIVATE | MAP_ANONYMOUS, -1, 0) != MAP_FAILED;
         },
         limits, true, true},
        {"read a variable of the environment", [] { return environ && environ[0]; }},
        {"use an inherited descriptor", [] { return usesInherited(); }},
    };
    return all;
}

} // namespace hostile
