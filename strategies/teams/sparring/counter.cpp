#include <algorithm>

#include "strategies/interface/team_info.hpp"
#include "strategies/skills/positions.hpp"
#include "strategies/teams/sparring/school.hpp"

namespace fulbito::sparring {
namespace {

/// Counter-attack: all wait deep and goal-side while the opponents have the ball. Once a robot is first at it
/// by a margin, it drives it straight at the goal and a second one runs along for the rebound.
class Counter final : public School {
 public:
  using School::School;

 protected:
  const char* roleName(std::size_t rank) const override {
    return rank == 0 ? "keeper" : breaks_ ? (rank == 1 ? "breaker" : "runner") : "waits";
  }

  void restart() override { breaks_ = false; }

  RobotCommand play(const Observation& now, std::size_t i, std::size_t rank) override {
    const Vec2 ball = now.ball.position;
    if (rank == 1) breaks_ = isChance(now, i);
    const double out = 0.5 * field().goal_area_depth + 0.25 * (ball.x + field().length / 2);
    if (!breaks_) {
      // Nobody waits for a kick-off, or near the own goal.
      const bool kick_off = now.restart == RestartKind::kKickOff && now.since_restart < 1.5;
      const bool press = rank == 1 && (kick_off || ball.x < 0.0);
      return press ? attack(now, i)
                   : stand(shadowPoint(field(), ball,
                                       std::max(0.15, out) + 0.15 * static_cast<double>(rank - 1)));
    }
    if (rank == 1) return attack(now, i);
    if (rank == 2) {
      Vec2 run = reboundSpot(field(), ball);
      run.x = std::min(run.x, ball.x + 0.25);
      return stand(run);
    }
    return stand(shadowPoint(field(), ball, 0.4));
  }

 private:
  bool isChance(const Observation& now, std::size_t i) const {
    const double lead = breaks_ ? -0.3 : 0.1;  // [s] a break goes on until the ball is clearly lost
    const Vec2 ball = meeting(now, i, opponentGoal(field()));
    return timeToReach(foresight().pace(), now.own[i].state, ball) + lead < theirTime(now, ball);
  }

  bool breaks_ = false;
};

}  // namespace

TeamInfo counterInfo() {
  return describeTeam<School::Params, Counter>(
      "counter", "waits deep until it is first at the ball, then breaks fast with two robots",
      School::parameters(), "univector:follower=classic");
}

}  // namespace fulbito::sparring
