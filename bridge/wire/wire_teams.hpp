#pragma once

#include <string>

#include "bridge/wire/oddities.hpp"
#include "fulbito/outside.hpp"
#include "fulbito/strategy.hpp"

namespace fulbito::wire {

/// The source of teams that are clients of the league (docs/league.md): `wire:yellow`, `wire:blue@10002`,
/// `wire:blue:lockstep=1`. Teams with the same ports in the same match share one server, and must have the
/// same settings. `wire:run=COMMAND` starts its client, with a server for it alone, contained as other
/// programs are, and once when it is parsed.
/// @param options  the clock, and how clients run that are started
/// @param log      takes lines about the wire for people
/// Errors: as `parseWire`; kIo if a port is taken or there is no way for multicast; kUsage if the colour is
/// taken, or if the command does not start; kMachine if the machine cannot start it; kInterrupted.
TeamCatalogue::Source wireTeams(OutsideOptions options, WireLog log);

}  // namespace fulbito::wire
