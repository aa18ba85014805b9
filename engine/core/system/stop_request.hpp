#pragma once

namespace fulbito {

/// @{ A process-wide request to stop. A program sets it on a signal; long work and waits check it and return
/// kInterrupted. `requestStop` is safe in signal handlers. A request cannot be withdrawn.
void requestStop() noexcept;
bool stopRequested() noexcept;
/// @}

}  // namespace fulbito
