#include "match/seats/seats.hpp"

#include <string>
#include <utility>

namespace fulbito {
namespace {

Error ofTeam(TeamId team, const Error& error) {
  return {error.code, std::string(nameOf(team)) + " team: " + error.message};
}

}  // namespace

Result<Seats> Seats::create(const MatchConfig& config, const MatchClock& clock) {
  Seats both;
  both.seats_.reserve(kTeams.size());
  for (const TeamId team : kTeams) {
    auto seat = Seat::create(config, team, clock);
    if (!seat) return tl::unexpected<Error>(ofTeam(team, seat.error()));
    both.seats_.push_back(std::move(*seat));
  }
  return both;
}

void Seats::sense(const SeatTick& tick, StageClock& stages) {
  for (Seat& seat : seats_) seat.sense(tick.moment, tick.drawings);
  stages.lap(&MatchProfile::sense);
  // `ask` goes to both teams first, so that teams in other processes think at the same time.
  for (Seat& seat : seats_) seat.ask();
  stages.lap(&MatchProfile::decide);
}

Result<void> Seats::act(const SeatTick& tick, StageClock& stages, std::vector<GameEvent>& events,
                        std::span<WheelSpeeds> commands) {
  for (Seat& seat : seats_) {
    seat.decide();
    stages.lap(&MatchProfile::decide);
    seat.clean(tick.now, events);
    stages.lap(&MatchProfile::navigate);
  }
  for (Seat& seat : seats_) seat.countFailures(tick.now, events);
  if (const auto error = cut()) return tl::unexpected<Error>(*error);
  for (Seat& seat : seats_) seat.drive(tick.moment.ids, tick.held, commands);
  stages.lap(&MatchProfile::navigate);
  return {};
}

/// A lack of resources is no team's fault: the match stops without a winner.
std::optional<Error> Seats::cut() const {
  for (const TeamId team : kTeams) {
    if (const auto error = (*this)[team].cut()) return ofTeam(team, *error);
  }
  return std::nullopt;
}

}  // namespace fulbito
