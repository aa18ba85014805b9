#include <algorithm>
#include <cmath>

#include "fulbito/match.hpp"
#include "fulbito/statistics.hpp"
#include "match/drills/trials.hpp"
#include "referee/rules/clauses.hpp"
#include "strategies/interface/team_frame.hpp"

namespace fulbito {
namespace {

constexpr double kEarly = 5.0;        // [s] goals conceded this soon after a restart are early
constexpr double kFlap = 0.3;         // [s] between two changes of one role
constexpr double kFullMatch = 600.0;  // [s] play time to which measures per match are scaled

/// Counts, for the tested team, the measures of whole matches.
class MatchTally final : public MatchObserver {
 public:
  explicit MatchTally(TeamId team) : team_(team) { tally_.as_blue = team == TeamId::kBlue; }

  void onPlayStart(const PlayStart& start) override {
    dt_ = start.world->physics.controlPeriod();
    began_ = start.tick + start.call.delay;
    event_ = start.tick;
    ++tally_.restarts;
    for (const GameEvent& event : start.events) {
      if (event.clause == "placement" && event.team == team_) ++tally_.illegal;
    }
  }

  void onTick(const MatchTick& tick) override {
    side_ = tick.referee->sideOf(team_);
    tally_.seconds = static_cast<double>(tick.referee->match_ticks) * dt_;
    bool touched = false;
    for (const ContactEvent& contact : tick.contacts) {
      if (contact.b.kind != BodyKind::kBall || contact.a.kind != BodyKind::kRobot) continue;
      touched = true;
    }
    if (touched != touched_) event_ = tick.tick;
    touched_ = touched;
    for (const GameEvent& event : tick.events) count(event, tick.tick);
    if (tick.referee->playing) followRoles(*tick.decisions[indexOf(team_)], tick.tick);
  }

  /// Own goals are those of the match's statistics: a deflected shot of an opponent is none.
  DrillMatch tally(const RefereeState& end, const MatchStatistics& statistics) const {
    DrillMatch match = tally_;
    match.own_goals = statistics.teams[indexOf(team_)].own_goals;
    match.goals = end.score[indexOf(team_)];
    match.conceded = end.score[indexOf(other(team_))];
    return match;
  }

 private:
  void count(const GameEvent& event, Tick now) {
    if (event.clause == clause::kGoal) {
      if (event.team == team_) return;
      tally_.early_goals += static_cast<double>(now - began_) * dt_ <= kEarly ? 1 : 0;
      return;
    }
    // The clause of a stuck ball in an area names no team, so the place tells whose area it is.
    const bool own_area = inTeamFrame(side_, event.place).x < 0.0;
    if (event.clause == clause::kGoalKickStuck && own_area) ++tally_.own_stalls;
    if (event.team != team_) return;
    if (event.clause == clause::kAttackers || event.clause == clause::kDefenders) ++tally_.area_fouls;
    if (event.clause == clause::kPenaltyStuck || event.clause == clause::kPenaltyHolding ||
        event.clause == clause::kKeeperHolds || event.clause == clause::kFreeKickHolding) {
      ++tally_.own_stalls;
    }
  }

  /// Counts a switch when a role goes from one robot to another.
  void followRoles(const TeamCommand& command, Tick now) {
    const auto& roles = command.roles;
    if (std::any_of(roles.begin(), roles.end(), [](auto role) { return role != 0; }))
      tally_.roles_told = true;
    if (roles == roles_) return;
    if (tally_.roles_told && known_) {
      ++tally_.switches;
      const bool soon = static_cast<double>(now - switched_) * dt_ < kFlap;
      tally_.flaps += soon && event_ <= switched_ ? 1 : 0;
      switched_ = now;
    }
    roles_ = roles;
    known_ = true;
  }

  TeamId team_;
  DrillMatch tally_;
  Side side_ = Side::kLeft;
  double dt_ = 1.0 / 60.0;
  Tick began_ = 0;  ///< tick of the signal
  Tick event_ = 0;  ///< when robots last came to the ball or lost it, or play began
  Tick switched_ = -1000;
  bool touched_ = false;  ///< a robot touched the ball in the last tick
  bool known_ = false;
  std::array<std::uint8_t, kMaxTeamSize> roles_{};
};

double perMatch(const DrillMatch& m, int count) {
  return m.seconds > 0.0 ? count * kFullMatch / m.seconds : 0.0;
}

double valueOf(const DrillMatch& m, DrillMeasure measure) {
  switch (measure) {
    case DrillMeasure::kOwnGoal:
      return perMatch(m, m.own_goals);
    case DrillMeasure::kAreaFoul:
      return perMatch(m, m.area_fouls);
    case DrillMeasure::kOwnStall:
      return perMatch(m, m.own_stalls);
    case DrillMeasure::kSwitch:
      return m.seconds > 0.0 ? m.switches / m.seconds : 0.0;
    case DrillMeasure::kFlap:
      return m.flaps;
    case DrillMeasure::kWin:
      return m.goals > m.conceded ? 1.0 : 0.0;
    case DrillMeasure::kIllegal:
      return m.illegal;
    default:
      return perMatch(m, m.goals - m.conceded);
  }
}

/// Mean with its 95 % interval by the normal approximation.
Interval normalInterval(const std::vector<double>& values) {
  const double average = mean(values);
  double squares = 0.0;
  for (const double v : values) squares += (v - average) * (v - average);
  const auto n = static_cast<double>(values.size());
  const double half = n > 1.0 ? 1.96 * std::sqrt(squares / (n - 1.0) / n) : 0.0;
  return {average, average - half, average + half};
}

/// Difference between the mean margins as blue and as yellow, in its standard deviations.
double bias(const std::vector<DrillMatch>& matches) {
  std::vector<double> sides[2];
  for (const DrillMatch& m : matches) sides[m.as_blue ? 0 : 1].push_back(valueOf(m, DrillMeasure::kMargin));
  const Interval blue = normalInterval(sides[0]);
  const Interval yellow = normalInterval(sides[1]);
  const double half_blue = blue.high - blue.value;
  const double half_yellow = yellow.high - yellow.value;
  const double sigma = std::sqrt(half_blue * half_blue + half_yellow * half_yellow) / 1.96;
  return sigma > 0.0 ? std::abs(blue.value - yellow.value) / sigma : 0.0;
}

Interval measured(const DrillBar& bar, const std::vector<DrillMatch>& matches) {
  const auto sum = [&](int DrillMatch::* part) {
    int total = 0;
    for (const DrillMatch& m : matches) total += m.*part;
    return total;
  };
  if (bar.value == DrillMeasure::kEarlyGoal) {
    return wilson(sum(&DrillMatch::early_goals), sum(&DrillMatch::restarts));
  }
  if (bar.value == DrillMeasure::kBias) {
    const double sigmas = bias(matches);
    return {sigmas, sigmas, sigmas};
  }
  std::vector<double> values;
  values.reserve(matches.size());
  for (const DrillMatch& m : matches) values.push_back(valueOf(m, bar.value));
  if (bar.statistic == DrillStatistic::kRate) {
    const auto hits = std::count_if(values.begin(), values.end(), [](double v) { return v > 0.5; });
    return wilson(static_cast<int>(hits), static_cast<int>(values.size()));
  }
  if (bar.statistic == DrillStatistic::kCount) {
    double total = 0.0;
    for (const double v : values) total += v;
    return {total, total, total};
  }
  return normalInterval(values);
}

}  // namespace

Result<DrillMatch> playDrillMatch(const DrillRun& run, const Drill& drill, const MatchConfig& base,
                                  int index) {
  const TeamId seat = index % 2 == 0 ? TeamId::kBlue : TeamId::kYellow;
  MatchConfig config = base;
  config.seed = run.options.seed + static_cast<std::uint64_t>(index / 2);
  config.teams[indexOf(seat)] = run.options.team;
  config.teams[indexOf(other(seat))] = run.options.itself.value_or(run.options.team);
  if (drill.match_opponent != "itself") {
    auto opponent = run.options.catalogue.parse(drill.match_opponent);
    if (!opponent) return tl::unexpected<Error>(opponent.error());
    config.teams[indexOf(other(seat))] = std::move(*opponent);
  }
  auto match = Match::create(config);
  if (!match) return tl::unexpected<Error>(match.error());
  MatchTally tally(seat);
  StatisticsObserver statistics;
  match->watch(tally);
  match->watch(statistics);
  while (match->step()) {
  }
  if (const auto abandoned = match->faults().abandoned) return tl::unexpected<Error>(*abandoned);
  return tally.tally(match->referee(), statistics.statistics());
}

double marginOf(const DrillMatch& match) { return valueOf(match, DrillMeasure::kMargin); }

std::vector<DrillVerdict> judgeMatches(const Drill& drill, const std::vector<DrillMatch>& matches) {
  std::vector<DrillVerdict> verdicts;
  for (const DrillBar& bar : drill.bars) {
    DrillVerdict verdict;
    verdict.bar = bar;
    verdict.count = static_cast<int>(matches.size());
    verdict.value = measured(bar, matches);
    judge(verdict);
    verdicts.push_back(std::move(verdict));
  }
  return verdicts;
}

}  // namespace fulbito
