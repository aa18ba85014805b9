#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "fulbito/experiment.hpp"

namespace fulbito {

/// What a run must do to show what a figure of the paper shows. The case file names it, so that it is settled
/// before anything runs.
enum class FigureRule {
  kFails,            ///< never reaches the goal
  kTouchesObstacle,  ///< touches an obstacle
  kTouchesWall,      ///< touches a wall
  kTurns,            ///< turns left and right by at least `turn` each, at least `times` times
  kTurnsBack,        ///< turns clockwise, then counter-clockwise, by at least `turn` each, near its start
  kBentBehind,       ///< is at least `off` to the left of the line start - goal behind the last obstacle
  kDrivesAway,       ///< drives at least `off` while it faces away from the goal
};

/// One run of a figure.
struct FigureRun {
  std::string navigator;  ///< specification
  bool judged = false;    ///< the paper's statement is about this method; else it stands beside it
};

/// What a figure's layout is varied by.
enum class SweepKind {
  kBallDistance,  ///< [m] from the first obstacle's centre to the goal
  kObstacleGap,   ///< [m] from the body's front to the first obstacle, ahead of the start
  kWallGap,       ///< [m] from the body's front to the wall that it faces
  kHeading,       ///< [deg] of the start
};
struct FigureSweep {
  SweepKind kind = SweepKind::kHeading;
  double from = 0.0;
  double to = 0.0;
  int steps = 0;  ///< number of values, both ends included; 0: no sweep
};

/// One of Jung & Lee's Figs 1-8: the tables [figure], [[run]] and [sweep] of its case file.
struct FigureCase {
  Layout layout;         ///< the case
  std::string title;     ///< a heading: "Fig. 1: ..."
  std::string sentence;  ///< statement of the paper's figure
  FigureRule rule = FigureRule::kFails;
  int times = 1;        ///< @{ of the rule
  double turn = 0.0;    ///< [rad]
  double within = 1e9;  ///< [m] of way in which a turn must happen: an abrupt one
  double off = 0.0;     ///< [m] off the line, or of way
  double near = 1e9;    ///< @} [m] from the start
  std::vector<FigureRun> runs;
  /// Lower left and upper right corner [m] of the picture, if the effect is small; else the whole field.
  std::optional<std::pair<Vec2, Vec2>> window;
  FigureSweep sweep;
};

/// Reads a case file. Errors: kBadInput with file and line.
Result<FigureCase> parseFigureCase(std::string_view text, const std::string& origin);

/// The run of that specification; null if the file names none.
const FigureRun* runOf(const FigureCase& figure, const std::string& navigator);

/// In the order of the figures.
const std::vector<FigureCase>& paperFigures();

/// The rule in words: "turns by at least 20 degrees within 3.5 cm of way, at least 4 times".
std::string ruleText(const FigureCase& figure);

/// The value of step `step` of a sweep.
double sweepValue(const FigureSweep& sweep, int step);
/// The value with its unit: "13 mm", "-45 degrees".
std::string sweepText(const FigureSweep& sweep, double value);
/// What is varied: "gap to the obstacle".
std::string_view nameOf(SweepKind kind);
/// The figure's layout with the swept quantity set to `value`.
Layout sweptLayout(const FigureCase& figure, double value);

/// A place in the suite `sweeps`: all sweeps of all figures one after the other.
struct SweepPlace {
  const FigureCase* figure = nullptr;
  double value = 0.0;
};
SweepPlace sweepPlace(std::uint64_t index);
int sweepPlaces();

}  // namespace fulbito
