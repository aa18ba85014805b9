#include "experiments/papers/localization/first_fix.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "experiments/papers/localization/estimation/sweep.hpp"

namespace fulbito::localization {
namespace {

constexpr double kDegree = math::kPi / 180;
constexpr double kFirstSweep = 45 * kDegree;
// Reaches beyond both flanks of the range, since half the cone and acos(1 / 1.05) are 30 degrees together.
constexpr double kSecondSweep = 40 * kDegree;
constexpr double kCentred = 8 * kDegree;  // with a smaller offset both flanks are in the sweep
constexpr int kMostSweeps = 5;
constexpr double kTurned = 0.1 * kDegree;
constexpr double kLeastNoise = 0.001;          // [m] noise of a counter of microseconds
constexpr int kQuarters = 4;                   // attempts in directions a quarter turn apart
constexpr int kLeastEchoes = 8;                // least number of echoes of a useful sweep
constexpr double kAlignRate = 0.9;             // [rad/s]
constexpr int kMostTicks = 60 * kControlRate;  // limit of one turn; a wall may hold the robot

/// Turns the robot by its gyro, whose bias is known.
class Turner {
 public:
  Turner(Rig& rig, double bias) : rig_(rig), bias_(bias) {}

  double heading() const { return heading_; }

  void turnTo(double heading, double rate) {
    for (int i = 0; i < kMostTicks && std::abs(heading - heading_) > kTurned; ++i)
      tick(turnRateFor(heading - heading_, rate));
    for (int i = 0; i < kControlRate / 4; ++i) tick(0.0);
  }

  /// Sweeps by `half` to both sides of `centre` [rad] and returns the echoes.
  std::vector<SweepEcho> sweep(double centre, double half, double rate) {
    turnTo(centre - half, kAlignRate);
    std::vector<SweepEcho> echoes;
    for (int i = 0; i < kMostTicks && heading_ < centre + half; ++i) {
      tick(rate);
      if (rig_.pingDue()) echoes.push_back({heading_, rig_.ping()[indexOf(Beam::kFront)]});
    }
    return echoes;
  }

 private:
  void tick(double turn_rate) {
    const InnerMotion motion = rig_.step({0.0, turn_rate});
    heading_ += (motion.turn_rate - bias_) * motion.dt;
  }

  Rig& rig_;
  double bias_;
  double heading_ = 0.0;
};

double biasAtStandstill(Rig& rig) {
  constexpr int kTicks = kStandstillPings * kTicksPerPing;
  double sum = 0.0;
  for (int i = 0; i < kTicks; ++i) sum += rig.step({}).turn_rate;
  return sum / kTicks;
}

/// Mean echo times of the sensors that hear their wall in most pings.
EchoTimes meanEchoes(Rig& rig) {
  std::array<double, kBeams.size()> sums{};
  std::array<int, kBeams.size()> counts{};
  for (int pings = 0; pings < kStandstillPings;) {
    rig.step({});
    if (!rig.pingDue()) continue;
    const EchoTimes times = rig.ping();
    for (std::size_t i = 0; i < times.size(); ++i) {
      if (times[i]) sums[i] += *times[i], ++counts[i];
    }
    ++pings;
  }
  EchoTimes means;
  for (std::size_t i = 0; i < means.size(); ++i) {
    if (counts[i] > kStandstillPings / 2) means[i] = sums[i] / counts[i];
  }
  return means;
}

int echoesOf(const std::vector<SweepEcho>& sweep) {
  int count = 0;
  for (const SweepEcho& echo : sweep) count += echo.time ? 1 : 0;
  return count;
}

/// The direction of a wall by three rules.
struct Perpendiculars {
  double fitted = 0.0, level = 0.0, shortest = 0.0;  // [rad]
};

/// Sweeps about the middle of the near-shortest echoes of the previous sweep until the middle stays.
Perpendiculars perpendicular(Turner& turner, double centre, const SweepSensor& sensor, double rate) {
  for (int i = 1;; ++i) {
    const auto sweep = turner.sweep(centre, kSecondSweep, rate);
    const double middle = levelCentre(sweep, sensor).value_or(centre);
    if (i == kMostSweeps || std::abs(middle - centre) < kCentred)
      return {fittedPerpendicular(sweep, middle, sensor), middle, shortestEcho(sweep).value_or(centre)};
    centre = middle;
  }
}

Result<void> align(Rig& rig, const SweepSensor& sensor, FirstFix& fix) {
  Turner turner(rig, fix.gyro_bias);
  const double rate = rig.rover().limits.sweep_rate;
  for (int quarter = 0; quarter < kQuarters; ++quarter) {
    const auto first = turner.sweep(quarter * math::kPi / 2, kFirstSweep, rate);
    if (echoesOf(first) < kLeastEchoes) continue;
    const Perpendiculars found = perpendicular(turner, *levelCentre(first, sensor), sensor, rate);
    turner.turnTo(found.fitted, kAlignRate);
    fix.level_centre = found.level - turner.heading();
    fix.shortest_echo = found.shortest - turner.heading();
    return {};
  }
  return fail(ErrorCode::kBadInput, "no wall answers the front sensor in any direction");
}

}  // namespace

double meanSigma(double sigma) { return sigma / std::sqrt(static_cast<double>(kStandstillPings)); }

Result<FirstFix> findStart(Rig& rig, const Room& room, double range_noise) {
  const Rover& rover = rig.rover();
  const Body body = bodyOf(rover);
  const double noise = std::max(kLeastNoise, range_noise);
  const SweepSensor sensor{rover.sonar.sonars.front().half_cone, reachOf(body, Beam::kFront),
                           kNominalEchoSpeed, noise};
  FirstFix fix;
  fix.gyro_bias = biasAtStandstill(rig);
  if (auto aligned = align(rig, sensor, fix); !aligned) return tl::unexpected<Error>(aligned.error());
  auto start = locate(room, body, meanEchoes(rig), meanSigma(noise));
  if (!start) return tl::unexpected<Error>(start.error());
  fix.start = *start;
  return fix;
}

}  // namespace fulbito::localization
