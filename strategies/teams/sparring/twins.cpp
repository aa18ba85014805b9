#include "strategies/interface/team_info.hpp"
#include "strategies/skills/positions.hpp"
#include "strategies/teams/sparring/school.hpp"

namespace fulbito {
namespace {

class Twins final : public School {
 public:
  using School::School;

 protected:
  RobotCommand play(const Observation& now, std::size_t i, std::size_t rank) override {
    if (rank == 1) return attack(now, i);
    if (now.ball.position.x < 0) return attack(now, i);
    const Vec2 ball = now.ball.position;
    return stand(shadowPoint(field(), ball, 0.3));
  }
};

}  // namespace

TeamInfo twinsInfo() {
  return describeTeam<School::Params, Twins>("twins", "two attackers: one at the ball, one at the rebound spot",
                                             {}, "univector:follower=classic");
}

}  // namespace fulbito
