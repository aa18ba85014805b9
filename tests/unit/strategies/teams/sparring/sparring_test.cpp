#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "strategies/skills/area_projection.hpp"
#include "strategies/skills/positions.hpp"
#include "tests/support/catch.hpp"
#include "tests/unit/strategies/teams/libero/scenes.hpp"

namespace fulbito {
namespace {

const std::vector<std::string> kSchools = {"univector", "twins",    "marker", "block",   "counter",
                                           "presser",   "dribbler", "kicker", "spinner", "sweeper"};

/// What a school does, as shares of the time of play.
struct Habits {
  double keeper_out = 0.0;  ///< the keeper is farther than 30 cm from its goal's middle
  double goal_side = 0.0;   ///< both field players are between ball and own goal line
  double both_near = 0.0;   ///< both field players are within 20 cm of the ball
  double at_rebound = 0.0;  ///< of the ball in their half: one is at the rebound spot
  double marks = 0.0;       ///< one is goal-side of an opponent and within 20 cm of it
  double at_home = 0.0;     ///< both field players are in the own half, and goal-side of the ball
  double spins = 0.0;       ///< a field player at the ball turns faster than 8 rad/s
  double intruders = 0.0;   ///< a field player is in the own area
  double locked = 0.0;      ///< two mates touch and are slower than 0.12 m/s, away from the ball
  double far = 0.0;         ///< [m] mean distance of the farther field player from the ball
};

/// The first half of a match as the school sees it: it is blue, and its goal is at -x.
class Watch {
 public:
  explicit Watch(const FieldGeometry& field) : field_(field) {}

  void look(const Match& match) {
    std::vector<RobotState> own, theirs;
    for (std::size_t k = 0; k < match.ids().size(); ++k) {
      (match.ids()[k].team == TeamId::kBlue ? own : theirs).push_back(match.world().robots[k]);
    }
    if (own.size() == 3 && theirs.size() == 3) add(own, theirs, match.world().balls[0].position);
  }

  Habits habits() const {
    Habits h = sum_;
    for (double* share : {&h.keeper_out, &h.goal_side, &h.both_near, &h.marks, &h.at_home, &h.spins,
                          &h.intruders, &h.locked, &h.far}) {
      *share /= ticks_;
    }
    h.at_rebound /= std::max(1.0, attacking_);
    return h;
  }

 private:
  void add(const std::vector<RobotState>& own, const std::vector<RobotState>& theirs, Vec2 ball) {
    const auto at = [&](std::size_t i) { return own[i].pose.position; };
    ++ticks_;
    sum_.keeper_out += distance(at(0), ownGoal(field_)) > 0.30;
    const auto from = [&](Vec2 p) { return distance(p, ownGoal(field_)); };
    sum_.goal_side += std::max(from(at(1)), from(at(2))) < from(ball);
    const double a = distance(at(1), ball), b = distance(at(2), ball);
    sum_.both_near += std::max(a, b) < 0.20;
    sum_.far += std::max(a, b);
    sum_.at_home += std::max(at(1).x, at(2).x) < 0.0 && std::max(from(at(1)), from(at(2))) < from(ball);
    bool marks = false, spins = false, intrudes = false;
    for (const std::size_t i : {1U, 2U}) {
      spins = spins || (distance(at(i), ball) < 0.12 && std::abs(own[i].angular_velocity) > 8.0);
      intrudes = intrudes || isInArea(field_, at(i), true);
      for (const RobotState& man : theirs) {
        const Vec2 p = man.pose.position;
        const bool free = distance(p, ball) > 0.25 && !isInArea(field_, p, false);
        marks = marks || (free && distance(at(i), p) < 0.20 && at(i).x < p.x);
      }
    }
    sum_.marks += marks, sum_.spins += spins, sum_.intruders += intrudes;
    const bool slow = norm(own[1].velocity) < 0.12 && norm(own[2].velocity) < 0.12;
    sum_.locked += slow && distance(at(1), at(2)) < 0.085 && std::min(a, b) > 0.12;
    if (ball.x > 0.1) {
      ++attacking_;
      const Vec2 spot = reboundSpot(field_, ball);
      sum_.at_rebound += std::min(distance(at(1), spot), distance(at(2), spot)) < 0.15;
    }
  }

  FieldGeometry field_;
  Habits sum_;
  double ticks_ = 0.0, attacking_ = 0.0;
};

/// How far [m] off the middle a ball crosses the other half, which nobody defends.
double passesAt(const std::string& school) {
  Placement scene;
  scene.ball = {-0.1, 0.2};
  scene.robots[0] = {Pose2{{-0.7, 0.0}, 1.57}, Pose2{{-0.35, 0.15}, 0.0}, Pose2{{-0.5, -0.2}, 0.0}};
  scene.robots[1] = {Pose2{{0.7, 0.0}, 1.57}, Pose2{{-0.3, -0.5}, 0.0}, Pose2{{0.2, -0.5}, 0.0}};
  Match match = test::matchFrom(test::matchOf(school.c_str(), "idle", "vsss-3v3", 20.0), scene);
  while (match.placement().ball.x < 0.45 && match.step()) {
  }
  return std::abs(match.placement().ball.y);
}

/// The school's habits against `classic`, in the first halves of `matches` matches.
Habits habitsOf(const std::string& school, std::uint64_t matches = 16) {
  auto config = test::matchOf(school.c_str(), "classic", "vsss-3v3", 60.0);
  Watch watch(config.field);
  for (config.seed = 1; config.seed <= matches; ++config.seed) {
    auto match = Match::create(config);
    REQUIRE(match);
    while (match->step() && match->referee().period == 1) watch.look(*match);
  }
  return watch.habits();
}

}  // namespace

TEST_CASE("sparring teams keep goal, stay out of their area and do not lock their mates", "[unit]") {
  for (const std::string& school : kSchools) {
    CAPTURE(school);
    const Habits habits = habitsOf(school, 12);
    if (school != "sweeper") CHECK(habits.keeper_out < 0.03);
    CHECK(habits.intruders < 0.02);
    CHECK(habits.locked < 0.01);
    CHECK(habits.goal_side > 0.65);
  }
}

TEST_CASE("each school does what it is named after more than another does", "[unit]") {
  const Habits plain = habitsOf("univector");
  CHECK(habitsOf("twins").at_rebound > plain.at_rebound + 0.3);
  CHECK(habitsOf("marker").marks > plain.marks + 0.07);
  CHECK(habitsOf("block").at_home > plain.at_home + 0.12);
  CHECK(habitsOf("presser").both_near > plain.both_near + 0.2);
  CHECK(habitsOf("kicker").both_near > plain.both_near + 0.03);
  CHECK(habitsOf("spinner").spins > plain.spins + 0.05);
  CHECK(habitsOf("univector:spins=true").spins > plain.spins + 0.05);
  CHECK(habitsOf("sweeper").keeper_out > plain.keeper_out + 0.1);
  // The wall waits in front of its area, and those who counter wait as far from the ball.
  CHECK(habitsOf("block").far > plain.far + 0.15);
  CHECK(habitsOf("counter").far > plain.far + 0.1);
  // Duels bring every ball to the walls; this ball meets none.
  CHECK(passesAt("dribbler") > 0.5);
  CHECK(passesAt("univector") < 0.35);
}

TEST_CASE("sparring teams play every robot, five a side, and with old and noisy pictures", "[unit]") {
  for (const std::string& school : kSchools) {
    CAPTURE(school);
    auto config = test::matchOf(school.c_str(), "chaser", "vsss-5v5", 10.0);
    config.robot = *loadRobot("firasim");
    for (VisionModel& vision : config.vision) vision.latency_ticks = 2, vision.position_noise = 0.002;
    auto match = Match::create(config);
    REQUIRE(match);
    while (match->step()) {
    }
    CHECK(match->faults().teams[0].rejected() == 0);
    CHECK(match->referee().score[1] <= 3);
  }
}

}  // namespace fulbito
