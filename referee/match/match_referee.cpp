#include "referee/match/match_referee.hpp"

#include <algorithm>
#include <cstdlib>

#include "engine/core/math/random.hpp"
#include "referee/match/false_start.hpp"
#include "referee/match/shoot_out.hpp"
#include "referee/restarts/restart_call.hpp"
#include "referee/rules/clauses.hpp"
#include "referee/state/ticks.hpp"

namespace fulbito {
namespace {

/// Purposes of tosses: each has its own index in the stream.
enum Toss : std::uint64_t { kFirstKickOff, kOvertimeKickOff, kFirstKick, kEndlessShootOut, kFalseStart };

int lead(const RefereeState& state) { return std::abs(state.score[0] - state.score[1]); }

std::optional<TeamId> ahead(const PerTeam<int>& score) {
  if (score[0] == score[1]) return std::nullopt;
  return score[0] > score[1] ? TeamId::kBlue : TeamId::kYellow;
}

}  // namespace

MatchReferee::MatchReferee(const RefereeSetup& setup) : setup_(setup) {
  state_.blue_side = setup.blue_side;
  const FirstKickOff first = setup.rules.periods.first_kick_off;
  state_.first_kick_off = first == FirstKickOff::kToss   ? toss(kFirstKickOff)
                          : first == FirstKickOff::kBlue ? TeamId::kBlue
                                                         : TeamId::kYellow;
  // Against an absent team, the present one takes all kick-offs.
  for (const TeamId team : kTeams) {
    if (!setup.present[indexOf(other(team))] && setup.present[indexOf(team)]) state_.first_kick_off = team;
  }
  state_.score = setup.scoreboard.score;
  beginPeriod(setup.scoreboard.period);
  state_.play_ticks = ticksOf(setup.scoreboard.play_seconds, setup.dt);
}

TeamId MatchReferee::toss(std::uint64_t index) const {
  return Rng(setup_.seed, Stream::kCoinToss, index).below(2) == 0 ? TeamId::kBlue : TeamId::kYellow;
}

RestartCall MatchReferee::open() { return kickOff(state_.first_kick_off, nullptr); }

RestartCall MatchReferee::kickOff(TeamId team, const MatchView* view) const {
  if (!setup_.present[indexOf(team)]) team = other(team);
  return makeCall(setup_, state_, {RestartKind::kKickOff, team, {}, view});
}

Tick MatchReferee::delayOf(const RestartCall& call) const {
  // After `max_repeats` false starts, play begins at once. Otherwise a team that never waits could hold up
  // the match.
  const int repeats = state_.false_starts[0] + state_.false_starts[1];
  return repeats < setup_.rules.restart.max_repeats || repeats == 0 ? call.delay : 0;
}

void MatchReferee::restarted(const RestartCall& call, const Placement& placement, Tick tick) {
  state_.last = call;
  state_.placed = placement;
  state_.last_tick = tick;
  const Tick delay = delayOf(call);
  state_.play_began = tick + delay;
  state_.playing = delay == 0;
  state_.announce = call.kind == RestartKind::kKickOff;
  state_.false_start_ticks = 0;
  if (state_.playing) state_.false_starts = {};
  if (state_.period == kShootOutPeriod) {
    state_.play_ticks = 0;
    state_.shoot_out.still_ticks = 0;
    state_.shoot_out.held_ticks = 0;
    state_.shoot_out.entered_area = false;
  }
  memory_ = {};
}

void MatchReferee::beginPeriod(int period) {
  state_.period = period;
  state_.play_ticks = 0;
  state_.period_ticks = periodTicks();
}

Tick MatchReferee::periodTicks() const {
  const bool walk_over = !setup_.present[0] || !setup_.present[1];
  const double seconds =
      walk_over ? setup_.rules.walk_over.seconds : periodSeconds(setup_.rules, state_.period);
  return std::max<Tick>(1, ticksOf(seconds, setup_.dt));
}

double MatchReferee::remaining() const {
  return static_cast<double>(std::max<Tick>(0, state_.period_ticks - state_.play_ticks)) * setup_.dt;
}

GameEvent MatchReferee::eventOf(const MatchView& view, std::string_view clause, std::string_view law) const {
  GameEvent event;
  event.tick = view.tick;
  event.play_time = static_cast<double>(state_.play_ticks) * setup_.dt;
  event.period = static_cast<std::uint8_t>(state_.period);
  event.clause = clause;
  event.law = law;
  event.place = view.ball.position;
  return event;
}

std::optional<RestartCall> MatchReferee::observe(const MatchView& view, Events& events) {
  state_.last_tick = view.tick;
  if (state_.ended) return std::nullopt;
  if (forfeited_) return walkOver(view, events);
  if (!state_.playing) return waitForSignal(view, events);
  ++state_.play_ticks;
  ++state_.match_ticks;
  if (state_.announce) {
    state_.announce = false;
    events.push_back(eventOf(view, "kick-off", "6"));
    events.back().team = state_.last.team;
  }
  if (state_.period == kShootOutPeriod) return kick(view, events);
  const bool nobody = !setup_.present[0] && !setup_.present[1];
  const bool one = setup_.present[0] != setup_.present[1];
  if (nobody || (one && setup_.rules.walk_over.mode == WalkOver::kForfeit)) return walkOver(view, events);
  if (const auto finding = detect(view, setup_, state_, memory_)) return conclude(*finding, view, events);
  if (state_.play_ticks >= state_.period_ticks) return endPeriod(view, events);
  return std::nullopt;
}

std::optional<RestartCall> MatchReferee::waitForSignal(const MatchView& view, Events& events) {
  const RestartRules& rules = setup_.rules.restart;
  if (!rules.hold_robots) {
    const TeamId tie = toss(kFalseStart + static_cast<std::uint64_t>(view.tick));
    if (const auto fault = observeFalseStart(setup_, view, state_, state_.false_start_ticks, tie)) {
      ++state_.false_starts[indexOf(fault->robot.team)];
      GameEvent event = eventOf(view, "false-start", "9");
      event.team = fault->robot.team;
      event.robot = fault->robot.number;
      event.value = fault->moved;
      // A robot that is away counts as away down to the release distance.
      event.threshold =
          event.value > rules.false_start_distance ? rules.false_start_distance : rules.false_start_release;
      event.margin = event.value - event.threshold;
      events.push_back(event);
      const bool kicker = state_.period == kShootOutPeriod && fault->robot.team == state_.last.team;
      // In a shoot-out, law 9 cannot give a restart to the other team: the kick is lost.
      if (kicker && rules.escalation && state_.false_starts[indexOf(state_.last.team)] > rules.warnings) {
        return endKick(false, view, events);
      }
      return punish(setup_, state_, *fault, view);
    }
  }
  if (view.tick >= state_.play_began) {
    state_.playing = true;
    state_.false_starts = {};
  }
  return std::nullopt;
}

std::optional<RestartCall> MatchReferee::conclude(const Finding& finding, const MatchView& view,
                                                  Events& events) {
  events.push_back(finding.event);
  if (finding.event.clause == clause::kGoal) return concludeGoal(finding, view, events);
  // When time is up, the end of the period is the only call.
  if (state_.play_ticks >= state_.period_ticks) return endPeriod(view, events);
  callBack(false);
  return makeCall(setup_, state_,
                  {finding.restart, finding.restart_team, finding.ball, &view,
                   memory_.presence.keeper[indexOf(finding.restart_team)]});
}

std::optional<RestartCall> MatchReferee::concludeGoal(const Finding& finding, const MatchView& view,
                                                      Events& events) {
  const TeamId scorer = finding.event.team.value_or(other(finding.restart_team));
  ++state_.score[indexOf(scorer)];
  const PeriodRules& rules = setup_.rules.periods;
  if (state_.period == kOvertimePeriod && rules.golden_goal) {
    finish(view, events);
    return std::nullopt;
  }
  if (rules.mercy_goals > 0 && lead(state_) >= rules.mercy_goals) {
    GameEvent event = eventOf(view, clause::kMercy, "");
    event.team = scorer;
    event.value = lead(state_);
    event.threshold = rules.mercy_goals;
    events.push_back(event);
    finish(view, events);
    return std::nullopt;
  }
  if (state_.play_ticks >= state_.period_ticks) return endPeriod(view, events);
  callBack(setup_.rules.restart.card_until_goal);
  RestartCall call = kickOff(other(scorer), &view);
  call.delay = ticksOf(setup_.rules.restart.goal_delay, setup_.dt);
  return call;
}

/// Brings back robots that were sent off and may play again; all of them after a goal and between periods.
void MatchReferee::callBack(bool all) {
  for (auto& team : state_.robots) {
    for (RobotRecord& robot : team) {
      if (robot.out && (all || state_.match_ticks >= robot.back_after)) robot.out = false;
    }
  }
}

void MatchReferee::forfeit(TeamId team) {
  setup_.present[indexOf(team)] = false;
  forfeited_ = true;
}

std::optional<RestartCall> MatchReferee::walkOver(const MatchView& view, Events& events) {
  for (const TeamId team : kTeams) {
    if (setup_.present[indexOf(team)]) continue;
    GameEvent event = eventOf(view, "walk-over", "7.3");
    event.team = team;
    event.value = state_.score[indexOf(other(team))];
    events.push_back(event);
  }
  const WalkOverRules& rules = setup_.rules.walk_over;
  const PerTeam<int> reached = state_.score;
  for (const TeamId team : kTeams) {
    if (setup_.present[indexOf(team)]) continue;
    const bool alone = setup_.present[indexOf(other(team))];
    state_.score[indexOf(team)] =
        alone ? rules.absent_score - reached[indexOf(other(team))] : rules.both_absent_score;
  }
  finish(view, events);
  return std::nullopt;
}

std::optional<RestartCall> MatchReferee::endPeriod(const MatchView& view, Events& events) {
  if (!setup_.present[0] || !setup_.present[1]) return walkOver(view, events);
  if (state_.period == 1) {
    events.push_back(eventOf(view, "half", "5"));
    beginPeriod(2);
    if (setup_.rules.periods.swap_sides) state_.blue_side = opposite(state_.blue_side);
    callBack(true);
    const TeamId first = state_.first_kick_off;
    return kickOff(setup_.rules.periods.swap_kick_off ? other(first) : first, &view);
  }
  if (state_.period == kOvertimePeriod && state_.part < setup_.rules.periods.overtime_parts &&
      !(setup_.rules.periods.golden_goal && lead(state_) > 0)) {
    return beginOvertime(state_.part + 1, view, events);
  }
  return afterRegularTime(view, events);
}

std::optional<RestartCall> MatchReferee::afterRegularTime(const MatchView& view, Events& events) {
  const TieBreak tie = setup_.rules.periods.tie_break;
  const bool level = lead(state_) == 0;
  if (level && state_.period == 2 && (tie == TieBreak::kOvertime || tie == TieBreak::kBoth)) {
    return beginOvertime(1, view, events);
  }
  if (level && (tie == TieBreak::kShootOut || tie == TieBreak::kBoth)) return beginShootOut(view, events);
  finish(view, events);
  return std::nullopt;
}

RestartCall MatchReferee::beginOvertime(int part, const MatchView& view, Events& events) {
  GameEvent event = eventOf(view, "overtime", "7.2");
  event.value = part;
  events.push_back(event);
  beginPeriod(kOvertimePeriod);
  state_.part = part;
  if (setup_.rules.periods.swap_sides) state_.blue_side = opposite(state_.blue_side);
  callBack(true);
  const TeamId first = toss(kOvertimeKickOff);
  return kickOff(part % 2 == 1 ? first : other(first), &view);
}

RestartCall MatchReferee::beginShootOut(const MatchView& view, Events& events) {
  events.push_back(eventOf(view, "shoot-out", "7.2"));
  beginPeriod(kShootOutPeriod);
  state_.shoot_out = {};
  state_.shoot_out.first = toss(kFirstKick);
  callBack(true);
  return makeShootOutCall(setup_, state_, state_.shoot_out.first);
}

std::optional<RestartCall> MatchReferee::kick(const MatchView& view, Events& events) {
  const auto end = observeKick(setup_, state_, view, state_.shoot_out);
  if (!end) return std::nullopt;
  return endKick(*end == KickEnd::kGoal, view, events);
}

std::optional<RestartCall> MatchReferee::endKick(bool goal, const MatchView& view, Events& events) {
  const TeamId kicker = state_.last.team;
  ShootOutState& shoot_out = state_.shoot_out;
  state_.false_starts = {};
  ++shoot_out.taken[indexOf(kicker)];
  if (goal) ++shoot_out.goals[indexOf(kicker)];
  GameEvent event = eventOf(view, "shoot-out", "7.2");
  event.team = kicker;
  event.value = goal ? 1.0 : 0.0;
  events.push_back(event);
  const ShootOutRules& rules = setup_.rules.shoot_out;
  const auto winner = leader(rules, shoot_out);
  if (!winner && !exhausted(rules, shoot_out)) {
    return makeShootOutCall(setup_, state_, nextKicker(rules, shoot_out));
  }
  state_.winner = winner ? *winner : toss(kEndlessShootOut);
  finish(view, events);
  return std::nullopt;
}

void MatchReferee::finish(const MatchView& view, Events& events) {
  state_.ended = true;
  state_.playing = false;
  if (!state_.winner) state_.winner = ahead(state_.score);
  GameEvent event = eventOf(view, "full-time", "5");
  event.team = state_.winner;
  event.value = lead(state_);
  events.push_back(event);
}

}  // namespace fulbito
