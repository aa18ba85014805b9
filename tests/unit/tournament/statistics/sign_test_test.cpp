#include "tournament/statistics/sign_test.hpp"

#include <vector>

#include "tests/support/catch.hpp"

using namespace fulbito;

TEST_CASE("the sign test has the binomial distribution's exact values", "[unit]") {
  CHECK(signTest(0, 0) == 1.0);
  CHECK(signTest(5, 5) == 1.0);
  CHECK(signTest(1, 0) == 1.0);
  CHECK(signTest(5, 0) == Approx(2.0 / 32));
  CHECK(signTest(8, 2) == Approx(2.0 * (1 + 10 + 45) / 1024));  // 0.109375
  CHECK(signTest(2, 8) == signTest(8, 2));
  CHECK(signTest(15, 5) == Approx(2.0 * 21700 / 1048576));  // 0.0413895
}

TEST_CASE("the sign test of many results is that of the normal distribution", "[unit]") {
  // 500,980 wins of 1,000,000 are (980 - 1/2) / 500 = 1.959 standard deviations, with the continuity
  // correction.
  CHECK(signTest(500'980, 499'020) == Approx(0.0501142).epsilon(2e-3));
  CHECK(signTest(1'000'000, 0) >= 0.0);
  CHECK(signTest(1'000'000, 0) < 1e-300);
}

TEST_CASE("Holm's correction multiplies by the number of tests left, and never falls", "[unit]") {
  const std::vector<double> p{0.01, 0.04, 0.03, 0.005};
  const std::vector<double> corrected = holm(p);
  CHECK(corrected[3] == Approx(0.02));  // 4 x 0.005
  CHECK(corrected[0] == Approx(0.03));  // 3 x 0.01
  CHECK(corrected[2] == Approx(0.06));  // 2 x 0.03
  CHECK(corrected[1] == Approx(0.06));  // 1 x 0.04 would be less
  CHECK(holm(std::vector<double>{0.6, 0.7}) == std::vector<double>{1.0, 1.0});
  CHECK(holm({}).empty());
}
