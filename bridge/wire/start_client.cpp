#include "bridge/wire/start_client.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

#include <fmt/format.h>

namespace fulbito::wire {
namespace {

constexpr std::string_view kColour = "{colour}";
constexpr std::string_view kPortBase = "{port_base}";
constexpr int kFirstFree = 21'000;  // first port base that is tried where several servers share a network
constexpr int kPortsOfServer = 3;   // in a row
constexpr const char* kLoopback = "127.0.0.1";

void replaceAll(std::string& word, std::string_view what, const std::string& by) {
  for (std::size_t at = 0; (at = word.find(what, at)) != std::string::npos; at += by.size()) {
    word.replace(at, what.size(), by);
  }
}

ChildOptions childOf(const ClientSetup& setup, int port_base) {
  ChildOptions child = setup.child;
  child.limits.network = true;
  for (std::string& word : child.command) {
    replaceAll(word, kColour, nameOf(setup.seat.colour));
    replaceAll(word, kPortBase, std::to_string(port_base));
  }
  return child;
}

StartedClient startedOf(const ClientSetup& setup, Child&& child, std::unique_ptr<WireServer>&& server) {
  StartedClient started;
  started.program = std::make_shared<ClientProgram>(std::move(child), setup.printed);
  started.server = std::move(server);
  return started;
}

Result<StartedClient> startInOwnNetwork(const ClientSetup& setup) {
  ChildOptions options = childOf(setup, setup.seat.settings.port_base);
  options.sockets = WireServer::kSockets;
  auto child = Child::launch(options);
  if (!child) return tl::unexpected<Error>(child.error());
  auto server = WireServer::open(setup.seat.settings, setup.clock, setup.log, child->takeSockets());
  if (!server) return tl::unexpected<Error>(server.error());
  return startedOf(setup, std::move(*child), std::move(*server));
}

/// Errors: kIo if no ports are free.
Result<std::unique_ptr<WireServer>> openFree(const ClientSetup& setup, WireSettings settings) {
  for (int port = kFirstFree;; port += kPortsOfServer) {
    settings.port_base = port;
    auto server = WireServer::open(settings, setup.clock, setup.log);
    if (server || server.error().code != ErrorCode::kIo || port + kPortsOfServer > kLargestPortBase) {
      return server;
    }
  }
}

Result<StartedClient> startAtLoopback(const ClientSetup& setup) {
  WireSettings settings = setup.seat.settings;
  if (settings.interface.empty()) settings.interface = kLoopback;
  const auto& words = setup.child.command;
  const bool told = std::any_of(words.begin(), words.end(),
                                [](const std::string& word) { return word.find(kPortBase) != word.npos; });
  auto server = told ? openFree(setup, settings) : WireServer::open(settings, setup.clock, setup.log);
  if (!server) return tl::unexpected<Error>(server.error());
  auto child = Child::launch(childOf(setup, (*server)->settings().port_base));
  if (!child) return tl::unexpected<Error>(child.error());
  return startedOf(setup, std::move(*child), std::move(*server));
}

}  // namespace

Result<StartedClient> startClient(const ClientSetup& setup) {
  auto started = startInOwnNetwork(setup);
  const bool refused = !started && started.error().code == ErrorCode::kUsage && !setup.child.sandbox_required;
  return refused ? startAtLoopback(setup) : std::move(started);
}

}  // namespace fulbito::wire
