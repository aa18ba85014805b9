#pragma once

namespace fulbito::app {

/// Says which library ends this process, and how: with `--isolate none`, and for navigators of libraries,
/// nothing contains them. After `exit` the exit code is kTeamFailed instead of the library's. A crash keeps
/// its signal, for debuggers and core files.
void watchLibraries();

/// From now on `exit` is this program's own.
void endOfMain();

}  // namespace fulbito::app
