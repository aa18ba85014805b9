#pragma once

#include <cstddef>
#include <functional>

namespace fulbito {

/// The number of threads for `jobs`: that many, or one per core if 0; at most `tasks`, at least 1.
int threadsFor(int jobs, std::size_t tasks);

/// Calls `task(i)` once for i = 0 ... count - 1, started in this order, on `threadsFor(jobs, count)` threads
/// including the caller's. Stops when one returns false. Uses fewer threads if the system cannot start more.
/// Throws the first exception of any task after all started tasks have ended.
void forEachTask(int jobs, std::size_t count, const std::function<bool(std::size_t)>& task);

/// Runs `work` on up to `threads` other threads while `meanwhile` runs on the caller's thread. Returns when
/// all have ended. `running` is the number of threads that the system started, possibly 0. Only the caller's
/// thread receives signals, which end its waits. Throws the first exception of any thread.
void runBeside(int threads, const std::function<void()>& work,
               const std::function<void(int running)>& meanwhile);

}  // namespace fulbito
