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

// A list of what is refused, not of what is allowed: interpreters and runtimes (Python, Go, Java, Node)
// differ too much in what they need, and new kernels bring calls that they try. Names that the library or the
// machine does not know are left out.
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
    // What outlives its process
    "mq_open", "msgget", "semget", "shmget",
    // Watches on all files
    "fanotify_init", "fanotify_mark"};

// Changes of files that Landlock lets through, so that only unwritable mounts stop them. An owner can make
// them.
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
    // Calls that this machine has under no number are nothing to refuse.
    if (result != 0 && result != -EDOM && wrong_ == 0) wrong_ = -result;
  }

  int load() {
    if (context_ == nullptr) return ENOMEM;
    if (wrong_ != 0) return wrong_;
    // Threads of other architectures (32-bit calls) would pass by the rules.
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
  // Its flags lie in memory, which a filter cannot read. C libraries go back to clone.
  filter.refuse("clone3", ENOSYS);
}

void refuseSockets(Filter& filter, bool network) {
  if (!network) {
    filter.refuse("socket", EACCES);
    return;
  }
  // Others lead past the network: AF_UNIX to services of this machine, which act with rights of their own.
  for (int family = 0; family < AF_MAX; ++family) {
    if (family == AF_INET || family == AF_INET6 || family == AF_NETLINK) continue;
    filter.refuse("socket", EACCES, SCMP_A0(SCMP_CMP_EQ, static_cast<scmp_datum_t>(family)));
  }
  filter.refuse("socket", EACCES, SCMP_A0(SCMP_CMP_GE, AF_MAX));
}

/// Without a namespace of its own the team could reach its keeper. The 32 bits of a process number are all
/// that the kernel looks at.
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

/// Without a namespace of its own the team could change how a user's other processes get the processor, the
/// disk and memory, and send them signals by ways that `refuseSignals` cannot see. 0 is the calling thread,
/// or its group.
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
  // A folder of /proc is as good as what pidfd_open gives.
  filter.refuse("pidfd_send_signal", EPERM);
  // The owner of a descriptor gets signals, and which ones its process chooses.
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
  // Memory that no process maps: the watch, which asks processes, would miss it.
  if (!order.page->grouped) {
    for (const char* name : {"memfd_create", "memfd_secret"}) filter.refuse(name, EPERM);
  }
  refuseNamespaces(filter);
  refuseSockets(filter, order.page->network);
  // Limits of other processes; of its own it can only lower them.
  filter.refuse("prlimit64", EPERM, SCMP_A0(SCMP_CMP_NE, 0), SCMP_A2(SCMP_CMP_NE, 0));
  // Asking (0xffffffff) is harmless; others switch protections of memory off.
  filter.refuse("personality", EPERM, SCMP_A0(SCMP_CMP_NE, 0xffffffff));
  // Typing into the terminal of the launching program.
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
