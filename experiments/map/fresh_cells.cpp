#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

#include "experiments/comparison/comparison_parts.hpp"
#include "experiments/comparison/summary.hpp"
#include "experiments/map/paper_map.hpp"

namespace fulbito {
namespace {

std::vector<std::size_t> nearestCells(const PaperMap& map) {
  std::vector<std::size_t> cells;
  for (const MapFinding& finding : map.findings) {
    const bool known = std::find(cells.begin(), cells.end(), finding.nearest) != cells.end();
    if (!std::isnan(finding.off) && !known) cells.push_back(finding.nearest);
  }
  return cells;
}

/// Adds the blocks of one cell on the fresh seeds, with the cell's Bezier method and ring.
void addFreshBlocks(const PaperMap& map, std::size_t cell, std::vector<ComparisonBlock>& blocks) {
  const std::size_t rings = map.config.radii.size() * map.config.widths.size();
  const std::size_t first = cell / rings * static_cast<std::size_t>(map.config.seeds);
  ComparisonBlock block = map.comparison.blocks[first];
  block.navigators = {block.navigators[0], block.navigators[1 + cell % rings]};
  block.trials = map.config.fresh;
  for (int i = 0; i < kFreshSeeds; ++i) {
    block.seed = map.config.base.seed + kFreshSeedOffset + static_cast<std::uint64_t>(i);
    blocks.push_back(block);
  }
}

FreshCell freshCell(const Comparison& comparison, std::size_t cell, std::size_t first) {
  std::vector<std::size_t> blocks(kFreshSeeds);
  std::iota(blocks.begin(), blocks.end(), first);
  FreshCell fresh;
  fresh.cell = cell;
  int safe = 0, trials = 0;
  for (const std::size_t& block : blocks) {
    fresh.by_seed.push_back(gapOf(comparison, {&block, 1}, 1, kHung));
    for (const TrialRecord& record : recordsOf(comparison, block, 1)) {
      safe += record.score.success() ? 1 : 0;
      ++trials;
    }
  }
  fresh.cut = gapOf(comparison, blocks, 1, kHung);
  fresh.raw = gapOf(comparison, blocks, 1, kNeverHung);
  fresh.safe = wilson(safe, trials);
  return fresh;
}

std::string pairText(const MapGap& gap) {
  if (gap.pairs == 0) return "-";
  return fmt::format("{:+.1f}, {:+.1f} %", 100 * gap.length.value, 100 * gap.time.value);
}

const char* within(const PaperTarget& target, const MapGap& gap) {
  return distanceTo(target, gap) <= kTargetTolerance ? "yes" : "no";
}

}  // namespace

Result<void> runFreshCells(PaperMap& map, const Progress& progress) {
  map.fresh.clear();
  if (map.config.fresh == 0) return {};
  const std::vector<std::size_t> cells = nearestCells(map);
  Comparison comparison;
  comparison.config = map.config.base;
  comparison.robot = map.comparison.robot;
  comparison.physics = map.comparison.physics;
  for (std::size_t cell : cells) addFreshBlocks(map, cell, comparison.blocks);
  if (auto ran = runComparison(comparison, {}, progress); !ran) return ran;
  for (std::size_t k = 0; k < cells.size(); ++k) {
    map.fresh.push_back(freshCell(comparison, cells[k], k * kFreshSeeds));
  }
  return {};
}

std::string freshReport(const PaperMap& map) {
  if (map.fresh.empty()) return {};
  std::string out = fmt::format(
      "\n### The nearest cells on fresh layouts (seeds {} ... {}, {} each)\n\n"
      "A cell is chosen by its figures on the map's own layouts. These had no part in it. Distance and time, "
      "without hung runs; within: both within {:.0f} points of the paper, on the map's and on all fresh "
      "layouts.\n\n"
      "| suite | radius, width cm | law | m/s | start | paper | on the map | fresh, by seed | all fresh "
      "(with "
      "hung) | safe | within |\n|---|---|---|---|---|---|---|---|---|---|---|\n",
      map.config.base.seed + kFreshSeedOffset, map.config.base.seed + kFreshSeedOffset + kFreshSeeds - 1,
      map.config.fresh, 100 * kTargetTolerance);
  for (const MapFinding& finding : map.findings) {
    if (finding.with_hung || std::isnan(finding.off)) continue;
    const auto fresh = std::find_if(map.fresh.begin(), map.fresh.end(),
                                    [&](const FreshCell& f) { return f.cell == finding.nearest; });
    const MapCell& cell = map.cells[finding.nearest];
    std::vector<std::string> seeds;
    for (const MapGap& gap : fresh->by_seed) seeds.push_back(pairText(gap));
    out += fmt::format(
        "| {} | {:.1f}, {:.1f} | {} | {:.1f} | {} | {} {:+.1f}, {:+.1f} % | {} | {} | {} ({}) | {:.0f} % | "
        "{}, then {} |\n",
        cell.suite, 100 * cell.radius, 100 * cell.width, cell.classic ? "classic" : "preview", cell.speed,
        nameOf(cell.heading), finding.target.name, 100 * finding.target.length, 100 * finding.target.time,
        pairText(cell.cut), fmt::join(seeds, "; "), pairText(fresh->cut), pairText(fresh->raw),
        100 * fresh->safe.value, within(finding.target, cell.cut), within(finding.target, fresh->cut));
  }
  return out;
}

}  // namespace fulbito
