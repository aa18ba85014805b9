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

constexpr double kDepth = 0.042;  // [m] from the goal line to the keeper's centre
constexpr double kSlow = 0.6;     // [m/s] the keeper does not leave its line for a faster ball
constexpr double kStuck = 2.0;    // [s] after which the keeper clears even if opponents are near
constexpr double kReach = 0.175;  // [m] greatest |y| of the keeper on its line

/// Offset [m] of the keeper from the crossing of a ball that an opponent pushes, toward the side from which
/// the ball comes. So the keeper already moves with the ball at the touch. A ball slides along the face of a
/// keeper that stands still and passes it.
double lead(const Picture& picture, double line) {
  constexpr double kShare = 0.6;    // share of the ball's remaining way across
  constexpr double kLongest = 0.2;  // [s] before the touch
  if (!opponentDribblesAtGoal(picture)) return 0.0;
  const Pitch& pitch = picture.pitch;
  const BallState& ball = picture.ball.now();
  const double gap = ball.position.x - (line + pitch.robot_half + pitch.ball_radius);
  const double time = std::clamp(gap / -ball.velocity.x, 0.0, kLongest);
  return -kShare * ball.velocity.y * time;
}

/// The twist along the line with a ball that touches the keeper's face at an angle now or soon; empty
/// otherwise. Such a ball keeps most of its speed along the face, and its spin presses it toward the goal.
/// The keeper starts just before the touch; starting after the ball has passed would be 0.1 s late.
std::optional<Twist> goWith(const Picture& picture, const RobotState& self, double line) {
  constexpr double kSoon = 0.04;    // [s] before the touch
  constexpr double kFace = 0.04;    // [m] from the keeper's centre; it must first reach a ball farther out
  constexpr double kAcross = 0.2;   // [m/s] the keeper waits for slower balls
  constexpr double kShare = 0.8;    // share of the ball's speed across that it keeps along the face
  constexpr double kRoom = 0.24;    // [m] greatest |y| of the keeper, slightly past the post
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

/// Whether the keeper reaches a ball near the goal before any opponent. For a fast ball it keeps its line,
/// since a keeper that turns to clear opens a gap. Fast balls along the end wall are an exception.
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

/// Whether the keeper leaves its goal along the end wall to reach a ball there. Far from the post the wall is
/// behind the keeper, and no ball passes it. At the post an opponent would arrive at full speed, push beside
/// the keeper's centre and turn it, and the ball would go in.
bool meetsAlongWall(const Picture& picture, const RobotState& self) {
  constexpr double kStrip = 0.06;     // [m] greatest distance of the ball from the wall
  constexpr double kOwnStrip = 0.09;  // [m] greatest distance of the keeper from the wall
  constexpr double kFarthest = 0.55;  // [m] greatest |y| of the ball
  constexpr double kFastest = 1.0;    // [m/s] toward the goal; a faster ball arrives before the keeper
  constexpr double kBetween = 0.03;   // [m] by which the keeper must be nearer to the goal's middle
  const Pitch& pitch = picture.pitch;
  const BallState& ball = picture.ball.now();
  const double out = ball.position.y >= 0.0 ? 1.0 : -1.0;
  const double y = ball.position.y * out;
  if (ball.position.x > -pitch.half_length + kStrip || y < pitch.goal_half - 0.02 || y > kFarthest)
    return false;
  if (ball.velocity.y * out < -kFastest) return false;
  return self.pose.position.x < -pitch.half_length + kOwnStrip && self.pose.position.y * out < y - kBetween;
}

/// Pushes a near ball out to the side, away from the goal; empty if the keeper is not on the goal's side of
/// the ball.
std::optional<Twist> clear(const Picture& picture, const RobotState& self) {
  const Pitch& pitch = picture.pitch;
  const Vec2 ball = picture.ball.at(0.05);
  const Vec2 rel = ball - self.pose.position;
  // A keeper that was pushed into the mouth with the ball in front has no wall behind it. It pushes out a
  // ball that is stuck there, but only after a while, because its turn may let the ball in.
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

/// Whether the ball lies or rolls along the own end wall, beside the goal or at the edge of its mouth.
bool alongEndWall(const Picture& picture) {
  const Pitch& pitch = picture.pitch;
  const Vec2 ball = picture.ball.now().position;
  return ball.x < -pitch.half_length + 0.08 && std::abs(ball.y) > 0.10 && std::abs(ball.y) < 0.5;
}

/// Closes the near post with a face that deflects the ball into the field. The keeper stands within the
/// mouth, so that a ball pushed along the wall hits the middle of its face. A hit beside the middle would
/// turn the keeper, and the ball would pass behind it.
Move guardPost(const Picture& picture, const RobotState& self) {
  const Pitch& pitch = picture.pitch;
  const Vec2 ball = picture.ball.now().position;
  const double side = ball.y > 0.0 ? 1.0 : -1.0;
  const double lean = 0.15;
  const Vec2 post{-pitch.half_length + 0.025,
                  side * std::min(pitch.goal_half - 0.045, std::abs(ball.y) - 0.055)};
  const Vec2 way = post - self.pose.position;
  const double heading = side * (math::kPi / 2 - lean);
  // A keeper that was pushed into the goal must leave it first.
  if (std::abs(way.y) < 0.02 && way.x < 0.04) {
    Twist twist = turnTo(pitch, self, heading);
    twist.linear = std::clamp(4.0 * dot(way, math::unit(self.pose.heading)), -0.2, 0.2);
    return {twist, "guard post", post, {}, {}};
  }
  return {slideTo(picture, self, post.x, post.y), "guard post", post, {}, {}};
}

/// Drives along the line at full speed to a ball that an opponent pushes at an angle past the near post. The
/// target is where the ball arrives in front of the line, reached from the goal's middle. An opponent would
/// push a waiting keeper along its line into the goal.
std::optional<Move> runOut(const Picture& picture, const RobotState& self, double line) {
  constexpr double kStrip = 0.16;     // [m] greatest distance of the ball from the wall
  constexpr double kNearest = 0.15;   // [m] least |y| of the ball
  constexpr double kFarthest = 0.45;  // [m] greatest |y| of the ball
  constexpr double kComing = 0.3;     // [m/s] least speed of the ball toward the goal's middle
  constexpr double kRow = 0.03;       // [m] from the keeper's line to a ball that touches its front
  constexpr double kRoom = 0.06;      // [m] between the centres of keeper and ball when they touch
  constexpr double kLeast = 0.10;     // [m] least |y| of the meeting; the keeper waits for balls farther in
  constexpr double kOffLine = 0.05;   // [m] greatest distance of the keeper from its line
  constexpr double kTurned = 0.5;     // [rad] greatest angle between keeper and line
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

/// Handles a ball in the mouth behind the keeper, where any touch pushes it in. The keeper drives away from
/// it along the line and waits there.
std::optional<Twist> leaveBehind(const Picture& picture, const RobotState& self, double line) {
  constexpr double kBehind = 0.025;  // [m] least distance of the ball's centre behind the keeper's
  constexpr double kDeep = 0.025;    // [m] greatest distance of the ball's centre in front of the goal line
  constexpr double kApart = 0.08;    // [m] distance along the line that the keeper drives away
  constexpr double kBeside = 0.045;  // [m] along the line; a ball farther off is beside the keeper
  constexpr double kPushed = 0.09;   // [m] from the ball's centre to that of an opponent that pushes it
  const Pitch& pitch = picture.pitch;
  const Vec2 ball = picture.ball.now().position;
  const Vec2 rel = ball - self.pose.position;
  // A keeper that stays holds out a ball beside it that an opponent pushes from the other side.
  if (std::abs(rel.y) > kBeside && picture.opponentsNear(ball, kPushed) > 0) return std::nullopt;
  if (rel.x > -kBehind || ball.x > -pitch.half_length + kDeep || std::abs(ball.y) > pitch.goal_half)
    return std::nullopt;
  const double away = rel.y > 0.0 ? -1.0 : 1.0;
  return std::abs(rel.y) < kApart ? alongLine(self, line, away * pitch.speed) : Twist{};
}

/// The twist of a keeper that was pushed into the goal with the ball in front and pushes it out while no
/// opponent is near. A keeper that waits is pushed in with the ball by the next opponent that runs at it.
std::optional<Twist> pushOut(const Picture& picture, const RobotState& self) {
  constexpr double kIn = 0.02;      // [m] greatest distance of the keeper's centre in front of the goal line
  constexpr double kBefore = 0.03;  // [m] by which the ball must be farther out than the keeper
  constexpr double kAside = 0.06;   // [m]
  constexpr double kNear = 0.115;   // [m]
  constexpr double kLies = 0.35;    // [m/s]
  constexpr double kInTime = 0.2;   // [s] in which no opponent can reach the ball
  // [rad] heading error from straight out below which the keeper continues in any case
  constexpr double kTurned = 0.9;
  constexpr double kOut = 0.2;  // tangent of the turn toward the near post
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

/// The y [m] of the keeper's place on its line.
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
    // The keeper drives toward the taker, since it covers more of the goal the nearer it is to the ball.
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
