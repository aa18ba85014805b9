#pragma once

#include <string>

#include "engine/core/result.hpp"
#include "referee/detector_rules.hpp"

namespace fulbito {

/// The rules of a match as numbers. Defaults: the rule book's 3v3 game (IEEE VSSS rules).
struct Rules {
  std::string name = "vsss-3v3";
  std::string field = "vsss-3v3";  ///< preset of the field that it is played on
  int team_size = 3;
  double half_seconds = 300.0;  ///< [s] of play
  GoalRules goal;
  StuckRules stuck;
  AreaRules areas;
  KeeperRules keeper;
  FoulRules fouls;
};

}  // namespace fulbito
