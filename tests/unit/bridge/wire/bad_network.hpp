#pragma once

#include <atomic>
#include <cstdint>
#include <deque>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include "bridge/wire/udp.hpp"

namespace fulbito::wire::test {

/// A network between a server at one first port and clients at another, which loses, doubles, delays and
/// reorders datagrams both ways.
class BadNetwork {
 public:
  /// @param loss  share of datagrams that never arrive, 0 ... 1; half as many come twice, and as many late
  BadNetwork(int server, int clients, double loss);
  BadNetwork(const BadNetwork&) = delete;
  BadNetwork& operator=(const BadNetwork&) = delete;
  ~BadNetwork();

 private:
  struct Way {
    UdpReceiver from;
    UdpSender to;
    std::deque<std::string> late;  ///< each comes after a later datagram
  };
  void add(const UdpAddress& from, const UdpAddress& to);
  void pass(Way& way, std::string datagram);
  void run();
  bool happens(double share) { return std::uniform_real_distribution<>(0.0, 1.0)(random_) < share; }

  double loss_;
  std::mt19937 random_{20};
  std::vector<Way> ways_;
  std::atomic<bool> stopped_{false};
  std::thread thread_;
};

}  // namespace fulbito::wire::test
