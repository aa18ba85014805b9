#pragma once

namespace fulbito {

/// @{ The wish to end all work soon, for the whole process: a program sets it on a signal, long work and
/// waits look at it and return kInterrupted. `requestStop` may be called by a signal handler; nothing takes
/// the wish back. A program that never sets it is never interrupted.
void requestStop() noexcept;
bool stopRequested() noexcept;
/// @}

}  // namespace fulbito
