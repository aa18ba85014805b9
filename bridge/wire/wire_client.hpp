#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "bridge/wire/messages.hpp"
#include "bridge/wire/udp.hpp"

namespace fulbito::wire {

/// What a client has heard.
struct Heard {
  std::optional<Vision> vision;          ///< the newest frame; older ones that waited are left out
  int skipped = 0;                       ///< of those
  int malformed = 0;                     ///< datagrams that are no messages
  std::vector<RefereeCommand> commands;  ///< all, in their order
};

/// The other end of the wire: hears vision and the referee of any server of the protocol, ours or the
/// league's, and sends commands and placements.
class WireClient {
 public:
  /// @param host       address of the server
  /// @param port_base  port of vision; the others follow as a server's do
  /// @param interface  address of the interface for multicast; empty: the system's choice
  /// Errors: as `UdpSender::open` and `UdpReceiver::open`.
  static Result<WireClient> open(const std::string& host, int port_base, const std::string& interface);

  /// All that has come, after a wait of at most `seconds` if nothing has.
  Heard listen(double seconds);
  /// @{ False if the system did not take it.
  bool send(const Packet& packet) { return commands_.send(datagramOf(packet)); }
  bool send(const TeamPlaces& places) { return placements_.send(datagramOf(places)); }
  /// @}

 private:
  WireClient(UdpReceiver vision, UdpReceiver referee, UdpSender commands, UdpSender placements)
      : vision_(std::move(vision)),
        referee_(std::move(referee)),
        commands_(std::move(commands)),
        placements_(std::move(placements)) {}

  UdpReceiver vision_, referee_;
  UdpSender commands_, placements_;
};

}  // namespace fulbito::wire
