#pragma once

#include <string>
#include <string_view>

#include "bridge/team_codec.hpp"

/// Words of the line protocol that several of its files use.
namespace fulbito::lines {

/// Name and version of the protocol, as in the handshake.
inline std::string protocolName() { return "fulbito-team/" + std::to_string(kTeamProtocol); }

/// Types of requests, in the order of `TeamReply::Kind`.
inline constexpr std::string_view kRequestTypes[] = {"hello", "begin", "decide", "place", "exercise"};

/// Type of a request.
constexpr std::string_view typeOf(TeamReply::Kind kind) {
  return kRequestTypes[static_cast<std::size_t>(kind)];
}

}  // namespace fulbito::lines
