#include <algorithm>
#include <cmath>

#include "fulbito/detail/math.hpp"
#include "strategies/interface/team_info.hpp"
#include "strategies/skills/positions.hpp"
#include "strategies/teams/sparring/school.hpp"

namespace fulbito::sparring {
namespace {

/// A wall of two in front of the own area covers the near and the far half of the goal. Who is nearer clears
/// long what comes within reach; only a ball that nobody else reaches draws a robot out.
class Block final : public School {
 public:
  using School::School;

 protected:
  const char* roleName(std::size_t rank) const override {
    return rank == 0 ? "keeper" : rank < 3 ? "wall" : "outlet";
  }

  RobotCommand play(const Observation& now, std::size_t i, std::size_t rank) override {
    const Vec2 ball = now.ball.position;
    if (rank == 1 && (isClearable(now, i) || order().size() == 1)) return clear(now, i);
    if (rank > 2) return stand({0.1, std::copysign(field().width / 4, rank == 3 ? ball.y : -ball.y)});
    // The two stand side by side on the ways from the ball to the halves of the goal.
    const Vec2 toward = unitOr(ball - ownGoal(field()), {1.0, 0.0});
    const double out = field().goal_area_depth + info().robot.circumradius() + 0.1;
    const Vec2 middle = ownGoal(field()) + toward * std::max(out, 0.6 * (ball.x + field().length / 2) * 0.6);
    const double apart = info().robot.length / 2 + 0.01;
    const std::size_t mate = order().size() > 1 ? order()[rank == 1 ? 1 : 0] : i;
    const bool left =
        dot(perp(toward), now.own[i].state.pose.position - now.own[mate].state.pose.position) > 0.0;
    return stand(middle + perp(toward) * (left ? apart : -apart), math::angleOf(perp(toward)));
  }

 private:
  bool isClearable(const Observation& now, std::size_t i) const {
    constexpr double kReach = 0.35, kLead = 0.2;  // [m], [s]
    const RobotState& robot = now.own[i].state;
    const Vec2 ball = now.ball.position;
    if (distance(ball, robot.pose.position) < kReach || ball.x < -0.15) return true;
    return timeToReach(foresight().pace(), robot, ball) + kLead < theirTime(now, ball);
  }

  /// Far from the opponents' goal the ball goes long, up the side where it is; near it, at the goal.
  RobotCommand clear(const Observation& now, std::size_t i) {
    const Vec2 ball = now.ball.position;
    Style style;
    if (ball.x < 0.0) style.toward = Vec2{field().length / 2, std::copysign(0.4 * field().width, ball.y)};
    return attack(now, i, style);
  }
};

}  // namespace

TeamInfo blockInfo() {
  return describeTeam<School::Params, Block>("block", "wall of two in front of the area, which clears long",
                                             School::parameters(), "univector:follower=classic");
}

}  // namespace fulbito::sparring
