#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace fulbito::app {

/// Options of `fulbito rules compare`.
struct RulesCompareOptions {
  std::string a, b;  ///< profiles or files
  std::vector<std::string> files;
  bool list = false;  ///< also list every play on which the profiles differ
  bool json = false;
};

/// Adds `compare` to the command `rules`.
CLI::App* addRulesCompare(CLI::App& rules, RulesCompareOptions& options);

/// Runs the command and returns its exit code.
int compareRules(const RulesCompareOptions& options);

}  // namespace fulbito::app
