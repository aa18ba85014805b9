#pragma once

#include <functional>
#include <string>
#include <vector>

#include "bridge/team_codec.hpp"
#include "tests/support/piped_team.hpp"

namespace fulbito::test {

/// One message of the sample session, and the function by which a codec writes it.
struct SessionMessage {
  bool request = true;  ///< it gets an answer
  std::function<void(TeamCodec& codec, std::uint64_t id, std::string& out)> write;
};

/// The simulator's messages in the sample session (docs/team-protocol-session.txt): every kind of message,
/// with values of an invented match, so that changes of the physics do not change them.
std::vector<SessionMessage> sessionMessages();

/// The same as lines of the protocol, with their ends.
std::vector<std::string> sessionLines();

/// The answer of a program to a line, without its end.
std::string answerOf(const PipedProgram& program, const std::string& line);

}  // namespace fulbito::test
