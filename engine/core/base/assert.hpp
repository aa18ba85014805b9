#pragma once

namespace fulbito::detail {
/// Prints the broken condition and aborts. A failure is a bug of this project, never the user's mistake.
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
