#include "apps/common/stack.hpp"

#include <algorithm>
#include <csignal>
#include <cstring>
#include <pthread.h>
#include <sys/resource.h>

#include <fmt/format.h>

#include "apps/common/commands.hpp"

namespace fulbito::app {
namespace {

constexpr std::size_t kStack = std::size_t{1} << 23;  // [bytes] the default of Linux

/// Raises the limit of the stack as far as possible. @return whether the first thread has enough: if address
/// space is limited, its stack may have no room to grow
bool raiseLimit() {
  rlimit limit{};
  if (::getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY) return false;
  if (::getrlimit(RLIMIT_STACK, &limit) != 0 || limit.rlim_cur >= kStack) return true;
  limit.rlim_cur = std::min<rlim_t>(limit.rlim_max, kStack);
  return ::setrlimit(RLIMIT_STACK, &limit) == 0 && limit.rlim_cur == kStack;
}

/// Raises the size of new stacks. The C library derives the default from the limit at the start of the
/// process.
void enlargeNewThreads(pthread_attr_t& attributes) {
  std::size_t size = 0;
  ::pthread_getattr_default_np(&attributes);
  ::pthread_attr_getstacksize(&attributes, &size);
  ::pthread_attr_setstacksize(&attributes, std::max(size, kStack));
  ::pthread_setattr_default_np(&attributes);
}

struct Job {
  const std::function<int()>& work;
  sigset_t signals{};
  int code = 0;
};

void* runJob(void* job) {
  auto& own = *static_cast<Job*>(job);
  ::pthread_sigmask(SIG_SETMASK, &own.signals, nullptr);
  own.code = own.work();
  return nullptr;
}

}  // namespace

int withAmpleStack(const std::function<int()>& work) {
  pthread_attr_t attributes;
  enlargeNewThreads(attributes);
  if (raiseLimit()) return work();
  Job job{work};
  // Only the working thread gets signals, so that they interrupt its waits.
  sigset_t all;
  sigfillset(&all);
  ::pthread_sigmask(SIG_SETMASK, &all, &job.signals);
  pthread_t thread{};
  if (const int wrong = ::pthread_create(&thread, &attributes, runJob, &job); wrong != 0) {
    return report({ErrorCode::kMachine, fmt::format("cannot start a thread: {}", std::strerror(wrong))});
  }
  ::pthread_join(thread, nullptr);
  return job.code;
}

}  // namespace fulbito::app
