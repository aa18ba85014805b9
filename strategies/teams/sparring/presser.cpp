#include "strategies/interface/team_info.hpp"
#include "strategies/skills/positions.hpp"
#include "strategies/teams/sparring/school.hpp"

namespace fulbito::sparring {
namespace {

/// Pressing: two robots go for the ball at once, from both sides of its way to the own goal; nobody waits.
class Presser final : public School {
 public:
  using School::School;

 protected:
  const char* roleName(std::size_t rank) const override {
    return rank == 0 ? "keeper" : rank < 3 ? "presser" : "cover";
  }

  RobotCommand play(const Observation& now, std::size_t i, std::size_t rank) override {
    const Vec2 ball = now.ball.position;
    if (rank <= 2) return attack(now, i);
    return stand(shadowPoint(field(), ball, 0.15 + 0.15 * static_cast<double>(rank - 2)));
  }
};

}  // namespace

TeamInfo presserInfo() {
  return describeTeam<School::Params, Presser>("presser", "two robots press whoever has the ball at once",
                                               School::parameters(), "univector:follower=classic");
}

}  // namespace fulbito::sparring
