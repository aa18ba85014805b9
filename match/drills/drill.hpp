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
  kTeam,   ///< it belongs to a team and does what that decides
  kStand,  ///< nothing
  kChase,  ///< straight at the ball
  kKeep,   ///< keeps goal at the point that leaves equal gaps on both sides of it
  kPress   ///< drives at the ball from the far side of its own goal, and pushes
};

/// A family of starts of a drill: where the ball is, how it moves and what is asked.
struct DrillStart {
  std::string name = "all";
  DrillTask task = DrillTask::kPlay;
  int restart = -1;          ///< `RestartKind` that play begins with; -1: none that is told
  bool ours = true;          ///< the tested team takes it
  std::string opponents;     ///< team specification, "itself", or empty: the robots' own roles
  double duration = 0.0;     ///< [s] instead of the drill's; 0: the drill's
  std::vector<Vec2> ball;    ///< [m] places that trials take in turn
  Vec2 ball_spread;          ///< [m] uniformly to either side of the place
  std::vector<Vec2> toward;  ///< [m] the ball rolls toward a point between the first and the last
  double speed_min = 0.0;    ///< [m/s] of the ball
  double speed_max = 0.0;
  double distance_min = 0.0;  ///< [m] of the ball from the point it rolls toward, instead of `ball`
  double distance_max = 0.0;
  double savable = 0.0;     ///< that many times the least savable distance is added to the distance
  double angle = 0.0;       ///< [rad] largest angle between the ball's way and the goal's normal
  bool enters = false;      ///< the untouched ball goes into the own goal
  int bounces = -1;         ///< of the ball against walls until it is in or the prediction is due; -1: any
  bool decided = false;     ///< only trials count that came to a success or a failure in time
  double target_min = 0.0;  ///< [m] distance of the task's target
  double target_max = 0.0;
  double turn_min = 0.0;  ///< [rad] angle between the robot's heading and the task's
  double turn_max = 0.0;
  double task_speed = 0.0;  ///< [m/s] asked for
  double horizon = 0.0;     ///< [s] of a prediction
};

/// The start of one robot.
struct DrillRobot {
  TeamId team = TeamId::kBlue;  ///< blue stands for the team under test
  int number = -1;              ///< in its team; -1: the next one
  DrillRole plays = DrillRole::kTeam;
  std::string start;            ///< only in the start of that name; empty: in all
  std::vector<Vec2> at;         ///< [m] places that are taken in turn
  Vec2 spread;                  ///< [m] uniformly to either side
  bool from_ball = false;       ///< `at` counts from the ball
  bool behind_ball = false;     ///< and along the line from the ball to the opponents' goal, which is its x
  bool equal_gap = false;       ///< y is the ball's bisector point: gaps to both posts are equal
  bool face_ball = false;       ///< `heading` counts from the direction of the ball
  double heading = 0.0;         ///< [rad]
  double heading_spread = 0.0;  ///< [rad] uniformly to either side
};

/// A condition on the ball.
enum class DrillCondition : std::uint8_t {
  kGoal,       ///< in the opponents' goal
  kConceded,   ///< in the own goal
  kTouched,    ///< an own robot touched it
  kGained,     ///< it is `value` [m] nearer to the opponents' end than at the start
  kDriven,     ///< it is `value` [m] nearer to the own end than at the start
  kOffWall,    ///< it is `value` [m] off the nearest wall
  kAway,       ///< it is `value` [m] from where it started
  kNearMouth,  ///< it is less than `value` [m] from the opponents' goal mouth
  kCleared,    ///< it is out of the own goal area by `value` [m]
  kLasted      ///< time is up
};

/// A condition that ends a trial, well or badly.
struct DrillEnd {
  DrillCondition what = DrillCondition::kGoal;
  std::string start;    ///< only in the start of that name; empty: in all
  double value = 0.0;   ///< see DrillCondition
  double within = 1e9;  ///< [s] only up to this time
};

/// What is measured in a trial or a match.
enum class DrillMeasure : std::uint8_t {
  kSuccess,    ///< of trials: 1 or 0
  kTime,       ///< [s] to success; a failure counts as infinity
  kExcess,     ///< [s] time beyond the least that the robot could need
  kError,      ///< [m] of the task: prediction, drift
  kOnTarget,   ///< the ball went into the goal or toward it
  kOwnGoal,    ///< conceded, and an own robot touched the ball last
  kConceded,   ///< the ball went into the own goal
  kIllegal,    ///< placements of a restart that had to be repaired
  kEarlyGoal,  ///< restarts after which a goal was conceded within 5 s
  kAreaFoul,   ///< fouls at the areas, per match
  kOwnStall,   ///< stuck balls in the own area, per match
  kSwitch,     ///< times a role changed hands, per second
  kFlap,       ///< such changes less than 0.3 s after the one before, with no event between
  kWin,        ///< matches won
  kMargin,     ///< goals more than the opponent, per match
  kBias,       ///< difference between the margins on the two sides, in its standard deviations
  kKept        ///< share of the success of other drills that is left under worse sight
};

enum class DrillStatistic : std::uint8_t { kRate, kCount, kMean, kMedian, kP95 };

/// One bar. Rates are judged by the end of their 95 % Wilson interval that is nearer to failing.
struct DrillBar {
  DrillMeasure value = DrillMeasure::kSuccess;
  DrillStatistic statistic = DrillStatistic::kRate;
  std::string start;  ///< of the trials with the start of that name; empty: of all
  double within = std::numeric_limits<double>::quiet_NaN();  ///< a rate of values that are at most that
  double at_least = std::numeric_limits<double>::quiet_NaN();
  double at_most = std::numeric_limits<double>::quiet_NaN();
  bool by_value = false;  ///< a rate is judged by itself, not by its interval
};

/// A drill as read from its file.
struct Drill {
  std::string file;  ///< where it comes from, for messages
  int number = 0;
  std::string name;
  std::string what;    ///< one line
  std::string source;  ///< why the bars are what they are, so that anyone can check it
  std::string rules = "vsss-3v3";
  bool referee = true;                ///< false: nothing but a goal stops play
  int trials = 400;                   ///< or matches, or half of them where pairs are played
  double duration = 10.0;             ///< [s]
  double after = 0.0;                 ///< [s] that are still watched after a success
  double latency = 0.05;              ///< [s] T of the least savable distance
  double acceleration = 5.0;          ///< [m/s^2] of the same
  double tolerance = 0.015;           ///< [m] of a task
  double heading_tolerance = 0.1396;  ///< [rad] of a task
  std::vector<DrillStart> starts;
  std::vector<DrillRobot> robots;
  std::vector<DrillEnd> successes;
  std::vector<DrillEnd> failures;
  std::vector<DrillBar> bars;
  std::string match_opponent;   ///< whole matches against that team ("itself"); empty: trials
  double half_seconds = 300.0;  ///< of such a match
  std::vector<int> repeats;     ///< drills that are repeated under the sight below, and compared
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
  bool counted = true;  ///< false: it was not the situation that was asked for
  bool offered = true;  ///< false: the team knows no such skill
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
  int count = 0;   ///< of trials or matches
  Interval value;  ///< with its 95 % interval, where it has one
  bool passed = false;
};

/// The result of one drill.
struct DrillReport {
  Drill drill;
  bool offered = true;
  std::vector<DrillVerdict> verdicts;
  std::vector<DrillTrial> trials;
  bool passed() const;
};

/// Called repeatedly with the number of finished trials. Returning false stops the run.
using DrillProgress = std::function<bool(std::size_t done, std::size_t total)>;

struct DrillOptions {
  TeamChoice team;
  TeamCatalogue catalogue = TeamCatalogue::builtIn();  ///< of the opponents that drills name
  int trials = 0;                                      ///< 0: as each drill says
  std::uint64_t seed = kDefaultMatchSeed;
  int jobs = 0;  ///< threads; 0: one per core
  std::string robot = "vsss";
  std::string physics = "standard";
};

/// Runs those of the drills whose numbers are asked for (all when none is), one after the other. The result
/// does not depend on the number of jobs. Errors: kUsage and kBadInput of names, of starts that cannot be
/// placed, of repeated drills that `drills` lacks; kMachine; kInterrupted when `progress` returned false.
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
