#pragma once

#include <string>

#include "bridge/wire/oddities.hpp"
#include "fulbito/strategy.hpp"

namespace fulbito::wire {

/// The source of teams that are clients of the league (docs/league.md): `wire:yellow`, `wire:blue@10002`,
/// `wire:blue:lockstep=1`. Teams with the same ports in the same match share one server, and must have the
/// same settings.
/// @param clock  monotonic time [ns]
/// @param log    takes lines for people
/// Errors: as `parseWire`; kIo if a port is taken or there is no way for multicast; kUsage if the colour is
/// taken.
TeamCatalogue::Source wireTeams(WireClock clock, WireLog log);

}  // namespace fulbito::wire
