#include "engine/core/base/float_mode.hpp"

#include <fenv.h>
#include <limits>

#include "tests/support/catch.hpp"

using namespace fulbito;

namespace {

// FTZ and DAZ: results and operands below 2.2e-308 count as 0.
constexpr unsigned kFlush = 0x8040;
constexpr unsigned kUpward = 0x4000;

bool keepsSmallNumbers() {
  volatile double smallest = std::numeric_limits<double>::min();
  volatile double half = smallest / 2;
  return half > 0.0;
}

}  // namespace

TEST_CASE("whatever mode a thread is in, numbers are handled the same way, and the thread gets its mode back",
          "[unit]") {
  const unsigned before = _mm_getcsr();
  _mm_setcsr(before | kFlush | kUpward);
  CHECK_FALSE(keepsSmallNumbers());
  {
    const FloatMode mode;
    CHECK(keepsSmallNumbers());
    volatile double one = 1.0, tiny = 1e-30;
    CHECK(one + tiny == 1.0);
  }
  CHECK((_mm_getcsr() & (kFlush | kUpward)) == (kFlush | kUpward));
  _mm_setcsr(before);
}

TEST_CASE("foreign code runs in the expected mode, and whatever it leaves, the thread gets its mode back",
          "[unit]") {
  const unsigned before = _mm_getcsr();
  for (const unsigned mode : {before, before | kFlush}) {
    _mm_setcsr(mode);
    {
      const ForeignCall call;
      CHECK(keepsSmallNumbers());
      fesetround(FE_UPWARD);  // changes the mode of the x87 unit too
      _mm_setcsr(_mm_getcsr() | kFlush);
    }
    CHECK(_mm_getcsr() == mode);
    volatile long double one = 1.0L, tiny = 1e-30L;
    CHECK(one + tiny == 1.0L);
  }
  _mm_setcsr(before);
}
