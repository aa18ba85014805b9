#pragma once

#include <functional>

namespace fulbito::app {

/// Runs `work` with a stack of at least 8 MiB. It starts a thread for it if limits of the shell (`ulimit -s`,
/// `-v`) may leave the first thread less. Threads started later have as much. @return the exit code of `work`
int withAmpleStack(const std::function<int()>& work);

}  // namespace fulbito::app
