#include "python/environments/match/environment.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/core/base/float_mode.hpp"
#include "python/environments/match/actions.hpp"
#include "python/environments/match/starts.hpp"
#include "python/environments/match/truth.hpp"
#include "referee/rules/clauses.hpp"
#include "strategies/interface/team_frame.hpp"

namespace fulbito {
namespace {

/// The index of a robot in the world; empty: it is not on the field.
std::optional<std::size_t> indexIn(std::span<const RobotId> ids, RobotId robot) {
  const auto found = std::find(ids.begin(), ids.end(), robot);
  if (found == ids.end()) return std::nullopt;
  return static_cast<std::size_t>(found - ids.begin());
}

int goalsOf(const RefereeState& referee, std::size_t team) {
  return referee.score[team] + referee.shoot_out.goals[team];
}

}  // namespace

void MatchEnvironment::Ear::onTick(const MatchTick& tick) {
  std::copy(tick.commands.begin(), tick.commands.end(), wheels.begin());
  fouls = {};
  for (const GameEvent& event : tick.events) {
    if (event.team && clause::isFoul(event.clause)) ++fouls[indexOf(*event.team)];
  }
}

Result<std::unique_ptr<MatchEnvironment>> MatchEnvironment::create(MatchTask task) {
  if (auto checked = checkTask(task); !checked) return tl::unexpected<Error>(checked.error());
  auto made = std::unique_ptr<MatchEnvironment>(new MatchEnvironment(std::move(task)));
  // A match that is never played shows what is wrong with the rest of the configuration.
  auto config = made->configOf({});
  if (!config) return tl::unexpected<Error>(config.error());
  if (auto match = Match::create(*config); !match) return tl::unexpected<Error>(match.error());
  return made;
}

MatchEnvironment::MatchEnvironment(MatchTask task)
    : task_(std::move(task)), writer_(task_.observations, task_.match) {
  for (const RobotId id : agentsOf(task_))
    agents_.push_back({id, CompatReward(task_.match.field), {}, {}, {}});
  seatAgents();
  shared_.resize(writer_.sharedSize());
  shape_.agents = agents_.size();
  shape_.observation = writer_.size() * static_cast<std::size_t>(task_.stack);
  shape_.bound = writer_.bound();
  shape_.action = numbersOf(task_.actions);
  if (task_.actions == ActionForm::kSkill) shape_.choices = skillNames().size();
  shape_.state = writer_.stateSize();
  shape_.terms = termsOf(task_.reward);
  shape_.figures = {"blue_goals", "yellow_goals", "seconds", "clipped"};
  if (task_.reward == RewardForm::kCompat) {
    shape_.figures = {"goal_score", "move", "ball_grad", "energy", "goals_blue", "goals_yellow", "clipped"};
  }
}

MatchEnvironment::~MatchEnvironment() { (void)leave(); }

// Agents sit in the seat of their team; the team itself decides for the others.
void MatchEnvironment::seatAgents() {
  for (const TeamId team : kTeams) {
    const auto& drives = task_.agents[indexOf(team)];
    if (std::none_of(drives.begin(), drives.end(), [](bool driven) { return driven; })) continue;
    TeamChoice& choice = task_.match.teams[indexOf(team)];
    auto slot = std::make_shared<AgentSlot>();
    slot->drives = drives;
    const auto driven = std::count(drives.begin(), drives.end(), true);
    const bool alone = driven == task_.match.rules.team_size || choice.info == nullptr;
    const std::string name = alone ? "agent" : "agent+" + choice.text;
    choice = agentTeam(name, slot, alone ? std::nullopt : std::optional(choice), task_.navigator);
    slots_[indexOf(team)] = std::move(slot);
  }
}

Result<MatchConfig> MatchEnvironment::configOf(const EpisodeStart& start) const {
  MatchConfig config = task_.match;
  config.seed = start.seed;
  drawModels(task_.ranges, start.seed, config.robot);
  if (!start.text.empty()) {
    auto state = parseStartState(start.text, "start");
    if (!state) return tl::unexpected<Error>(state.error());
    setStart(config, *state);
  } else if (task_.start == StartForm::kRandom) {
    auto placement = randomPlacement(config, start.seed);
    if (!placement) return tl::unexpected<Error>(placement.error());
    config.start = *placement;
  }
  return config;
}

Result<void> MatchEnvironment::leave() {
  if (match_ && match_->phase() != MatchPhase::kEnded) match_->finish();
  Result<void> written;
  if (recorder_) written = recorder_->written();
  match_.reset();
  recorder_.reset();
  return written;
}

Result<void> MatchEnvironment::open(const MatchConfig& config) {
  auto match = Match::create(config);
  if (!match) return tl::unexpected<Error>(match.error());
  match_.emplace(std::move(*match));
  match_->watch(ear_);
  if (record_to_.empty()) return {};
  auto recorder = MatchRecorder::create(std::exchange(record_to_, {}), match_->config());
  if (!recorder) return tl::unexpected<Error>(recorder.error());
  recorder_.emplace(std::move(*recorder));
  match_->watch(*recorder_);
  return {};
}

Result<void> MatchEnvironment::begin(const EpisodeStart& start, const EpisodeView& out) {
  if (auto left = leave(); !left) return left;
  const auto config = configOf(start);
  if (!config) return tl::unexpected<Error>(config.error());
  if (auto opened = open(*config); !opened) return opened;
  for (const auto& slot : slots_) {
    if (slot) slot->commands.fill({});
  }
  for (Agent& agent : agents_) {
    agent.compat.begin();
    agent.skills.begin(slots_[indexOf(agent.id.team)]->info);
  }
  advanceToChoice();
  if (const auto gone = match_->faults().abandoned) return tl::unexpected<Error>(*gone);
  begun_at_ = match_->tick();
  std::fill(out.rewards.begin(), out.rewards.end(), 0.0);
  std::fill(out.terms.begin(), out.terms.end(), 0.0);
  observe(out, true);
  tell(out);
  return {};
}

// Until the teams have seen a tick of play, or the match is over.
void MatchEnvironment::advanceToChoice() {
  while (match_->phase() != MatchPhase::kEnded) {
    const bool held = !match_->referee().playing && task_.match.rules.restart.hold_robots;
    if (match_->phase() == MatchPhase::kDeciding && !held) return;
    match_->advance();
  }
}

void MatchEnvironment::command(std::span<const float> actions) {
  for (std::size_t i = 0; i < agents_.size(); ++i) {
    const auto action = actions.subspan(i * shape_.action, shape_.action);
    const RobotId id = agents_[i].id;
    if (task_.actions == ActionForm::kSkill) {
      agents_[i].skill = static_cast<Skill>(action[0]);
    } else {
      slots_[indexOf(id.team)]->commands[id.number] = commandOf(task_.actions, task_.match, action);
    }
  }
}

// A skill decides anew in each tick.
void MatchEnvironment::playSkills() {
  for (Agent& agent : agents_) {
    AgentSlot& slot = *slots_[indexOf(agent.id.team)];
    slot.commands[agent.id.number] = agent.skills.play(agent.skill, slot.seen, agent.id.number);
  }
}

Result<EpisodeEnd> MatchEnvironment::step(std::span<const float> actions, const EpisodeView& out) {
  std::fill(out.terms.begin(), out.terms.end(), 0.0);
  command(actions);
  bool goal = false;
  for (int i = 0; i < task_.frame_skip && match_->phase() == MatchPhase::kDeciding; ++i) {
    goal = playTick(out.terms) != 0;
    if (goal && task_.ends_at_goal) break;
    advanceToChoice();
  }
  if (match_->phase() == MatchPhase::kEnded) {
    if (const auto gone = match_->faults().abandoned) return tl::unexpected<Error>(*gone);
  }
  if (task_.reward == RewardForm::kCompat) goal = measureCompat(out.terms);
  const std::size_t terms = shape_.terms.size();
  for (std::size_t i = 0; i < agents_.size(); ++i) {
    double sum = 0.0;
    for (const double term : out.terms.subspan(i * terms, terms)) sum += term;
    out.rewards[i] = sum;
  }
  observe(out, false);
  tell(out);
  const EpisodeEnd end = endOf(goal);
  if (end.any() && recorder_) {
    match_->finish();
    if (auto written = recorder_->written(); !written) return tl::unexpected<Error>(written.error());
  }
  return end;
}

EpisodeEnd MatchEnvironment::endOf(bool goal) const {
  EpisodeEnd end;
  end.terminated = match_->phase() == MatchPhase::kEnded || (goal && task_.ends_at_goal);
  const auto played = static_cast<double>(match_->tick() - begun_at_);
  const double limit = std::round(task_.seconds * task_.match.physics.control_rate);
  end.truncated = !end.terminated && limit > 0.0 && played >= limit;
  return end;
}

/// Plays one tick and adds its terms.
/// @return the number of goals
int MatchEnvironment::playTick(std::span<double> terms) {
  if (task_.actions == ActionForm::kSkill) playSkills();
  before_.robots = match_->world().robots;
  before_.balls = match_->world().balls;
  const RefereeState& referee = match_->referee();
  const PerTeam<int> score{goalsOf(referee, 0), goalsOf(referee, 1)};
  const Side blue_side = referee.blue_side;
  match_->advance();
  const PerTeam<int> goals{goalsOf(referee, 0) - score[0], goalsOf(referee, 1) - score[1]};
  if (task_.reward == RewardForm::kShaped) measure(goals, blue_side, terms);
  return goals[0] + goals[1];
}

void MatchEnvironment::measure(PerTeam<int> goals, Side blue_side, std::span<double> terms) {
  const WorldState& after = match_->world();
  const Vec2 ball_before = before_.balls.front().position, ball_after = after.balls.front().position;
  const FieldGeometry& field = task_.match.field;
  const double gained = ballPotential(field, ball_after) - ballPotential(field, ball_before);
  RewardTick tick;
  tick.dt = task_.match.physics.controlPeriod();
  const std::size_t count = shape_.terms.size();
  for (std::size_t i = 0; i < agents_.size(); ++i) {
    const RobotId id = agents_[i].id;
    const std::size_t team = indexOf(id.team);
    const bool left = (id.team == TeamId::kBlue ? blue_side : opposite(blue_side)) == Side::kLeft;
    tick.gained = left ? gained : -gained;
    tick.nearer = 0.0;
    tick.wheels = {};
    if (const auto robot = indexIn(match_->ids(), id)) {
      tick.nearer = distance(before_.robots[*robot].pose.position, ball_before) -
                    distance(after.robots[*robot].pose.position, ball_after);
      tick.wheels = ear_.wheels[*robot];
    }
    tick.goals = goals[team] - goals[1 - team];
    tick.fouls = ear_.fouls[team];
    addShaped(tick, task_.weights, task_.match.robot.robot.max_wheel_speed, terms.subspan(i * count, count));
  }
}

bool MatchEnvironment::measureCompat(std::span<double> terms) {
  bool goal = false;
  const std::size_t count = shape_.terms.size();
  for (std::size_t i = 0; i < agents_.size(); ++i) {
    const RobotId id = agents_[i].id;
    const Side side = match_->referee().sideOf(id.team);
    CompatMoment now;
    now.ball = inTeamFrame(side, match_->world().balls.front());
    now.step = task_.frame_skip * task_.match.physics.controlPeriod();
    if (const auto robot = indexIn(match_->ids(), id)) {
      now.robot = inTeamFrame(side, match_->world().robots[*robot]);
      now.wheels = ear_.wheels[*robot];
    }
    goal = agents_[i].compat.step(now, terms.subspan(i * count, count));
  }
  return goal;
}

void MatchEnvironment::observe(const EpisodeView& out, bool first) {
  clipped_ = 0;
  for (const TeamId team : kTeams) {
    if (!slots_[indexOf(team)]) continue;
    AgentSlot& slot = *slots_[indexOf(team)];
    // After the last tick no team sees the end of it.
    if (match_->phase() != MatchPhase::kDeciding) slot.seen = truthFor(*match_, team);
    writer_.share(slot.seen, shared_);
    for (std::size_t i = 0; i < agents_.size(); ++i) {
      if (agents_[i].id.team != team) continue;
      const std::span<float> all = out.observations.subspan(i * shape_.observation, shape_.observation);
      clipped_ += writer_.write(slot.seen, shared_, agents_[i].id.number, all.first(writer_.size()));
      if (task_.stack > 1) pile(agents_[i].seen, all, first);
    }
  }
}

// Puts the newest observation, which stands in front of `all`, before the earlier ones.
void MatchEnvironment::pile(std::vector<float>& seen, std::span<float> all, bool first) const {
  const auto size = static_cast<std::ptrdiff_t>(writer_.size());
  if (first) {
    for (auto at = all.begin() + size; at != all.end(); at += size) std::copy_n(all.begin(), size, at);
  } else {
    std::copy(seen.begin(), seen.end() - size, all.begin() + size);
  }
  seen.assign(all.begin(), all.end());
}

void MatchEnvironment::tell(const EpisodeView& out) const {
  if (task_.reward == RewardForm::kCompat) {
    const auto& sums = agents_.front().compat.sums();
    std::copy(sums.begin(), sums.end(), out.figures.begin());
  } else {
    const RefereeState& referee = match_->referee();
    out.figures[0] = referee.score[0];
    out.figures[1] = referee.score[1];
    out.figures[2] = match_->seconds();
  }
  out.figures.back() = clipped_;
}

void MatchEnvironment::state(std::span<float> out) const {
  writer_.writeState(truthFor(*match_, TeamId::kBlue), out);
}

Result<void> MatchEnvironment::record(const std::string& file) {
  record_to_ = file;
  return {};
}

Result<Canvas> MatchEnvironment::picture(int width) {
  if (!match_) return fail(ErrorCode::kUsage, "there is no picture before the first reset");
  if (!painter_ || painter_->width() != width) {
    auto painter = MatchPainter::create(match_->config(), width);
    if (!painter) return tl::unexpected<Error>(painter.error());
    painter_.emplace(std::move(*painter));
  }
  return painter_->draw(*match_);
}

}  // namespace fulbito
