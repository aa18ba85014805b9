#pragma once

#include <string>
#include <vector>

namespace fulbito::test {

/// The command of a Python team in examples/teams.
inline std::vector<std::string> pythonTeam(const std::string& file) {
  return {"env", "PYTHONPATH=" FULBITO_SOURCE_DIR "/sdk/python", "PYTHONDONTWRITEBYTECODE=1", FULBITO_PYTHON,
          FULBITO_SOURCE_DIR "/examples/teams/" + file};
}

/// The commands of the ports of `chaser` as programs: C++, then Python.
inline std::vector<std::vector<std::string>> ports() {
  return {{FULBITO_CHASER_PROGRAM}, pythonTeam("chaser.py")};
}

}  // namespace fulbito::test
