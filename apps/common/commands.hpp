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
  kTeamFailed = 4,
  kIo = 5,
  kInconclusive = 6,
  kDifferent = 7,
  kInternal = 70,
  kInterruptedBase = 128,  ///< plus the signal number: 129 hang-up, 130 Ctrl-C, 143 SIGTERM
};

struct RunOptions {
  std::string navigator = kDefaultNavigator;
  std::string layout = "corner:0";  ///< a file, a named case, or suite:index
  double speed = 1.0;               ///< [m/s] top speed
  std::string robot = "jung-lee-2015";
  std::string physics = "standard";
  std::uint64_t seed = 2015;
  SensorModel sensors;
  std::optional<std::string> png;  ///< picture file; empty name: named after the layout
  std::string trace;
  std::string record;     ///< recording file; empty: none
  bool drawings = false;  ///< also record the path or field of the navigator
  bool json = false;
  bool force = false;  ///< replace existing files
};

struct CompareOptions {
  ComparisonConfig config;
  std::string out = "fulbito-out";
  std::string html;  ///< page of races; empty: none
  std::string tune;  ///< method to tune; empty: no tuning
  int tune_evaluations = 150;
  bool mapped = false;  ///< run the ring map instead of the suite
  MapConfig map;        ///< options of the ring map; its base is `config`
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
  int repetitions = 5;  ///< repetitions per row of the table
  int episodes = 48;    ///< episodes per repetition, with ten simulated seconds each
};

/// @{ Each runs one command and returns its exit code. Results go to stdout, all other output to stderr.
int run(const RunOptions& options);
int compare(const CompareOptions& options);
int list(const ListOptions& options);
int show(const ShowOptions& options);
int version(bool json);
int bench(const BenchCommand& command);
/// @}

/// Prints the error on stderr, truncated if very long. Returns its exit code.
int report(const Error& error);

/// Monotonic time [ns]. The libraries get this function because they read no clock themselves.
std::int64_t now();

/// True after the first SIGINT, SIGTERM or SIGHUP. The process exits a few seconds later, or at a second
/// signal; unfinished files are removed.
bool interrupted();
/// The exit code after a signal.
int interruptedCode();
void catchSignals();

}  // namespace fulbito::app
