// Navigation trials: one robot on one layout, suites of layouts, comparisons of many methods, and their
// reports. Component `experiment`.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fulbito/detail/interval.hpp"
#include "fulbito/detail/layout.hpp"
#include "fulbito/detail/trial_score.hpp"
#include "fulbito/detail/values.hpp"
#include "fulbito/models.hpp"
#include "fulbito/navigation.hpp"

namespace fulbito {

/// A monotonic clock [ns]. Libraries read no clock themselves: the program passes one in. Only fields named
/// compute_ or wall_ hold measured times.
using Clock = std::function<std::int64_t()>;

/// One trial: a robot, a layout, a navigator.
struct TrialConfig {
  Layout layout;              ///< start, goal, obstacles
  FieldGeometry field;        ///< usually the field that the layout names
  RobotPreset robot;          ///< its max_wheel_speed is the speed limit of the trial
  PhysicsProfile physics;     ///< time steps and accuracy of the physics
  NavigatorChoice navigator;  ///< the method and its parameters
  SensorModel
      sensors;  ///< quality of observations; the robot's state is predicted through the commands given since
  ForbiddenContacts forbidden = ForbiddenContacts::kAll;  ///< contacts that fail the trial
  double limit_clearance = 0.058;  ///< [m] between the robot's centre and obstacles along the L* path
  /// Apart from its pose and goal, the robot knows only what its eight front sonars hear (docs/suites.md); it
  /// knows no walls.
  bool sonars_only = false;
  double sonar_noise = 0.005;  ///< [m] standard deviation of a sonar's range, if `sonars_only`
  std::uint64_t seed = 1;      ///< seed of its random numbers
  std::uint64_t index = 0;     ///< number of the trial in its suite, for its random streams
};

/// One control tick of a trial.
struct TraceRow {
  double time = 0.0;    ///< [s]
  RobotState robot;     ///< its true state
  WheelSpeeds command;  ///< [rad/s] the applied command
};

/// The start of a contact with an obstacle or wall.
struct Touch {
  double time = 0.0;  ///< [s]
  Vec2 point;         ///< [m] contact point
};

/// The result of a trial.
struct TrialResult {
  TrialScore score;                ///< the trial's figures
  std::vector<TraceRow> trace;     ///< from the start, one row per tick
  std::vector<Touch> touches;      ///< contacts in chronological order
  std::vector<Vec2> limit_path;    ///< [m] the L* path
  std::vector<double> compute_us;  ///< [us] navigator and follower per tick; empty without a clock
  std::uint64_t final_hash = 0;    ///< running hash of all states of the trial
};

class World;
class TrialRecorder;  ///< For `fulbito run --record`; not part of the public interface.

/// Runs a trial and records it if `recorder` is not null. Errors: kUsage or kBadInput if the layout does not
/// fit the field or robot; those of the recorder.
Result<TrialResult> runTrial(const TrialConfig& config, const Clock& clock,
                             TrialRecorder* recorder = nullptr);

/// Appends an obstacle as discs for navigators. A box becomes squares along its longer side, with one disc
/// per square.
void appendDiscs(const ObstacleSpec& spec, const ObstacleState& state, std::vector<DiscObstacle>& discs);

/// Least distance [m] between two obstacles as they start; negative where they overlap.
double distanceBetween(const ObstacleSpec& a, const ObstacleSpec& b);

/// The knowledge of a robot that has only sonars, as in trials with `sonars_only`: their readings and, for
/// navigators that do not use these, discs where a short memory of echoes is occupied. It has no walls: its
/// field is a wide plain.
class SonarSight {
 public:
  /// Reads field, robot, navigator, noise and seed of the trial.
  explicit SonarSight(const TrialConfig& config);
  SonarSight(SonarSight&&) noexcept;  ///< One that was moved from can only be destroyed or assigned to.
  SonarSight& operator=(SonarSight&&) noexcept;  ///< As above.
  ~SonarSight();

  /// Fires the sonars of the world's first robot and replaces the obstacles and walls of `scene`.
  /// Valid until the next call.
  void look(const World& world, NavigationScene& scene);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// A family of seeded layouts with the rules for judging their trials.
struct Suite {
  std::string name;                                       ///< as in `ComparisonConfig::suite`
  std::string summary;                                    ///< one line
  int default_trials = 200;                               ///< default number of layouts
  std::vector<double> speeds;                             ///< [m/s] default top speeds
  ForbiddenContacts forbidden = ForbiddenContacts::kAll;  ///< contacts that fail a trial
  double limit_clearance = 0.058;                         ///< [m] see TrialConfig
  bool always_drawn = false;  ///< draw all layouts, regardless of the configured number
  /// Layout number `index` of a seed: a pure function of the two.
  Layout (*layout)(std::uint64_t seed, std::uint64_t index) = nullptr;
  bool sonars_only = false;    ///< see TrialConfig
  bool always_traced = false;  ///< keep the traces of all layouts, for their judgement
};

/// All suites of layouts: corner, short, close-range, heading, walls, clutter, u-trap, moving, sonar, the
/// named cases of the figures of Jung & Lee (2015), and sweeps of these. `jung-lee-2015` is a comparison of
/// some of them, see `ComparisonConfig`.
const std::vector<Suite>& suites();

/// The suite of that name. Errors: kUsage with a suggestion.
Result<const Suite*> findSuite(const std::string& name);

/// A barrier of robot-sized obstacles with one gap of `widths` robot widths. The gap is at most 20 cm from
/// the straight line to the goal. Part of the suites `sonar`.
Layout gapLayout(std::uint64_t seed, std::uint64_t index, double widths);
/// A layout of the class of Fig. 8 of P.-G. Kim et al. (2006). Obstacles of different sizes stand side by
/// side across the straight line to the goal, with one gap of 1.3 to 1.6 robot widths near it. Both ends
/// leave wide passages.
Layout anyRowLayout(std::uint64_t seed, std::uint64_t index);

/// The named cases of Figs 1-8 of Jung & Lee (2015), in order.
const std::vector<Layout>& namedCases();

/// The configuration of `fulbito compare`.
struct ComparisonConfig {
  std::string suite = "jung-lee-2015";  ///< name of the suite
  std::vector<std::string> navigators;  ///< specifications; empty: the suite's
  std::vector<double> speeds;           ///< [m/s] top speeds; empty: the suite's
  int trials = 0;                       ///< layouts per block; 0: the suite's
  std::uint64_t seed = 2015;            ///< seed of the layouts
  int jobs = 0;                         ///< worker threads; 0: all cores
  std::string robot = "jung-lee-2015";  ///< preset or file
  std::string physics = "standard";     ///< preset or file
  SensorModel sensors;                  ///< quality of observations
  std::optional<std::uint64_t> only;    ///< only this layout of each block
  int pictures = 8;                     ///< layouts per block with traces for pictures
  /// largest number of paths per picture, the paper's methods first; 0: all
  int ways = 6;
  std::string record;  ///< folder for recordings of these layouts; empty: none
};

/// Start headings of a block's trials.
enum class StartHeading {
  kLayout,  ///< the layout's; in most suites toward the goal
  kRandom,  ///< random, drawn per layout
  kAway,    ///< 171 degrees from the goal
};
/// Name as in results: layout, random, away.
std::string_view nameOf(StartHeading heading);

/// One suite at one speed with the compared navigators.
struct ComparisonBlock {
  const Suite* suite = nullptr;                  ///< the suite of its layouts
  double speed = 1.0;                            ///< [m/s] top speed
  int trials = 0;                                ///< number of layouts
  std::vector<NavigatorChoice> navigators;       ///< compared on each layout
  std::uint64_t seed = 2015;                     ///< seed of its layouts
  StartHeading heading = StartHeading::kLayout;  ///< headings of the robots at the start
};

/// One trial: its indices and results.
struct TrialRecord {
  std::size_t block = 0;          ///< index in `Comparison::blocks`
  std::size_t navigator = 0;      ///< index in its block
  std::uint64_t index = 0;        ///< number of the layout
  TrialScore score;               ///< the trial's figures
  std::uint64_t final_hash = 0;   ///< running hash of all states of the trial
  std::vector<float> compute_us;  ///< [us] navigator and follower per tick
  std::vector<TraceRow> trace;    ///< @{ only for pictures
  std::vector<Touch> touches;     ///< @}
};

/// One row of the table: a navigator on a block.
struct SummaryRow {
  std::string suite;                ///< name of the suite
  double speed = 0.0;               ///< [m/s] top speed
  std::string navigator;            ///< specification
  bool plans_speed = false;         ///< see `NavigatorInfo`
  int trials = 0;                   ///< number of layouts
  Interval success;                 ///< success rate with its Wilson interval
  int contacts = 0;                 ///< contacts with obstacles and walls in all trials
  int own_contacts = 0;             ///< trials with a contact by own motion
  int stuck_over_2s = 0;            ///< trials with more than 2 s without moving
  int safe_pairs = 0;               ///< layouts that this navigator and the block's reference both solve
  double length_ratio = 0.0;        ///< sum of lengths over sum of L*, successes
  double time_ratio = 0.0;          ///< sum of times over sum of T*, successes
  double time_ratio_all = 0.0;      ///< mean of T/T* over all trials; a failure counts as 8
  double path_length = 0.0;         ///< [m] mean over successes
  double time = 0.0;                ///< [s] mean over successes
  double min_clearance = 0.0;       ///< [m] least of all trials
  double mean_min_clearance = 0.0;  ///< [m] mean of the trials' least clearances, successes
  double turning = 0.0;             ///< [rad] mean over successes
  double curvature_jumps = 0.0;     ///< mean over successes
  double wheel_jerk = 0.0;          ///< [m/s^3] mean over successes
  double compute_us_p50 = 0.0, compute_us_p99 = 0.0,
         compute_us_max = 0.0;  ///< [us] per tick, navigator and follower
};

/// One claim of the paper and its measured reproduction.
struct ReproductionRow {
  std::string id;     ///< e.g. distance-untuned-univector
  std::string claim;  ///< the paper's claim
  std::string paper;  ///< the paper's figure as printed
  std::string ours;   ///< the measured figure with its interval
  /// Difference of the measured figure from the paper's [percentage points]; empty: the paper has none.
  std::optional<double> off_paper;
  std::string our_band;  ///< range expected of this project's methods; it is no band about the paper's figure
  bool inside_our_band = false;  ///< the measured figure is in that range
  std::string reason;            ///< reason of a difference from the paper or the band
};

/// A comparison: its configuration, and its results so far.
struct Comparison {
  ComparisonConfig config;                    ///< configuration, with all defaults filled in
  RobotPreset robot;                          ///< robot of all trials; each block sets its top speed
  PhysicsProfile physics;                     ///< physics of all trials
  std::vector<ComparisonBlock> blocks;        ///< each is a suite at one speed
  std::vector<TrialRecord> records;           ///< by block, then navigator, then layout
  std::vector<SummaryRow> summary;            ///< one row per block and navigator
  std::vector<ReproductionRow> reproduction;  ///< for `jung-lee-2015` only
};

/// Called repeatedly with the number of finished trials. Return false to stop the run.
using Progress = std::function<bool(std::size_t done, std::size_t total)>;

/// Checks names, files and ranges, and plans the blocks without running a trial. Errors: kUsage, kIo,
/// kBadInput.
Result<Comparison> planComparison(const ComparisonConfig& config);

/// Runs all trials of a plan on worker threads and fills in records, summary and reproduction. The number of
/// threads does not affect the result. Errors: those of the trials; kInterrupted if `progress` returned
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

/// CSV with a header and one line per trial.
std::string trialsCsv(const Comparison& comparison);

/// CSV with a header and one line per control tick.
std::string traceCsv(const TrialResult& result);

/// Markdown tables for people: one per block, then the reproduction.
std::string markdownReport(const Comparison& comparison);

/// Name, version and build of the library as a JSON object.
std::string versionJson();

}  // namespace fulbito
