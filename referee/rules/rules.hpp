#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "engine/core/base/result.hpp"
#include "referee/rules/detector_rules.hpp"
#include "referee/rules/period_rules.hpp"
#include "referee/rules/restart_rules.hpp"

namespace fulbito {

/// The rules of a match. Defaults: the rule book's 3v3 game (IEEE VSSS rules).
struct Rules {
  std::string name = "vsss-3v3";
  std::string field = "vsss-3v3";  ///< field preset or file
  int team_size = 3;
  double half_seconds = 300.0;  ///< [s] play time of a half; a key of [periods]
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

/// Reads a profile: a preset's name or the path of a TOML file. Missing keys keep the defaults of `Rules`; a
/// missing name becomes the file's. A relative path of a field counts from the profile's folder; the field
/// must load. Errors: kUsage for an unknown name (with a suggestion), kIo for an unreadable file, kBadInput
/// as `file:line: table.key ...` with the range.
Result<Rules> loadRules(const std::string& name_or_file);
/// The same from text; `origin` stands for the file name in errors. Opens no field.
Result<Rules> parseRules(std::string_view text, const std::string& origin);
/// Checks ranges and consistency; the error names the key.
Result<void> validate(const Rules& rules);
/// All keys with units, meanings and sources, as a TOML file that `parseRules` reads back to the same bits.
std::string toToml(const Rules& rules);
/// The embedded profiles.
std::vector<std::string> rulesPresetNames();
/// The text of an embedded profile with all keys, defaults included. Errors: kUsage, with a suggestion.
Result<std::string> rulesPresetText(const std::string& name);

}  // namespace fulbito
