#include "bridge/abi/library_team.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "bridge/abi/frames.hpp"
#include "fulbito/referee.hpp"
#include "navigation/library/plugin_values.hpp"

namespace fulbito {

LibraryTeam::LibraryTeam(std::unique_ptr<PluginTeam> first, Make make)
    : make_(std::move(make)), team_(std::move(first)), name_(team_->table().name) {
  if (team_->table().version != nullptr) version_ = team_->table().version;
}

Result<void> LibraryTeam::start() {
  if (team_ == nullptr) {
    auto made = make_();
    if (!made) return tl::unexpected<Error>(made.error());
    team_ = std::move(*made);
  }
  team_->begin(abiOf<fulbito_match_info>(info_), wideningToAbi(info_.robot), toToml(info_.rules));
  if (auto taken = takeNavigators(); !taken) return taken;
  if (!team_->failure().empty()) return fail(ErrorCode::kBadInput, team_->failure());
  return {};
}

Result<void> LibraryTeam::takeNavigators() {
  std::vector<std::string> names = team_->navigatorNames();
  if (begun_ && names != navigator_names_) {
    return fail(ErrorCode::kBadInput, "other navigators than at its first start");
  }
  if (begun_) return {};
  navigators_.clear();
  for (const std::string& name : names) navigators_.push_back(navigatorFor(name, parseNavigator));
  navigator_names_ = std::move(names);
  return {};
}

void LibraryTeam::failed(const std::string& reason) {
  // copied first, as it may belong to the team, which is destroyed next
  condition_.reason = failureText(reason);
  team_.reset();
  if (!begun_) navigators_.clear();
  const int most = info_.decision_time ? info_.decision_time->failures : 1;
  condition_.state = ++condition_.failures >= most ? State::kLost : State::kDown;
}

/// The condition after a request. @return whether its answer counts
bool LibraryTeam::settle() {
  condition_.state = State::kWell;
  if (!team_->failure().empty()) failed(team_->failure());
  return condition_.state == State::kWell;
}

void LibraryTeam::begin(const MatchInfo& info) {
  info_ = info;
  seen_ = {};
  begun_ = false;
  condition_ = {};
  if (team_ != nullptr && !team_->failure().empty()) team_.reset();
  while (condition_.state != State::kLost) {
    const auto started = start();
    condition_.state = State::kWell;
    if (started) break;
    failed(started.error().message);
  }
  begun_ = true;
}

TeamCommand LibraryTeam::decide(const Observation& observation) {
  TeamCommand decision;
  if (condition_.state == State::kLost) return decision;
  if (team_ == nullptr) {
    if (const auto started = start(); !started) failed(started.error().message);
  }
  if (!playing()) return decision;
  toAbi(observation, seen_);
  fulbito_team_command command = room_.open(observation.wants_drawings);
  if (team_->failure().empty()) team_->decide(seen_, command);
  if (!settle()) return decision;
  room_.close(command);
  fromAbi(command, seen_.team_size, decision);
  return decision;
}

std::optional<TeamProposal> LibraryTeam::place(const PlacementRequest& request) {
  if (!playing()) return std::nullopt;
  fulbito_placement_request asked{};
  toAbi(request, asked);
  fulbito_placement placement{};
  if (team_->failure().empty()) team_->place(asked, placement);
  if (!settle()) return std::nullopt;
  return fromAbi(placement);
}

void LibraryTeam::stopped(const PlayStop& stop) {
  if (!playing() || !team_->failure().empty()) return;
  fulbito_stop notice{};
  toAbi(stop, notice);
  team_->stopped(notice);
}

void LibraryTeam::ready(const Observation& observation) {
  if (!playing() || !team_->failure().empty()) return;
  fulbito_observation seen{};
  toAbi(observation, seen);
  team_->ready(seen);
}

void LibraryTeam::ended(const MatchEnd& end) {
  if (playing() && team_->failure().empty()) team_->ended(abiOf<fulbito_end>(end));
}

std::optional<ExerciseReply> LibraryTeam::exercise(const Observation& observation, const Exercise& exercise) {
  if (!playing()) return std::nullopt;
  toAbi(observation, seen_);
  fulbito_team_command command = room_.open(observation.wants_drawings);
  fulbito_vec2 answer{};
  bool has_skill = false;
  if (team_->failure().empty())
    team_->exercise(seen_, abiOf<fulbito_exercise>(exercise), command, answer, has_skill);
  if (!settle() || !has_skill) return std::nullopt;
  ExerciseReply reply;
  room_.close(command);
  fromAbi(command, seen_.team_size, reply.command);
  reply.answer = fromAbi(answer);
  return reply;
}

std::vector<Setting> LibraryTeam::origin() const {
  std::vector<Setting> origin{{"name", name_}, {"containment", "none"}};
  if (!version_.empty()) origin.push_back({"version", version_});
  return origin;
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
  info.outside = true;
  info.make = [library = *library, log = std::move(log)](
                  const std::vector<Setting>& settings) -> Result<std::unique_ptr<Strategy>> {
    LibraryTeam::Make make = [library, log, settings] { return PluginTeam::create(library, settings, log); };
    auto team = make();
    if (!team) return tl::unexpected<Error>(team.error());
    return std::unique_ptr<Strategy>(std::make_unique<LibraryTeam>(std::move(*team), std::move(make)));
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
