#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <sys/types.h>
#include <thread>
#include <vector>

namespace fulbito {

/// Threads that wait for rounds of numbered tasks. The thread that calls `finish` does tasks, too. They
/// receive no signals.
class WorkerPool {
 public:
  static constexpr std::size_t kMostTasks = (std::size_t{1} << 20) - 1;  ///< of one round

  /// @param threads  1 ...; the caller's included. If the system cannot start all, there are fewer.
  explicit WorkerPool(int threads);
  WorkerPool(const WorkerPool&) = delete;
  WorkerPool& operator=(const WorkerPool&) = delete;
  ~WorkerPool();

  /// Begins a round: `task(context, i)` once for each i = 0 ... count - 1. It must not throw. Call `finish`
  /// before the next round.
  void start(std::size_t count, void (*task)(void* context, std::size_t i), void* context);
  /// Returns when all tasks of the round are done.
  void finish();
  /// Threads, the caller's included.
  int threads() const { return static_cast<int>(threads_.size()) + 1; }
  /// Whether this process is a child of the one that started the threads: it does not have them.
  bool forked() const;

 private:
  void work();
  bool doOne();

  // The round, its number of tasks, and the next of them in one word: a thread that comes late from one
  // round takes no task of another.
  std::atomic<std::uint64_t> ticket_{0};
  std::atomic<std::uint32_t> round_{0};
  std::atomic<std::uint32_t> done_{0};
  std::atomic<bool> stop_{false};
  std::uint32_t count_ = 0;
  void (*task_)(void*, std::size_t) = nullptr;
  void* context_ = nullptr;
  pid_t process_;
  std::vector<std::thread> threads_;
};

}  // namespace fulbito
