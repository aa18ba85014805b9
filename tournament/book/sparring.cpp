#include "tournament/book/sparring.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "engine/core/math/random.hpp"
#include "engine/core/models/field_places.hpp"
#include "fulbito/detail/math.hpp"

namespace fulbito {
namespace {

constexpr double kHomeSeconds = 2.0;  // [s] after which a robot gets another place
constexpr double kRoom = 3.0;   // [radii] between centres: a robot keeps away from robots nearer than this
constexpr double kNear = 0.04;  // [m] a robot this near to its target has arrived

/// Backs off a robot that should move but is held. The sparring team has its own copy, so that starts do not
/// depend on the skills of the built-in teams.
class BackingOff {
 public:
  /// @return the command that replaces the team's for a moment, if any
  std::optional<Twist> update(const RobotState& robot, bool meant, double dt) {
    constexpr double kStill = 0.03, kTurning = 1.0;      // [m/s], [rad/s]
    constexpr double kPatience = 0.8, kDuration = 0.25;  // [s]
    constexpr double kSpeed = 0.5, kWiggle = 3.0;        // [m/s], [rad/s]
    if (left_ > 0.0) {
      left_ -= dt;
      return Twist{speed_, kWiggle};
    }
    const bool still = norm(robot.velocity) < kStill && std::abs(robot.angular_velocity) < kTurning;
    held_ = meant && still ? held_ + dt : 0.0;
    if (held_ < kPatience) return std::nullopt;
    held_ = 0.0;
    left_ = kDuration;
    // Away from the direction in which the wheels push.
    speed_ = robot.wheels.left + robot.wheels.right > 0.0 ? -kSpeed : kSpeed;
    return Twist{speed_, kWiggle};
  }

 private:
  double held_ = 0.0;  // [s] without motion
  double left_ = 0.0;  // [s] of backing off
  double speed_ = 0.0;
};

class Sparring final : public Strategy {
 public:
  void begin(const MatchInfo& info) override {
    info_ = info;
    rng_ = Rng(info.seed, Stream::kStartBook, indexOf(info.team));
    backing_off_.fill({});
    drawHomes();
  }

  TeamCommand decide(const Observation& seen) override {
    if (seen.tick % homeTicks() == 0) drawHomes();
    const std::size_t player = nearestToBall(seen);
    TeamCommand command;
    for (std::size_t i = 0; i < static_cast<std::size_t>(seen.team_size); ++i) {
      if (!seen.own[i].present) continue;
      const RobotState& robot = seen.own[i].state;
      const Vec2 target = i == player ? behindBall(robot, seen.ball)
                                      : robot.pose.position + freeWay(i, placeOf(i, seen), seen);
      const Twist wanted = drive(robot, target, i == player);
      const bool meant = seen.playing && distance(robot.pose.position, target) > kNear;
      const auto free = backing_off_[i].update(robot, meant, seen.dt);
      command.robots[i] = RobotCommand::byTwist(free ? *free : wanted);
    }
    return command;
  }

 private:
  Tick homeTicks() const { return std::max<Tick>(1, static_cast<Tick>(kHomeSeconds / info_.dt())); }

  void drawHomes() {
    for (Vec2& home : homes_) {
      home = {rng_.uniform(-0.4, 0.3) * info_.field.length, rng_.uniform(-0.42, 0.42) * info_.field.width};
    }
  }

  bool hasKeeper(const Observation& seen) const { return seen.team_size > 1 && seen.own[0].present; }

  std::size_t nearestToBall(const Observation& seen) const {
    std::size_t nearest = 0;
    double least = 1e9;
    for (std::size_t i = hasKeeper(seen) ? 1 : 0; i < static_cast<std::size_t>(seen.team_size); ++i) {
      const double away = distance(seen.own[i].state.pose.position, seen.ball.position);
      if (!seen.own[i].present || away >= least) continue;
      nearest = i;
      least = away;
    }
    return nearest;
  }

  /// The target: through the ball for a robot behind it, around the ball for one in front of it.
  Vec2 behindBall(const RobotState& robot, const BallState& ball) const {
    const double room = 2.0 * info_.robot.circumradius();
    const Vec2 from_ball = robot.pose.position - ball.position;
    if (from_ball.x < -info_.ball.radius && std::abs(from_ball.y) < room)
      return ball.position + Vec2{room, 0.0};
    const double aside = from_ball.x > 0.0 && std::abs(from_ball.y) < room ? room : 0.0;
    return insideWalls(info_.field, ball.position + Vec2{-room, std::copysign(aside, from_ball.y)}, room / 2);
  }

  Vec2 placeOf(std::size_t robot, const Observation& seen) const {
    const double margin = 1.2 * info_.robot.circumradius();
    if (robot == 0 && hasKeeper(seen)) {
      const double half = info_.field.goal_width / 2;
      return {-info_.field.length / 2 + margin, std::clamp(seen.ball.position.y, -half, half)};
    }
    return insideWalls(info_.field, homes_[robot] + Vec2{0.4 * seen.ball.position.x, 0.0}, margin);
  }

  /// Direction from the robot to its place, bent away from near robots. A robot that only holds a place makes
  /// room.
  Vec2 freeWay(std::size_t robot, Vec2 place, const Observation& seen) const {
    const Vec2 at = seen.own[robot].state.pose.position;
    const double room = kRoom * info_.robot.circumradius();
    Vec2 way = place - at;
    if (norm(way) > room) way = way * (room / norm(way));
    for (const auto* team : {&seen.own, &seen.opponents}) {
      for (const ObservedRobot& other : *team) {
        const Vec2 apart = at - other.state.pose.position;
        const double away = norm(apart);
        if (other.present && away > 0.0 && away < room) way += apart * (2.0 * (room - away) / away);
      }
    }
    return way;
  }

  Twist drive(const RobotState& robot, Vec2 target, bool fast) const {
    const Vec2 way = target - robot.pose.position;
    double error = math::wrapAngle(math::angleOf(way) - robot.pose.heading);
    const bool backward = std::abs(error) > math::kPi / 2;
    if (backward) error = math::wrapAngle(error + math::kPi);
    const double top = std::min(info_.robot.maxSpeed(), fast ? 1.0 : 3.0 * norm(way));
    const double speed = top * std::max(0.0, math::cos(error));
    return {backward ? -speed : speed, norm(way) > kNear ? 8.0 * error : 0.0};
  }

  MatchInfo info_;
  Rng rng_{0, Stream::kStartBook};
  std::array<Vec2, kMaxTeamSize> homes_{};
  std::array<BackingOff, kMaxTeamSize> backing_off_{};
};

}  // namespace

TeamChoice sparringTeam() {
  return TeamChoice::own("sparring", [] { return std::make_unique<Sparring>(); });
}

}  // namespace fulbito
