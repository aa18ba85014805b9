#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "bridge/abi/frames.hpp"
#include "bridge/abi/plugin_team.hpp"
#include "bridge/abi/team_values.hpp"

namespace fulbito {

/// The other side of `AbiCodec`: runs a team of a shared library and answers its messages.
class TeamHost {
 public:
  /// @param settings  the team's settings; those of the first message come after them
  TeamHost(std::shared_ptr<const TeamLibrary> library, std::vector<Setting> settings, PluginLog log);

  /// Answers one whole message. A reply is appended to `out`, which keeps its memory; notices have none. Once
  /// warm, a decision allocates nothing. Errors: kBadInput if the message is wrong or comes before the first
  /// one; kUsage if the team refuses its settings; kBadInput in the team's words if a function of it fails.
  Result<void> answer(std::string_view message, std::string& out);

 private:
  Result<void> hello(FrameReader& frame, std::string& out);
  bool begin(FrameReader& frame, std::string& out);
  bool decide(FrameReader& frame, std::string& out);
  bool place(FrameReader& frame, std::string& out);
  bool exercise(FrameReader& frame, std::string& out);
  bool notice(FrameReader& frame);
  bool handle(FrameReader& frame, std::string& out);

  std::shared_ptr<const TeamLibrary> library_;
  std::vector<Setting> settings_;
  PluginLog log_;
  std::unique_ptr<PluginTeam> team_;  ///< null before the first message
  CommandRoom room_;
  fulbito_observation seen_{};  ///< observation of the present tick
};

}  // namespace fulbito
