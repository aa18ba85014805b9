#include "apps/match/simulate.hpp"

#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "apps/common/commands.hpp"
#include "apps/common/console.hpp"
#include "apps/simulator/wire_simulator.hpp"

namespace fulbito::app {
namespace {

using simulator::WireSimulator;
using wire::Oddity;

void announcePorts(const wire::WireSettings& settings) {
  const int base = settings.port_base;
  std::string ports = fmt::format("{}", base + wire::kCommandOffset);
  if (settings.team_ports) {
    ports += fmt::format(", of yellow {}, of blue {}", base + wire::kYellowOffset, base + wire::kBlueOffset);
  }
  note("wire: vision on {}:{}, commands to port {}; replacements to port {}; no referee\n",
       wire::kVisionGroup, base + wire::kVisionOffset, ports, base + wire::kCommandOffset);
}

void print(const WireSimulator& simulator, double period, bool json) {
  const wire::WireServer& server = simulator.server();
  const auto count = [&](Oddity kind) { return server.oddities().count(kind); };
  const double seconds = static_cast<double>(server.frames()) * period;
  if (json) {
    const nlohmann::ordered_json text = {{"schema_version", 1},
                                         {"simulated_s", seconds},
                                         {"frames", server.frames()},
                                         {"commands", server.commands()},
                                         {"replacements", simulator.replacements()},
                                         {"malformed", count(Oddity::kMalformed)},
                                         {"not_finite", count(Oddity::kNotFinite)},
                                         {"unknown_robots", count(Oddity::kUnknown)},
                                         {"floods", count(Oddity::kFlood)},
                                         {"other_senders", count(Oddity::kOtherSender)},
                                         {"misplaced", count(Oddity::kReplacement)},
                                         {"unsent", count(Oddity::kUnsent)}};
    writeOut(text.dump(2) + "\n");
    return;
  }
  say("simulated {:.1f} s without a referee: frames {}, commands {}, replacements {}\n", seconds,
      server.frames(), server.commands(), simulator.replacements());
  say("ignored: malformed datagrams {}, values that are not finite {}, unknown robots {}, of floods {}, of "
      "other senders {}, replacements at the teams' ports {}\n",
      count(Oddity::kMalformed), count(Oddity::kNotFinite), count(Oddity::kUnknown), count(Oddity::kFlood),
      count(Oddity::kOtherSender), count(Oddity::kReplacement));
}

}  // namespace

int simulate(const MatchSettings& settings, const wire::WireSettings& wire, const SimulateOptions& options,
             bool json) {
  const auto config = configWithoutTeams(settings);
  if (!config) return report(config.error());
  auto simulator =
      WireSimulator::open(*config, wire, now, [](std::string_view line) { note("wire: {}\n", line); });
  if (!simulator) return report(simulator.error());
  announcePorts(wire);
  const double period = config->physics.controlPeriod();
  const double frames =
      options.seconds ? std::ceil(*options.seconds / period - 1e-6) : std::numeric_limits<double>::infinity();
  Result<void> stepped;
  while (stepped && !interrupted() && static_cast<double>((*simulator)->server().frames()) < frames) {
    stepped = (*simulator)->step();
  }
  print(**simulator, period, json);
  if (!stepped) return report(stepped.error());
  return interrupted() ? interruptedCode() : kOk;
}

}  // namespace fulbito::app
