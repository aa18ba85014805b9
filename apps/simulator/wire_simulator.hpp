#pragma once

#include <cstdint>
#include <memory>

#include "apps/simulator/simulated_field.hpp"
#include "bridge/wire/wire_server.hpp"

namespace fulbito::simulator {

/// The simulator of the league alone: sends vision, and obeys commands and replacements of any sender. The
/// referee is another program, or there is none.
class WireSimulator {
 public:
  /// `settings.referee` does not matter. Errors: as `WireServer::open` and `SimulatedField::create`.
  static Result<std::unique_ptr<WireSimulator>> open(const MatchConfig& config, wire::WireSettings settings,
                                                     wire::WireClock clock, wire::WireLog log);
  WireSimulator(const WireSimulator&) = delete;
  WireSimulator& operator=(const WireSimulator&) = delete;

  /// Sends a frame, waits for its end, and simulates what follows. Errors: as `SimulatedField::step`.
  Result<void> step();

  const wire::WireServer& server() const { return *server_; }
  /// Robots and balls that were put elsewhere.
  std::int64_t replacements() const { return replacements_; }

 private:
  WireSimulator(std::unique_ptr<wire::WireServer> server, SimulatedField field);
  void finishFrame();

  std::unique_ptr<wire::WireServer> server_;
  SimulatedField field_;
  std::int64_t replacements_ = 0;
};

}  // namespace fulbito::simulator
