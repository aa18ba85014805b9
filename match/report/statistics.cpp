#include "fulbito/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "match/series/foul_goals.hpp"

namespace fulbito {
namespace {

constexpr std::size_t kManyGoals = 64;
constexpr std::size_t kManyClauses = 32;

double shareOf(Tick part, Tick whole) {
  return whole > 0 ? static_cast<double>(part) / static_cast<double>(whole) : 0.0;
}

}  // namespace

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

int MatchStatistics::restartCount(RestartKind kind) const {
  const PerTeam<int>& counts = restarts[static_cast<std::size_t>(kind)];
  return counts[0] + counts[1];
}

/// What the observer keeps between the ticks.
struct StatisticsObserver::Impl {
  /// A shot in progress.
  struct Shot {
    RobotId shooter;
    bool on_goal = false;
    Tick last = 0;  ///< tick at which it was last seen
  };
  /// The ball heads at a goal, or close to a post.
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
  RobotStatistics& of(RobotId id) { return s_.teams[indexOf(id.team)].robots[id.number]; }

  MatchStatistics s_;
  double half_length_ = 0.0;
  double post_ = 0.0;  ///< [m] half of the mouth
  double ball_radius_ = 0.0;
  Tick shot_pause_ = 0;
  bool playing_ = false;
  std::array<Vec2, 2 * kMaxTeamSize> places_{};  ///< of the robots, one tick ago
  std::optional<TeamId> holder_;
  std::optional<RobotId> last_touch_;
  PerTeam<std::optional<RobotId>> team_touch_;  ///< last touch by each team in this play
  std::optional<Shot> shot_;
  FoulGoalFinder foul_goals_;
};

StatisticsObserver::StatisticsObserver() : impl_(std::make_unique<Impl>()) {}
StatisticsObserver::StatisticsObserver(StatisticsObserver&&) noexcept = default;
StatisticsObserver::~StatisticsObserver() = default;

const MatchStatistics& StatisticsObserver::statistics() const { return impl_->s_; }
void StatisticsObserver::onMatchStart(const MatchConfig& config) { impl_->onMatchStart(config); }
void StatisticsObserver::onPlayStart(const PlayStart& start) { impl_->onPlayStart(start); }
void StatisticsObserver::onTick(const MatchTick& tick) { impl_->onTick(tick); }

void StatisticsObserver::Impl::onMatchStart(const MatchConfig& config) {
  *this = {};
  s_.dt = config.physics.controlPeriod();
  s_.team_size = config.rules.team_size;
  s_.goals.reserve(kManyGoals);
  s_.calls.reserve(kManyClauses);
  half_length_ = config.field.length / 2;
  post_ = config.field.goal_width / 2;
  ball_radius_ = config.robot.ball.radius;
  shot_pause_ = static_cast<Tick>(std::floor(kShotPause / s_.dt + 0.5));
}

void StatisticsObserver::Impl::onPlayStart(const PlayStart& start) {
  ++s_.restarts[static_cast<std::size_t>(start.call.kind)][indexOf(start.call.team)];
  countCalls(start.events, *start.referee);
  for (std::size_t i = 0; i < start.ids.size(); ++i) places_[i] = start.world->robots[i].pose.position;
  playing_ = start.referee->playing;
  holder_.reset();
  last_touch_.reset();
  team_touch_ = {};
  shot_.reset();
}

void StatisticsObserver::Impl::onTick(const MatchTick& tick) {
  if (playing_) {
    ++s_.play_ticks;
    countContacts(tick);
    countMoves(tick);
    countBall(tick);
    watchShot(tick);
  } else {
    ++s_.waiting_ticks;
    for (std::size_t i = 0; i < tick.ids.size(); ++i) places_[i] = tick.world->robots[i].pose.position;
  }
  countCalls(tick.events, *tick.referee);
  playing_ = tick.referee->playing;
}

void StatisticsObserver::Impl::countContacts(const MatchTick& tick) {
  for (const ContactEvent& contact : tick.contacts) {
    if (contact.b.kind == BodyKind::kBall && contact.a.kind == BodyKind::kRobot) {
      const RobotId id = tick.ids[contact.a.index];
      last_touch_ = team_touch_[indexOf(id.team)] = id;
      if (contact.began) ++of(id).touches;
      continue;
    }
    if (!contact.began || contact.b.kind != BodyKind::kRobot) continue;
    const TeamId team = tick.ids[contact.b.index].team;
    if (contact.a.kind == BodyKind::kWall) {
      ++s_.teams[indexOf(team)].wall_contacts;
    } else if (contact.a.kind == BodyKind::kRobot) {
      ++(tick.ids[contact.a.index].team == team ? s_.teams[indexOf(team)].mate_contacts
                                                : s_.opponent_contacts);
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
    robot.distance += distance(place, places_[i]);
    places_[i] = place;
    double& least = nearest[indexOf(tick.ids[i].team)];
    least = std::min(least, squaredNorm(place - ball));
  }
  const double blue = std::sqrt(nearest[0]), yellow = std::sqrt(nearest[1]);
  if (blue + kPossessionLead < yellow) holder_ = TeamId::kBlue;
  if (yellow + kPossessionLead < blue) holder_ = TeamId::kYellow;
  if (holder_) ++s_.teams[indexOf(*holder_)].possession;
}

void StatisticsObserver::Impl::countBall(const MatchTick& tick) {
  const double right = tick.world->balls.front().position.x;
  const double x = tick.referee->blue_side == Side::kLeft ? right : -right;  // in blue's frame
  s_.ball_x_sum += x;
  const std::size_t third = x < -half_length_ / 3 ? 0 : x > half_length_ / 3 ? 2 : 1;
  ++s_.teams[0].thirds[third];
  ++s_.teams[1].thirds[2 - third];
}

std::optional<StatisticsObserver::Impl::Aim> StatisticsObserver::Impl::aimOf(
    const BallState& ball, const RefereeState& referee) const {
  if (!(squaredNorm(ball.velocity) > kShotSpeed * kShotSpeed)) return std::nullopt;
  const double ahead = half_length_ - (ball.velocity.x > 0.0 ? ball.position.x : -ball.position.x);
  const double speed = std::abs(ball.velocity.x);
  if (ahead < 0.0 || ahead > speed * kShotHorizon) return std::nullopt;
  const double y = std::abs(ball.position.y + ball.velocity.y * (ahead / speed));
  if (y > post_ + kShotNearMiss) return std::nullopt;
  const Side goal = ball.velocity.x > 0.0 ? Side::kRight : Side::kLeft;
  const TeamId defender = goal == referee.blue_side ? TeamId::kBlue : TeamId::kYellow;
  return Aim{other(defender), y < post_ - ball_radius_};
}

void StatisticsObserver::Impl::onGoal(Shot& shot) {
  if (shot.on_goal) return;
  shot.on_goal = true;
  ++s_.teams[indexOf(shot.shooter.team)].shots_on_goal;
}

void StatisticsObserver::Impl::watchShot(const MatchTick& tick) {
  const std::optional<Aim> aim = aimOf(tick.world->balls.front(), *tick.referee);
  if (aim && shot_ && shot_->shooter.team == aim->attacker) {
    shot_->last = tick.tick;
  } else if (aim && last_touch_ && last_touch_->team == aim->attacker) {
    shot_ = Shot{*last_touch_, false, tick.tick};
    ++s_.teams[indexOf(aim->attacker)].shots;
    ++of(*last_touch_).shots;
  } else if (shot_ && tick.tick - shot_->last > shot_pause_) {
    shot_.reset();
  }
  if (shot_ && aim && aim->on_goal && aim->attacker == shot_->shooter.team) onGoal(*shot_);
}

void StatisticsObserver::Impl::countCalls(std::span<const GameEvent> events, const RefereeState& referee) {
  for (const GameEvent& event : events) {
    auto count = std::find_if(s_.calls.begin(), s_.calls.end(),
                              [&](const CallCount& c) { return c.clause == event.clause; });
    if (count == s_.calls.end()) count = s_.calls.insert(count, CallCount{event.clause, {}, 0, {}});
    ++(event.team ? count->against[indexOf(*event.team)] : count->neither);
    countPaid(event, referee.match_ticks);
    if (event.clause == "goal" && event.team) goal(event, *event.team, referee);
  }
}

void StatisticsObserver::Impl::countPaid(const GameEvent& event, Tick played) {
  const auto foul = foul_goals_.take(event, played, s_.dt);
  if (!foul) return;
  ++s_.teams[indexOf(*event.team)].goals_after_foul;
  for (CallCount& count : s_.calls) {
    if (count.clause == *foul) ++count.paid[indexOf(*event.team)];
  }
}

void StatisticsObserver::Impl::goal(const GameEvent& event, TeamId team, const RefereeState& referee) {
  GoalRecord goal;
  goal.seconds = static_cast<double>(event.tick) * s_.dt;
  goal.period = event.period;
  goal.play_time = event.play_time;
  goal.team = team;
  goal.score = referee.score;
  const bool shot = shot_ && shot_->shooter.team == goal.team;
  goal.own_goal = last_touch_ && last_touch_->team != goal.team && !(shot && shot_->on_goal);
  if (goal.own_goal) {
    goal.scorer = last_touch_;
    ++s_.teams[indexOf(other(goal.team))].own_goals;
  } else {
    goal.scorer = shot ? std::optional(shot_->shooter) : team_touch_[indexOf(goal.team)];
    if (goal.scorer) ++of(*goal.scorer).goals;
    countGoalAsShot(goal);
  }
  s_.goals.push_back(goal);
  shot_.reset();
}

void StatisticsObserver::Impl::countGoalAsShot(const GoalRecord& goal) {
  if (!shot_ || shot_->shooter.team != goal.team) {
    ++s_.teams[indexOf(goal.team)].shots;
    if (goal.scorer) ++of(*goal.scorer).shots;
    shot_ = Shot{goal.scorer.value_or(RobotId{goal.team, 0}), false, 0};
  }
  onGoal(*shot_);
}

}  // namespace fulbito
