// Tables of the default navigator, or of the one in the environment variable NAV, over COUNT layouts per row.
#include <chrono>
#include <cstdlib>

#include <fmt/format.h>

#include "fulbito/navigation.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/kinematic_trial.hpp"
#include "tests/support/suite_layouts.hpp"
#include "tests/support/survey.hpp"
#include "tests/support/test_stream.hpp"

namespace fulbito {
namespace {

std::string specification() {
  const char* text = std::getenv("NAV");
  return text != nullptr ? text : kDefaultNavigator;
}

void print(const std::string& name, test::LayoutMaker layout, double limit_clearance = 0.058) {
  test::SurveyTask task;
  task.layout = std::move(layout);
  task.first_seed = 1;
  task.limit_clearance = limit_clearance;
  if (const char* text = std::getenv("COUNT")) task.runs = std::atoi(text);
  test::printSurvey(name, specification(), std::move(task));
}

}  // namespace

TEST_CASE("survey corner", "[survey]") { print("corner", test::cornerLayout); }
TEST_CASE("survey short", "[survey]") { print("short", test::shortLayout); }
TEST_CASE("survey heading", "[survey]") { print("heading", test::headingLayout); }
TEST_CASE("survey walls", "[survey]") { print("walls", test::wallLayout); }
TEST_CASE("survey clutter", "[survey]") {
  for (double gap : {1.1, 1.3, 1.6}) {
    const auto layout = [gap](std::uint64_t seed) { return test::gapLayout(seed, gap * 0.075); };
    print(fmt::format("clutter gap {}", gap), layout, 0.0395);
  }
}
TEST_CASE("survey moving", "[survey]") { print("moving", test::movingLayout); }

TEST_CASE("survey six robots", "[survey]") {
  const RobotModel robot = test::paperRobot(1.2);
  const FieldGeometry field;
  const double radius = robot.circumradius();
  std::vector<std::unique_ptr<Pilot>> pilots;
  std::vector<test::KinematicRobot> bodies(6);
  std::vector<NavigationGoal> goals(6);
  Rng rng(1, test::kTestStream, 7);
  const auto place = [&] { return Vec2{rng.uniform(-0.65, 0.65), rng.uniform(-0.55, 0.55)}; };
  for (auto& body : bodies) {
    pilots.push_back(*makePilot(*parseNavigator(specification())));
    body.state.pose.position = place();
  }
  for (auto& goal : goals) goal.position = place();
  std::vector<DiscObstacle> others;
  int arrivals = 0;
  double micros = 0.0;
  std::vector<WheelSpeeds> wheels(6);
  for (int tick = 0; tick < 6000; ++tick) {
    const auto begin = std::chrono::steady_clock::now();
    for (std::size_t i = 0; i < 6; ++i) {
      others.clear();
      for (std::size_t j = 0; j < 6; ++j) {
        if (j != i) others.push_back({bodies[j].state.pose.position, radius, bodies[j].state.velocity});
      }
      NavigationScene scene{tick, 1.0 / 60.0, bodies[i].state, goals[i], others, &field, &robot, {}};
      wheels[i] = pilots[i]->drive(scene);
    }
    const std::chrono::duration<double, std::micro> spent = std::chrono::steady_clock::now() - begin;
    // Ticks that the operating system interrupted are left out.
    if (spent.count() < 2000.0) micros += spent.count();
    for (std::size_t i = 0; i < 6; ++i) {
      for (int step = 0; step < 16; ++step) bodies[i].step(robot, wheels[i], 1.0 / 960.0);
      if (distance(bodies[i].state.pose.position, goals[i].position) > 0.03) continue;
      goals[i].position = place();
      ++arrivals;
    }
  }
  fmt::print("six robots: {} arrivals in 100 s, {:.2f} us a robot and tick\n", arrivals,
             micros / 6000.0 / 6.0);
}

}  // namespace fulbito
