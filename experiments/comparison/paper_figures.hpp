#pragma once

#include <span>
#include <string>
#include <vector>

#include "experiments/trials/figure_case.hpp"
#include "fulbito/experiment.hpp"

namespace fulbito {

/// Whether a run behaves as its figure's rule says, and how it behaves.
struct FigureVerdict {
  bool shown = false;
  std::string measured;  ///< a phrase, e.g. "turns abruptly 4 times"
};

/// Judges one run on `layout`, which is the figure's case or a swept one. Needs the run's trace and touches.
FigureVerdict judgeRun(const FigureCase& figure, const Layout& layout, const TrialRecord& run);

/// The figure of a named case; null for any other layout.
const FigureCase* figureOf(const std::string& layout);

/// The methods of the figures' block: those of all runs of all figures, and the default navigator.
std::vector<std::string> figureMethods();

struct JudgedRun {
  const FigureRun* run = nullptr;
  FigureVerdict verdict;
};

/// The runs of one figure at one top speed, in the order of the case file.
struct FigureRow {
  const FigureCase* figure = nullptr;
  double speed = 0.0;  ///< [m/s]
  double value = 0.0;  ///< swept quantity; only in a sweep
  std::vector<JudgedRun> runs;
};

/// Summary of the judged runs: "yes" if all follow the rule, "no" if none does, else "partly".
std::string_view verdictOf(const FigureRow& row);

/// All figures whose runs are in the comparison with their traces.
std::vector<FigureRow> judgeFigures(const Comparison& comparison);
/// All values of the figures' sweeps in the comparison, by figure, speed and value.
std::vector<FigureRow> judgeSweeps(const Comparison& comparison);

/// @{ Measures of a run's trace for the verdicts.
struct HeadingTurn {
  double angle = 0.0;   ///< [rad] to the left
  double abrupt = 0.0;  ///< [rad] the greatest part of it within `within` of path
};
/// Alternating left and right turns of more than `least` [rad] each; smaller wobbles do not count.
std::vector<HeadingTurn> turnsOf(std::span<const TraceRow> trace, double least, double within = 1e9);
/// Largest distance [m] of the robot's centre from the line start - goal, for places between `from` and `to`
/// [m] along that line. `left_only`: only to the left of the line.
double detourOf(const Layout& layout, std::span<const TraceRow> trace, double from, double to,
                bool left_only);
/// @}

}  // namespace fulbito
