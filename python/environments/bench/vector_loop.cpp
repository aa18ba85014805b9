// Steps a vector of matches with random actions and prints the steps per second: the loop of
// docs/environments.md without Python.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <memory>
#include <string>
#include <vector>

#include "engine/core/math/random.hpp"
#include "python/environments/match/environment.hpp"
#include "python/environments/vector_environment.hpp"

namespace fulbito {
namespace {

constexpr double kSeconds = 3.0;  // of measuring
constexpr int kRounds = 5;        // the fastest counts

/// One agent beside and against `team`; "agents": all six robots are agents.
Result<MatchTask> taskOf(const std::string& team) {
  const bool all = team == "agents";
  auto config = all ? MatchConfig::standard("idle", "idle") : MatchConfig::standard(team, team);
  if (!config) return tl::unexpected<Error>(config.error());
  auto navigator = parseNavigator("straight");
  if (!navigator) return tl::unexpected<Error>(navigator.error());
  MatchTask task;
  task.match = *config;
  task.navigator = *navigator;
  for (std::size_t i = 0; i < 3; ++i) task.agents[0][i] = task.agents[1][i] = all;
  task.agents[0][0] = true;
  task.start = StartForm::kRandom;
  task.seconds = 30.0;
  return task;
}

/// The arrays of a caller.
struct Arrays {
  explicit Arrays(const EpisodeShape& shape, std::size_t rows)
      : observations(4 * rows * shape.agents * shape.observation),
        numbers(4 * rows * (shape.agents * (1 + shape.terms.size()) + shape.figures.size())),
        flags(8 * rows * shape.agents) {
    const std::size_t agents = rows * shape.agents;
    float* seen = observations.data();
    double* number = numbers.data();
    std::uint8_t* flag = flags.data();
    for (auto* pair : {&all, &some}) {
      for (VectorRows& to : *pair) {
        to = {seen, number, flag, flag + agents, number + agents, number + agents * (1 + shape.terms.size())};
        seen += agents * shape.observation;
        number += agents * (1 + shape.terms.size()) + rows * shape.figures.size();
        flag += 2 * agents;
      }
    }
  }
  std::vector<float> observations;
  std::vector<double> numbers;
  std::vector<std::uint8_t> flags;
  std::array<VectorRows, 2> all, some;
};

/// Steps per second of the clock, and per second of one core's time.
struct Speed {
  double clock = 0.0, core = 0.0;
};

Speed speedOf(VectorEnvironment& vector) {
  const std::size_t width = vector.size() * vector.shape().agents * vector.shape().action;
  std::vector<std::vector<float>> actions(64, std::vector<float>(width));
  Rng random(1, Stream::kWheelCommands);
  for (auto& all : actions) {
    for (float& action : all) action = static_cast<float>(random.uniform(-1.0, 1.0));
  }
  using Clock = std::chrono::steady_clock;
  const auto begin = Clock::now();
  const std::clock_t worked = std::clock();
  std::size_t rounds = 0;
  double seconds = 0.0;
  while (seconds < kSeconds) {
    if (auto done = vector.step(actions[rounds % actions.size()]); !done) {
      std::fprintf(stderr, "%s\n", done.error().message.c_str());
      std::exit(1);
    }
    ++rounds;
    seconds = std::chrono::duration<double>(Clock::now() - begin).count();
  }
  const auto steps = static_cast<double>(rounds * vector.size());
  return {steps / seconds, steps * CLOCKS_PER_SEC / static_cast<double>(std::clock() - worked)};
}

int measure(std::size_t envs, int threads, const std::string& team) {
  std::vector<std::unique_ptr<EpisodeSource>> sources;
  for (std::size_t i = 0; i < envs; ++i) {
    auto task = taskOf(team);
    if (!task) return std::fprintf(stderr, "%s\n", task.error().message.c_str());
    auto source = MatchEnvironment::create(*task);
    if (!source) return std::fprintf(stderr, "%s\n", source.error().message.c_str());
    sources.push_back(std::move(*source));
  }
  auto vector = VectorEnvironment::create(std::move(sources), {threads, Autoreset::kNextStep, false});
  if (!vector) return std::fprintf(stderr, "%s\n", vector.error().message.c_str());
  Arrays arrays((*vector)->shape(), envs);
  (*vector)->use({arrays.all, arrays.some, {}});
  for (std::size_t i = 0; i < envs; ++i) (*vector)->seed(i, i);
  if (auto begun = (*vector)->reset({}); !begun)
    return std::fprintf(stderr, "%s\n", begun.error().message.c_str());
  Speed best;
  for (int i = 0; i < kRounds; ++i) {
    const Speed now = speedOf(**vector);
    best = {std::max(best.clock, now.clock), std::max(best.core, now.core)};
  }
  std::printf("%.0f env steps/s, %.0f per second of one core: %zu environments, %d threads, %s\n", best.clock,
              best.core, envs, (*vector)->threads(), team.c_str());
  return 0;
}

}  // namespace
}  // namespace fulbito

int main(int count, char** words) {
  const std::size_t envs = count > 1 ? std::strtoul(words[1], nullptr, 10) : 256;
  const int threads = count > 2 ? std::atoi(words[2]) : 0;
  return fulbito::measure(envs, threads, count > 3 ? words[3] : "random");
}
