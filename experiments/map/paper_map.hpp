#pragma once

#include <array>
#include <string>
#include <vector>

#include "experiments/comparison/comparison.hpp"

namespace fulbito {

/// The two figures of one of the paper's results, as ratios: -0.256 is 25.6 % less.
struct PaperTarget {
  const char* name;  ///< what the paper calls it
  double length;
  double time;
};
/// What Jung & Lee (2015) print: of their simulation and of their experiment.
inline constexpr std::array<PaperTarget, 2> kPaperTargets{
    {{"simulation", -0.256, -0.193}, {"experiment", -0.273, -0.235}}};
/// Both figures of a cell must be this near to the paper's to hold together.
inline constexpr double kTargetTolerance = 0.02;
/// A cell with fewer safe pairs has no say: its means would be of a few lucky runs.
inline constexpr int kLeastMapPairs = 10;

/// What the map of the ring field is asked for. Empty lists mean the defaults.
struct MapConfig {
  /// Filled in by planMap: base.suite, or for the paper's own comparison its long and its short runs.
  std::vector<std::string> suites;
  ComparisonConfig base;              ///< suite, speeds, trials (layouts of each seed), first seed, robot ...
  int seeds = 3;                      ///< of layouts: base.seed and the numbers after it
  std::vector<double> radii;          ///< [m] `offset` of the ring
  std::vector<double> widths;         ///< [m] `width` of the ring
  std::vector<std::string> laws;      ///< `preview`, `classic`
  std::vector<std::string> headings;  ///< `goal`, `random`, `away`
};

/// Bezier against the ring on the layouts that both solved, as ratios; NaN without a pair.
struct MapGap {
  int pairs = 0;
  Interval length;
  Interval time;
};

/// One ring under one law, at one speed, from one kind of start. The Bezier method drives under the same law.
struct MapCell {
  std::string suite;
  double radius = 0.0;  ///< [m]
  double width = 0.0;   ///< [m]
  bool classic = false;
  double speed = 0.0;  ///< [m/s]
  StartHeading heading = StartHeading::kLayout;
  int trials = 0;
  Interval safe;              ///< share of the ring's runs that arrived and touched nothing
  Interval bezier_safe;       ///< the same of the Bezier method
  double time_ratio_all = 0;  ///< mean T/T* of the ring, failures as 8
  MapGap cut;                 ///< without pairs in which a run hung (over 4 T*)
  MapGap raw;                 ///< with them
};

/// Where the paper's two figures of one result hold together.
struct MapFinding {
  std::string suite;
  PaperTarget target;
  bool with_hung = false;
  std::vector<std::size_t> region;  ///< cells in which they do, nearest first
  std::size_t nearest = 0;          ///< the cell that comes nearest, also where the region is not empty
  double off = 0.0;                 ///< of that cell: the larger of both differences; NaN: no cell counts
};

/// The map: cells in the order suite, law, heading, speed, width, radius.
struct PaperMap {
  MapConfig config;       ///< resolved
  Comparison comparison;  ///< all its trials
  std::vector<MapCell> cells;
  std::vector<MapFinding> findings;  ///< each suite and target, without and with hung runs
};

/// Checks names and ranges and lays out the trials. Errors: kUsage, kIo, kBadInput.
Result<PaperMap> planMap(const MapConfig& config);

/// Drives all trials and fills in cells and findings. Errors: as runComparison.
Result<void> runMap(PaperMap& map, const Progress& progress);

/// How far `gap` is from the target: the larger of both differences; NaN when it has too few pairs.
double distanceTo(const PaperTarget& target, const MapGap& gap);

/// Searches the cells of a suite for the target.
MapFinding findTarget(const std::vector<MapCell>& cells, const std::string& suite, const PaperTarget& target,
                      bool with_hung);

/// The cell of each suite, law, heading and speed whose ring is the safest by its own runs; of equally safe
/// ones the fastest. It never looks at the gap.
std::vector<std::size_t> safestCells(const std::vector<MapCell>& cells);

/// A ring by its own runs under all laws, from all starts and at all speeds of a map.
struct RingRecord {
  double radius = 0.0, width = 0.0;  ///< [m]
  double safe = 0.0;                 ///< mean share of safe runs
  double least_safe = 1.0;           ///< the share where it is least
  double time_ratio_all = 0.0;       ///< mean T/T*, failures as 8
};
/// The ring of a suite whose mean `time_ratio_all` is the least: one setting for all uses. It never looks at
/// the gap.
RingRecord bestRing(const std::vector<MapCell>& cells, const std::string& suite);

/// For people: what was found, and the safest ring of each suite, law, heading and speed.
std::string mapReport(const PaperMap& map);
/// One line a cell, with a header.
std::string mapCsv(const PaperMap& map);
/// As one JSON object (docs/results-format.md) with a final newline.
std::string mapJson(const PaperMap& map, double wall_seconds);
/// A picture for each suite and law into `folder`, such as map-corner-classic.png. Returns the file names.
/// Errors: kIo.
Result<std::vector<std::string>> writeMapPictures(const PaperMap& map, const std::string& folder);

}  // namespace fulbito
