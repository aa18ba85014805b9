#pragma once

#include <string>
#include <vector>

#include "fulbito/strategy.hpp"

namespace fulbito::wire {

/// @{ Ports from the first one on, `WireSettings::port_base`. The default is the league's.
inline constexpr int kDefaultPortBase = 10002;
inline constexpr int kVisionOffset = 0;       ///< 10002
inline constexpr int kRefereeOffset = 1;      ///< 10003
inline constexpr int kPlacementOffset = 2;    ///< 10004
inline constexpr int kCommandOffset = 10009;  ///< 20011
inline constexpr int kYellowOffset = 10010;   ///< 20012, with `WireSettings::team_ports`
inline constexpr int kBlueOffset = 10011;     ///< 20013, likewise
inline constexpr int kLargestPortBase = 65535 - kBlueOffset;
/// @}
inline constexpr const char* kVisionGroup = "224.0.0.1";    ///< of the simulator's frames
inline constexpr const char* kRefereeGroup = "224.5.23.2";  ///< of the referee's commands and of placements

/// How a server talks to clients.
struct WireSettings {
  int port_base = kDefaultPortBase;  ///< port of vision; the others follow from it
  std::string interface;             ///< address of the interface for multicast; empty: the system's choice
  double speed = 1.0;                ///< frames per period of simulated time, over real time
  bool lockstep = false;             ///< a frame ends once its commands are there, not at its time
  double answer = 0.1;               ///< [s] with `lockstep`: longest wait for commands
  double placing = 4.0;              ///< [s] at a restart: longest wait for a placement, over `speed`
  double wait = 180.0;               ///< [s] without a client until its team is lost; 0: for ever
  bool lock = false;                 ///< for each colour only the first sender counts
  bool team_ports = false;           ///< commands come at a port for each colour, too
  bool referee = true;               ///< it also speaks as the referee, and listens for placements
  friend bool operator==(const WireSettings&, const WireSettings&) = default;
};

/// A team of the wire, as its specification says.
struct WireSeat {
  TeamId colour = TeamId::kBlue;  ///< colour of the client's team, whatever seat it plays
  WireSettings settings;
  std::string run;  ///< command that starts the client; empty: it connects by itself
};

/// Whether a specification names a team of the wire: `wire` or `wire:...`.
bool isWire(const std::string& specification);
/// Parses `wire:COLOUR`, `wire:COLOUR@PORTBASE` and either with `:name=value,...` and `:run=COMMAND` at the
/// end. `wire:run=COMMAND` is blue. Errors: kUsage naming what is wrong, and what there is.
Result<WireSeat> parseWire(const std::string& specification);
/// The settings that specifications may have, with ranges and meanings, without `interface`.
std::vector<ParameterSpec> wireParameters();

}  // namespace fulbito::wire
