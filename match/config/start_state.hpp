#pragma once

#include <string>
#include <string_view>

#include "engine/core/base/result.hpp"
#include "match/config/match_config.hpp"
#include "referee/state/placement.hpp"
#include "referee/state/scoreboard.hpp"

namespace fulbito {

/// A placement from which a match starts, with score and time.
struct StartState {
  Placement placement;
  Scoreboard scoreboard;
};

/// Reads a start state. Tables, all positions in the world's frame (blue defends the goal at -x):
/// [ball] position (required), velocity; any number of [[robot]] team = "blue" | "yellow", number,
/// position (all required), heading or heading_deg; [match] blue, yellow (score), period, play_seconds.
/// Robots that are not listed are not on the field. Errors: kIo; kBadInput as `file:line: table.key ...`.
Result<StartState> loadStartState(const std::string& file);

/// The same, checked against a match: its rules have all robots, all bodies are inside the field without
/// overlap, and the elapsed play time fits into a half. Ignores `match.start`.
Result<StartState> loadStartState(const std::string& file, const MatchConfig& match);

/// The same from text; `origin` stands for the file name in errors.
Result<StartState> parseStartState(std::string_view text, const std::string& origin);

/// A TOML file that `parseStartState` reads back to the same bits.
std::string toToml(const StartState& start);

}  // namespace fulbito
