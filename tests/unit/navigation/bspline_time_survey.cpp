// Hidden surveys of the default navigator: `navigation_test "[survey]"` prints the tables.
#include <algorithm>
#include <chrono>
#include <cstdlib>

#include <fmt/format.h>

#include "navigation/preview_follower.hpp"
#include "navigation/registry.hpp"
#include "navigation/tangent_graph_search.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/corner_layout.hpp"
#include "tests/support/kinematic_trial.hpp"
#include "tests/support/suite_layouts.hpp"

namespace fulbito {
namespace {

struct Tally {
  int runs = 0, reached = 0, safe = 0;
  double length = 0, time = 0, clearance = 0, worst_time = 0;
};

std::string specification() {
  const char* s = std::getenv("NAV");
  return s ? s : kDefaultNavigator;
}
/// Wall time of each tick, to print; nothing depends on it.
class Stopwatch final : public Follower, public Navigator {
 public:
  explicit Stopwatch(const std::string& text)
      : choice_(*parseNavigator(text)), navigator_(*choice_.info->make(choice_.settings)) {}
  void reset() override {
    navigator_->reset();
    follower_.reset();
  }
  Guidance plan(const NavigationScene& scene) override {
    begin_ = std::chrono::steady_clock::now();
    return navigator_->plan(scene);
  }
  Twist follow(const Guidance& guidance, const NavigationScene& scene) override {
    const Twist twist = follower_.follow(guidance, scene);
    micros.push_back(
        std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - begin_).count());
    return twist;
  }
  std::vector<double> micros;

 private:
  NavigatorChoice choice_;
  std::unique_ptr<Navigator> navigator_;
  PreviewFollower follower_;
  std::chrono::steady_clock::time_point begin_;
};

/// Hands a pilot the two roles of one stopwatch.
struct Plans final : Navigator {
  explicit Plans(Stopwatch& w) : watch(w) {}
  void reset() override { watch.reset(); }
  Guidance plan(const NavigationScene& scene) override { return watch.plan(scene); }
  Stopwatch& watch;
};
struct Follows final : Follower {
  explicit Follows(Stopwatch& w) : watch(w) {}
  void reset() override {}
  Twist follow(const Guidance& g, const NavigationScene& scene) override { return watch.follow(g, scene); }
  Stopwatch& watch;
};
struct TimedPilot {
  TimedPilot() : pilot(std::make_unique<Plans>(watch), std::make_unique<Follows>(watch)) {}
  void print() {
    std::sort(watch.micros.begin(), watch.micros.end());
    double sum = 0;
    // A tick that the operating system interrupted says nothing about the method.
    for (double m : watch.micros) sum += m < 1000.0 ? m : 0.0;
    const std::size_t n = watch.micros.size();
    fmt::print("           us/tick mean {:.2f} p50 {:.2f} p99 {:.2f} max {:.1f}\n",
               sum / static_cast<double>(n), watch.micros[n / 2], watch.micros[n * 99 / 100],
               watch.micros.back());
  }
  Stopwatch watch{specification()};
  Pilot pilot;
};

int count(int fallback) {
  const char* s = std::getenv("COUNT");
  return s ? std::atoi(s) : fallback;
}

double shortest(Vec2 start, Vec2 goal, const std::vector<DiscObstacle>& obstacles, double clearance) {
  std::vector<Circle> circles;
  for (const auto& o : obstacles) circles.push_back({o.position, o.radius + clearance});
  TangentGraph graph;
  return graph.search(start, goal, circles) ? graph.length() : distance(start, goal);
}

void print(const char* name, double speed, const Tally& t) {
  const double n = std::max(1, t.safe);
  fmt::print(
      "{:10} {:4.1f}  reached {:5.1f} %  safe {:5.1f} %  L/L* {:.4f}  T/T* {:.4f} (worst {:.3f})  clear "
      "{:.4f}\n",
      name, speed, 100.0 * t.reached / t.runs, 100.0 * t.safe / t.runs, t.length / n, t.time / n,
      t.worst_time, t.clearance / n);
}

void add(Tally& t, const test::KinematicResult& r, double best, double speed, int seed) {
  ++t.runs;
  if (r.reached) ++t.reached;
  const double bound = best >= speed * speed / 10 ? best / speed + speed / 10.0 : std::sqrt(2 * best / 5);
  if (r.reached && !r.touched) {
    ++t.safe;
    t.length += r.length / best;
    t.time += r.time / bound;
    t.worst_time = std::max(t.worst_time, r.time / bound);
    t.clearance += r.min_clearance;
  } else if (std::getenv("VERBOSE")) {
    fmt::print("  seed {} reached {} clearance {:.4f} time {:.2f} end {:.3f} {:.3f} heading {:.2f}\n", seed,
               r.reached, r.min_clearance, r.time, r.path.back().x, r.path.back().y, r.final_heading);
  }
}

}  // namespace

TEST_CASE("survey N1", "[.][survey]") {
  for (double speed : {0.6, 1.0, 2.6}) {
    TimedPilot timed;
    Tally t;
    const RobotModel robot = test::paperRobot(speed);
    for (int seed = 1; seed <= count(200); ++seed) {
      const auto layout = test::cornerLayout(seed);
      const auto r =
          test::kinematicTrial(timed.pilot, robot, {}, layout.start, layout.goal, layout.obstacles);
      add(t, r, shortest(layout.start.position, layout.goal.position, layout.obstacles, 0.058), speed, seed);
    }
    print("N1", speed, t);
    timed.print();
  }
}

TEST_CASE("survey N2", "[.][survey]") {
  for (double speed : {0.6, 1.0, 2.6}) {
    TimedPilot timed;
    Tally t;
    const RobotModel robot = test::paperRobot(speed);
    for (int seed = 1; seed <= count(200); ++seed) {
      const auto layout = test::shortLayout(seed);
      const auto r =
          test::kinematicTrial(timed.pilot, robot, {}, layout.start, layout.goal, layout.obstacles);
      add(t, r, shortest(layout.start.position, layout.goal.position, layout.obstacles, 0.058), speed, seed);
    }
    print("N2", speed, t);
    timed.print();
  }
}

TEST_CASE("survey N3", "[.][survey]") {
  for (double speed : {0.6, 1.0, 2.6}) {
    TimedPilot timed;
    Tally t;
    const RobotModel robot = test::paperRobot(speed);
    for (int seed = 1; seed <= count(200); ++seed) {
      const auto layout = test::headingLayout(seed);
      const auto r =
          test::kinematicTrial(timed.pilot, robot, {}, layout.start, layout.goal, layout.obstacles);
      add(t, r, shortest(layout.start.position, layout.goal.position, layout.obstacles, 0.058), speed, seed);
    }
    print("N3", speed, t);
    timed.print();
  }
}

TEST_CASE("survey N4", "[.][survey]") {
  for (double speed : {0.6, 1.0, 2.6}) {
    TimedPilot timed;
    Tally t;
    const RobotModel robot = test::paperRobot(speed);
    for (int seed = 1; seed <= count(200); ++seed) {
      const auto layout = test::wallLayout(seed);
      const auto r =
          test::kinematicTrial(timed.pilot, robot, {}, layout.start, layout.goal, layout.obstacles);
      add(t, r, shortest(layout.start.position, layout.goal.position, layout.obstacles, 0.058), speed, seed);
    }
    print("N4", speed, t);
    timed.print();
  }
}

TEST_CASE("survey N5", "[.][survey]") {
  for (double gap : {1.1, 1.3, 1.6}) {
    for (double speed : {0.6, 1.0, 2.6}) {
      TimedPilot timed;
      Tally t;
      const RobotModel robot = test::paperRobot(speed);
      for (int seed = 1; seed <= count(200); ++seed) {
        const auto layout = test::gapLayout(seed, gap * 0.075);
        const auto r =
            test::kinematicTrial(timed.pilot, robot, {}, layout.start, layout.goal, layout.obstacles);
        add(t, r, shortest(layout.start.position, layout.goal.position, layout.obstacles, 0.0395), speed,
            seed);
      }
      print(fmt::format("N5 gap {}", gap).c_str(), speed, t);
      timed.print();
    }
  }
}

TEST_CASE("survey N6", "[.][survey]") {
  for (double speed : {0.6, 1.0, 2.6}) {
    TimedPilot timed;
    Tally t;
    int own = 0;
    const RobotModel robot = test::paperRobot(speed);
    for (int seed = 1; seed <= count(300); ++seed) {
      const auto layout = test::movingLayout(seed);
      const auto r =
          test::kinematicTrial(timed.pilot, robot, {}, layout.start, layout.goal, layout.obstacles);
      add(t, r, shortest(layout.start.position, layout.goal.position, {}, 0.058), speed, seed);
      if (r.own_fault) ++own;
      if (r.own_fault && std::getenv("VERBOSE"))
        fmt::print("   own fault in {} with {} discs\n", seed, layout.obstacles.size());
    }
    print("N6", speed, t);
    fmt::print("           own fault {:.2f} %\n", 100.0 * own / t.runs);
    timed.print();
  }
}

TEST_CASE("survey six robots", "[.][survey]") {
  const RobotModel robot = test::paperRobot(1.2);
  const FieldGeometry field;
  const double radius = robot.circumradius();
  std::vector<std::unique_ptr<Pilot>> pilots;
  std::vector<test::KinematicRobot> bodies(6);
  std::vector<NavigationGoal> goals(6);
  Rng rng(1, Stream::kTest, 7);
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
      NavigationScene scene{tick, 1.0 / 60.0, bodies[i].state, goals[i], others, &field, &robot};
      wheels[i] = pilots[i]->drive(scene);
    }
    const std::chrono::duration<double, std::micro> spent = std::chrono::steady_clock::now() - begin;
    // A tick that the operating system interrupted says nothing about the method.
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
