#include <algorithm>

#include "engine/core/base/text_controls.hpp"
#include "fulbito/statistics.hpp"
#include "match/report/match_json.hpp"

namespace fulbito {
namespace {

constexpr std::size_t kManyEvents = 1024;

/// The restart as a logged event.
LoggedEvent restartEvent(const PlayStart& start, double dt) {
  const RefereeState& referee = *start.referee;
  LoggedEvent event;
  event.call.tick = start.tick;
  event.call.period = static_cast<std::uint8_t>(referee.period);
  event.call.play_time = static_cast<double>(referee.play_ticks) * dt;
  event.call.team = start.call.team;
  event.call.place = start.placement.ball;
  event.restart = start.call.kind;
  event.score = referee.score;
  return event;
}

std::string lineOf(const Json& json) {
  return escapedJson(json.dump(-1, ' ', false, Json::error_handler_t::replace)) + '\n';
}

}  // namespace

void EventLog::onMatchStart(const MatchConfig& config) {
  events_.clear();
  events_.reserve(std::min(limit_, kManyEvents));
  left_out_ = 0;
  dt_ = config.physics.controlPeriod();
}

void EventLog::onPlayStart(const PlayStart& start) {
  for (const GameEvent& call : start.events) keep({call, std::nullopt, start.referee->score});
  keep(restartEvent(start, dt_));
}

void EventLog::onTick(const MatchTick& tick) {
  for (const GameEvent& call : tick.events) keep({call, std::nullopt, tick.referee->score});
}

void EventLog::onAbandoned(const GameEvent& event, const RefereeState& referee) {
  keep({event, std::nullopt, referee.score});
}

void EventLog::keep(const LoggedEvent& event) {
  if (events_.size() < limit_) {
    events_.push_back(event);
  } else {
    ++left_out_;
  }
}

void EventLines::onMatchStart(const MatchConfig& config) {
  dt_ = config.physics.controlPeriod();
  const Json header = {{"schema_version", kMatchSchemaVersion},
                       {"event", "match"},
                       {"teams", {{"blue", config.teams[0].text}, {"yellow", config.teams[1].text}}},
                       {"seed", config.seed},
                       {"dt_s", dt_},
                       {"config", matchConfigJson(config)},
                       {"build", buildJson()}};
  sink_(lineOf(header));
}

void EventLines::onPlayStart(const PlayStart& start) {
  for (const GameEvent& call : start.events) {
    sink_(lineOf(eventJson({call, std::nullopt, start.referee->score}, dt_)));
  }
  sink_(lineOf(eventJson(restartEvent(start, dt_), dt_)));
}

void EventLines::onTick(const MatchTick& tick) {
  for (const GameEvent& call : tick.events) {
    sink_(lineOf(eventJson({call, std::nullopt, tick.referee->score}, dt_)));
  }
}

void EventLines::onAbandoned(const GameEvent& event, const RefereeState& referee) {
  sink_(lineOf(eventJson({event, std::nullopt, referee.score}, dt_)));
}

void EventLines::onMatchEnd(const RefereeState& referee, Tick tick) {
  Json end = {{"tick", tick},
              {"time_s", static_cast<double>(tick) * dt_},
              {"period", referee.period},
              {"event", "end"},
              {"complete", referee.ended},
              {"score", {referee.score[0], referee.score[1]}}};
  sink_(lineOf(end));
}

}  // namespace fulbito
