#include <algorithm>

#include "fulbito/detail/math.hpp"
#include "strategies/interface/team_info.hpp"
#include "strategies/skills/area_projection.hpp"
#include "strategies/skills/positions.hpp"
#include "strategies/teams/sparring/school.hpp"

namespace fulbito::sparring {
namespace {

/// A keeper that attacks: it stands before its area while the ball is far, and drives out at every ball in
/// its half that it reaches first. A field player covers the goal meanwhile.
class Sweeper final : public School {
 public:
  using School::School;

 protected:
  const char* roleName(std::size_t rank) const override {
    return rank == 0 ? "sweeper" : rank == 1 ? "attacker" : "cover";
  }

  void restart() override { out_ = false; }

  RobotCommand play(const Observation& now, std::size_t i, std::size_t rank) override {
    const Vec2 ball = now.ball.position;
    if (rank == 1 && !out_) return attack(now, i);
    if (rank <= 2 && out_) return stand(shadowPoint(field(), ball, 0.5 * (ball.x + field().length / 2)));
    // The sweeper covers the middle: the second goes up to the ball with the first.
    if (ball.x > 0.0) return stand(reboundSpot(field(), ball));
    return stand(shadowPoint(field(), ball, 0.2 * static_cast<double>(rank - 1)));
  }

  RobotCommand keep(const Observation& now, std::size_t i) override {
    constexpr double kFar = 0.2;  // [m] beyond the half-way line the ball is far
    const Vec2 ball = now.ball.position;
    out_ = goesOut(now, i);
    if (out_) return attack(now, i);
    const bool danger = ball.x < kFar || foresight().ball().positionAt(1.0).x < 0.0;
    if (danger) return School::keep(now, i);
    Vec2 place =
        ownGoal(field()) + unitOr(ball - ownGoal(field()), {1.0, 0.0}) * (field().goal_area_depth + 0.15);
    return stand(place, math::kPi / 2);
  }

 private:
  bool goesOut(const Observation& now, std::size_t i) const {
    const double lead = out_ ? 0.0 : 0.15;  // [s]
    const RobotState& robot = now.own[i].state;
    const Vec2 ball = meeting(now, i, opponentGoal(field()));
    if (ball.x > 0.0 || ball.x < robot.pose.position.x || isInArea(field(), ball, true)) return false;
    const double mine = timeToReach(foresight().pace(), robot, ball);
    double mates = 1e9;
    for (const std::size_t mate : order()) {
      mates = std::min(mates, timeToReach(foresight().pace(), now.own[mate].state, ball));
    }
    return mine + lead < std::min(mates, theirTime(now, ball));
  }

  bool out_ = false;
};

}  // namespace

TeamInfo sweeperInfo() {
  return describeTeam<School::Params, Sweeper>(
      "sweeper", "a keeper that leaves its area for every ball that it reaches first", School::parameters(),
      "univector:follower=classic");
}

}  // namespace fulbito::sparring
