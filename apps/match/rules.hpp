#pragma once

#include <string>

#include "apps/match/rules_compare.hpp"

namespace CLI {
class App;
}

namespace fulbito::app {

/// Options of `fulbito rules`.
struct RulesOptions {
  std::string show;   ///< preset or file to print
  std::string check;  ///< file to check
  RulesCompareOptions compare;
};

/// Adds `rules` with its subcommands `show`, `check` and `compare`.
CLI::App* addRules(CLI::App& app, RulesOptions& options);

/// Runs the given subcommand and returns its exit code.
int rules(const RulesOptions& options);

}  // namespace fulbito::app
