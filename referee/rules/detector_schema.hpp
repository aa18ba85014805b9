#pragma once

#include "engine/core/config/schema.hpp"
#include "fulbito/referee.hpp"

/// The keys of the detectors' tables in a rules profile, with ranges and sources.
namespace fulbito {

/// @{ The keys of one table, bound to `value`.
Schema schemaOf(GoalRules& value);    ///< [goal]
Schema schemaOf(StuckRules& value);   ///< [stuck]
Schema schemaOf(AreaRules& value);    ///< [areas]
Schema schemaOf(KeeperRules& value);  ///< [keeper]
Schema schemaOf(FoulRules& value);    ///< [fouls]
/// @}

/// Switches off every call but goals, as far as the ranges allow: a ball is stuck after 600 s.
void callOnlyGoals(Rules& rules);

/// @{ The first flaw of a table: a value outside its limits, or two values in conflict.
std::optional<Flaw> findFlaw(const GoalRules& rules);
std::optional<Flaw> findFlaw(const StuckRules& rules);
std::optional<Flaw> findFlaw(const AreaRules& rules);
std::optional<Flaw> findFlaw(const KeeperRules& rules);
std::optional<Flaw> findFlaw(const FoulRules& rules);
/// @}

}  // namespace fulbito
