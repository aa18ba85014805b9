#include "bridge/process/keeper/syscall_filter.hpp"

#include <asm/sockios.h>
#include <cerrno>
#include <fcntl.h>
#include <linux/sched.h>
#include <sched.h>
#include <seccomp.h>
#include <sys/ioctl.h>
#include <sys/resource.h>
#include <sys/socket.h>

namespace fulbito::keeper {
namespace {

// A list of refused calls, not of allowed ones: interpreters and runtimes (Python, Go, Java, Node) need very
// different calls, and try new ones on new kernels. Names that the library or the machine does not know are
// ignored.
constexpr const char* kRefused[] = {
    // Other processes
    "ptrace", "process_vm_readv", "process_vm_writev", "process_madvise", "kcmp", "pidfd_getfd",
    "perf_event_open", "pidfd_open",
    // The system
    "acct", "add_key", "bpf", "clock_adjtime", "clock_settime", "adjtimex", "delete_module", "finit_module",
    "init_module", "ioperm", "iopl", "kexec_file_load", "kexec_load", "keyctl", "lookup_dcookie", "quotactl",
    "quotactl_fd", "reboot", "request_key", "sethostname", "setdomainname", "settimeofday", "swapoff",
    "swapon", "syslog", "vhangup", "nfsservctl", "_sysctl", "uselib", "ustat", "userfaultfd",
    // Mounts and namespaces
    "chroot", "fsconfig", "fsmount", "fsopen", "fspick", "mount", "mount_setattr", "move_mount", "open_tree",
    "pivot_root", "setns", "umount", "umount2", "unshare", "name_to_handle_at", "open_by_handle_at",
    // Ways around this filter
    "io_uring_enter", "io_uring_register", "io_uring_setup",
    // Objects that outlive their process
    "mq_open", "msgget", "semget", "shmget",
    // Watches on all files
    "fanotify_init", "fanotify_mark"};

// Changes of files that Landlock does not prevent, so that only unwritable mounts stop them. The owner of a
// file can make them.
constexpr const char* kRefusedOnWritableMounts[] = {
    "chmod",       "fchmod",       "fchmodat",     "fchmodat2",    "chown",     "fchown",
    "lchown",      "fchownat",     "setxattr",     "lsetxattr",    "fsetxattr", "setxattrat",
    "removexattr", "lremovexattr", "fremovexattr", "removexattrat"};

class Filter {
 public:
  Filter() : context_(seccomp_init(SCMP_ACT_ALLOW)) {}
  Filter(const Filter&) = delete;
  Filter& operator=(const Filter&) = delete;
  ~Filter() {
    if (context_ != nullptr) seccomp_release(context_);
  }

  template <typename... Comparisons>
  void refuse(const char* name, int error, Comparisons... comparisons) {
    const int number = seccomp_syscall_resolve_name(name);
    if (context_ == nullptr || number == __NR_SCMP_ERROR) return;
    const int result = seccomp_rule_add(context_, SCMP_ACT_ERRNO(static_cast<std::uint32_t>(error)), number,
                                        sizeof...(Comparisons), comparisons...);
    // A call without a number on this machine needs no rule.
    if (result != 0 && result != -EDOM && wrong_ == 0) wrong_ = -result;
  }

  int load() {
    if (context_ == nullptr) return ENOMEM;
    if (wrong_ != 0) return wrong_;
    // Calls of other architectures (32-bit calls) would bypass the rules.
    seccomp_attr_set(context_, SCMP_FLTATR_ACT_BADARCH, SCMP_ACT_KILL_PROCESS);
    seccomp_attr_set(context_, SCMP_FLTATR_CTL_OPTIMIZE, 2);
    return -seccomp_load(context_);
  }

 private:
  scmp_filter_ctx context_;
  int wrong_ = 0;
};

void refuseNamespaces(Filter& filter) {
  for (const unsigned long flag : {CLONE_NEWNS, CLONE_NEWCGROUP, CLONE_NEWUTS, CLONE_NEWIPC, CLONE_NEWUSER,
                                   CLONE_NEWPID, CLONE_NEWNET}) {
    filter.refuse("clone", EPERM, SCMP_A0(SCMP_CMP_MASKED_EQ, flag, flag));
  }
  // The flags of clone3 are in memory, which a filter cannot read. C libraries fall back to clone.
  filter.refuse("clone3", ENOSYS);
}

void refuseSockets(Filter& filter, bool network) {
  if (!network) {
    filter.refuse("socket", EACCES);
    return;
  }
  // Other families bypass the network: AF_UNIX leads to services of this machine with rights of their own.
  for (int family = 0; family < AF_MAX; ++family) {
    if (family == AF_INET || family == AF_INET6 || family == AF_NETLINK) continue;
    filter.refuse("socket", EACCES, SCMP_A0(SCMP_CMP_EQ, static_cast<scmp_datum_t>(family)));
  }
  filter.refuse("socket", EACCES, SCMP_A0(SCMP_CMP_GE, AF_MAX));
}

/// Without a PID namespace, the team could send signals to its keeper. The kernel looks only at the lower 32
/// bits of a process number.
void refuseSignals(Filter& filter, pid_t process) {
  constexpr scmp_datum_t kPid = 0xffffffff;
  const auto one = static_cast<scmp_datum_t>(process);
  const scmp_datum_t group = static_cast<std::uint32_t>(-process);
  const scmp_datum_t all = static_cast<std::uint32_t>(-1);
  for (const char* name : {"kill", "tkill", "tgkill", "rt_sigqueueinfo", "rt_tgsigqueueinfo"}) {
    filter.refuse(name, EPERM, SCMP_A0(SCMP_CMP_MASKED_EQ, kPid, one));
  }
  filter.refuse("kill", EPERM, SCMP_A0(SCMP_CMP_MASKED_EQ, kPid, group));
  filter.refuse("kill", EPERM, SCMP_A0(SCMP_CMP_MASKED_EQ, kPid, all));
}

/// Without a PID namespace, the team could change the priorities of a user's other processes for processor,
/// disk and memory. It could also send them signals in ways that `refuseSignals` does not see. 0 stands for
/// the calling thread or its group.
void refuseMeddling(Filter& filter) {
  for (const char* name : {"sched_setscheduler", "sched_setparam", "sched_setattr", "sched_setaffinity",
                           "migrate_pages", "move_pages"}) {
    filter.refuse(name, EPERM, SCMP_A0(SCMP_CMP_NE, 0));
  }
  constexpr scmp_datum_t kInt = 0xffffffff, kAllOfUser = PRIO_USER, kDisksAllOfUser = 3;  // IOPRIO_WHO_USER
  filter.refuse("setpriority", EPERM, SCMP_A1(SCMP_CMP_NE, 0));
  filter.refuse("setpriority", EPERM, SCMP_A0(SCMP_CMP_MASKED_EQ, kInt, kAllOfUser));
  filter.refuse("ioprio_set", EPERM, SCMP_A1(SCMP_CMP_NE, 0));
  filter.refuse("ioprio_set", EPERM, SCMP_A0(SCMP_CMP_MASKED_EQ, kInt, kDisksAllOfUser));
  // A folder of /proc can replace the descriptor of pidfd_open.
  filter.refuse("pidfd_send_signal", EPERM);
  // The owner of a descriptor receives signals, and the process that sets the owner chooses which.
  for (const scmp_datum_t command : {F_SETOWN, F_SETOWN_EX}) {
    filter.refuse("fcntl", EPERM, SCMP_A1(SCMP_CMP_MASKED_EQ, kInt, command));
  }
  for (const scmp_datum_t request : {FIOSETOWN, SIOCSPGRP}) {
    filter.refuse("ioctl", EPERM, SCMP_A1(SCMP_CMP_MASKED_EQ, kInt, request));
  }
}

}  // namespace

int filterSyscalls(const Order& order, pid_t keeper) {
  Filter filter;
  for (const char* name : kRefused) filter.refuse(name, EPERM);
  if (!order.unwritable) {
    for (const char* name : kRefusedOnWritableMounts) filter.refuse(name, EPERM);
  }
  // Such memory is mapped by no process, so the watch, which asks processes, would miss it.
  if (!order.page->grouped) {
    for (const char* name : {"memfd_create", "memfd_secret"}) filter.refuse(name, EPERM);
  }
  refuseNamespaces(filter);
  refuseSockets(filter, order.page->network);
  // A team may not change limits of other processes; its own it can only lower.
  filter.refuse("prlimit64", EPERM, SCMP_A0(SCMP_CMP_NE, 0), SCMP_A2(SCMP_CMP_NE, 0));
  // 0xffffffff only asks; other values can switch off protections of memory.
  filter.refuse("personality", EPERM, SCMP_A0(SCMP_CMP_NE, 0xffffffff));
  // These put input into the terminal of the launching program.
  filter.refuse("ioctl", EPERM, SCMP_A1(SCMP_CMP_MASKED_EQ, 0xffffffff, TIOCSTI));
  filter.refuse("ioctl", EPERM, SCMP_A1(SCMP_CMP_MASKED_EQ, 0xffffffff, TIOCLINUX));
  if (!order.own_pids) {
    refuseSignals(filter, keeper);
    refuseSignals(filter, order.page->launcher);
    refuseMeddling(filter);
  }
  return filter.load();
}

}  // namespace fulbito::keeper
