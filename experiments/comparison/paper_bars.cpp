#include "experiments/comparison/paper_bars.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "experiments/comparison/comparison_parts.hpp"
#include "experiments/comparison/paper_plan.hpp"
#include "experiments/comparison/summary.hpp"

namespace fulbito {
namespace {

struct BarsRuns {
  const PaperTarget* paper;
  const char* suite;
  double speed;
  const char* bezier;
  const char* field;
};
constexpr BarsRuns kRuns[] = {{&kPaperTargets[0], "corner", 1.0, "bezier", kUntunedField},
                              {&kPaperTargets[1], "close-range", 0.6, kClassicBezier, kWideField}};

bool counts(const TrialScore& score) { return score.success() && score.timeRatio() <= kHung; }

/// Mean lengths and times of the pairs.
LayoutPair meanOf(const PaperBars& bars) {
  LayoutPair sum;
  for (const LayoutPair& p : bars.pairs) {
    sum.field_length += p.field_length, sum.bezier_length += p.bezier_length;
    sum.field_time += p.field_time, sum.bezier_time += p.bezier_time;
  }
  const double n = std::max(1.0, static_cast<double>(bars.pairs.size()));
  return {0, sum.field_length / n, sum.bezier_length / n, sum.field_time / n, sum.bezier_time / n};
}

/// The mean lengths and times that a result of the paper implies: the printed savings divided by their
/// shares.
LayoutPair impliedBy(const PaperTarget& paper) {
  LayoutPair mean;
  mean.field_length = -paper.length_saved / paper.length;
  mean.bezier_length = mean.field_length - paper.length_saved;
  mean.field_time = -paper.time_saved / paper.time;
  mean.bezier_time = mean.field_time - paper.time_saved;
  return mean;
}

void appendColumns(std::vector<std::string>& rows, const LayoutPair& m, const char* unit, int digits) {
  const auto cell = [&](double length, double time) {
    return fmt::format(" {:.{}f} {}, {:.2f} s |", length, digits, unit, time);
  };
  rows[0] += cell(m.field_length, m.field_time);
  rows[1] += cell(m.bezier_length, m.bezier_time);
  rows[2] += cell(m.field_length - m.bezier_length, m.field_time - m.bezier_time);
  rows[3] += fmt::format(" {:.1f} %, {:.1f} % |", 100 * (1.0 - m.bezier_length / m.field_length),
                         100 * (1.0 - m.bezier_time / m.field_time));
  rows[4] += fmt::format(" {:.2f}, {:.2f} {} per s |", m.field_length / m.field_time,
                         m.bezier_length / m.bezier_time, unit);
}

}  // namespace

std::vector<PaperBars> paperBars(const Comparison& comparison) {
  std::vector<PaperBars> all;
  for (const BarsRuns& runs : kRuns) {
    const auto bezier = findMethod(comparison, runs.suite, runs.speed, runs.bezier);
    const auto field = findMethod(comparison, runs.suite, runs.speed, runs.field);
    if (!bezier || !field) continue;
    PaperBars bars{runs.paper, runs.suite, runs.speed, runs.bezier, runs.field, {}};
    const auto a = recordsOf(comparison, field->block, field->navigator);
    const auto b = recordsOf(comparison, bezier->block, bezier->navigator);
    for (std::size_t i = 0; i < a.size(); ++i) {
      const TrialScore &f = a[i].score, &z = b[i].score;
      if (counts(f) && counts(z)) bars.pairs.push_back({a[i].index, f.length, z.length, f.time, z.time});
    }
    all.push_back(std::move(bars));
  }
  return all;
}

int slowerPairs(const PaperBars& bars) {
  return static_cast<int>(std::count_if(bars.pairs.begin(), bars.pairs.end(),
                                        [](const LayoutPair& p) { return p.bezier_time > p.field_time; }));
}

int longerPairs(const PaperBars& bars) {
  return static_cast<int>(std::count_if(bars.pairs.begin(), bars.pairs.end(), [](const LayoutPair& p) {
    return p.bezier_length > p.field_length;
  }));
}

std::string barsReport(const std::vector<PaperBars>& all) {
  if (all.empty()) return {};
  std::string head = "| mean of a run |", line = "|---|";
  std::vector<std::string> rows = {"| field: way, time |",
                                   "| Bezier: way, time |",
                                   "| saved |",
                                   "| saved, share |",
                                   "| speed along the way: field, Bezier |",
                                   "| layouts in which Bezier is slower |",
                                   "| layouts in which Bezier drives farther |"};
  for (const PaperBars& bars : all) {
    head += fmt::format(" {} ({}) | here: {}, {:.1f} m/s, `{}` against `{}` |", bars.paper->figure,
                        bars.paper->name, bars.suite, bars.speed, bars.bezier, bars.field);
    line += "---|---|";
    appendColumns(rows, impliedBy(*bars.paper), bars.paper->length_unit, 1);
    appendColumns(rows, meanOf(bars), "m", 3);
    const bool simulation = bars.paper == &kPaperTargets[0];
    rows[5] +=
        fmt::format(" {} | {} of {} |", simulation ? "the 4th; their number is not given" : "none named",
                    slowerPairs(bars), bars.pairs.size());
    rows[6] += fmt::format(" none named | {} of {} |", longerPairs(bars), bars.pairs.size());
  }
  std::string out = fmt::format(
      "\n### Figs 28 and 29 beside this run\n\nThe paper prints what is saved; ways and times follow from "
      "the "
      "shares.\n\n{}\n{}\n",
      head, line);
  for (const std::string& row : rows) out += row + '\n';
  return out;
}

}  // namespace fulbito
