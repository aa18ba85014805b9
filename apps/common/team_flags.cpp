#include "apps/common/team_flags.hpp"

#include <CLI/CLI.hpp>

#include "apps/common/commands.hpp"
#include "apps/common/console.hpp"
#include "apps/common/option_values.hpp"
#include "bridge/wire/wire_teams.hpp"

namespace fulbito::app {
namespace {

constexpr double kLeastMemory = 16.0;            // [MiB]
constexpr double kMostMemory = 1024.0 * 1024.0;  // [MiB]
constexpr int kMostProcesses = 10'000;

}  // namespace

void addTeamFlags(CLI::App& command, TeamFlags& flags) {
  const auto group = [](CLI::Option* option) { return option->group("Teams that are files or programs"); };
  group(command
            .add_option("--isolate", flags.isolate,
                        "'process': a library runs in a contained process; 'none': in this one")
            ->check(CLI::IsMember({"process", "none"}))
            ->capture_default_str());
  group(command
            .add_option("--sandbox", flags.sandbox,
                        "'best': all containment that this system allows; 'require': or refuse")
            ->check(CLI::IsMember({"best", "require"}))
            ->capture_default_str());
  group(number(command.add_option("--team-memory", flags.memory_mb, "memory of each team [MiB]"))
            ->check(CLI::Range(kLeastMemory, kMostMemory))
            ->type_name("MIB")
            ->capture_default_str());
  group(command.add_option("--team-processes", flags.processes, "processes and threads of each team")
            ->check(CLI::Range(1, kMostProcesses))
            ->type_name("N")
            ->capture_default_str());
  group(command.add_flag("--team-network", flags.network, "teams may use the network"));
}

TeamCatalogue catalogueOf(const TeamFlags& flags) {
  OutsideOptions options;
  using Isolation = OutsideOptions::Isolation;
  options.isolation = flags.isolate == "none" ? Isolation::kNone : Isolation::kProcess;
  options.sandbox_required = flags.sandbox == "require";
  options.limits.memory = static_cast<std::size_t>(flags.memory_mb * 1024.0 * 1024.0);
  options.limits.processes = flags.processes;
  options.limits.network = flags.network;
  options.clock = now;
  options.log = [](const std::string& team, std::string_view line) { note("{}: {}\n", team, line); };
  TeamCatalogue catalogue = TeamCatalogue::builtIn();
  catalogue.addSource(outsideTeams(options));
  catalogue.addSource(
      wire::wireTeams(std::move(options), [](std::string_view line) { note("wire: {}\n", line); }));
  return catalogue;
}

}  // namespace fulbito::app
