#pragma once

#include <string>

/// How all programs and files write match times.
namespace fulbito {

/// Minutes, seconds and tenths, e.g. "4:32.1". Truncated, not rounded, like a clock: 14.06 s is "0:14.0". A
/// negative time or NaN is "0:00.0".
std::string clockText(double seconds);

/// Name of a period as `GameEvent` counts them: "1st half", "2nd half", "overtime", "shoot-out".
std::string periodName(int period);

}  // namespace fulbito
