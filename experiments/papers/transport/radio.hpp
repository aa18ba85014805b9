#pragma once

#include <cstdint>
#include <queue>
#include <vector>

#include "experiments/papers/transport/message.hpp"
#include "fulbito/report.hpp"

namespace fulbito {

/// The two robots.
enum class CarrierId : std::uint8_t { kLead, kFollower };
constexpr CarrierId other(CarrierId id) {
  return id == CarrierId::kLead ? CarrierId::kFollower : CarrierId::kLead;
}
constexpr std::size_t indexOf(CarrierId id) { return static_cast<std::size_t>(id); }

/// A period in which no message reaches a robot.
struct Outage {
  double from = 0.0;  ///< [s] first time of sending
  double to = 0.0;    ///< [s] time of sending from which messages arrive again
  bool to_lead = true;
  bool to_follower = true;
};

/// Effects of the radio on messages.
struct RadioModel {
  double loss = 0.0;   ///< share of lost messages, 0 ... 0.5
  double delay = 0.0;  ///< [s] greatest delay; delays are uniform from half of it
  std::vector<Outage> outages;

  bool ideal() const { return loss == 0.0 && delay == 0.0 && outages.empty(); }
};

/// Carries messages between two robots.
class Radio {
 public:
  Radio(const RadioModel& model, std::uint64_t seed, std::uint64_t index);

  void send(CarrierId to, const Message& message, double now);
  /// Arrival time [s] of the next message; infinity if none is on its way.
  double next() const;
  /// Removes and returns the next message.
  struct Delivery {
    CarrierId to;
    Message message;
  };
  Delivery take();

  std::size_t sent() const { return sent_; }
  std::size_t lost() const { return lost_; }

 private:
  struct Letter {
    double arrival;
    std::size_t number;  // keeps the order of messages with the same arrival time
    Delivery delivery;
  };
  struct Later {
    bool operator()(const Letter& a, const Letter& b) const {
      return a.arrival != b.arrival ? a.arrival > b.arrival : a.number > b.number;
    }
  };
  bool isLost(CarrierId to, double now);

  RadioModel model_;
  Rng random_;
  std::priority_queue<Letter, std::vector<Letter>, Later> letters_;
  std::size_t sent_ = 0;
  std::size_t lost_ = 0;
};

}  // namespace fulbito
