#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "fulbito/detail/values.hpp"

namespace fulbito {

/// One row: a scene at one physics rate under one load, engine and bare Box2D loop in turns.
struct BenchScene {
  std::string name;                ///< "3v3", "5v5"
  int rate_hz = 0;                 ///< physics steps a simulated second
  std::string load;                ///< random, hold, chase
  double engine_x_realtime = 0.0;  ///< simulated seconds per CPU second of one core, median repetition
  double bare_x_realtime = 0.0;    ///< the same of the bare loop
  double ratio = 0.0;              ///< engine speed / bare speed, median of the repetitions' own ratios
  double ratio_min = 0.0;          ///< the smallest of them
  double engine_contacts = 0.0;    ///< touching pairs after a tick, mean
  double bare_contacts = 0.0;
};

/// Speed of two worlds on two threads over that of one on one thread.
struct BenchScaling {
  int rate_hz = 0;
  std::string load;
  double engine = 0.0;
  double bare = 0.0;
  double ratio = 0.0;  ///< engine / bare, median of the repetitions' own ratios
};

struct BenchReport {
  std::uint64_t signature = 0;  ///< sceneSignature() of bench/scenes.hpp
  std::vector<BenchScene> scenes;
  std::vector<BenchScaling> scaling;
};

struct BenchOptions {
  int repetitions = 5;  ///< of each row, >= 1
  int episodes = 48;    ///< runs of 10 simulated seconds in a repetition, >= 1: from different starts, as a
                        ///< pile-up's contacts depend on how it came about
  bool scaling = true;  ///< measure two threads too
};

/// Measures 3v3 at 60, 120 and 240 Hz under each load. Takes about 40 s with the defaults.
/// Errors: kInterrupted.
Result<BenchReport> runBenchmark(const BenchOptions& options);

/// The report as a table for people.
std::string toTable(const BenchReport& report);

}  // namespace fulbito
