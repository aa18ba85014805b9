#pragma once

#include <optional>
#include <string>

#include "experiments/paper_map.hpp"

namespace fulbito::app {

/// Exit codes of the program (docs/command-line.md).
enum ExitCode {
  kOk = 0,
  kTestFailed = 1,
  kUsage = 2,
  kBadInput = 3,
  kIo = 5,
  kDifferent = 7,
  kInternal = 70,
  kInterrupted = 130,
};

struct RunOptions {
  std::string navigator = kDefaultNavigator;
  std::string layout = "corner:0";  ///< file, named case, or suite:index
  double speed = 1.0;               ///< [m/s]
  std::string robot = "paper-004";
  std::string physics = "standard";
  std::uint64_t seed = 2015;
  SensorModel sensors;
  std::optional<std::string> png;  ///< empty: named after the layout
  std::string trace;
  std::string record;     ///< file; empty: none
  bool drawings = false;  ///< the recording also holds what the navigator wants
  bool json = false;
};

struct CompareOptions {
  ComparisonConfig config;
  std::string out = "fulbito-out";
  std::string html;  ///< page of races; empty: none
  std::string tune;  ///< empty: no tuning
  int tune_evaluations = 150;
  bool mapped = false;  ///< the map of the ring field instead
  MapConfig map;        ///< its base is `config`
  bool json = false;
};

struct ListOptions {
  std::string kind;
  bool json = false;
};

struct ShowOptions {
  std::string kind;
  std::string name;
};

struct BenchCommand {
  bool json = false;
  bool signature_only = false;
  int repetitions = 5;  ///< of each row
  int episodes = 48;    ///< of ten simulated seconds each in a repetition
};

/// @{ Each runs one command and returns its exit code; results go to stdout, all else to stderr.
int run(const RunOptions& options);
int compare(const CompareOptions& options);
int list(const ListOptions& options);
int show(const ShowOptions& options);
int version(bool json);
int bench(const BenchCommand& command);
/// @}

/// Prints the error and returns its exit code.
int report(const Error& error);

/// Monotonic time [ns], handed to the libraries, which read no clock of their own.
std::int64_t now();

/// From the first SIGINT or SIGTERM on; a second one ends the program at once.
bool interrupted();
void catchSignals();

}  // namespace fulbito::app
