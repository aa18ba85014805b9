#include <cmath>

#include "strategies/interface/team_info.hpp"
#include "strategies/skills/positions.hpp"
#include "strategies/teams/sparring/school.hpp"

namespace fulbito::sparring {
namespace {

/// Spins: at walls, in duels and before both goals the robot at the ball turns in place and throws it out to
/// the side that suits it; in the open it drives.
class Spinner final : public School {
 public:
  using School::School;

 protected:
  const char* roleName(std::size_t rank) const override {
    return rank == 0 ? "keeper" : rank == 1 ? "spinner" : "cover";
  }

  RobotCommand play(const Observation& now, std::size_t i, std::size_t rank) override {
    const Vec2 ball = now.ball.position;
    if (rank > 1) return stand(shadowPoint(field(), ball, 0.2 * static_cast<double>(rank - 1)));
    Style style;
    style.spins.slow = 0.7;
    style.spins.lock_out = 0.25;
    const bool duel = theirTime(now, ball) < 0.25;
    const bool before_goal =
        std::abs(ball.x) > field().length / 2 - 0.3 && std::abs(ball.y) < field().goal_area_width / 2;
    style.spins.wall = duel || before_goal ? field().width : 0.08;
    style.spins.reach = spinReach();
    // A robot upfield of the ball would throw it at its own goal unless it stands at the ball's side.
    const Vec2 from = ball - now.own[i].state.pose.position;
    if (from.x < 0.0 && std::abs(from.y) < 0.5 * std::abs(from.x)) style.spins.reach = 0.0;
    return attack(now, i, style);
  }
};

}  // namespace

TeamInfo spinnerInfo() {
  return describeTeam<School::Params, Spinner>("spinner",
                                               "spins at walls, in duels and in front of both goals",
                                               School::parameters(), "univector:follower=classic");
}

}  // namespace fulbito::sparring
