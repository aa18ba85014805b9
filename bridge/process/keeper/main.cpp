// The keeper of one team: a small program between a program that plays matches and a team's program. It sets
// up the containment, waits, and at the end removes whatever the team has left. It is a separate program
// because a process forked from one with threads may call almost nothing, and would keep that one's memory.

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/signalfd.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include "bridge/process/keeper/cgroup.hpp"
#include "bridge/process/keeper/descendants.hpp"
#include "bridge/process/keeper/files.hpp"
#include "bridge/process/keeper/namespaces.hpp"
#include "bridge/process/keeper/network.hpp"
#include "bridge/process/keeper/promise.hpp"
#include "bridge/process/keeper/team.hpp"
#include "engine/core/system/shortage.hpp"

namespace fulbito::keeper {
namespace {

// [ms] a process that allocates without end takes about 0.1 GiB in this time
constexpr int kWatchInterval = 50;
constexpr int kFolderWatchIntervals = 10;  // walking over a folder costs more than asking for a process
constexpr int kKillSeconds = 10;  // [s] then processes that even SIGKILL does not end are left behind

/// Whether the user namespace of this process knows the user.
bool isMapped(uid_t user) {
  const std::string map = readSmallFile("/proc/self/uid_map");
  const char* next = map.c_str();
  while (*next != '\0') {
    char* after = nullptr;
    const unsigned long long first = std::strtoull(next, &after, 10);
    std::strtoull(after, &after, 10);
    const unsigned long long count = std::strtoull(after, &after, 10);
    if (user >= first && user - first < count) return true;
    if (after == next) return false;
    next = *after == '\n' ? after + 1 : after;
  }
  return false;
}

/// The user that the team runs as. For root, it is a user that nobody else has: each keeper has another
/// process number, and process numbers stay below 2^22. In containers that know only 65536 users, it is one
/// of systemd's dynamic users.
uid_t chooseUser() {
  if (::geteuid() != 0) return ::geteuid();
  constexpr uid_t kFirst = 0x70000000, kFirstDynamic = 61184, kDynamic = 4336;
  const auto number = static_cast<uid_t>(::getpid());
  return isMapped(kFirst + number) ? kFirst + number : kFirstDynamic + number % kDynamic;
}

bool makePrivateFolder(Order& order) {
  order.private_folder = order.base_folder + "/fulbito-team-XXXXXX";
  if (::mkdtemp(order.private_folder.data()) == nullptr) {
    failed(order, "make a private folder", errno);
    return false;
  }
  order.page->private_folder.set(order.private_folder);
  if (::geteuid() != 0 || ::chown(order.private_folder.c_str(), order.user, order.group) == 0) return true;
  failed(order, "give the private folder to the team", errno);
  ::rmdir(order.private_folder.c_str());
  return false;
}

void detach(int descriptor) {
  const int nothing = ::open("/dev/null", O_RDWR | O_CLOEXEC);
  if (nothing < 0) {
    ::close(descriptor);
    return;
  }
  ::dup2(nothing, descriptor);
  if (nothing > descriptor) ::close(nothing);
}

/// Closes this process's ends of the team's pipes: otherwise nobody would notice when the team closes them.
void letGo() {
  for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) detach(descriptor);
  ::close(kStartDescriptor);
}

bool receiveByte(int descriptor) {
  char byte = 0;
  ssize_t got = 0;
  do {
    got = ::read(descriptor, &byte, 1);
  } while (got < 0 && errno == EINTR);
  return got == 1;
}

/// The first process of a PID namespace: starts the team, reaps orphans, and when it ends, the kernel ends
/// all others. `line` is the connection to the keeper.
[[noreturn]] void beFirst(Order& order, int line, pid_t keeper) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL, 0, 0, 0);
  const int error = receiveByte(line) ? mapUser(order) : ESRCH;
  if (error != 0) {
    order.page->error = error;
    ::_exit(125);
  }
  reached(order, "pid-namespace");
  if (order.own_users) reached(order, "user-namespace");
  std::string why;
  const int mount_error = restrictMounts(order, why);
  if (mount_error == 0) {
    reached(order, "mount-namespace");
  } else {
    lacks(order, "mount-namespace", why, mount_error);
  }
  if (order.page->sockets > 0) openNetwork(order);
  const pid_t team = ::fork();
  if (team < 0) giveUp(order, "start a process", errno);
  if (team == 0) becomeTeam(order, ::getppid(), keeper);
  letGo();
  static_cast<void>(::write(line, "r", 1));
  ::close(line);
  for (;;) {
    int status = 0;
    const pid_t ended = ::waitpid(-1, &status, 0);
    if (ended != team) continue;
    order.page->wait_status = status;
    order.page->ended = true;
    ::_exit(0);
  }
}

/// Lets the process at the other end continue. Waits until the first process of a namespace has started the
/// team. @return 0, or an errno
int exchange(const Order& order, int line, bool with_namespaces) {
  if (::send(line, "g", 1, MSG_NOSIGNAL) != 1) return errno;
  errno = 0;
  if (!with_namespaces || receiveByte(line)) return 0;
  if (order.page->error != 0) return order.page->error;
  return errno != 0 ? errno : EIO;
}

/// The process that the keeper has started: the team, or the first process of its namespaces.
struct Started {
  pid_t process = -1;
  bool grouped = false;  ///< in the team's control group
};

/// `process` is -1 with errno on failure, for example if the system refuses namespaces.
Started start(Order& order, const Cgroup& group, bool has_group, bool with_namespaces) {
  int line[2] = {-1, -1};
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, line) != 0) return {};
  const pid_t keeper = ::getpid();
  Started started{forkInNamespaces(order, with_namespaces), false};
  if (started.process == 0) {
    ::close(line[0]);
    if (with_namespaces) beFirst(order, line[1], keeper);
    if (!receiveByte(line[1])) ::_exit(125);
    becomeTeam(order, keeper, keeper);
  }
  int error = errno;
  ::close(line[1]);
  if (started.process > 0) {
    started.grouped = order.page->grouped = has_group && group.add(started.process);
    reached(order, started.grouped ? "cgroup" : "memory-watch");
    error = exchange(order, line[0], with_namespaces);
    if (error != 0) {
      ::kill(started.process, SIGKILL);
      ::waitpid(started.process, nullptr, 0);
      started.process = -1;
    }
  }
  ::close(line[0]);
  errno = error;
  return started;
}

/// Starts with namespaces, or without them if the system refuses them.
Started startAsContainedAsPossible(Order& order, const Cgroup& group, bool has_group) {
  Started started = start(order, group, has_group, true);
  if (started.process > 0) return started;
  const int error = errno;
  // A shortage is temporary: a later launch gets all layers.
  if (isShortage(error) || error == EIO) {
    if (order.page->error == 0) failed(order, "start a process", error);
    return started;
  }
  if (order.page->sockets > 0) {
    lacks(order, "network-namespace", "not allowed here", error);
    order.page->lacks_layer = true;
    failed(order, "make a network", error);
    return started;
  }
  order.own_pids = order.own_users = order.page->bounded_folder = false;
  order.page->error = 0;
  order.page->begins = false;
  order.page->layers.set("");
  order.page->missing.set("");
  for (const char* layer : {"pid-namespace", "mount-namespace"})
    lacks(order, layer, "not allowed here", error);
  if (::geteuid() != 0) lacks(order, "user-namespace", "not allowed here", error);
  started = start(order, group, has_group, false);
  if (started.process < 0) failed(order, "start a process", errno);
  return started;
}

/// The limits that the keeper itself must watch.
class Watch {
 public:
  Watch(const Order& order, bool memory) : order_(order), memory_(memory) {}

  /// [ms] until the next look; -1: no need to look
  int interval() const { return memory_ || !order_.page->bounded_folder ? kWatchInterval : -1; }

  /// The reason why the team must end; empty: none.
  std::string look() {
    if (memory_) {
      const Usage used = usage(descendants(::getpid()));
      if (used.memory > order_.page->memory) return "out of memory";
      // The first process of the namespace counts too.
      if (used.tasks > order_.page->processes + 1) return "too many processes";
    }
    if (!order_.page->bounded_folder && ++looks_ % kFolderWatchIntervals == 0) {
      const std::uint64_t most = order_.page->folder_size;
      if (treeSize(order_.private_folder, most + 1) > most) return "private folder full";
    }
    return {};
  }

 private:
  const Order& order_;
  bool memory_;
  int looks_ = 0;
};

/// Descriptors that wake the keeper.
struct Wakers {
  int signals = -1;
  int launcher = -1;  ///< readable when the launcher has ended; -1: kernels before 5.3
};

Wakers openWakers(Order& order) {
  Wakers wakers;
  sigset_t set;
  sigemptyset(&set);
  sigaddset(&set, SIGTERM);
  sigaddset(&set, SIGCHLD);
  ::sigprocmask(SIG_BLOCK, &set, nullptr);
  wakers.signals = ::signalfd(-1, &set, SFD_CLOEXEC | SFD_NONBLOCK);
  if (wakers.signals < 0) giveUp(order, "watch for signals", errno);
  wakers.launcher = static_cast<int>(::syscall(SYS_pidfd_open, order.page->launcher, 0));
  // Checked after the descriptor is open: if another process has the number by then, the parent differs.
  if (::getppid() != order.page->launcher) ::_exit(125);
  return wakers;
}

/// Notes that the team ends by no fault of its own.
void machineFailed(Order& order, const char* reason) {
  order.page->reason.set(reason);
  order.page->machine_failed = true;
}

/// Reaps ended processes. @return whether `process` is one of them
bool reap(Order& order, pid_t process) {
  bool found = false;
  int status = 0;
  for (pid_t ended = 0; (ended = ::waitpid(-1, &status, WNOHANG)) > 0;) {
    if (ended != process) continue;
    found = true;
    if (!order.own_pids) {
      order.page->wait_status = status;
      order.page->ended = true;
    } else if (!order.page->ended) {  // it has not reported how the team ended
      machineFailed(order, "somebody killed the first process of its namespace");
    }
  }
  return found;
}

/// Whether the team is exiting by itself: its pipes close a moment before its parent can reap it.
bool teamIsEnding(const Order& order, pid_t process) {
  if (!order.own_pids) return isEnding(process);
  // The first child of the namespace's first process, in the order of their start.
  const std::vector<pid_t> below = descendants(process);
  return below.empty() || isEnding(below.front());
}

/// Gives a team that is about to end the time to do so. @return whether `process` still runs
bool waitForOwnEnd(Order& order, pid_t process, const Wakers& wakers) {
  constexpr int kMostRounds = 1000;  // at most 1 ms each
  // An interpreter closes its files some milliseconds before it ends, or longer on a busy machine.
  for (int round = 0; round < kMostRounds && (order.page->pipe_closed || teamIsEnding(order, process));
       ++round) {
    pollfd wait{wakers.signals, POLLIN, 0};
    ::poll(&wait, 1, 1);
    signalfd_siginfo info{};
    while (::read(wakers.signals, &info, sizeof info) > 0) {
    }
    if (reap(order, process)) return false;
  }
  return true;
}

/// Waits until the team or the launcher has ended, or the launcher asks for the end.
/// @return whether `process` still runs
bool waitForEnd(Order& order, pid_t process, const Wakers& wakers, Watch& watch) {
  for (;;) {
    pollfd waits[] = {{wakers.signals, POLLIN, 0}, {wakers.launcher, POLLIN, 0}};
    const int interval = wakers.launcher < 0 ? kWatchInterval : watch.interval();
    ::poll(waits, wakers.launcher < 0 ? 1 : 2, interval);
    bool asked = false;
    signalfd_siginfo info{};
    while (::read(wakers.signals, &info, sizeof info) == static_cast<ssize_t>(sizeof info)) {
      asked = asked || info.ssi_signo == SIGTERM;
    }
    if (reap(order, process)) return false;
    if (asked || ::getppid() != order.page->launcher) return waitForOwnEnd(order, process, wakers);
    const std::string why = watch.look();
    if (why.empty()) continue;
    order.page->reason.set(why);
    return true;
  }
}

void closeAllFrom(int first) {
  if (::syscall(SYS_close_range, first, ~0U, 0) == 0) return;
  constexpr int kMost = 1 << 20;  // Linux before 5.9 has no such call
  for (int descriptor = first; descriptor < kMost; ++descriptor) ::close(descriptor);
}

void keep(Order& order) {
  const Wakers wakers = openWakers(order);
  ::prctl(PR_SET_CHILD_SUBREAPER, 1, 0, 0, 0);
  if (!canKeepPromise(order)) return;
  order.user = chooseUser();
  order.group = ::geteuid() == 0 ? order.user : ::getegid();
  if (!makePrivateFolder(order)) return;
  Cgroup group;
  const bool has_group = group.make(order);
  for (const std::string& folder : group.folders()) order.page->groups.add(folder + "\n");
  const Started started = startAsContainedAsPossible(order, group, has_group);
  letGo();
  // A team of the same user without a namespace could otherwise reach into this process.
  ::prctl(PR_SET_DUMPABLE, 0, 0, 0, 0);
  if (started.process > 0) {
    Watch watch(order, !started.grouped);
    const bool runs = waitForEnd(order, started.process, wakers, watch);
    if (runs && order.own_pids) ::kill(started.process, SIGKILL);
  }
  killDescendants(kKillSeconds);
  if (group.ranOut()) {
    order.page->reason.set("out of memory");
    order.page->machine_failed = false;
  } else if (group.othersRanOut()) {
    machineFailed(order, "the machine is out of memory");
  }
  removeTree(order.private_folder);
}

}  // namespace
}  // namespace fulbito::keeper

int main() {
  using namespace fulbito::keeper;
  closeAllFrom(kStartDescriptor + 1);
  for (const int descriptor : {kPageDescriptor, kStartDescriptor}) {
    if (::fcntl(descriptor, F_SETFD, FD_CLOEXEC) != 0) return 125;
  }
  Order order = readOrder();
  keep(order);
  return 0;
}
