#include "strategies/teams/libero/attack/press.hpp"
#include "strategies/teams/libero/playbook/skills.hpp"

namespace fulbito::libero::keeper {
namespace {

bool isFirst(const Picture& picture, int robot) {
  const double own = squaredNorm(picture.ballFrom(robot));
  for (int i = 0; i < picture.seen.team_size; ++i) {
    if (i != robot && picture.ownPresent(i) && squaredNorm(picture.ballFrom(i)) < own) return false;
  }
  return true;
}

}  // namespace

/// The rules place the robot next to a free ball that was nearest to it, even a keeper that had come out. If
/// it turned back to its goal, an opponent would have the ball for itself.
std::optional<Move> freeBall(const Picture& picture, int robot, Memory& memory) {
  if (auto move = striker::spinOn(picture, robot, memory)) return move;
  if (!picture.disputesFreeBall() || !isFirst(picture, robot)) return std::nullopt;
  if (auto move = striker::freeBall(picture, robot, memory)) return move;
  return striker::spin(picture, robot, memory);
}

}  // namespace fulbito::libero::keeper
