#pragma once

/// Exact sums and products as unevaluated sums of two doubles (Dekker, Numerische Mathematik 18, 1971).
/// Private to the elementary functions of math.hpp; correct only in round-to-nearest mode without overflow.
namespace fulbito::math {

/// The value high + low, where |low| is at most a few ulp of high.
struct DoubleDouble {
  double high = 0.0;
  double low = 0.0;
};

/// a + b exactly, for |a| >= |b| or a == 0.
inline DoubleDouble fastTwoSum(double a, double b) {
  const double sum = a + b;
  return {sum, (a - sum) + b};
}

/// a * b exactly, for products well inside the normal range and |a|, |b| < 2^996.
inline DoubleDouble twoProduct(double a, double b) {
  constexpr double kSplit = 0x1p27 + 1.0;
  const double a_big = kSplit * a, b_big = kSplit * b;
  const double a_high = a_big - (a_big - a), b_high = b_big - (b_big - b);
  const double a_low = a - a_high, b_low = b - b_high;
  const double product = a * b;
  return {product, ((a_high * b_high - product) + a_high * b_low + a_low * b_high) + a_low * b_low};
}

}  // namespace fulbito::math
