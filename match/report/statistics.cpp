#include "fulbito/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "match/report/foul_goals.hpp"
#include "match/report/play_counter.hpp"

namespace fulbito {
namespace {

constexpr std::size_t kManyGoals = 64;
constexpr std::size_t kManyClauses = 32;

double shareOf(Tick part, Tick whole) {
  return whole > 0 ? static_cast<double>(part) / static_cast<double>(whole) : 0.0;
}

}  // namespace

double TeamPlay::slow() const { return shareOf(slow_ticks, robot_ticks); }

double TeamPlay::fieldSlow() const { return shareOf(field_slow_ticks, field_ticks); }

double TeamPlay::keeperAway() const { return shareOf(keeper_away, own_half); }

double TeamStatistics::distance() const {
  double sum = 0.0;
  for (const RobotStatistics& robot : robots) sum += robot.distance;
  return sum;
}

int TeamStatistics::touches() const {
  int sum = 0;
  for (const RobotStatistics& robot : robots) sum += robot.touches;
  return sum;
}

double MatchStatistics::possession(TeamId team) const {
  return shareOf(teams[indexOf(team)].possession, teams[0].possession + teams[1].possession);
}

double MatchStatistics::third(TeamId team, std::size_t which) const {
  return shareOf(teams[indexOf(team)].thirds[which], play_ticks);
}

double MatchStatistics::meanBallX(TeamId team) const {
  if (play_ticks == 0) return 0.0;
  const double mean = ball_x_sum / static_cast<double>(play_ticks);
  return team == TeamId::kBlue ? mean : 0.0 - mean;
}

double MatchStatistics::uncovered(TeamId team) const {
  return shareOf(teams[indexOf(team)].play.uncovered, play_ticks);
}

double MatchStatistics::fieldUncovered(TeamId team) const {
  return shareOf(teams[indexOf(team)].play.field_uncovered, play_ticks);
}

double MatchStatistics::atWall() const { return shareOf(wall_ticks, play_ticks); }

double MatchStatistics::inCorner() const { return shareOf(corner_ticks, play_ticks); }

int MatchStatistics::restartCount(RestartKind kind) const {
  const PerTeam<int>& counts = restarts[static_cast<std::size_t>(kind)];
  return counts[0] + counts[1];
}

/// The observer's state between ticks.
struct StatisticsObserver::Impl {
  /// A shot in progress.
  struct Shot {
    RobotId shooter;
    bool on_goal = false;
    Tick last = 0;  ///< last tick in which it was under way
  };
  /// A direction of the ball toward a goal, or close to a post.
  struct Aim {
    TeamId attacker = TeamId::kBlue;
    bool on_goal = false;
  };

  void onMatchStart(const MatchConfig& config);
  void onPlayStart(const PlayStart& start);
  void onTick(const MatchTick& tick);

  void countContacts(const MatchTick& tick);
  void countMoves(const MatchTick& tick);
  void countBall(const MatchTick& tick);
  void watchShot(const MatchTick& tick);
  void countCalls(std::span<const GameEvent> events, const RefereeState& referee);
  void goal(const GameEvent& event, TeamId team, const RefereeState& referee);
  void countPaid(const GameEvent& event, Tick played);
  void countGoalAsShot(const GoalRecord& goal);
  std::optional<Aim> aimOf(const BallState& ball, const RefereeState& referee) const;
  void onGoal(Shot& shot);
  RobotStatistics& of(RobotId id) { return counted.teams[indexOf(id.team)].robots[id.number]; }

  MatchStatistics counted;
  double half_length = 0.0;
  double half_mouth = 0.0;  ///< [m] half of the mouth
  double ball_radius = 0.0;
  Tick shot_pause = 0;
  bool in_play = false;
  std::array<Vec2, 2 * kMaxTeamSize> places_before{};  ///< places of the robots one tick ago
  std::optional<TeamId> in_possession;
  std::optional<RobotId> last_touch;
  PerTeam<std::optional<RobotId>> team_touch;  ///< last touch by each team in this play
  std::optional<Shot> open_shot;
  FoulGoalFinder foul_goals;
  PlayCounter play;
};

StatisticsObserver::StatisticsObserver() : impl_(std::make_unique<Impl>()) {}
StatisticsObserver::StatisticsObserver(StatisticsObserver&&) noexcept = default;
StatisticsObserver::~StatisticsObserver() = default;

const MatchStatistics& StatisticsObserver::statistics() const { return impl_->counted; }
void StatisticsObserver::onMatchStart(const MatchConfig& config) { impl_->onMatchStart(config); }
void StatisticsObserver::onPlayStart(const PlayStart& start) { impl_->onPlayStart(start); }
void StatisticsObserver::onTick(const MatchTick& tick) { impl_->onTick(tick); }

void StatisticsObserver::Impl::onMatchStart(const MatchConfig& config) {
  *this = {};
  counted.dt = config.physics.controlPeriod();
  counted.team_size = config.rules.team_size;
  counted.goals.reserve(kManyGoals);
  counted.calls.reserve(kManyClauses);
  half_length = config.field.length / 2;
  half_mouth = config.field.goal_width / 2;
  ball_radius = config.robot.ball.radius;
  play = PlayCounter(config);
  shot_pause = static_cast<Tick>(std::floor(kShotPause / counted.dt + 0.5));
}

void StatisticsObserver::Impl::onPlayStart(const PlayStart& start) {
  ++counted.restarts[static_cast<std::size_t>(start.call.kind)][indexOf(start.call.team)];
  countCalls(start.events, *start.referee);
  for (std::size_t i = 0; i < start.ids.size(); ++i) places_before[i] = start.world->robots[i].pose.position;
  in_play = start.referee->playing;
  play.begin();
  in_possession.reset();
  last_touch.reset();
  team_touch = {};
  open_shot.reset();
}

void StatisticsObserver::Impl::onTick(const MatchTick& tick) {
  if (in_play) {
    ++counted.play_ticks;
    countContacts(tick);
    countMoves(tick);
    countBall(tick);
    play.count(tick, counted);
    watchShot(tick);
  } else {
    ++counted.waiting_ticks;
    for (std::size_t i = 0; i < tick.ids.size(); ++i) places_before[i] = tick.world->robots[i].pose.position;
  }
  countCalls(tick.events, *tick.referee);
  in_play = tick.referee->playing;
}

void StatisticsObserver::Impl::countContacts(const MatchTick& tick) {
  for (const ContactEvent& contact : tick.contacts) {
    if (contact.b.kind == BodyKind::kBall && contact.a.kind == BodyKind::kRobot) {
      const RobotId id = tick.ids[contact.a.index];
      last_touch = team_touch[indexOf(id.team)] = id;
      if (contact.began) ++of(id).touches;
      continue;
    }
    if (!contact.began || contact.b.kind != BodyKind::kRobot) continue;
    const TeamId team = tick.ids[contact.b.index].team;
    if (contact.a.kind == BodyKind::kWall) {
      ++counted.teams[indexOf(team)].wall_contacts;
    } else if (contact.a.kind == BodyKind::kRobot) {
      ++(tick.ids[contact.a.index].team == team ? counted.teams[indexOf(team)].mate_contacts
                                                : counted.opponent_contacts);
    }
  }
}

void StatisticsObserver::Impl::countMoves(const MatchTick& tick) {
  const Vec2 ball = tick.world->balls.front().position;
  PerTeam<double> nearest{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  for (std::size_t i = 0; i < tick.ids.size(); ++i) {
    const Vec2 place = tick.world->robots[i].pose.position;
    RobotStatistics& robot = of(tick.ids[i]);
    ++robot.ticks;
    robot.distance += distance(place, places_before[i]);
    places_before[i] = place;
    double& least = nearest[indexOf(tick.ids[i].team)];
    least = std::min(least, squaredNorm(place - ball));
  }
  const double blue = std::sqrt(nearest[0]), yellow = std::sqrt(nearest[1]);
  if (blue + kPossessionLead < yellow) in_possession = TeamId::kBlue;
  if (yellow + kPossessionLead < blue) in_possession = TeamId::kYellow;
  if (in_possession) ++counted.teams[indexOf(*in_possession)].possession;
}

void StatisticsObserver::Impl::countBall(const MatchTick& tick) {
  const double right = tick.world->balls.front().position.x;
  const double x = tick.referee->blue_side == Side::kLeft ? right : -right;  // in blue's frame
  counted.ball_x_sum += x;
  const std::size_t third = x < -half_length / 3 ? 0 : x > half_length / 3 ? 2 : 1;
  ++counted.teams[0].thirds[third];
  ++counted.teams[1].thirds[2 - third];
}

std::optional<StatisticsObserver::Impl::Aim> StatisticsObserver::Impl::aimOf(
    const BallState& ball, const RefereeState& referee) const {
  if (!(squaredNorm(ball.velocity) > kShotSpeed * kShotSpeed)) return std::nullopt;
  const double ahead = half_length - (ball.velocity.x > 0.0 ? ball.position.x : -ball.position.x);
  const double speed = std::abs(ball.velocity.x);
  if (ahead < 0.0 || ahead > speed * kShotHorizon) return std::nullopt;
  const double y = std::abs(ball.position.y + ball.velocity.y * (ahead / speed));
  if (y > half_mouth + kShotNearMiss) return std::nullopt;
  const Side goal = ball.velocity.x > 0.0 ? Side::kRight : Side::kLeft;
  const TeamId defender = goal == referee.blue_side ? TeamId::kBlue : TeamId::kYellow;
  return Aim{other(defender), y < half_mouth - ball_radius};
}

void StatisticsObserver::Impl::onGoal(Shot& shot) {
  if (shot.on_goal) return;
  shot.on_goal = true;
  ++counted.teams[indexOf(shot.shooter.team)].shots_on_goal;
}

void StatisticsObserver::Impl::watchShot(const MatchTick& tick) {
  const std::optional<Aim> aim = aimOf(tick.world->balls.front(), *tick.referee);
  if (aim && open_shot && open_shot->shooter.team == aim->attacker) {
    open_shot->last = tick.tick;
  } else if (aim && last_touch && last_touch->team == aim->attacker) {
    open_shot = Shot{*last_touch, false, tick.tick};
    ++counted.teams[indexOf(aim->attacker)].shots;
    ++of(*last_touch).shots;
  } else if (open_shot && tick.tick - open_shot->last > shot_pause) {
    open_shot.reset();
  }
  if (open_shot && aim && aim->on_goal && aim->attacker == open_shot->shooter.team) onGoal(*open_shot);
}

void StatisticsObserver::Impl::countCalls(std::span<const GameEvent> events, const RefereeState& referee) {
  for (const GameEvent& event : events) {
    auto count = std::find_if(counted.calls.begin(), counted.calls.end(),
                              [&](const CallCount& c) { return c.clause == event.clause; });
    if (count == counted.calls.end()) count = counted.calls.insert(count, CallCount{event.clause, {}, 0, {}});
    ++(event.team ? count->against[indexOf(*event.team)] : count->neither);
    countPaid(event, referee.match_ticks);
    if (event.clause == "goal" && event.team) goal(event, *event.team, referee);
  }
}

void StatisticsObserver::Impl::countPaid(const GameEvent& event, Tick played) {
  const auto foul = foul_goals.take(event, played, counted.dt);
  if (!foul) return;
  ++counted.teams[indexOf(*event.team)].goals_after_foul;
  for (CallCount& count : counted.calls) {
    if (count.clause == *foul) ++count.paid[indexOf(*event.team)];
  }
}

void StatisticsObserver::Impl::goal(const GameEvent& event, TeamId team, const RefereeState& referee) {
  GoalRecord goal;
  goal.seconds = static_cast<double>(event.tick) * counted.dt;
  goal.period = event.period;
  goal.play_time = event.play_time;
  goal.team = team;
  goal.score = referee.score;
  const bool shot = open_shot && open_shot->shooter.team == goal.team;
  goal.own_goal = last_touch && last_touch->team != goal.team && !(shot && open_shot->on_goal);
  if (goal.own_goal) {
    goal.scorer = last_touch;
    ++counted.teams[indexOf(other(goal.team))].own_goals;
  } else {
    goal.scorer = shot ? std::optional(open_shot->shooter) : team_touch[indexOf(goal.team)];
    if (goal.scorer) ++of(*goal.scorer).goals;
    countGoalAsShot(goal);
  }
  counted.goals.push_back(goal);
  open_shot.reset();
}

void StatisticsObserver::Impl::countGoalAsShot(const GoalRecord& goal) {
  if (!open_shot || open_shot->shooter.team != goal.team) {
    ++counted.teams[indexOf(goal.team)].shots;
    if (goal.scorer) ++of(*goal.scorer).shots;
    open_shot = Shot{goal.scorer.value_or(RobotId{goal.team, 0}), false, 0};
  }
  onGoal(*open_shot);
}

}  // namespace fulbito
