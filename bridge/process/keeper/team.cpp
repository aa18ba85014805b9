#include "bridge/process/keeper/team.hpp"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <fcntl.h>
#include <grp.h>
#include <linux/capability.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include "bridge/process/keeper/descendants.hpp"
#include "bridge/process/keeper/file_rules.hpp"
#include "bridge/process/keeper/syscall_filter.hpp"

namespace fulbito::keeper {
namespace {

constexpr int kOnlyReading = CAP_DAC_READ_SEARCH;

/// Keeps only the capability to read files whatever their owner, since the files of program and team may be
/// in root's folders. Landlock says which files the team may read. If the system refuses the capability, none
/// is kept.
bool keepOnlyReading() {
  __user_cap_header_struct header{_LINUX_CAPABILITY_VERSION_3, 0};
  __user_cap_data_struct data[2] = {};
  data[0].effective = data[0].permitted = data[0].inheritable = 1U << kOnlyReading;
  if (::syscall(SYS_capset, &header, data) == 0) {
    return ::prctl(PR_CAP_AMBIENT, PR_CAP_AMBIENT_RAISE, kOnlyReading, 0, 0) == 0;
  }
  data[0] = {};
  return ::syscall(SYS_capset, &header, data) == 0;
}

/// Root's team runs as a user of its own: its limit of processes counts only its own, and it has no rights
/// over other processes and files.
bool becomeOwnUser(Order& order) {
  const bool done = ::setgroups(0, nullptr) == 0 && ::setresgid(order.group, order.group, order.group) == 0 &&
                    ::prctl(PR_SET_KEEPCAPS, 1, 0, 0, 0) == 0 &&
                    ::setresuid(order.user, order.user, order.user) == 0 && keepOnlyReading();
  if (done) {
    reached(order, "own-user");
  } else {
    lacks(order, "own-user", "cannot change the user", errno);
  }
  return done;
}

/// The limit of processes. If the user is not the team's alone, the user's other processes count too.
rlim_t processLimit(const Order& order, bool own_user) {
  const auto own = static_cast<rlim_t>(order.page->processes);
  if (own_user) return own;
  if (order.own_users) return own + 1;                            // the first process of the namespace
  return own + static_cast<rlim_t>(tasksOfUser(order.user)) - 1;  // the present process is among them
}

/// Lowers a resource's limit to `most`; a lower limit stays. `beyond`: by which the hard limit is higher.
bool limit(int resource, rlim_t most, rlim_t beyond = 0) {
  rlimit now{};
  if (::getrlimit(static_cast<__rlimit_resource>(resource), &now) != 0) return false;
  now.rlim_max = std::min(now.rlim_max, most + beyond);
  now.rlim_cur = std::min(now.rlim_max, most);
  return ::setrlimit(static_cast<__rlimit_resource>(resource), &now) == 0;
}

/// Raises the soft limit to `least`, or as far as allowed; a higher limit stays.
bool raise(int resource, rlim_t least) {
  rlimit now{};
  if (::getrlimit(static_cast<__rlimit_resource>(resource), &now) != 0) return false;
  now.rlim_cur = std::max(now.rlim_cur, std::min(now.rlim_max, least));
  return ::setrlimit(static_cast<__rlimit_resource>(resource), &now) == 0;
}

/// Address space has no limit: Go and Java reserve much more than they use. The signal at the soft limit of
/// processor time shows the cause, which the kill at the hard limit does not.
void limitResources(Order& order) {
  const Page& page = *order.page;
  const bool done = limit(RLIMIT_CORE, 0) && limit(RLIMIT_FSIZE, page.file_size) &&
                    limit(RLIMIT_NOFILE, static_cast<rlim_t>(page.open_files)) &&
                    limit(RLIMIT_CPU, static_cast<rlim_t>(page.cpu_seconds), 1) &&
                    limit(RLIMIT_DATA, page.memory) && limit(RLIMIT_MSGQUEUE, 0) && limit(RLIMIT_RTPRIO, 0) &&
                    limit(RLIMIT_NICE, 0) && raise(RLIMIT_AS, RLIM_INFINITY) &&
                    raise(RLIMIT_STACK, kStackSize);
  if (done) {
    reached(order, "rlimits");
  } else {
    lacks(order, "rlimits", "cannot set them", errno);
  }
}

void restrictCalls(Order& order, pid_t keeper) {
  std::string why;
  const int files_error = restrictFiles(order, why);
  if (files_error == 0) {
    reached(order, "landlock");
  } else {
    lacks(order, "landlock", why, files_error);
  }
  const int filter_error = filterSyscalls(order, keeper);
  if (filter_error == 0) {
    reached(order, "seccomp");
  } else {
    lacks(order, "seccomp", "the kernel refuses the filter", filter_error);
  }
}

void resetSignals() {
  for (int number = 1; number < NSIG; ++number) ::signal(number, SIG_DFL);
  sigset_t none;
  sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);
}

std::vector<char*> pointers(std::vector<std::string>& words) {
  std::vector<char*> list;
  list.reserve(words.size() + 1);
  for (std::string& word : words) list.push_back(word.data());
  list.push_back(nullptr);
  return list;
}

}  // namespace

void becomeTeam(Order& order, pid_t parent, pid_t keeper) {
  resetSignals();
  ::umask(077);
  if (::setsid() < 0) giveUp(order, "start a session", errno);
  reached(order, "process-group");
  limitResources(order);
  const bool own_user = ::geteuid() == 0 && becomeOwnUser(order);
  if (!limit(RLIMIT_NPROC, processLimit(order, own_user))) giveUp(order, "limit the processes", errno);
  // Must follow the change of user, which clears it.
  ::prctl(PR_SET_PDEATHSIG, SIGKILL, 0, 0, 0);
  if (::getppid() != parent) ::_exit(125);
  reached(order, "parent-death");
  const std::string& folder = order.own_folder.empty() ? order.private_folder : order.own_folder;
  if (::chdir(folder.c_str()) != 0) giveUp(order, "enter the team's folder", errno);
  if (::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0) {
    reached(order, "no-new-privs");
  } else {
    lacks(order, "no-new-privs", "the kernel refuses", errno);
  }
  restrictCalls(order, keeper);
  if (order.page->all_layers && !order.page->missing.view().empty()) {
    order.page->lacks_layer = true;
    giveUp(order, "reach all layers", EPERM);
  }
  std::vector<std::string> environment{"PATH=" + order.path, "HOME=" + order.private_folder,
                                       "TMPDIR=" + order.private_folder, "LANG=" + order.language};
  if (!order.readable.empty()) {
    std::string modules = "PYTHONPATH=";
    for (const std::string& place : order.readable) modules += (modules.back() == '=' ? "" : ":") + place;
    environment.push_back(std::move(modules));
  }
  std::vector<char*> arguments = pointers(order.arguments), variables = pointers(environment);
  order.page->begins = true;
  ::execve(order.program.c_str(), arguments.data(), variables.data());
  giveUp(order, kRunProgram, errno);
}

}  // namespace fulbito::keeper
