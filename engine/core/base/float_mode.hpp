#pragma once

#include <cstdint>
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

/// Calls foreign code: sets the mode as `FloatMode` does, and the destructor restores the thread's mode,
/// whatever the foreign code left. It keeps the mode of SSE and of the x87 unit, which `fesetround` changes
/// too. Loading a library built with -ffast-math sets FTZ and DAZ, for example.
class ForeignCall {
 public:
  ForeignCall() { __asm__ volatile("fnstcw %0" : "=m"(x87_)); }
  ~ForeignCall() {
    if (_mm_getcsr() != before_) _mm_setcsr(before_);
    std::uint16_t now = 0;
    __asm__ volatile("fnstcw %0" : "=m"(now));
    if (now != x87_) __asm__ volatile("fldcw %0" : : "m"(x87_));
  }
  ForeignCall(const ForeignCall&) = delete;
  ForeignCall& operator=(const ForeignCall&) = delete;

 private:
  unsigned before_ = _mm_getcsr();
  std::uint16_t x87_ = 0;
  FloatMode expected_;  // set for the call; destroyed after the body above, when the mode is `before_` again
};

}  // namespace fulbito
