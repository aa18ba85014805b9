#include "replays/verify/shadow_referee.hpp"

#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "fulbito/models.hpp"
#include "referee/match/match_referee.hpp"
#include "replays/verify/resimulate.hpp"

namespace fulbito {
namespace {

/// A referee that judges one play. After its first call it makes no more.
class Shadow {
 public:
  explicit Shadow(RefereeSetup setup) : setup_(std::move(setup)) {}

  void begin(const RecordedPlay& play, const Placement& placement, double dt) {
    setup_.scoreboard.score = play.score;
    setup_.scoreboard.period = play.period;
    setup_.scoreboard.play_seconds = static_cast<double>(play.play_ticks) * dt;
    setup_.blue_side = play.blue_side;
    referee_.emplace(setup_);
    verdict_.reset();
    RestartCall call;
    call.kind = play.kind;
    call.team = play.team;
    call.ball = play.ball;
    call.delay = play.delay;
    call.defenders_back = play.defenders_back;
    call.defaults = placement;
    referee_->restarted(call, placement, play.tick);
  }

  void observe(const MatchView& view) {
    if (verdict_) return;
    events_.clear();
    const auto call = referee_->observe(view, events_);
    if (!call && !referee_->state().ended) return;
    verdict_.emplace();
    verdict_->tick = view.tick;
    if (call) {
      verdict_->restart = call->kind;
      verdict_->restart_team = call->team;
    }
    for (const GameEvent& event : events_) {
      if (event.clause == "kick-off") continue;  // not a call: announced at the first tick of a play
      verdict_->clause = event.clause;
      verdict_->team = event.team;
      verdict_->value = event.value;
      verdict_->threshold = event.threshold;
      break;
    }
  }

  const std::optional<ShadowVerdict>& verdict() const { return verdict_; }

 private:
  RefereeSetup setup_;
  std::optional<MatchReferee> referee_;
  std::optional<ShadowVerdict> verdict_;
  std::vector<GameEvent> events_;
};

bool sameCall(const ShadowVerdict& a, const ShadowVerdict& b) {
  return a.clause == b.clause && a.team == b.team && a.restart == b.restart &&
         a.restart_team == b.restart_team;
}

VerdictAgreement agreementOf(const PlayVerdicts& play) {
  if (!play.a && !play.b) return VerdictAgreement::kNone;
  if (!play.b) return VerdictAgreement::kOnlyA;
  if (!play.a) return VerdictAgreement::kOnlyB;
  if (!sameCall(*play.a, *play.b)) return VerdictAgreement::kDifferent;
  if (play.a->tick == play.b->tick) return VerdictAgreement::kSame;
  return play.a->tick < play.b->tick ? VerdictAgreement::kAEarlier : VerdictAgreement::kBEarlier;
}

/// Shows the plays of one recording to both referees.
class Comparer final : public ReplayVisitor {
 public:
  Comparer(const RefereeSetup& a, const RefereeSetup& b, RulesComparison& to)
      : a_(a), b_(b), dt_(a.dt), to_(to) {}

  void chunkBegins(const RecordedChunk& chunk) override {
    calls_.clear();
    for (const RecordedEvent& event : chunk.events) {
      if (event.clause != "kick-off" && event.clause != "placement")
        calls_[event.tick].push_back(event.clause);
    }
  }

  bool playBegins(const ReplayedPlay& play) override {
    end();
    if (play.world->state().balls.empty()) {
      flaw_ = fmt::format("there is no ball in play {}", play.number + 1);
      return false;
    }
    judging_ = play.recorded->period < kShootOutPeriod;
    if (!judging_) return true;
    current_ = {};
    current_.file = to_.files;
    current_.play = play.number;
    current_.begin = current_.end = play.recorded->tick;
    const Placement placement = placementOf(play);
    a_.begin(*play.recorded, placement, dt_);
    b_.begin(*play.recorded, placement, dt_);
    return true;
  }

  bool ticked(const ReplayedTick& tick) override {
    ++to_.ticks;
    if (!judging_) return true;
    current_.end = tick.tick;
    const WorldState& world = tick.world->state();
    const MatchView view{tick.tick, tick.ids, world.robots, world.balls.front(), tick.world->contacts()};
    a_.observe(view);
    b_.observe(view);
    // Keeps the recorded calls of the latest tick that has any.
    if (const auto calls = calls_.find(tick.tick); calls != calls_.end()) {
      called_tick_ = tick.tick;
      called_ = calls->second;
    }
    return true;
  }

  /// The reason why the comparison stopped; empty if it did not.
  const std::string& flaw() const { return flaw_; }

  void end() {
    if (!judging_ || current_.end == current_.begin) return;
    current_.a = a_.verdict();
    current_.b = b_.verdict();
    current_.agreement = agreementOf(current_);
    if (current_.a && current_.b) {
      current_.lead = static_cast<double>(std::abs(current_.a->tick - current_.b->tick)) * dt_;
    }
    to_.recorded_a += endsAsRecorded(current_.a) ? 1 : 0;
    to_.recorded_b += endsAsRecorded(current_.b) ? 1 : 0;
    to_.plays.push_back(current_);
    judging_ = false;
  }

 private:
  static Placement placementOf(const ReplayedPlay& play) {
    const WorldState& world = play.world->state();
    Placement placement;
    placement.ball = world.balls.front().position;
    placement.ball_velocity = world.balls.front().velocity;
    for (std::size_t i = 0; i < play.ids.size(); ++i) {
      placement.robots[indexOf(play.ids[i].team)][play.ids[i].number] = world.robots[i].pose;
    }
    return placement;
  }

  bool endsAsRecorded(const std::optional<ShadowVerdict>& verdict) const {
    return verdict && verdict->tick == current_.end && called_tick_ == current_.end &&
           std::find(called_.begin(), called_.end(), verdict->clause) != called_.end();
  }

  Shadow a_, b_;
  const double dt_;
  RulesComparison& to_;
  PlayVerdicts current_;
  std::map<Tick, std::vector<std::string>> calls_;  ///< by tick, of the present chunk
  std::vector<std::string> called_;
  std::string flaw_;
  Tick called_tick_ = -1;
  bool judging_ = false;
};

Result<RefereeSetup> setupOf(const RecordingRecipe& recipe, const Rules& own, int control_rate) {
  const auto recorded = parseRules(recipe.rules, "recorded rules");
  if (!recorded) return tl::unexpected<Error>(recorded.error());
  const auto field = parseField(recipe.field, "recorded field");
  if (!field) return tl::unexpected<Error>(field.error());
  const auto robot = parseRobot(recipe.robot, "recorded robot");
  if (!robot) return tl::unexpected<Error>(robot.error());
  RefereeSetup setup;
  setup.rules = own;
  setup.rules.team_size = recorded->team_size;
  setup.rules.half_seconds = recorded->half_seconds;
  setup.field = *field;
  setup.robot = robot->robot;
  setup.ball = robot->ball;
  setup.dt = 1.0 / control_rate;
  setup.seed = recipe.seed;
  return setup;
}

/// Name of a call in the list of differences. It includes the restart if both calls are of the same rule.
std::string callName(const ShadowVerdict& verdict, bool with_restart) {
  if (!with_restart) return verdict.clause;
  return verdict.clause + " (" + nameOf(verdict.restart) + ", " + nameOf(verdict.restart_team) + ")";
}

void count(RuleAgreement& rule, const PlayVerdicts& play) {
  switch (play.agreement) {
    case VerdictAgreement::kNone:
      break;
    case VerdictAgreement::kSame:
      ++rule.same;
      break;
    case VerdictAgreement::kAEarlier:
      ++rule.a_earlier;
      rule.a_lead += play.lead;
      break;
    case VerdictAgreement::kBEarlier:
      ++rule.b_earlier;
      rule.b_lead += play.lead;
      break;
    case VerdictAgreement::kOnlyA:
      ++rule.only_a;
      break;
    case VerdictAgreement::kOnlyB:
      ++rule.only_b;
      break;
    case VerdictAgreement::kDifferent:
      ++rule.different;
      break;
  }
}

}  // namespace

Result<void> compareRules(const RecordingReader& recording, const Rules& a, const Rules& b,
                          RulesComparison& comparison) {
  const RecordingHeader& header = recording.header();
  if (header.kind != RecordingKind::kMatch || countOf(header, BodyKind::kBall) != 1) {
    return fail(ErrorCode::kBadInput, "the recording is not a match");
  }
  if (header.heard) {
    return fail(ErrorCode::kBadInput, "the motion is another program's, and no referee can judge it again");
  }
  const auto setup_a = setupOf(header.recipe, a, header.control_rate);
  if (!setup_a) return fail(ErrorCode::kBadInput, setup_a.error().message);
  const auto setup_b = setupOf(header.recipe, b, header.control_rate);
  if (!setup_b) return fail(ErrorCode::kBadInput, setup_b.error().message);
  comparison.a = a.name;
  comparison.b = b.name;
  const Tick before = comparison.ticks;
  Comparer comparer(*setup_a, *setup_b, comparison);
  if (auto played = resimulate(recording, comparer); !played) return played;
  if (!comparer.flaw().empty()) return fail(ErrorCode::kBadInput, comparer.flaw());
  comparer.end();
  comparison.seconds += static_cast<double>(comparison.ticks - before) / header.control_rate;
  ++comparison.files;
  return {};
}

std::vector<RuleAgreement> byRule(const RulesComparison& comparison) {
  std::map<std::string, RuleAgreement> rules;
  for (const PlayVerdicts& play : comparison.plays) {
    if (play.a) ++rules[play.a->clause].a;
    if (play.b) ++rules[play.b->clause].b;
    if (play.a) count(rules[play.a->clause], play);
    // If both profiles call the same rule, the play counts once.
    if (play.b && (!play.a || play.a->clause != play.b->clause)) count(rules[play.b->clause], play);
  }
  std::vector<RuleAgreement> list;
  for (auto& [clause, rule] : rules) {
    rule.clause = clause;
    if (rule.a_earlier > 0) rule.a_lead /= static_cast<double>(rule.a_earlier);
    if (rule.b_earlier > 0) rule.b_lead /= static_cast<double>(rule.b_earlier);
    list.push_back(rule);
  }
  return list;
}

std::vector<VerdictPair> differentPairs(const RulesComparison& comparison) {
  std::map<std::pair<std::string, std::string>, std::int64_t> counts;
  for (const PlayVerdicts& play : comparison.plays) {
    if (play.agreement != VerdictAgreement::kDifferent) continue;
    const bool same_rule = play.a->clause == play.b->clause;
    ++counts[{callName(*play.a, same_rule), callName(*play.b, same_rule)}];
  }
  std::vector<VerdictPair> pairs;
  pairs.reserve(counts.size());
  for (const auto& [names, number] : counts) pairs.push_back({names.first, names.second, number});
  std::stable_sort(pairs.begin(), pairs.end(),
                   [](const VerdictPair& x, const VerdictPair& y) { return x.count > y.count; });
  return pairs;
}

std::int64_t countOf(const RulesComparison& comparison, VerdictAgreement agreement) {
  return std::count_if(comparison.plays.begin(), comparison.plays.end(),
                       [agreement](const PlayVerdicts& play) { return play.agreement == agreement; });
}

}  // namespace fulbito
