#include <cmath>

#include "fulbito/detail/math.hpp"
#include "strategies/interface/team_info.hpp"
#include "strategies/skills/positions.hpp"
#include "strategies/teams/sparring/school.hpp"

namespace fulbito::sparring {
namespace {

/// Two attackers: the one at the ball plays it at the goal, or across to the rebound spot, where the other
/// waits. In the own half both go to the ball.
class Twins final : public School {
 public:
  using School::School;

 protected:
  const char* roleName(std::size_t rank) const override {
    return rank == 0 ? "keeper" : rank == 1 ? "attacker" : rank == 2 ? "twin" : "cover";
  }

  RobotCommand play(const Observation& now, std::size_t i, std::size_t rank) override {
    const Vec2 ball = now.ball.position;
    const bool attacking = ball.x > 0.0;
    if (rank == 1) return attacking ? shotOrPass(now, i) : attack(now, i);
    if (rank > 2) return stand(shadowPoint(field(), ball, 0.2 + 0.2 * static_cast<double>(rank - 2)));
    if (!attacking) return attack(now, i);
    // The twin waits where the ball comes to, and takes it once it comes.
    const Vec2 spot = reboundSpot(field(), ball);
    const auto crossing = foresight().ball().positionAt(0.4);
    if (distance(crossing, spot) < distance(ball, spot) - 0.1) return attack(now, i);
    return stand(spot, math::angleOf(opponentGoal(field()) - spot));
  }

 private:
  /// From a steep angle the goal is narrow: the ball goes along in front of it to the twin.
  RobotCommand shotOrPass(const Observation& now, std::size_t i) {
    const Vec2 ball = now.ball.position, to_goal = opponentGoal(field()) - ball;
    const bool steep = std::abs(to_goal.y) > 1.5 * to_goal.x;
    Style style;
    if (steep && order().size() > 1) style.toward = reboundSpot(field(), ball);
    return attack(now, i, style);
  }
};

}  // namespace

TeamInfo twinsInfo() {
  return describeTeam<School::Params, Twins>(
      "twins", "two attackers: one at the ball, the other at the spot where its passes and rebounds arrive",
      School::parameters(), "univector:follower=classic");
}

}  // namespace fulbito::sparring
