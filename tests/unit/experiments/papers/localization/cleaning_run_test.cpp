#include "experiments/papers/localization/cleaning_run.hpp"

#include <cmath>
#include <cstring>

#include "experiments/papers/localization/batch.hpp"
#include "experiments/papers/paper_experiments.hpp"
#include "fulbito/report.hpp"
#include "tests/support/catch.hpp"

using namespace fulbito;
using namespace fulbito::localization;

namespace {

constexpr std::uint64_t kSeed = 77;

RandomRooms someRooms() { return randomRooms(6, kSeed, {}); }

ExperimentRequest smallRequest(int jobs) {
  ExperimentRequest request;
  request.jobs = jobs;
  request.settings = {{"rooms", "3"}, {"fields", "2"}};
  return request;
}

}  // namespace

TEST_CASE("a robot finds its place in random rooms and cleans them by the paper's scheme and by a filter",
          "[unit]") {
  for (const CleaningTask& task : someRooms().tasks) {
    for (const Scheme scheme : {Scheme::kThreshold, Scheme::kEkf}) {
      const auto run = runCleaning(task, scheme);
      REQUIRE(run);
      CHECK(run->outcome == CleaningOutcome::kFinished);
      CHECK(run->inside(0.05));
      CHECK(std::abs(run->heading_error) < 0.03);
      CHECK(std::abs(run->echo_speed_error) < 0.005);
      CHECK(run->start_error < 0.015);
      CHECK(run->seconds > run->route_length / 0.3);
    }
  }
}

TEST_CASE("dead reckoning alone leaves the path", "[unit]") {
  int inside = 0;
  for (const CleaningTask& task : someRooms().tasks)
    inside += runCleaning(task, Scheme::kDeadReckoning)->inside(0.05) ? 1 : 0;
  CHECK(inside <= 2);
}

TEST_CASE("perfect sensors keep any scheme on the path, so that deviations come from the sensors", "[unit]") {
  CleaningTask task = someRooms().tasks.front();
  task.rover = cleaningRobot();
  task.spread.range_noise = 1e-3;  // the robot expects some noise
  for (const Scheme scheme : kSchemes) {
    const auto run = runCleaning(task, scheme);
    REQUIRE(run);
    CHECK(run->outcome == CleaningOutcome::kFinished);
    CHECK(run->max_deviation < 0.03);
  }
}

TEST_CASE("moments tell the run: they begin at the start, end at the origin and hold the largest deviation",
          "[unit]") {
  const auto run = runCleaning(someRooms().tasks.front(), Scheme::kEkf, true);
  REQUIRE(run);
  REQUIRE(run->moments.size() > 500);
  double worst = 0.0;
  for (const CleaningMoment& moment : run->moments) worst = std::max(worst, moment.deviation);
  CHECK(worst <= run->max_deviation);
  CHECK(worst > 0.8 * run->max_deviation);
  CHECK(distance(run->moments.front().truth.position, run->route.front()) < 0.05);
  CHECK(distance(run->moments.back().truth.position, run->route.back()) < 0.05);
  CHECK(run->moments.back().way == Approx(run->route_length).margin(0.05));
}

TEST_CASE("a room that echoes cannot tell apart is refused with the reason", "[unit]") {
  CleaningTask task = someRooms().tasks.front();
  task.field = plainRoom({3.0, 3.02});
  task.start = {{1.0, 1.2}, 0.4};
  const auto run = runCleaning(task, Scheme::kEkf);
  REQUIRE(run);
  CHECK(run->outcome == CleaningOutcome::kRefused);
  CHECK(run->reason.find("either axis of the room 3.000 x 3.020 m") == 0);
  CHECK_FALSE(run->inside(1.0));
}

TEST_CASE("a robot whose sensors hear nothing refuses to drive", "[unit]") {
  CleaningTask task = someRooms().tasks.front();
  task.rover.sonar.dropout = 1.0;
  const auto run = runCleaning(task, Scheme::kEkf);
  REQUIRE(run);
  CHECK(run->outcome == CleaningOutcome::kRefused);
  CHECK(run->reason == "no wall answers the front sensor in any direction");
}

TEST_CASE("what a robot is told changes what it believes, not its sensors", "[unit]") {
  const CleaningTask task = randomRooms(1, 301, {}).tasks.front();
  CleaningTask told = task;
  told.spread.wheel_slip *= 3, told.spread.gyro_scale *= 3;
  // The filter uses these values, dead reckoning does not.
  CHECK(runCleaning(told, Scheme::kDeadReckoning)->max_deviation ==
        runCleaning(task, Scheme::kDeadReckoning)->max_deviation);
  CHECK_FALSE(runCleaning(told, Scheme::kEkf)->max_deviation ==
              runCleaning(task, Scheme::kEkf)->max_deviation);
}

TEST_CASE("the first fix believes the stated noise of a range, whatever the sensor's is", "[unit]") {
  CleaningTask task = randomRooms(1, 302, {}).tasks.front();
  task.field = plainRoom({3.0, 3.32});
  task.start = {{1.1, 1.2}, 0.7};
  REQUIRE(runCleaning(task, Scheme::kEkf)->outcome == CleaningOutcome::kFinished);
  task.spread.range_noise = 0.2;
  const auto run = runCleaning(task, Scheme::kEkf);
  CHECK(run->outcome == CleaningOutcome::kRefused);
  CHECK(run->reason.find("either axis") == 0);
}

TEST_CASE("air that warms after the first fix makes echoes err", "[unit]") {
  CleaningTask task = randomRooms(1, 303, {}).tasks.front();
  const double before = runCleaning(task, Scheme::kThreshold)->final_error;
  task.warming = 25.0;
  CHECK(runCleaning(task, Scheme::kThreshold)->final_error > before + 0.02);
}

TEST_CASE("wrong figures: a row per case and scheme; the filter breaks down when told far too little noise",
          "[unit]") {
  std::vector<WrongCase> cases;
  for (const WrongCase& wrong : wrongCases()) {
    if (wrong.amount == "-" || (wrong.what == "all six told" && wrong.amount == "x 1/8"))
      cases.push_back(wrong);
  }
  REQUIRE(cases.size() == 2);
  const auto runs = runWrongFigures(cases, 2, 305, {}, 2, {});
  REQUIRE(runs);
  REQUIRE(runs->size() == 4);  // per case, the paper's scheme and the filter
  const ReportTable table = wrongTable(*runs);
  REQUIRE(table.rows.size() == 4);
  for (const auto& row : table.rows) CHECK(row.size() == table.columns.size());
  for (std::size_t room = 0; room < 2; ++room) {
    CHECK((*runs)[1].results[room].inside(0.05));
    CHECK((*runs)[1].results[room].squared_error < 20.0);
    CHECK((*runs)[2].results[room].inside(0.05));
    CHECK((*runs)[3].results[room].squared_error > 100.0);
  }
  CHECK(runWrongFigures(cases, 0, 305, {}, 1, {})->empty());
}

TEST_CASE("a start outside the room is an error", "[unit]") {
  CleaningTask task = someRooms().tasks.front();
  task.start.position = {-1.0, 1.0};
  CHECK_FALSE(runCleaning(task, Scheme::kEkf));
}

TEST_CASE("random rooms are unambiguous, and the refused ones are counted", "[unit]") {
  const RandomRooms rooms = randomRooms(100, 5, {});
  CHECK(rooms.tasks.size() == 100);
  CHECK(rooms.refusals.size() > 5);
  for (const std::string& reason : rooms.refusals) CHECK(reason.find("is ambiguous") != std::string::npos);
  CHECK(randomRooms(100, 5, {}).tasks[99].start.position == rooms.tasks[99].start.position);
  CHECK_FALSE(randomRooms(100, 6, {}).tasks[99].start.position == rooms.tasks[99].start.position);
}

TEST_CASE("the experiment is the same for any number of threads", "[unit]") {
  const PaperExperiment experiment = **findPaperExperiment(paperExperiments(), "localization");
  const auto one = experiment.run(smallRequest(1)), two = experiment.run(smallRequest(2));
  REQUIRE(one);
  REQUIRE(two);
  CHECK(experimentJson(*one, smallRequest(1)) == experimentJson(*two, smallRequest(1)));
  CHECK(one->scenes.front().page.rows.size() == two->scenes.front().page.rows.size());
  CHECK(one->charts.size() == 3);
}

TEST_CASE("the experiment names a setting that is out of range, and stops when asked to", "[unit]") {
  const PaperExperiment experiment = **findPaperExperiment(paperExperiments(), "localization");
  for (const Setting& wrong : {Setting{"rooms", "0"},
                               {"rooms", "1.5"},
                               {"fields", "x"},
                               {"noise", "1"},
                               {"noise", "nan"},
                               {"noise", "0.01 "},
                               {"wrong", "-1"},
                               {"wrong", "0.5"}}) {
    ExperimentRequest request;
    request.settings = {wrong};
    const auto report = experiment.run(request);
    REQUIRE_FALSE(report);
    CHECK(report.error().code == ErrorCode::kUsage);
    CHECK(report.error().message.find("'" + wrong.name + "': '" + wrong.value + "'") != std::string::npos);
  }
  ExperimentRequest request = smallRequest(1);
  request.progress = [](std::size_t, std::size_t) { return false; };
  const auto stopped = experiment.run(request);
  REQUIRE_FALSE(stopped);
  CHECK(stopped.error().code == ErrorCode::kInterrupted);
}
