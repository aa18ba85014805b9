#pragma once

#include <string>

/// How times of a match are written, everywhere the same.
namespace fulbito {

/// Minutes, seconds and tenths, e.g. "4:32.1". Cut and not rounded, as a clock shows what has passed: 14.06 s
/// is "0:14.0". A time that is negative or not a number is "0:00.0".
std::string clockText(double seconds);

/// Name of a period as `GameEvent` counts them: "1st half", "2nd half", "overtime", "shoot-out".
std::string periodName(int period);

}  // namespace fulbito
