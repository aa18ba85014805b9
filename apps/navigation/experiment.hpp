#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace CLI {
class App;
}  // namespace CLI

namespace fulbito::app {

/// Options of `fulbito experiment`.
struct ExperimentCommand {
  std::string name;  ///< name of an experiment, "list" or "all"
  std::uint64_t seed = 1;
  int jobs = 0;
  std::vector<std::string> settings;  ///< "name=value" for each setting
  std::string out = "fulbito-out";
  bool json = false;
};

/// Adds the command with its options, unless the program is built without experiments.
void addExperiment(CLI::App& app, ExperimentCommand& command);

/// Runs the command and returns its exit code.
int experiment(const ExperimentCommand& command);

}  // namespace fulbito::app
