#pragma once

#include <string>
#include <vector>

namespace fulbito::test {

/// How to run a team of examples/teams that is written in Python.
inline std::vector<std::string> pythonTeam(const std::string& file) {
  return {"env", "PYTHONPATH=" FULBITO_SOURCE_DIR "/sdk/python", "PYTHONDONTWRITEBYTECODE=1", FULBITO_PYTHON,
          FULBITO_SOURCE_DIR "/examples/teams/" + file};
}

/// How to run the ports of `chaser` as programs: C++, then Python.
inline std::vector<std::vector<std::string>> ports() {
  return {{FULBITO_CHASER_PROGRAM}, pythonTeam("chaser.py")};
}

}  // namespace fulbito::test
