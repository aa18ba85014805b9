#include "match/drills/drill.hpp"

#include <cmath>
#include <set>

#include "fulbito/detail/math.hpp"
#include "fulbito/match.hpp"
#include "fulbito/statistics.hpp"
#include "match/drills/ideal.hpp"
#include "match/drills/start.hpp"
#include "match/drills/trials.hpp"
#include "strategies/prediction/time_to_reach.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/scratch_folder.hpp"

namespace fulbito {
namespace {

/// Does nothing; answers tasks with the ball's present position.
class Still : public Strategy {
 public:
  void begin(const MatchInfo& info) override { info_ = info; }
  TeamCommand decide(const Observation&) override { return {}; }
  std::optional<ExerciseReply> exercise(const Observation& observation, const Exercise& exercise) override {
    ExerciseReply reply;
    reply.answer = observation.ball.position;
    if (exercise.kind == Exercise::Kind::kTurn) {
      const double error = math::wrapAngle(exercise.heading - observation.own[0].state.pose.heading);
      reply.command.robots[0] = RobotCommand::byTwist({0.0, 6.0 * error});
    }
    if (exercise.kind == Exercise::Kind::kPush || exercise.kind == Exercise::Kind::kReachBall) {
      reply.command.robots[0] = RobotCommand::byTwist({1.1 * exercise.speed, 0.0});
    }
    return reply;
  }

 private:
  MatchInfo info_;
};

/// Exchanges two roles every tick.
class Flapping final : public Still {
  TeamCommand decide(const Observation& observation) override {
    TeamCommand command;
    const bool even = observation.tick % 2 == 0;
    command.roles[0] = even ? 1 : 2;
    command.roles[1] = even ? 2 : 1;
    return command;
  }
};

template <typename Team>
TeamChoice stub(const char* name) {
  return TeamChoice::own(name, [] { return std::make_unique<Team>(); });
}

TeamChoice still() { return stub<Still>("still"); }

Drill drillOf(const std::string& text) {
  auto drill = parseDrill(text, "test.toml");
  if (!drill) FAIL(drill.error().message);
  return *drill;
}

DrillReport runOne(const std::string& text, const TeamChoice& team, int jobs = 1) {
  DrillOptions options;
  options.team = team;
  options.jobs = jobs;
  auto reports = runDrills({drillOf(text)}, {}, options, {});
  if (!reports) FAIL(reports.error().message);
  return reports->front();
}

/// A ball in front of the opponents' goal, or of the own, and a robot right behind it.
std::string tapIn(const char* ball, const char* robot) {
  return std::string(
             "[drill]\nnumber = 900\nwhat = \"tap in\"\nduration = 2.0\ntrials = 8\n[[start]]\nball = ") +
         ball + "\nball_spread = [0.01, 0.05]\n[[robot]]\nfrom_ball = true\nat = " + robot +
         "\nface_ball = true\n[[success]]\nwhat = \"goal\"\n[[failure]]\nwhat = \"conceded\"\n"
         "[[pass]]\nvalue = \"success\"\nstatistic = \"rate\"\nby_value = true\nat_least = 1.0\n"
         "[[pass]]\nvalue = \"time\"\nstatistic = \"median\"\nat_most = 1.0\n"
         "[[pass]]\nvalue = \"own-goal\"\nstatistic = \"count\"\nat_most = 0\n";
}

/// One robot is asked for a task, with the ball 0.0605 m before it.
std::string taskDrill(const char* task, const char* more) {
  return std::string(
             "[drill]\nnumber = 901\nwhat = \"a task\"\nduration = 2.0\ntrials = 8\nreferee = false\n"
             "tolerance = 0.04\n[[start]]\ntask = \"") +
         task + "\"\nball = [[-0.4, 0.2]]\n" + more +
         "[[robot]]\nfrom_ball = true\nat = [[-0.0605, 0.0]]\n"
         "[[pass]]\nvalue = \"success\"\nstatistic = \"rate\"\nby_value = true\nat_least = 1.0\n";
}

constexpr const char* kMinimal =
    "[drill]\nnumber = 1\nwhat = \"x\"\n[[start]]\nball = [[0, 0]]\n[[robot]]\nat = [[0.3, 0]]\n"
    "[[success]]\nwhat = \"goal\"\n[[pass]]\nvalue = \"success\"\nstatistic = \"rate\"\nat_least = 0.5\n";

std::string errorOf(const std::string& text) {
  const auto drill = parseDrill(text, "d.toml");
  return drill ? "" : drill.error().message;
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

}  // namespace

TEST_CASE("all 21 drills are built in", "[unit]") {
  const std::vector<Drill>& drills = builtInDrills();
  REQUIRE(drills.size() == 21);
  std::set<std::string> names;
  for (std::size_t i = 0; i < drills.size(); ++i) {
    CHECK(drills[i].number == static_cast<int>(i) + 1);
    // A rule, physics, or a choice that says so: sources that every reader can check.
    CHECK_THAT(drills[i].source, Catch::Contains("IEEE VSSS rules 2020, law") ||
                                     Catch::Contains("Physics: ") || Catch::Contains("Floor: ") ||
                                     Catch::Contains("Chosen by us"));
    names.insert(drills[i].name);
  }
  CHECK(names.size() == drills.size());
}

TEST_CASE("every start of the built-in drills finds room", "[unit]") {
  DrillOptions options;
  options.team = still();
  const DrillRun run{options, *loadRobot("vsss"), *loadPhysics("standard")};
  for (const Drill& drill : builtInDrills()) {
    if (drill.starts.empty()) continue;
    const auto match = drillMatch(run, drill);
    REQUIRE(match);
    const int some = 16 * static_cast<int>(drill.starts.size());
    for (int i = 0; i < some; ++i) {
      const auto scene = drawScene(drill, *match, 7, i);
      INFO(drill.name << " " << i << (scene ? "" : scene.error().message));
      REQUIRE(scene);
    }
  }
}

TEST_CASE("a drill's file errors name file, line and key", "[unit]") {
  CHECK(errorOf(kMinimal).empty());
  CHECK_THAT(errorOf("[drill]\n"), Catch::StartsWith("d.toml:1: drill.number is missing"));
  CHECK_THAT(errorOf(replaced(kMinimal, "what = \"goal\"", "what = \"gaol\"")),
             Catch::StartsWith("d.toml:9: success[0].what"));
  CHECK_THAT(errorOf(replaced(kMinimal, "at_least = 0.5", "")), Catch::Contains("needs at_least or at_most"));
  CHECK_THAT(errorOf(replaced(kMinimal, "at_least = 0.5", "at_least = \"x\"")),
             Catch::Contains("pass[0].at_least"));
  CHECK_THAT(errorOf(replaced(kMinimal, "[[robot]]", "[[robot]]\nstart = \"al\"")),
             Catch::Contains("robot[0].start names no [[start]] of this file: 'al'. Did you mean 'all'?"));
  CHECK_THAT(errorOf(replaced(kMinimal, "ball = [[0, 0]]", "speed_max = 1.0\nball = [[0, 0]]")),
             Catch::Contains("start[0].toward is missing"));
  CHECK_THAT(errorOf(replaced(kMinimal, "number = 1", "number = 1\nrepeats = \"3, x\"")),
             Catch::Contains("drill.repeats = '3, x' is no list"));
  CHECK_THAT(errorOf(replaced(kMinimal, "[[start]]\nball = [[0, 0]]", "")), Catch::Contains("is missing"));
}

TEST_CASE("a folder of drills is read in the order of numbers", "[unit]") {
  const test::ScratchFolder folder;
  folder.write("a.toml", replaced(kMinimal, "number = 1", "number = 30"));
  folder.write("b.toml", replaced(kMinimal, "number = 1", "number = 4"));
  const auto drills = loadDrills(folder.path().string());
  REQUIRE(drills);
  REQUIRE(drills->size() == 2);
  CHECK((*drills)[0].number == 4);
  CHECK((*drills)[0].name == "b");
  CHECK(loadDrills((folder.path() / "none").string()).error().code == ErrorCode::kIo);
}

TEST_CASE("floors are those of docs/skills.md", "[unit]") {
  RobotModel robot;
  robot.wheel_acceleration = 5.0;
  robot.axle_track = 0.075;
  robot.yaw_acceleration = 2.0 * 5.0 / 0.075;  // the wheels do not affect each other: 2 a / b
  robot.max_wheel_speed = 1.2 / robot.wheel_radius;
  const RobotPace pace(robot);
  CHECK(timeToReach(pace, 0.3, 0.0) == Approx(0.37).margin(0.005));
  CHECK(timeToReach(pace, 1.0, 0.0) == Approx(0.95).margin(0.005));
  CHECK(timeToReach(pace, 1.0, math::kPi / 2) - timeToReach(pace, 1.0, 0.0) == Approx(0.15).margin(0.005));
  CHECK(timeToTurn(pace, math::kPi / 2) == Approx(0.22).margin(0.005));
  const Drill& keeper = builtInDrills()[9];
  REQUIRE(keeper.name == "keeper");
  const RobotModel vsss = loadRobot("vsss")->robot;
  CHECK(leastSavableDistance(keeper, vsss, 1.2) == Approx(0.32).margin(0.005));
  CHECK(leastSavableDistance(keeper, vsss, 1.6) == Approx(0.43).margin(0.005));
  CHECK(leastSavableDistance(keeper, vsss, 2.0) == Approx(0.53).margin(0.005));
  // A robot that speeds up five times as slowly needs about twice the distance.
  CHECK(leastSavableDistance(keeper, loadRobot("firasim")->robot, 1.2) == Approx(0.66).margin(0.005));
}

TEST_CASE("trials are shared evenly among hands and sides", "[unit]") {
  const Drill drill = drillOf(tapIn("[[0.6, 0.1]]", "[[-0.08, 0.0]]"));
  DrillOptions options;
  options.team = still();
  const DrillRun run{options, *loadRobot("vsss"), *loadPhysics("standard")};
  const auto match = drillMatch(run, drill);
  REQUIRE(match);
  int upper = 0, blue = 0, upper_blue = 0;
  for (int i = 0; i < 40; ++i) {
    const auto scene = drawScene(drill, *match, 3, i);
    REQUIRE(scene);
    upper += scene->placement.ball.y > 0.0 ? 1 : 0;
    blue += scene->seat == TeamId::kBlue ? 1 : 0;
    upper_blue += scene->placement.ball.y > 0.0 && scene->seat == TeamId::kBlue ? 1 : 0;
  }
  CHECK(upper == 20);
  CHECK(blue == 20);
  CHECK(upper_blue == 10);
}

TEST_CASE("who pushes a ball in front of the goal scores, who stands still does not", "[unit]") {
  const std::string drill = tapIn("[[0.62, 0.0]]", "[[-0.08, 0.0]]");
  const DrillReport scored = runOne(drill, *parseTeam("chaser"));
  CHECK(scored.passed());
  CHECK(scored.verdicts[1].value.value > 0.05);
  const DrillReport failed = runOne(drill, still());
  CHECK_FALSE(failed.passed());
  CHECK(failed.verdicts[0].value.value == 0.0);
  CHECK(std::isinf(failed.verdicts[1].value.value));
  CHECK(failed.verdicts[2].passed);
}

TEST_CASE("a ball pushed into the own goal is an own goal", "[unit]") {
  const DrillReport report = runOne(tapIn("[[-0.62, 0.0]]", "[[0.08, 0.0]]"), *parseTeam("chaser"));
  CHECK(report.verdicts[0].value.value == 0.0);
  CHECK(report.verdicts[2].value.value == 8.0);
}

TEST_CASE("a standing keeper saves what rolls at it and nothing else", "[unit]") {
  const auto saves = [](const char* robot) {
    return runOne(
               std::string(
                   "[drill]\nnumber = 902\nwhat = \"shots\"\nduration = 2.0\ntrials = 8\nreferee = false\n"
                   "[[start]]\ntoward = [[-0.75, -0.02], [-0.75, 0.02]]\nspeed_min = 1.0\nspeed_max = 1.5\n"
                   "distance_min = 0.4\ndistance_max = 0.4\nenters = true\nbounces = 0\n[[robot]]\nat = ") +
                   robot +
                   "\nheading_deg = 90.0\n[[success]]\nwhat = \"lasted\"\n[[failure]]\nwhat = \"conceded\"\n"
                   "[[pass]]\nvalue = \"success\"\nstatistic = \"rate\"\nby_value = true\nat_least = 1.0\n",
               still())
        .verdicts[0]
        .value.value;
  };
  CHECK(saves("[[-0.69, 0.0]]") == 1.0);
  CHECK(saves("[[-0.69, 0.4]]") == 0.0);
}

TEST_CASE("who is to last fails by a penalty, not by what else the referee calls", "[unit]") {
  const auto lasts = [](const char* ball, const char* robot) {
    return runOne(std::string("[drill]\nnumber = 903\nwhat = \"stuck\"\nduration = 19.0\ntrials = 4\n"
                              "referee = true\n[[start]]\nball = ") +
                      ball + "\n[[robot]]\nat = [" + robot +
                      "]\n[[robot]]\nteam = \"opponent\"\nplays = \"stand\"\n"
                      "at = [[0.71, 0.25]]\n[[success]]\nwhat = \"lasted\"\n[[failure]]\n"
                      "what = \"conceded\"\n[[pass]]\nvalue = \"success\"\nstatistic = \"rate\"\n"
                      "by_value = true\nat_least = 1.0\n",
                  still());
  };
  // In between, the call is a goal kick for the opponents; a keeper that holds the ball gives a penalty.
  const DrillReport goal_kick = lasts("[[0.62, 0.25]]", "[0.53, 0.25]");
  const DrillReport penalty = lasts("[[-0.65, 0.2]]", "[-0.71, 0.2]");
  CHECK(goal_kick.verdicts[0].value.value == 1.0);
  CHECK(penalty.trials.front().stopped_by == "penalty.keeper-holds");
  CHECK(penalty.verdicts[0].value.value == 0.0);
}

TEST_CASE("tasks are judged by the true world", "[unit]") {
  // The robot turns in place, and its front starts in line with the ball.
  CHECK(runOne(taskDrill("turn", "turn_min_deg = 60.0\nturn_max_deg = 60.0\n"), still()).passed());
  CHECK_FALSE(runOne(taskDrill("reach-pose", "target_min = 0.3\ntarget_max = 0.3\n"), still()).passed());
  CHECK(
      runOne(taskDrill("push", "target_min = 0.3\ntarget_max = 0.3\ntask_speed = 0.5\n"), still()).passed());
  // A resting ball stays where it is; a rolling one does not.
  CHECK(runOne(taskDrill("predict-ball", "horizon = 0.5\n"), still()).passed());
  CHECK_FALSE(runOne(taskDrill("predict-ball",
                               "horizon = 0.5\ntoward = [[0.7, 0.2]]\nspeed_min = 0.5\nspeed_max = 0.5\n"),
                     still())
                  .passed());
}

TEST_CASE("a strike counts by the speed before the touch", "[unit]") {
  const std::string far = replaced(taskDrill("reach-ball", "task_speed = 0.4\n"), "-0.0605", "-0.3");
  CHECK(runOne(far, still()).passed());
  // From 0.1 mm, the robot has no room to speed up.
  CHECK_FALSE(runOne(taskDrill("reach-ball", "task_speed = 0.4\n"), still()).passed());
}

TEST_CASE("a team that knows no tasks is not offered them", "[unit]") {
  const DrillReport report =
      runOne(taskDrill("turn", "turn_min_deg = 60.0\n turn_max_deg = 60.0\n"), *parseTeam("chaser"));
  CHECK_FALSE(report.offered);
  CHECK_FALSE(report.passed());
  DrillOptions options;
  options.team = *parseTeam("chaser");
  CHECK_THAT(drillTable({report}, options), Catch::Contains("not offered"));
}

TEST_CASE("nobody meets a crossing ball before the least time", "[unit]") {
  Drill drill = builtInDrills()[5];
  REQUIRE(drill.name == "crossing");
  DrillOptions options;
  options.team = *parseTeam("chaser");
  options.trials = 40;
  const auto reports = runDrills({drill}, {}, options, {});
  REQUIRE(reports);
  int touched = 0;
  for (const DrillTrial& trial : reports->front().trials) {
    CHECK(trial.ideal > 0.0);
    if (!trial.success) continue;
    ++touched;
    // The formula is accurate to 0.04 s.
    CHECK(trial.time - trial.ideal > -0.05);
  }
  CHECK(touched > 20);
}

TEST_CASE("rates are judged by their intervals", "[unit]") {
  DrillVerdict verdict;
  verdict.bar.at_least = 0.98;
  verdict.count = 200;
  verdict.value = wilson(200, 200);
  judge(verdict);
  CHECK(verdict.passed);
  verdict.value = wilson(199, 200);
  judge(verdict);
  CHECK_FALSE(verdict.passed);
  verdict.bar.by_value = true;
  judge(verdict);
  CHECK(verdict.passed);
  verdict.count = 0;
  judge(verdict);
  CHECK_FALSE(verdict.passed);
}

TEST_CASE("whole matches count roles that change hands", "[unit]") {
  const std::string drill =
      "[drill]\nnumber = 903\nwhat = \"roles\"\ntrials = 2\nmatch_opponent = \"chaser\"\nhalf_seconds = 2.0\n"
      "[[pass]]\nvalue = \"switch\"\nstatistic = \"mean\"\nat_most = 0.5\n"
      "[[pass]]\nvalue = \"flap\"\nstatistic = \"count\"\nat_most = 0\n";
  const DrillReport flapping = runOne(drill, stub<Flapping>("flapping"));
  CHECK(flapping.offered);
  CHECK(flapping.verdicts[0].value.value == Approx(60.0).margin(3.0));
  CHECK(flapping.verdicts[1].value.value > 200.0);
  CHECK_FALSE(runOne(drill, still()).offered);
}

TEST_CASE("own goals of whole matches are those of a match's statistics", "[unit]") {
  Drill drill = drillOf(
      "[drill]\nnumber = 905\nwhat = \"own goals\"\ntrials = 2\nmatch_opponent = \"chaser\"\n"
      "half_seconds = 120.0\n[[pass]]\nvalue = \"own-goal\"\nstatistic = \"mean\"\nat_most = 0\n");
  DrillOptions options;
  options.team = *parseTeam("chaser");
  options.seed = 12;
  const DrillRun run{options, *loadRobot("vsss"), *loadPhysics("standard")};
  const auto base = drillMatch(run, drill);
  REQUIRE(base);
  int own_goals = 0;
  for (int i = 0; i < 8; ++i) {
    const auto tally = playDrillMatch(run, drill, *base, i);
    REQUIRE(tally);
    MatchConfig config = *base;
    config.seed = options.seed + static_cast<std::uint64_t>(i / 2);
    config.teams = {options.team, options.team};
    auto match = Match::create(config);
    REQUIRE(match);
    StatisticsObserver statistics;
    match->watch(statistics);
    while (match->step()) {
    }
    const TeamId seat = i % 2 == 0 ? TeamId::kBlue : TeamId::kYellow;
    CHECK(tally->own_goals == statistics.statistics().teams[indexOf(seat)].own_goals);
    own_goals += tally->own_goals;
  }
  CHECK(own_goals > 0);
}

TEST_CASE("every restart begins as the rules say, for both teams", "[unit]") {
  Drill drill = builtInDrills()[16];
  REQUIRE(drill.name == "restarts");
  DrillOptions options;
  options.team = *parseTeam("chaser");
  options.trials = 20;
  drill.duration = 0.2;
  const auto reports = runDrills({drill}, {}, options, {});
  REQUIRE(reports);
  CHECK(reports->front().verdicts[0].value.value == 0.0);
  for (const DrillTrial& trial : reports->front().trials) CHECK(trial.success);
}

TEST_CASE("drills under worse sight are compared with the same under better", "[unit]") {
  std::vector<Drill> drills = {drillOf(tapIn("[[0.62, 0.0]]", "[[-0.08, 0.0]]"))};
  drills.push_back(drillOf(
      "[drill]\nnumber = 904\nwhat = \"sight\"\ntrials = 8\nrepeats = \"900\"\n[sight]\nlatency_ticks = 2\n"
      "[[pass]]\nvalue = \"kept\"\nstatistic = \"rate\"\nby_value = true\nat_least = 0.9\n"));
  DrillOptions options;
  options.team = *parseTeam("chaser");
  const auto reports = runDrills(drills, {904}, options, {});
  REQUIRE(reports);
  REQUIRE(reports->size() == 1);
  REQUIRE(reports->front().verdicts.size() == 1);
  CHECK(reports->front().passed());
  drills.erase(drills.begin());
  CHECK(runDrills(drills, {}, options, {}).error().code == ErrorCode::kBadInput);
}

TEST_CASE("results do not depend on the number of jobs", "[unit]") {
  DrillOptions options;
  options.team = *parseTeam("chaser");
  options.trials = 24;
  std::string texts[2];
  for (int i = 0; i < 2; ++i) {
    options.jobs = i == 0 ? 1 : 3;
    const auto reports = runDrills(builtInDrills(), {3, 6, 10, 12}, options, {});
    REQUIRE(reports);
    texts[i] = drillJson(*reports, options);
  }
  CHECK(texts[0] == texts[1]);
}

TEST_CASE("the drills among the examples run", "[unit]") {
  const auto drills = loadDrills(FULBITO_SOURCE_DIR "/examples/drills");
  REQUIRE(drills);
  DrillOptions options;
  options.team = *parseTeam("chaser");
  options.trials = 7;
  const auto reports = runDrills(*drills, {}, options, {});
  REQUIRE(reports);
  constexpr std::size_t kStarts[] = {7, 7, 5}, kBars[] = {8, 8, 10};
  REQUIRE(reports->size() == 3);
  for (std::size_t i = 0; i < 3; ++i) {
    const DrillReport& report = (*reports)[i];
    CHECK(report.drill.starts.size() == kStarts[i]);
    CHECK(report.trials.size() == 7);
    CHECK(report.verdicts.size() == kBars[i]);
  }
}

TEST_CASE("a run of drills stops when it is told to", "[unit]") {
  DrillOptions options;
  options.team = *parseTeam("chaser");
  const auto reports = runDrills({drillOf(tapIn("[[0.62, 0.0]]", "[[-0.08, 0.0]]"))}, {}, options,
                                 [](std::size_t, std::size_t) { return false; });
  REQUIRE_FALSE(reports);
  CHECK(reports.error().code == ErrorCode::kInterrupted);
}

TEST_CASE("a start without room is an error", "[unit]") {
  DrillOptions options;
  options.team = still();
  const auto reports =
      runDrills({drillOf(replaced(kMinimal, "at = [[0.3, 0]]", "at = [[0.0, 0]]"))}, {}, options, {});
  REQUIRE_FALSE(reports);
  CHECK(reports.error().code == ErrorCode::kBadInput);
  CHECK_THAT(reports.error().message, Catch::Contains("leaves no room"));
}

}  // namespace fulbito
