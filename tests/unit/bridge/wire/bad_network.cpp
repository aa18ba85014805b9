#include "tests/unit/bridge/wire/bad_network.hpp"

#include <array>
#include <stdexcept>

#include "bridge/wire/wire_settings.hpp"
#include "tests/unit/bridge/wire/test_client.hpp"

namespace fulbito::wire::test {

BadNetwork::BadNetwork(int server, int clients, double loss) : loss_(loss) {
  add({kVisionGroup, server + kVisionOffset}, {kVisionGroup, clients + kVisionOffset});
  add({kRefereeGroup, server + kRefereeOffset}, {kRefereeGroup, clients + kRefereeOffset});
  add({kRefereeGroup, clients + kPlacementOffset}, {kRefereeGroup, server + kPlacementOffset});
  add({kLoopback, clients + kCommandOffset}, {kLoopback, server + kCommandOffset});
  thread_ = std::thread([this] { run(); });
}

BadNetwork::~BadNetwork() {
  stopped_ = true;
  thread_.join();
}

void BadNetwork::add(const UdpAddress& from, const UdpAddress& to) {
  auto receiver = UdpReceiver::open(from, kLoopback);
  auto sender = UdpSender::open(to, kLoopback);
  if (!receiver || !sender) throw std::runtime_error("a port of the test is taken");
  ways_.push_back({std::move(*receiver), std::move(*sender), {}});
}

void BadNetwork::pass(Way& way, std::string datagram) {
  if (happens(loss_)) return;
  if (happens(loss_)) {
    way.late.push_back(std::move(datagram));
    return;
  }
  way.to.send(datagram);
  if (happens(loss_ / 2.0)) way.to.send(datagram);
  while (!way.late.empty() && happens(0.5)) {
    way.to.send(way.late.front());
    way.late.pop_front();
  }
}

void BadNetwork::run() {
  std::vector<int> sockets;
  for (const Way& way : ways_) sockets.push_back(way.from.number());
  std::array<char, 65536> room{};
  while (!stopped_) {
    waitForAny(sockets, 0.01);
    for (Way& way : ways_) {
      while (const auto datagram = way.from.receive(room)) pass(way, {room.data(), datagram->size});
    }
  }
}

}  // namespace fulbito::wire::test
