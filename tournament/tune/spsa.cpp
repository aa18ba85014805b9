#include "tournament/tune/spsa.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "engine/core/math/random.hpp"
#include "fulbito/detail/math.hpp"

namespace fulbito {
namespace {

// Spall's practical exponents of the gains, and A as a share of the iterations; A damps the first moves.
constexpr double kMoveExponent = 0.602, kPerturbationExponent = 0.101, kDamping = 0.1;
constexpr int kMostMoves = 1'000'000;
constexpr std::size_t kMostTuned = 1000;

double clamped(double share) { return std::clamp(share, 0.0, 1.0); }

/// A random direction of the iteration: 1 or -1 for each parameter.
std::vector<double> directionOf(const Spsa& spsa, int iteration) {
  Rng rng(spsa.seed, Stream::kPerturbation, static_cast<std::uint64_t>(iteration));
  std::vector<double> direction(spsa.parameters.size());
  for (double& sign : direction) sign = rng.below(2) == 0 ? -1.0 : 1.0;
  return direction;
}

Result<void> validate(const TunedParameter& p) {
  const auto bad = [&p](const std::string& what) {
    return fail(ErrorCode::kUsage, fmt::format("parameter '{}': {}", p.name, what));
  };
  if (!std::isfinite(p.high - p.low) || !(p.low < p.high)) {
    return bad(fmt::format("its limits must be two rising numbers, not {:g} and {:g}", p.low, p.high));
  }
  if (!(p.start >= p.low && p.start <= p.high)) {
    return bad(fmt::format("its start {:g} is outside {:g} ... {:g}", p.start, p.low, p.high));
  }
  if (p.whole &&
      (p.start != std::floor(p.start) || p.low != std::floor(p.low) || p.high != std::floor(p.high))) {
    return bad("it takes whole numbers only");
  }
  if (!(p.perturbation > 0.0 && p.perturbation <= 0.5)) {
    return bad(
        fmt::format("its last perturbation {:g} must be above 0 and at most half the range", p.perturbation));
  }
  if (!(p.step > 0.0 && p.step <= 100.0)) {
    return bad(fmt::format("its last step {:g} must be above 0 and at most 100", p.step));
  }
  return {};
}

}  // namespace

SpsaGain gainOf(const TunedParameter& parameter, int iteration, int iterations) {
  const double k = iteration, last = iterations, damping = kDamping * last;
  const double perturbation = parameter.perturbation * math::pow(last / k, kPerturbationExponent);
  // a_k, computed from a_last = r_end c_end^2.
  const double gain = parameter.step * parameter.perturbation * parameter.perturbation *
                      math::pow((damping + last) / (damping + k), kMoveExponent);
  return {perturbation, gain / perturbation};
}

TunePoint startOf(const Spsa& spsa) {
  TunePoint point;
  for (const TunedParameter& p : spsa.parameters) point.push_back((p.start - p.low) / (p.high - p.low));
  return point;
}

TunePair versionsAt(const Spsa& spsa, const TunePoint& point, int iteration) {
  const std::vector<double> direction = directionOf(spsa, iteration);
  TunePair pair;
  for (std::size_t i = 0; i < point.size(); ++i) {
    const double off = gainOf(spsa.parameters[i], iteration, spsa.iterations).perturbation * direction[i];
    pair.plus.push_back(clamped(point[i] + off));
    pair.minus.push_back(clamped(point[i] - off));
  }
  return pair;
}

TunePoint nextPoint(const Spsa& spsa, const TunePoint& point, int iteration, double result) {
  const std::vector<double> direction = directionOf(spsa, iteration);
  TunePoint next;
  for (std::size_t i = 0; i < point.size(); ++i) {
    const double move = gainOf(spsa.parameters[i], iteration, spsa.iterations).move;
    next.push_back(clamped(point[i] + move * result * direction[i]));
  }
  return next;
}

std::vector<TunePoint> pathOf(const Spsa& spsa, std::span<const double> results) {
  std::vector<TunePoint> path{startOf(spsa)};
  for (const double result : results) {
    path.push_back(nextPoint(spsa, path.back(), static_cast<int>(path.size()), result));
  }
  return path;
}

Result<void> validate(const Spsa& spsa) {
  if (spsa.parameters.empty() || spsa.parameters.size() > kMostTuned) {
    return fail(ErrorCode::kUsage, fmt::format("a tuning needs 1 ... {} parameters", kMostTuned));
  }
  if (spsa.iterations < 1 || spsa.iterations > kMostMoves) {
    return fail(ErrorCode::kUsage, fmt::format("a tuning has 1 ... {} iterations", kMostMoves));
  }
  for (auto p = spsa.parameters.begin(); p != spsa.parameters.end(); ++p) {
    if (auto checked = validate(*p); !checked) return checked;
    const auto same = [p](const TunedParameter& other) { return other.name == p->name; };
    if (std::any_of(spsa.parameters.begin(), p, same)) {
      return fail(ErrorCode::kUsage, fmt::format("parameter '{}' is listed twice", p->name));
    }
  }
  return {};
}

}  // namespace fulbito
