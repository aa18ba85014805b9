#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "bridge/wire/messages.hpp"
#include "bridge/wire/udp.hpp"

namespace fulbito::wire {

/// A frame of vision, and who sent it.
struct HeardFrame {
  Vision vision;
  std::uint64_t sender = 0;  ///< as `Datagram::sender`
  std::size_t commands = 0;  ///< of `Heard::commands`, those that came before it
};

/// What has come from a server.
struct Heard {
  std::vector<HeardFrame> frames;        ///< of vision, in their order
  std::vector<RefereeCommand> commands;  ///< in their order
  int malformed = 0;                     ///< datagrams that are no messages
};

/// Hears vision and the referee of any server of the protocol, ours or the league's.
class WireListener {
 public:
  /// @param port_base  port of vision; the others follow as a server's do
  /// @param interface  address of the interface for multicast; empty: the system's choice
  /// Errors: as `UdpReceiver::open`.
  static Result<WireListener> open(int port_base, const std::string& interface);

  /// All that has come, after a wait of at most `seconds` if nothing has.
  Heard listen(double seconds);

 private:
  WireListener(UdpReceiver vision, UdpReceiver referee)
      : vision_(std::move(vision)), referee_(std::move(referee)) {}

  UdpReceiver vision_, referee_;
};

/// The other end of the wire: hears a server, and sends commands and placements.
class WireClient {
 public:
  /// @param host  address of the server; the rest as of `WireListener::open`
  /// Errors: as `UdpSender::open` and `UdpReceiver::open`.
  static Result<WireClient> open(const std::string& host, int port_base, const std::string& interface);

  /// As `WireListener::listen`.
  Heard listen(double seconds) { return listener_.listen(seconds); }
  /// @{ False if the system did not take it.
  bool send(const Packet& packet) { return commands_.send(datagramOf(packet)); }
  bool send(const TeamPlaces& places) { return placements_.send(datagramOf(places)); }
  /// @}

 private:
  WireClient(WireListener listener, UdpSender commands, UdpSender placements)
      : listener_(std::move(listener)), commands_(std::move(commands)), placements_(std::move(placements)) {}

  WireListener listener_;
  UdpSender commands_, placements_;
};

}  // namespace fulbito::wire
