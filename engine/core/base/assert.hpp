#pragma once

#include <stdexcept>

namespace fulbito::detail {
/// A broken condition, in processes that asked for it.
struct BrokenDemand : std::logic_error {
  using std::logic_error::logic_error;
};
/// From now on, broken conditions throw a BrokenDemand instead of ending the process: for hosts that live on,
/// such as an interpreter.
void throwOnBrokenDemand() noexcept;
/// Prints the broken condition and aborts, or throws. A failure is a bug of this project, never the user's
/// mistake.
[[noreturn]] void demandFailed(const char* condition, const char* file, int line);
}  // namespace fulbito::detail

/// Always checked.
#define FULBITO_DEMAND(condition) \
  ((condition) ? static_cast<void>(0) : ::fulbito::detail::demandFailed(#condition, __FILE__, __LINE__))
/// Checked in builds without NDEBUG.
#ifdef NDEBUG
#define FULBITO_ASSERT(condition) static_cast<void>(0)
#else
#define FULBITO_ASSERT(condition) FULBITO_DEMAND(condition)
#endif
