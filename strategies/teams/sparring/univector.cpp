#include "strategies/interface/team_info.hpp"
#include "strategies/skills/area_projection.hpp"
#include "strategies/skills/ball_posture.hpp"
#include "strategies/skills/positions.hpp"
#include "strategies/teams/sparring/school.hpp"

namespace fulbito::sparring {
namespace {

/// The school of Kim et al.: one attacker follows a univector field round the opponents into the posture
/// behind the ball, a second one covers the way to the own goal.
class UnivectorSchool final : public School {
 public:
  using School::School;

 protected:
  const char* roleName(std::size_t rank) const override {
    return rank == 0 ? "keeper" : rank == 1 ? "attacker" : "cover";
  }

  void restart() override {
    round_.fill(false);
    lined_up_.fill(false);
  }

  RobotCommand play(const Observation& now, std::size_t i, std::size_t rank) override {
    constexpr double kCover = 0.35,
                     kAside = 0.2;  // [m] behind the ball, and from the middle line between them
    if (rank == 1) return posture(now, i);
    const Vec2 ball = now.ball.position;
    const Vec2 cover = shadowPoint(field(), ball, kCover);
    if (rank == 2) return stand(cover);
    return stand(cover + Vec2{-0.1, ball.y > 0.0 ? -kAside * static_cast<double>(rank - 2)
                                                 : kAside * static_cast<double>(rank - 2)});
  }

 private:
  /// The field plans while the robot is on its way; near the ball, or when an opponent comes first, it
  /// drives.
  RobotCommand posture(const Observation& now, std::size_t i) {
    const RobotState& robot = now.own[i].state;
    const Vec2 ball = meeting(now, i, opponentGoal(field()));
    const Vec2 direction = wanted(now, ball);
    PostureSettings settings;
    settings.standoff = info().robot.length / 2 + info().ball.radius;
    lined_up_[i] = isLinedUp(sideOfBall(robot, ball, direction), lined_up_[i], settings);
    const double far = distance(robot.pose.position, ball);
    const bool contested = theirTime(now, ball) < timeToReach(foresight().pace(), robot, ball) + 0.15;
    if (lined_up_[i] || contested || far < kNear || wallClearance(field(), ball) < kNear / 2)
      return attack(now, i);
    const BallApproach approach = approachBall(robot, ball, direction, round_[i], settings);
    round_[i] = approach.round;
    GoTo go_to = approach.go_to;
    go_to.avoid_ball = true;
    go_to.position = insideWalls(field(), go_to.position, info().robot.width / 2);
    if (now.own[0].present && isInArea(field(), go_to.position, true, info().robot.circumradius()))
      return attack(now, i);
    return RobotCommand::drivingTo(go_to);
  }

  static constexpr double kNear = 0.2;  // [m] here all robots are in the way, and the field would turn away
  std::array<bool, kMaxTeamSize> round_{}, lined_up_{};
};

}  // namespace

TeamInfo univectorInfo() {
  return describeTeam<School::Params, UnivectorSchool>(
      "univector", "a univector field leads the attacker round opponents into the posture behind the ball",
      School::parameters(), "univector:follower=classic");
}

}  // namespace fulbito::sparring
