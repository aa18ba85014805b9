#pragma once

#include <string_view>

#include "bridge/team_codec.hpp"

namespace fulbito::lines {

/// Reads one reply of a team. The memory of `reply` is used again. Errors: kBadInput with the member, as in
/// "robots[1].left: not a number", or the column of a syntax error.
Result<void> readReply(std::string_view line, TeamReply& reply);

}  // namespace fulbito::lines
