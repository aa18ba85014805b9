// Private header of referee: not installed.
#pragma once

#include <cmath>

#include "referee/detectors.hpp"
#include "referee/match_referee.hpp"

/// What several detectors need.
namespace fulbito {

/// Seconds of the rules in whole ticks.
inline Tick ticksOf(double seconds, double dt) { return static_cast<Tick>(seconds / dt + 0.5); }

inline Side sideOf(const RefereeState& state, TeamId team) {
  return team == TeamId::kBlue ? state.blue_side : opposite(state.blue_side);
}
inline TeamId defenderOf(const RefereeState& state, Side side) {
  return side == state.blue_side ? TeamId::kBlue : TeamId::kYellow;
}

/// A call with what every event has in common.
inline GameEvent makeEvent(const DetectorInput& in, std::string_view clause, std::string_view law) {
  GameEvent event;
  event.tick = in.view.tick;
  event.play_time = static_cast<double>(in.state.play_ticks) * in.setup.dt;
  event.period = static_cast<std::uint8_t>(in.state.period);
  event.clause = clause;
  event.law = law;
  event.place = in.view.ball.position;
  return event;
}

inline void measure(GameEvent& event, double value, double threshold) {
  event.value = value;
  event.threshold = threshold;
  event.margin = std::abs(value - threshold);
}

}  // namespace fulbito
