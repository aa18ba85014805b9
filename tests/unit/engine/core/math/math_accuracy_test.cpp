#include "tests/unit/engine/core/math/math_accuracy.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string>

#include "engine/core/math/random.hpp"
#include "fulbito/detail/math.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/test_stream.hpp"

// Every function against MPFR on 400,000 arguments. `math_test "[accuracy]" -s` prints the largest errors.

namespace fulbito {
namespace {

using test::Arguments;
using test::Precise;
using test::ulpError;
using test::Worst;

constexpr int kArguments = 400'000;
constexpr double kBound = 2.0;  // [ulp], what math.hpp promises
constexpr mpfr_prec_t kBits = 70;

double signOf(Rng& rng) { return rng.below(2) == 0 ? 1.0 : -1.0; }

/// +-2^e with e uniform in [low, high).
double logUniform(Rng& rng, double low, double high) {
  const double e = rng.uniform(low, high);
  const double whole = std::floor(e);
  return signOf(rng) * std::ldexp(1.0 + (e - whole), static_cast<int>(whole));
}

/// `x` (not 0) moved by up to `steps` neighbouring doubles either way.
double nudged(Rng& rng, double x, std::uint32_t steps) {
  return std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) + rng.below(2 * steps + 1) - steps);
}

template <typename Draw>
std::vector<Arguments> draw(std::uint64_t index, Draw one) {
  Rng rng(20240607, test::kTestStream, index);
  std::vector<Arguments> all;
  all.reserve(kArguments);
  for (int i = 0; i < kArguments; ++i) all.push_back(one(rng, i % 4));
  return all;
}

void checkAll(const std::vector<std::string>& names, const std::vector<Worst>& worst, double bound = kBound) {
  for (std::size_t i = 0; i < names.size(); ++i) {
    char line[160];
    std::snprintf(line, sizeof line, "%-8s max %.4f ulp at (%a, %a)", names[i].c_str(), worst[i].ulp,
                  worst[i].at.x, worst[i].at.y);
    INFO(line);
    CHECK(worst[i].ulp > 0.0);  // an error of 0 means that the function was not measured
    CHECK(worst[i].ulp <= bound);
  }
}

void measureTrigonometry(Arguments a, std::vector<Worst>& worst) {
  thread_local Precise x(53), s(kBits), c(kBits), t(kBits);
  mpfr_set_d(x, a.x, MPFR_RNDN);
  mpfr_sin_cos(s, c, x, MPFR_RNDN);
  mpfr_div(t, s, c, MPFR_RNDN);
  worst[0].see(ulpError(math::sin(a.x), s), a);
  worst[1].see(ulpError(math::cos(a.x), c), a);
  worst[2].see(ulpError(math::tan(a.x), t), a);
  const math::SinCos both = math::sinCos(a.x);
  worst[3].see(both.sin == math::sin(a.x) && both.cos == math::cos(a.x) ? worst[0].ulp : INFINITY, a);
}

const std::vector<std::string> kTrigonometry = {"sin", "cos", "tan", "sinCos"};

TEST_CASE("sine, cosine and tangent are within 2 ulp up to a million", "[unit][accuracy]") {
  const auto arguments = draw(1, [](Rng& rng, int kind) -> Arguments {
    switch (kind) {
      case 0:
        return {rng.uniform(-4.0, 4.0)};
      case 1:
        return {rng.uniform(-1e6, 1e6)};
      case 2:
        return {logUniform(rng, -40.0, 19.9)};
      default:  // next to a multiple of pi / 2
        return {nudged(rng, signOf(rng) * (1 + rng.below(600000)) * (math::kPi / 2), 3)};
    }
  });
  checkAll(kTrigonometry, worstOf(arguments, 4, measureTrigonometry));
}

TEST_CASE("sine, cosine and tangent are within 2 ulp for any size of angle", "[unit][accuracy]") {
  auto arguments = draw(2, [](Rng& rng, int) -> Arguments { return {logUniform(rng, 19.0, 1023.9)}; });
  arguments.resize(kArguments / 20);
  // The double next to a multiple of pi / 2 (Kahan), the largest double, and both sides of the quick path's
  // end.
  for (double x :
       {0x1.6ac5b262ca1ffp+849, 0x1.fffffffffffffp+1023, 0x1p20, 0x1.fffffffffffffp+19, 0.75, 0.7500000001})
    arguments.push_back({x});
  checkAll(kTrigonometry, worstOf(arguments, 4, measureTrigonometry));
}

TEST_CASE("atan2 is within 2 ulp", "[unit][accuracy]") {
  const auto arguments = draw(3, [](Rng& rng, int kind) -> Arguments {
    switch (kind) {
      case 0:
        return {rng.uniform(-1.0, 1.0), rng.uniform(-1.0, 1.0)};
      case 1:
        return {logUniform(rng, -30.0, 30.0), logUniform(rng, -30.0, 30.0)};
      case 2:
        return {logUniform(rng, -1070.0, 1023.0), logUniform(rng, -1070.0, 1023.0)};
      default: {  // next to the edges between the table's entries
        const double x = signOf(rng) * rng.uniform(1.0, 2.0);
        const double edge = (rng.below(33) + 1) / 32.0;
        return {nudged(rng, x * edge, 3), x};
      }
    }
  });
  checkAll({"atan2"}, worstOf(arguments, 1, [](Arguments a, std::vector<Worst>& worst) {
             thread_local Precise y(53), x(53), truth(kBits);
             mpfr_set_d(y, a.y, MPFR_RNDN);
             mpfr_set_d(x, a.x, MPFR_RNDN);
             mpfr_atan2(truth, x, y, MPFR_RNDN);
             worst[0].see(ulpError(math::atan2(a.x, a.y), truth), a);
           }));
}

TEST_CASE("asin and acos are within 2 ulp", "[unit][accuracy]") {
  const auto arguments = draw(4, [](Rng& rng, int kind) -> Arguments {
    switch (kind) {
      case 0:
        return {rng.uniform(-1.0, 1.0)};
      case 1:
        return {logUniform(rng, -40.0, -0.001)};
      case 2:
        return {nudged(rng, signOf(rng) * 0.5, 1000)};
      default:
        return {signOf(rng) * (1.0 - std::abs(logUniform(rng, -53.0, -1.0)))};
    }
  });
  checkAll({"asin", "acos"}, worstOf(arguments, 2, [](Arguments a, std::vector<Worst>& worst) {
             // Next to 1, pi / 2 - asin(x) cancels 27 bits.
             thread_local Precise x(53), truth(kBits + 28), right_angle(kBits + 28);
             mpfr_set_d(x, a.x, MPFR_RNDN);
             mpfr_asin(truth, x, MPFR_RNDN);
             worst[0].see(ulpError(math::asin(a.x), truth), a);
             mpfr_const_pi(right_angle, MPFR_RNDN);
             mpfr_div_2ui(right_angle, right_angle, 1, MPFR_RNDN);
             mpfr_sub(truth, right_angle, truth, MPFR_RNDN);
             worst[1].see(ulpError(math::acos(a.x), truth), a);
           }));
}

TEST_CASE("exp is within 2 ulp, also where the result is subnormal", "[unit][accuracy]") {
  const auto arguments = draw(5, [](Rng& rng, int kind) -> Arguments {
    switch (kind) {
      case 0:
        return {rng.uniform(-10.0, 10.0)};
      case 1:
        return {rng.uniform(-745.0, 709.78)};
      case 2:
        return {logUniform(rng, -60.0, 9.35)};
      default:
        return {nudged(rng, signOf(rng) * (1 + rng.below(130000)) * (std::log(2.0) / 128), 3)};
    }
  });
  checkAll({"exp"}, worstOf(arguments, 1, [](Arguments a, std::vector<Worst>& worst) {
             thread_local Precise x(53), truth(kBits);
             mpfr_set_d(x, a.x, MPFR_RNDN);
             mpfr_exp(truth, x, MPFR_RNDN);
             worst[0].see(ulpError(math::exp(a.x), truth), a);
           }));
}

TEST_CASE("log is within 2 ulp", "[unit][accuracy]") {
  const auto arguments = draw(6, [](Rng& rng, int kind) -> Arguments {
    switch (kind) {
      case 0:
        return {rng.uniform(0.9, 1.1)};
      case 1:
        return {std::abs(logUniform(rng, -1074.0, 1024.0))};
      case 2:
        return {1.0 + logUniform(rng, -52.0, -1.0)};
      default:
        return {nudged(rng, 0.5 + rng.below(257) / 128.0, 1000)};  // next to the table's edges
    }
  });
  checkAll({"log"}, worstOf(arguments, 1, [](Arguments a, std::vector<Worst>& worst) {
             thread_local Precise x(53), truth(kBits);
             mpfr_set_d(x, a.x, MPFR_RNDN);
             mpfr_log(truth, x, MPFR_RNDN);
             worst[0].see(ulpError(math::log(a.x), truth), a);
           }));
}

TEST_CASE("pow is within 2 ulp for normal results", "[unit][accuracy]") {
  const auto arguments = draw(7, [](Rng& rng, int kind) -> Arguments {
    switch (kind) {
      case 0:
        return {rng.uniform(0.0, 10.0), rng.uniform(-10.0, 10.0)};
      case 1: {  // any base, results over the whole range
        const double x = std::abs(logUniform(rng, -1074.0, 1024.0));
        return {x, rng.uniform(-708.0, 709.0) / std::log(x)};
      }
      case 2: {  // bases next to 1 with large exponents
        const double x = 1.0 + logUniform(rng, -52.0, -2.0);
        return {x, rng.uniform(-708.0, 709.0) / std::log(x)};
      }
      default:
        return {-rng.uniform(0.1, 20.0), static_cast<double>(rng.below(400)) - 200.0};
    }
  });
  checkAll({"pow"}, worstOf(arguments, 1, [](Arguments a, std::vector<Worst>& worst) {
             thread_local Precise x(53), y(53), truth(kBits);
             mpfr_set_d(x, a.x, MPFR_RNDN);
             mpfr_set_d(y, a.y, MPFR_RNDN);
             mpfr_pow(truth, x, y, MPFR_RNDN);
             if (mpfr_get_exp(truth) < -1021 || mpfr_get_exp(truth) > 1024) return;
             worst[0].see(ulpError(math::pow(a.x, a.y), truth), a);
           }));
}

}  // namespace
}  // namespace fulbito
