#include "bridge/abi/library_team.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "fulbito/referee.hpp"
#include "navigation/library/plugin_values.hpp"

namespace fulbito {

LibraryTeam::LibraryTeam(std::unique_ptr<PluginTeam> team) : team_(std::move(team)) {}

void LibraryTeam::begin(const MatchInfo& info) {
  seen_ = {};
  navigators_.clear();
  team_->begin(toAbi(info), wideningToAbi(info.robot), toToml(info.rules));
  for (const std::string& name : team_->navigatorNames()) {
    navigators_.push_back(navigatorFor(name, parseNavigator));
  }
}

TeamCommand LibraryTeam::decide(const Observation& observation) {
  toAbi(observation, seen_);
  fulbito_team_command command = room_.open(observation.wants_drawings);
  TeamCommand decision;
  if (!team_->decide(seen_, command)) return decision;
  room_.close(command);
  fromAbi(command, seen_.team_size, decision);
  return decision;
}

std::optional<TeamProposal> LibraryTeam::place(const PlacementRequest& request) {
  fulbito_placement_request asked{};
  toAbi(request, asked);
  fulbito_placement placement{};
  if (!team_->place(asked, placement)) return std::nullopt;
  return fromAbi(placement);
}

void LibraryTeam::stopped(const PlayStop& stop) {
  fulbito_stop notice{};
  toAbi(stop, notice);
  team_->stopped(notice);
}

void LibraryTeam::ready(const Observation& observation) {
  fulbito_observation seen{};
  toAbi(observation, seen);
  team_->ready(seen);
}

void LibraryTeam::ended(const MatchEnd& end) { team_->ended(toAbi(end)); }

std::optional<ExerciseReply> LibraryTeam::exercise(const Observation& observation, const Exercise& exercise) {
  toAbi(observation, seen_);
  fulbito_team_command command = room_.open(observation.wants_drawings);
  fulbito_vec2 answer{};
  bool has_skill = false;
  ExerciseReply reply;
  if (!team_->exercise(seen_, toAbi(exercise), command, answer, has_skill)) return reply;
  if (!has_skill) return std::nullopt;
  room_.close(command);
  fromAbi(command, seen_.team_size, reply.command);
  reply.answer = fromAbi(answer);
  return reply;
}

Result<TeamInfo> loadTeamLibrary(const std::string& path, PluginLog log) {
  const auto library = TeamLibrary::open(path);
  if (!library) return tl::unexpected<Error>(library.error());
  const fulbito_library& table = (*library)->table();
  TeamInfo info;
  info.name = table.name;
  info.summary = table.summary == nullptr ? "" : table.summary;
  info.parameters = (*library)->parameters;
  info.takes_navigator = table.default_navigator != nullptr;
  info.default_navigator = info.takes_navigator ? table.default_navigator : "";
  info.make = [library = *library, log = std::move(log)](
                  const std::vector<Setting>& settings) -> Result<std::unique_ptr<Strategy>> {
    auto team = PluginTeam::create(library, settings, log);
    if (!team) return tl::unexpected<Error>(team.error());
    return std::unique_ptr<Strategy>(std::make_unique<LibraryTeam>(std::move(*team)));
  };
  return info;
}

NavigatorChoice navigatorFor(const std::string& specification,
                             Result<NavigatorChoice> (*parse)(const std::string&)) {
  std::string text = specification;
  std::replace(text.begin(), text.end(), '+', ',');
  auto choice = parse(text);
  if (choice) return std::move(*choice);
  NavigatorInfo info;
  info.name = text;
  info.make = [error = choice.error()](const std::vector<Setting>&) -> Result<std::unique_ptr<Navigator>> {
    return tl::unexpected<Error>(error);
  };
  NavigatorChoice failing;
  failing.info = std::make_shared<const NavigatorInfo>(std::move(info));
  failing.text = text;
  return failing;
}

}  // namespace fulbito
