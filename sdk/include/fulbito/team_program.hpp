// Runs a team of `fulbito/team.hpp` as a program over the line protocol (docs/team-protocol.md): the macro
// `FULBITO_TEAM_PROGRAM(MyTeam)` is the whole `main`. Needs the standard library and POSIX only.
//
// What the team prints goes to standard error, since standard output belongs to the protocol.
#pragma once

#include <cstdio>
#include <exception>
#include <memory>
#include <string>
#include <string_view>
#include <unistd.h>

#include "fulbito/detail/lines/conversation.hpp"
#include "fulbito/detail/lines/pipes.hpp"
#include "fulbito/team.hpp"

namespace fulbito::team::program {

/// Plays until the input ends. @return the program's exit code
template <typename TeamClass>
int run() {
  const int out = takeOutput();
  if (out < 0) return 1;
  try {
    Pipes pipes(STDIN_FILENO, out);
    Conversation conversation(std::make_unique<TeamClass>());
    std::string answer;
    for (std::string_view line; pipes.next(line);) {
      answer.clear();
      conversation.take(line, answer);
      if (!pipes.send(answer)) return 1;
    }
  } catch (const std::exception& error) {
    std::fprintf(stderr, "the team has thrown an exception: %s\n", error.what());
    return 1;
  }
  return 0;
}

}  // namespace fulbito::team::program

/// Defines `main` as the program of a team class, which needs a constructor without arguments.
#define FULBITO_TEAM_PROGRAM(TeamClass) \
  int main() { return ::fulbito::team::program::run<TeamClass>(); }
