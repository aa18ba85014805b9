#include <iostream>

#include "tests/unit/bridge/lines/port_commands.hpp"
#include "tests/unit/bridge/lines/session.hpp"

/// Prints the sample session: the simulator's messages, and the answers of examples/teams/trio.py.
int main() {
  using namespace fulbito::test;
  const PipedProgram trio(pythonTeam("trio.py"));
  for (const std::string& line : sessionLines()) {
    std::cout << "> " << line;
    if (line.find("\"id\":") == std::string::npos) {
      trio.send(line);
    } else {
      std::cout << "< " << answerOf(trio, line) << '\n';
    }
  }
}
