#pragma once

#include <string>

#include "fulbito/strategy.hpp"

namespace fulbito::lines {

/// Appends the members of a match's information, with a comma before each. The tables have the keys of the
/// configuration files, by the same schemas.
void appendMembers(std::string& out, const MatchInfo& info);

}  // namespace fulbito::lines
