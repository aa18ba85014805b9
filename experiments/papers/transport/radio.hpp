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

/// A time in which no message to a robot arrives.
struct Outage {
  double from = 0.0;  ///< [s] sent from then on
  double to = 0.0;    ///< [s] and before then
  bool to_lead = true;
  bool to_follower = true;
};

/// What the radio between the robots does to messages.
struct RadioModel {
  double loss = 0.0;   ///< share of messages that get lost, 0 ... 0.5
  double delay = 0.0;  ///< [s] longest time on the way; it is uniform from half of it on
  std::vector<Outage> outages;

  bool ideal() const { return loss == 0.0 && delay == 0.0 && outages.empty(); }
};

/// Carries messages between two robots.
class Radio {
 public:
  Radio(const RadioModel& model, std::uint64_t seed, std::uint64_t index);

  void send(CarrierId to, const Message& message, double now);
  /// When the next message arrives [s]; infinity: none is on its way.
  double next() const;
  /// Takes the next message off.
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
    std::size_t number;  // keeps the order of messages that arrive at one instant
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
