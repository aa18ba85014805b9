#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "match/play/match_observer.hpp"

namespace fulbito {

/// One entry of a match's event log: a call of the referee, or a restart.
struct LoggedEvent {
  GameEvent call;                      ///< for a restart: tick, time, period, taking team and ball position
  std::optional<RestartKind> restart;  ///< empty: a call
  PerTeam<int> score{};                ///< after it
};

/// Stores the events of the observed match, up to a limit.
class EventLog : public MatchObserver {
 public:
  explicit EventLog(std::size_t limit = 20000) : limit_(limit) {}
  const std::vector<LoggedEvent>& events() const { return events_; }
  /// Number of events beyond the limit.
  std::size_t leftOut() const { return left_out_; }

  void matchBegins(const MatchConfig& config) override;
  void playBegins(const PlayStart& start) override;
  void ticked(const MatchTick& tick) override;
  void abandoned(const GameEvent& event, const RefereeState& referee) override;

 private:
  void keep(const LoggedEvent& event);

  std::size_t limit_;
  std::vector<LoggedEvent> events_;
  std::size_t left_out_ = 0;
  double dt_ = 0.0;
};

/// Writes the events of the observed match as JSON objects, one per line (docs/results-format.md). The first
/// line describes the match, the last one its result.
class EventLines : public MatchObserver {
 public:
  /// Called with each line, including its line end.
  using Sink = std::function<void(std::string_view)>;
  explicit EventLines(Sink sink) : sink_(std::move(sink)) {}

  void matchBegins(const MatchConfig& config) override;
  void playBegins(const PlayStart& start) override;
  void ticked(const MatchTick& tick) override;
  void abandoned(const GameEvent& event, const RefereeState& referee) override;
  void matchEnds(const RefereeState& referee, Tick tick) override;

 private:
  Sink sink_;
  double dt_ = 0.0;
};

}  // namespace fulbito
