#include "experiments/papers/capture/random_captures.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "experiments/papers/capture/fig18.hpp"
#include "experiments/papers/random/streams.hpp"
#include "fulbito/models.hpp"
#include "fulbito/report.hpp"

namespace fulbito::capture {
namespace {

constexpr std::uint64_t kBlock = 64;  // number of draws that the threads share at a time
constexpr std::uint64_t kDrawsPerCapture = 40;

/// A draw: a capture, or the reason why there is none.
struct Draw {
  std::optional<RandomCapture> capture;
  CaptureRefusal refusal = CaptureRefusal::kNoLine;
};

Result<Draw> drawn(const PursuitSetup& setup) {
  const auto result = pursue(setup);
  if (!result) return tl::unexpected<Error>(result.error());
  Draw draw;
  draw.refusal = result->answer.refusal;
  if (!result->answer.plan) return draw;
  RandomCapture capture;
  capture.index = setup.index, capture.setup = setup, capture.plan = *result->answer.plan;
  capture.time = result->time;
  capture.gap_error = result->gap - setup.gap;
  capture.aside = result->aside;
  capture.speed_error = result->speed - norm(setup.object.velocity);
  capture.heading_error = math::wrapAngle(result->heading - math::angleOf(setup.object.velocity));
  capture.largest_rim = result->largest_rim;
  capture.touched = result->touched;
  draw.capture = std::move(capture);
  return draw;
}

/// Takes draws in their order until there are `count` captures.
void collect(std::vector<Draw>& draws, std::size_t count, RandomCaptures& all) {
  for (Draw& draw : draws) {
    if (all.captures.size() == count) return;
    if (draw.capture) {
      all.captures.push_back(std::move(*draw.capture));
    } else {
      ++all.refused[static_cast<std::size_t>(draw.refusal)];
    }
  }
}

}  // namespace

bool RandomCapture::caught() const {
  return !touched && std::abs(gap_error) <= kGapTolerance && std::abs(aside) <= kAsideTolerance &&
         std::abs(speed_error) <= kSpeedTolerance && std::abs(heading_error) <= kHeadingTolerance;
}

PursuitSetup randomTask(const RobotModel& robot, double free_gap, const SightingNoise& noise,
                        std::uint64_t seed, std::uint64_t index) {
  Rng rng(seed, kCaptureTaskStream, index);
  PursuitSetup setup;
  setup.robot = robot;
  setup.start = {{0.0, 0.0}, rng.uniform(-math::kPi, math::kPi)};
  const double range = rng.uniform(1.5, 4.0);
  const Vec2 place = math::unit(rng.uniform(-math::kPi, math::kPi)) * range;
  const double heading = rng.uniform(-math::kPi, math::kPi);
  setup.object = {place, math::unit(heading) * rng.uniform(0.15, 0.40), 0.0};
  setup.gap = free_gap + halfLengths(robot);
  setup.limits = limitsWithoutTouch(robot);
  setup.noise = noise;
  setup.together = true;
  setup.seed = seed;
  setup.index = index;
  return setup;
}

Result<RandomCaptures> captureAtRandom(const RobotModel& robot, double free_gap, const SightingNoise& noise,
                                       std::uint64_t seed, int count, int jobs, const Progress& progress) {
  RandomCaptures all;
  const auto wanted = static_cast<std::size_t>(count);
  for (std::uint64_t first = 0; all.captures.size() < wanted && first < kDrawsPerCapture * wanted;
       first += kBlock) {
    std::vector<Draw> draws(kBlock);
    WorkProgress work(
        [&](std::size_t, std::size_t) { return !progress || progress(all.captures.size(), wanted); }, kBlock);
    const auto done = parallelFor(jobs, kBlock, work, [&](std::size_t i) -> Result<void> {
      auto draw = drawn(randomTask(robot, free_gap, noise, seed, first + i));
      if (!draw) return tl::unexpected<Error>(draw.error());
      draws[i] = std::move(*draw);
      return {};
    });
    if (!done) return tl::unexpected<Error>(done.error());
    collect(draws, wanted, all);
  }
  return all;
}

Result<std::vector<PursuitResult>> captureAgain(const PursuitSetup& setup, std::size_t count, int jobs,
                                                const Progress& progress) {
  std::vector<PursuitResult> results(count);
  WorkProgress work(progress, count);
  const auto done = parallelFor(jobs, count, work, [&](std::size_t i) -> Result<void> {
    PursuitSetup other = setup;
    other.index += i;
    auto result = pursue(other);
    if (!result) return tl::unexpected<Error>(result.error());
    results[i] = std::move(*result);
    return {};
  });
  if (!done) return tl::unexpected<Error>(done.error());
  return results;
}

}  // namespace fulbito::capture
