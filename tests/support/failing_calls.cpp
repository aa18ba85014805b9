#include "tests/support/failing_calls.hpp"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <fstream>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

namespace fulbito::test {
namespace {

constexpr int kHangs = 25'000;  // [ms] less than the match waits for a keeper

/// A call with the errnos that a machine which runs short gives.
struct Failing {
  long number;
  const char* name;
  std::vector<int> errors;
};

const std::vector<Failing>& failingCalls() {
  static const std::vector<Failing> calls{{SYS_openat, "openat", {EMFILE, ENFILE, ENOMEM, EIO}},
                                          {SYS_open, "open", {EMFILE, ENFILE, ENOMEM, EIO}},
                                          {SYS_pipe2, "pipe2", {EMFILE, ENFILE}},
                                          {SYS_socketpair, "socketpair", {EMFILE, ENOMEM}},
                                          {SYS_memfd_create, "memfd_create", {EMFILE, ENOMEM}},
                                          {SYS_signalfd4, "signalfd4", {EMFILE, ENOMEM}},
                                          {SYS_pidfd_open, "pidfd_open", {EMFILE, ENOMEM}},
                                          {SYS_fcntl, "fcntl", {EMFILE, ENOMEM}},
                                          {SYS_ftruncate, "ftruncate", {ENOSPC, ENOMEM}},
                                          {SYS_clone, "clone", {EAGAIN, ENOMEM}},
                                          {SYS_clone3, "clone3", {EAGAIN, ENOMEM}},
                                          {SYS_execve, "execve", {ENOMEM, EAGAIN, EIO}},
                                          {SYS_mmap, "mmap", {ENOMEM}},
                                          {SYS_read, "read", {EIO, ENOMEM, EINTR}},
                                          {SYS_write, "write", {EIO, ENOMEM, EINTR}},
                                          {SYS_sendto, "sendto", {ENOBUFS, ENOMEM}},
                                          {SYS_poll, "poll", {ENOMEM, EINTR}},
                                          {SYS_ppoll, "ppoll", {ENOMEM, EINTR}},
                                          {SYS_wait4, "wait4", {EINTR}},
                                          {SYS_mkdir, "mkdir", {ENOSPC, EDQUOT, ENOMEM, EIO}},
                                          {SYS_chown, "chown", {ENOMEM, EIO}},
                                          {SYS_chdir, "chdir", {ENOMEM, EIO}},
                                          {SYS_mount, "mount", {ENOMEM}},
                                          {SYS_mount_setattr, "mount_setattr", {ENOMEM}},
                                          {SYS_newfstatat, "newfstatat", {ENOMEM, EIO}},
                                          {SYS_readlink, "readlink", {ENOMEM, EIO}},
                                          {SYS_access, "access", {ENOMEM, EIO}},
                                          {SYS_setresuid, "setresuid", {EAGAIN}},
                                          {SYS_setgroups, "setgroups", {ENOMEM}},
                                          {SYS_seccomp, "seccomp", {ENOMEM}},
                                          {SYS_landlock_create_ruleset, "landlock_create_ruleset", {ENOMEM}},
                                          {SYS_landlock_add_rule, "landlock_add_rule", {ENOMEM}},
                                          {SYS_landlock_restrict_self, "landlock_restrict_self", {ENOMEM}}};
  return calls;
}

/// Makes the kernel ask about these calls, of this process and all that it starts. @return the descriptor
/// that the questions come to
int installFilter() {
  std::vector<sock_filter> code;
  code.push_back(BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr)));
  for (const Failing& call : failingCalls()) {
    code.push_back(BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, static_cast<unsigned>(call.number), 0, 1));
    code.push_back(BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_USER_NOTIF));
  }
  code.push_back(BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW));
  sock_fprog program{static_cast<unsigned short>(code.size()), code.data()};
  if (::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0) return -1;
  return static_cast<int>(
      ::syscall(SYS_seccomp, SECCOMP_SET_MODE_FILTER, SECCOMP_FILTER_FLAG_NEW_LISTENER, &program));
}

std::string nameOf(__u32 process) {
  std::string name;
  std::getline(std::ifstream("/proc/" + std::to_string(process) + "/comm"), name);
  return name;
}

/// Answers the kernel: all calls go on but one.
class Supervisor {
 public:
  Supervisor(std::string spared, int number, int variant)
      : spared_(std::move(spared)), left_(number), variant_(variant) {}

  void answer(int listener) {
    seccomp_notif asked{};
    if (::ioctl(listener, SECCOMP_IOCTL_NOTIF_RECV, &asked) != 0) return;
    seccomp_notif_resp reply{asked.id, 0, 0, SECCOMP_USER_NOTIF_FLAG_CONTINUE};
    if (const int error = errorOf(asked); error != 0) {
      reply.error = -error;
      reply.flags = 0;
    }
    ::ioctl(listener, SECCOMP_IOCTL_NOTIF_SEND, &reply);
  }
  const std::string& failed() const { return failed_; }

 private:
  int errorOf(const seccomp_notif& asked) {
    if (left_ < 0) return 0;
    const std::string process = nameOf(asked.pid);
    if (process == spared_ || left_-- > 0) return 0;
    const auto call = std::find_if(failingCalls().begin(), failingCalls().end(),
                                   [&](const Failing& known) { return known.number == asked.data.nr; });
    const int error = call->errors[static_cast<std::size_t>(variant_) % call->errors.size()];
    failed_ = std::string(call->name) + " of '" + process + "': " + std::strerror(error);
    return error;
  }

  std::string spared_;
  int left_;
  int variant_;
  std::string failed_;
};

[[noreturn]] void work(const std::function<int()>& task, int to_parent) {
  const int listener = installFilter();
  static_cast<void>(::syscall(SYS_pwrite64, to_parent, &listener, sizeof listener, 0));
  // Until the parent has its copy.
  while (::lseek(to_parent, 0, SEEK_END) < static_cast<off_t>(2 * sizeof listener)) ::sched_yield();
  if (listener >= 0) ::close(listener);
  ::_exit(task());
}

/// The parent's copy of the descriptor, which the child tells through `file`.
int listenerOf(pid_t child, int file) {
  int number = -1;
  while (::pread(file, &number, sizeof number, 0) != sizeof number) ::sched_yield();
  const int process = static_cast<int>(::syscall(SYS_pidfd_open, child, 0));
  const int listener = number < 0 ? -1 : static_cast<int>(::syscall(SYS_pidfd_getfd, process, number, 0));
  ::close(process);
  static_cast<void>(::pwrite(file, &number, sizeof number, sizeof number));
  return listener;
}

}  // namespace

FailedCall withFailingCall(const std::function<int()>& task, const std::string& spared, int number,
                           int variant) {
  const int file = ::memfd_create("failing-calls", MFD_CLOEXEC);
  const pid_t child = ::fork();
  if (child == 0) work(task, file);
  const int listener = listenerOf(child, file);
  ::close(file);
  Supervisor supervisor(spared, number, variant);
  FailedCall result;
  for (pollfd wait{listener, POLLIN, 0}; listener >= 0;) {
    if (::poll(&wait, 1, kHangs) == 0) {
      ::kill(child, SIGKILL);
      break;
    }
    if ((wait.revents & POLLIN) == 0) break;  // nobody is left who could ask
    supervisor.answer(listener);
  }
  ::close(listener);
  int status = 0;
  ::waitpid(child, &status, 0);
  if (WIFEXITED(status)) result.code = WEXITSTATUS(status);
  result.call = supervisor.failed();
  return result;
}

}  // namespace fulbito::test
