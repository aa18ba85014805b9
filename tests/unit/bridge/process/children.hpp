#pragma once

#include <string>
#include <vector>

#include "bridge/process/child.hpp"

namespace fulbito::test {

/// The program that misbehaves: beside this test's program, or named by the environment.
std::string misbehavingTeam();

/// A child whose start must succeed.
Child launched(const ChildOptions& options);

/// Options for a shell's command line.
ChildOptions shell(const std::string& line);

/// All output of the child until it closes it, or is silent for `seconds`.
std::string allOutput(Child& child, double seconds = 20.0);

/// Whether the list of layers has this one.
bool has(const std::vector<std::string>& layers, const std::string& name);

/// Finds what children have left: descriptors, processes, files, control groups. Looks at processes whose
/// command line contains `mark`, and at a folder of temporary files that only this test uses.
class Leftovers {
 public:
  explicit Leftovers(std::string mark);
  /// Notes the running keepers, whose control groups must disappear.
  void noteKeepers();
  /// Kills the noted keepers.
  void killKeepers() const;
  /// One line per thing that is left; empty: nothing.
  std::string found() const;

 private:
  std::string mark_;
  std::size_t descriptors_;
  std::vector<int> keepers_;
};

/// Number of living processes whose command line holds the mark.
int processesWith(const std::string& mark);

}  // namespace fulbito::test
