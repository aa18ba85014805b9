#include "python/environments/match/environment.hpp"

#include "fulbito/detail/math.hpp"
#include "python/environments/match/starts.hpp"
#include "tests/support/allocation_counter.hpp"
#include "tests/support/catch.hpp"

namespace fulbito {
namespace {

MatchTask taskOf(const std::string& blue = "idle", const std::string& yellow = "idle") {
  MatchTask task;
  task.match = *MatchConfig::standard(blue, yellow);
  task.navigator = *parseNavigator("straight");
  task.agents[0][0] = true;
  task.start = StartForm::kRandom;
  return task;
}

/// An environment with the arrays that it writes.
struct Played {
  explicit Played(const MatchTask& task) : environment(std::move(*MatchEnvironment::create(task))) {
    const EpisodeShape& shape = environment->shape();
    seen.resize(shape.agents * shape.observation);
    rewards.resize(shape.agents);
    terms.resize(shape.agents * shape.terms.size());
    figures.resize(shape.figures.size());
  }
  EpisodeView view() { return {seen, rewards, terms, figures}; }
  EpisodeEnd step(std::span<const float> actions) { return *environment->step(actions, view()); }

  std::unique_ptr<MatchEnvironment> environment;
  std::vector<float> seen;
  std::vector<double> rewards, terms, figures;
};

}  // namespace

TEST_CASE("steps of an environment allocate nothing once warm", "[unit]") {
  MatchTask task = taskOf("random", "random");
  task.stack = 3;
  Played played(task);
  const std::array<float, 2> action{0.7f, 0.4f};
  REQUIRE(played.environment->begin({3, ""}, played.view()));
  bool over = false;
  for (int i = 0; i < 100; ++i) over = over || played.step(action).any();
  const auto before = allocationCount();
  int plays = played.environment->match()->edits();
  for (int i = 0; i < 100 && !over; ++i) {
    const RestartKind kind = played.environment->match()->referee().last.kind;
    over = played.step(action).any();
    plays += played.environment->match()->referee().last.kind != kind ? 1 : 0;
  }
  REQUIRE(plays == 0);
  CHECK(allocationCount() == before);
}

TEST_CASE("random starts differ by their seed and have room for all", "[unit]") {
  const MatchTask task = taskOf();
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const auto placement = randomPlacement(task.match, seed);
    REQUIRE(placement);
    std::vector<Vec2> places{placement->ball};
    for (const auto& team : placement->robots) {
      for (const auto& pose : team) {
        if (pose) places.push_back(pose->position);
      }
    }
    REQUIRE(places.size() == 7);
    for (std::size_t i = 0; i < places.size(); ++i) {
      CHECK(wallClearance(task.match.field, places[i]) > 0.0);
      for (std::size_t j = 0; j < i; ++j) CHECK(distance(places[i], places[j]) > 0.07);
    }
  }
  CHECK_FALSE(randomPlacement(task.match, 1)->ball == randomPlacement(task.match, 2)->ball);
  MatchConfig tiny = task.match;
  tiny.field = plainFloor("tiny", 0.3, 0.3);
  CHECK_FALSE(randomPlacement(tiny, 1));
}

TEST_CASE("models are drawn from their ranges", "[unit]") {
  MatchTask task = taskOf();
  task.ranges = {{"robot.mass", 0.1, 0.2}, {"ball.friction", 0.3, 0.3}};
  REQUIRE(checkRanges(task));
  double lowest = 1.0, highest = 0.0;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    RobotPreset models = task.match.robot;
    drawModels(task.ranges, seed, models);
    CHECK(models.ball.friction == 0.3);
    lowest = std::min(lowest, models.robot.mass);
    highest = std::max(highest, models.robot.mass);
  }
  CHECK((lowest > 0.1 && lowest < 0.11));
  CHECK((highest < 0.2 && highest > 0.19));
  task.ranges = {{"robot.name", 0.0, 1.0}};
  CHECK_FALSE(checkRanges(task));
}

TEST_CASE("the potential of the ball goes from goal to goal", "[unit]") {
  const FieldGeometry field;
  CHECK(ballPotential(field, {field.length / 2, 0.0}) == Approx(0.5));
  CHECK(ballPotential(field, {-field.length / 2, 0.0}) == Approx(-0.5));
  CHECK(ballPotential(field, {0.0, 0.4}) == Approx(0.0));
}

TEST_CASE("shaping adds up to what has changed", "[unit]") {
  MatchTask task = taskOf("random", "random");
  task.weights = {};
  task.weights.energy = 0.0;
  Played played(task);
  REQUIRE(played.environment->begin({5, ""}, played.view()));
  const auto ball = [&] { return played.environment->match()->world().balls.front().position; };
  const auto robot = [&] { return played.environment->match()->world().robots.front().pose.position; };
  const double potential = ballPotential(task.match.field, ball()), far = distance(robot(), ball());
  double gained = 0.0, nearer = 0.0;
  const std::array<float, 2> action{1.0f, 0.8f};
  for (int i = 0; i < 60; ++i) {
    REQUIRE_FALSE(played.step(action).any());
    gained += played.terms[1];
    nearer += played.terms[2];
  }
  CHECK(gained == Approx(task.weights.ball * (ballPotential(task.match.field, ball()) - potential)));
  CHECK(nearer == Approx(task.weights.move * (far - distance(robot(), ball()))));
}

TEST_CASE("each form of action moves the robot as it says", "[unit]") {
  MatchTask task = taskOf();
  StartState start = *parseStartState(
      "[ball]\nposition = [0.5, 0.5]\n[[robot]]\nteam = \"blue\"\nnumber = 0\nposition = [0.0, 0.0]\n",
      "test");
  const std::string text = toToml(start);
  const auto driven = [&](ActionForm form, std::vector<float> action) {
    task.actions = form;
    Played played(task);
    REQUIRE(played.environment->begin({1, text}, played.view()));
    for (int i = 0; i < 30; ++i) played.step(action);
    return played.environment->match()->world().robots.front();
  };
  CHECK(driven(ActionForm::kWheels, {0.5f, 0.5f}).pose.position.x > 0.15);
  CHECK(driven(ActionForm::kTwist, {0.0f, 0.3f}).angular_velocity > 3.0);
  CHECK(driven(ActionForm::kGoTo, {0.4f, 0.0f, 0.0f}).pose.position.x > 0.1);
  CHECK(driven(ActionForm::kSkill, {9.0f}).pose.position.x < -0.1);
  CHECK(driven(ActionForm::kCompat, {0.04f, 0.04f}).pose.position.x == Approx(0.0).margin(1e-6));
}

TEST_CASE("tasks are checked", "[unit]") {
  MatchTask task = taskOf();
  task.agents[0] = {};
  CHECK_FALSE(MatchEnvironment::create(task));
  task = taskOf();
  task.agents[1][3] = true;
  CHECK_FALSE(MatchEnvironment::create(task));
  task = taskOf();
  task.match.teams[1] = {};
  CHECK_FALSE(MatchEnvironment::create(task));
}

}  // namespace fulbito
