#include "fulbito/world.hpp"

#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include "python/bindings/arrays.hpp"
#include "python/bindings/bind.hpp"
#include "python/bindings/errors.hpp"
#include "python/bindings/exclusive.hpp"
#include "python/bindings/python_calls.hpp"

namespace fulbito::python {
namespace {

namespace nb = nanobind;

constexpr std::size_t kTicksBetweenChecks = 512;
constexpr std::size_t kRobotColumns = 8, kBallColumns = 6, kObstacleColumns = 5;

using Matrix = nb::ndarray<const double, nb::ndim<2>, nb::c_contig, nb::device::cpu>;
using Commands = nb::ndarray<const double, nb::ndim<3>, nb::c_contig, nb::device::cpu>;

void requireColumns(const Matrix& rows, const char* name, std::size_t columns) {
  if (rows.shape(1) == columns) return;
  raise(ErrorCode::kUsage, std::string(name) + " need " + std::to_string(columns) + " columns");
}

/// x, y, heading, along x, along y, yaw rate of each row.
std::vector<RobotPlacement> robotsOf(const Matrix& rows, const RobotModel& model) {
  requireColumns(rows, "robots", 6);
  std::vector<RobotPlacement> robots;
  for (std::size_t i = 0; i < rows.shape(0); ++i) {
    robots.push_back({model, {{rows(i, 0), rows(i, 1)}, rows(i, 2)}, {rows(i, 3), rows(i, 4)}, rows(i, 5)});
  }
  return robots;
}

/// x, y, along x, along y, spin along x, spin along y of each row.
std::vector<BallPlacement> ballsOf(const Matrix& rows, const BallModel& model) {
  requireColumns(rows, "balls", 6);
  std::vector<BallPlacement> balls;
  for (std::size_t i = 0; i < rows.shape(0); ++i) {
    balls.push_back({model, {rows(i, 0), rows(i, 1)}, {rows(i, 2), rows(i, 3)}, {rows(i, 4), rows(i, 5)}});
  }
  return balls;
}

/// x, y, radius of each row.
std::vector<ObstacleSpec> discsOf(const Matrix& rows) {
  requireColumns(rows, "discs", 3);
  std::vector<ObstacleSpec> obstacles(rows.shape(0));
  for (std::size_t i = 0; i < rows.shape(0); ++i) {
    obstacles[i].pose.position = {rows(i, 0), rows(i, 1)};
    obstacles[i].radius = rows(i, 2);
  }
  return obstacles;
}

void put(const WorldState& state, double* robots, double* balls) {
  for (const RobotState& r : state.robots) {
    for (const double value : {r.pose.position.x, r.pose.position.y, r.pose.heading, r.velocity.x,
                               r.velocity.y, r.angular_velocity, r.wheels.left, r.wheels.right})
      *robots++ = value;
  }
  for (const BallState& b : state.balls) {
    for (const double value : {b.position.x, b.position.y, b.velocity.x, b.velocity.y, b.spin.x, b.spin.y})
      *balls++ = value;
  }
}

/// A world that Python steps.
class SteppedWorld {
 public:
  SteppedWorld(const std::string& field, const std::string& robot, const std::string& physics,
               const Matrix& robots, const Matrix& balls, const Matrix& discs)
      : world_(made(field, robot, physics, robots, balls, discs)) {}

  void step(const Matrix& commands, std::int64_t ticks) {
    const Exclusive::Use use(exclusive_, "the world");
    requirePairs(commands.shape(0), commands.shape(1));
    const std::vector<WheelSpeeds> speeds = speedsOf(commands.data());
    const nb::gil_scoped_release for_the_work;
    for (std::int64_t i = 0; i < ticks; ++i) advance(speeds, static_cast<std::size_t>(i));
  }

  nb::tuple run(const Commands& commands) {
    const Exclusive::Use use(exclusive_, "the world");
    requirePairs(commands.shape(1), commands.shape(2));
    const std::size_t ticks = commands.shape(0), robots = robotCount() * kRobotColumns,
                      balls = world_.state().balls.size() * kBallColumns;
    std::vector<double> robot_rows(ticks * robots), ball_rows(ticks * balls);
    {
      const nb::gil_scoped_release for_the_work;
      for (std::size_t i = 0; i < ticks; ++i) {
        advance(speedsOf(commands.data() + i * robotCount() * 2), i);
        put(world_.state(), robot_rows.data() + i * robots, ball_rows.data() + i * balls);
      }
    }
    return nb::make_tuple(arrayOf(std::move(robot_rows), {ticks, robotCount(), kRobotColumns}),
                          arrayOf(std::move(ball_rows), {ticks, world_.state().balls.size(), kBallColumns}));
  }

  nb::tuple state() {
    const Exclusive::Use use(exclusive_, "the world");
    const std::size_t balls = world_.state().balls.size();
    std::vector<double> robot_rows(robotCount() * kRobotColumns), ball_rows(balls * kBallColumns), obstacles;
    put(world_.state(), robot_rows.data(), ball_rows.data());
    for (const ObstacleState& o : world_.state().obstacles) {
      obstacles.insert(obstacles.end(),
                       {o.pose.position.x, o.pose.position.y, o.pose.heading, o.velocity.x, o.velocity.y});
    }
    const std::size_t count = world_.state().obstacles.size();
    return nb::make_tuple(arrayOf(std::move(robot_rows), {robotCount(), kRobotColumns}),
                          arrayOf(std::move(ball_rows), {balls, kBallColumns}),
                          arrayOf(std::move(obstacles), {count, kObstacleColumns}));
  }

  nb::list contacts() {
    const Exclusive::Use use(exclusive_, "the world");
    static constexpr const char* kNames[] = {"wall", "robot", "ball", "obstacle"};
    nb::list list;
    for (const ContactEvent& contact : world_.contacts()) {
      list.append(nb::make_tuple(kNames[static_cast<std::size_t>(contact.a.kind)], contact.a.index,
                                 kNames[static_cast<std::size_t>(contact.b.kind)], contact.b.index,
                                 contact.point.x, contact.point.y, contact.normal.x, contact.normal.y,
                                 contact.impulse, contact.began));
    }
    return list;
  }

  std::int64_t tick() {
    const Exclusive::Use use(exclusive_, "the world");
    return world_.state().tick;
  }
  double dt() const { return world_.config().physics.controlPeriod(); }
  double maxWheelSpeed() const { return max_wheel_speed_; }
  std::size_t robotCount() const { return world_.config().robots.size(); }
  std::uint64_t hash() {
    const Exclusive::Use use(exclusive_, "the world");
    StateHash hash;
    hash.add(world_.state());
    return hash.value();
  }

 private:
  World made(const std::string& field, const std::string& robot, const std::string& physics,
             const Matrix& robots, const Matrix& balls, const Matrix& discs) {
    const RobotPreset preset = valueOf(loadRobot(robot));
    max_wheel_speed_ = preset.robot.max_wheel_speed;
    return valueOf(
        World::create({valueOf(loadField(field)), valueOf(loadPhysics(physics)),
                       robotsOf(robots, preset.robot), ballsOf(balls, preset.ball), discsOf(discs)}));
  }
  void requirePairs(std::size_t rows, std::size_t columns) const {
    if (rows == robotCount() && columns == 2) return;
    raise(ErrorCode::kUsage, "commands: two wheels for each of " + std::to_string(robotCount()) + " robots");
  }
  std::vector<WheelSpeeds> speedsOf(const double* pairs) const {
    std::vector<WheelSpeeds> speeds(robotCount());
    for (WheelSpeeds& speed : speeds) {
      speed.left = *pairs++;
      speed.right = *pairs++;
    }
    return speeds;
  }
  void advance(const std::vector<WheelSpeeds>& speeds, std::size_t done) {
    if (done % kTicksBetweenChecks == kTicksBetweenChecks - 1) checkSignals();
    world_.step(speeds);
  }

  double max_wheel_speed_ = 0.0;
  World world_;
  Exclusive exclusive_;
};

}  // namespace

void bindWorld(nb::module_& m) {
  nb::class_<SteppedWorld>(m, "SteppedWorld", "A world: see fulbito.World, which checks the arrays.")
      .def(nb::init<const std::string&, const std::string&, const std::string&, const Matrix&, const Matrix&,
                    const Matrix&>(),
           nb::arg("field"), nb::arg("robot"), nb::arg("physics"), nb::arg("robots").noconvert(),
           nb::arg("balls").noconvert(), nb::arg("discs").noconvert())
      .def("step", &SteppedWorld::step, nb::arg("commands").noconvert(), nb::arg("ticks"),
           "Runs ticks with the same commands.")
      .def("run", &SteppedWorld::run, nb::arg("commands").noconvert(),
           nb::sig("def run(self, commands: numpy.typing.NDArray[numpy.float64]) -> "
                   "tuple[numpy.typing.NDArray[numpy.float64], numpy.typing.NDArray[numpy.float64]]"),
           "Runs a tick per row; robots and balls after each.")
      .def("state", &SteppedWorld::state,
           nb::sig("def state(self) -> tuple[numpy.typing.NDArray[numpy.float64], "
                   "numpy.typing.NDArray[numpy.float64], numpy.typing.NDArray[numpy.float64]]"),
           "Robots, balls and obstacles now.")
      .def("contacts", &SteppedWorld::contacts,
           nb::sig("def contacts(self) -> list[tuple[str, int, str, int, float, float, float, float, float, "
                   "bool]]"),
           "Contacts of the last tick.")
      .def("hash", &SteppedWorld::hash, "Hash of the state.")
      .def_prop_ro("tick", &SteppedWorld::tick, "Ticks so far.")
      .def_prop_ro("dt", &SteppedWorld::dt, "[s] of a tick.")
      .def_prop_ro("max_wheel_speed", &SteppedWorld::maxWheelSpeed, "[rad/s]")
      .def_prop_ro("robot_count", &SteppedWorld::robotCount, "Number of robots.");
}

}  // namespace fulbito::python
