#include "experiments/papers/transport/radio.hpp"

#include <algorithm>
#include <limits>

#include "experiments/papers/random/streams.hpp"

namespace fulbito {

Radio::Radio(const RadioModel& model, std::uint64_t seed, std::uint64_t index)
    : model_(model), random_(seed, kTransportStream, index) {}

bool Radio::isLost(CarrierId to, double now) {
  const auto cuts = [&](const Outage& outage) {
    return now >= outage.from && now < outage.to &&
           (to == CarrierId::kLead ? outage.to_lead : outage.to_follower);
  };
  if (std::any_of(model_.outages.begin(), model_.outages.end(), cuts)) return true;
  return model_.loss > 0.0 && random_.uniform() < model_.loss;
}

void Radio::send(CarrierId to, const Message& message, double now) {
  const std::size_t number = sent_++;
  if (isLost(to, now)) {
    ++lost_;
    return;
  }
  const double way = model_.delay > 0.0 ? random_.uniform(model_.delay / 2, model_.delay) : 0.0;
  letters_.push({now + way, number, {to, message}});
}

double Radio::next() const {
  return letters_.empty() ? std::numeric_limits<double>::infinity() : letters_.top().arrival;
}

Radio::Delivery Radio::take() {
  const Delivery delivery = letters_.top().delivery;
  letters_.pop();
  return delivery;
}

}  // namespace fulbito
