#include <algorithm>
#include <cmath>

#include "fulbito/detail/math.hpp"
#include "strategies/interface/team_info.hpp"
#include "strategies/skills/unsticking.hpp"

namespace fulbito {
namespace {

/// Drives every robot straight at the ball with the nearer end leading. A robot that has stood at a wall for
/// a while backs off.
class Chaser final : public Strategy {
 public:
  struct Params {};
  explicit Chaser(Params) {}

  void begin(const MatchInfo& info) override {
    info_ = info;
    unsticking_.fill({});
  }

  TeamCommand decide(const Observation& observation) override {
    TeamCommand command;
    for (std::size_t i = 0; i < static_cast<std::size_t>(observation.team_size); ++i) {
      if (!observation.own[i].present) continue;
      const RobotState& robot = observation.own[i].state;
      const bool at_wall =
          wallClearance(info_.field, robot.pose.position) < info_.robot.circumradius() + 0.02;
      const auto free = unsticking_[i].update(robot, observation.playing && at_wall, observation.dt);
      command.robots[i] = RobotCommand::byTwist(free ? *free : chase(robot, observation.ball.position));
    }
    return command;
  }

 private:
  Twist chase(const RobotState& robot, Vec2 ball) const {
    double error = math::wrapAngle(math::angleOf(ball - robot.pose.position) - robot.pose.heading);
    const bool backward = std::abs(error) > math::kPi / 2;
    if (backward) error = math::wrapAngle(error + math::kPi);
    const double speed = info_.robot.maxSpeed() * std::max(0.0, math::cos(error));
    return {backward ? -speed : speed, 10.0 * error};
  }

  MatchInfo info_;
  std::array<Unsticking, kMaxTeamSize> unsticking_;
};

}  // namespace

TeamInfo chaserInfo() {
  return describeTeam<Chaser::Params, Chaser>("chaser", "all robots drive straight at the ball", {});
}

}  // namespace fulbito
