#pragma once

#include <span>
#include <string>
#include <vector>

#include "experiments/comparison/paper_results.hpp"
#include "fulbito/experiment.hpp"

namespace fulbito {

/// A cell matches a result if both numbers differ by at most this.
inline constexpr double kTargetTolerance = 0.02;
/// Number of fresh seeds, and the offset of the first of them from the map's first seed.
inline constexpr int kFreshSeeds = 3;
inline constexpr std::uint64_t kFreshSeedOffset = 7000003;
/// Cells with fewer safe pairs are ignored: their means would depend on a few lucky runs.
inline constexpr int kLeastMapPairs = 10;

/// The configuration of the ring map. Empty lists mean the defaults.
struct MapConfig {
  /// Set by planMap: `base.suite`, or the long and the short suite of the paper's comparison.
  std::vector<std::string> suites;
  ComparisonConfig base;  ///< suite, speeds, trials (number of layouts per seed), first seed, robot ...
  int seeds = 3;          ///< number of layout seeds, counted up from base.seed
  /// Number of layouts of each of `kFreshSeeds` other seeds, on which the cells nearest to the paper run
  /// again; 0: none.
  int fresh = 400;
  std::vector<double> radii;          ///< [m] `offset` of the ring
  std::vector<double> widths;         ///< [m] `width` of the ring
  std::vector<std::string> laws;      ///< `preview`, `classic`
  std::vector<std::string> headings;  ///< `goal`, `random`, `away`
};

/// Relative difference of the Bezier method to the ring on layouts that both solve; NaN without a pair.
struct MapGap {
  int pairs = 0;
  Interval length;
  Interval time;
};

/// One ring with one law, speed and kind of start. The Bezier method uses the same law.
struct MapCell {
  std::string suite;
  double radius = 0.0;  ///< [m]
  double width = 0.0;   ///< [m]
  bool classic = false;
  double speed = 0.0;  ///< [m/s]
  StartHeading heading = StartHeading::kLayout;
  int trials = 0;
  Interval safe;              ///< share of the ring's runs that arrived without contact
  Interval bezier_safe;       ///< the same for the Bezier method
  double time_ratio_all = 0;  ///< mean T/T* of the ring; a failure counts as 8
  MapGap cut;                 ///< without pairs in which a run hung (over 4 T*)
  MapGap raw;                 ///< including pairs in which a run hung
};

/// The cells that match both numbers of one of the paper's results.
struct MapFinding {
  std::string suite;
  PaperTarget target;
  bool with_hung = false;
  std::vector<std::size_t> region;  ///< matching cells, nearest first
  std::size_t nearest = 0;          ///< the nearest cell, even if `region` is empty
  double off = 0.0;                 ///< its larger difference to the result; NaN: no cell has enough pairs
};

/// The cell nearest to one of the paper's results, measured on layouts that had no part in the choice. The
/// nearest of many cells is partly luck, so its values on the layouts of the choice are too good.
struct FreshCell {
  std::size_t cell = 0;         ///< index in `PaperMap::cells`
  std::vector<MapGap> by_seed;  ///< per fresh seed, without hung runs
  MapGap cut;                   ///< @{ of all fresh seeds, without and with hung runs
  MapGap raw;                   ///< @}
  Interval safe;                ///< share of the ring's runs that arrived without contact
};

/// The map: cells in the order suite, law, heading, speed, width, radius.
struct PaperMap {
  MapConfig config;       ///< with defaults filled in
  Comparison comparison;  ///< all its trials
  std::vector<MapCell> cells;
  std::vector<MapFinding> findings;  ///< per suite and target, without and with hung runs
  std::vector<FreshCell> fresh;      ///< the nearest cells of the findings, each once
};

/// Checks names and ranges and plans the trials. Errors: kUsage, kIo, kBadInput.
Result<PaperMap> planMap(const MapConfig& config);

/// Runs all trials and fills in cells and findings. Errors: as runComparison.
Result<void> runMap(PaperMap& map, const Progress& progress);

/// Bezier method against method `ring` of a comparison in the blocks `blocks`; see kHung.
MapGap gapOf(const Comparison& comparison, std::span<const std::size_t> blocks, std::size_t ring,
             double hung);

/// Runs the nearest cells of all findings on fresh layouts and fills in `map.fresh`. Errors: as
/// runComparison.
Result<void> runFreshCells(PaperMap& map, const Progress& progress);

/// Difference between `gap` and the target: the larger one of length and time; NaN with too few pairs.
double distanceTo(const PaperTarget& target, const MapGap& gap);

/// Finds the cells of a suite that match the target.
MapFinding findTarget(const std::vector<MapCell>& cells, const std::string& suite, const PaperTarget& target,
                      bool with_hung);

/// For each suite, law, heading and speed, the cell whose ring is safest in its own runs, and the fastest of
/// equally safe ones. Does not use the gap.
std::vector<std::size_t> safestCells(const std::vector<MapCell>& cells);

/// A ring's own runs over all laws, starts and speeds of a map.
struct RingRecord {
  double radius = 0.0, width = 0.0;  ///< [m]
  double safe = 0.0;                 ///< mean share of safe runs
  double least_safe = 1.0;           ///< smallest share of safe runs
  double time_ratio_all = 0.0;       ///< mean T/T*; a failure counts as 8
};
/// The ring of a suite with the least mean `time_ratio_all`: one setting for all uses. Does not use the gap.
RingRecord bestRing(const std::vector<MapCell>& cells, const std::string& suite);

/// Readable lines on the nearest cells: results on their own and on fresh layouts. Empty without fresh cells.
std::string freshReport(const PaperMap& map);
/// Readable text: the findings, the fresh layouts, and the safest ring per suite, law, heading and speed.
std::string mapReport(const PaperMap& map);
/// CSV with one line per cell and a header.
std::string mapCsv(const PaperMap& map);
/// As one JSON object (docs/results-format.md) with a final newline.
std::string mapJson(const PaperMap& map, double wall_seconds);
/// Writes one picture per suite and law to `folder`, such as map-corner-classic.png. Returns the file names.
/// Errors: kIo.
Result<std::vector<std::string>> writeMapPictures(const PaperMap& map, const std::string& folder);

}  // namespace fulbito
