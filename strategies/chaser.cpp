#include "strategies/chaser.hpp"

#include <algorithm>
#include <cmath>

#include "engine/core/math.hpp"

namespace fulbito {
namespace {

/// Drives every robot straight at the ball with whichever end is nearer.
class Chaser final : public Strategy {
 public:
  void begin(const MatchInfo& info) override { info_ = info; }

  TeamCommand decide(const Observation& observation) override {
    TeamCommand command;
    for (std::size_t i = 0; i < static_cast<std::size_t>(observation.team_size); ++i) {
      if (observation.own[i].present) {
        command.robots[i] = RobotCommand::byTwist(chase(observation.own[i].state, observation.ball.position));
      }
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
};

}  // namespace

TeamInfo chaserInfo() {
  return {"chaser",
          "everyone drives straight at the ball",
          {},
          false,
          {},
          [](const std::vector<Setting>&) -> Result<std::unique_ptr<Strategy>> {
            return std::unique_ptr<Strategy>(std::make_unique<Chaser>());
          }};
}

}  // namespace fulbito
