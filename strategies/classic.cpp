#include "strategies/classic.hpp"

#include <algorithm>
#include <cmath>

#include "engine/core/math.hpp"
#include "strategies/area_projection.hpp"
#include "strategies/ball_posture.hpp"
#include "strategies/foresight.hpp"
#include "strategies/interception.hpp"
#include "strategies/line_keeping.hpp"
#include "strategies/positions.hpp"
#include "strategies/shot_geometry.hpp"
#include "strategies/unsticking.hpp"
#include "strategies/wall_play.hpp"

namespace fulbito {
namespace {

enum class Role : std::uint8_t { kKeeper, kAttacker, kSupporter, kDefender, kWinger };

class Classic final : public Strategy {
 public:
  struct Params {
    double keeper_depth = 0.10;  ///< [m]
    double support = 0.30;       ///< [m]
    double strike_speed = 1.2;   ///< [m/s]
    bool exchange = false;
    bool spin = true;
  };

  Classic(Params params, NavigatorChoice navigator) : params_(params), navigators_{std::move(navigator)} {}

  void begin(const MatchInfo& info) override;
  std::span<const NavigatorChoice> navigators() const override { return navigators_; }
  TeamCommand decide(const Observation& seen) override;
  std::optional<TeamPlacement> place(const PlacementRequest& request) override;
  std::optional<ExerciseReply> exercise(const Observation& seen, const Exercise& task) override;

 private:
  /// What one robot remembers between ticks.
  struct Memory {
    bool round = false;
    bool lined_up = false;
    SpinKick spin;
    Unsticking unsticking;
  };

  void chooseAttacker(const Observation& now);
  RobotCommand keeper(const Observation& now, std::size_t i);
  RobotCommand attacker(const Observation& now, std::size_t i);
  RobotCommand supporter(Role role) const;
  std::optional<RobotCommand> keptOutOfAreas(const Observation& now, std::size_t i, Role role) const;
  bool mayClear(const Observation& now, std::size_t i) const;
  RobotCommand clearing(const Observation& now, std::size_t i);
  std::optional<RobotCommand> spinAtBall(const Observation& now, std::size_t i, bool contested);
  bool isKicking(const Observation& now, std::size_t i) const;
  bool isHeldByKeeper(const Observation& now) const;
  bool isContested(const Observation& now, double mine) const;
  Vec2 aim(const Observation& now, Vec2 ball) const;
  Vec2 wantedDirection(const Observation& now, Vec2 ball) const;
  Role roleOf(std::size_t robot) const;

  Params params_;
  std::vector<NavigatorChoice> navigators_;
  MatchInfo info_;
  Foresight foresight_;
  std::array<Memory, kMaxTeamSize> memory_;
  std::size_t attacker_ = 1;
  double since_exchange_ = 0.0;
};

RobotCommand spinning(double sense) {
  constexpr double kYawRate = 30.0;  // [rad/s] as fast as the wheels go
  return RobotCommand::byTwist({0.0, sense * kYawRate});
}

void Classic::begin(const MatchInfo& info) {
  info_ = info;
  foresight_ = Foresight(info);
  memory_.fill({});
  attacker_ = std::min<std::size_t>(1, static_cast<std::size_t>(info.team_size) - 1);
}

/// Roles by number: 0 keeps, 1 attacks, 2 supports, 3 defends, 4 ... wait on the other wing. The attacker's
/// may be exchanged with a mate's.
Role Classic::roleOf(std::size_t robot) const {
  constexpr std::array<Role, 5> kByNumber = {Role::kKeeper, Role::kAttacker, Role::kSupporter,
                                             Role::kDefender, Role::kWinger};
  if (robot == attacker_) return Role::kAttacker;
  const std::size_t number = robot == 1 ? attacker_ : robot;
  return kByNumber[std::min(number, kByNumber.size() - 1)];
}

GoTo poseOf(const Exercise& task) {
  GoTo go_to;
  go_to.position = task.target;
  go_to.heading = task.heading;
  go_to.stop = true;
  go_to.either_front = false;
  go_to.tolerance = 0.01;
  return go_to;
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

/// Kick-offs and penalties are taken at an angle, past whoever waits on the straight line.
std::optional<TeamPlacement> Classic::place(const PlacementRequest& request) {
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
  since_exchange_ += now.dt;
  const auto size = static_cast<std::size_t>(now.team_size);
  // Whoever a restart puts at the ball attacks in that play.
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
  if (foresight_.playBegan()) memory_.fill({});
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
  return command;
}

/// Brakes and turns back a robot on its way into an area where its role has no business.
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

RobotCommand Classic::keeper(const Observation& now, std::size_t i) {
  const RobotState& robot = now.own[i].state;
  const double farthest = info_.field.goal_width / 2 - 0.02;
  const Vec2 place = keeperPoint(info_.field, foresight_.ball(), params_.keeper_depth, farthest);
  const Vec2 ball = now.ball.position;
  // Only outward and upfield, never across the own mouth.
  const Vec2 out{0.5, ball.y >= robot.pose.position.y ? 1.0 : -1.0};
  const bool in_front = ball.x > robot.pose.position.x - 0.01;
  const auto sense = memory_[i].spin.update(info_.field, info_.ball.radius, robot, now.ball, out,
                                            params_.spin && in_front, now.dt, {.slow = 0.5, .wall = 0.3});
  if (sense) return spinning(*sense);
  // A penalty is met far out, facing the ball: on the line it would be pushed in with the keeper.
  const bool penalty =
      now.restart == RestartKind::kPenalty && !now.restart_is_ours && now.since_restart < 1.0;
  if (penalty || mayClear(now, i)) return clearing(now, i);
  if (const auto twist = keepLine(robot, place, info_.robot.maxSpeed())) return RobotCommand::byTwist(*twist);
  GoTo back;
  back.position = place;
  back.heading = math::kPi / 2;
  back.stop = true;
  return RobotCommand::drivingTo(back);
}

/// Whether the keeper leaves its line: for a slow ball near the goal that no opponent is about to have.
bool Classic::mayClear(const Observation& now, std::size_t i) const {
  constexpr double kSlow = 0.3, kLead = 0.15;  // [m/s], [s]
  const Vec2 ball = now.ball.position;
  if (norm(now.ball.velocity) > kSlow || !isInArea(info_.field, ball, true, 0.02)) return false;
  // Behind the keeper's back nothing good can be done.
  const RobotState& robot = now.own[i].state;
  if (ball.x < robot.pose.position.x + 0.02) return false;
  if (now.restart == RestartKind::kGoalKick && now.restart_is_ours && now.since_restart < 2.0) return true;
  const double mine = timeToReach(foresight_.pace(), robot, ball);
  for (std::size_t k = 0; k < static_cast<std::size_t>(now.team_size); ++k) {
    if (!now.opponents[k].present) continue;
    if (timeToReach(foresight_.pace(), now.opponents[k].state, ball) < mine + kLead) return false;
  }
  return true;
}

RobotCommand Classic::clearing(const Observation& now, std::size_t i) {
  const Vec2 ball = now.ball.position;
  const Vec2 away = unitOr(ball - now.own[i].state.pose.position, {1.0, 0.0});
  return RobotCommand::byTwist(strike(now.own[i].state, ball, away, params_.strike_speed));
}

Vec2 Classic::aim(const Observation& now, Vec2 ball) const {
  std::array<ShotBlocker, kMaxTeamSize> blockers;
  std::array<Vec2, kMaxTeamSize> places;
  std::size_t count = 0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(now.team_size); ++i) {
    if (!now.opponents[i].present) continue;
    const RobotState& state = now.opponents[i].state;
    places[count] = state.pose.position;
    blockers[count++] = {state.pose.position, info_.robot.length / 2, state.velocity};
  }
  if (ball.x < -info_.field.length / 4) return clearanceTarget(info_.field, ball, {places.data(), count});
  ShotModel model;
  model.ball_radius = info_.ball.radius;
  auto shot = bestShot(info_.field, model, ball, {blockers.data(), count});
  // A keeper in time for everything still leaves a wider and a narrower side.
  model.acceleration = 0.0;
  if (!shot) shot = bestShot(info_.field, model, ball, {blockers.data(), count});
  return shot ? shot->aim : opponentGoal(info_.field);
}

/// Where the ball shall go: at the free part of the goal, out of the own third up a side, along a wall that
/// it lies at.
Vec2 Classic::wantedDirection(const Observation& now, Vec2 ball) const {
  constexpr double kAtWall = 0.02;  // [m] of room behind the ball, where nothing can get
  const FieldGeometry& field = info_.field;
  const double reach = info_.ball.radius + kAtWall;
  if (field.width / 2 - std::abs(ball.y) < reach) return {1.0, 0.0};
  if (field.length / 2 - ball.x < reach && std::abs(ball.y) > field.goal_width / 2) {
    return {0.0, ball.y > 0.0 ? -1.0 : 1.0};
  }
  return unitOr(aim(now, ball) - ball, {1.0, 0.0});
}

/// Whether an opponent will be at the ball before robot `i` could line up.
bool Classic::isContested(const Observation& now, double mine) const {
  constexpr double kReserve = 0.15;  // [s]
  for (std::size_t k = 0; k < static_cast<std::size_t>(now.team_size); ++k) {
    if (!now.opponents[k].present) continue;
    const double theirs = timeToReach(foresight_.pace(), now.opponents[k].state, now.ball.position);
    if (theirs < mine + kReserve) return true;
  }
  return false;
}

/// Whether the ball lies in the opponents' area with an opponent at it.
bool Classic::isHeldByKeeper(const Observation& now) const {
  constexpr double kSlow = 0.3, kAtBall = 0.085;  // [m/s], [m]
  if (norm(now.ball.velocity) > kSlow || !isInArea(info_.field, now.ball.position, false)) return false;
  for (std::size_t k = 0; k < static_cast<std::size_t>(now.team_size); ++k) {
    const ObservedRobot& opponent = now.opponents[k];
    if (opponent.present && distance(opponent.state.pose.position, now.ball.position) < kAtBall) return true;
  }
  return false;
}

/// Whether robot `i` is taking a kick-off or penalty that it was placed for: straight on, until the ball is
/// away.
bool Classic::isKicking(const Observation& now, std::size_t i) const {
  constexpr double kWhile = 0.6, kAway = 0.12, kStraight = 0.15;  // [s], [m], [rad]
  const bool kick = now.restart == RestartKind::kPenalty || now.restart == RestartKind::kKickOff;
  if (!kick || !now.restart_is_ours || now.since_restart > kWhile) return false;
  const Pose2& pose = now.own[i].state.pose;
  const Vec2 to_ball = now.ball.position - pose.position;
  const bool straight = std::abs(math::wrapAngle(math::angleOf(to_ball) - pose.heading)) < kStraight;
  return straight && (norm(to_ball) < kAway || now.since_restart < 0.3);
}

std::optional<RobotCommand> Classic::spinAtBall(const Observation& now, std::size_t i, bool contested) {
  const RobotState& robot = now.own[i].state;
  const Vec2 ball = now.ball.position;
  SpinSettings settings;
  Vec2 wanted{1.0, -0.3 * std::copysign(1.0, ball.y)};
  const bool at_mouth =
      ball.x > info_.field.length / 2 - 0.08 && std::abs(ball.y) < info_.field.goal_width / 2;
  if (at_mouth) {
    wanted = {1.0, 0.0};
    settings.slow = 2.0;  // it would roll past
    settings.wall = 0.10;
  } else if (contested && std::abs(ball.x) < info_.field.length / 2 - 0.15) {
    settings.wall = 1.0;  // held between two robots
  }
  const auto sense = memory_[i].spin.update(info_.field, info_.ball.radius, robot, now.ball, wanted,
                                            params_.spin, now.dt, settings);
  if (!sense) return std::nullopt;
  return spinning(*sense);
}

RobotCommand Classic::attacker(const Observation& now, std::size_t i) {
  constexpr double kAreaMargin = 0.07;  // [m]
  Memory& memory = memory_[i];
  const RobotState& robot = now.own[i].state;
  const BallPrediction& prediction = foresight_.ball();
  const auto meeting = intercept(prediction, foresight_.pace(), robot);
  const Vec2 ball = meeting ? meeting->ball : prediction.endOfWay();
  const bool keeper_plays = now.own[0].present && i != 0;
  if (keeper_plays && isInArea(info_.field, ball, true)) {
    GoTo wait;
    wait.position = outsideArea(info_.field, ball + Vec2{0.1, 0.0}, true, kAreaMargin);
    return RobotCommand::drivingTo(wait);
  }
  if (isHeldByKeeper(now)) {
    // Charging a keeper in its area is a foul.
    GoTo wait;
    wait.position = reboundSpot(info_.field, -ball);
    return RobotCommand::drivingTo(wait);
  }
  const bool contested = isContested(now, meeting ? meeting->time : 10.0);
  if (isKicking(now, i)) return RobotCommand::byTwist({info_.robot.maxSpeed(), 0.0});
  if (const auto spin = spinAtBall(now, i, contested)) return *spin;
  const Vec2 direction = wantedDirection(now, ball);
  memory.lined_up = isLinedUp(sideOfBall(robot, now.ball.position, direction), memory.lined_up);
  if (memory.lined_up) {
    return RobotCommand::byTwist(strike(robot, now.ball.position, direction, params_.strike_speed));
  }
  // A ball that somebody else is about to have is met straight, as long as it goes upfield.
  constexpr double kUpfield = 0.2;
  const Vec2 straight = unitOr(ball - robot.pose.position, {1.0, 0.0});
  if (contested && straight.x > kUpfield) {
    return RobotCommand::byTwist(strike(robot, ball, straight, params_.strike_speed));
  }
  BallApproach approach = approachBall(robot, ball, direction, memory.round);
  memory.round = approach.round;
  GoTo& go_to = approach.go_to;
  constexpr double kBodyMargin = 0.04;  // [m]
  go_to.position = insideWalls(info_.field, go_to.position, kBodyMargin);
  if (keeper_plays) go_to.position = outsideArea(info_.field, go_to.position, true, kAreaMargin);
  // Near the ball everybody is in the way: the field would turn off it.
  const bool near = distance(robot.pose.position, ball) < 0.25;
  go_to.avoid_opponents = !near;
  go_to.avoid_mates = !near;
  return RobotCommand::drivingTo(go_to);
}

RobotCommand Classic::supporter(Role role) const {
  constexpr double kBodyMargin = 0.08, kAreaMargin = 0.07;  // [m]
  const Vec2 ball = foresight_.ball().positionAt(0.3);
  Vec2 place;
  // In the own half the supporter defends too.
  if (role == Role::kDefender || (role == Role::kSupporter && ball.x < 0.0)) {
    place = shadowPoint(info_.field, ball, 0.45 * (ball.x + info_.field.length / 2));
  } else {
    // Behind the ball and nearer the middle: ready for balls that come back, out of the attacker's way.
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

}  // namespace

TeamInfo classicInfo() {
  using P = Classic::Params;
  return describeTeam<P, Classic>(
      "classic", "fixed roles, a keeper on its line and a field that leads to the ball, as in the textbooks",
      {number("keeper_depth", &P::keeper_depth, 0.03, 0.2, "m", "the keeper's line before the goal line"),
       number("support", &P::support, 0.1, 1.0, "m", "the supporter's place behind the ball"),
       number("strike_speed", &P::strike_speed, 0.2, 3.0, "m/s", "through a ball that is lined up"),
       flag("exchange", &P::exchange, "a field player that is nearer to the ball becomes the attacker"),
       flag("spin", &P::spin, "spin at balls that lie at a wall")},
      "univector:follower=classic");
}

}  // namespace fulbito
