#pragma once

#include <cstddef>
#include <functional>

#include "fulbito/detail/parallel.hpp"

namespace fulbito {

/// Threads to use where a caller asks for `jobs`: that many, 0: one per core; at most `tasks`, at least 1.
int threadsFor(int jobs, std::size_t tasks);

/// Runs `work` on up to `threads` other threads while `meanwhile` runs on the caller's, and returns when all
/// have ended. `meanwhile` hears how many the system started, which may be none. Signals come to the caller's
/// thread only, whose waits they end. Throws the first exception of any of them.
void runBeside(int threads, const std::function<void()>& work,
               const std::function<void(int running)>& meanwhile);

}  // namespace fulbito
