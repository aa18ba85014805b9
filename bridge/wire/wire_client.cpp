#include "bridge/wire/wire_client.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "bridge/wire/wire_settings.hpp"

namespace fulbito::wire {
namespace {

constexpr int kMostAtOnce = 1024;  // datagrams per look at a socket, so that a flood does not hold us

/// Hands on each message that waits, with its datagram. @return datagrams that are none
template <typename Read, typename Take>
int receiveAll(UdpReceiver& socket, const Read& read, const Take& take) {
  std::array<char, kLongestMessage> room{};
  int malformed = 0;
  for (int i = 0; i < kMostAtOnce; ++i) {
    const auto datagram = socket.receive(room);
    if (!datagram) break;
    auto message = read(std::string_view(room.data(), std::min(datagram->size, room.size())));
    if (message && datagram->size <= room.size()) {
      take(std::move(*message), *datagram);
    } else {
      ++malformed;
    }
  }
  return malformed;
}

}  // namespace

Result<WireListener> WireListener::open(int port_base, const std::string& interface) {
  auto vision = UdpReceiver::open({kVisionGroup, port_base + kVisionOffset}, interface);
  if (!vision) return tl::unexpected<Error>(vision.error());
  auto referee = UdpReceiver::open({kRefereeGroup, port_base + kRefereeOffset}, interface);
  if (!referee) return tl::unexpected<Error>(referee.error());
  return WireListener(std::move(*vision), std::move(*referee));
}

Heard WireListener::listen(double seconds) {
  const std::array<int, 2> sockets{vision_.number(), referee_.number()};
  waitForAny(sockets, seconds);
  Heard heard;
  std::vector<std::int64_t> frames_at, commands_at;
  heard.malformed += receiveAll(vision_, readVision, [&](Vision&& vision, const Datagram& datagram) {
    heard.frames.push_back({std::move(vision), datagram.sender, 0});
    frames_at.push_back(datagram.arrived);
  });
  // Afterwards: what the referee says just before a frame is there if the frame is.
  heard.malformed +=
      receiveAll(referee_, readRefereeCommand, [&](RefereeCommand&& command, const Datagram& datagram) {
        heard.commands.push_back(command);
        commands_at.push_back(datagram.arrived);
      });
  for (std::size_t i = 0; i < heard.frames.size(); ++i) {
    const auto later = std::upper_bound(commands_at.begin(), commands_at.end(), frames_at[i]);
    heard.frames[i].commands = static_cast<std::size_t>(later - commands_at.begin());
  }
  return heard;
}

Result<WireClient> WireClient::open(const std::string& host, int port_base, const std::string& interface) {
  auto listener = WireListener::open(port_base, interface);
  if (!listener) return tl::unexpected<Error>(listener.error());
  auto commands = UdpSender::open({host, port_base + kCommandOffset}, interface);
  if (!commands) return tl::unexpected<Error>(commands.error());
  auto placements = UdpSender::open({kRefereeGroup, port_base + kPlacementOffset}, interface);
  if (!placements) return tl::unexpected<Error>(placements.error());
  return WireClient(std::move(*listener), std::move(*commands), std::move(*placements));
}

}  // namespace fulbito::wire
