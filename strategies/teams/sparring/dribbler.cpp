#include <algorithm>
#include <cmath>

#include "strategies/interface/team_info.hpp"
#include "strategies/skills/positions.hpp"
#include "strategies/teams/sparring/school.hpp"

namespace fulbito::sparring {
namespace {

/// Wall-hugging: the ball goes to the nearer side wall, along it, round the corner and in along the end wall.
/// The second follows behind the ball, and waits before the goal once it is in the corner.
class Dribbler final : public School {
 public:
  using School::School;

 protected:
  const char* roleName(std::size_t rank) const override {
    return rank == 0 ? "keeper" : rank == 1 ? "dribbler" : "follower";
  }

  RobotCommand play(const Observation& now, std::size_t i, std::size_t rank) override {
    constexpr double kBehind = 0.28;  // [m] between the ball and who follows it
    const Vec2 ball = now.ball.position;
    const double side = ball.y >= 0.0 ? 1.0 : -1.0;
    if (rank == 1) return dribble(now, i, side);
    const bool in_corner = ball.x > field().length / 2 - 0.25 && std::abs(ball.y) > field().goal_width / 2;
    if (rank == 2 && in_corner) return stand({field().length / 2 - 0.3, 0.05 * side});
    const double along = static_cast<double>(rank - 1);
    if (ball.x < 0.0) return stand(shadowPoint(field(), ball, kBehind * along));
    return stand(ball + Vec2{-kBehind * along, -0.1 * side * along});
  }

 private:
  RobotCommand dribble(const Observation& now, std::size_t i, double side) {
    const Vec2 ball = now.ball.position;
    const double wall = field().width / 2 - info().ball.radius;
    Style style;
    const bool at_mouth = std::abs(ball.y) < field().goal_width / 2 && ball.x > field().length / 4;
    // Upfield to the wall; what lies before the goal is shot at it.
    if (!at_mouth)
      style.toward =
          Vec2{std::min(ball.x + 0.8 * (wall - side * ball.y) + 0.1, field().length / 2), side * wall};
    // A spin would lose the ball that the wall holds; in the corner it turns it round.
    const bool in_corner = ball.x > field().length / 2 - 0.12;
    style.spins.reach = in_corner ? style.spins.reach : 0.0;
    style.straight = false;
    return attack(now, i, style);
  }
};

}  // namespace

TeamInfo dribblerInfo() {
  return describeTeam<School::Params, Dribbler>(
      "dribbler", "carries the ball along the side wall and hooks it in along the end wall",
      School::parameters(), "univector:follower=classic");
}

}  // namespace fulbito::sparring
