#include "experiments/papers/localization/first_fix.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "experiments/papers/localization/estimation/sweep.hpp"

namespace fulbito::localization {
namespace {

constexpr double kDegree = math::kPi / 180;
constexpr double kFirstSweep = 45 * kDegree;
// It reaches beyond both flanks of the range: half the cone and acos(1 / 1.05) are 30 degrees.
constexpr double kSecondSweep = 40 * kDegree;
constexpr double kCentred = 8 * kDegree;  // both flanks are in the sweep
constexpr int kMostSweeps = 5;
constexpr double kTurned = 0.1 * kDegree;
constexpr double kLeastNoise = 0.001;          // [m] a counter of microseconds has some
constexpr int kQuarters = 4;                   // turns on the spot until a wall answers
constexpr int kLeastEchoes = 8;                // in a sweep that counts
constexpr double kAlignRate = 0.9;             // [rad/s]
constexpr int kMostTicks = 60 * kControlRate;  // of one turn: a robot that a wall holds gives up

/// Turns by its gyro, whose bias it knows.
class Turner {
 public:
  Turner(Rig& rig, double bias) : rig_(rig), bias_(bias) {}

  double heading() const { return heading_; }

  void turnTo(double heading, double rate) {
    for (int i = 0; i < kMostTicks && std::abs(heading - heading_) > kTurned; ++i)
      tick(turnRateFor(heading - heading_, rate));
    for (int i = 0; i < kControlRate / 4; ++i) tick(0.0);
  }

  /// Sweeps about a heading, and turns on to its end.
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

/// Mean times of the sensors that hear their wall in most pings.
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

/// Directions of a wall by three rules.
struct Perpendiculars {
  double fitted = 0.0, level = 0.0, shortest = 0.0;  // [rad]
};

/// Sweeps about the middle of the last sweep's near-shortest echoes, until it is the middle of its own.
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
