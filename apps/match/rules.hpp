#pragma once

#include <string>

#include "apps/match/rules_compare.hpp"

namespace CLI {
class App;
}

namespace fulbito::app {

/// What `fulbito rules` was asked.
struct RulesOptions {
  std::string show;   ///< preset or file whose numbers are printed
  std::string check;  ///< file that is checked
  RulesCompareOptions compare;
};

/// Adds `rules` with its parts `show`, `check` and `compare`.
CLI::App* addRules(CLI::App& app, RulesOptions& options);

/// Runs the part that was given and returns its exit code.
int rules(const RulesOptions& options);

}  // namespace fulbito::app
