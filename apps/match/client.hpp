#pragma once

#include <string>

#include "apps/common/match_settings.hpp"
#include "bridge/wire/wire_settings.hpp"

namespace CLI {
class App;
}

namespace fulbito::app {

/// Options of `fulbito client`.
struct ClientCommand {
  MatchSettings settings;  ///< its first team is the one that plays
  std::string colour = "blue";
  std::string host = "127.0.0.1";
  int port_base = wire::kDefaultPortBase;
  std::string interface;   ///< empty: the system's choice
  int latency = 1;         ///< frames until commands act, beyond the next one
  bool stay = false;       ///< for another match after this one
  double patience = 10.0;  ///< [s]
  bool json = false;
};

/// Adds `client`.
CLI::App* addClient(CLI::App& app, ClientCommand& options);

/// Runs the command and returns its exit code.
int client(const ClientCommand& options);

}  // namespace fulbito::app
