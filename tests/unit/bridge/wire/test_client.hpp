#pragma once

#include <atomic>
#include <functional>
#include <string>
#include <thread>
#include <vector>

#include "bridge/wire/messages.hpp"
#include "bridge/wire/udp.hpp"
#include "bridge/wire/wire_settings.hpp"
#include "bridge/wire/wire_teams.hpp"
#include "tests/support/free_ports.hpp"

namespace fulbito::wire::test {

constexpr const char* kLoopback = "127.0.0.1";

/// Monotonic time [ns].
std::int64_t steadyTime();

/// Options with that clock.
OutsideOptions outsideOptions();

using fulbito::test::freePortBase;

/// A client of one server, in a thread of its own: keeps what it hears, and answers each frame.
class TestClient {
 public:
  struct Behaviour {
    std::function<std::vector<std::string>(const Vision&)> answer;  ///< datagrams of commands for a frame
    std::optional<TeamPlaces> places;                               ///< sent at each foul
  };
  TestClient(int port_base, Behaviour behaviour);
  TestClient(const TestClient&) = delete;
  TestClient& operator=(const TestClient&) = delete;
  ~TestClient() { stop(); }

  /// Ends the thread. What was heard can be read after that.
  void stop();
  const std::vector<std::string>& frames() const { return frames_; }      ///< datagrams of vision
  const std::vector<std::string>& commands() const { return commands_; }  ///< of the referee

 private:
  void run();

  Behaviour behaviour_;
  UdpReceiver vision_, referee_;
  UdpSender sender_, placements_;
  std::vector<std::string> frames_, commands_;
  std::atomic<bool> stopped_{false};
  std::thread thread_;
};

}  // namespace fulbito::wire::test
