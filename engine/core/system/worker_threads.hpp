#pragma once

#include <cstddef>
#include <functional>

#include "fulbito/detail/parallel.hpp"

namespace fulbito {

/// Threads to use where a caller asks for `jobs`: that many, 0: one per core; at most `tasks`, at least 1.
int threadsFor(int jobs, std::size_t tasks);

/// Runs `work` on up to `threads` other threads while `meanwhile` runs on the caller's, and returns when all
/// have ended. `meanwhile` gets the number of threads that the system started, which may be 0. Only the
/// caller's thread receives signals, which end its waits. Throws the first exception of any of them.
void runBeside(int threads, const std::function<void()>& work,
               const std::function<void(int running)>& meanwhile);

}  // namespace fulbito
