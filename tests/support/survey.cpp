#include "tests/support/survey.hpp"

#include <algorithm>
#include <chrono>

#include <fmt/format.h>

#include "fulbito/navigation.hpp"
#include "navigation/methods/paths/tangent_graph_search.hpp"
#include "tests/support/kinematic_trial.hpp"
#include "tests/support/test_stream.hpp"

namespace fulbito::test {
namespace {

/// L*; the straight line where there is no way, and among moving obstacles, which clear it.
double shortestWay(const CornerLayout& layout, double clearance) {
  std::vector<Circle> circles;
  for (const DiscObstacle& o : layout.obstacles) {
    if (o.velocity == Vec2{}) circles.push_back({o.position, o.radius + clearance});
  }
  TangentGraph graph;
  const bool found = graph.search(layout.start.position, layout.goal.position, circles);
  return found ? graph.length() : distance(layout.start.position, layout.goal.position);
}

double timeBound(double length, double speed) {
  constexpr double kAcceleration = 5.0;  // [m/s^2] of paperRobot's wheels
  const double ramp = speed * speed / (2.0 * kAcceleration);
  return length >= ramp ? length / speed + speed / (2.0 * kAcceleration)
                        : std::sqrt(2.0 * length / kAcceleration);
}

void addSafeRun(Survey& survey, const SurveyTask& task, const CornerLayout& layout,
                const KinematicResult& run) {
  ++survey.safe;
  const double shortest = shortestWay(layout, task.limit_clearance);
  const double over_bound = run.time / timeBound(shortest, task.speed);
  survey.over_straight += run.length / distance(layout.start.position, layout.goal.position);
  survey.over_shortest += run.length / shortest;
  survey.time += run.time;
  survey.over_bound += over_bound;
  survey.worst_over_bound = std::max(survey.worst_over_bound, over_bound);
  survey.clearance += run.min_clearance;
}

void printTimes(std::vector<double> micros) {
  std::sort(micros.begin(), micros.end());
  double sum = 0.0;
  // A tick that the operating system interrupted says nothing about the method.
  for (double m : micros) sum += m < 1000.0 ? m : 0.0;
  const std::size_t n = micros.size();
  fmt::print("{:>12} mean {:.2f} p50 {:.2f} p99 {:.2f} max {:.1f} us a tick\n", "",
             sum / static_cast<double>(n), micros[n / 2], micros[n * 99 / 100], micros.back());
}

}  // namespace

Survey survey(const std::string& specification, const SurveyTask& task) {
  const auto pilot = makePilot(*parseNavigator(specification));
  const RobotModel robot = paperRobot(task.speed);
  Survey survey;
  for (int i = 0; i < task.runs; ++i) {
    const CornerLayout layout = task.layout(task.first_seed + static_cast<std::uint64_t>(i));
    const KinematicResult run =
        kinematicTrial(**pilot, robot, task.field, layout.start, layout.goal, layout.obstacles);
    ++survey.runs;
    survey.reached += run.reached ? 1 : 0;
    survey.own_fault += run.own_fault ? 1 : 0;
    survey.tick_micros.insert(survey.tick_micros.end(), run.tick_micros.begin(), run.tick_micros.end());
    if (run.reached && !run.touched) addSafeRun(survey, task, layout, run);
  }
  const double safe = std::max(1, survey.safe);
  for (double* sum :
       {&survey.over_straight, &survey.over_shortest, &survey.time, &survey.over_bound, &survey.clearance}) {
    *sum /= safe;
  }
  return survey;
}

void printSurvey(const std::string& name, const std::string& specification, SurveyTask task) {
  for (double speed : {0.6, 1.0, 2.6}) {
    task.speed = speed;
    const Survey s = survey(specification, task);
    fmt::print(
        "{:34} {:3.1f} m/s: reached {:5.1f} % safe {:5.1f} % own fault {:4.2f} %  L/straight {:.3f} "
        "L/L* {:.4f}  T {:.3f} s T/T* {:.4f} (worst {:.3f})  clearance {:.1f} cm\n",
        name, speed, 100.0 * s.reached / s.runs, 100.0 * s.safe / s.runs, 100.0 * s.own_fault / s.runs,
        s.over_straight, s.over_shortest, s.time, s.over_bound, s.worst_over_bound, 100.0 * s.clearance);
    printTimes(s.tick_micros);
  }
}

void printPlanningTime(const std::string& specification, std::size_t obstacles) {
  const auto pilot = makePilot(*parseNavigator(specification));
  const RobotModel robot = paperRobot(1.0);
  const FieldGeometry field;
  Rng rng(obstacles, kTestStream, 5);
  std::vector<double> micros;
  for (int i = 0; i < 2000; ++i) {
    std::vector<DiscObstacle> balls;
    NavigationScene scene;
    scene.field = &field;
    scene.robot = &robot;
    scene.self.pose = {{rng.uniform(-0.6, 0.6), rng.uniform(-0.5, 0.5)}, rng.uniform(-3.0, 3.0)};
    scene.goal.position = {rng.uniform(-0.6, 0.6), rng.uniform(-0.5, 0.5)};
    while (balls.size() < obstacles) {
      const Vec2 p{rng.uniform(-0.7, 0.7), rng.uniform(-0.6, 0.6)};
      if (std::min(distance(p, scene.self.pose.position), distance(p, scene.goal.position)) > 0.08) {
        balls.push_back({p, 0.0335, {}});
      }
    }
    scene.obstacles = balls;
    (*pilot)->reset();
    const auto begin = std::chrono::steady_clock::now();
    (*pilot)->drive(scene);
    const std::chrono::duration<double, std::micro> spent = std::chrono::steady_clock::now() - begin;
    micros.push_back(spent.count());
  }
  fmt::print("{:40} first tick among {} obstacles\n", specification, obstacles);
  printTimes(std::move(micros));
}

}  // namespace fulbito::test
