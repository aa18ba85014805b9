#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "engine/core/base/result.hpp"
#include "referee/rules/detector_rules.hpp"
#include "referee/rules/period_rules.hpp"
#include "referee/rules/restart_rules.hpp"

namespace fulbito {

/// The rules of a match as numbers. Defaults: the rule book's 3v3 game (IEEE VSSS rules).
struct Rules {
  std::string name = "vsss-3v3";
  std::string field = "vsss-3v3";  ///< preset of the field that it is played on, or a file
  int team_size = 3;
  double half_seconds = 300.0;  ///< [s] of play; the key of [periods]
  PeriodRules periods;
  ShootOutRules shoot_out;
  WalkOverRules walk_over;
  RestartRules restart;
  KickOffRules kick_off;
  FreeBallRules free_ball;
  FreeKickRules free_kick;
  PenaltyRules penalty;
  GoalKickRules goal_kick;
  GoalRules goal;
  StuckRules stuck;
  AreaRules areas;
  KeeperRules keeper;
  FoulRules fouls;
};

/// Reads a profile: the name of a preset or the path of a TOML file. A key that the file lacks keeps the
/// default of `Rules`; a missing name becomes the file's. Errors: kUsage for an unknown name (with a
/// suggestion), kIo for a file that cannot be read, kBadInput as `file:line: table.key ...` with the range.
/// A field that is a relative path counts from the profile's folder and must load.
Result<Rules> loadRules(const std::string& name_or_file);
/// The same from text; `origin` stands for the file name in errors. Opens no field.
Result<Rules> parseRules(std::string_view text, const std::string& origin);
/// Checks ranges and consistency; the error names the key.
Result<void> validate(const Rules& rules);
/// All keys with units, meanings and sources, as a TOML file that `parseRules` reads back to the same bits.
std::string toToml(const Rules& rules);
/// The embedded profiles.
std::vector<std::string> rulesPresetNames();
/// The whole text of one, with the keys that its file leaves to the defaults. Errors: kUsage, with a
/// suggestion.
Result<std::string> rulesPresetText(const std::string& name);

}  // namespace fulbito
