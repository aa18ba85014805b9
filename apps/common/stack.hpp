#pragma once

#include <functional>

namespace fulbito::app {

/// Runs `work` with an ample stack, on a thread of its own where limits of the shell (`ulimit -s`, `-v`) may
/// leave the first one less. Threads that are started later have as much. @return the exit code of `work`
int withAmpleStack(const std::function<int()>& work);

}  // namespace fulbito::app
