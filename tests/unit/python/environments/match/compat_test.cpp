#include "python/environments/match/compat.hpp"

#include <fstream>

#include <nlohmann/json.hpp>

#include "fulbito/detail/math.hpp"
#include "tests/support/catch.hpp"

namespace fulbito {
namespace {

using nlohmann::json;

const json& states() {
  static const json all = json::parse(
      std::ifstream(FULBITO_SOURCE_DIR "/tests/unit/python/environments/match/rsoccer_states.json"));
  return all.at("states");
}

BallState ballOf(const json& b) { return {{b[0], b[1]}, {b[2], b[3]}, {}}; }

RobotState robotOf(const json& r) {
  const double degree = math::kPi / 180.0;
  return {{{r[0], r[1]}, r[2].get<double>() * degree}, {r[3], r[4]}, r[5].get<double>() * degree, {}};
}

Observation observationOf(const json& state) {
  Observation seen;
  seen.ball = ballOf(state["ball"]);
  for (std::size_t i = 0; i < 3; ++i) {
    seen.own[i] = {true, robotOf(state["blue"][i])};
    seen.opponents[i] = {true, robotOf(state["yellow"][i])};
  }
  return seen;
}

}  // namespace

TEST_CASE("observations are those of rSoccer", "[unit]") {
  for (const json& state : states()) {
    std::array<float, kCompatNumbers> ours{};
    writeCompat(observationOf(state), ours);
    for (std::size_t i = 0; i < ours.size(); ++i) {
      INFO(i);
      CHECK(ours[i] == Approx(state["observation"][i].get<double>()).margin(2e-6));
    }
  }
}

TEST_CASE("wheel speeds are those of rSoccer", "[unit]") {
  for (const json& state : states()) {
    const std::array<float, 2> action{state["action"][0], state["action"][1]};
    const WheelSpeeds wheels = compatWheels(RobotModel{}, action);
    CHECK(wheels.left == Approx(state["wheels"][0].get<double>()).margin(1e-4));
    CHECK(wheels.right == Approx(state["wheels"][1].get<double>()).margin(1e-4));
  }
}

TEST_CASE("rewards and their terms are those of rSoccer", "[unit]") {
  int goals = 0;
  for (const json& state : states()) {
    CompatReward reward{FieldGeometry{}};
    std::array<double, kCompatTerms> terms{};
    CompatMoment moment;
    moment.step = 0.025;
    moment.ball = ballOf(state["ball_before"]);
    reward.begin();
    reward.step(moment, terms);
    const std::array<double, kCompatFigures> before = reward.sums();
    terms.fill(0.0);
    moment.ball = ballOf(state["ball"]);
    moment.robot = robotOf(state["blue"][0]);
    moment.wheels = {state["wheels"][0], state["wheels"][1]};
    const bool goal = reward.step(moment, terms);
    CHECK(goal == state["goal"].get<bool>());
    goals += goal ? 1 : 0;
    CHECK(terms[0] + terms[1] + terms[2] + terms[3] == Approx(state["reward"].get<double>()).margin(1e-9));
    const char* names[] = {"goal_score", "move", "ball_grad", "energy", "goals_blue", "goals_yellow"};
    for (std::size_t i = 0; i < kCompatFigures; ++i) {
      INFO(names[i]);
      CHECK(reward.sums()[i] - before[i] == Approx(state["terms"][names[i]].get<double>()).margin(1e-9));
    }
  }
  CHECK(goals == 2);
}

}  // namespace fulbito
