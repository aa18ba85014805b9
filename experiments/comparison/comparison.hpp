#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/math/statistics.hpp"
#include "experiments/trials/suite.hpp"
#include "experiments/trials/trial.hpp"

namespace fulbito {

/// The configuration of `fulbito compare`.
struct ComparisonConfig {
  std::string suite = "jung-lee-2015";
  std::vector<std::string> navigators;  ///< specifications; empty = the suite's
  std::vector<double> speeds;           ///< [m/s]; empty = the suite's
  int trials = 0;                       ///< layouts per block; 0 = the suite's
  std::uint64_t seed = 2015;
  int jobs = 0;                         ///< worker threads; 0 = all cores
  std::string robot = "jung-lee-2015";  ///< preset or file
  std::string physics = "standard";     ///< preset or file
  SensorModel sensors;
  std::optional<std::uint64_t> only;  ///< this layout of each block alone
  int pictures = 8;                   ///< layouts per block whose traces are kept for pictures
  std::string record;                 ///< folder for recordings of these layouts; empty: none
};

/// Start headings of a block's trials.
enum class StartHeading {
  kLayout,  ///< the layout's; in most suites toward the goal
  kRandom,  ///< random, drawn per layout
  kAway,    ///< 171 degrees from the goal
};
std::string_view nameOf(StartHeading heading);

/// One suite at one speed with the compared navigators.
struct ComparisonBlock {
  const Suite* suite = nullptr;
  double speed = 1.0;  ///< [m/s]
  int trials = 0;
  std::vector<NavigatorChoice> navigators;
  std::uint64_t seed = 2015;  ///< of its layouts
  StartHeading heading = StartHeading::kLayout;
};

/// One trial: its indices and results.
struct TrialRecord {
  std::size_t block = 0;
  std::size_t navigator = 0;  ///< in its block
  std::uint64_t index = 0;
  TrialScore score;
  std::uint64_t final_hash = 0;
  std::vector<float> compute_us;  ///< [us] per tick
  std::vector<TraceRow> trace;    ///< @{ kept only for pictures
  std::vector<Touch> touches;     ///< @}
};

/// One row of the table: a navigator on a block.
struct SummaryRow {
  std::string suite;
  double speed = 0.0;
  std::string navigator;
  bool plans_speed = false;
  int trials = 0;
  Interval success;                 ///< rate with its Wilson interval
  int contacts = 0;                 ///< contacts with obstacles and walls in all trials
  int own_contacts = 0;             ///< trials with a contact by own motion
  int stuck_over_2s = 0;            ///< trials with more than 2 s without moving
  int safe_pairs = 0;               ///< layouts that this navigator and the block's reference both solved
  double length_ratio = 0.0;        ///< sum of lengths over sum of L*, successes
  double time_ratio = 0.0;          ///< sum of times over sum of T*, successes
  double time_ratio_all = 0.0;      ///< mean of T/T* over all trials; a failure counts as 8
  double path_length = 0.0;         ///< [m] mean over successes
  double time = 0.0;                ///< [s] mean over successes
  double min_clearance = 0.0;       ///< [m] least over all trials
  double mean_min_clearance = 0.0;  ///< [m] mean of the trials' least clearances, successes
  double turning = 0.0;             ///< [rad] mean over successes
  double curvature_jumps = 0.0;     ///< mean over successes
  double wheel_jerk = 0.0;          ///< [m/s^3] mean over successes
  double compute_us_p50 = 0.0, compute_us_p99 = 0.0, compute_us_max = 0.0;
};

/// One claim of the paper and the result measured here.
struct ReproductionRow {
  std::string id;  ///< e.g. distance-untuned-univector
  std::string claim;
  std::string paper;  ///< the paper's figure as printed
  std::string ours;   ///< with its interval
  std::string band;   ///< expected range for an honest reproduction
  bool inside_band = false;
  std::string reason;  ///< why it differs from the paper, or from the band
};

struct Comparison {
  ComparisonConfig config;  ///< resolved
  RobotPreset robot;
  PhysicsProfile physics;
  std::vector<ComparisonBlock> blocks;
  std::vector<TrialRecord> records;  ///< by block, then navigator, then layout
  std::vector<SummaryRow> summary;
  std::vector<ReproductionRow> reproduction;  ///< for `jung-lee-2015` only
};

/// Called repeatedly with the number of finished trials. Returning false stops the run.
using Progress = std::function<bool(std::size_t done, std::size_t total)>;

/// Loads robot and physics and checks ranges, without blocks. Errors: kUsage, kIo, kBadInput.
Result<Comparison> prepareComparison(const ComparisonConfig& config);

/// Checks names, files and ranges and plans the blocks without running a trial. Errors: kUsage, kIo,
/// kBadInput.
Result<Comparison> planComparison(const ComparisonConfig& config);

/// Runs all trials of a plan on worker threads and fills in records, summary and reproduction. The result
/// does not depend on the number of threads. Errors: of the trials; kInterrupted if `progress` returned
/// false.
Result<void> runComparison(Comparison& comparison, const Clock& clock, const Progress& progress);

/// Records of one block and navigator, in the order of the layouts.
std::span<const TrialRecord> recordsOf(const Comparison& comparison, std::size_t block,
                                       std::size_t navigator);

/// Index of the navigator with which the others are paired: `bezier` if present, else the first.
std::size_t referenceOf(const ComparisonBlock& block);

/// The robot of a block: the comparison's with its top speed set to the block's.
RobotPreset robotAt(const RobotPreset& robot, double speed);

/// The trial config of one trial of the comparison. Errors: of the layout's field.
Result<TrialConfig> trialConfig(const Comparison& comparison, const ComparisonBlock& block,
                                std::size_t navigator, std::uint64_t index);

}  // namespace fulbito
