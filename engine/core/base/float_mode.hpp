#pragma once

#include <xmmintrin.h>

namespace fulbito {

/// Sets the floating-point mode that this library expects: round to nearest, subnormals kept (neither FTZ nor
/// DAZ), no traps. The destructor restores the thread's mode. Programs built with -ffast-math and audio
/// libraries leave threads in other modes, which would change results.
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
  static constexpr unsigned kModes = 0xffc0;    // all but the status flags
  unsigned before_;
};

}  // namespace fulbito
