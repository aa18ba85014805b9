#include "match/drills/ideal.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "match/drills/trials.hpp"
#include "strategies/prediction/time_to_reach.hpp"
#include "tests/support/catch.hpp"

namespace fulbito {
namespace {

/// A drill with one start; the arguments are further lines of its tables.
std::string textOf(const std::string& start, const std::string& end, const std::string& bar,
                   const std::string& robots = "[[robot]]\nfrom_ball = true\nat = [[-0.4, 0.0]]\n") {
  return "[drill]\nnumber = 910\nwhat = \"least times\"\n[[start]]\nball = [[0.35, 0.0]]\n" + start + robots +
         "[[success]]\n" + end + "[[pass]]\n" + bar;
}

const std::string kGoal = "what = \"goal\"\n";
const std::string kInLeastTimes =
    "value = \"time\"\nstatistic = \"median\"\nof_least = true\nat_most = 1.5\n";

std::string errorOf(const std::string& text) {
  const auto drill = parseDrill(text, "d.toml");
  return drill ? "" : drill.error().message;
}

}  // namespace

TEST_CASE("the least time to score is that of a robot that carries the ball in", "[unit]") {
  const auto drill = parseDrill(textOf("", kGoal, kInLeastTimes), "d.toml");
  REQUIRE(drill);
  for (const char* name : {"vsss", "firasim"}) {
    const DrillOptions options;
    const DrillRun run{options, *loadRobot(name), *loadPhysics("standard")};
    const auto match = drillMatch(run, *drill);
    REQUIRE(match);
    const auto scene = drawScene(*drill, *match, 7, 0);
    REQUIRE(scene);
    // It drives straight on for 0.4 m behind the ball, less the gap of their centres, and 0.4 m with the
    // ball.
    const RobotPace pace(run.robot.robot);
    const double gap = run.robot.robot.length / 2 + run.robot.ball.radius;
    const double speed = std::min(pace.speed, std::sqrt(2 * pace.acceleration * (0.4 - gap)));
    INFO(name);
    CHECK(idealTime(*drill, *scene, *match) ==
          Approx(timeAlong(pace, 0.4 - gap, 0.0) + timeAlong(pace, 0.4, speed)).margin(1e-6));
  }
}

TEST_CASE("bars may be multiples of the least times", "[unit]") {
  auto drill = parseDrill(textOf("", kGoal, kInLeastTimes), "d.toml");
  REQUIRE(drill);
  std::vector<DrillTrial> trials(3);
  const double times[] = {1.2, 3.0, 2.0}, least[] = {1.0, 1.5, 3.0};
  for (std::size_t i = 0; i < 3; ++i) {
    trials[i].success = true;
    trials[i].time = times[i];
    trials[i].ideal = least[i];
  }
  const DrillVerdict verdict = judgeTrials(*drill, trials).front();
  CHECK(verdict.value.value == Approx(2.0 / 1.5));
  CHECK(verdict.passed);
  drill->bars.front().at_most = 1.3;
  CHECK_FALSE(judgeTrials(*drill, trials).front().passed);
  // A trial that fails takes forever.
  trials[0].time = trials[1].time = std::numeric_limits<double>::infinity();
  CHECK_FALSE(judgeTrials(*drill, trials).front().passed);
}

TEST_CASE("a bar in least times needs times, and starts that have a least time", "[unit]") {
  const auto none = Catch::Contains("pass[0].of_least finds no least time in start 'all'");
  CHECK(errorOf(textOf("", kGoal, kInLeastTimes)).empty());
  CHECK(errorOf(textOf("", "what = \"touched\"\n", kInLeastTimes)).empty());
  CHECK_THAT(errorOf(textOf("", "what = \"lasted\"\n", kInLeastTimes)), none);
  CHECK_THAT(errorOf(textOf("speed_max = 1.0\ntoward = [[0.7, 0.0]]\n", kGoal, kInLeastTimes)), none);
  // A success of another start does not count.
  CHECK_THAT(errorOf(textOf("[[start]]\nname = \"other\"\nball = [[0.0, 0.0]]\n",
                            kGoal + "start = \"other\"\n", kInLeastTimes)),
             none);
  CHECK_THAT(errorOf(textOf("", kGoal, kInLeastTimes, "")),
             Catch::Contains("pass[0].of_least finds no least time without starts and robots"));
  CHECK_THAT(errorOf(textOf("", kGoal,
                            "value = \"success\"\nstatistic = \"rate\"\nof_least = true\nat_least = 0.5\n")),
             Catch::Contains("pass[0].of_least asks for a mean, median or p95 of 'time'"));
}

}  // namespace fulbito
