#include "tests/second_referee/second_referee.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "tests/second_referee/laws.hpp"

namespace fulbito::second {
namespace {

/// Clauses that this referee knows; all else is none of its business (placements, policy).
bool known(std::string_view clause) {
  constexpr std::array<std::string_view, 15> kKnown = {"kick-off",
                                                       "half",
                                                       "full-time",
                                                       "goal",
                                                       "free-ball",
                                                       "goal-kick.attackers",
                                                       "goal-kick.keeper-charged",
                                                       "goal-kick.stuck",
                                                       "penalty.defenders",
                                                       "penalty.keeper-holds",
                                                       "penalty.holding",
                                                       "penalty.stuck",
                                                       "free-kick.push",
                                                       "free-kick.holding",
                                                       "shoot-out"};
  return std::find(kKnown.begin(), kKnown.end(), clause) != kKnown.end();
}

std::string describe(const Call& call) {
  std::string text = fmt::format("tick {}: {}", call.tick, call.clause);
  if (call.team) text += fmt::format(" {}", nameOf(*call.team));
  if (call.robot) text += fmt::format(" robot {}", *call.robot);
  return text;
}

Call callOf(const GameEvent& event) {
  Call call;
  call.tick = event.tick;
  call.clause = event.clause;
  call.team = event.team;
  if (event.robot) call.robot = *event.robot;
  call.value = event.value;
  return call;
}

/// Whether `b` is what `a` says; a value that `a` lacks may be any.
bool same(const Call& a, const Call& b) {
  return a.tick == b.tick && a.clause == b.clause && a.team == b.team && a.robot == b.robot &&
         (!a.value || a.value == b.value);
}

/// The first in this order stops play: docs/rules.md, "What stops play".
std::optional<Call> firstCall(const Play& play) {
  for (const auto law : {goal, areaFoul, keeperCharged, keeperHolds, pinnedToWall, pushedAway, stuckBall}) {
    if (auto call = law(play)) return call;
  }
  return std::nullopt;
}

}  // namespace

std::string SecondReferee::unfit(const MatchConfig& config) {
  if (!config.present[0] || !config.present[1]) return "a team is absent";
  const TieBreak tie = config.rules.periods.tie_break;
  if (tie != TieBreak::kNone && tie != TieBreak::kShootOut) return "there may be overtime";
  if (config.rules.shoot_out.order != ShootOutOrder::kAlternating) return "kicks may be in series";
  if (config.rules.periods.mercy_goals > 0) return "mercy may end the match";
  if (!config.rules.restart.hold_robots) return "there may be false starts";
  return "";
}

void SecondReferee::onMatchStart(const MatchConfig& config) {
  config_ = config;
  play_.match = &config_;
  play_.dt = config.physics.controlPeriod();
  if (const std::string why = unfit(config); !why.empty()) disagreements_.push_back("cannot judge: " + why);
}

void SecondReferee::onPlayStart(const PlayStart& start) {
  if (start.tick == 0) first_kick_off_ = start.call.team;
  if (restart_ && (restart_->restart != start.call.kind ||
                   restart_->restart_team.value_or(start.call.team) != start.call.team)) {
    disagreements_.push_back(fmt::format("{}: play goes on with {} for {}, not {} for {}",
                                         describe(*restart_), nameOf(start.call.kind),
                                         nameOf(start.call.team), nameOf(restart_->restart),
                                         nameOf(restart_->restart_team.value_or(start.call.team))));
  }
  if (start.tick > 0 && !restart_ && !start.edited) {
    disagreements_.push_back(fmt::format("tick {}: a restart that nothing was called for", start.tick));
  }
  restart_.reset();
  play_.moments.clear();
  play_.begun_by = start.call.team;
  play_.mark = start.call.ball;
  play_.signal = start.tick + start.call.delay;
  announce_ = start.call.kind == RestartKind::kKickOff;
}

/// The state of the tick, and what follows from those before.
void SecondReferee::see(const MatchTick& tick) {
  Moment now;
  now.tick = tick.tick;
  for (std::size_t i = 0; i < tick.ids.size(); ++i) {
    const RobotState& robot = tick.world->robots[i];
    now.players.push_back({tick.ids[i], robot.pose, robot.velocity, {}, {}, {}});
  }
  now.contacts.assign(tick.contacts.begin(), tick.contacts.end());
  now.ball = tick.world->balls.front().position;
  now.ball_velocity = tick.world->balls.front().velocity;
  play_.moments.push_back(std::move(now));
  noteAreas(play_);
  noteCrowds(play_);
  noteStandstill(play_);
}

std::vector<Call> SecondReferee::judge() {
  const Tick now = play_.now().tick;
  std::vector<Call> calls;
  ++played_;
  if (announce_) calls.push_back({now, "kick-off", play_.begun_by, {}, {}, {}, {}});
  announce_ = false;
  if (auto call = firstCall(play_)) {
    calls.push_back(*call);
    restart_ = *call;
    if (call->clause == "goal") ++score_[indexOf(*call->team)];
  }
  if (played_ < play_.ticks(config_.rules.half_seconds)) return calls;
  // Time is up: whatever was called, its restart is not taken.
  played_ = 0;
  calls.push_back(period_ == 2 ? afterFullTime() : half());
  return calls;
}

Call SecondReferee::half() {
  period_ = 2;
  const PeriodRules& rules = config_.rules.periods;
  if (rules.swap_sides) play_.blue_left = !play_.blue_left;
  const TeamId first = rules.swap_kick_off ? other(first_kick_off_) : first_kick_off_;
  restart_ = Call{play_.now().tick, "half", {}, {}, RestartKind::kKickOff, first, {}};
  return *restart_;
}

Call SecondReferee::afterFullTime() {
  if (score_[0] != score_[1] || config_.rules.periods.tie_break == TieBreak::kNone) return fullTime(score_);
  // The toss says who begins.
  shoot_out_ = true;
  restart_ = Call{play_.now().tick, "shoot-out", {}, {}, RestartKind::kPenalty, {}, {}};
  return *restart_;
}

Call SecondReferee::fullTime(const PerTeam<int>& score) {
  restart_.reset();
  Call call{play_.now().tick, "full-time", {}, {}, {}, {}, {}};
  if (score[0] != score[1]) call.team = score[0] > score[1] ? TeamId::kBlue : TeamId::kYellow;
  return call;
}

/// Law 7.2: as many kicks each as the rules say, then in pairs; who cannot be caught has won.
std::vector<Call> SecondReferee::judgeKick() {
  const auto goal = kickOver(play_);
  if (!goal) return {};
  const ShootOutRules& rules = config_.rules.shoot_out;
  const TeamId kicker = play_.begun_by, rival = other(kicker);
  ++kicks_[indexOf(kicker)];
  hits_[indexOf(kicker)] += *goal ? 1 : 0;
  std::vector<Call> calls = {
      {play_.now().tick, "shoot-out", kicker, {}, RestartKind::kPenalty, {}, *goal ? 1.0 : 0.0}};
  const auto left = [&](TeamId team) {
    return std::max(0, std::max(rules.kicks, kicks_[indexOf(other(team))]) - kicks_[indexOf(team)]);
  };
  const bool decided = hits_[indexOf(kicker)] > hits_[indexOf(rival)] + left(rival) ||
                       hits_[indexOf(rival)] > hits_[indexOf(kicker)] + left(kicker);
  tossed_ = !decided && kicks_[0] >= rules.max_kicks && kicks_[1] >= rules.max_kicks;
  if (decided || tossed_) {
    calls.push_back(fullTime(hits_));
    return calls;
  }
  calls.back().restart_team = rival;  // in turn
  restart_ = calls.back();
  return calls;
}

void SecondReferee::compare(const std::vector<Call>& calls, std::span<const GameEvent> events) {
  std::vector<Call> theirs;
  for (const GameEvent& event : events) {
    if (!known(event.clause)) continue;
    theirs.push_back(callOf(event));
    if (event.clause == "full-time" && tossed_) theirs.back().team.reset();
  }
  for (const Call& call : calls) {
    const auto match =
        std::find_if(theirs.begin(), theirs.end(), [&](const Call& t) { return same(call, t); });
    if (match != theirs.end()) {
      ++tallies_[call.clause].both;
      theirs.erase(match);
    } else {
      ++tallies_[call.clause].second_alone;
      disagreements_.push_back("missing: " + describe(call));
    }
  }
  for (const Call& call : theirs) {
    ++tallies_[call.clause].match_alone;
    disagreements_.push_back("not found by the laws: " + describe(call));
  }
}

void SecondReferee::onTick(const MatchTick& tick) {
  std::vector<Call> calls;
  if (tick.tick > play_.signal) {
    see(tick);
    calls = shoot_out_ ? judgeKick() : judge();
  }
  compare(calls, tick.events);
}

int SecondReferee::calls() const {
  int calls = 0;
  for (const auto& [clause, tally] : tallies_) calls += tally.both;
  return calls;
}

}  // namespace fulbito::second
