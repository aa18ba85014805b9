#include "strategies/teams/libero/defence/keeper.hpp"

#include <algorithm>
#include <cmath>

#include "engine/core/models/field_places.hpp"
#include "fulbito/detail/math.hpp"
#include "strategies/prediction/time_to_reach.hpp"
#include "strategies/skills/area_projection.hpp"
#include "strategies/teams/libero/attack/meet.hpp"
#include "strategies/teams/libero/defence/goal_line.hpp"
#include "strategies/teams/libero/motion/approach.hpp"
#include "strategies/teams/libero/motion/motion.hpp"

namespace fulbito::libero {
namespace {

constexpr double kDepth = 0.042;  // [m] of the keeper's centre before the goal line
constexpr double kSlow = 0.6;     // [m/s] of a ball that the keeper goes out to
constexpr double kStuck = 2.0;  // [s] after which a ball in our area is cleared though opponents wait for it
constexpr double kReach = 0.175;  // [m] most |y| on the line

/// How far beside its crossing a carried ball is awaited [m]: on the side from which it comes, so that the
/// keeper already moves across with it at the touch. A ball slides past a keeper that stands, along its face.
double lead(const Picture& picture, double line) {
  constexpr double kShare = 0.6;    // of the ball's way across
  constexpr double kLongest = 0.2;  // [s] before the touch
  if (!opponentDribblesAtGoal(picture)) return 0.0;
  const Pitch& pitch = picture.pitch;
  const BallState& ball = picture.ball.now();
  const double gap = ball.position.x - (line + pitch.robot_half + pitch.ball_radius);
  const double time = std::clamp(gap / -ball.velocity.x, 0.0, kLongest);
  return -kShare * ball.velocity.y * time;
}

/// Whether a ball that comes slanting touches the keeper's face now or soon: there it loses little of its
/// speed across, runs on along the face, and its spin presses it on toward the goal. The keeper goes with it
/// from a moment before the touch; a keeper that waits for the ball to be past is 0.1 s late.
std::optional<Twist> goWith(const Picture& picture, const RobotState& self, double line) {
  constexpr double kSoon = 0.04;    // [s] before the touch
  constexpr double kFace = 0.04;    // [m] off the keeper's middle: a ball farther out has to be reached first
  constexpr double kAcross = 0.2;   // [m/s] slower balls wait
  constexpr double kShare = 0.8;    // of its speed: the face takes some of it
  constexpr double kRoom = 0.24;    // [m] most |y|: a little past the post
  constexpr double kTouch = 0.002;  // [m]
  const Pitch& pitch = picture.pitch;
  const BallState& ball = picture.ball.now();
  const Vec2 rel = ball.position - self.pose.position;
  const double gap = rel.x - pitch.robot_half - pitch.ball_radius;
  const double across = ball.velocity.y;
  if (rel.x < 0.0 || gap > std::max(kTouch, -kSoon * ball.velocity.x) || std::abs(across) < kAcross)
    return std::nullopt;
  const double time = ball.velocity.x < 0.0 ? std::clamp(-gap / ball.velocity.x, 0.0, kSoon) : 0.0;
  const double ahead = rel.y + across * time;
  if (std::abs(ahead) > kFace) return std::nullopt;
  const double wanted = kShare * across + std::copysign(stoppableSpeed(pitch, ahead, 15.0), ahead);
  const double room = std::max(0.0, kRoom - std::copysign(1.0, wanted) * self.pose.position.y);
  const double speed = std::min({std::abs(wanted), pitch.speed, stoppableSpeed(pitch, room, 20.0)});
  return alongLine(self, line, std::copysign(speed, wanted));
}

/// Whether the keeper is at a ball near the goal before any opponent. Before a fast one it keeps its line: a
/// keeper that turns in order to clear leaves the ball a way in beside it. What runs along the end wall is
/// excepted.
bool comesFirst(const Picture& picture, const RobotState& self) {
  const Pitch& pitch = picture.pitch;
  const Vec2 ball = picture.ball.at(0.1);
  if (ball.x > -pitch.half_length + 0.24 || std::abs(ball.y) > 0.36) return false;
  const BallState& now = picture.ball.now();
  if (now.position.x > -pitch.half_length + 0.06 && squaredNorm(now.velocity) > kSlow * kSlow) return false;
  const double mine = timeToReach(pitch.pace, self, ball);
  for (int i = 0; i < picture.seen.team_size; ++i) {
    if (picture.opponentPresent(i) && timeToReach(pitch.pace, picture.opponent(i), ball) < mine) return false;
  }
  return true;
}

/// Whether the keeper goes out along the end wall to a ball there. Far from the post it has the wall behind
/// it, and nothing gets past. At the post an opponent with the ball arrives at full speed and pushes beside
/// the keeper's middle, which turns it, and the ball goes in behind it.
bool meetsAlongWall(const Picture& picture, const RobotState& self) {
  constexpr double kStrip = 0.06;     // [m] off the wall, the ball
  constexpr double kOwnStrip = 0.09;  // [m] off the wall, the keeper
  constexpr double kFarthest = 0.55;  // [m] |y| of the ball
  constexpr double kFastest = 1.0;    // [m/s] toward the goal; a faster one is there first
  constexpr double kBetween = 0.03;   // [m] that the keeper is nearer to the goal's middle
  const Pitch& pitch = picture.pitch;
  const BallState& ball = picture.ball.now();
  const double out = ball.position.y >= 0.0 ? 1.0 : -1.0;
  const double y = ball.position.y * out;
  if (ball.position.x > -pitch.half_length + kStrip || y < pitch.goal_half - 0.02 || y > kFarthest)
    return false;
  if (ball.velocity.y * out < -kFastest) return false;
  return self.pose.position.x < -pitch.half_length + kOwnStrip && self.pose.position.y * out < y - kBetween;
}

/// Pushes a ball that lies near out to the side, from the goal's side; nothing when the keeper is not there.
std::optional<Twist> clear(const Picture& picture, const RobotState& self) {
  const Pitch& pitch = picture.pitch;
  const Vec2 ball = picture.ball.at(0.05);
  const Vec2 rel = ball - self.pose.position;
  // In the mouth there is no wall behind the keeper, which was pushed in and has the ball before it: it
  // pushes out what is stuck there; before that its turn would only let the ball in.
  const bool in_mouth = picture.stuck > 2 * kStuck &&
                        std::abs(ball.y) < pitch.goal_half - pitch.ball_radius &&
                        self.pose.position.x < ball.x - 0.03;
  const bool at_wall = !in_mouth && ball.x < -pitch.half_length + pitch.ball_radius + 0.04;
  const double out = ball.y >= 0.0 ? 1.0 : -1.0;
  const bool beside = rel.x < 0.03 && std::abs(rel.x) < 0.05 && rel.y * out > 0.04;
  if (at_wall || beside) {
    if (rel.y * out < 0.02) return std::nullopt;
    return passThrough(self, {std::max(ball.x, -pitch.half_length + kDepth), ball.y + 0.1 * out},
                       pitch.speed);
  }
  if (rel.x < 0.02) return std::nullopt;
  const Vec2 way = unitOr(rel, {1.0, 0.0}) + Vec2{0.3, out * 0.4};
  int side = 0;
  const double heading = approachHeading(self.pose.position, ball, math::angleOf(way), 0.09, 1.0, side);
  return alongHeading(self, heading, pitch.speed);
}

/// The ball lies or comes along our end wall, beside the goal or in its mouth's edge.
bool alongEndWall(const Picture& picture) {
  const Pitch& pitch = picture.pitch;
  const Vec2 ball = picture.ball.now().position;
  return ball.x < -pitch.half_length + 0.08 && std::abs(ball.y) > 0.10 && std::abs(ball.y) < 0.5;
}

/// Closes the near post with a face that leads the ball out to the field, and holds: from within the mouth,
/// so that a ball that is pushed along the wall meets the middle of the face. Beside its middle it would turn
/// the keeper and pass behind it.
Move guardPost(const Picture& picture, const RobotState& self) {
  const Pitch& pitch = picture.pitch;
  const Vec2 ball = picture.ball.now().position;
  const double side = ball.y > 0.0 ? 1.0 : -1.0;
  const double lean = 0.15;
  const Vec2 post{-pitch.half_length + 0.025,
                  side * std::min(pitch.goal_half - 0.045, std::abs(ball.y) - 0.055)};
  const Vec2 way = post - self.pose.position;
  const double heading = side * (math::kPi / 2 - lean);
  // A keeper that was pushed into the goal has to come out of it first.
  if (std::abs(way.y) < 0.02 && way.x < 0.04) {
    Twist twist = turnTo(pitch, self, heading);
    twist.linear = std::clamp(4.0 * dot(way, math::unit(self.pose.heading)), -0.2, 0.2);
    return {twist, "guard post", post, {}, {}};
  }
  return {slideTo(picture, self, post.x, post.y), "guard post", post, {}, {}};
}

/// Out along the line, at speed, to a ball that is carried slanting past the near post: to where it comes
/// into the keeper's row, from within. A keeper that waits there is pushed along its own line into the goal.
std::optional<Move> runOut(const Picture& picture, const RobotState& self, double line) {
  constexpr double kStrip = 0.16;     // [m] off the wall, the ball
  constexpr double kNearest = 0.15;   // [m] |y| of the ball
  constexpr double kFarthest = 0.45;  // [m]
  constexpr double kComing = 0.3;     // [m/s] across
  constexpr double kRow = 0.03;       // [m] before the keeper's line, where a ball meets its front
  constexpr double kRoom = 0.06;      // [m] between the middles of both where they touch
  constexpr double kLeast = 0.10;     // [m] |y| of the keeper there; further in it waits
  constexpr double kOffLine = 0.05;   // [m] of the keeper
  constexpr double kTurned = 0.5;     // [rad] out of its line
  const Pitch& pitch = picture.pitch;
  const BallState& ball = picture.ball.now();
  const double out = ball.position.y >= 0.0 ? 1.0 : -1.0;
  const double y = ball.position.y * out, across = -ball.velocity.y * out;
  if (ball.position.x > -pitch.half_length + kStrip || y < kNearest || y > kFarthest || across < kComing ||
      !opponentDribblesAtGoal(picture))
    return std::nullopt;
  const double before = std::max(0.0, ball.position.x - (line + kRow));
  const double meet = y - across * before / -ball.velocity.x - kRoom;
  const double own = self.pose.position.y * out;
  if (meet < kLeast || own > y - kRoom / 2) return std::nullopt;
  if (std::abs(self.pose.position.x - line) > kOffLine ||
      std::abs(foldedError(math::kPi / 2, self.pose.heading)) > kTurned)
    return std::nullopt;
  const bool there = own > meet - 0.01;
  const Twist twist =
      there ? slideTo(picture, self, line, out * meet) : alongLine(self, line, out * pitch.speed);
  return Move{twist, "run out", Vec2{line, out * meet}, {}, {}};
}

/// A ball in the mouth behind the keeper: whatever touches it from here pushes it in. The keeper gets out of
/// its way along the line, and waits until the ball has come out or one of them has been moved.
std::optional<Twist> leaveBehind(const Picture& picture, const RobotState& self, double line) {
  constexpr double kBehind = 0.025;  // [m] of the ball's centre behind the keeper's
  constexpr double kDeep = 0.025;    // [m] of the ball's centre before the goal line
  constexpr double kApart = 0.08;    // [m] along the line
  constexpr double kBeside = 0.045;  // [m] along the line
  constexpr double kPushed = 0.09;   // [m] from the ball to an opponent's middle
  const Pitch& pitch = picture.pitch;
  const Vec2 ball = picture.ball.now().position;
  const Vec2 rel = ball - self.pose.position;
  // Beside its front, with an opponent pushing from the other side, it is held out by the keeper that stays.
  if (std::abs(rel.y) > kBeside && picture.opponentsNear(ball, kPushed) > 0) return std::nullopt;
  if (rel.x > -kBehind || ball.x > -pitch.half_length + kDeep || std::abs(ball.y) > pitch.goal_half)
    return std::nullopt;
  const double away = rel.y > 0.0 ? -1.0 : 1.0;
  return std::abs(rel.y) < kApart ? alongLine(self, line, away * pitch.speed) : Twist{};
}

/// A keeper that was pushed into the goal, with the ball before it, pushes it out while no opponent is near:
/// one that waits is pushed in with it by the next run at the ball.
std::optional<Twist> pushOut(const Picture& picture, const RobotState& self) {
  constexpr double kIn = 0.02;      // [m] of the keeper's middle before the goal line at most
  constexpr double kBefore = 0.03;  // [m] by which the ball is farther out
  constexpr double kAside = 0.06;   // [m]
  constexpr double kNear = 0.115;   // [m]
  constexpr double kLies = 0.35;    // [m/s]
  constexpr double kInTime = 0.2;   // [s] that no opponent is at the ball
  constexpr double kTurned = 0.9;   // [rad] off straight out: from there on it goes on whatever comes
  constexpr double kOut = 0.2;      // tangent, to the side of the near post
  const Pitch& pitch = picture.pitch;
  const BallState& ball = picture.ball.now();
  const Vec2 rel = ball.position - self.pose.position;
  if (self.pose.position.x > -pitch.half_length + kIn || std::abs(ball.position.y) > pitch.goal_half)
    return std::nullopt;
  if (rel.x < kBefore || std::abs(rel.y) > kAside || squaredNorm(rel) > kNear * kNear) return std::nullopt;
  if (std::abs(foldedError(0.0, self.pose.heading)) > kTurned) {
    if (squaredNorm(ball.velocity) > kLies * kLies) return std::nullopt;
    for (int i = 0; i < picture.seen.team_size; ++i) {
      if (picture.opponentPresent(i) && timeToReach(pitch.pace, picture.opponent(i), ball.position) < kInTime)
        return std::nullopt;
    }
  }
  const double side = ball.position.y >= 0.0 ? kOut : -kOut;
  return alongHeading(self, math::angleOf(unitOr(rel, {1.0, 0.0}) + Vec2{0.0, side}), pitch.speed);
}

/// Where on its line the keeper should stand, y [m].
double keeperPlace(const Picture& picture, double line) {
  const Pitch& pitch = picture.pitch;
  const auto shot = crossing(picture, line + pitch.ball_radius);
  if (shot && std::abs(*shot) < pitch.goal_half + 0.05) {
    return std::clamp(*shot + lead(picture, line), -kReach, kReach);
  }
  const Vec2 ball = picture.ball.at(0.05);
  return std::clamp(equalGapPoint(pitch.field, ball, kDepth).y, -kReach, kReach);
}

}  // namespace

bool mustSave(const Picture& picture, int robot) {
  const Pitch& pitch = picture.pitch;
  const auto shot = crossing(picture, -pitch.half_length);
  if (!shot || std::abs(*shot) > pitch.goal_half + 0.02) return false;
  return picture.own(robot).pose.position.x < -pitch.half_length + 0.3 &&
         picture.ball.now().position.x > picture.own(robot).pose.position.x;
}

Move keep(const Picture& picture, int robot) {
  const RobotState& self = picture.own(robot);
  const Pitch& pitch = picture.pitch;
  const double line = -pitch.half_length + kDepth;
  const BallState& ball = picture.ball.now();
  const Vec2 rel = ball.position - self.pose.position;
  if (picture.seen.restart == RestartKind::kPenalty && !picture.seen.restart_is_ours &&
      picture.seen.since_restart < 0.8 && rel.x > 0.04 && squaredNorm(rel) > 0.06 * 0.06) {
    // Out to meet the taker: the nearer to the ball, the more of the goal is covered.
    const Vec2 meet = ball.position + ball.velocity * 0.12;
    return {passThrough(self, meet, pitch.speed), "meet penalty", {}, meet, {}};
  }
  const auto shot = crossing(picture, -pitch.half_length);
  const bool coming =
      shot && std::abs(*shot) < pitch.goal_half + 0.03 && squaredNorm(ball.velocity) > 0.3 * 0.3;
  const bool stuck = picture.stuck > kStuck && isInArea(pitch.field, ball.position, true, 0.05);
  if (const auto twist = leaveBehind(picture, self, line)) return {*twist, "leave ball", {}, {}, {}};
  if (const auto twist = pushOut(picture, self)) return {*twist, "push out", {}, ball.position, {}};
  if (!coming && (stuck || comesFirst(picture, self) || meetsAlongWall(picture, self))) {
    if (const auto twist = clear(picture, self)) return {*twist, "clear", {}, ball.position, {}};
  }
  if (const auto move = runOut(picture, self, line)) return *move;
  if (!(coming && rel.x > 0.03) && alongEndWall(picture)) return guardPost(picture, self);
  if (const auto twist = goWith(picture, self, line)) return {*twist, "go with ball", {}, {}, {}};
  const double y = keeperPlace(picture, line);
  return {slideTo(picture, self, line, y), "", Vec2{line, y}, {}, {}};
}

}  // namespace fulbito::libero
