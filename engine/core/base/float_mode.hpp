#pragma once

#include <xmmintrin.h>

namespace fulbito {

/// While it lives, floating-point numbers are handled as everything here expects: rounded to nearest, small
/// ones kept (neither FTZ nor DAZ), no traps. Then the thread gets its own mode back. Programs and plug-ins
/// that were built with -ffast-math, or audio libraries, leave threads in other modes, which would change
/// bits.
class FloatMode {
 public:
  FloatMode() : before_(_mm_getcsr()) {
    if ((before_ & kModes) != (kDefault & kModes)) _mm_setcsr(kDefault);
  }
  ~FloatMode() {
    if ((before_ & kModes) != (kDefault & kModes)) _mm_setcsr(before_);
  }
  FloatMode(const FloatMode&) = delete;
  FloatMode& operator=(const FloatMode&) = delete;

 private:
  static constexpr unsigned kDefault = 0x1f80;  // all exceptions masked
  static constexpr unsigned kModes = 0xffc0;    // all but the flags of what happened
  unsigned before_;
};

}  // namespace fulbito
