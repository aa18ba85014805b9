#pragma once

#include <optional>
#include <string>

#include "experiments/map/paper_map.hpp"

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
  kInterruptedBase = 128,  ///< plus the signal's number: 129 hang-up, 130 Ctrl-C, 143 SIGTERM
};

struct RunOptions {
  std::string navigator = kDefaultNavigator;
  std::string layout = "corner:0";  ///< file, named case, or suite:index
  double speed = 1.0;               ///< [m/s]
  std::string robot = "jung-lee-2015";
  std::string physics = "standard";
  std::uint64_t seed = 2015;
  SensorModel sensors;
  std::optional<std::string> png;  ///< empty: named after the layout
  std::string trace;
  std::string record;     ///< file; empty: none
  bool drawings = false;  ///< the recording also holds what the navigator wants
  bool json = false;
  bool force = false;  ///< files that exist are replaced
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
  bool force = false;  ///< `html` is replaced if it exists
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

/// Prints the error on stderr, cut where it is very long, and returns its exit code.
int report(const Error& error);

/// Monotonic time [ns], handed to the libraries, which read no clock of their own.
std::int64_t now();

/// From the first SIGINT, SIGTERM or SIGHUP on. Work that does not end then is ended after a few seconds, and
/// by a second signal at once; nothing half-made is left.
bool interrupted();
/// The exit code of what a signal ended.
int interruptedCode();
void catchSignals();

}  // namespace fulbito::app
