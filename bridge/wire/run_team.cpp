#include "bridge/wire/run_team.hpp"

#include <utility>

#include "bridge/outside/outside_team.hpp"

namespace fulbito::wire {
namespace {

constexpr int kFarewell = 10;  // looks at a client that may end by itself after the match

}  // namespace

void RunTeam::begin(const MatchInfo& info) {
  info_ = info;
  condition_ = {};
  condition_.stands = true;  // both as of `WireTeam`
  condition_.seconds = 0.0;
  start(true);
}

void RunTeam::start(bool first) {
  auto started = startClient(setup_);
  if (!started) return fail(started.error().message, started.error().code);
  team_.reset();
  program_ = std::move(started->program);
  server_ = std::move(started->server);
  server_->watch([program = program_] { return program->look(); });
  team_.emplace(server_, setup_.seat.colour, first);
  team_->begin(info_);
}

void RunTeam::fail(std::string reason, ErrorCode code) {
  using State = TeamCondition::State;
  condition_.reason = std::move(reason);
  team_.reset();
  if (code == ErrorCode::kMachine || code == ErrorCode::kInterrupted) {
    condition_.state = State::kCut;
  } else if (++condition_.failures >= info_.decision_time.value_or(DecisionTime{}).failures) {
    condition_.state = State::kLost;
  } else {
    condition_.state = State::kDown;
    start(false);
  }
}

void RunTeam::settle() {
  if (!team_) return;
  const TeamCondition& told = team_->condition();
  if (server_->clientEnded()) {
    const ChildEnd end = program_->end();
    return fail("its client ended: " + end.reason, end.machine ? ErrorCode::kMachine : ErrorCode::kBadInput);
  }
  condition_.state = told.state;
  if (told.state != TeamCondition::State::kLost) return;
  condition_.failures += told.failures;
  condition_.reason = told.reason;
}

void RunTeam::ask(const Observation& observation) {
  if (team_) team_->ask(observation);
  settle();
}

TeamCommand RunTeam::decide(const Observation& observation) {
  if (!team_) return {};
  const TeamCommand command = team_->decide(observation);
  settle();
  return command;
}

std::optional<TeamProposal> RunTeam::place(const PlacementRequest& request) {
  if (!team_) return std::nullopt;
  auto proposal = team_->place(request);
  settle();
  return proposal;
}

void RunTeam::ready(const Observation& observation) {
  if (team_) team_->ready(observation);
  settle();
}

void RunTeam::ended(const MatchEnd& end) {
  if (!team_) return;
  team_->ended(end);
  program_->waitForEnd(kFarewell);
}

std::vector<Setting> RunTeam::origin() const {
  std::vector<Setting> origin;
  if (program_) addContainment(program_->containment(), origin);
  return origin;
}

}  // namespace fulbito::wire
