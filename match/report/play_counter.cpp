#include "match/report/play_counter.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fulbito {
namespace {

Tick ticksOf(double seconds, double dt) { return static_cast<Tick>(std::floor(seconds / dt + 0.5)); }

bool isSlower(const RobotState& robot, double speed) { return squaredNorm(robot.velocity) < speed * speed; }

}  // namespace

PlayCounter::PlayCounter(const MatchConfig& config)
    : half_length_(config.field.length / 2),
      half_width_(config.field.width / 2),
      half_mouth_(config.field.hasGoals() ? config.field.goal_width / 2 : 0.0),
      corner_(config.field.corner),
      ball_radius_(config.robot.ball.radius),
      pause_(ticksOf(kContactPause, config.physics.controlPeriod())),
      lock_(ticksOf(kLockSeconds, config.physics.controlPeriod())),
      long_contact_(ticksOf(kLongContact, config.physics.controlPeriod())) {}

void PlayCounter::count(const MatchTick& tick, MatchStatistics& counted) {
  countBall(tick, counted);
  for (const TeamId team : kTeams) countTeam(tick, team, counted.teams[indexOf(team)].play);
  countMates(tick, counted);
}

void PlayCounter::countBall(const MatchTick& tick, MatchStatistics& counted) const {
  const Vec2 ball = tick.world->balls.front().position;
  // Distances from the lines of the nearer end wall and side wall.
  const double end = half_length_ - std::abs(ball.x), side = half_width_ - std::abs(ball.y);
  // The end wall begins at the post; the triangle lies across both lines.
  const double mouth = std::max(0.0, half_mouth_ - std::abs(ball.y));
  const double end_wall = std::sqrt(end * end + mouth * mouth);
  const double triangle = (end + side - corner_) / std::sqrt(2.0);
  if (std::min({side, end_wall, triangle}) <= kWallGap + ball_radius_) ++counted.wall_ticks;
  if (std::max(end, side) <= kCornerReach) ++counted.corner_ticks;
}

void PlayCounter::countTeam(const MatchTick& tick, TeamId team, TeamPlay& play) const {
  const double own = tick.referee->sideOf(team) == Side::kLeft ? -1.0 : 1.0;  // the sign of its goal's x
  const Vec2 goal{own * half_length_, 0.0}, ball = tick.world->balls.front().position;
  double keeper_distance = std::numeric_limits<double>::infinity();
  bool keeper_slow = false, keeper_behind = false;
  int robots = 0, slow = 0, behind = 0;
  for (std::size_t i = 0; i < tick.ids.size(); ++i) {
    if (tick.ids[i].team != team) continue;
    const RobotState& robot = tick.world->robots[i];
    const bool is_slow = isSlower(robot, kSlowSpeed), is_behind = own * robot.pose.position.x > own * ball.x;
    ++robots;
    slow += is_slow ? 1 : 0;
    behind += is_behind ? 1 : 0;
    const double from_goal = squaredNorm(robot.pose.position - goal);
    if (from_goal >= keeper_distance) continue;
    keeper_distance = from_goal;
    keeper_slow = is_slow;
    keeper_behind = is_behind;
  }
  play.robot_ticks += robots;
  play.slow_ticks += slow;
  play.field_ticks += std::max(0, robots - 1);
  play.field_slow_ticks += slow - (keeper_slow ? 1 : 0);
  play.uncovered += behind == 0 ? 1 : 0;
  play.field_uncovered += behind - (keeper_behind ? 1 : 0) == 0 ? 1 : 0;
  if (own * ball.x <= 0.0) return;
  ++play.own_half;
  if (keeper_distance > kKeeperLeash * kKeeperLeash) ++play.keeper_away;
}

Tick PlayCounter::grow(Spell& spell, Tick now) const {
  if (spell.last < 0 || now - spell.last > pause_ + 1) spell = {now, now, false};
  spell.last = now;
  return now - spell.since + 1;
}

void PlayCounter::countMates(const MatchTick& tick, MatchStatistics& counted) {
  const auto once = [](Spell& spell, bool now, std::int64_t& count) {
    if (!now || spell.counted) return;
    spell.counted = true;
    ++count;
  };
  for (const ContactEvent& contact : tick.contacts) {
    if (contact.a.kind != BodyKind::kRobot || contact.b.kind != BodyKind::kRobot) continue;
    const RobotId a = tick.ids[contact.a.index], b = tick.ids[contact.b.index];
    if (a.team != b.team) continue;
    TeamPlay& play = counted.teams[indexOf(a.team)].play;
    Mates& mates = mates_[indexOf(a.team)][std::min(a.number, b.number)][std::max(a.number, b.number)];
    const Tick touching = grow(mates.contact, tick.tick);
    play.longest_contact = std::max(play.longest_contact, touching);
    once(mates.contact, touching > long_contact_, play.long_contacts);
    const auto& robots = tick.world->robots;
    if (!isSlower(robots[contact.a.index], kLockSpeed) || !isSlower(robots[contact.b.index], kLockSpeed)) {
      continue;
    }
    once(mates.lock, grow(mates.lock, tick.tick) > lock_, play.locks);
  }
}

}  // namespace fulbito
