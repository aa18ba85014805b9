#pragma once

#include <string>
#include <vector>

#include "bridge/process/child.hpp"

namespace fulbito::test {

/// The program that misbehaves, next to this test's program or as the environment names it.
std::string misbehavingTeam();

/// A child that must start.
Child launched(const ChildOptions& options);

/// Options for a shell's command line.
ChildOptions shell(const std::string& line);

/// All that the child writes until it closes its output, at most `seconds` after its last word.
std::string allOutput(Child& child, double seconds = 20.0);

/// Whether the list of layers has this one.
bool has(const std::vector<std::string>& layers, const std::string& name);

/// What children have left: descriptors, processes, files, control groups. Looks at processes whose command
/// line holds `mark`, and at a folder of temporary files that only this test uses.
class Leftovers {
 public:
  explicit Leftovers(std::string mark);
  /// Notes the keepers that run now, whose control groups must go.
  void noteKeepers();
  /// Kills those that were noted.
  void killKeepers() const;
  /// One line for each thing that is left; empty: nothing.
  std::string found() const;

 private:
  std::string mark_;
  std::size_t descriptors_;
  std::vector<int> keepers_;
};

/// Number of living processes whose command line holds the mark.
int processesWith(const std::string& mark);

}  // namespace fulbito::test
