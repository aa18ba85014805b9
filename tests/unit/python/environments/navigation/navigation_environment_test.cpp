#include "python/environments/navigation/navigation_environment.hpp"

#include <cmath>
#include <filesystem>

#include "engine/core/math/random.hpp"
#include "experiments/comparison/comparison_parts.hpp"
#include "fulbito/detail/math.hpp"
#include "fulbito/recording.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/test_stream.hpp"
#include "tests/unit/python/environments/one_agent.hpp"

namespace fulbito {
namespace {

using Lane = test::OneAgent<NavigationEnvironment>;

double randomEpisode(Lane& lane, const EpisodeStart& start) {
  lane.begin(start);
  Rng rng(start.seed, test::kTestStream);
  double sum = 0.0;
  for (EpisodeEnd end; !end.any();) {
    end = lane.step({static_cast<float>(rng.uniform(-1.0, 1.0)), static_cast<float>(rng.uniform(-1.0, 1.0))});
    for (const float number : lane.observation) sum += static_cast<double>(number) * 0.37;
    sum = sum * 0.9 + lane.rewards[0];
  }
  return sum;
}

/// Half the top speed straight on.
class HalfAhead final : public Navigator {
 public:
  void reset() override {}
  Guidance plan(const NavigationScene& scene) override {
    Guidance guidance;
    guidance.kind = GuidanceKind::kWheels;
    guidance.wheels = {0.5 * scene.robot->max_wheel_speed, 0.5 * scene.robot->max_wheel_speed};
    return guidance;
  }
};

}  // namespace

TEST_CASE("every suite is an environment, and equal starts and actions give equal bits", "[unit]") {
  for (const Suite& suite : suites()) {
    for (const auto control :
         {NavigationControl::kWheels, NavigationControl::kTwist, NavigationControl::kHeading}) {
      NavigationSettings settings;
      settings.suite = suite.name;
      settings.control = control;
      settings.ticks = 4;
      Lane lane(settings), other(settings);
      INFO(suite.name);
      const double first = randomEpisode(lane, {11, ""});
      randomEpisode(other, {5, ""});
      CHECK(randomEpisode(other, {11, ""}) == first);
    }
  }
}

TEST_CASE("an agent has the score that compare gives a navigator that does the same", "[unit]") {
  for (const char* suite : {"corner", "moving", "walls", "clutter"}) {
    NavigationSettings settings;
    settings.suite = suite;
    Lane lane(settings);
    ComparisonConfig config;
    config.suite = suite;
    config.navigators = {"straight"};
    config.speeds = {settings.speed};
    const auto plan = planComparison(config);
    for (std::uint64_t index = 0; index < 8; ++index) {
      auto trial = trialConfig(*plan, plan->blocks.front(), 0, index);
      auto info = std::make_shared<NavigatorInfo>(*trial->navigator.info);
      info->make = [](const std::vector<Setting>&) -> Result<std::unique_ptr<Navigator>> {
        return std::make_unique<HalfAhead>();
      };
      trial->navigator.info = info;
      const auto played = runTrial(*trial, {});
      lane.begin({99, "layout " + std::to_string(index)});
      EpisodeEnd end;
      while (!end.any()) end = lane.step({0.5f, 0.5f});
      INFO(suite << " " << index);
      CHECK(lane.figures[0] == (played->score.success() ? 1.0 : 0.0));
      CHECK(lane.figures[1] == static_cast<double>(played->score.outcome));
      CHECK(lane.figures[3] == played->score.timeRatio());
      CHECK(lane.figures[5] == played->score.lengthRatio());
      CHECK(end.truncated == (played->score.time >= 8.0 * played->score.time_limit));
    }
  }
}

TEST_CASE("layouts to train on are other ones than those of a test and of compare", "[unit]") {
  NavigationSettings settings;
  Lane train(settings);
  settings.train = false;
  Lane test(settings);
  train.begin({7, ""});
  test.begin({7, ""});
  CHECK(train.observation != test.observation);
  const std::vector<float> seen = test.observation;
  train.begin({99, "layout " + std::to_string(static_cast<int>(test.figures[8])) + " of seed 7"});
  CHECK(train.observation == seen);
}

TEST_CASE("a named case and a layout of one's own are the same in every episode", "[unit]") {
  NavigationSettings settings;
  settings.suite = "cases";
  Lane named(settings);
  named.begin({1, "layout fig4-wall"});
  CHECK(named.figures[8] == 4.0);
  settings.suite = "corner";
  settings.layout = namedCases()[4];
  Lane own(settings);
  own.begin({1, ""});
  CHECK(own.observation == named.observation);
  own.begin({2, ""});
  CHECK(own.observation == named.observation);
}

TEST_CASE("rays end at obstacles and walls", "[unit]") {
  Layout layout;
  layout.start = {{0.0, 0.0}, 0.0};
  layout.goal = {0.5, 0.0};
  layout.obstacles.resize(1);
  layout.obstacles[0].pose.position = {0.0, 0.3};
  NavigationSettings settings;
  settings.layout = layout;
  Lane lane(settings);
  lane.begin({1, ""});
  const auto named = [&](std::string_view name) {
    const auto& entries = navigationSight();
    for (std::size_t i = 0; i < entries.size(); ++i) {
      if (entries[i].name == name) return static_cast<double>(lane.observation[i]);
    }
    return std::nan("");
  };
  CHECK(named("goal-x") == Approx(0.5));
  CHECK(named("ray-8") == Approx(0.3 - 0.0335));  // to the left: the obstacle
  CHECK(named("ray-24") == Approx(0.65));         // to the right: the wall
  CHECK(named("obstacle-1-y") == Approx(0.3));
  CHECK(named("obstacle-2-present") == 0.0);
}

TEST_CASE("a forbidden contact may end an episode", "[unit]") {
  Layout layout;
  layout.start = {{-0.4, 0.0}, 0.0};
  layout.goal = {0.5, 0.0};
  layout.obstacles.resize(1);
  layout.obstacles[0].pose.position = {0.0, 0.0};
  NavigationSettings settings;
  settings.layout = layout;
  settings.ends_at_contact = true;
  Lane lane(settings);
  lane.begin({1, ""});
  EpisodeEnd end;
  while (!end.any()) end = lane.step({1.0f, 1.0f});
  CHECK(end.terminated);
  CHECK(lane.figures[1] == static_cast<double>(TrialOutcome::kCollided));
  CHECK(lane.terms[static_cast<std::size_t>(NavigationTerm::kFailure)] == -settings.weights[1]);
}

TEST_CASE("an episode can be seen and recorded", "[unit]") {
  const test::ScratchFolder folder;
  const std::string file = (folder.path() / "episode.fbr").string();
  Lane lane(NavigationSettings{});
  REQUIRE(lane.environment->record(file));
  lane.begin({1, ""});
  EpisodeEnd end;
  int steps = 0;
  for (; !end.any(); ++steps) end = lane.step({1.0f, 0.9f});
  const auto picture = lane.environment->picture(480);
  REQUIRE(picture);
  CHECK(picture->width() == 480);
  const auto recording = RecordingReader::open(file);
  REQUIRE(recording);
  CHECK(recording->finished());
  CHECK(recording->ticks() == steps);
}

TEST_CASE("what is no layout, suite or range is refused with the reason", "[unit]") {
  const auto why = [](const NavigationSettings& settings) {
    return NavigationEnvironment::create(settings).error().message;
  };
  NavigationSettings settings;
  settings.suite = "cornr";
  CHECK(why(settings) == "there is no suite 'cornr'. Did you mean 'corner'?");
  settings.suite = "jung-lee-2015";
  CHECK(why(settings).starts_with("there is no suite 'jung-lee-2015'"));
  settings = {};
  settings.speed = 20.0;
  CHECK(why(settings) == "speed: 20 is outside 0.05 ... 10 m/s");
  settings = {};
  settings.ticks = 61;
  CHECK(why(settings) == "frame_skip: 61 is outside 1 ... 60");
  settings = {};
  settings.weights[0] = std::nan("");
  CHECK(why(settings) == "rewards: success is not finite");
  Lane lane(NavigationSettings{});
  CHECK(lane.environment->begin({1, "trial 3"}, lane.view()).error().message ==
        "start: 'trial 3' is not 'layout N', 'layout N of seed S' or 'layout NAME'");
  CHECK(lane.environment->begin({1, "layout north"}, lane.view()).error().message ==
        "start: 'north' is not a number or the name of a layout of suite 'corner'");
}

}  // namespace fulbito
