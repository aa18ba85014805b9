// Navigation trials: one robot on one layout, suites of layouts, comparisons of many methods, and their
// reports. Component `experiment`.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fulbito/detail/interval.hpp"
#include "fulbito/detail/layout.hpp"
#include "fulbito/detail/trial_score.hpp"
#include "fulbito/models.hpp"
#include "fulbito/navigation.hpp"
#include "fulbito/values.hpp"

namespace fulbito {

/// A monotonic clock [ns]. Libraries read no clock themselves: the program passes one in. Measured times only
/// go into fields named compute_ or wall_.
using Clock = std::function<std::int64_t()>;

/// One trial: a robot, a layout, a navigator.
struct TrialConfig {
  Layout layout;              ///< start, goal, obstacles
  FieldGeometry field;        ///< usually the one that the layout names
  RobotPreset robot;          ///< its max_wheel_speed is the speed limit of the trial
  PhysicsProfile physics;     ///< how finely time is stepped
  NavigatorChoice navigator;  ///< the method and its parameters
  SensorModel
      sensors;  ///< of the observation; the navigator knows the commands given since, and rolls it forward
  ForbiddenContacts forbidden = ForbiddenContacts::kAll;  ///< which contacts spoil it
  double limit_clearance = 0.058;  ///< [m] between the robot's centre and obstacles along the L* path
  std::uint64_t seed = 1;          ///< of its random numbers
  std::uint64_t index = 0;         ///< number of the trial in its suite, for its random streams
};

/// One control tick of a trial.
struct TraceRow {
  double time = 0.0;    ///< [s]
  RobotState robot;     ///< its true state
  WheelSpeeds command;  ///< [rad/s] as applied
};

/// The start of a contact with an obstacle or wall.
struct Touch {
  double time = 0.0;  ///< [s]
  Vec2 point;         ///< [m] of contact
};

/// The result of a trial.
struct TrialResult {
  TrialScore score;                ///< its figures
  std::vector<TraceRow> trace;     ///< from the start, one row per tick
  std::vector<Touch> touches;      ///< in chronological order
  std::vector<Vec2> limit_path;    ///< the L* path
  std::vector<double> compute_us;  ///< navigator and follower per tick; empty without a clock
  std::uint64_t final_hash = 0;    ///< of all states of the trial
};

class TrialRecorder;  ///< Of the program `fulbito run --record`; not part of the public interface.

/// Runs a trial and records it if a recorder is given. Errors: kUsage or kBadInput if the layout does not fit
/// the field or robot; those of the recorder.
Result<TrialResult> runTrial(const TrialConfig& config, const Clock& clock,
                             TrialRecorder* recorder = nullptr);

/// Appends an obstacle as discs for navigators. A box is divided along its longer side into squares, with one
/// disc per square.
void appendDiscs(const ObstacleSpec& spec, const ObstacleState& state, std::vector<DiscObstacle>& discs);

/// A family of seeded layouts with the rules for judging their trials.
struct Suite {
  std::string name;                                       ///< as in `ComparisonConfig::suite`
  std::string summary;                                    ///< one line
  int default_trials = 200;                               ///< layouts that are run unless told otherwise
  std::vector<double> speeds;                             ///< [m/s] default top speeds
  ForbiddenContacts forbidden = ForbiddenContacts::kAll;  ///< which contacts spoil a trial
  double limit_clearance = 0.058;                         ///< [m] see TrialConfig
  bool always_drawn = false;  ///< draw every layout, regardless of the configured number
  /// Layout number `index` of a seed: a pure function of the two.
  Layout (*layout)(std::uint64_t seed, std::uint64_t index) = nullptr;
};

/// All suites of layouts: corner, short, close-range, heading, walls, clutter, u-trap, moving and the named
/// cases of the figures of Jung & Lee (2015). `jung-lee-2015` is a comparison made of some of them, see
/// comparison.hpp.
const std::vector<Suite>& suites();

/// Errors: kUsage with a suggestion.
Result<const Suite*> findSuite(const std::string& name);

/// The named cases of Figs 1-8 of Jung & Lee (2015), in order.
const std::vector<Layout>& namedCases();

/// The configuration of `fulbito compare`.
struct ComparisonConfig {
  std::string suite = "jung-lee-2015";  ///< name of the suite
  std::vector<std::string> navigators;  ///< specifications; empty = the suite's
  std::vector<double> speeds;           ///< [m/s]; empty = the suite's
  int trials = 0;                       ///< layouts per block; 0 = the suite's
  std::uint64_t seed = 2015;            ///< of the layouts
  int jobs = 0;                         ///< worker threads; 0 = all cores
  std::string robot = "jung-lee-2015";  ///< preset or file
  std::string physics = "standard";     ///< preset or file
  SensorModel sensors;                  ///< how late and how badly robots see
  std::optional<std::uint64_t> only;    ///< this layout of each block alone
  int pictures = 8;                     ///< layouts per block whose traces are kept for pictures
  std::string record;                   ///< folder for recordings of these layouts; empty: none
};

/// Start headings of a block's trials.
enum class StartHeading {
  kLayout,  ///< the layout's; in most suites toward the goal
  kRandom,  ///< random, drawn per layout
  kAway,    ///< 171 degrees from the goal
};
/// As in results: layout, random, away.
std::string_view nameOf(StartHeading heading);

/// One suite at one speed with the compared navigators.
struct ComparisonBlock {
  const Suite* suite = nullptr;                  ///< that its layouts are of
  double speed = 1.0;                            ///< [m/s]
  int trials = 0;                                ///< layouts
  std::vector<NavigatorChoice> navigators;       ///< that are compared on each layout
  std::uint64_t seed = 2015;                     ///< of its layouts
  StartHeading heading = StartHeading::kLayout;  ///< where robots look at the start
};

/// One trial: its indices and results.
struct TrialRecord {
  std::size_t block = 0;          ///< index in `Comparison::blocks`
  std::size_t navigator = 0;      ///< in its block
  std::uint64_t index = 0;        ///< number of the layout
  TrialScore score;               ///< the trial's figures
  std::uint64_t final_hash = 0;   ///< of all states of the trial
  std::vector<float> compute_us;  ///< [us] per tick
  std::vector<TraceRow> trace;    ///< @{ kept only for pictures
  std::vector<Touch> touches;     ///< @}
};

/// One row of the table: a navigator on a block.
struct SummaryRow {
  std::string suite;                ///< its name
  double speed = 0.0;               ///< [m/s] top speed
  std::string navigator;            ///< specification
  bool plans_speed = false;         ///< see `NavigatorInfo`
  int trials = 0;                   ///< layouts
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
  double compute_us_p50 = 0.0, compute_us_p99 = 0.0,
         compute_us_max = 0.0;  ///< [us] per tick, navigator and follower
};

/// One claim of the paper and the result measured here.
struct ReproductionRow {
  std::string id;            ///< e.g. distance-untuned-univector
  std::string claim;         ///< of the paper
  std::string paper;         ///< the paper's figure as printed
  std::string ours;          ///< with its interval
  std::string band;          ///< expected range for an honest reproduction
  bool inside_band = false;  ///< whether it is as expected
  std::string reason;        ///< why it differs from the paper, or from the band
};

/// A comparison: what was asked for, and what came of it so far.
struct Comparison {
  ComparisonConfig config;                    ///< resolved
  RobotPreset robot;                          ///< of all trials; each block sets its top speed
  PhysicsProfile physics;                     ///< of all trials
  std::vector<ComparisonBlock> blocks;        ///< a suite at one speed each
  std::vector<TrialRecord> records;           ///< by block, then navigator, then layout
  std::vector<SummaryRow> summary;            ///< one row per block and navigator
  std::vector<ReproductionRow> reproduction;  ///< for `jung-lee-2015` only
};

/// Called repeatedly with the number of finished trials. Returning false stops the run.
using Progress = std::function<bool(std::size_t done, std::size_t total)>;

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

/// The comparison as one JSON object (docs/results-format.md), pretty-printed with a final newline. The same
/// seed gives the same bytes on any number of threads, except keys that begin with compute_ or wall_.
std::string resultsJson(const Comparison& comparison, double wall_seconds);

/// One trial as a JSON object.
std::string trialJson(const TrialConfig& config, const TrialResult& result);

/// CSV with one line per trial and a header.
std::string trialsCsv(const Comparison& comparison);

/// CSV with one line per control tick and a header.
std::string traceCsv(const TrialResult& result);

/// Markdown tables for people: one per block, then the reproduction.
std::string markdownReport(const Comparison& comparison);

/// Name, version and build of the library as a JSON object.
std::string versionJson();

}  // namespace fulbito
