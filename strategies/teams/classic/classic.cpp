#include <algorithm>

#include "fulbito/detail/math.hpp"
#include "strategies/interface/drawings.hpp"
#include "strategies/interface/team_info.hpp"
#include "strategies/skills/area_projection.hpp"
#include "strategies/skills/ball_posture.hpp"
#include "strategies/skills/interception.hpp"
#include "strategies/skills/positions.hpp"
#include "strategies/teams/classic/classic_team.hpp"

namespace fulbito {
namespace {

GoTo poseOf(const Exercise& task) {
  GoTo go_to;
  go_to.position = task.target;
  go_to.heading = task.heading;
  go_to.stop = true;
  go_to.either_front = false;
  go_to.tolerance = 0.01;
  return go_to;
}

}  // namespace

void Classic::begin(const MatchInfo& info) {
  info_ = info;
  foresight_ = Foresight(info);
  memory_.fill({});
  attacker_ = std::min<std::size_t>(1, static_cast<std::size_t>(info.rules.team_size) - 1);
}

/// Roles by robot number: 0 keeper, 1 attacker, 2 supporter, 3 defender, 4 and up winger. The attacker may
/// exchange its role with another robot.
Classic::Role Classic::roleOf(std::size_t robot) const {
  constexpr std::array<Role, 5> kByNumber = {Role::kKeeper, Role::kAttacker, Role::kSupporter,
                                             Role::kDefender, Role::kWinger};
  if (robot == attacker_) return Role::kAttacker;
  const std::size_t number = robot == 1 ? attacker_ : robot;
  return kByNumber[std::min(number, kByNumber.size() - 1)];
}

std::optional<ExerciseReply> Classic::exercise(const Observation& seen, const Exercise& task) {
  const Observation& now = foresight_.update(seen);
  const RobotState& robot = now.own[0].state;
  const Vec2 ball = now.ball.position, direction = math::unit(task.heading);
  ExerciseReply reply;
  RobotCommand& own = reply.command.robots[0];
  Memory& memory = memory_[0];
  switch (task.kind) {
    case Exercise::Kind::kReachPose:
      own = RobotCommand::drivingTo(poseOf(task));
      break;
    case Exercise::Kind::kTurn:
      own = RobotCommand::byTwist({0.0, 15.0 * math::wrapAngle(task.heading - robot.pose.heading)});
      break;
    case Exercise::Kind::kReachBall:
    case Exercise::Kind::kPush: {
      memory.lined_up = isLinedUp(sideOfBall(robot, ball, direction), memory.lined_up);
      BallApproach approach = approachBall(robot, ball, direction, memory.round);
      memory.round = approach.round;
      own = memory.lined_up ? RobotCommand::byTwist(strike(robot, ball, direction, task.speed))
                            : RobotCommand::drivingTo(approach.go_to);
      break;
    }
    case Exercise::Kind::kPredictBall:
      reply.answer = foresight_.ball().positionAt(task.horizon);
      break;
  }
  return reply;
}

/// The taker of a kick-off or penalty stands at an angle, so that the ball passes opponents on the straight
/// line.
std::optional<TeamProposal> Classic::place(const PlacementRequest& request) {
  constexpr double kKickOffAngle = 0.6, kPenaltyAngle = 0.36;  // [rad]
  const bool penalty = request.kind == RestartKind::kPenalty;
  if (!request.ours || (!penalty && request.kind != RestartKind::kKickOff)) return std::nullopt;
  TeamPlacement placement = request.defaults;
  std::optional<Pose2>* taker = nullptr;
  for (std::optional<Pose2>& pose : placement) {
    if (!pose) continue;
    if (taker == nullptr ||
        distance(pose->position, request.ball) < distance((*taker)->position, request.ball)) {
      taker = &pose;
    }
  }
  if (taker == nullptr) return std::nullopt;
  const double angle = penalty ? kPenaltyAngle : kKickOffAngle;
  (*taker)->position = request.ball - math::unit(angle) * distance((*taker)->position, request.ball);
  (*taker)->heading = angle;
  return placement;
}

void Classic::chooseAttacker(const Observation& now) {
  constexpr double kDwell = 1.0, kBetter = 0.3;  // [s]
  if (now.playing) since_exchange_ += now.dt;
  const auto size = static_cast<std::size_t>(now.team_size);
  // The robot that a restart places at the ball is the attacker of that play.
  const bool open = !now.own[attacker_].present || foresight_.playBegan();
  if (!open && (!params_.exchange || since_exchange_ < kDwell)) return;
  double least = 1e9, present = 1e9;
  std::size_t best = attacker_;
  for (std::size_t i = 1; i < size; ++i) {
    if (!now.own[i].present) continue;
    const auto meeting = intercept(foresight_.ball(), foresight_.pace(), now.own[i].state);
    double cost = meeting ? meeting->time : 10.0;
    if (now.own[i].state.pose.position.x > now.ball.position.x) cost += 0.3;
    if (i == attacker_) present = cost;
    if (cost < least) least = cost, best = i;
  }
  if (best != attacker_ && (open || least < present - kBetter)) {
    attacker_ = best;
    since_exchange_ = 0.0;
  }
}

TeamCommand Classic::decide(const Observation& seen) {
  const Observation& now = foresight_.update(seen);
  if (foresight_.playBegan() || !now.playing) memory_.fill({});
  chooseAttacker(now);
  TeamCommand command;
  for (std::size_t i = 0; i < static_cast<std::size_t>(now.team_size); ++i) {
    if (!now.own[i].present) continue;
    const Role role = roleOf(i);
    command.roles[i] = static_cast<std::uint8_t>(static_cast<int>(role) + 1);
    RobotCommand& own = command.robots[i];
    if (role == Role::kKeeper) {
      own = keeper(now, i);
    } else if (role == Role::kAttacker) {
      own = attacker(now, i);
    } else {
      own = supporter(role);
    }
    if (const auto out = keptOutOfAreas(now, i, role)) own = *out;
    const bool meant = own.kind != RobotCommand::Kind::kGoTo ||
                       distance(own.go_to.position, now.own[i].state.pose.position) > 0.1;
    if (const auto free = memory_[i].unsticking.update(
            now.own[i].state, now.playing && meant && role != Role::kKeeper, now.dt)) {
      own = RobotCommand::byTwist(*free);
    }
  }
  if (seen.wants_drawings) draw(now, command.drawings);
  return command;
}

/// Draws every robot's role and the intended direction of the ball.
void Classic::draw(const Observation& now, std::vector<DebugDrawing>& drawings) const {
  constexpr std::array<const char*, 5> kNames = {"keeper", "attacker", "supporter", "defender", "winger"};
  for (std::size_t i = 0; i < static_cast<std::size_t>(now.team_size); ++i) {
    if (!now.own[i].present) continue;
    const Vec2 self = now.own[i].state.pose.position;
    addName(drawings, self, kNames[static_cast<std::size_t>(roleOf(i))]);
    if (i == attacker_) addLine(drawings, now.ball.position, aim(now, now.ball.position));
  }
}

/// Brakes and turns back a robot that is about to enter an area in which its role is not allowed.
std::optional<RobotCommand> Classic::keptOutOfAreas(const Observation& now, std::size_t i, Role role) const {
  constexpr double kLookahead = 0.12, kFast = 0.3, kBody = 0.07;  // [s], [m/s], [m]
  if (role == Role::kKeeper) return std::nullopt;
  const RobotState& robot = now.own[i].state;
  const Vec2 soon = robot.pose.position + robot.velocity * kLookahead;
  const bool in_own = now.own[0].present && isInArea(info_.field, soon, true);
  const bool in_theirs = role != Role::kAttacker && isInArea(info_.field, soon, false, kBody);
  if (!in_own && !in_theirs) return std::nullopt;
  const Vec2 ahead = math::unit(robot.pose.heading);
  const Vec2 out = outsideArea(info_.field, soon, in_own, kBody + 0.01) - soon;
  if (norm(robot.velocity) > kFast && dot(robot.velocity, out) < 0.0)
    return RobotCommand::byTwist({0.0, 0.0});
  const double turn = math::wrapAngle(math::angleOf(out) - robot.pose.heading);
  const bool backward = dot(ahead, out) < 0.0;
  const double error = backward ? math::wrapAngle(turn + math::kPi) : turn;
  const double speed = 0.8 * std::max(0.0, math::cos(error));
  return RobotCommand::byTwist({backward ? -speed : speed, 10.0 * error});
}

RobotCommand Classic::supporter(Role role) const {
  constexpr double kBodyMargin = 0.08, kAreaMargin = 0.07;  // [m]
  const Vec2 ball = foresight_.ball().positionAt(0.3);
  Vec2 place;
  // In the own half the supporter defends too.
  if (role == Role::kDefender || (role == Role::kSupporter && ball.x < 0.0)) {
    place = shadowPoint(info_.field, ball, 0.45 * (ball.x + info_.field.length / 2));
  } else {
    // Behind the ball and nearer to the middle: ready for rebounds and out of the attacker's way.
    const double side = ball.y >= 0.0 ? -1.0 : 1.0;
    const double aside = role == Role::kWinger ? 0.5 : 0.15;
    place = ball + Vec2{-params_.support, side * aside};
    place.y = std::clamp(place.y, -info_.field.width / 2 + 0.2, info_.field.width / 2 - 0.2);
  }
  place = insideWalls(info_.field, place, kBodyMargin);
  place = outsideArea(info_.field, place, true, kAreaMargin);
  place = outsideArea(info_.field, place, false, kAreaMargin + 0.03);
  GoTo go_to;
  go_to.position = place;
  go_to.stop = true;
  go_to.avoid_ball = true;
  return RobotCommand::drivingTo(go_to);
}

TeamInfo classicInfo() {
  using P = Classic::Params;
  return describeTeam<P, Classic>(
      "classic", "textbook team: fixed roles, a keeper on its line, a vector field to the ball",
      {number("keeper_depth", &P::keeper_depth, 0.03, 0.2, "m",
              "distance of the keeper's line from the goal line"),
       number("support", &P::support, 0.1, 1.0, "m", "distance of the supporter behind the ball"),
       number("strike_speed", &P::strike_speed, 0.2, 3.0, "m/s", "speed for driving through a lined-up ball"),
       flag("exchange", &P::exchange, "the field player nearest to the ball becomes the attacker"),
       flag("spin", &P::spin, "spin to free balls at a wall")},
      "univector:follower=classic");
}

}  // namespace fulbito
