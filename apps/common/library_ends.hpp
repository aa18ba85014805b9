#pragma once

namespace fulbito::app {

/// Says which library ends this process, and how: with `--isolate none`, and for navigators of libraries,
/// nothing contains them. After `exit` or `_exit` the exit code is kTeamFailed instead of the library's. A
/// crash keeps its signal, for debuggers and core files.
void watchLibraries();

/// From now on `exit` is this program's own, with the code that `main` returns.
void endOfMain(int code);

/// Ends this process at once, as the C library's `_exit` does. May be called in handlers of signals.
[[noreturn]] void endProcess(int code);

}  // namespace fulbito::app
