#include <utility>

#include <fmt/format.h>

#include "engine/core/config/suggest.hpp"
#include "fulbito/strategy.hpp"
#include "navigation/interface/parameters.hpp"

namespace fulbito {

// The built-in teams: each is defined in a file of its own below strategies/teams.

/// No robot moves: the first opponent for a new striker.
TeamInfo idleInfo();
/// All robots drive smoothly at random, for tests of the referee and the engine.
TeamInfo randomTeamInfo();
/// All robots drive straight at the ball: the weakest opponent that a team must beat.
TeamInfo chaserInfo();
/// The textbook team: fixed roles, and a field that leads to the ball with the right heading.
TeamInfo classicInfo();
/// The flagship team: a striker, a support and a keeper who exchange their roles during play
/// (docs/libero.md).
TeamInfo liberoInfo();

/// The sparring teams, each a school of play (docs/strategies.md).
namespace sparring {
/// @{ Teams are tuned against these.
TeamInfo univectorInfo();
TeamInfo twinsInfo();
TeamInfo markerInfo();
TeamInfo blockInfo();
TeamInfo counterInfo();
TeamInfo presserInfo();
/// @}
/// @{ Teams that only validate: nothing is tuned against them.
TeamInfo dribblerInfo();
TeamInfo kickerInfo();
TeamInfo spinnerInfo();
TeamInfo sweeperInfo();
/// @}
}  // namespace sparring

TeamChoice TeamChoice::own(std::string name, std::function<std::unique_ptr<Strategy>()> make) {
  TeamInfo info;
  info.name = name;
  info.make = [make = std::move(make)](const std::vector<Setting>&) -> Result<std::unique_ptr<Strategy>> {
    return make();
  };
  return {std::make_shared<const TeamInfo>(std::move(info)), std::move(name), {}, {}};
}

TeamCatalogue TeamCatalogue::builtIn() {
  TeamCatalogue catalogue;
  const auto add = [&catalogue](std::vector<TeamInfo> teams, const char* purpose) {
    for (TeamInfo& info : teams) {
      info.purpose = purpose;
      catalogue.teams_.push_back(std::make_shared<const TeamInfo>(std::move(info)));
    }
  };
  add({idleInfo(), randomTeamInfo(), chaserInfo(), classicInfo(), liberoInfo()}, "");
  add({sparring::univectorInfo(), sparring::twinsInfo(), sparring::markerInfo(), sparring::blockInfo(),
       sparring::counterInfo(), sparring::presserInfo()},
      "training");
  add({sparring::dribblerInfo(), sparring::kickerInfo(), sparring::spinnerInfo(), sparring::sweeperInfo()},
      "validation");
  return catalogue;
}

Result<void> TeamCatalogue::add(TeamInfo info) {
  if (info.name.empty() || info.name.find_first_of(":,") != std::string::npos) {
    return fail(ErrorCode::kUsage, fmt::format("'{}' cannot be a team's name", info.name));
  }
  if (!info.make) return fail(ErrorCode::kUsage, fmt::format("team '{}': nothing makes it", info.name));
  for (const auto& team : teams_) {
    if (team->name != info.name) continue;
    return fail(ErrorCode::kUsage, fmt::format("there is a team '{}' already", info.name));
  }
  teams_.push_back(std::make_shared<const TeamInfo>(std::move(info)));
  return {};
}

Result<TeamChoice> TeamCatalogue::parse(const std::string& specification) const {
  for (const Source& source : sources_) {
    if (auto choice = source(specification)) return std::move(*choice);
  }
  const std::size_t colon = specification.find(':');
  const std::string name = specification.substr(0, colon);
  TeamChoice choice;
  choice.text = specification;
  std::vector<std::string> names;
  for (const auto& info : teams_) {
    if (info->name == name) choice.info = info;
    names.push_back(info->name);
  }
  if (choice.info == nullptr) {
    return fail(ErrorCode::kUsage, fmt::format("there is no team '{}'.{}", name, suggestion(name, names)));
  }
  if (colon != std::string::npos) {
    auto settings = parseSettings(specification.substr(colon + 1), specification);
    if (!settings) return tl::unexpected<Error>(settings.error());
    choice.settings = std::move(*settings);
  }
  // The trial reports wrong parameters before a match starts.
  const auto trial = makeTeam(choice);
  if (!trial) return tl::unexpected<Error>(trial.error());
  return choice;
}

Result<TeamChoice> parseTeam(const std::string& specification) {
  return TeamCatalogue::builtIn().parse(specification);
}

const TeamCondition& Strategy::condition() const {
  static const TeamCondition well;
  return well;
}

Result<std::unique_ptr<Strategy>> makeTeam(const TeamChoice& choice) {
  return choice.info->make(choice.settings);
}

}  // namespace fulbito
