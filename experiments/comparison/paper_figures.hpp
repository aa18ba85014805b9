#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "experiments/comparison/comparison.hpp"

namespace fulbito {

/// Whether a run shows what a figure of the paper shows, with the figure that says so.
struct FigureVerdict {
  bool shown = false;
  std::string measured;  ///< half a sentence, e.g. "turns abruptly 4 times"
};

/// One of Jung & Lee's Figs 1-8 as a named case (docs/reproduction.md).
struct PaperFigure {
  std::string layout;               ///< name of the case
  std::string title;                ///< a sentence's beginning: "Fig. 1: ..."
  std::string sentence;             ///< what the paper's figure shows
  std::string method;               ///< the run that is to show it, as a navigator specification
  std::vector<std::string> beside;  ///< other runs drawn with it
  /// Lower left and upper right corner [m] of what is drawn, where the effect is small; else the whole field.
  std::optional<std::pair<Vec2, Vec2>> window;
  FigureVerdict (*judge)(const Layout& layout, const TrialRecord& run) = nullptr;
};

/// In the order of the figures.
const std::vector<PaperFigure>& paperFigures();

/// The figure of a named case; null for any other layout.
const PaperFigure* figureOf(const std::string& layout);

/// The methods of the figures' block: those that the figures are about, under both followers, and for
/// comparison others.
std::vector<std::string> figureMethods();

/// What one figure shows here.
struct FigureRow {
  const PaperFigure* figure = nullptr;
  FigureVerdict verdict;
};

/// The verdicts of all figures whose method took part in a comparison and whose traces were kept.
std::vector<FigureRow> judgeFigures(const Comparison& comparison);

/// @{ Measures of a run for the verdicts, over its trace.
/// Turns [rad] one way and the other in turn, each of more than `least`; what wobbles less is none.
std::vector<double> turnsOf(std::span<const TraceRow> trace, double least);
/// Farthest distance [m] of the robot's centre from the line start - goal, over the part of its way that is
/// between `from` and `to` [m] along that line; `left_only`: to the left of it.
double detourOf(const Layout& layout, std::span<const TraceRow> trace, double from, double to,
                bool left_only);
/// @}

}  // namespace fulbito
