#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "match/play/match_observer.hpp"

namespace fulbito {

/// One line of a match's record: a call of the referee, or a restart.
struct LoggedEvent {
  GameEvent call;  ///< of a restart: tick, time, period, team that takes it, and the ball's place
  std::optional<RestartKind> restart;  ///< empty: a call
  PerTeam<int> score{};                ///< after it
};

/// Keeps the events of the match that it watches, up to a limit.
class EventLog : public MatchObserver {
 public:
  explicit EventLog(std::size_t limit = 20000) : limit_(limit) {}
  const std::vector<LoggedEvent>& events() const { return events_; }
  /// Events beyond the limit, which are only counted.
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

/// Streams the events of the match that it watches as JSON objects, one a line (docs/results-format.md). The
/// first line says what is played, the last one how it ended.
class EventLines : public MatchObserver {
 public:
  /// Takes a line with its line end.
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
