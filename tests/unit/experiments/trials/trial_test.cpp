#include "experiments/comparison/comparison_parts.hpp"
#include "experiments/trials/navigation_trial.hpp"
#include "experiments/trials/suite_layouts.hpp"
#include "fulbito/experiment.hpp"
#include "tests/support/catch.hpp"

namespace fulbito {
namespace {

TrialConfig cornerTrial(const std::string& navigator, double speed) {
  TrialConfig config;
  config.layout = cornerLayout(2015, 3);
  config.field = *loadField(config.layout.field);
  config.robot = robotAt(*loadRobot("jung-lee-2015"), speed);
  config.physics = *loadPhysics("standard");
  config.navigator = *parseNavigator(navigator);
  return config;
}

}  // namespace

TEST_CASE("the default navigator drives a corner layout in the world without a contact", "[unit]") {
  const auto result = runTrial(cornerTrial(kDefaultNavigator, 1.0), {});
  REQUIRE(result);
  CHECK(result->score.outcome == TrialOutcome::kReached);
  CHECK(result->score.obstacle_contacts == 0);
  CHECK(result->score.timeRatio() < 1.15);
  CHECK(result->score.lengthRatio() < 1.05);
  CHECK(result->score.min_clearance > 0.0);
  CHECK(result->compute_us.empty());
  CHECK(result->trace.size() > 60);
}

TEST_CASE("a trial repeats to the bit, and its seed changes nothing but the noise", "[unit]") {
  TrialConfig config = cornerTrial("bezier", 2.6);
  const auto first = runTrial(config, {}), again = runTrial(config, {});
  REQUIRE(first);
  REQUIRE(again);
  CHECK(first->final_hash == again->final_hash);
  config.seed = 99;
  CHECK(runTrial(config, {})->final_hash == first->final_hash);
  config.sensors.position_noise = 0.002;
  const auto noisy = runTrial(config, {});
  CHECK(noisy->final_hash != first->final_hash);
  CHECK(runTrial(config, {})->final_hash == noisy->final_hash);
}

TEST_CASE("a caller that drives a trial tick by tick gets what the program gets", "[unit]") {
  TrialConfig config = cornerTrial("bezier", 2.6);
  config.sensors.position_noise = 0.002;
  const auto played = runTrial(config, {});
  auto trial = NavigationTrial::create(config);
  REQUIRE(trial);
  auto pilot = makePilot(config.navigator);
  std::size_t steps = 0;
  while (!trial->over()) {
    const bool goes_on = trial->step((*pilot)->drive(trial->observe()));
    CHECK(goes_on == !trial->over());
    ++steps;
  }
  CHECK(trial->hash() == played->final_hash);
  CHECK(trial->score().time == played->score.time);
  CHECK(steps + 1 == played->trace.size());
}

TEST_CASE("a robot that avoids nothing runs into the ball on its line", "[unit]") {
  TrialConfig config = cornerTrial("straight", 1.0);
  config.layout.obstacles.resize(1);
  config.layout.obstacles[0].pose.position = (config.layout.start.position + config.layout.goal) * 0.5;
  const auto result = runTrial(config, {});
  REQUIRE(result);
  CHECK(result->score.outcome == TrialOutcome::kCollided);
  CHECK(result->score.own_contacts >= 1);
  CHECK(result->score.contact_impulse > 0.01);
}

TEST_CASE("latency that is rolled forward costs a little time and no safety", "[unit]") {
  TrialConfig config = cornerTrial(kDefaultNavigator, 1.0);
  const auto prompt = runTrial(config, {});
  config.sensors.latency_ticks = 3;
  const auto late = runTrial(config, {});
  REQUIRE(late);
  CHECK(late->score.outcome == TrialOutcome::kReached);
  CHECK(late->score.time < 1.10 * prompt->score.time);
}

TEST_CASE("impossible trials are refused with the reason", "[unit]") {
  TrialConfig config = cornerTrial("bezier", 1.0);
  config.sensors.latency_ticks = -1;
  CHECK(runTrial(config, {}).error().message == "latency: -1 is outside 0 ... 60 ticks");
  config = cornerTrial("bezier", 20.0);
  CHECK(runTrial(config, {}).error().message == "speed: 20 is outside 0.05 ... 10 m/s");
  config = cornerTrial("bezier", 1.0);
  config.layout.start.position = {5.0, 0.0};
  CHECK_FALSE(runTrial(config, {}));
}

}  // namespace fulbito
