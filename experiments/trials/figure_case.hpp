#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "fulbito/experiment.hpp"

namespace fulbito {

/// What a run must do to show the effect of a figure of the paper. The case file sets the rule before any
/// run.
enum class FigureRule {
  kFails,            ///< never reaches the goal
  kTouchesObstacle,  ///< touches an obstacle
  kTouchesWall,      ///< touches a wall
  kTurns,            ///< turns left and right by at least `turn` each, at least `times` times
  kTurnsBack,        ///< turns clockwise, then counter-clockwise, by at least `turn` each, near its start
  /// is at least `off` to the left of the line start - goal after it has passed the last obstacle
  kBentBehind,
  kDrivesAway,  ///< drives at least `off` while it faces away from the goal
};

/// One navigator whose run is compared with a figure.
struct FigureRun {
  std::string navigator;  ///< specification
  bool judged = false;    ///< whether the paper's statement is about this method
};

/// The quantity that a sweep of a figure's layout varies.
enum class SweepKind {
  kBallDistance,  ///< [m] from the first obstacle's centre to the goal
  kObstacleGap,   ///< [m] from the body's front to the first obstacle, ahead of the start
  kWallGap,       ///< [m] from the body's front to the wall that it faces
  kHeading,       ///< [deg] heading of the start
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
  std::string title;     ///< heading, such as "Fig. 1: ..."
  std::string sentence;  ///< statement of the paper's figure
  FigureRule rule = FigureRule::kFails;
  int times = 1;        ///< @{ parameters of the rule
  double turn = 0.0;    ///< [rad]
  double within = 1e9;  ///< [m] of path in which an abrupt turn must happen
  double off = 0.0;     ///< [m] from the line, or of path
  double near = 1e9;    ///< @} [m] from the start
  std::vector<FigureRun> runs;
  /// Lower left and upper right corner [m] of the picture, for small effects; otherwise the whole field.
  std::optional<std::pair<Vec2, Vec2>> window;
  FigureSweep sweep;
};

/// Reads a case file. Errors: kBadInput with file and line.
Result<FigureCase> parseFigureCase(std::string_view text, const std::string& origin);

/// The run with the specification `navigator`; null if the figure has none.
const FigureRun* runOf(const FigureCase& figure, const std::string& navigator);

/// All cases in the order of the figures.
const std::vector<FigureCase>& paperFigures();

/// The rule in words, such as "turns by at least 20 degrees within 3.5 cm of way, at least 4 times".
std::string ruleText(const FigureCase& figure);

/// The value of a sweep at step `step`.
double sweepValue(const FigureSweep& sweep, int step);
/// The value with its unit, such as "13 mm" or "-45 degrees".
std::string sweepText(const FigureSweep& sweep, double value);
/// The varied quantity in words, such as "gap to the obstacle".
std::string_view nameOf(SweepKind kind);
/// The figure's layout with the swept quantity set to `value`.
Layout sweptLayout(const FigureCase& figure, double value);

/// An entry of the suite `sweeps`, which has all sweeps of all figures in turn.
struct SweepPlace {
  const FigureCase* figure = nullptr;
  double value = 0.0;
};
SweepPlace sweepPlace(std::uint64_t index);
int sweepPlaces();

}  // namespace fulbito
