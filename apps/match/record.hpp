#pragma once

#include <optional>
#include <string>

#include "apps/common/match_settings.hpp"
#include "bridge/wire/wire_settings.hpp"

namespace CLI {
class App;
}

namespace fulbito::app {

/// Options of `fulbito record`.
struct RecordCommand {
  std::string file;
  MatchSettings settings;  ///< rules and models; its teams are names
  int port_base = wire::kDefaultPortBase;
  std::string interface;          ///< empty: the system's choice
  double wait = 0.0;              ///< [s] for the first frame; 0: for ever
  double patience = 10.0;         ///< [s] without vision
  std::optional<double> seconds;  ///< [s] longest recording
  bool until_halt = false;
  bool force = false;
  bool json = false;
};

/// Adds `record`.
CLI::App* addRecord(CLI::App& app, RecordCommand& options);

/// Runs the command and returns its exit code.
int record(const RecordCommand& options);

}  // namespace fulbito::app
