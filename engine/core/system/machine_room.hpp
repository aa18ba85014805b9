#pragma once

#include <condition_variable>
#include <cstddef>
#include <exception>
#include <limits>
#include <mutex>

#include "fulbito/detail/values.hpp"

namespace fulbito {

/// The error kMachine for the current exception, if it reports a lack of memory or threads. Rethrows any
/// other. Call it in a `catch`.
Error machineError();

/// Limits the number of demanding tasks at once, such as matches with processes of their own. A task that
/// fails for lack of resources runs again: with fewer tasks beside it, at last alone. Thread-safe.
class MachineRoom {
 public:
  /// @param retries  further attempts of a task while no other runs
  explicit MachineRoom(int retries = 2) : retries_(retries) {}

  /// The result of `task`, which returns a Result. Errors: those of the task; kMachine if all attempts lacked
  /// resources.
  template <typename Task>
  auto run(const Task& task) -> decltype(task()) {
    for (int alone = 0;;) {
      const Entry entry = enter();
      auto result = attempt(task);
      const bool failed = !result && result.error().code == ErrorCode::kMachine;
      if (leave(entry, failed)) ++alone;
      if (!failed || alone > retries_) return result;
      countRepeat();
    }
  }
  /// Attempts that were repeated.
  std::size_t repeated() const;

 private:
  template <typename Task>
  static auto attempt(const Task& task) -> decltype(task()) {
    try {
      return task();
    } catch (const std::exception&) {
      return tl::unexpected<Error>(machineError());
    }
  }
  struct Entry {
    std::size_t number = 0;
    int running = 0;  ///< running tasks, including this one
  };
  Entry enter();
  /// @return whether no other task ran meanwhile
  bool leave(const Entry& entry, bool failed);
  void countRepeat();

  const int retries_;
  mutable std::mutex mutex_;
  std::condition_variable left_;
  std::size_t entered_ = 0;
  int running_ = 0;
  int most_ = std::numeric_limits<int>::max();  ///< limit of tasks at once
  int well_ = 0;                                ///< tasks without a shortage since `most_` changed
  std::size_t repeated_ = 0;
};

}  // namespace fulbito
