#include "engine/core/system/worker_threads.hpp"

#include <algorithm>
#include <atomic>
#include <csignal>
#include <exception>
#include <optional>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

namespace fulbito {
namespace {

/// Blocks all signals, so that threads started during its life receive none.
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

/// The error of the first failed task. kInterrupted counts only if no task has another error.
class FirstError {
 public:
  void take(std::size_t task, const Error& error) {
    const std::scoped_lock lock(mutex_);
    const std::pair rank{error.code == ErrorCode::kInterrupted, task};
    if (error_ && rank_ < rank) return;
    rank_ = rank;
    error_ = error;
  }
  const std::optional<Error>& error() const { return error_; }

 private:
  std::mutex mutex_;
  std::pair<bool, std::size_t> rank_;
  std::optional<Error> error_;
};

/// Starts the threads, or as many of them as the system allows.
std::vector<std::jthread> start(int threads, const std::function<void()>& call) {
  std::vector<std::jthread> started;
  started.reserve(static_cast<std::size_t>(std::max(threads, 0)));
  const SignalsBlocked blocked;
  for (int i = 0; i < threads; ++i) {
    try {
      started.emplace_back(call);
    } catch (const std::system_error&) {  // no memory or no process left: continue with fewer
      break;
    } catch (const std::bad_alloc&) {
      break;
    }
  }
  return started;
}

}  // namespace

WorkProgress::WorkProgress(WorkWatcher watcher, std::size_t total)
    : watcher_(std::move(watcher)), total_(total) {}

bool WorkProgress::tell(std::size_t finished) {
  const std::scoped_lock lock(mutex_);
  done_ += finished;
  if (!stopped_ && watcher_ && !watcher_(done_, total_)) stopped_ = true;
  return !stopped_;
}

bool WorkProgress::stopped() const {
  const std::scoped_lock lock(mutex_);
  return stopped_;
}

int threadsFor(int jobs, std::size_t tasks) {
  const int cores = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  const auto wanted = static_cast<std::size_t>(jobs > 0 ? jobs : cores);
  return static_cast<int>(std::clamp<std::size_t>(wanted, 1, std::max<std::size_t>(tasks, 1)));
}

Result<void> parallelFor(int jobs, std::size_t count, WorkProgress& progress,
                         const std::function<Result<void>(std::size_t)>& task) {
  std::atomic<std::size_t> next{0}, done{0};
  std::atomic<bool> stop{progress.stopped()};
  FirstError first;
  const auto run = [&](std::size_t i) {
    if (const auto result = task(i); !result) {
      first.take(i, result.error());
      return false;
    }
    ++done;
    return progress.finishedOne();
  };
  const auto work = [&] {
    try {
      // A thread that takes a task runs it. Otherwise a stop could leave out a task before the one that
      // failed.
      while (!stop) {
        const std::size_t i = next++;
        if (i >= count) return;
        if (!run(i)) stop = true;
      }
    } catch (...) {
      stop = true;
      throw;
    }
  };
  runBeside(threadsFor(jobs, count) - 1, work, [&work](int) { work(); });
  if (first.error()) return tl::unexpected<Error>(*first.error());
  if (done < count) return fail(ErrorCode::kInterrupted, "interrupted");
  return {};
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
