#include <arpa/inet.h>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <dirent.h>
#include <fcntl.h>
#include <mqueue.h>
#include <netinet/in.h>
#include <sched.h>
#include <string>
#include <sys/ipc.h>
#include <sys/mman.h>
#include <sys/mount.h>
#include <sys/ptrace.h>
#include <sys/resource.h>
#include <sys/shm.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/un.h>
#include <unistd.h>

#include "tests/misbehaviour/kinds.hpp"

namespace fulbito::test {
namespace {

bool opens(const std::string& path, int flags) {
  const int file = ::open(path.c_str(), flags | O_CLOEXEC, 0600);
  if (file >= 0) ::close(file);
  // Where an attack gets through, the test that sees it fails, and that is enough.
  if (file >= 0 && (flags & O_CREAT) != 0) ::unlink(path.c_str());
  return file >= 0;
}

/// Calls `visit` with all processes that /proc shows, but this one and those below it: it has none.
template <typename Visit>
void forOtherProcesses(Visit visit) {
  DIR* stream = ::opendir("/proc");
  if (stream == nullptr) return;
  while (const dirent* entry = ::readdir(stream)) {
    const long process = std::strtol(entry->d_name, nullptr, 10);
    if (process > 0 && process != ::getpid()) visit(static_cast<pid_t>(process));
  }
  ::closedir(stream);
}

/// In a PID namespace a signal to the first process is accepted, and dropped. The test that runs this looks
/// whether anybody got one.
void signalOthers(const Scene&) {
  const pid_t parent = ::getppid();
  for (const int signal : {SIGSTOP, SIGTERM, SIGKILL}) {
    if (parent > 1) tell("signal to the parent", ::kill(parent, signal) == 0);
    if (parent > 1) tell("signal to the parent's group", ::kill(-parent, signal) == 0);
    ::kill(1, signal);
  }
  forOtherProcesses([](pid_t process) {
    if (process > 1 && ::kill(process, SIGURG) == 0) tell("signal to another process", true);
  });
}

void traceOthers(const Scene&) {
  tell("ptrace of the parent", ::ptrace(PTRACE_ATTACH, ::getppid(), nullptr, nullptr) == 0);
  forOtherProcesses([](pid_t process) {
    if (::ptrace(PTRACE_SEIZE, process, nullptr, nullptr) == 0) tell("ptrace of another process", true);
    if (opens("/proc/" + std::to_string(process) + "/mem", O_RDWR)) tell("memory of another process", true);
    if (opens("/proc/" + std::to_string(process) + "/environ", O_RDONLY))
      tell("environment of another process", true);
  });
}

void writeOutside(const Scene& scene) {
  if (!scene.victim.empty()) {
    tell("writing to a file", opens(scene.victim, O_WRONLY));
    tell("emptying a file", ::truncate(scene.victim.c_str(), 0) == 0);
    tell("removing a file", ::unlink(scene.victim.c_str()) == 0);
    tell("renaming a file", ::rename(scene.victim.c_str(), (scene.victim + "-moved").c_str()) == 0);
    tell("a file next to it", opens(scene.victim + "-new", O_CREAT | O_WRONLY));
    tell("changing rights", ::chmod(scene.victim.c_str(), 0777) == 0);
  }
  for (const char* folder : {"/tmp", "/var/tmp", "/dev/shm", "/run", "/etc", "/usr", "/"}) {
    tell(std::string("a file in ") + folder,
         opens(std::string(folder) + "/fulbito-attack", O_CREAT | O_WRONLY));
  }
}

void readSecrets(const Scene& scene) {
  if (!scene.victim.empty()) tell("reading a file", opens(scene.victim, O_RDONLY));
  for (const char* path :
       {"/etc/shadow", "/root", "/home", "/var/log", "/proc/1/mem", "/proc/kcore", "/dev/mem"}) {
    tell(std::string("reading ") + path, opens(path, O_RDONLY));
  }
}

bool connects(int family, const sockaddr* address, socklen_t size) {
  const int socket = ::socket(family, SOCK_STREAM | SOCK_CLOEXEC, 0);
  if (socket < 0) return false;
  const bool done = ::connect(socket, address, size) == 0 || errno == ECONNREFUSED || errno == ENETUNREACH;
  const int error = errno;
  ::close(socket);
  errno = error;
  return done;
}

void useNetwork(const Scene&) {
  sockaddr_in here{};
  here.sin_family = AF_INET;
  here.sin_port = htons(9);
  here.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  tell("a connection", connects(AF_INET, reinterpret_cast<const sockaddr*>(&here), sizeof here));
  tell("a datagram", ::socket(AF_INET, SOCK_DGRAM, 0) >= 0);
  tell("raw packets", ::socket(AF_INET, SOCK_RAW, 1) >= 0);
  tell("IPv6", ::socket(AF_INET6, SOCK_STREAM, 0) >= 0);
  sockaddr_un local{};
  local.sun_family = AF_UNIX;
  std::strcpy(local.sun_path, "/run/docker.sock");
  tell("a socket of a service", connects(AF_UNIX, reinterpret_cast<const sockaddr*>(&local), sizeof local));
}

void raiseLimits(const Scene&) {
  for (const int resource :
       {RLIMIT_CORE, RLIMIT_FSIZE, RLIMIT_NOFILE, RLIMIT_NPROC, RLIMIT_DATA, RLIMIT_CPU}) {
    const rlimit more{std::size_t{1} << 40, std::size_t{1} << 40};
    tell("raising limit " + std::to_string(resource),
         ::setrlimit(static_cast<__rlimit_resource>(resource), &more) == 0);
  }
  tell("priority", ::setpriority(PRIO_PROCESS, 0, -10) == 0);
  const sched_param first{1};
  tell("real-time scheduling", ::sched_setscheduler(0, SCHED_FIFO, &first) == 0);
}

void leaveSharedThings(const Scene&) {
  tell("shared memory that stays", ::shmget(0x46554c42, 4096, IPC_CREAT | 0600) >= 0);
  tell("a queue that stays", ::mq_open("/fulbito-attack", O_CREAT | O_RDWR, 0600, nullptr) >= 0);
  tell("shared memory with a name", ::shm_open("/fulbito-attack", O_CREAT | O_RDWR, 0600) >= 0);
}

void gainRights(const Scene& scene) {
  tell("becoming root", ::geteuid() != 0 && ::setuid(0) == 0);
  tell("another user", ::setuid(12345) == 0);
  tell("a user namespace", ::unshare(CLONE_NEWUSER) == 0);
  tell("a mount", ::mount("none", "/tmp", "tmpfs", 0, nullptr) == 0);
  tell("writable mounts", ::mount("none", "/", nullptr, MS_REMOUNT | MS_BIND, nullptr) == 0);
  tell("another root", ::chroot("/tmp") == 0);
  tell("a kernel key", ::syscall(SYS_add_key, "user", "fulbito", "x", 1, -2) >= 0);
  tell("calls around the filter", ::syscall(SYS_io_uring_setup, 1, nullptr) >= 0 || errno == EFAULT);
  if (!scene.victim.empty())
    tell("a device", ::mknod((scene.victim + "-device").c_str(), S_IFCHR, 0x103) == 0);
}

/// How others get the processor, the disk and memory, and signals by other ways than `kill`. What it asks for
/// is what they have already.
void meddleWithOthers(const Scene&) {
  constexpr int kDiskOfProcess = 1, kDiskOfUser = 3;  // IOPRIO_WHO_PROCESS, IOPRIO_WHO_USER
  forOtherProcesses([](pid_t process) {
    if (process == 1 || ::getppid() == 1) return;  // of its own namespace
    const sched_param none{0};
    cpu_set_t processors;
    ::sched_getaffinity(0, sizeof processors, &processors);
    const std::array<std::uint64_t, 6> plain{48};  // its size; SCHED_OTHER
    tell("another's scheduler", ::sched_setscheduler(process, SCHED_OTHER, &none) == 0);
    tell("another's scheduling", ::sched_setparam(process, &none) == 0);
    tell("another's attributes", ::syscall(SYS_sched_setattr, process, plain.data(), 0) == 0);
    tell("another's processors", ::sched_setaffinity(process, sizeof processors, &processors) == 0);
    tell("another's priority", ::setpriority(PRIO_PROCESS, static_cast<id_t>(process), 0) == 0);
    tell("another's disk", ::syscall(SYS_ioprio_set, kDiskOfProcess, process, 0) == 0);
    tell("another's memory", ::syscall(SYS_migrate_pages, process, 0, nullptr, nullptr) == 0);
    const int folder = ::open(("/proc/" + std::to_string(process)).c_str(), O_DIRECTORY | O_CLOEXEC);
    tell("a signal by /proc", ::syscall(SYS_pidfd_send_signal, folder, 0, nullptr, 0) == 0);
    tell("a descriptor's signals", ::fcntl(STDIN_FILENO, F_SETOWN, process) == 0);
    ::close(folder);
  });
  if (::getppid() > 1) {
    tell("the user's priority", ::setpriority(PRIO_USER, ::geteuid(), 0) == 0);
    tell("the user's disk", ::syscall(SYS_ioprio_set, kDiskOfUser, 0, 0) == 0);
  }
  // What runtimes ask for themselves must go on working.
  const sched_param none{0};
  cpu_set_t processors;
  ::sched_getaffinity(0, sizeof processors, &processors);
  const bool own = ::sched_setaffinity(0, sizeof processors, &processors) == 0 &&
                   ::sched_setscheduler(0, SCHED_OTHER, &none) == 0 &&
                   ::setpriority(PRIO_PROCESS, 0, ::getpriority(PRIO_PROCESS, 0) + 1) == 0;
  tell("no say in its own scheduling", !own);
}

constexpr Kind kAttacks[] = {
    {"signal-others", "signals its parent and all processes that it sees", signalOthers, true},
    {"trace-others", "traces its parent and reads memory of others", traceOthers, true},
    {"write-outside", "writes to the match's files and other folders", writeOutside, true},
    {"read-secrets", "reads others' files", readSecrets, true},
    {"network", "connects to services", useNetwork, true},
    {"meddle-with-others", "changes how other processes are scheduled", meddleWithOthers, true},
    {"raise-limits", "raises its limits", raiseLimits, true},
    {"leave-shared-memory", "leaves what outlives a process", leaveSharedThings, true},
    {"gain-rights", "gets rights that it lacks", gainRights, true},
};

}  // namespace

std::span<const Kind> attacks() { return kAttacks; }

}  // namespace fulbito::test
