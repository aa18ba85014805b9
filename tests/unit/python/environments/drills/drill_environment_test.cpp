#include "python/environments/drills/drill_environment.hpp"

#include <cmath>
#include <numeric>

#include "engine/core/math/random.hpp"
#include "match/drills/trials.hpp"
#include "python/environments/sight.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/test_stream.hpp"
#include "tests/unit/python/environments/one_agent.hpp"

namespace fulbito {
namespace {

DrillSettings settingsOf(int number) {
  DrillSettings settings;
  settings.drill = *builtInDrill(number);
  settings.mates = settings.itself = *parseTeam("classic");
  return settings;
}

using Room = test::OneAgent<DrillEnvironment>;

/// Sum of all that a random agent sees and gets, to compare bits.
double randomEpisode(Room& room, const EpisodeStart& start) {
  room.begin(start);
  Rng rng(start.seed, test::kTestStream);
  double sum = 0.0;
  for (EpisodeEnd end; !end.any();) {
    std::vector<float> action(room.environment->shape().action);
    for (float& number : action) number = static_cast<float>(rng.uniform(-1.0, 1.0));
    end = room.step(action);
    for (const float number : room.observation) {
      REQUIRE(std::abs(number) <= kSightBound);
      sum += static_cast<double>(number) * 0.37;
    }
    const double reward = std::accumulate(room.terms.begin(), room.terms.end(), 0.0);
    REQUIRE(room.rewards[0] == reward);
    sum = sum * 0.9 + reward;
    REQUIRE(end.terminated != end.truncated + !end.any());
  }
  return sum;
}

/// Drives straight on.
class Straight final : public Strategy {
 public:
  void begin(const MatchInfo& info) override { speed_ = info.robot.maxSpeed(); }
  TeamCommand decide(const Observation&) override {
    TeamCommand command;
    command.robots.fill(RobotCommand::byTwist({0.5 * speed_, 0.0}));
    return command;
  }
  std::optional<ExerciseReply> exercise(const Observation& seen, const Exercise&) override {
    return ExerciseReply{decide(seen), {}};
  }

 private:
  double speed_ = 0.0;
};

}  // namespace

TEST_CASE("every drill of trials is an environment, and equal starts and actions give equal bits", "[unit]") {
  for (const Drill& drill : builtInDrills()) {
    if (drill.starts.empty()) continue;
    DrillSettings settings = settingsOf(drill.number);
    settings.ticks = 6;
    Room room(settings), other(settings);
    INFO("drill " << drill.number);
    const double first = randomEpisode(room, {11, ""});
    randomEpisode(other, {5, ""});
    CHECK(randomEpisode(other, {11, ""}) == first);
    CHECK(randomEpisode(room, {12, ""}) != first);
  }
}

TEST_CASE("the drill's own judge decides: an agent gets what a team gets that does the same", "[unit]") {
  DrillOptions options;
  options.team = TeamChoice::own("straight", [] { return std::make_unique<Straight>(); });
  const DrillRun run{options, *loadRobot("vsss"), *loadPhysics("standard")};
  for (const int number : {1, 2, 3, 4, 6, 13}) {
    DrillSettings settings = settingsOf(number);
    settings.actions = ActionForm::kTwist;
    Room room(settings);
    const auto base = drillMatch(run, settings.drill);
    for (int index = 0; index < 6; ++index) {
      const auto trial = playTrial(run, settings.drill, *base, index);
      room.begin({99, "trial " + std::to_string(index)});
      EpisodeEnd end;
      while (!end.any()) end = room.step({0.5f, 0.0f});
      INFO("drill " << number << " trial " << index);
      CHECK(room.figures[0] == (trial->success ? 1.0 : 0.0));
      if (trial->success) CHECK(room.figures[1] == trial->time);
      CHECK(room.figures[2] == trial->ideal);
      CHECK(room.figures[5] == index);
    }
  }
}

TEST_CASE("trials to train on are other ones than those of a test and of the program", "[unit]") {
  DrillSettings settings = settingsOf(3);
  Room train(settings);
  settings.split = DrillSplit::kTest;
  Room test(settings);
  train.begin({7, ""});
  test.begin({7, ""});
  CHECK(train.observation != test.observation);
  // The program plays seeds below 2^63: that of the test is among them.
  const auto number = static_cast<int>(test.figures[5]);
  const std::vector<float> seen = test.observation;
  train.begin({99, "trial " + std::to_string(number) + " of seed 7"});
  CHECK(train.observation == seen);
}

TEST_CASE("what is no trial is refused with the reason", "[unit]") {
  const auto why = [](const DrillSettings& settings) {
    return DrillEnvironment::create(settings).error().message;
  };
  CHECK(why(settingsOf(18)) ==
        "drill: 18 'discipline' plays whole matches, so it has no trials to play as episodes");
  CHECK(why(settingsOf(20)) ==
        "drill: 20 'poor-sight' repeats other drills, so it has no trials to play as episodes");
  CHECK(builtInDrill(99).error().message == "drill: there is no drill 99; numbers are 1 ... 21");
  DrillSettings settings = settingsOf(3);
  settings.ticks = 0;
  CHECK(why(settings) == "frame_skip: 0 is outside 1 ... 60");
  settings = settingsOf(3);
  settings.robot = 2;
  CHECK(why(settings) == "robot: drill 3 'empty-goal' has no own robot 2 in its start 'attack'; it has 1");
  settings = settingsOf(5);
  settings.drill.starts.front().task = DrillTask::kPlay;
  CHECK(why(settings) == "drill: 5 'prediction' mixes predictions with other tasks: their actions differ");
  Room room(settingsOf(3));
  const auto refused = room.environment->begin({1, "trial -3"}, room.view());
  CHECK(refused.error().message ==
        "start: 'trial -3' is not 'trial N' or 'trial N of seed S' with N in 0 ... 1000000000");
}

TEST_CASE("the agent drives the robot that the drill is about, and mates the others", "[unit]") {
  const auto agent = [](int number, std::size_t start) {
    const Drill drill = *builtInDrill(number);
    return *agentOf(drill, drill.starts[start], -1);
  };
  CHECK(agent(1, 0) == 0);
  CHECK(agent(3, 0) == 1);
  CHECK(agent(10, 0) == 0);
  CHECK(agent(12, 0) == 1);
  CHECK(agent(16, 0) == 1);
  CHECK(agent(16, 1) == 0);
  CHECK(agent(17, 0) == 1);
}

TEST_CASE("a predicted place is judged once, as an error of the answer", "[unit]") {
  Room room(settingsOf(5));
  CHECK(room.environment->shape().action == 2);
  room.begin({1, "trial 0"});
  EpisodeEnd end;
  while (!end.any()) end = room.step({1.0f, 1.0f});
  CHECK(end.terminated);
  CHECK(room.figures[0] == 0.0);
  CHECK(room.terms[static_cast<std::size_t>(DrillTerm::kAnswer)] < -0.2);
}

}  // namespace fulbito
