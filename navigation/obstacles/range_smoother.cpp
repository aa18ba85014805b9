#include "navigation/obstacles/range_smoother.hpp"

#include <algorithm>
#include <cmath>

#include "fulbito/detail/math.hpp"

namespace fulbito {
namespace {

constexpr std::size_t kRecent = 4;   // number of readings
constexpr int kLoud = 6;             // least number of echoes in the window that count as one surface
constexpr int kSilent = 2;           // greatest number of echoes in the window that count as noise in silence
constexpr double kScatter = 0.0085;  // [m] about the line; 99 % of windows with 5 mm noise are below
constexpr double kFastest = 0.009;   // [m] greatest change of the range per tick

}  // namespace

std::optional<SmoothRange> RangeSmoother::add(const RangeReading& reading, const Pose2& pose) {
  ring_[count_++ % kReadings] = {pose.position + outOfFrame(math::unit(pose.heading), reading.mount.position),
                                 pose.heading + reading.mount.heading, reading.heard, reading.range};
  if (count_ < kReadings) return {};
  const auto heard = static_cast<int>(
      std::count_if(ring_.begin(), ring_.end(), [](const Item& each) { return each.heard; }));
  if (heard < kLoud && heard > kSilent) return {};
  SmoothRange mean;
  mean.heard = heard >= kLoud;
  mean.half_cone = reading.half_cone;
  double turn = 0.0, age = 0.0;
  int used = 0;
  for (std::size_t i = 0; i < kReadings; ++i) {
    if (item(i).heard != mean.heard) continue;
    mean.apex += item(i).apex, mean.range += item(i).range, ++used;
    turn += math::wrapAngle(item(i).heading - item(0).heading), age += static_cast<double>(i);
  }
  mean.apex = mean.apex / used, mean.range /= used;
  mean.axis = math::unit(item(0).heading + turn / used);
  if (mean.heard && !agree(mean, age / used, used)) return {};
  return mean;
}

bool RangeSmoother::agree(const SmoothRange& mean, double mean_age, int heard) const {
  double square = 0.0, product = 0.0, rest = 0.0;
  for (std::size_t i = 0; i < kReadings; ++i) {
    if (!item(i).heard) continue;
    const double age = static_cast<double>(i) - mean_age;
    square += age * age, product += age * (item(i).range - mean.range);
  }
  const double slope = product / square;
  for (std::size_t i = 0; i < kReadings; ++i) {
    if (!item(i).heard) continue;
    const double off = item(i).range - mean.range - slope * (static_cast<double>(i) - mean_age);
    rest += off * off;
  }
  return rest <= kScatter * kScatter * (heard - 2) && std::abs(slope) <= kFastest;
}

std::optional<double> RangeSmoother::recent() const {
  double sum = 0.0;
  int heard = 0;
  for (std::size_t i = 0; i < std::min(kRecent, count_); ++i) {
    if (item(i).heard) sum += item(i).range, ++heard;
  }
  if (heard < 2) return {};
  return sum / heard;
}

}  // namespace fulbito
