#include <algorithm>

#include <fmt/format.h>

#include "engine/core/config/suggest.hpp"
#include "fulbito/navigation.hpp"
#include "navigation/followers/classic_follower.hpp"
#include "navigation/followers/preview_follower.hpp"
#include "navigation/interface/parameters.hpp"
#include "navigation/library/library_navigator.hpp"

namespace fulbito {

/// @{ The built-in methods. A file of its own below navigation/methods defines each of them.
NavigatorInfo straightInfo();
NavigatorInfo vectorFieldInfo();
NavigatorInfo univectorInfo();
NavigatorInfo tangentFieldInfo();
NavigatorInfo limitCycleInfo();
NavigatorInfo nearnessDiagramInfo();
NavigatorInfo hybridInfo();
NavigatorInfo hybridWithoutNdInfo();
NavigatorInfo hybridRawInfo();
NavigatorInfo bezierInfo();
NavigatorInfo bezierRawInfo();
NavigatorInfo hermiteInfo();
NavigatorInfo tangentGraphInfo();
NavigatorInfo dwaInfo();
NavigatorInfo bsplineTimeInfo();
NavigatorInfo singleCurvatureInfo();
NavigatorInfo doubleCurvatureInfo();
/// @}

namespace {

/// Entries in the order of tables.
const std::vector<NavigatorInfo>& registry() {
  static const std::vector<NavigatorInfo> entries = {
      straightInfo(),        vectorFieldInfo(),
      univectorInfo(),       tangentFieldInfo(),
      limitCycleInfo(),      nearnessDiagramInfo(),
      hybridInfo(),          hybridWithoutNdInfo(),
      hybridRawInfo(),       bezierInfo(),
      bezierRawInfo(),       hermiteInfo(),
      tangentGraphInfo(),    dwaInfo(),
      bsplineTimeInfo(),     singleCurvatureInfo(),
      doubleCurvatureInfo(),
  };
  return entries;
}

const std::vector<ParameterSpec>& common() {
  static const std::vector<ParameterSpec> specs = {
      {"follower",
       ParameterSpec::Type::kChoice,
       0.0,
       0.0,
       1.0,
       {"preview", "classic"},
       "",
       "what turns the guidance into wheel speeds: the shared preview follower or the classic univector law"},
      {"wall_escape",
       ParameterSpec::Type::kChoice,
       0.0,
       0.0,
       2.0,
       {"on", "off", "zones"},
       "",
       "on: a robot without room to turn at a wall first drives away from it; zones: the boundary rule of "
       "Jung "
       "& Lee (2015)"},
  };
  return specs;
}

/// Whether all methods share `setting`; it is then set in `choice`. Errors: kUsage for its value.
Result<bool> takeShared(const Setting& setting, NavigatorChoice& choice) {
  for (const ParameterSpec& spec : common()) {
    if (setting.name != spec.name) continue;
    const auto value = parseParameter(spec, setting.value);
    if (!value) return tl::unexpected<Error>(value.error());
    if (&spec == &common().front()) {
      choice.classic_follower = *value != 0.0;
    } else {
      choice.wall_rule = static_cast<WallRule>(static_cast<int>(*value));
    }
    return true;
  }
  return false;
}

/// The entry of a built-in method. It has no owner, since the registry lives as long as the program.
Result<std::shared_ptr<const NavigatorInfo>> builtIn(const std::string& name) {
  std::vector<std::string> names;
  for (const NavigatorInfo& info : registry()) {
    if (info.name == name) return std::shared_ptr<const NavigatorInfo>(std::shared_ptr<void>(), &info);
    names.push_back(info.name);
  }
  return fail(ErrorCode::kUsage, fmt::format("there is no navigator '{}'.{}", name, suggestion(name, names)));
}

/// The entry of a navigator of the library at `path`.
Result<std::shared_ptr<const NavigatorInfo>> loaded(const std::string& path, const std::string& name) {
  const auto library = PluginLibrary::open(path);
  if (!library) return tl::unexpected<Error>(library.error());
  return libraryNavigator(*library, name);
}

/// The choice of the entry `info` with the settings `text`, such as `clearance=0.02,follower=classic`.
Result<NavigatorChoice> choose(Result<std::shared_ptr<const NavigatorInfo>> info, const std::string& text,
                               const std::string& specification) {
  if (!info) return tl::unexpected<Error>(info.error());
  NavigatorChoice choice;
  choice.info = std::move(*info);
  choice.text = specification;
  if (!text.empty()) {
    auto settings = parseSettings(text.substr(1), specification);
    if (!settings) return tl::unexpected<Error>(settings.error());
    for (Setting& setting : *settings) {
      const auto shared = takeShared(setting, choice);
      if (!shared) return tl::unexpected<Error>(shared.error());
      if (!*shared) choice.settings.push_back(std::move(setting));
    }
  }
  // The trial reports wrong parameters before a match starts.
  const auto trial = choice.info->make(choice.settings);
  if (!trial) return tl::unexpected<Error>(trial.error());
  return choice;
}

}  // namespace

std::span<const NavigatorInfo> navigators() { return registry(); }

std::span<const ParameterSpec> commonParameters() { return common(); }

Result<NavigatorChoice> parseBuiltInNavigator(const std::string& specification) {
  const std::size_t colon = std::min(specification.find(':'), specification.size());
  return choose(builtIn(specification.substr(0, colon)), specification.substr(colon), specification);
}

Result<NavigatorChoice> parseNavigator(const std::string& specification) {
  if (!namesLibrary(specification)) return parseBuiltInNavigator(specification);
  const std::size_t colon = std::min(specification.find(':'), specification.size());
  const std::size_t name = std::min(colon + 1, specification.size());
  const std::size_t settings = std::min(specification.find(':', name), specification.size());
  return choose(loaded(specification.substr(0, colon), specification.substr(name, settings - name)),
                specification.substr(settings), specification);
}

Result<std::unique_ptr<Pilot>> makePilot(const NavigatorChoice& choice) {
  auto navigator = choice.info->make(choice.settings);
  if (!navigator) return tl::unexpected<Error>(navigator.error());
  std::unique_ptr<Follower> follower;
  if (choice.classic_follower) {
    follower = std::make_unique<ClassicFollower>();
  } else {
    follower = std::make_unique<PreviewFollower>();
  }
  return std::make_unique<Pilot>(std::move(*navigator), std::move(follower), choice.wall_rule);
}

}  // namespace fulbito
