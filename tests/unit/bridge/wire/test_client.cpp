#include "tests/unit/bridge/wire/test_client.hpp"

#include <array>
#include <chrono>

namespace fulbito::wire::test {
namespace {

template <typename T>
T opened(Result<T> result) {
  if (!result) throw std::runtime_error(result.error().message);
  return std::move(*result);
}

}  // namespace

std::int64_t steadyTime() {
  return std::chrono::duration_cast<std::chrono::nanoseconds>(
             std::chrono::steady_clock::now().time_since_epoch())
      .count();
}

OutsideOptions outsideOptions() {
  OutsideOptions options;
  options.clock = steadyTime;
  return options;
}

TestClient::TestClient(int port_base, Behaviour behaviour)
    : behaviour_(std::move(behaviour)),
      vision_(opened(UdpReceiver::open({kVisionGroup, port_base + kVisionOffset}, kLoopback))),
      referee_(opened(UdpReceiver::open({kRefereeGroup, port_base + kRefereeOffset}, kLoopback))),
      sender_(opened(UdpSender::open({kLoopback, port_base + kCommandOffset}, kLoopback))),
      placements_(opened(UdpSender::open({kRefereeGroup, port_base + kPlacementOffset}, kLoopback))),
      thread_([this] { run(); }) {}

void TestClient::stop() {
  stopped_ = true;
  if (thread_.joinable()) thread_.join();
}

void TestClient::run() {
  std::array<char, 65536> room{};
  // What was sent before the end is there, so that a last look misses nothing.
  for (bool last = false; !last;) {
    last = stopped_;
    waitForAny(std::array{vision_.number(), referee_.number()}, 0.01);
    while (const auto datagram = referee_.receive(room)) {
      commands_.emplace_back(room.data(), datagram->size);
      const auto command = readRefereeCommand(commands_.back());
      if (behaviour_.places && command && command->foul < Foul::kStop) {
        placements_.send(datagramOf(*behaviour_.places));
      }
    }
    while (const auto datagram = vision_.receive(room)) {
      frames_.emplace_back(room.data(), datagram->size);
      const auto vision = readVision(frames_.back());
      if (!vision || !behaviour_.answer) continue;
      for (const std::string& answer : behaviour_.answer(*vision)) sender_.send(answer);
    }
  }
}

}  // namespace fulbito::wire::test
