#include "bridge/abi/plugin_team.hpp"

#include <fmt/format.h>

#include "navigation/library/plugin_parameters.hpp"
#include "strategies/interface/team_info.hpp"

namespace fulbito {
namespace {

constexpr std::int32_t kThrown = -2000;  // stands for the result of a function that throws
constexpr std::uint32_t kMostNavigators = 256;

/// The setting `navigator`, which is removed from `settings`, or the library's default; null: it takes none.
const char* takeNavigatorName(const fulbito_library& table, std::vector<Setting>& settings,
                              std::string& memory) {
  if (table.default_navigator == nullptr) return nullptr;
  memory = table.default_navigator;
  for (const Setting& setting : settings) {
    if (setting.name == kNavigatorSetting) memory = setting.value;
  }
  std::erase_if(settings, [](const Setting& setting) { return setting.name == kNavigatorSetting; });
  return memory.c_str();
}

}  // namespace

Result<std::shared_ptr<const TeamLibrary>> TeamLibrary::open(const std::string& path) {
  auto library = PluginLibrary::open(path);
  if (!library) return tl::unexpected<Error>(library.error());
  const fulbito_library& table = (*library)->table();
  if (table.create == nullptr || table.destroy == nullptr || table.begin == nullptr ||
      table.decide == nullptr) {
    return fail(ErrorCode::kBadInput,
                fmt::format("the library '{}' has no team: its table lacks 'create', 'destroy', 'begin' or "
                            "'decide'",
                            path));
  }
  auto parameters =
      pluginParameters(table.parameters, table.parameter_count, fmt::format("the library '{}'", path));
  if (!parameters) return tl::unexpected<Error>(parameters.error());
  auto team = std::make_shared<TeamLibrary>();
  team->library = *library;
  team->parameters = std::move(*parameters);
  team->navigator_names = (*library)->extension<fulbito_navigator_names>(FULBITO_EXT_NAVIGATOR_NAMES);
  team->restarts = (*library)->extension<fulbito_restarts>(FULBITO_EXT_RESTARTS);
  team->exercises = (*library)->extension<fulbito_exercises>(FULBITO_EXT_EXERCISES);
  return team;
}

Result<std::unique_ptr<PluginTeam>> PluginTeam::create(std::shared_ptr<const TeamLibrary> library,
                                                       const std::vector<Setting>& settings, PluginLog log) {
  const fulbito_library& table = library->table();
  const std::string name = library->library->path();
  std::vector<Setting> own = settings;
  std::string memory;
  const char* navigator = takeNavigatorName(table, own, memory);
  const auto values = pluginValues(library->parameters, own, name);
  if (!values) return tl::unexpected<Error>(values.error());
  auto host = std::make_unique<PluginHost>(table.name, std::move(log));
  std::unique_ptr<PluginTeam> team(new PluginTeam(std::move(library), std::move(host)));
  const fulbito_host* services = team->host_->table();
  team->self_ = callForeign<void*>(*team->library_->library, nullptr,
                                   [&] { return table.create(services, values->data(), navigator); });
  if (team->self_ == nullptr) {
    const std::string& reason = team->host_->lastLine();
    return fail(ErrorCode::kUsage, fmt::format("the team of '{}' refuses to be made{}{}", name,
                                               reason.empty() ? "" : ": ", reason));
  }
  return team;
}

PluginTeam::~PluginTeam() {
  if (self_ != nullptr) callForeign(*library_->library, 0, [this] { return table().destroy(self_), 0; });
}

bool PluginTeam::succeeded(const char* function, std::int32_t code) {
  if (code == 0) return true;
  const std::string what = code == kThrown ? fmt::format("'{}' throws", function)
                                           : fmt::format("'{}' fails with {}", function, code);
  failure_ = fmt::format("{}: {}", table().name, what);
  return false;
}

bool PluginTeam::begin(const fulbito_match_info& info, const fulbito_curve_widening& widening,
                       std::string rules_text) {
  host_->know(widening);
  host_->begin(info.seed, std::move(rules_text));
  return succeeded("begin",
                   callForeign(*library_->library, kThrown, [&] { return table().begin(self_, &info); }));
}

bool PluginTeam::decide(const fulbito_observation& seen, fulbito_team_command& command) {
  return succeeded("decide", callForeign(*library_->library, kThrown,
                                         [&] { return table().decide(self_, &seen, &command); }));
}

bool PluginTeam::place(const fulbito_placement_request& request, fulbito_placement& placement) {
  const auto* functions = library_->restarts;
  if (functions == nullptr || functions->place == nullptr) return true;
  return succeeded("place", callForeign(*library_->library, kThrown,
                                        [&] { return functions->place(self_, &request, &placement); }));
}

bool PluginTeam::stopped(const fulbito_stop& stop) {
  const auto* functions = library_->restarts;
  if (functions == nullptr || functions->stopped == nullptr) return true;
  return succeeded(
      "stopped", callForeign(*library_->library, kThrown, [&] { return functions->stopped(self_, &stop); }));
}

bool PluginTeam::ready(const fulbito_observation& seen) {
  const auto* functions = library_->restarts;
  if (functions == nullptr || functions->ready == nullptr) return true;
  return succeeded("ready",
                   callForeign(*library_->library, kThrown, [&] { return functions->ready(self_, &seen); }));
}

bool PluginTeam::ended(const fulbito_end& end) {
  const auto* functions = library_->restarts;
  if (functions == nullptr || functions->ended == nullptr) return true;
  return succeeded("ended",
                   callForeign(*library_->library, kThrown, [&] { return functions->ended(self_, &end); }));
}

bool PluginTeam::exercise(const fulbito_observation& seen, const fulbito_exercise& task,
                          fulbito_team_command& command, fulbito_vec2& answer, bool& has_skill) {
  const auto* functions = library_->exercises;
  has_skill = functions != nullptr && functions->exercise != nullptr;
  if (!has_skill) return true;
  const std::int32_t code = callForeign(*library_->library, kThrown, [&] {
    return functions->exercise(self_, &seen, &task, &command, &answer);
  });
  has_skill = code != FULBITO_NO_SKILL;
  return !has_skill || succeeded("exercise", code);
}

std::vector<std::string> PluginTeam::navigatorNames() {
  std::vector<std::string> names;
  const auto* functions = library_->navigator_names;
  if (functions == nullptr || functions->name == nullptr) return names;
  for (std::uint32_t i = 0; i < kMostNavigators; ++i) {
    const char* name =
        callForeign<const char*>(*library_->library, nullptr, [&] { return functions->name(self_, i); });
    if (name == nullptr) break;
    names.emplace_back(name);
  }
  return names;
}

}  // namespace fulbito
