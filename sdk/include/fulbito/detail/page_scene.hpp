#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "fulbito/detail/field_geometry.hpp"
#include "fulbito/detail/values.hpp"
#include "fulbito/recording.hpp"

namespace fulbito {

/// A body as the viewer draws it.
struct PageBody {
  BodyKind kind = BodyKind::kRobot;  ///< never kWall
  std::optional<RobotId> id;         ///< team and number of a match's robot
  bool box = false;                  ///< a rectangle; false: a disc
  double length = 0.0;               ///< [m] of a box along its x
  double width = 0.0;                ///< [m] of a box along its y
  double radius = 0.0;               ///< [m] of a disc
};

/// The poses of all bodies at one tick.
struct PageRow {
  Tick tick = 0;
  std::vector<Pose2> poses;  ///< one per body; any finite value if it is absent
};

/// A play without jumps: bodies are interpolated between its rows.
struct PagePlay {
  std::size_t row = 0;  ///< index of its first row
  Tick tick = 0;        ///< tick of that row
  Tick signal = 0;      ///< the clock runs from here on; beyond the play's end: never
  double clock = 0.0;   ///< [s] time in the period at the beginning
  int period = 1;
  std::string kind;               ///< kind of restart, e.g. kick-off; empty for a trial
  std::optional<TeamId> team;     ///< the team that takes the restart
  std::optional<TeamId> favours;  ///< team whose colour the restart has, see `CallWords`
  PerTeam<int> score{};
  Side blue_side = Side::kLeft;
  std::vector<std::uint8_t> present;  ///< per body: whether it is on the field
};

/// Wheel commands of the robots at every `every`-th tick.
struct PageCommands {
  int every = 6;
  std::vector<WheelSpeeds> values;  ///< for each of these ticks, from 0 on, one per robot
};

/// The result of one navigator in a race.
struct PageRun {
  std::string label;    ///< specification of the navigator
  std::string outcome;  ///< a TrialOutcome's name
  bool success = false;
  double seconds = 0.0;       ///< [s] time until its end
  double length = 0.0;        ///< [m] driven
  double time_ratio = 0.0;    ///< over T*
  double length_ratio = 0.0;  ///< over L*
};

/// The task of a trial.
struct PageTask {
  Pose2 start;
  Vec2 goal;
  double tolerance = 0.03;  ///< [m]
  std::optional<double> heading;
};

/// One match, trial or race.
struct PageScene {
  std::string title;
  std::vector<std::string> teams;  ///< of a match: blue's and yellow's specification
  FieldGeometry field;
  double rate = 60.0;  ///< [Hz] ticks per second
  Tick ticks = 0;
  std::vector<PageBody> bodies;  ///< robots, then balls, then obstacles
  std::vector<PageRow> rows;
  std::vector<PagePlay> plays;
  std::vector<RecordedEvent> events;
  std::vector<RecordedDrawing> drawings;
  Tick drawing_ticks = 12;  ///< time for which a drawing is shown unless a newer one replaces it
  PageCommands commands;
  std::optional<RecordingResult> result;  ///< of a finished recording
  std::optional<PageTask> task;
  std::vector<PageRun> runs;  ///< of a race: one per robot
  std::uint64_t seed = 0;
  /// Further facts as pairs of name and text, in the order of display.
  std::vector<std::pair<std::string, std::string>> facts;
};

/// Rounding steps of the page's values.
inline constexpr double kPagePlaceStep = 5e-4;    ///< [m]
inline constexpr double kPageHeadingStep = 5e-3;  ///< [rad]
inline constexpr double kPageCommandStep = 1.0;   ///< [rad/s]

}  // namespace fulbito
