#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "engine/core/system/descriptor.hpp"
#include "fulbito/detail/values.hpp"

namespace fulbito::wire {

/// Where datagrams go to or come from: an address of IPv4 and a port.
struct UdpAddress {
  std::string host;  ///< such as "224.0.0.1"; as a place to listen, empty: all
  int port = 0;      ///< 1 ... 65535
};

/// Sends datagrams to one address.
class UdpSender {
 public:
  /// @param interface  address of the interface for multicast; empty: the system's choice
  /// @param socket     to use, such as one of another network; none: a new one
  /// Errors: kUsage for what is no address, kIo if there is no way to it, kMachine.
  static Result<UdpSender> open(const UdpAddress& to, const std::string& interface, Descriptor socket = {});
  /// False if the system did not take it.
  bool send(std::string_view datagram);

 private:
  explicit UdpSender(Descriptor socket) : socket_(std::move(socket)) {}
  Descriptor socket_;
};

/// A datagram that came.
struct Datagram {
  std::size_t size = 0;      ///< [bytes] of it, also if the room was too small
  std::uint64_t sender = 0;  ///< address and port
  /// [ns] By a clock of the system, to tell what of several sockets came first. In the first moment after
  /// the first socket of the machine asks for it, Linux gives the time of the look instead.
  std::int64_t arrived = 0;
};

/// Receives datagrams at one port. Never waits.
class UdpReceiver {
 public:
  /// @param at  a multicast group, which is joined and shared with others; or an address of this machine or
  ///            none, which is taken for this socket alone
  /// @param interface  as of `UdpSender::open`
  /// @param socket     as of `UdpSender::open`
  /// Errors: kUsage for what is no address; kIo if the port is taken or the group cannot be joined; kMachine.
  static Result<UdpReceiver> open(const UdpAddress& at, const std::string& interface, Descriptor socket = {});
  /// The next datagram into `room`; empty: none is there.
  std::optional<Datagram> receive(std::span<char> room);
  /// For `waitForAny`.
  int number() const { return socket_.number(); }

 private:
  explicit UdpReceiver(Descriptor socket) : socket_(std::move(socket)) {}
  Descriptor socket_;
};

/// Waits until a datagram is there for any of the sockets, at most so long. A signal may end the wait early.
void waitForAny(std::span<const int> sockets, double seconds);

}  // namespace fulbito::wire
