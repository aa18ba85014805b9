#include "fulbito/detail/math.hpp"

#include <cmath>
#include <limits>
#include <vector>

#include "engine/core/math/random.hpp"
#include "fulbito/detail/state_hash.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/test_stream.hpp"

namespace fulbito {
namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kPi = math::kPi;

/// Equal, with the same sign of zero.
bool same(double a, double b) { return a == b && std::signbit(a) == std::signbit(b); }

TEST_CASE("trigonometry of NaN and infinity is NaN", "[unit]") {
  for (double x : {kNaN, kInf, -kInf}) {
    CHECK(std::isnan(math::sin(x)));
    CHECK(std::isnan(math::cos(x)));
    CHECK(std::isnan(math::tan(x)));
    CHECK(std::isnan(math::sinCos(x).sin));
    CHECK(std::isnan(math::sinCos(x).cos));
    CHECK(std::isnan(math::wrapAngle(x)));
  }
}

TEST_CASE("sine and tangent keep the sign of zero and of the smallest numbers", "[unit]") {
  for (double x : {0.0, -0.0, 0x1p-1074, -0x1p-1074, 0x1p-30, -0x1p-30}) {
    CHECK(same(math::sin(x), x));
    CHECK(same(math::tan(x), x));
    CHECK(same(math::sinCos(x).sin, x));
    CHECK(math::cos(x) == 1.0);
    CHECK(same(math::asin(x), x));
  }
}

TEST_CASE("sine is odd and cosine even, bit for bit", "[unit]") {
  Rng rng(1, test::kTestStream);
  for (int i = 0; i < 10000; ++i) {
    const double x = rng.uniform(0.0, i % 2 == 0 ? 10.0 : 1e9);
    REQUIRE(math::sin(-x) == -math::sin(x));
    REQUIRE(math::cos(-x) == math::cos(x));
    REQUIRE(math::tan(-x) == -math::tan(x));
  }
}

TEST_CASE("atan2 has the zeros, quadrants and infinities of C Annex F", "[unit]") {
  struct Row {
    double y, x, angle;
  };
  const double t = 2.5;
  const std::vector<Row> rows = {{0.0, 0.0, 0.0},
                                 {0.0, -0.0, kPi},
                                 {0.0, t, 0.0},
                                 {0.0, -t, kPi},
                                 {t, 0.0, kPi / 2},
                                 {t, -0.0, kPi / 2},
                                 {t, kInf, 0.0},
                                 {t, -kInf, kPi},
                                 {kInf, t, kPi / 2},
                                 {kInf, -t, kPi / 2},
                                 {kInf, kInf, kPi / 4},
                                 {kInf, -kInf, 3 * kPi / 4},
                                 {t, t, kPi / 4},
                                 {t, -t, 3 * kPi / 4},
                                 {0x1p-1074, 0x1p-1074, kPi / 4},
                                 {0x1p1023, 0x1p1023, kPi / 4},
                                 {0x1p-1074, 0x1p1023, 0.0},
                                 {0x1p-1074, -0x1p1023, kPi}};
  for (const Row& row : rows) {
    CAPTURE(row.y, row.x);
    CHECK(same(math::atan2(row.y, row.x), row.angle));
    CHECK(same(math::atan2(-row.y, row.x), -row.angle));
  }
  CHECK(std::isnan(math::atan2(kNaN, 1.0)));
  CHECK(std::isnan(math::atan2(1.0, kNaN)));
}

TEST_CASE("asin and acos meet their ends and refuse what lies beyond", "[unit]") {
  CHECK(math::asin(1.0) == kPi / 2);
  CHECK(math::asin(-1.0) == -kPi / 2);
  CHECK(same(math::acos(1.0), 0.0));
  CHECK(math::acos(-1.0) == kPi);
  CHECK(math::acos(0.0) == kPi / 2);
  CHECK(math::acos(-0.0) == kPi / 2);
  for (double x : {std::nextafter(1.0, 2.0), -1.5, kInf, -kInf, kNaN}) {
    CHECK(std::isnan(math::asin(x)));
    CHECK(std::isnan(math::acos(x)));
  }
}

TEST_CASE("exp overflows to infinity and underflows through subnormals to zero", "[unit]") {
  CHECK(math::exp(0.0) == 1.0);
  CHECK(math::exp(-0.0) == 1.0);
  CHECK(math::exp(kInf) == kInf);
  CHECK(same(math::exp(-kInf), 0.0));
  CHECK(std::isnan(math::exp(kNaN)));
  CHECK(std::isfinite(math::exp(0x1.62e42fefa39efp+9)));  // the largest x with a finite result
  CHECK(math::exp(0x1.62e42fefa39fp+9) == kInf);
  CHECK(math::exp(-745.0) == 0x1p-1074);
  CHECK(same(math::exp(-745.2), 0.0));
  CHECK(math::exp(1e300) == kInf);
  CHECK(same(math::exp(-1e300), 0.0));
}

TEST_CASE("log has a pole at zero and no value below", "[unit]") {
  CHECK(same(math::log(1.0), 0.0));
  CHECK(math::log(0.0) == -kInf);
  CHECK(math::log(-0.0) == -kInf);
  CHECK(math::log(kInf) == kInf);
  for (double x : {-1.0, -0x1p-1074, -kInf, kNaN}) CHECK(std::isnan(math::log(x)));
}

TEST_CASE("pow has the zeros, infinities and signs of C Annex F", "[unit]") {
  const double big = 1e300, even = 4.0, odd = 3.0, broken = 2.5;
  struct Row {
    double x, y, result;
  };
  const std::vector<Row> rows = {{kNaN, 0.0, 1.0},      {kNaN, -0.0, 1.0},
                                 {1.0, kNaN, 1.0},      {1.0, kInf, 1.0},
                                 {-1.0, kInf, 1.0},     {-1.0, -kInf, 1.0},
                                 {0.0, -odd, kInf},     {-0.0, -odd, -kInf},
                                 {0.0, -even, kInf},    {-0.0, -even, kInf},
                                 {-0.0, -broken, kInf}, {0.0, -kInf, kInf},
                                 {-0.0, -kInf, kInf},   {0.0, odd, 0.0},
                                 {-0.0, odd, -0.0},     {-0.0, even, 0.0},
                                 {-0.0, broken, 0.0},   {0.5, -kInf, kInf},
                                 {-0.5, -kInf, kInf},   {2.0, -kInf, 0.0},
                                 {-2.0, -kInf, 0.0},    {0.5, kInf, 0.0},
                                 {2.0, kInf, kInf},     {-kInf, -odd, -0.0},
                                 {-kInf, -even, 0.0},   {-kInf, -broken, 0.0},
                                 {-kInf, odd, -kInf},   {-kInf, even, kInf},
                                 {-kInf, broken, kInf}, {kInf, -broken, 0.0},
                                 {kInf, broken, kInf},  {kInf, -kInf, 0.0},
                                 {kInf, kInf, kInf},    {-1.0, big, 1.0},
                                 {-1.0, odd, -1.0},     {-1.0, -odd, -1.0},
                                 {2.0, big, kInf},      {2.0, -big, 0.0},
                                 {0.5, big, 0.0},       {-2.0, 1025.0, -kInf},
                                 {-2.0, -1077.0, -0.0}, {2.0, -1074.0, 0x1p-1074},
                                 {2.0, 10.0, 1024.0},   {-2.0, odd, -8.0},
                                 {3.0, 0x1p-1074, 1.0}, {0x1.fffffffffffffp-1, 0x1p900, 0.0}};
  for (const Row& row : rows) {
    CAPTURE(row.x, row.y);
    CHECK(same(math::pow(row.x, row.y), row.result));
  }
  for (const auto& [x, y] : {std::pair{-2.0, broken}, {-0.5, 1e-300}, {kNaN, 1.0}, {2.0, kNaN}, {0.0, kNaN}})
    CHECK(std::isnan(math::pow(x, y)));
}

TEST_CASE("pow of whole numbers with whole exponents is exact", "[unit]") {
  for (int base = 2; base <= 12; ++base) {
    double exact = 1.0;
    for (int exponent = 1; exact * base < 0x1p53; ++exponent) {
      exact *= base;
      CAPTURE(base, exponent);
      CHECK(math::pow(base, exponent) == exact);
      CHECK(math::pow(-base, exponent) == (exponent % 2 == 0 ? exact : -exact));
    }
  }
}

TEST_CASE("huge angles have their published sines and cosines", "[unit]") {
  CHECK(math::sin(0x1.6ac5b262ca1ffp+849) == 1.0);
  CHECK(math::cos(0x1.6ac5b262ca1ffp+849) ==
        -4.68716592425462761112e-19);  // Kahan: next to a multiple of pi / 2
  CHECK(math::sin(1e22) == -0.8522008497671888018);
}

TEST_CASE("the bits of every function are the same for any compiler, level and CPU", "[unit]") {
  Rng rng(3, test::kTestStream);
  StateHash hash;
  for (int i = 0; i < 20000; ++i) {
    const double x = rng.uniform(-1.0, 1.0), y = rng.uniform(-1.0, 1.0), size = std::ldexp(1.0, i % 64 - 8);
    for (double value : {math::sin(x * size), math::cos(x * size), math::tan(x * size), math::atan2(x, y),
                         math::asin(x), math::acos(x), math::exp(700.0 * x), math::log(size * std::abs(x)),
                         math::pow(std::abs(x), 100.0 * y), math::wrapAngle(x * size), rng.normal()})
      hash.add(value);
  }
  CHECK(hash.value() == 0x45ad8131f4467c4bu);
}

TEST_CASE("a wrapped angle lies in [-pi, pi) for every finite angle", "[unit]") {
  Rng rng(2, test::kTestStream);
  std::vector<double> angles = {0.0, -0.0, 0x1p-1074, 1e308, -1e308, 1e22, 0x1p53};
  for (int k = -200; k <= 200; ++k) {
    for (double x : {k * kPi, k * kPi / 2})
      for (double to : {-kInf, kInf}) angles.insert(angles.end(), {x, std::nextafter(x, to)});
  }
  for (int i = 0; i < 20000; ++i) {
    const double size = std::ldexp(1.0, static_cast<int>(rng.below(1030)) - 7);
    angles.push_back(rng.uniform(-size, size));
    angles.push_back(rng.uniform(-10.0, 10.0));
    angles.push_back(2 * kPi + std::ldexp(rng.uniform(-1.0, 1.0), -static_cast<int>(rng.below(50))));
  }
  for (double angle : angles) {
    const double wrapped = math::wrapAngle(angle);
    CAPTURE(angle, wrapped);
    REQUIRE(wrapped >= -kPi);
    REQUIRE(wrapped < kPi);
    // The same direction: half an ulp of the wrapped angle and the errors of the two sines.
    REQUIRE(std::abs(math::sin(wrapped) - math::sin(angle)) < 5e-16);
    REQUIRE(std::abs(math::cos(wrapped) - math::cos(angle)) < 5e-16);
  }
}

TEST_CASE("wrapping keeps what is in range and takes pi to -pi", "[unit]") {
  for (double angle : {0.0, -0.0, 1.0, -kPi, std::nextafter(kPi, 0.0)})
    CHECK(same(math::wrapAngle(angle), angle));
  CHECK(math::wrapAngle(kPi) == -kPi);
  CHECK(math::wrapAngle(-kPi - 1e-15) == Approx(kPi).margin(2e-15));
  CHECK(math::wrapAngle(4.0) == Approx(4.0 - 2 * kPi).margin(1e-15));
  CHECK(math::wrapAngle(-4.0) == Approx(2 * kPi - 4.0).margin(1e-15));
}

TEST_CASE("unit vectors and directions are each other's inverse", "[unit]") {
  for (double angle : {0.0, 0.5, 2.0, 3.1, -0.5, -2.0, -3.1}) {
    const Vec2 v = math::unit(angle);
    CHECK(norm(v) == Approx(1.0).margin(1e-15));
    CHECK(math::angleOf(v * 3.0) == Approx(angle).margin(1e-15));
  }
  CHECK(math::angleOf({0.0, 0.0}) == 0.0);
}

}  // namespace
}  // namespace fulbito
