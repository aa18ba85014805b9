#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "fulbito/navigation.hpp"
#include "fulbito/strategy.hpp"
#include "fulbito/team.h"
#include "navigation/library/plugin_host.hpp"
#include "navigation/library/plugin_library.hpp"

namespace fulbito {

/// A shared library with a team, checked. It stays loaded as long as the object lives.
struct TeamLibrary {
  /// Errors: as `PluginLibrary::open`; kBadInput if it has no team or wrong parameters.
  static Result<std::shared_ptr<const TeamLibrary>> open(const std::string& path);

  std::shared_ptr<const PluginLibrary> library;              ///< the file
  std::vector<ParameterSpec> parameters;                     ///< parameters of the team
  const fulbito_navigator_names* navigator_names = nullptr;  ///< null: the team uses no navigators
  const fulbito_restarts* restarts = nullptr;                ///< null: the team takes no part in restarts
  const fulbito_exercises* exercises = nullptr;              ///< null: the team has no skills for drills

  const fulbito_library& table() const { return library->table(); }  ///< the library's table
};

/// One team of a library. Every call runs in the expected floating-point mode and restores the thread's mode.
/// A call of a function that the library lacks succeeds without effect. After a failure, this team takes no
/// more calls.
class PluginTeam {
 public:
  /// Errors: kUsage for unknown settings, values out of range, or if the library refuses.
  static Result<std::unique_ptr<PluginTeam>> create(std::shared_ptr<const TeamLibrary> library,
                                                    const std::vector<Setting>& settings, PluginLog log);
  PluginTeam(const PluginTeam&) = delete;
  PluginTeam& operator=(const PluginTeam&) = delete;
  ~PluginTeam();

  /// @{ The functions of the interface. @return false after a failure
  bool begin(const fulbito_match_info& info, const fulbito_curve_widening& widening, std::string rules_text);
  bool decide(const fulbito_observation& seen, fulbito_team_command& command);
  bool place(const fulbito_placement_request& request, fulbito_placement& placement);
  bool stopped(const fulbito_stop& stop);
  bool ready(const fulbito_observation& seen);
  bool ended(const fulbito_end& end);
  /// `has_skill` becomes false if the team lacks it.
  bool exercise(const fulbito_observation& seen, const fulbito_exercise& task, fulbito_team_command& command,
                fulbito_vec2& answer, bool& has_skill);
  /// @}
  /// Specifications of the navigators that the team uses, at most 256.
  std::vector<std::string> navigatorNames();
  /// The last failure in words, with the team's name; empty: none.
  const std::string& failure() const { return failure_; }
  /// The library's table.
  const fulbito_library& table() const { return library_->table(); }

 private:
  PluginTeam(std::shared_ptr<const TeamLibrary> library, std::unique_ptr<PluginHost> host)
      : library_(std::move(library)), host_(std::move(host)) {}
  bool succeeded(const char* function, std::int32_t code);

  std::shared_ptr<const TeamLibrary> library_;
  std::unique_ptr<PluginHost> host_;
  void* self_ = nullptr;
  std::string failure_;
};

}  // namespace fulbito
