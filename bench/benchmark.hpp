#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "fulbito/detail/values.hpp"

namespace fulbito {

/// One row of the table: a scene at one physics rate under one load, for the engine and the bare Box2D loop.
struct BenchScene {
  std::string name;                ///< "3v3", "5v5"
  int rate_hz = 0;                 ///< physics steps per simulated second
  std::string load;                ///< name of the load: random, hold, chase
  double engine_x_realtime = 0.0;  ///< simulated seconds per CPU second of one core; median over repetitions
  double bare_x_realtime = 0.0;    ///< the same for the bare loop
  double ratio = 0.0;              ///< engine speed / bare speed; median of the ratios of the repetitions
  double ratio_min = 0.0;          ///< smallest ratio of a repetition
  double engine_contacts = 0.0;    ///< mean number of touching pairs after a tick
  double bare_contacts = 0.0;
};

/// Speed of two worlds on two threads, relative to one world on one thread.
struct BenchScaling {
  int rate_hz = 0;
  std::string load;
  double engine = 0.0;
  double bare = 0.0;
  double ratio = 0.0;  ///< engine / bare; median of the ratios of the repetitions
};

struct BenchReport {
  std::uint64_t signature = 0;  ///< `sceneSignature` of bench/scenes.hpp
  std::vector<BenchScene> scenes;
  std::vector<BenchScaling> scaling;
};

struct BenchOptions {
  int repetitions = 5;  ///< repetitions of each row, at least 1
  int episodes = 48;    ///< runs of 10 simulated seconds per repetition, at least 1; each has another start,
                        ///< as the number of contacts depends on it
  bool scaling = true;  ///< whether to measure two threads as well
};

/// Measures 3v3 at 60, 120 and 240 Hz under each load. Takes about 40 s with the defaults.
/// Errors: kInterrupted.
Result<BenchReport> runBenchmark(const BenchOptions& options);

/// The report as a table for people.
std::string toTable(const BenchReport& report);

}  // namespace fulbito
