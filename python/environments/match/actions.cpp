#include "python/environments/match/actions.hpp"

#include <algorithm>

#include "fulbito/detail/math.hpp"
#include "python/environments/match/compat.hpp"

namespace fulbito {

std::size_t numbersOf(ActionForm form) {
  if (form == ActionForm::kSkill) return 1;
  return form == ActionForm::kGoTo ? 3 : 2;
}

RobotCommand commandOf(ActionForm form, const MatchConfig& match, std::span<const float> action) {
  const RobotModel& robot = match.robot.robot;
  const auto number = [&](std::size_t i) { return std::clamp(double{action[i]}, -1.0, 1.0); };
  switch (form) {
    case ActionForm::kTwist:
      return RobotCommand::byTwist(
          {number(0) * robot.maxSpeed(), number(1) * 2.0 * robot.maxSpeed() / robot.axle_track});
    case ActionForm::kGoTo: {
      GoTo place;
      place.position = {number(0) * match.field.length / 2, number(1) * match.field.width / 2};
      place.heading = number(2) * math::kPi;
      return RobotCommand::drivingTo(place);
    }
    case ActionForm::kCompat:
      return RobotCommand::byWheels(compatWheels(robot, action));
    case ActionForm::kWheels:
    case ActionForm::kSkill:
      break;
  }
  return RobotCommand::byWheels({number(0) * robot.max_wheel_speed, number(1) * robot.max_wheel_speed});
}

}  // namespace fulbito
