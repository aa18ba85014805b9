#pragma once

#include <string>
#include <vector>

#include "experiments/papers/hybrid/gap_layouts.hpp"
#include "fulbito/report.hpp"

namespace fulbito::hybrid {

/// What the experiment is asked for.
struct HybridSettings {
  int rows = 200;      ///< layouts like Fig. 8
  int gaps = 200;      ///< layouts with a gap of 1.3 widths; half as many of the other widths
  int kinds = 25;      ///< layouts of each kind of gap of 1.3 widths
  double speed = 0.3;  ///< [m/s] top speed
};

/// What a robot knows of its surroundings.
enum class Knowledge {
  kSonars,      ///< what its sonars hear
  kFineSonars,  ///< the same where a range's error is as large to this robot as 5 mm to the paper's
  kMap,         ///< all obstacles and walls
};

/// Gaps of one width, passed with one kind of knowledge.
struct GapBlock {
  double widths = 1.3;  ///< of the gap, in robot widths
  Knowledge knowledge = Knowledge::kSonars;
  std::vector<TrialScore> scores;
};

/// One layout like Fig. 8, driven with and without the nearness diagram.
struct RowPair {
  std::uint64_t index = 0;
  double gap = 0.0;  ///< [m] between the two obstacles at the straight way
  TrialScore with, without;
  TrialScore around;  ///< of a robot that knows the map and keeps too far off to take the gap

  bool bothArrive() const { return with.success() && without.success(); }
  /// Whether the diagram's way is the shorter one. A way that does not arrive is longer than any.
  bool isShorter() const { return with.success() && (!without.success() || with.length < without.length); }
};

/// Gaps of one kind, passed by one navigator with sonars only.
struct KindBlock {
  GapKind kind = GapKind::kDiscs;
  Knowledge knowledge = Knowledge::kSonars;
  std::string navigator;
  std::vector<TrialScore> scores;
};

/// Results of all runs.
struct HybridRuns {
  HybridSettings settings;
  std::vector<GapBlock> gaps;
  std::vector<RowPair> rows;
  std::vector<KindBlock> kinds;
};

/// A trial of a navigator. Errors: of presets and its name.
Result<TrialConfig> sonarTrial(const Layout& layout, Knowledge knowledge, const std::string& choice,
                               double speed, std::uint64_t seed, std::uint64_t index);
/// A trial of the hybrid, with or without its nearness diagram. Errors: of presets.
Result<TrialConfig> hybridTrial(const Layout& layout, Knowledge knowledge, bool with_diagram, double speed,
                                std::uint64_t seed, std::uint64_t index);

/// Runs all trials on `request.jobs` threads. Errors: of trials; kInterrupted.
Result<HybridRuns> runHybrid(const HybridSettings& settings, const ExperimentRequest& request);

}  // namespace fulbito::hybrid
