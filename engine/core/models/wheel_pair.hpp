#pragma once

#include <emmintrin.h>

namespace fulbito {

/// One quantity of the left and of the right wheel. Each operation computes both at once, which halves the
/// cost of a drive step, and treats both alike to the last bit.
class WheelPair {
 public:
  WheelPair(double left, double right) : both_(_mm_set_pd(right, left)) {}
  explicit WheelPair(double each) : both_(_mm_set1_pd(each)) {}

  double left() const { return _mm_cvtsd_f64(both_); }
  double right() const { return _mm_cvtsd_f64(_mm_unpackhi_pd(both_, both_)); }

  friend WheelPair operator+(WheelPair a, WheelPair b) { return WheelPair(_mm_add_pd(a.both_, b.both_)); }
  friend WheelPair operator-(WheelPair a, WheelPair b) { return WheelPair(_mm_sub_pd(a.both_, b.both_)); }
  friend WheelPair operator*(WheelPair a, WheelPair b) { return WheelPair(_mm_mul_pd(a.both_, b.both_)); }
  friend WheelPair operator/(WheelPair a, WheelPair b) { return WheelPair(_mm_div_pd(a.both_, b.both_)); }
  WheelPair operator-() const { return WheelPair(_mm_xor_pd(both_, _mm_set1_pd(-0.0))); }

  /// Each wheel's value for the other one.
  WheelPair swapped() const { return WheelPair(_mm_shuffle_pd(both_, both_, 1)); }
  /// The left wheel's value negated: a turn moves the two wheels in opposite directions.
  WheelPair mirrored() const { return WheelPair(_mm_xor_pd(both_, _mm_set_pd(0.0, -0.0))); }
  /// The sum of both, for each.
  WheelPair sum() const { return *this + swapped(); }
  WheelPair abs() const { return WheelPair(_mm_andnot_pd(_mm_set1_pd(-0.0), both_)); }
  /// As `std::clamp` and `std::max`: NaN stays NaN.
  WheelPair clamped(WheelPair least, WheelPair most) const {
    return WheelPair(_mm_min_pd(most.both_, atLeast(least).both_));
  }
  WheelPair atLeast(WheelPair least) const { return WheelPair(_mm_max_pd(least.both_, both_)); }
  /// Each value with the sign of another one.
  WheelPair withSign(WheelPair sign) const {
    const __m128d only_sign = _mm_and_pd(sign.both_, _mm_set1_pd(-0.0));
    return WheelPair(_mm_or_pd(abs().both_, only_sign));
  }
  /// Each value where `a` is below `b`, else 0.
  WheelPair whereBelow(WheelPair a, WheelPair b) const {
    return WheelPair(_mm_and_pd(both_, _mm_cmplt_pd(a.both_, b.both_)));
  }
  /// Each value where `a` equals `b`, else 0.
  WheelPair whereEqual(WheelPair a, WheelPair b) const {
    return WheelPair(_mm_and_pd(both_, _mm_cmpeq_pd(a.both_, b.both_)));
  }
  /// Each value where `a` differs from 0, else 0.
  WheelPair whereAny(WheelPair a) const {
    return WheelPair(_mm_and_pd(both_, _mm_cmpneq_pd(a.both_, _mm_setzero_pd())));
  }

 private:
  explicit WheelPair(__m128d both) : both_(both) {}

  __m128d both_;
};

}  // namespace fulbito
