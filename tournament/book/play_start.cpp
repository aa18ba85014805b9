#include "tournament/book/play_start.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "engine/core/math/random.hpp"
#include "fulbito/detail/math.hpp"
#include "referee/geometry/ball_gap.hpp"
#include "referee/geometry/placed_body.hpp"
#include "tournament/book/draw_order.hpp"
#include "tournament/book/sparring.hpp"

namespace fulbito {
namespace {

constexpr int kAttempts = 20;
constexpr std::uint64_t kAttemptRoom = 32;  // indices of random draws reserved for each start
constexpr double kEarliest = 1.5;           // [s] earliest match time of a state
constexpr double kLatest = 5.0;             // [s] latest match time at which the search begins
constexpr double kPatience = 4.0;           // [s] how long the search lasts
constexpr double kSettled = 1.0;  // [s] of play since the last restart, so that robots have left its places
constexpr double kGoesOn = 0.5;   // [s] that play must go on after the state
constexpr double kSlowest = 0.1;  // [m/s] least speed of the ball
constexpr double kGap = 0.001;    // [m] between bodies and to walls
constexpr double kHalf = 600.0;   // [s] long enough that no half ends before a state is found

/// The match between sparring teams that the state is taken from.
MatchConfig sparringMatch(const MatchConfig& match, std::uint64_t seed) {
  MatchConfig config;
  config.teams = {sparringTeam(), sparringTeam()};
  config.rules = match.rules;
  config.rules.half_seconds = kHalf;
  config.field = match.field;
  config.robot = match.robot;
  config.physics = match.physics;
  config.placement_error = match.placement_error;
  config.seed = seed;
  return config;
}

std::vector<Pose2> posesOf(const Placement& placement) {
  std::vector<Pose2> poses;
  for (const TeamPoses& team : placement.robots) {
    for (const auto& pose : team) {
      if (pose) poses.push_back(*pose);
    }
  }
  return poses;
}

PlacedBody bodyOf(const RobotModel& robot, const Pose2& pose, double margin) {
  return {pose.position, math::unit(pose.heading), robot.length / 2 + margin, robot.width / 2 + margin};
}

/// Whether robot `i` keeps the gap to the walls, the ball and the robots before it in `poses`.
bool isFree(const MatchConfig& match, const std::vector<Pose2>& poses, std::size_t i, Vec2 ball) {
  const RobotModel& robot = match.robot.robot;
  const PlacedBody body = bodyOf(robot, poses[i], 0.0);
  if (!onField(match.field, bodyOf(robot, poses[i], kGap))) return false;
  if (const auto gap = ballGap(robot, poses[i], match.robot.ball, ball, kGap); gap && *gap < kGap)
    return false;
  return std::all_of(poses.begin(), poses.begin() + static_cast<std::ptrdiff_t>(i),
                     [&](const Pose2& other) { return apart(body, bodyOf(robot, other, 0.0), kGap); });
}

bool ballPlays(const MatchConfig& match, const Placement& placement) {
  const double radius = match.robot.ball.radius;
  return std::abs(placement.ball.x) < match.field.length / 2 - radius - kGap &&
         insideField(match.field, placement.ball, radius + kGap) && norm(placement.ball_velocity) >= kSlowest;
}

bool isGood(const MatchConfig& match, const Placement& placement) {
  if (!ballPlays(match, placement)) return false;
  const std::vector<Pose2> poses = posesOf(placement);
  for (std::size_t i = 0; i < poses.size(); ++i) {
    if (!isFree(match, poses, i, placement.ball)) return false;
  }
  // A robot that was sent off is missing here, but a start needs all robots.
  return poses.size() == 2 * static_cast<std::size_t>(match.rules.team_size);
}

/// Looks for a good state while the match is played.
class StateSearch {
 public:
  StateSearch(Match match, double earliest) : match_(std::move(match)), earliest_(earliest) {}

  /// The state, or nothing if the match shows no good state in time.
  std::optional<Placement> find() {
    std::optional<Placement> found;
    Tick found_at = 0;
    const double deadline = earliest_ + kPatience;
    while ((found || match_.seconds() < deadline) && match_.step()) {
      if (secondsOfPlay() < kSettled) found.reset();
      if (found && match_.tick() - found_at >= ticksOf(kGoesOn)) return found;
      if (found || match_.seconds() < earliest_ || secondsOfPlay() < kSettled) continue;
      const Placement now = match_.placement();
      if (!isGood(match_.config(), now)) continue;
      found = now;
      found_at = match_.tick();
    }
    return std::nullopt;
  }

 private:
  double dt() const { return match_.config().physics.controlPeriod(); }
  Tick ticksOf(double seconds) const { return static_cast<Tick>(std::ceil(seconds / dt())); }
  /// Seconds since the signal of the last restart; a referee call starts the count again.
  double secondsOfPlay() const {
    const RefereeState& referee = match_.referee();
    return referee.playing ? static_cast<double>(match_.tick() - referee.play_began) * dt() : 0.0;
  }

  Match match_;
  double earliest_;
};

}  // namespace

Result<Placement> playStart(const StartKey& key, const MatchConfig& match) {
  for (std::uint64_t attempt = 0; attempt < kAttempts; ++attempt) {
    Rng rng(key.seed, Stream::kStartBook, drawIndex(key.kind, key.turn * kAttemptRoom + attempt));
    const std::uint64_t seed = rng.bits64() >> 11;
    const double earliest = rng.uniform(kEarliest, kLatest);
    auto sparring = Match::create(sparringMatch(match, seed));
    if (!sparring) return tl::unexpected<Error>(sparring.error());
    auto found = StateSearch(std::move(*sparring), earliest).find();
    if (!found) continue;
    for (const TeamId team : kTeams) {
      if (!match.present[indexOf(team)]) found->robots[indexOf(team)] = {};
    }
    return *found;
  }
  return fail(ErrorCode::kBadInput,
              fmt::format("start 'play': the rules '{}' with {} robots per team on the field '{}' lead to no "
                          "state with room between all bodies in {} attempts",
                          match.rules.name, match.rules.team_size, match.field.name, kAttempts));
}

}  // namespace fulbito
