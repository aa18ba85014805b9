#include <algorithm>

#include "strategies/interface/team_info.hpp"
#include "strategies/skills/positions.hpp"
#include "strategies/teams/sparring/school.hpp"

namespace fulbito::sparring {
namespace {

/// Kick-and-rush: a long run-up, a strike upfield at full speed, and everyone follows the ball.
class Kicker final : public School {
 public:
  using School::School;

 protected:
  const char* roleName(std::size_t rank) const override {
    return rank == 0 ? "keeper" : rank == 1 ? "kicker" : "rusher";
  }

  RobotCommand play(const Observation& now, std::size_t i, std::size_t rank) override {
    const Vec2 ball = now.ball.position;
    if (rank == 1) {
      Style style;
      // From afar any way to the end wall will do: the straightest has the greatest speed.
      if (ball.x < 0.0)
        style.toward =
            Vec2{field().length / 2, std::clamp(1.5 * ball.y, -0.4 * field().width, 0.4 * field().width)};
      style.bend = 0.8;
      style.room = 0.05;
      return attack(now, i, style);
    }
    // The others rush after it, one on each side of its way, and strike what they reach first.
    const double lead = timeToReach(foresight().pace(), now.own[i].state, ball);
    if (lead < theirTime(now, ball) && now.own[i].state.pose.position.x < ball.x) return attack(now, i);
    const double side = rank % 2 == 0 ? 1.0 : -1.0;
    const Vec2 to_goal = unitOr(opponentGoal(field()) - ball, {1.0, 0.0});
    const double behind = 0.15 * static_cast<double>(rank);
    return stand(ball - to_goal * behind + perp(to_goal) * (0.12 * side * (ball.y > 0.0 ? -1.0 : 1.0)));
  }
};

}  // namespace

TeamInfo kickerInfo() {
  return describeTeam<School::Params, Kicker>("kicker",
                                              "strikes upfield at full speed, and all follow the ball",
                                              School::parameters(), "univector:follower=classic");
}

}  // namespace fulbito::sparring
