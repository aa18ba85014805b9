#pragma once

namespace fulbito::app {

/// Prints which library ends this process, and how. Teams with `--isolate none`, and navigators of libraries,
/// run in this process without containment. After `exit` or `_exit` the exit code is kTeamFailed instead of
/// the library's. A crash keeps its signal, for debuggers and core files.
void watchLibraries();

/// Call it at the end of `main`. Then `exit` is no longer reported, and its code is the one `main` returns.
void endOfMain(int code);

/// Ends this process immediately, like `_exit` of the C library. May be called in signal handlers.
[[noreturn]] void endProcess(int code);

}  // namespace fulbito::app
