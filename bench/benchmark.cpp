#include "bench/benchmark.hpp"

#include <algorithm>
#include <chrono>
#include <ctime>
#include <thread>

#include <fmt/format.h>

#include "bench/bare.hpp"
#include "bench/scenes.hpp"
#include "engine/core/base/assert.hpp"
#include "engine/core/system/stop_request.hpp"
#include "fulbito/detail/math.hpp"

namespace fulbito {
namespace {

constexpr int kEpisodeTicks = 600;
constexpr Stream kStartStream{6};  // a stream that no simulation draws from, see `Stream`

struct Row {
  PhysicsProfile physics;
  Load load;
};

PhysicsProfile physicsAt(int rate_hz) {
  PhysicsProfile physics;
  physics.substeps = rate_hz / physics.control_rate;
  physics.contact_depth = 0.0;  // for equal work, because the bare loop splits no steps
  return physics;
}

std::vector<Row> allRows() {
  std::vector<Row> rows;
  for (int rate : {60, 120, 240}) {
    for (Load load : {Load::kRandom, Load::kHold, Load::kChase}) rows.push_back({physicsAt(rate), load});
  }
  return rows;
}

// A start with robots scattered over a grid and the ball between them. Different starts lead to different
// numbers of contacts.
WorldConfig episodeStart(const Row& row, int episode) {
  WorldConfig config = matchScene(3, row.physics);
  Rng rng(static_cast<std::uint64_t>(episode), kStartStream);
  for (std::size_t i = 0; i < config.robots.size(); ++i) {
    const Vec2 cell{-0.45 + 0.45 * static_cast<double>(i % 3), i < 3 ? -0.3 : 0.3};
    config.robots[i].pose = {cell + Vec2{rng.uniform(-0.1, 0.1), rng.uniform(-0.1, 0.1)},
                             rng.uniform(-math::kPi, math::kPi)};
  }
  config.balls[0].position = {rng.uniform(-0.6, 0.6), rng.uniform(-0.08, 0.08)};
  return config;
}

// Wrappers that give the engine and the bare loop the same three methods.
class EngineRun {
 public:
  EngineRun(const Row& row, int episode)
      : world_(make(row, episode)), driver_(row.load, 6, row.physics.control_rate, episode) {}
  void tick() { world_.step(driver_.drive(world_.state())); }
  int contacts() const { return world_.touchingPairs(); }

 private:
  static World make(const Row& row, int episode) {
    Result<World> world = World::create(episodeStart(row, episode));
    FULBITO_DEMAND(world.has_value());
    return std::move(*world);
  }
  World world_;
  SceneDriver driver_;
};

class BareRun {
 public:
  BareRun(const Row& row, int episode)
      : loop_(episodeStart(row, episode)), driver_(row.load, 6, row.physics.control_rate, episode) {}
  void tick() { loop_.step(driver_.drive(loop_.robots(), loop_.ball())); }
  int contacts() const { return loop_.touchingPairs(); }

 private:
  BareLoop loop_;
  SceneDriver driver_;
};

double threadCpuSeconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// CPU time of one episode [s], without the time to create the world.
template <typename Run>
double timeEpisode(const Row& row, int episode) {
  if (stopRequested()) return 0.0;
  Run run(row, episode);
  const double start = threadCpuSeconds();
  for (int tick = 0; tick < kEpisodeTicks; ++tick) run.tick();
  return threadCpuSeconds() - start;
}

template <typename Run>
double meanContacts(const Row& row, int episodes) {
  double sum = 0.0;
  for (int episode = 0; episode < episodes && !stopRequested(); ++episode) {
    Run run(row, episode);
    for (int tick = 0; tick < kEpisodeTicks; ++tick) {
      run.tick();
      sum += run.contacts();
    }
  }
  return sum / (static_cast<double>(episodes) * kEpisodeTicks);
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
}

BenchScene measure(const Row& row, const BenchOptions& options) {
  std::vector<double> engine, bare, ratios;
  for (int i = 0; i < options.repetitions; ++i) {
    double engine_time = 0.0, bare_time = 0.0;
    // Alternates after each episode, so that other load on the machine affects both.
    for (int episode = 0; episode < options.episodes; ++episode) {
      engine_time += timeEpisode<EngineRun>(row, episode);
      bare_time += timeEpisode<BareRun>(row, episode);
    }
    engine.push_back(engine_time);
    bare.push_back(bare_time);
    ratios.push_back(bare_time / engine_time);
  }
  const double simulated = options.episodes * kEpisodeTicks * row.physics.controlPeriod();
  return {"3v3",
          row.physics.control_rate * row.physics.substeps,
          nameOf(row.load),
          simulated / median(engine),
          simulated / median(bare),
          median(ratios),
          *std::min_element(ratios.begin(), ratios.end()),
          meanContacts<EngineRun>(row, options.episodes),
          meanContacts<BareRun>(row, options.episodes)};
}

// Wall time [s] in which each of `threads` threads runs the same episodes.
template <typename Run>
double wallTime(const Row& row, int episodes, int threads) {
  const auto work = [&] {
    for (int episode = 0; episode < episodes; ++episode) timeEpisode<Run>(row, episode);
  };
  const auto start = std::chrono::steady_clock::now();
  std::vector<std::thread> others;
  for (int i = 1; i < threads; ++i) others.emplace_back(work);
  work();
  for (std::thread& other : others) other.join();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

template <typename Run>
double scalingOf(const Row& row, int episodes) {
  const double one = wallTime<Run>(row, episodes, 1), two = wallTime<Run>(row, episodes, 2);
  return 2.0 * one / two;
}

BenchScaling measureScaling(const Row& row, const BenchOptions& options) {
  const int episodes = std::max(1, options.episodes / 4);
  std::vector<double> engine, bare, ratios;
  for (int i = 0; i < 2 * options.repetitions + 1; ++i) {
    // Engine and bare loop alternate in which goes first.
    if (i % 2 == 0) engine.push_back(scalingOf<EngineRun>(row, episodes));
    bare.push_back(scalingOf<BareRun>(row, episodes));
    if (i % 2 == 1) engine.push_back(scalingOf<EngineRun>(row, episodes));
    ratios.push_back(engine.back() / bare.back());
  }
  return {row.physics.control_rate * row.physics.substeps, nameOf(row.load), median(engine), median(bare),
          median(ratios)};
}

}  // namespace

Result<BenchReport> runBenchmark(const BenchOptions& options) {
  BenchReport report;
  report.signature = sceneSignature();
  for (const Row& row : allRows()) report.scenes.push_back(measure(row, options));
  if (options.scaling) {
    for (Load load : {Load::kRandom, Load::kHold, Load::kChase})
      report.scaling.push_back(measureScaling({physicsAt(120), load}, options));
  }
  // After a stop request, skipped runs make all figures invalid.
  if (stopRequested()) return fail(ErrorCode::kInterrupted, "interrupted");
  return report;
}

std::string toTable(const BenchReport& report) {
  std::string text = fmt::format("{:<6}{:>6} {:<8}{:>10}{:>10}{:>8}{:>8}{:>10}{:>10}\n", "scene", "Hz",
                                 "load", "engine x", "bare x", "ratio", "min", "contacts", "bare");
  for (const BenchScene& s : report.scenes) {
    text += fmt::format("{:<6}{:>6} {:<8}{:>10.0f}{:>10.0f}{:>8.3f}{:>8.3f}{:>10.3f}{:>10.3f}\n", s.name,
                        s.rate_hz, s.load, s.engine_x_realtime, s.bare_x_realtime, s.ratio, s.ratio_min,
                        s.engine_contacts, s.bare_contacts);
  }
  if (!report.scaling.empty()) text += "two worlds on two threads\n";
  for (const BenchScaling& s : report.scaling) {
    text += fmt::format("{:<6}{:>6} {:<8}{:>10.2f}{:>10.2f}{:>8.3f}\n", "3v3", s.rate_hz, s.load, s.engine,
                        s.bare, s.ratio);
  }
  text += fmt::format("signature {:016x}\n", report.signature);
  return text;
}

}  // namespace fulbito
