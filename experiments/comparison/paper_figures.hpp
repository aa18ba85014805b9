#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "fulbito/experiment.hpp"

namespace fulbito {

/// Whether a run confirms a figure of the paper, with the measured value.
struct FigureVerdict {
  bool shown = false;
  std::string measured;  ///< a phrase, e.g. "turns abruptly 4 times"
};

/// One of Jung & Lee's Figs 1-8 as a named case (docs/reproduction.md).
struct FigureClaim {
  std::string layout;               ///< name of the case
  std::string title;                ///< a heading: "Fig. 1: ..."
  std::string sentence;             ///< statement of the paper's figure
  std::string method;               ///< navigator specification of the run that should confirm it
  std::vector<std::string> others;  ///< other runs in the same picture
  /// Lower left and upper right corner [m] of the picture, if the effect is small; else the whole field.
  std::optional<std::pair<Vec2, Vec2>> window;
  FigureVerdict (*judge)(const Layout& layout, const TrialRecord& run) = nullptr;
};

/// In the order of the figures.
const std::vector<FigureClaim>& paperFigures();

/// The figure of a named case; null for any other layout.
const FigureClaim* figureOf(const std::string& layout);

/// The methods of the figures' block: the figures' own methods with both followers, and others for
/// comparison.
std::vector<std::string> figureMethods();

/// The verdict on one figure.
struct FigureRow {
  const FigureClaim* figure = nullptr;
  FigureVerdict verdict;
};

/// The verdicts on all figures whose method took part in the comparison and whose traces were kept.
std::vector<FigureRow> judgeFigures(const Comparison& comparison);

/// @{ Measures of a run for the verdicts, over its trace.
/// Alternating left and right turns [rad] of more than `least` each; smaller wobbles do not count.
std::vector<double> turnsOf(std::span<const TraceRow> trace, double least);
/// Largest distance [m] of the robot's centre from the line start - goal, over the part of its path between
/// `from` and `to` [m] along that line. `left_only`: only to the left of the line.
double detourOf(const Layout& layout, std::span<const TraceRow> trace, double from, double to,
                bool left_only);
/// @}

}  // namespace fulbito
