#include "bridge/wire/wire_teams.hpp"

#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "bridge/outside/team_command.hpp"
#include "bridge/wire/run_team.hpp"
#include "bridge/wire/wire_server.hpp"
#include "bridge/wire/wire_team.hpp"

namespace fulbito::wire {
namespace {

/// The servers of the teams that live, by their first port.
class Servers {
 public:
  Servers(WireClock clock, WireLog log) : clock_(std::move(clock)), log_(std::move(log)) {}

  Result<std::unique_ptr<Strategy>> teamOf(const WireSeat& seat) {
    const std::lock_guard guard(mutex_);
    std::weak_ptr<WireServer>& kept = servers_[seat.settings.port_base];
    std::shared_ptr<WireServer> server = kept.lock();
    if (!server) {
      auto opened = WireServer::open(seat.settings, clock_, log_);
      if (!opened) return tl::unexpected<Error>(opened.error());
      server = std::move(*opened);
      kept = server;
    }
    if (!(server->settings() == seat.settings)) {
      return fail(ErrorCode::kUsage,
                  fmt::format("both teams at port {} need the same settings", seat.settings.port_base));
    }
    if (!server->claim(seat.colour)) {
      return fail(ErrorCode::kUsage,
                  fmt::format("{} at port {} plays already; take the other colour, other ports, or --jobs 1",
                              nameOf(seat.colour), seat.settings.port_base));
    }
    return std::make_unique<WireTeam>(std::move(server), seat.colour);
  }

 private:
  WireClock clock_;
  WireLog log_;
  std::mutex mutex_;
  std::map<int, std::weak_ptr<WireServer>> servers_;
};

using Make = decltype(TeamInfo::make);

/// What makes teams of a client that connects by itself.
Make makerOf(const WireSeat& seat, const std::string& specification,
             const std::shared_ptr<Servers>& servers) {
  return [servers, seat, specification](const std::vector<Setting>&) -> Result<std::unique_ptr<Strategy>> {
    auto team = servers->teamOf(seat);
    if (team) return team;
    return fail(team.error().code, fmt::format("team '{}': {}", specification, team.error().message));
  };
}

/// What makes teams that start their client. Errors: kUsage for a command that names no program.
Result<Make> runnerOf(const WireSeat& seat, const std::string& specification, const OutsideOptions& options,
                      const WireLog& log) {
  auto line = parseTeamCommand("cmd:" + seat.run);
  if (!line) return tl::unexpected<Error>(line.error());
  ClientSetup setup{seat, {}, options.clock, log, {}};
  setup.child.command = std::move(line->command);
  setup.child.own_folder = std::move(line->folder);
  setup.child.limits = options.limits;
  setup.child.sandbox_required = options.sandbox_required;
  if (options.log) {
    setup.printed = [show = options.log, specification](std::string_view text) { show(specification, text); };
  }
  // What keeps it from starting is said before the match.
  if (const auto trial = startClient(setup); !trial) {
    return fail(trial.error().code, fmt::format("team '{}': {}", specification, trial.error().message));
  }
  return [setup = std::move(setup)](const std::vector<Setting>&) -> Result<std::unique_ptr<Strategy>> {
    return std::make_unique<RunTeam>(setup);
  };
}

Result<TeamChoice> choiceOf(const std::string& specification, const std::shared_ptr<Servers>& servers,
                            const OutsideOptions& options, const WireLog& log) {
  const auto seat = parseWire(specification);
  if (!seat) return tl::unexpected<Error>(seat.error());
  TeamInfo info;
  info.name = specification;
  info.summary = fmt::format("a client of the league, {}", nameOf(seat->colour));
  info.outside = true;
  auto make = seat->run.empty() ? Result<Make>(makerOf(*seat, specification, servers))
                                : runnerOf(*seat, specification, options, log);
  if (!make) return tl::unexpected<Error>(make.error());
  info.make = std::move(*make);
  TeamChoice choice{std::make_shared<const TeamInfo>(std::move(info)), specification, {}, {}};
  // What keeps it from starting is said before the match.
  if (const auto trial = makeTeam(choice); !trial) return tl::unexpected<Error>(trial.error());
  return choice;
}

}  // namespace

TeamCatalogue::Source wireTeams(OutsideOptions options, WireLog log) {
  auto servers = std::make_shared<Servers>(options.clock, log);
  return [servers, options = std::move(options),
          log = std::move(log)](const std::string& specification) -> std::optional<Result<TeamChoice>> {
    if (!isWire(specification)) return std::nullopt;
    return choiceOf(specification, servers, options, log);
  };
}

}  // namespace fulbito::wire
