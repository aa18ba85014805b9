#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace fulbito::app {

/// What `fulbito rules compare` was asked.
struct RulesCompareOptions {
  std::string a, b;  ///< profiles or files
  std::vector<std::string> files;
  bool list = false;  ///< also every play on which the two differ
  bool json = false;
};

/// Adds `compare` to the command `rules`.
CLI::App* addRulesCompare(CLI::App& rules, RulesCompareOptions& options);

/// Runs it and returns its exit code.
int compareRules(const RulesCompareOptions& options);

}  // namespace fulbito::app
