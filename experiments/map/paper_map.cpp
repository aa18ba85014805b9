#include "experiments/map/paper_map.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

#include <fmt/format.h>

#include "engine/core/config/suggest.hpp"
#include "experiments/comparison/comparison_parts.hpp"
#include "experiments/comparison/paper_plan.hpp"
#include "experiments/comparison/summary.hpp"

namespace fulbito {
namespace {

constexpr int kMostSeeds = 100, kMostFresh = 100000;
constexpr std::size_t kMostValues = 40;      // greatest number of values in a list
constexpr std::size_t kMapResamples = 1000;  // a small number, since there are thousands of intervals
constexpr double kMostRing = 1.0;            // [m] the limit of the method's own parameters

struct Axes {
  std::vector<double> radii, widths, speeds;
  std::vector<bool> classic;
  std::vector<StartHeading> headings;
};

Result<void> checkLengths(const std::vector<double>& values, const char* flag) {
  if (values.size() > kMostValues) {
    return fail(ErrorCode::kUsage, fmt::format("{}: more than {} values", flag, kMostValues));
  }
  for (double value : values) {
    if (!(value >= 0.0 && value <= kMostRing)) {
      return fail(ErrorCode::kUsage, fmt::format("{}: {} is outside 0 ... {} m", flag, value, kMostRing));
    }
  }
  return {};
}

/// The index of `name` in `names`, or an error with a suggestion.
Result<std::size_t> placeOf(const std::string& name, const std::vector<std::string>& names,
                            const char* flag) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
  return fail(ErrorCode::kUsage, fmt::format("{}: '{}' must be one of {}.{}", flag, name,
                                             fmt::join(names, ", "), suggestion(name, names)));
}

Result<MapConfig> resolved(MapConfig config) {
  config.suites = {config.base.suite};
  if (config.base.suite == kPaperSuite) config.suites = {"corner", "close-range"};
  if (config.base.speeds.empty()) config.base.speeds = {0.6, 1.0, 1.2, 2.6};
  if (config.base.trials == 0) config.base.trials = 12;
  if (config.radii.empty()) config.radii = {0.0, 0.04, 0.08, 0.12, 0.16, 0.18, 0.20, 0.24};
  if (config.widths.empty()) config.widths = {0.01, 0.02, 0.05, 0.10, 0.15, 0.20, 0.30};
  if (config.laws.empty()) config.laws = {"preview", "classic"};
  if (config.headings.empty()) config.headings = {"goal", "random"};
  config.base.pictures = 0;
  config.base.navigators.clear();
  if (config.seeds < 1 || config.seeds > kMostSeeds) {
    return fail(ErrorCode::kUsage, fmt::format("--seeds: {} is outside 1 ... {}", config.seeds, kMostSeeds));
  }
  if (config.fresh < 0 || config.fresh > kMostFresh) {
    return fail(ErrorCode::kUsage, fmt::format("--fresh: {} is outside 0 ... {}", config.fresh, kMostFresh));
  }
  if (auto checked = checkLengths(config.radii, "--radii"); !checked) {
    return tl::unexpected<Error>(checked.error());
  }
  if (auto checked = checkLengths(config.widths, "--widths"); !checked) {
    return tl::unexpected<Error>(checked.error());
  }
  return config;
}

Result<Axes> axesOf(const MapConfig& config) {
  Axes axes{config.radii, config.widths, config.base.speeds, {}, {}};
  for (const std::string& law : config.laws) {
    const auto place = placeOf(law, {"preview", "classic"}, "--laws");
    if (!place) return tl::unexpected<Error>(place.error());
    axes.classic.push_back(*place == 1);
  }
  for (const std::string& heading : config.headings) {
    const auto place = placeOf(heading, {"goal", "random", "away"}, "--headings");
    if (!place) return tl::unexpected<Error>(place.error());
    axes.headings.push_back(static_cast<StartHeading>(*place));
  }
  return axes;
}

/// The Bezier method and every ring, all with one law.
Result<std::vector<NavigatorChoice>> methodsOf(const Axes& axes, bool classic) {
  const char* law = classic ? "classic" : "preview";
  std::vector<std::string> texts{fmt::format("bezier:follower={}", law)};
  for (double width : axes.widths) {
    for (double radius : axes.radii) {
      texts.push_back(fmt::format("vector-field:goal=bearing,offset={:.6g},width={:.6g},follower={}", radius,
                                  width, law));
    }
  }
  std::vector<NavigatorChoice> choices;
  for (const std::string& text : texts) {
    auto choice = parseNavigator(text);
    if (!choice) return tl::unexpected<Error>(choice.error());
    choices.push_back(std::move(*choice));
  }
  return choices;
}

/// The indices of the blocks of one law, heading and speed: one per seed, consecutive in the comparison.
std::vector<std::size_t> blocksFrom(std::size_t first, int seeds) {
  std::vector<std::size_t> blocks(static_cast<std::size_t>(seeds));
  std::iota(blocks.begin(), blocks.end(), first);
  return blocks;
}

/// Adds the safety and the time of one ring's own runs in some blocks to its cell.
void addOwn(const Comparison& comparison, std::span<const std::size_t> blocks, std::size_t ring,
            MapCell& cell) {
  int safe = 0, bezier_safe = 0;
  double ratios = 0.0;
  for (std::size_t block : blocks) {
    for (const TrialRecord& record : recordsOf(comparison, block, ring)) {
      ++cell.trials;
      safe += record.score.success() ? 1 : 0;
      ratios += record.score.success() ? record.score.timeRatio() : kFailureTimeRatio;
    }
    for (const TrialRecord& record : recordsOf(comparison, block, 0)) {
      bezier_safe += record.score.success() ? 1 : 0;
    }
  }
  cell.safe = wilson(safe, cell.trials);
  cell.bezier_safe = wilson(bezier_safe, cell.trials);
  cell.time_ratio_all = ratios / std::max(1, cell.trials);
}

void fillCells(PaperMap& map) {
  const MapConfig& config = map.config;
  map.cells.clear();
  for (std::size_t first = 0; first < map.comparison.blocks.size();
       first += static_cast<std::size_t>(config.seeds)) {
    const ComparisonBlock& block = map.comparison.blocks[first];
    const std::vector<std::size_t> blocks = blocksFrom(first, config.seeds);
    std::size_t ring = 1;
    for (double width : config.widths) {
      for (double radius : config.radii) {
        MapCell cell;
        cell.suite = block.suite->name;
        cell.radius = radius, cell.width = width;
        cell.classic = block.navigators[ring].classic_follower;
        cell.speed = block.speed, cell.heading = block.heading;
        addOwn(map.comparison, blocks, ring, cell);
        cell.cut = gapOf(map.comparison, blocks, ring, kHung);
        cell.raw = gapOf(map.comparison, blocks, ring, kNeverHung);
        map.cells.push_back(cell);
        ++ring;
      }
    }
  }
}

Result<void> addBlocks(const MapConfig& config, const Axes& axes, const Suite& suite,
                       std::vector<ComparisonBlock>& blocks) {
  for (bool classic : axes.classic) {
    const auto methods = methodsOf(axes, classic);
    if (!methods) return tl::unexpected<Error>(methods.error());
    for (StartHeading heading : axes.headings) {
      for (double speed : axes.speeds) {
        for (int i = 0; i < config.seeds; ++i) {
          blocks.push_back({&suite, speed, config.base.trials, *methods,
                            config.base.seed + static_cast<std::uint64_t>(i), heading});
        }
      }
    }
  }
  return {};
}

}  // namespace

MapGap gapOf(const Comparison& comparison, std::span<const std::size_t> blocks, std::size_t ring,
             double hung) {
  const PairedDifference difference = compareSafePairs(comparison, blocks, 0, ring, hung, kMapResamples);
  return {difference.pairs, difference.length, difference.time};
}

Result<PaperMap> planMap(const MapConfig& asked) {
  auto config = resolved(asked);
  if (!config) return tl::unexpected<Error>(config.error());
  const auto axes = axesOf(*config);
  if (!axes) return tl::unexpected<Error>(axes.error());
  auto comparison = prepareComparison(config->base);
  if (!comparison) return tl::unexpected<Error>(comparison.error());
  for (const std::string& name : config->suites) {
    const auto suite = findSuite(name);
    if (!suite) return tl::unexpected<Error>(suite.error());
    if (auto added = addBlocks(*config, *axes, **suite, comparison->blocks); !added) {
      return tl::unexpected<Error>(added.error());
    }
  }
  return PaperMap{std::move(*config), std::move(*comparison), {}, {}, {}};
}

Result<void> runMap(PaperMap& map, const Progress& progress) {
  if (auto ran = runComparison(map.comparison, {}, progress); !ran) return ran;
  fillCells(map);
  map.findings.clear();
  for (const std::string& suite : map.config.suites) {
    for (const PaperTarget& target : kPaperTargets) {
      for (bool with_hung : {false, true}) {
        map.findings.push_back(findTarget(map.cells, suite, target, with_hung));
      }
    }
  }
  return runFreshCells(map, progress);
}

double distanceTo(const PaperTarget& target, const MapGap& gap) {
  if (gap.pairs < kLeastMapPairs) return std::numeric_limits<double>::quiet_NaN();
  return std::max(std::abs(gap.length.value - target.length), std::abs(gap.time.value - target.time));
}

MapFinding findTarget(const std::vector<MapCell>& cells, const std::string& suite, const PaperTarget& target,
                      bool with_hung) {
  MapFinding finding{suite, target, with_hung, {}, 0, std::numeric_limits<double>::quiet_NaN()};
  const auto off = [&](std::size_t i) { return distanceTo(target, with_hung ? cells[i].raw : cells[i].cut); };
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const double distance = off(i);
    if (cells[i].suite != suite || std::isnan(distance)) continue;
    if (distance <= kTargetTolerance) finding.region.push_back(i);
    if (std::isnan(finding.off) || distance < finding.off) finding.nearest = i, finding.off = distance;
  }
  std::stable_sort(finding.region.begin(), finding.region.end(),
                   [&](std::size_t a, std::size_t b) { return off(a) < off(b); });
  return finding;
}

std::vector<std::size_t> safestCells(const std::vector<MapCell>& cells) {
  std::vector<std::size_t> best;
  const auto same_group = [&](const MapCell& a, const MapCell& b) {
    return a.suite == b.suite && a.classic == b.classic && a.heading == b.heading && a.speed == b.speed;
  };
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (best.empty() || !same_group(cells[best.back()], cells[i])) {
      best.push_back(i);
      continue;
    }
    const MapCell &now = cells[best.back()], &other = cells[i];
    const bool better = other.safe.value > now.safe.value ||
                        (other.safe.value == now.safe.value && other.time_ratio_all < now.time_ratio_all);
    if (better) best.back() = i;
  }
  return best;
}

RingRecord bestRing(const std::vector<MapCell>& cells, const std::string& suite) {
  std::map<std::pair<double, double>, std::pair<RingRecord, int>> rings;
  for (const MapCell& cell : cells) {
    if (cell.suite != suite) continue;
    auto& [ring, count] = rings[{cell.radius, cell.width}];
    ring.radius = cell.radius, ring.width = cell.width;
    ring.safe += cell.safe.value;
    ring.least_safe = std::min(ring.least_safe, cell.safe.value);
    ring.time_ratio_all += cell.time_ratio_all;
    ++count;
  }
  RingRecord best;
  best.time_ratio_all = std::numeric_limits<double>::infinity();
  for (auto& [size, entry] : rings) {
    auto& [ring, count] = entry;
    ring.safe /= count, ring.time_ratio_all /= count;
    if (ring.time_ratio_all < best.time_ratio_all) best = ring;
  }
  return best;
}

}  // namespace fulbito
