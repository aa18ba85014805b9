#include "engine/core/system/worker_threads.hpp"

#include <algorithm>
#include <atomic>
#include <csignal>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace fulbito {
namespace {

/// Blocks all signals, so that threads that are started meanwhile take none.
class SignalsBlocked {
 public:
  SignalsBlocked() {
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before_);
  }
  SignalsBlocked(const SignalsBlocked&) = delete;
  SignalsBlocked& operator=(const SignalsBlocked&) = delete;
  ~SignalsBlocked() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }

 private:
  sigset_t before_;
};

/// The first exception of several threads.
class FirstException {
 public:
  void run(const std::function<void()>& work) {
    try {
      work();
    } catch (...) {
      const std::scoped_lock lock(mutex_);
      if (!first_) first_ = std::current_exception();
    }
  }
  void rethrow() const {
    if (first_) std::rethrow_exception(first_);
  }

 private:
  std::mutex mutex_;
  std::exception_ptr first_;
};

/// As many threads as the system gives.
std::vector<std::jthread> start(int threads, const std::function<void()>& call) {
  std::vector<std::jthread> started;
  started.reserve(static_cast<std::size_t>(std::max(threads, 0)));
  const SignalsBlocked blocked;
  for (int i = 0; i < threads; ++i) {
    try {
      started.emplace_back(call);
    } catch (const std::system_error&) {  // no memory or no process left: fewer will do
      break;
    } catch (const std::bad_alloc&) {
      break;
    }
  }
  return started;
}

}  // namespace

int threadsFor(int jobs, std::size_t tasks) {
  const int cores = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  const auto wanted = static_cast<std::size_t>(jobs > 0 ? jobs : cores);
  return static_cast<int>(std::clamp<std::size_t>(wanted, 1, std::max<std::size_t>(tasks, 1)));
}

void forEachTask(int jobs, std::size_t count, const std::function<bool(std::size_t)>& task) {
  std::atomic<std::size_t> next{0};
  std::atomic<bool> stop{false};
  const auto work = [&] {
    try {
      for (std::size_t i = next++; i < count && !stop; i = next++) {
        if (!task(i)) stop = true;
      }
    } catch (...) {
      stop = true;
      throw;
    }
  };
  runBeside(threadsFor(jobs, count) - 1, work, [&work](int) { work(); });
}

void runBeside(int threads, const std::function<void()>& work,
               const std::function<void(int running)>& meanwhile) {
  FirstException exception;
  {
    const std::vector<std::jthread> started = start(threads, [&] { exception.run(work); });
    exception.run([&] { meanwhile(static_cast<int>(started.size())); });
  }
  exception.rethrow();
}

}  // namespace fulbito
