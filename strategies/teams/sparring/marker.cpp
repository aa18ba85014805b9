#include <algorithm>

#include "strategies/interface/team_info.hpp"
#include "strategies/skills/area_projection.hpp"
#include "strategies/skills/positions.hpp"
#include "strategies/teams/sparring/school.hpp"

namespace fulbito::sparring {
namespace {

/// Man-marking: the robot that is first goes to the ball; every other one stays goal-side of an opponent, the
/// most dangerous first.
class Marker final : public School {
 public:
  using School::School;

 protected:
  const char* roleName(std::size_t rank) const override {
    return rank == 0 ? "keeper" : rank == 1 ? "attacker" : "marker";
  }

  RobotCommand play(const Observation& now, std::size_t i, std::size_t rank) override {
    if (rank == 1) {
      choose(now);
      return attack(now, i);
    }
    const Vec2 ball = now.ball.position;
    if (rank - 2 >= count_) return stand(shadowPoint(field(), ball, 0.3));
    const Vec2 man = now.opponents[men_[rank - 2]].state.pose.position;
    // Close on the way to the own goal, turned toward the ball, which the opponent waits for.
    const double close = 2.0 * info().robot.circumradius() + 0.02;
    const Vec2 mark = man + unitOr(ownGoal(field()) - man, {-1.0, 0.0}) * close;
    const Vec2 cut = unitOr(ball - mark, {1.0, 0.0}) * 0.03;
    return stand(mark + cut);
  }

 private:
  /// The opponents to mark, by their distance to the own goal and to the ball.
  void choose(const Observation& now) {
    std::array<double, kMaxTeamSize> danger{};
    count_ = 0;
    for (std::size_t k = 0; k < static_cast<std::size_t>(now.team_size); ++k) {
      if (!now.opponents[k].present) continue;
      const Vec2 p = now.opponents[k].state.pose.position;
      // The first takes the man at the ball; their keeper needs no marker.
      if (isInArea(field(), p, false) || distance(p, now.ball.position) < kAtBall) continue;
      danger[k] = distance(p, ownGoal(field())) + 0.5 * distance(p, now.ball.position);
      men_[count_++] = k;
    }
    std::sort(men_.begin(), men_.begin() + static_cast<std::ptrdiff_t>(count_),
              [&](std::size_t a, std::size_t b) {
                return danger[a] < danger[b] || (danger[a] == danger[b] && a < b);
              });
  }

  static constexpr double kAtBall = 0.12;  // [m] from the ball: the opponent has it
  std::array<std::size_t, kMaxTeamSize> men_{};
  std::size_t count_ = 0;
};

}  // namespace

TeamInfo markerInfo() {
  return describeTeam<School::Params, Marker>(
      "marker", "man-marking: each field player stays goal-side of an opponent, one goes to the ball",
      School::parameters(), "univector:follower=classic");
}

}  // namespace fulbito::sparring
