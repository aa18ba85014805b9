#include "bridge/wire/udp.hpp"

#include <algorithm>
#include <arpa/inet.h>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace fulbito::wire {
namespace {

constexpr int kReceiveBuffer = 1 << 20;  // [bytes] as far as the system allows

std::string reason() { return std::generic_category().message(errno); }

Result<in_addr> addressOf(const std::string& text, const char* what) {
  in_addr address{};
  if (!text.empty() && ::inet_pton(AF_INET, text.c_str(), &address) != 1) {
    return fail(ErrorCode::kUsage, fmt::format("{} '{}' is no address such as 127.0.0.1", what, text));
  }
  return address;
}

bool isGroup(in_addr address) { return IN_MULTICAST(ntohl(address.s_addr)); }

sockaddr_in endOf(in_addr address, int port) {
  sockaddr_in end{};
  end.sin_family = AF_INET;
  end.sin_addr = address;
  end.sin_port = htons(static_cast<std::uint16_t>(port));
  return end;
}

template <typename Value>
bool setOption(int socket, int level, int name, const Value& value) {
  return ::setsockopt(socket, level, name, &value, sizeof value) == 0;
}

Result<Descriptor> socketOr(Descriptor ready) {
  if (ready.isOpen()) return ready;
  Descriptor socket(::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
  if (!socket.isOpen()) return fail(ErrorCode::kMachine, "no socket: " + reason());
  return socket;
}

tl::unexpected<Error> unreachable(const UdpAddress& address) {
  return fail(ErrorCode::kIo,
              fmt::format("{}:{}: {}; name an interface, such as 127.0.0.1, or add a route for multicast",
                          address.host.empty() ? "0.0.0.0" : address.host, address.port, reason()));
}

std::int64_t arrivalOf(const msghdr& message) {
  const cmsghdr* header = CMSG_FIRSTHDR(&message);
  if (header == nullptr || header->cmsg_level != SOL_SOCKET || header->cmsg_type != SCM_TIMESTAMPNS) return 0;
  timespec time{};
  std::memcpy(&time, CMSG_DATA(header), sizeof time);
  return std::int64_t{time.tv_sec} * 1'000'000'000 + time.tv_nsec;
}

}  // namespace

Result<UdpSender> UdpSender::open(const UdpAddress& to, const std::string& interface, Descriptor ready) {
  const auto address = addressOf(to.host, "address");
  if (!address) return tl::unexpected<Error>(address.error());
  const auto way = addressOf(interface, "interface");
  if (!way) return tl::unexpected<Error>(way.error());
  auto socket = socketOr(std::move(ready));
  if (!socket) return tl::unexpected<Error>(socket.error());
  if (!interface.empty() && !setOption(socket->number(), IPPROTO_IP, IP_MULTICAST_IF, *way)) {
    return unreachable({interface, to.port});
  }
  // Connected, so that a missing route shows now and not at the first datagram.
  const sockaddr_in end = endOf(*address, to.port);
  if (::connect(socket->number(), reinterpret_cast<const sockaddr*>(&end), sizeof end) != 0) {
    return unreachable(to);
  }
  return UdpSender(std::move(*socket));
}

bool UdpSender::send(std::string_view datagram) {
  // A client's port that nobody listens at makes one call fail, and the next one works.
  for (int attempts = 0; attempts < 2; ++attempts) {
    if (::send(socket_.number(), datagram.data(), datagram.size(), MSG_NOSIGNAL) >= 0) return true;
    if (errno != ECONNREFUSED && errno != EINTR) return false;
  }
  return false;
}

Result<UdpReceiver> UdpReceiver::open(const UdpAddress& at, const std::string& interface, Descriptor ready) {
  const auto address = addressOf(at.host, "address");
  if (!address) return tl::unexpected<Error>(address.error());
  const auto way = addressOf(interface, "interface");
  if (!way) return tl::unexpected<Error>(way.error());
  auto socket = socketOr(std::move(ready));
  if (!socket) return tl::unexpected<Error>(socket.error());
  const bool group = isGroup(*address);
  setOption(socket->number(), SOL_SOCKET, SO_RCVBUF, kReceiveBuffer);
  setOption(socket->number(), SOL_SOCKET, SO_TIMESTAMPNS, 1);
  if (group) setOption(socket->number(), SOL_SOCKET, SO_REUSEADDR, 1);
  const sockaddr_in end = endOf(*address, at.port);
  if (::bind(socket->number(), reinterpret_cast<const sockaddr*>(&end), sizeof end) != 0) {
    return fail(ErrorCode::kIo, fmt::format("port {}: {}", at.port, reason()));
  }
  const ip_mreq membership{*address, *way};
  if (group && !setOption(socket->number(), IPPROTO_IP, IP_ADD_MEMBERSHIP, membership))
    return unreachable(at);
  return UdpReceiver(std::move(*socket));
}

std::optional<Datagram> UdpReceiver::receive(std::span<char> room) {
  sockaddr_in from{};
  iovec text{room.data(), room.size()};
  alignas(cmsghdr) std::array<char, CMSG_SPACE(sizeof(timespec))> more{};
  msghdr message{};
  ssize_t size = -1;
  do {
    message = {&from, sizeof from, &text, 1, more.data(), more.size(), 0};
    size = ::recvmsg(socket_.number(), &message, MSG_TRUNC);
  } while (size < 0 && errno == EINTR);
  if (size < 0) return std::nullopt;
  return Datagram{static_cast<std::size_t>(size),
                  std::uint64_t{from.sin_addr.s_addr} << 16 | std::uint64_t{from.sin_port},
                  arrivalOf(message)};
}

void waitForAny(std::span<const int> sockets, double seconds) {
  std::vector<pollfd> waiting;
  waiting.reserve(sockets.size());
  for (const int socket : sockets) waiting.push_back({socket, POLLIN, 0});
  const double time = std::max(seconds, 0.0);
  const timespec limit{static_cast<time_t>(time), static_cast<long>((time - std::floor(time)) * 1e9)};
  ::ppoll(waiting.data(), waiting.size(), &limit, nullptr);
}

}  // namespace fulbito::wire
