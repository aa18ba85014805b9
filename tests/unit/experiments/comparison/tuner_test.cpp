#include "experiments/comparison/tuner.hpp"

#include "tests/support/catch.hpp"

namespace fulbito {
namespace {

ComparisonConfig training() {
  ComparisonConfig config;
  config.suite = "corner";
  return config;
}

double settingOf(const std::string& specification, const std::string& name) {
  return std::stod(specification.substr(specification.find(name + "=") + name.size() + 1));
}

}  // namespace

TEST_CASE("tuning never ends worse than it began and repeats", "[unit]") {
  const TuneConfig tuning{"vector-field", 1.0, 6, 4};
  const auto first = tune(training(), tuning, {}), again = tune(training(), tuning, {});
  REQUIRE(first);
  CHECK(first->objective <= first->initial);
  CHECK(first->navigator == again->navigator);
  CHECK(first->evaluations == 6);
  CHECK(first->layouts == 12);  // in the last round
  CHECK(tune(training(), {"straight", 1.0, 6, 4}, {}).error().code == ErrorCode::kUsage);
}

TEST_CASE("tries near the best come ever nearer", "[unit]") {
  // For a range of a metre, the changes are ten centimetres at first and two millimetres at last, since
  // millimetres of a ring matter.
  CHECK(tuningSpread(0.0) == Approx(0.1));
  CHECK(tuningSpread(1.0) == Approx(0.002));
  for (double progress = 0.1; progress <= 1.0; progress += 0.1) {
    CHECK(tuningSpread(progress) < tuningSpread(progress - 0.1));
  }
}

TEST_CASE("what a specification holds is not tuned", "[unit]") {
  const auto tuned = tune(training(), {"vector-field:offset=0.03,follower=classic", 1.0, 12, 3}, {});
  REQUIRE(tuned);
  CHECK(settingOf(tuned->navigator, "offset") == 0.03);
  CHECK(tuned->navigator.find("width=") != std::string::npos);
}

TEST_CASE("tuning can be stopped", "[unit]") {
  const auto stopped =
      tune(training(), {"vector-field", 1.0, 6, 2}, [](std::size_t done, std::size_t) { return done < 2; });
  REQUIRE_FALSE(stopped);
  CHECK(stopped.error().code == ErrorCode::kInterrupted);
}

}  // namespace fulbito
