// Plays whole matches over all pairings of the built-in teams in both formats and watches for what only shows
// in the long run: a match that does not end, a state that is not finite, memory that grows.
//
//   soak MATCHES [HALF_SECONDS] [JOBS]
//
// The memory's growth counts from the end of the first round over all pairings. Exit code 0: all is well; 1:
// not.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <mutex>
#include <string>
#include <unistd.h>
#include <vector>

#include "engine/core/system/worker_threads.hpp"
#include "fulbito/match.hpp"

namespace {

using namespace fulbito;

constexpr double kAllowedGrowth = 5.0;  // [MiB]
constexpr Tick kLongest = 10;           // a match that is this many times as long as its halves has stalled

double residentMebibytes() {
  std::ifstream file("/proc/self/statm");
  long total = 0, resident = 0;
  file >> total >> resident;
  return static_cast<double>(resident) * static_cast<double>(sysconf(_SC_PAGESIZE)) / (1024.0 * 1024.0);
}

template <typename T>
T get(Result<T> result) {
  if (result) return std::move(*result);
  std::fprintf(stderr, "soak: %s\n", result.error().message.c_str());
  std::exit(1);
}

class Soak {
 public:
  Soak(std::size_t matches, double half_seconds) : matches_(matches) {
    for (const char* rules : {"vsss-3v3", "vsss-5v5"}) {
      MatchConfig config;
      config.rules = get(loadRules(rules));
      config.rules.half_seconds = half_seconds;
      config.field = get(loadField(config.rules.field));
      config.robot = get(loadRobot("vsss"));
      config.physics = get(loadPhysics("standard"));
      for (const auto& blue : TeamCatalogue::builtIn().teams()) {
        for (const auto& yellow : TeamCatalogue::builtIn().teams()) {
          config.teams = {get(parseTeam(blue->name)), get(parseTeam(yellow->name))};
          pairings_.push_back(config);
        }
      }
    }
  }

  /// Plays the matches from `first` to before `last`.
  void play(std::size_t first, std::size_t last, int jobs) {
    WorkProgress progress({}, last - first);
    (void)parallelFor(jobs, last - first, progress, [&](std::size_t i) -> Result<void> {
      playOne(first + i);
      return {};
    });
  }

  std::size_t warmUp() const { return std::min(pairings_.size(), matches_); }
  std::size_t matches() const { return matches_; }
  int failures() const { return failures_; }
  void report() const {
    std::printf("soak: %zu matches, %lld ticks, %lld goals, %lld restarts, %lld commands rejected\n",
                matches_, static_cast<long long>(ticks_), static_cast<long long>(goals_),
                static_cast<long long>(restarts_), static_cast<long long>(rejected_));
  }

 private:
  void playOne(std::size_t i) {
    MatchConfig config = pairings_[i % pairings_.size()];
    config.seed = i + 1;
    const auto limit = static_cast<Tick>(config.rules.half_seconds * 2.0 / config.physics.controlPeriod());
    Match match = get(Match::create(config));
    std::int64_t restarts = 0;
    const char* trouble = nullptr;
    while (match.step() && trouble == nullptr) {
      restarts += match.world().tick == 0 ? 1 : 0;
      for (const RobotState& robot : match.world().robots) {
        if (!isFinite(robot.pose.position)) trouble = "has a robot that is nowhere";
      }
      if (match.tick() > kLongest * limit) trouble = "does not end";
    }
    const MatchFaults faults = match.faults();
    if (faults.abandoned) trouble = faults.abandoned->message.c_str();
    const std::scoped_lock lock(mutex_);
    if (trouble != nullptr) {
      ++failures_;
      std::fprintf(stderr, "soak: match %zu (%s v %s, %s) %s\n", i, config.teams[0].text.c_str(),
                   config.teams[1].text.c_str(), config.rules.name.c_str(), trouble);
    }
    ticks_ += match.tick();
    goals_ += match.referee().score[0] + match.referee().score[1];
    restarts_ += restarts;
    rejected_ += faults.teams[0].rejected() + faults.teams[1].rejected();
  }

  std::size_t matches_;
  std::vector<MatchConfig> pairings_;
  std::mutex mutex_;
  int failures_ = 0;
  std::int64_t ticks_ = 0, goals_ = 0, restarts_ = 0, rejected_ = 0;
};

}  // namespace

int main(int argc, char** argv) {
  const int matches = argc > 1 ? std::atoi(argv[1]) : 0;
  const double half_seconds = argc > 2 ? std::atof(argv[2]) : 300.0;
  const int jobs = argc > 3 ? std::atoi(argv[3]) : fulbito::threadsFor(0, 1024);
  if (matches < 1 || !(half_seconds > 0.0) || jobs < 1) {
    std::fprintf(stderr, "usage: soak MATCHES [HALF_SECONDS] [JOBS]\n");
    return 2;
  }
  Soak soak(static_cast<std::size_t>(matches), half_seconds);
  soak.play(0, soak.warmUp(), jobs);
  const double before = residentMebibytes();
  soak.play(soak.warmUp(), soak.matches(), jobs);
  const double after = residentMebibytes();
  soak.report();
  std::printf("soak: %.1f MiB after the first %zu matches, %.1f MiB at the end: %+.1f MiB (at most %.0f)\n",
              before, soak.warmUp(), after, after - before, kAllowedGrowth);
  std::printf("soak: %d matches failed\n", soak.failures());
  return soak.failures() == 0 && after - before <= kAllowedGrowth ? 0 : 1;
}
