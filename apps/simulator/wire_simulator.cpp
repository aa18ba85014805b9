#include "apps/simulator/wire_simulator.hpp"

#include <utility>

namespace fulbito::simulator {

WireSimulator::WireSimulator(std::unique_ptr<wire::WireServer> server, SimulatedField field)
    : server_(std::move(server)), field_(std::move(field)) {
  server_->onReplacement(
      [this](const wire::Packet& packet) { replacements_ += field_.replace(packet, server_->oddities()); });
}

Result<std::unique_ptr<WireSimulator>> WireSimulator::open(const MatchConfig& config,
                                                           wire::WireSettings settings, wire::WireClock clock,
                                                           wire::WireLog log) {
  auto field = SimulatedField::create(config, startOf(config));
  if (!field) return tl::unexpected<Error>(field.error());
  settings.referee = false;
  auto server = wire::WireServer::open(settings, std::move(clock), std::move(log));
  if (!server) return tl::unexpected<Error>(server.error());
  (*server)->begin(config.rules.team_size, config.physics.controlPeriod());
  return std::unique_ptr<WireSimulator>(new WireSimulator(std::move(*server), std::move(*field)));
}

/// In lockstep the frame ends once each colour that ever had a client has answered. Without any to wait for
/// it lasts as long as at real time.
void WireSimulator::finishFrame() {
  bool awaited = false;
  for (const TeamId colour : kTeams) {
    const std::uint32_t robots = field_.on(colour);
    if (!server_->settings().lockstep || !server_->heard(colour) || robots == 0) continue;
    server_->awaitCommands(colour, robots, server_->settings().answer);
    awaited = true;
  }
  if (!awaited) server_->finishFrame();
}

Result<void> WireSimulator::step() {
  server_->show(field_.vision());
  finishFrame();
  SimulatedField::Wheels wheels{};
  for (const TeamId team : kTeams) {
    const std::uint32_t gone = field_.wentOff(team);
    for (std::size_t i = 0; i < kMaxTeamSize; ++i) {
      if ((gone >> i & 1U) != 0) server_->forget(team, i);
      wheels[indexOf(team)][i] = server_->wheels(team, i);
    }
  }
  return field_.step(wheels);
}

}  // namespace fulbito::simulator
