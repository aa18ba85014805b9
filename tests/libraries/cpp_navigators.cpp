// Navigators by the C++ wrapper whose guidance shows what they know, and wrong ones.
#include <stdexcept>

#include "fulbito/team.hpp"

namespace {

using namespace fulbito::team;

/// Wheel speeds that repeat what the scene and the settings say.
class Echo : public Navigator {
 public:
  Echo() : Navigator("echo", "for tests", "none", true) { integer("laps", laps_, 1, 9, "", "any number"); }
  void reset() override { resets_ += 1.0; }
  void plan(const NavigationScene& scene, Guidance& guidance) override {
    guidance.kind = Guidance::Kind::kWheels;
    guidance.wheels = {scene.robot.curve_widening + 10.0 * scene.robot.curve_widening_rise,
                       resets_ + 10.0 * laps_ + 100.0 * static_cast<double>(scene.obstacles.size()) +
                           1000.0 * scene.goal_heading.value_or(0.0)};
    guidance.speed_cap = 0.25;
  }

 private:
  int laps_ = 2;
  double resets_ = 0.0;
};

class Timed : public Navigator {
 public:
  explicit Timed(std::string name = "timed", std::size_t speeds = 2) : Navigator(name), speeds_(speeds) {}
  void plan(const NavigationScene& scene, Guidance& guidance) override {
    guidance.kind = Guidance::Kind::kTimedPath;
    guidance.path = {scene.self.position, scene.goal};
    guidance.speeds.assign(speeds_, 0.5);
  }

 private:
  std::size_t speeds_;
};

/// Speeds are missing.
class Short : public Timed {
 public:
  Short() : Timed("short", 1) {}
};

class Throwing : public Navigator {
 public:
  Throwing() : Navigator("throwing") {}
  void plan(const NavigationScene&, Guidance&) override { throw std::runtime_error("no way"); }
};

}  // namespace

FULBITO_NAVIGATORS(Echo, Timed, Short, Throwing)
