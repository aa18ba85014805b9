#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <thread>
#include <vector>

#include <mpfr.h>

namespace fulbito::test {

/// An MPFR number of `bits` bits that frees itself.
class Precise {
 public:
  explicit Precise(mpfr_prec_t bits) { mpfr_init2(number_, bits); }
  Precise(const Precise&) = delete;
  Precise& operator=(const Precise&) = delete;
  ~Precise() { mpfr_clear(number_); }
  operator mpfr_ptr() { return number_; }

 private:
  mpfr_t number_;
};

/// Distance of `value` from `truth` in units in the last place of the double nearest to `truth`.
inline double ulpError(double value, mpfr_srcptr truth) {
  if (!std::isfinite(value)) return INFINITY;
  if (mpfr_zero_p(truth)) return value == 0.0 ? 0.0 : INFINITY;
  Precise difference(mpfr_get_prec(truth));
  mpfr_sub_d(difference, truth, value, MPFR_RNDN);
  const long ulp_exponent = std::max<long>(mpfr_get_exp(truth) - 53, -1074);
  mpfr_mul_2si(difference, difference, -ulp_exponent, MPFR_RNDN);
  return std::abs(mpfr_get_d(difference, MPFR_RNDN));
}

/// One pair of arguments; functions of one argument ignore the second.
struct Arguments {
  double x = 0.0;
  double y = 0.0;
};

/// The largest error of a function, and its arguments.
struct Worst {
  double ulp = 0.0;
  Arguments at;
  void see(double error, Arguments arguments) {
    // A NaN error must not pass for a small one.
    if (!(error <= ulp)) *this = {std::isnan(error) ? INFINITY : error, arguments};
  }
};

/// Runs `measure(arguments, worst)` over all arguments on two threads and merges their results.
template <typename Measure>
std::vector<Worst> worstOf(const std::vector<Arguments>& all, std::size_t functions, Measure measure) {
  std::vector<Worst> halves[2] = {std::vector<Worst>(functions), std::vector<Worst>(functions)};
  const auto run = [&](std::size_t half) {
    for (std::size_t i = half; i < all.size(); i += 2) measure(all[i], halves[half]);
    mpfr_free_cache();
  };
  std::thread other(run, 1);
  run(0);
  other.join();
  for (std::size_t i = 0; i < functions; ++i) {
    if (halves[1][i].ulp > halves[0][i].ulp) halves[0][i] = halves[1][i];
  }
  return halves[0];
}

}  // namespace fulbito::test
