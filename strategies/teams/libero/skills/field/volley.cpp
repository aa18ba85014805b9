#include "strategies/teams/libero/attack/volley.hpp"

#include <utility>

#include "strategies/teams/libero/motion/motion.hpp"
#include "strategies/teams/libero/playbook/skills.hpp"

namespace fulbito::libero::field {
namespace {

/// The run of the last tick, as long as it leaves room, or the best one. A robot that took the best one in
/// each tick would turn to and fro instead of speeding up.
std::optional<Volley> chosen(const Picture& picture, int robot, double left) {
  if (left > 0.0) {
    const auto kept = volleyAt(picture, robot, left);
    if (kept && kept->room > leastRoom(picture) - picture.tuning.clearance) return kept;
  }
  return bestVolley(picture, robot);
}

}  // namespace

std::optional<Move> volley(const Picture& picture, int robot, Memory& memory) {
  const double rolls = picture.tuning.rolls;
  const double left = std::exchange(memory.volley, 0.0) - picture.seen.dt;
  // Robots that speed up fast need no run-up: they drive round a ball in less time than the wait takes.
  if (picture.pitch.shoves || memory.spin.left > 0.0 ||
      squaredNorm(picture.ball.now().velocity) < rolls * rolls)
    return std::nullopt;
  // Where nobody defends, no goal needs a run-up.
  if (picture.isPenalty() || (!picture.hasOpponent(true) && !picture.hasOpponent(false))) return std::nullopt;
  const auto run = chosen(picture, robot, left);
  if (!run) return std::nullopt;
  memory.volley = run->time;
  const Pitch& pitch = picture.pitch;
  const RobotState& self = picture.own(robot);
  const bool waits = run->spare > pitch.tick / 2;
  Move move{.reason = waits ? "a rolling ball will come" : "a rolling ball is met on the run",
            .ball = run->ball};
  move.twist =
      waits ? turnTo(pitch, self, run->heading) : alongHeading(pitch, self, run->heading, pitch.speed);
  move.target = run->target;
  return move;
}

}  // namespace fulbito::libero::field
