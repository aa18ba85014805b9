#include "strategies/teams/sparring/school.hpp"

#include <algorithm>
#include <cmath>

#include "fulbito/detail/math.hpp"
#include "strategies/interface/drawings.hpp"
#include "strategies/skills/area_projection.hpp"
#include "strategies/skills/interception.hpp"
#include "strategies/skills/kicking.hpp"
#include "strategies/skills/positions.hpp"
#include "strategies/skills/quick_twist.hpp"
#include "strategies/skills/shot_geometry.hpp"

namespace fulbito::sparring {
namespace {

constexpr double kAtWall = 0.02;    // [m] from ball to wall: a narrower gap has no room for a robot's body
constexpr double kPressing = 0.12;  // [m] between the centres of ball and robot: the robot presses the ball

}  // namespace

std::vector<Parameter<School::Params>> School::parameters() {
  return {flag("spins", &Params::spins, "spin at any ball that is stuck, not at walls only")};
}

void School::begin(const MatchInfo& info) {
  info_ = info;
  foresight_ = Foresight(info);
  memory_.fill({});
  keeper_ = {};
  players_ = 0;
  restart();
}

const char* School::roleName(std::size_t rank) const {
  constexpr std::array<const char*, 4> kNames = {"keeper", "first", "second", "third"};
  return kNames[std::min(rank, kNames.size() - 1)];
}

double School::theirTime(const Observation& now, Vec2 place) const {
  double least = 1e9;
  for (std::size_t k = 0; k < static_cast<std::size_t>(now.team_size); ++k) {
    if (!now.opponents[k].present) continue;
    least = std::min(least, timeToReach(foresight_.pace(), now.opponents[k].state, place));
  }
  return least;
}

double School::cost(const Observation& now, std::size_t i) const {
  constexpr double kAhead = 0.6;  // [s] a robot ahead of the ball first has to come round
  const RobotState& robot = now.own[i].state;
  const auto met = intercept(foresight_.ball(), foresight_.pace(), robot);
  return (met ? met->time : 10.0) + (robot.pose.position.x > now.ball.position.x ? kAhead : 0.0);
}

/// Orders the field players by cost. The first keeps its place unless another is clearly better.
void School::rank(const Observation& now) {
  constexpr double kBetter = 0.25;  // [s]
  const bool had = players_ > 0;
  const std::size_t before = order_[0];
  std::array<double, kMaxTeamSize> costs{};
  players_ = 0;
  for (std::size_t i = 1; i < static_cast<std::size_t>(now.team_size); ++i) {
    if (!now.own[i].present) continue;
    costs[i] = cost(now, i) - (had && i == before && !foresight_.playBegan() ? kBetter : 0.0);
    order_[players_++] = i;
  }
  std::sort(
      order_.begin(), order_.begin() + static_cast<std::ptrdiff_t>(players_),
      [&](std::size_t a, std::size_t b) { return costs[a] < costs[b] || (costs[a] == costs[b] && a < b); });
}

Vec2 School::meeting(const Observation& now, std::size_t i, Vec2 aim) const {
  InterceptionRequest request;
  request.aim = aim;
  const auto met = intercept(foresight_.ball(), foresight_.pace(), now.own[i].state, request);
  return met ? met->ball : foresight_.ball().endOfWay();
}

Vec2 School::wanted(const Observation& now, Vec2 ball) const {
  const double at_wall = info_.ball.radius + kAtWall;
  const double end = field().length / 2 - std::abs(ball.x);
  const double side = ball.y > 0.0 ? 1.0 : -1.0;
  const bool beside_goal = std::abs(ball.y) > field().goal_width / 2;
  if (end < at_wall && beside_goal) return {0.0, ball.x > 0.0 ? -side : side};
  if (field().width / 2 - std::abs(ball.y) < at_wall) return unitOr({1.0, 0.2 * side}, {1.0, 0.0});
  std::array<ShotBlocker, kMaxTeamSize> blockers;
  std::array<Vec2, kMaxTeamSize> places;
  std::size_t count = 0;
  for (std::size_t k = 0; k < static_cast<std::size_t>(now.team_size); ++k) {
    if (!now.opponents[k].present) continue;
    const RobotState& state = now.opponents[k].state;
    places[count] = state.pose.position;
    blockers[count++] = {state.pose.position, info_.robot.length / 2, state.velocity};
  }
  if (ball.x < -field().length / 4) {
    return unitOr(clearanceTarget(field(), ball, {places.data(), count}) - ball, {1.0, 0.0});
  }
  ShotModel model;
  model.ball_radius = info_.ball.radius;
  model.acceleration = foresight_.pace().acceleration;
  auto shot = bestShot(field(), model, ball, {blockers.data(), count});
  model.acceleration = 0.0;
  if (!shot) shot = bestShot(field(), model, ball, {blockers.data(), count});
  return unitOr(shot.value_or(opponentGoal(field())) - ball, {1.0, 0.0});
}

RobotCommand School::twist(const Observation& now, std::size_t i, Twist wanted) const {
  return quickTwist(info_.robot, now.own[i].state, wanted, now.dt);
}

std::optional<RobotCommand> School::spin(const Observation& now, std::size_t i, Vec2 direction,
                                         const SpinSettings& settings) {
  constexpr double kYawRate = 30.0;  // [rad/s] the limiter reduces it to what the robot can
  const auto sense = memory_[i].spin.update(field(), info_.ball.radius, now.own[i].state, now.ball, direction,
                                            true, now.dt, settings);
  if (!sense) return std::nullopt;
  return twist(now, i, {0.0, *sense * kYawRate});
}

double School::spinReach() const {
  constexpr double kGap = 0.01;  // [m] between a corner of the robot and the ball
  return info_.robot.circumradius() + info_.ball.radius + kGap;
}

SpinSettings School::spinsAnywhere() const {
  SpinSettings settings;
  settings.reach = spinReach();
  settings.release = settings.reach + info_.ball.radius;
  settings.slow = 0.6;
  settings.wall = field().width;
  settings.lock_out = 0.2;
  return settings;
}

RobotCommand School::drive(const Observation& now, std::size_t i, DriveGoal goal) {
  return twist(now, i, memory_[i].drive.update(info_, now.own[i].state, goal));
}

/// Head-on, two robots hold the ball between them and the heavier train wins. Off its centre the ball leaves
/// to the side where the opponent is not.
Vec2 School::pastOpponent(const Observation& now, Vec2 ball, Vec2 straight) const {
  constexpr double kNear = 0.4, kOff = 0.35;  // [m], [rad]
  double nearest = kNear, aside = 0.0;
  for (std::size_t k = 0; k < static_cast<std::size_t>(now.team_size); ++k) {
    if (!now.opponents[k].present) continue;
    const Vec2 from = intoFrame(straight, now.opponents[k].state.pose.position - ball);
    if (from.x > 0.0 && norm(from) < nearest) nearest = norm(from), aside = from.y;
  }
  if (nearest >= kNear) return straight;
  return outOfFrame(straight, math::unit(aside > 0.0 ? -kOff : kOff));
}

/// The taker of a kick-off or penalty stands close behind the ball at an angle, so that the ball passes
/// opponents on the straight line. Against a kick-off, a robot meets the ball from the side: head-on, the
/// heavier train wins.
std::optional<TeamProposal> School::place(const PlacementRequest& request) {
  constexpr double kKickOff = 0.6, kPenalty = 0.36, kAgainst = 1.0;  // [rad]
  constexpr double kRoom = 0.025;                                    // [m] between ball and taker
  const bool penalty = request.kind == RestartKind::kPenalty;
  if (request.kind != RestartKind::kKickOff && !(penalty && request.ours)) return std::nullopt;
  TeamPlacement placement = request.defaults;
  std::array<Pose2*, 2> near{};  // the nearest to the ball and the next
  for (std::optional<Pose2>& pose : placement) {
    if (!pose) continue;
    const double gap = distance(pose->position, request.ball);
    if (near[0] == nullptr || gap < distance(near[0]->position, request.ball)) {
      near = {&*pose, near[0]};
    } else if (near[1] == nullptr || gap < distance(near[1]->position, request.ball)) {
      near[1] = &*pose;
    }
  }
  if (near[0] == nullptr) return std::nullopt;
  const double hand = (request.now.own_score + request.now.opponent_score) % 2 == 0 ? 1.0 : -1.0;
  const double behind = info_.robot.length / 2 + info_.ball.radius + kRoom;
  const double far = field().centre_circle_radius + info_.robot.circumradius() + 0.005;
  const double run_up = distance(near[0]->position, request.ball);
  const double angle = hand * (penalty ? kPenalty : request.ours ? kKickOff : kAgainst);
  near[0]->position = request.ball - math::unit(angle) * (penalty ? run_up : request.ours ? behind : far);
  near[0]->heading = angle;
  if (!penalty && near[1] != nullptr && near[1]->position.x > -0.7 * field().length / 2) {
    // The second waits where the ball goes.
    near[1]->position = {-far, hand * (request.ours ? 0.3 : 0.2)};
    near[1]->heading = request.ours ? 0.0 : math::angleOf(request.ball - near[1]->position);
  }
  return placement;
}

RobotCommand School::attack(const Observation& now, std::size_t i, const Style& style) {
  const RobotState& robot = now.own[i].state;
  if (isKicking(now, i, {.longest = 0.8, .straight = 0.3}))
    return twist(now, i, {info_.robot.maxSpeed(), 0.0});
  const auto direction = [&](Vec2 from) {
    const bool free = style.toward && wallClearance(field(), from) > info_.ball.radius + kAtWall;
    return free ? unitOr(*style.toward - from, {1.0, 0.0}) : wanted(now, from);
  };
  const Vec2 ball = meeting(now, i, now.ball.position + direction(now.ball.position));
  if (now.own[0].present && isInArea(field(), ball, true)) {
    return stand(outsideArea(field(), ball + Vec2{0.1, 0.0}, true, 0.1));
  }
  DriveGoal goal{ball, direction(ball), style.bend, style.room};
  if (const auto turn = spin(now, i, goal.direction, params_.spins ? spinsAnywhere() : style.spins))
    return *turn;
  // A ball that an opponent reaches first is hit straight, if that sends it upfield.
  constexpr double kReserve = 0.2, kUpfield = 0.0;  // [s], [1]
  const Vec2 straight = unitOr(ball - robot.pose.position, {1.0, 0.0});
  const double mine = timeToReach(foresight_.pace(), robot, ball - goal.direction * 0.06);
  const bool at_wall = wallClearance(field(), ball) < info_.ball.radius + kAtWall;
  const bool kick_off = now.restart == RestartKind::kKickOff && now.since_restart < 1.0;
  if ((style.straight || kick_off) && !at_wall && theirTime(now, ball) < mine + kReserve &&
      straight.x > kUpfield) {
    goal.direction = straight;
  }
  return drive(now, i, goal);
}

RobotCommand School::stand(Vec2 place, std::optional<double> heading) const {
  constexpr double kMargin = 0.02;  // [m] beyond the body
  const double body = info_.robot.circumradius() + kMargin;
  place = insideWalls(field(), place, info_.robot.width / 2 + kMargin);
  GoTo go_to;
  go_to.position = outsideArea(field(), outsideArea(field(), place, true, body), false, body);
  go_to.heading = heading;
  go_to.stop = true;
  go_to.avoid_ball = true;
  return RobotCommand::drivingTo(go_to);
}

RobotCommand School::keep(const Observation& now, std::size_t i) {
  return keeper_.update(info_, foresight_, now, i, {});
}

/// Turns back a field player that is about to enter the own area while the keeper is there, or, unless it is
/// the first at the ball, that of the opponents.
std::optional<RobotCommand> School::legal(const Observation& now, std::size_t i, bool first) const {
  const RobotState& robot = now.own[i].state;
  const double body = info_.robot.circumradius();
  const double speed = norm(robot.velocity);
  const Vec2 soon = robot.pose.position + robot.velocity * (now.dt + speed / (2.0 * info_.robot.braking()));
  const bool in_own = now.own[0].present && isInArea(field(), soon, true, body / 2);
  const bool in_theirs = !first && isInArea(field(), soon, false, body);
  if (!in_own && !in_theirs) return std::nullopt;
  const Vec2 out = outsideArea(field(), soon, in_own, body + 0.02) - soon;
  if (dot(robot.velocity, out) < 0.0 && speed > 0.1) return twist(now, i, {});
  constexpr double kTurn = 8.0;  // [1/s]
  double error = math::wrapAngle(math::angleOf(out) - robot.pose.heading);
  const bool backward = std::abs(error) > math::kPi / 2;
  if (backward) error = math::wrapAngle(error + math::kPi);
  const double v = 0.4 * foresight_.pace().speed * std::max(0.0, math::cos(error));
  return twist(now, i, {backward ? -v : v, kTurn * error});
}

/// A lower rank moves off along its wheels when it is about to touch a mate of a higher one.
std::optional<RobotCommand> School::yielding(const Observation& now, std::size_t i, std::size_t rank) const {
  const RobotState& robot = now.own[i].state;
  const double near = 2.0 * info_.robot.circumradius();
  if (distance(robot.pose.position, now.ball.position) < kPressing) return std::nullopt;
  const auto yields_to = [&](std::size_t mate) -> std::optional<RobotCommand> {
    if (mate == i || !now.own[mate].present) return std::nullopt;
    const Vec2 from = robot.pose.position - now.own[mate].state.pose.position;
    const Vec2 closing = robot.velocity - now.own[mate].state.velocity;
    if (norm(from) > near || dot(from, closing) > 0.02 * norm(from)) return std::nullopt;
    const double along = dot(math::unit(robot.pose.heading), from);
    const double v = 0.4 * foresight_.pace().speed;
    return twist(now, i, {along >= 0.0 ? v : -v, 0.0});
  };
  if (const auto away = yields_to(0)) return away;
  for (std::size_t k = 0; k + 1 < rank; ++k) {
    if (const auto away = yields_to(order_[k])) return away;
  }
  return std::nullopt;
}

TeamCommand School::decide(const Observation& seen) {
  const Observation& now = foresight_.update(seen);
  if (foresight_.playBegan() || !now.playing) {
    memory_.fill({});
    keeper_ = {};
    restart();
  }
  rank(now);
  TeamCommand command;
  if (now.own[0].present) {
    command.roles[0] = 1;
    command.robots[0] = keep(now, 0);
    if (seen.wants_drawings) addName(command.drawings, now.own[0].state.pose.position, roleName(0));
  }
  for (std::size_t k = 0; k < players_; ++k) {
    const std::size_t i = order_[k], rank = k + 1;
    RobotCommand& own = command.robots[i];
    command.roles[i] = static_cast<std::uint8_t>(rank + 1);
    own = play(now, i, rank);
    if (const auto away = yielding(now, i, rank)) own = *away;
    if (const auto out = legal(now, i, rank == 1)) own = *out;
    // Who presses the ball stands still in a jam and stays there.
    const bool meant = own.kind == RobotCommand::Kind::kGoTo
                           ? distance(own.go_to.position, now.own[i].state.pose.position) > 0.1
                           : distance(now.ball.position, now.own[i].state.pose.position) > kPressing;
    if (const auto free = memory_[i].unsticking.update(now.own[i].state, now.playing && meant, now.dt)) {
      own = twist(now, i, *free);
    }
    if (seen.wants_drawings) addName(command.drawings, now.own[i].state.pose.position, roleName(rank));
  }
  return command;
}

}  // namespace fulbito::sparring
