#include "trials/comparison/summary.hpp"

#include <algorithm>

#include "trials/comparison/comparison_parts.hpp"

namespace fulbito {
namespace {

constexpr double kStuckTooLong = 2.0;  // [s]

/// Sums over the trials that succeeded.
struct Successes {
  int count = 0;
  double length = 0.0, length_limit = 0.0, time = 0.0, time_limit = 0.0;
  double clearance = 0.0, turning = 0.0, jumps = 0.0, jerk = 0.0;

  void add(const TrialScore& s) {
    ++count;
    length += s.length;
    length_limit += s.length_limit;
    time += s.time;
    time_limit += s.time_limit;
    clearance += s.min_clearance;
    turning += s.turning;
    jumps += s.curvature_jumps;
    jerk += s.wheel_jerk;
  }
};

void fillMeans(SummaryRow& row, const Successes& sums) {
  const double n = std::max(1, sums.count);
  row.length_ratio = sums.count > 0 ? sums.length / sums.length_limit : 0.0;
  row.time_ratio = sums.count > 0 ? sums.time / sums.time_limit : 0.0;
  row.path_length = sums.length / n;
  row.time = sums.time / n;
  row.mean_min_clearance = sums.clearance / n;
  row.turning = sums.turning / n;
  row.curvature_jumps = sums.jumps / n;
  row.wheel_jerk = sums.jerk / n;
}

SummaryRow summaryRow(const Comparison& comparison, std::size_t b, std::size_t n) {
  const ComparisonBlock& block = comparison.blocks[b];
  const auto records = recordsOf(comparison, b, n);
  const auto reference = recordsOf(comparison, b, referenceOf(block));
  SummaryRow row;
  row.suite = block.suite->name;
  row.speed = block.speed;
  row.navigator = block.navigators[n].text;
  row.plans_speed = block.navigators[n].info->plans_speed;
  row.trials = static_cast<int>(records.size());
  row.min_clearance = 1e9;
  Successes sums;
  double ratio_all = 0.0;
  std::vector<double> compute;
  for (std::size_t i = 0; i < records.size(); ++i) {
    const TrialScore& score = records[i].score;
    if (score.success()) sums.add(score);
    row.safe_pairs += score.success() && reference[i].score.success() ? 1 : 0;
    row.contacts += score.obstacle_contacts + score.wall_contacts;
    row.own_contacts += score.own_contacts > 0 ? 1 : 0;
    row.stuck_over_2s += score.longest_stuck > kStuckTooLong ? 1 : 0;
    row.min_clearance = std::min(row.min_clearance, score.min_clearance);
    ratio_all += score.success() ? score.timeRatio() : kFailureTimeRatio;
    compute.insert(compute.end(), records[i].compute_us.begin(), records[i].compute_us.end());
  }
  row.success = wilson(sums.count, row.trials);
  row.time_ratio_all = ratio_all / std::max(1, row.trials);
  fillMeans(row, sums);
  if (!compute.empty()) {
    row.compute_us_p50 = quantile(compute, 0.5);
    row.compute_us_p99 = quantile(compute, 0.99);
    row.compute_us_max = quantile(compute, 1.0);
  }
  return row;
}

}  // namespace

void summarise(Comparison& comparison) {
  comparison.summary.clear();
  for (std::size_t b = 0; b < comparison.blocks.size(); ++b) {
    for (std::size_t n = 0; n < comparison.blocks[b].navigators.size(); ++n) {
      comparison.summary.push_back(summaryRow(comparison, b, n));
    }
  }
}

PairedDifference compareSafePairs(const Comparison& comparison, std::span<const std::size_t> blocks,
                                  std::size_t a, std::size_t b, double hung, std::size_t resamples) {
  std::vector<double> length_a, length_b, time_a, time_b;
  for (std::size_t block : blocks) {
    const auto first = recordsOf(comparison, block, a), second = recordsOf(comparison, block, b);
    for (std::size_t i = 0; i < first.size(); ++i) {
      if (!first[i].score.success() || !second[i].score.success()) continue;
      if (first[i].score.timeRatio() > hung || second[i].score.timeRatio() > hung) continue;
      length_a.push_back(first[i].score.length);
      length_b.push_back(second[i].score.length);
      time_a.push_back(first[i].score.time);
      time_b.push_back(second[i].score.time);
    }
  }
  PairedDifference difference;
  difference.pairs = static_cast<int>(length_a.size());
  const std::uint64_t seed = comparison.config.seed;
  difference.length = pairedRelativeDifference(length_a, length_b, seed, resamples);
  difference.time = pairedRelativeDifference(time_a, time_b, seed, resamples);
  return difference;
}

PairedDifference compareSafePairs(const Comparison& comparison, std::size_t block, std::size_t a,
                                  std::size_t b, double hung) {
  return compareSafePairs(comparison, std::span(&block, 1), a, b, hung, 10000);
}

}  // namespace fulbito
