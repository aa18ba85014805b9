#pragma once

#include <cstddef>
#include <functional>
#include <mutex>

#include "fulbito/detail/values.hpp"

namespace fulbito {

/// Called after each task with the number of finished tasks of `total`, by one thread at a time. Returning
/// false stops the work: no further task begins.
using WorkWatcher = std::function<bool(std::size_t done, std::size_t total)>;

/// Counts the finished tasks of one or more `parallelFor` for a watcher. Safe to use from several threads.
class WorkProgress {
 public:
  /// `watcher` may be empty. `total`: tasks of all loops together.
  WorkProgress(WorkWatcher watcher, std::size_t total);

  /// Counts one task and tells the watcher.
  /// @return whether the work goes on
  bool finishedOne() { return tell(1); }
  /// Calls the watcher in the middle of a long task. If it returns false, the task must end soon with
  /// kInterrupted.
  /// @return whether the work goes on
  bool goesOn() { return tell(0); }
  /// Whether the watcher stopped the work.
  bool stopped() const;

 private:
  bool tell(std::size_t finished);

  const WorkWatcher watcher_;
  const std::size_t total_;
  mutable std::mutex mutex_;
  std::size_t done_ = 0;
  bool stopped_ = false;
};

/// Calls `task(i)` once for each i = 0 ... count - 1, on `jobs` threads (0: one per core), the caller's
/// included. Tasks begin in this order. A task writes its result to a place of its own, so that results do
/// not depend on the number of threads. After a task failed or the watcher stopped, running tasks end and no
/// other begins. If the system cannot start all threads, fewer do the work.
///
/// Errors: that of the failed task with the lowest i. All tasks before it ran, so no number of threads
/// changes the error. kInterrupted if the watcher stopped the work before the last task was done. Throws the
/// first exception of any task, when all tasks that began have ended.
Result<void> parallelFor(int jobs, std::size_t count, WorkProgress& progress,
                         const std::function<Result<void>(std::size_t)>& task);

}  // namespace fulbito
