#pragma once

#include "engine/core/config/schema.hpp"
#include "fulbito/referee.hpp"

/// The keys of a rules profile by table, with ranges and sources.
namespace fulbito {

/// One table of a profile, bound to the rules.
struct RulesTable {
  std::string name;
  std::string doc;
  Schema schema;
};

/// All tables in the order of printing. Valid while `rules` lives.
std::vector<RulesTable> tablesOf(Rules& rules);

/// The first flaw of a profile: a value outside its limits, or two values in conflict.
std::optional<Flaw> findFlaw(const Rules& rules);

}  // namespace fulbito
