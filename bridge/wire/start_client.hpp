#pragma once

#include <memory>

#include "bridge/wire/client_program.hpp"
#include "bridge/wire/wire_server.hpp"

namespace fulbito::wire {

/// A client to start, and how to play with it.
struct ClientSetup {
  WireSeat seat;
  ChildOptions child;  ///< in its command, {colour} and {port_base} stand for those of the server
  WireClock clock;
  WireLog log;      ///< about the wire
  TeamLog printed;  ///< takes what the client prints
};

/// A client that runs, and the server for it alone.
struct StartedClient {
  std::shared_ptr<ClientProgram> program;
  std::shared_ptr<WireServer> server;
};

/// Starts the client in a network of its own, where the ports are those of the seat and nobody else is heard.
/// Where the system refuses that: in the machine's, at the loopback, and with ports that are free if the
/// command has {port_base}. Errors: as `Child::launch` and `WireServer::open`.
Result<StartedClient> startClient(const ClientSetup& setup);

}  // namespace fulbito::wire
