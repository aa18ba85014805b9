#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fulbito/detail/interval.hpp"
#include "fulbito/match.hpp"
#include "fulbito/strategy.hpp"

/// Drills: seeded situations that test one skill of a team, each with a bar. A drill is a TOML file
/// (docs/drills.md); everything in it is written in the frame of the team under test, whose goal is at -x.
namespace fulbito {

/// A task for the tested team instead of a game.
enum class DrillTask : std::uint8_t { kPlay, kReachPose, kTurn, kReachBall, kPush, kPredictBall };

/// Behaviour of a robot in a drill.
enum class DrillRole : std::uint8_t {
  kTeam,   ///< plays as its team decides
  kStand,  ///< stands still
  kChase,  ///< drives straight at the ball
  kKeep,   ///< keeps goal at the point that leaves equal gaps on both sides of it
  kPress   ///< drives at the ball from the far side of its own goal, and pushes
};

/// A family of starts of a drill: place and motion of the ball, and the task.
struct DrillStart {
  std::string name = "all";
  DrillTask task = DrillTask::kPlay;
  int restart = -1;          ///< `RestartKind` that play begins with; -1: the team is told of no restart
  bool ours = true;          ///< the tested team takes the restart
  std::string opponents;     ///< team specification, "itself", or empty: the robots' own roles
  double duration = 0.0;     ///< [s] instead of the drill's; 0: the drill's
  std::vector<Vec2> ball;    ///< [m] places that trials take in turn
  Vec2 ball_spread;          ///< [m] uniformly to either side of the place
  std::vector<Vec2> toward;  ///< [m] the ball rolls toward a point between the first and the last
  double speed_min = 0.0;    ///< [m/s] least speed of the ball
  double speed_max = 0.0;
  double distance_min = 0.0;  ///< [m] distance of the ball from the point it rolls toward; replaces `ball`
  double distance_max = 0.0;
  double savable = 0.0;  ///< multiple of the least savable distance that is added to the distance
  /// [m/s] speed of the shot whose least savable distance that is; 0: each shot's own
  double savable_speed = 0.0;
  double angle = 0.0;   ///< [rad] largest angle between the ball's path and the goal's normal
  bool enters = false;  ///< only balls that go into the own goal if nobody touches them
  /// bounces off walls before the ball is in, or before the prediction ends; -1: any number
  int bounces = -1;
  bool decided = false;     ///< only trials with a success or a failure in time count
  double target_min = 0.0;  ///< [m] distance of the task's target
  double target_max = 0.0;
  double turn_min = 0.0;  ///< [rad] angle between the robot's heading and the task's
  double turn_max = 0.0;
  double task_speed = 0.0;  ///< [m/s] speed that the task asks for
  double horizon = 0.0;     ///< [s] time ahead of a prediction
};

/// The start of one robot.
struct DrillRobot {
  TeamId team = TeamId::kBlue;  ///< blue stands for the team under test
  int number = -1;              ///< in its team; -1: the next one
  DrillRole plays = DrillRole::kTeam;
  std::string start;       ///< only in the start of that name; empty: in all
  std::vector<Vec2> at;    ///< [m] places, one after the other from trial to trial
  Vec2 spread;             ///< [m] uniformly to either side
  bool from_ball = false;  ///< `at` counts from the ball
  /// as `from_ball`, with x along the line from the ball to the opponents' goal
  bool behind_ball = false;
  /// y is the point where the gaps to both posts are equal, as seen from the ball
  bool equal_gap = false;
  bool face_ball = false;       ///< `heading` counts from the direction of the ball
  double heading = 0.0;         ///< [rad]
  double heading_spread = 0.0;  ///< [rad] uniformly to either side
};

/// A condition on the ball.
enum class DrillCondition : std::uint8_t {
  kGoal,       ///< in the opponents' goal
  kConceded,   ///< in the own goal
  kTouched,    ///< a robot of the tested team touched it
  kGained,     ///< it is `value` [m] nearer to the opponents' end than at the start
  kDriven,     ///< it is `value` [m] nearer to the own end than at the start
  kOffWall,    ///< it is `value` [m] off the nearest wall
  kAway,       ///< it is `value` [m] from where it started
  kNearMouth,  ///< it is less than `value` [m] from the opponents' goal mouth
  kCleared,    ///< it is out of the own goal area by `value` [m]
  kLasted      ///< the time is over
};

/// A condition that ends a trial, well or badly.
struct DrillEnd {
  DrillCondition what = DrillCondition::kGoal;
  std::string start;    ///< only in the start of that name; empty: in all
  double value = 0.0;   ///< see DrillCondition
  double within = 1e9;  ///< [s] only up to this time
};

/// A measured value of a trial or a match.
enum class DrillMeasure : std::uint8_t {
  kSuccess,    ///< of trials: 1 or 0
  kTime,       ///< [s] to success; a failure counts as infinity
  kExcess,     ///< [s] time beyond the least that the robot could need
  kError,      ///< [m] error of the task: prediction, drift
  kOnTarget,   ///< the ball went into the goal or toward it
  kOwnGoal,    ///< conceded, and an own robot touched the ball last
  kConceded,   ///< the ball went into the own goal
  kIllegal,    ///< placements of a restart that had to be repaired
  kEarlyGoal,  ///< restarts after which a goal was conceded within 5 s
  kAreaFoul,   ///< fouls at the areas, per match
  kOwnStall,   ///< stuck balls in the own area, per match
  kSwitch,     ///< times per second that another robot takes a role
  kFlap,       ///< switches less than 0.3 s after the last one, with no event between
  kWin,        ///< matches won
  kMargin,     ///< goals scored minus goals conceded, per match
  kBias,       ///< difference between the margins on the two sides, in its standard deviations
  kKept        ///< share of the success of other drills that remains under worse sight
};

enum class DrillStatistic : std::uint8_t { kRate, kCount, kMean, kMedian, kP95 };

/// One bar. Rates are judged by the end of their 95 % Wilson interval that is nearer to failing.
struct DrillBar {
  DrillMeasure value = DrillMeasure::kSuccess;
  DrillStatistic statistic = DrillStatistic::kRate;
  std::string start;  ///< only trials with the start of that name; empty: all
  double within = std::numeric_limits<double>::quiet_NaN();  ///< largest value that counts for the rate
  double at_least = std::numeric_limits<double>::quiet_NaN();
  double at_most = std::numeric_limits<double>::quiet_NaN();
  bool by_value = false;  ///< the rate itself is judged, not the end of its interval
  /// the statistic counts in the same one of the trials' least times, so that a bar is as hard for every
  /// robot
  bool of_least = false;
};

/// A drill as read from its file.
struct Drill {
  std::string file;  ///< its path or name, for messages
  int number = 0;
  std::string name;
  std::string what;    ///< one line
  std::string source;  ///< reason for the bars, so that readers can check them
  std::string rules = "vsss-3v3";
  bool referee = true;  ///< false: only goals stop play
  /// number of trials; for whole matches their number, or half of it if they are played in pairs
  int trials = 400;
  int agent = -1;          ///< robot that an environment's agent drives; -1: the lowest number of a start
  double duration = 10.0;  ///< [s]
  double after = 0.0;      ///< [s] time to observe after a success
  double latency = 0.05;   ///< [s] T of the least savable distance
  double acceleration_share = 0.75;   ///< a of it, as a share of the robot's acceleration
  double tolerance = 0.015;           ///< [m] tolerance of a task's position
  double heading_tolerance = 0.1396;  ///< [rad] tolerance of a task's heading
  std::vector<DrillStart> starts;
  std::vector<DrillRobot> robots;
  std::vector<DrillEnd> successes;
  std::vector<DrillEnd> failures;
  std::vector<DrillBar> bars;
  std::string match_opponent;   ///< whole matches against that team ("itself"); empty: trials
  double half_seconds = 300.0;  ///< [s] length of a half of such a match
  /// numbers of drills that are repeated under `sight` and compared with `sight_before`
  std::vector<int> repeats;
  VisionModel sight;
  VisionModel sight_before;
};

/// @{ Drills from text (`origin` stands for the file name in errors), from a folder's *.toml files in the
/// order of their numbers, and the built-in ones. Errors: kIo; kBadInput as `file:line: table.key ...`.
Result<Drill> parseDrill(std::string_view text, const std::string& origin);
Result<std::vector<Drill>> loadDrills(const std::string& folder);
const std::vector<Drill>& builtInDrills();
/// @}

/// The result of one trial.
struct DrillTrial {
  int start = 0;        ///< index of the drill's start
  bool counted = true;  ///< false: the trial was not as the start asks
  bool offered = true;  ///< false: the team does not offer the skill
  bool success = false;
  double time = std::numeric_limits<double>::infinity();   ///< [s]
  double ideal = 0.0;                                      ///< [s]
  double error = std::numeric_limits<double>::infinity();  ///< [m]
  bool on_target = false;
  bool own_goal = false;
  bool conceded = false;
  int illegal = 0;              ///< robots of the tested team whose proposed places had to be repaired
  std::string_view stopped_by;  ///< rule by which the referee ended it, static lifetime
};

/// One bar with the measured value.
struct DrillVerdict {
  DrillBar bar;
  int count = 0;   ///< number of trials or matches
  Interval value;  ///< measured value, with its 95 % interval if it has one
  bool passed = false;
};

/// The result of one drill.
struct DrillReport {
  Drill drill;
  bool offered = true;
  std::vector<DrillVerdict> verdicts;
  std::vector<DrillTrial> trials;
  /// Success (1 or 0) of each trial; goals ahead per full match, of whole matches. NaN: it does not count.
  std::vector<double> values;
  bool passed() const;
  /// Whether the drill plays whole matches.
  bool ofMatches() const { return !drill.match_opponent.empty(); }
};

/// Called repeatedly with the number of finished trials. Returning false stops the run.
using DrillProgress = std::function<bool(std::size_t done, std::size_t total)>;

struct DrillOptions {
  TeamChoice team;
  std::optional<TeamChoice> itself;  ///< plays where a drill asks for the team itself; empty: `team`
  TeamCatalogue catalogue = TeamCatalogue::builtIn();  ///< teams that drills may name as opponents
  int trials = 0;                                      ///< 0: as each drill says
  std::uint64_t seed = kDefaultMatchSeed;
  int jobs = 0;  ///< threads; 0: one per core
  std::string robot = "vsss";
  std::string physics = "standard";
};

/// Runs the drills with these numbers (all if there are none), one after the other. The result does not
/// depend on the number of jobs. Errors: kUsage and kBadInput for names, for starts that cannot be placed and
/// for repeated drills that `drills` lacks; kMachine; kInterrupted when `progress` returned false.
Result<std::vector<DrillReport>> runDrills(const std::vector<Drill>& drills, const std::vector<int>& numbers,
                                           const DrillOptions& options, const DrillProgress& progress);

/// @{ The reports as tables to read and as JSON.
std::string drillTable(const std::vector<DrillReport>& reports, const DrillOptions& options);
/// Several teams: one row per drill, one column per team.
std::string drillOverview(const std::vector<std::string>& teams,
                          const std::vector<std::vector<DrillReport>>& reports);
std::string drillJson(const std::vector<DrillReport>& reports, const DrillOptions& options);
/// @}

}  // namespace fulbito
