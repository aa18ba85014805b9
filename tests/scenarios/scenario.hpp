#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fulbito/detail/values.hpp"
#include "fulbito/referee.hpp"

namespace fulbito::test {

/// How the bodies of a scenario move.
enum class ScenarioMode {
  kKinematic,  ///< exactly as scripted: straight on at their velocities, through one another
  kPhysics     ///< in a World, driven by wheel commands
};

/// How play begins.
enum class ScenarioStart {
  kGiven,   ///< from the scenario's robots and ball, the signal given
  kOpening  ///< from the rules' own kick-off
};

/// A robot at the start.
struct ScenarioRobot {
  RobotId id;
  Pose2 pose;
  Vec2 velocity;
};

/// What a body does from a time on. What is not given stays as it is.
struct ScenarioMove {
  double at = 0.0;                    ///< [s]
  std::optional<RobotId> robot;       ///< none: the ball
  std::optional<WheelSpeeds> wheels;  ///< physics
  std::optional<Vec2> position;       ///< kinematic: jumps there
  std::optional<double> heading;      ///< kinematic
  std::optional<Vec2> velocity;       ///< kinematic
};

/// Kinematic: two bodies press on each other in each tick of a time.
struct ScenarioContact {
  double from = 0.0, until = 0.0;  ///< [s]
  std::optional<RobotId> a;        ///< none: the nearest wall, on the ball
  std::optional<RobotId> b;        ///< none: the ball
  double impulse = 0.01;           ///< [kg m/s] in each tick, from a to b
};

/// An event that must come, once.
struct ExpectedEvent {
  std::string clause;
  std::optional<TeamId> team;
  std::optional<int> robot;            ///< -1: no robot may be named
  std::optional<RestartKind> restart;  ///< that play goes on with
  std::optional<TeamId> restart_team;
  double from = 0.0, until = 0.0;  ///< [s]
};

/// Where a robot must stand in the end, exactly.
struct ExpectedPlace {
  RobotId id;
  Vec2 position;
};

/// One situation and what the referee is to make of it.
struct Scenario {
  std::string name;         ///< rule/name, of its folder
  std::string description;  ///< one line
  Rules rules;
  ScenarioMode mode = ScenarioMode::kKinematic;
  ScenarioStart start = ScenarioStart::kGiven;
  bool goes_on = false;      ///< past the first stoppage
  double seconds = 1.0;      ///< that it lasts at most
  std::string forbid = "*";  ///< clauses that must not come, by commas; "*": all that are not expected
  PerTeam<bool> present{true, true};
  std::optional<Vec2> score;  ///< blue's and yellow's in the end
  Vec2 ball, ball_velocity;
  std::vector<ScenarioRobot> robots;  ///< of a given start the first one's team counts as who began
  std::vector<ScenarioMove> moves;
  std::vector<ScenarioContact> contacts;
  std::vector<ExpectedEvent> expected;
  std::vector<ExpectedPlace> places;
};

/// Reads `folder/scenario.toml`. Errors name file, line and key.
Result<Scenario> loadScenario(const std::string& folder, const std::string& name);

/// The same situation seen otherwise.
struct ScenarioVariant {
  bool sides = false;    ///< rotated by 180 degrees
  bool colours = false;  ///< blue's robots are yellow's and the other way round
};

/// Plays the scenario and returns what the referee called.
std::vector<GameEvent> eventsOf(const Scenario& scenario, ScenarioVariant variant);

/// Plays the scenario; empty if all is as expected, else what is not.
std::string playScenario(const Scenario& scenario, ScenarioVariant variant);

}  // namespace fulbito::test
