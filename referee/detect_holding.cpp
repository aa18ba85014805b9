#include "referee/detect_holding.hpp"

#include "engine/core/math.hpp"
#include "referee/ball_gap.hpp"
#include "referee/detector_support.hpp"
#include "referee/note_presence.hpp"

namespace fulbito {
namespace {

/// [m] A body that is at least this far from the ball hides no more than the rules allow: what it covers is
/// less than a strip of the disc's full diameter and as wide as the body reaches in.
double harmlessGap(const DetectorInput& in) {
  return -in.setup.rules.fouls.hidden_share * math::kPi * in.setup.ball.radius / 2;
}

/// The share of the ball that the robot covers.
double hiddenShare(const DetectorInput& in, std::size_t i) {
  const Pose2& pose = in.view.robots[i].pose;
  const Vec2 ball = intoFrame(math::unit(pose.heading), in.view.ball.position - pose.position);
  return shareOfDisc(in.setup.robot.length / 2, in.setup.robot.width / 2, ball, in.setup.ball.radius);
}

bool pins(const DetectorInput& in, std::size_t i, double gap) {
  const FoulRules& rules = in.setup.rules.fouls;
  const double most = rules.pinned_speed * rules.pinned_speed;
  if (rules.pinned_seconds <= 0.0 || gap > rules.pinned_gap) return false;
  if (squaredNorm(in.view.ball.velocity) > most || squaredNorm(in.view.robots[i].velocity) > most) {
    return false;
  }
  return !disputes(in, other(in.view.ids[i].team), rules.dispute_lengths);
}

Finding callOf(const DetectorInput& in, std::size_t i) {
  const RobotId robot = in.view.ids[i];
  const bool in_own_area = at(in.areas, in.state.sideOf(robot.team)).ball;
  Finding call =
      in_own_area
          ? makeFinding(in, clause::kPenaltyHolding, "8.1", RestartKind::kPenalty, other(robot.team))
          : makeFinding(in, clause::kFreeKickHolding, "8.1", RestartKind::kFreeKick, other(robot.team));
  blame(call, robot);
  return call;
}

std::optional<Finding> holdingBy(const DetectorInput& in, std::size_t i, double gap, FoulMemory& memory) {
  const FoulRules& rules = in.setup.rules.fouls;
  const Tick release = ticksOf(rules.holding_release, in.setup.dt), now = in.view.tick;
  const double share = gap < harmlessGap(in) ? hiddenShare(in, i) : 0.0;
  if (share > rules.hidden_share) memory.hidden[i].add(now, release);
  if (pins(in, i, gap)) memory.pinned[i].add(now, release);
  if (memory.hidden[i].ticks(now) > ticksOf(rules.hidden_seconds, in.setup.dt)) {
    Finding call = callOf(in, i);
    measure(call, share, rules.hidden_share);
    return call;
  }
  if (memory.pinned[i].ticks(now) > ticksOf(rules.pinned_seconds, in.setup.dt)) {
    Finding call = callOf(in, i);
    measureTicks(in, call, memory.pinned[i].ticks(now), rules.pinned_seconds);
    return call;
  }
  return std::nullopt;
}

}  // namespace

std::optional<Finding> detectHolding(const DetectorInput& in, const PresenceMemory& presence,
                                     FoulMemory& memory) {
  const FoulRules& rules = in.setup.rules.fouls;
  if (!rules.holding || !cooledDown(in, rules.cool_down)) return std::nullopt;
  const double most = rules.pinned_seconds > 0.0 ? rules.pinned_gap : harmlessGap(in);
  for (std::size_t i = 0; i < robotsIn(in.view); ++i) {
    const auto gap =
        ballGap(in.setup.robot, in.view.robots[i].pose, in.setup.ball, in.view.ball.position, most);
    if (!gap || keepsGoal(in, i, presence)) continue;
    if (auto call = holdingBy(in, i, *gap, memory)) return call;
  }
  return std::nullopt;
}

}  // namespace fulbito
