#pragma once

#include <cstddef>
#include <functional>

namespace fulbito {

/// Threads to use where a caller asks for `jobs`: that many, 0: one a core; at most `tasks`, at least 1.
int threadsFor(int jobs, std::size_t tasks);

/// Calls `task(i)` for i = 0 ... count - 1 on `threadsFor(jobs, count)` threads, the caller's included, each
/// once and begun in this order, until all are done or one returns false. Where the system starts no more
/// threads, fewer work. Throws the first exception of any task, after all that were begun have ended.
void forEachTask(int jobs, std::size_t count, const std::function<bool(std::size_t)>& task);

/// Runs `work` on up to `threads` other threads while `meanwhile` runs on the caller's, and returns when all
/// have ended. `meanwhile` hears how many the system started, which may be none. Signals come to the caller's
/// thread only, whose waits they end. Throws the first exception of any of them.
void runBeside(int threads, const std::function<void()>& work,
               const std::function<void(int running)>& meanwhile);

}  // namespace fulbito
