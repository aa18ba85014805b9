#include "experiments/papers/hybrid/hybrid_figures.hpp"

#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include "fulbito/models.hpp"

namespace fulbito::hybrid {
namespace {

const char* nameOf(Knowledge knowledge) {
  if (knowledge == Knowledge::kMap) return "known map";
  return knowledge == Knowledge::kSonars ? "sonars only" : "sonars only, 1.2 mm noise";
}

const char* idOf(Knowledge knowledge) {
  if (knowledge == Knowledge::kMap) return "map";
  return knowledge == Knowledge::kSonars ? "sonars" : "fine-sonars";
}

template <typename Items, typename Test>
int count(const Items& items, const Test& test) {
  return static_cast<int>(std::count_if(items.begin(), items.end(), test));
}

double percent(int part, std::size_t all) {
  return all > 0 ? 100.0 * part / static_cast<double>(all) : std::numeric_limits<double>::quiet_NaN();
}

bool hasContact(const TrialScore& score) { return score.obstacle_contacts + score.wall_contacts > 0; }

double passed(const GapBlock& block) {
  return percent(count(block.scores, [](const TrialScore& s) { return s.success(); }), block.scores.size());
}

double touched(const GapBlock& block) {
  return percent(count(block.scores, hasContact), block.scores.size());
}

std::vector<const RowPair*> arrivedPairs(const HybridRuns& runs) {
  std::vector<const RowPair*> pairs;
  for (const RowPair& pair : runs.rows)
    if (pair.bothArrive()) pairs.push_back(&pair);
  std::sort(pairs.begin(), pairs.end(), [](const RowPair* a, const RowPair* b) {
    return a->with.length * b->without.length < b->with.length * a->without.length;
  });
  return pairs;
}

/// Length of our way over that of the direct way round, where both arrive.
double medianRatio(const HybridRuns& runs) {
  std::vector<double> ratios;
  for (const RowPair& pair : runs.rows) {
    if (pair.with.success() && pair.around.success()) ratios.push_back(pair.with.length / pair.around.length);
  }
  return quantile(ratios, 0.5);
}

void addRowFigures(const HybridRuns& runs, ExperimentReport& report) {
  const auto pairs = arrivedPairs(runs);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  PaperFigure shorter{"row-shorter", "Fig. 8", "layouts in which the way with the diagram is shorter", "%",
                      1};
  shorter.paper = 100.0;
  shorter.ours = percent(count(runs.rows, [](const RowPair& p) { return p.isShorter(); }), runs.rows.size());
  shorter.low = 95.0;
  shorter.reason = "the paper shows one layout; a way that does not arrive counts as longer";
  PaperFigure paired{"row-shorter-pairs", "Fig. 8", "the same where both ways arrive", "%", 1};
  paired.paper = 100.0;
  paired.ours = percent(count(pairs, [](const RowPair* p) { return p->isShorter(); }), pairs.size());
  paired.low = 95.0;
  PaperFigure ratio{"row-length-ratio", "Fig. 8", "length with over without the diagram, median", "", 2};
  ratio.ours =
      pairs.empty() ? nan : pairs[pairs.size() / 2]->with.length / pairs[pairs.size() / 2]->without.length;
  ratio.high = 1.0;
  ratio.reason = "the paper gives no lengths";
  PaperFigure direct{"row-direct-ratio", "Fig. 8", "length over the direct way round, median", "", 2};
  direct.ours = medianRatio(runs);
  direct.high = 1.0;
  direct.reason = "the direct way round knows the map, and no robot without the diagram drives it";
  PaperFigure around{"row-without-arrives", "Fig. 8", "ways without the diagram that arrive round the row",
                     "%", 1};
  around.ours =
      percent(count(runs.rows, [](const RowPair& p) { return p.without.success(); }), runs.rows.size());
  report.figures.insert(report.figures.end(), {shorter, paired, ratio, direct, around});
}

void addGapFigures(const GapBlock& block, ExperimentReport& report) {
  const bool judged = block.widths == 1.3 && block.knowledge != Knowledge::kFineSonars;
  const bool by_map = block.knowledge == Knowledge::kMap;
  const std::string id = fmt::format("gap-{:.1f}-{}", block.widths, idOf(block.knowledge));
  const std::string what = fmt::format("gap of {:.1f} widths, {}", block.widths, nameOf(block.knowledge));
  PaperFigure through{id, "section V", what + ": through", "%", 1};
  through.ours = passed(block);
  if (judged) through.low = by_map ? 98.0 : 90.0;
  PaperFigure contact{id + "-contact", "section V", what + ": runs with a contact", "%", 1};
  contact.ours = touched(block);
  if (judged) contact.high = by_map ? 0.0 : 1.0;
  if (!contact.inside())
    contact.reason = "the gap leaves 11 mm on each side, and a range has an error of 5 mm";
  report.figures.insert(report.figures.end(), {through, contact});
}

void addKindFigures(const KindBlock& block, ExperimentReport& report) {
  if (block.navigator != "hybrid" || block.knowledge != Knowledge::kSonars) return;
  const std::string id = fmt::format("kind-{}", nameOf(block.kind));
  const bool faces = block.kind == GapKind::kBoxes || block.kind == GapKind::kDoorway;
  PaperFigure through{id, "section V", fmt::format("gap of 1.3 widths, {}: through", nameOf(block.kind)), "%",
                      1};
  through.ours =
      percent(count(block.scores, [](const TrialScore& s) { return s.success(); }), block.scores.size());
  through.low = faces ? 90.0 : 95.0;
  through.reason = "the paper shows one gap and gives no rates";
  PaperFigure contact{id + "-contact", "section V",
                      fmt::format("gap of 1.3 widths, {}: runs with a contact", nameOf(block.kind)), "%", 1};
  contact.ours = percent(count(block.scores, hasContact), block.scores.size());
  contact.high = 1.0;
  contact.reason = "the gap leaves 11 mm on each side, and faces seen aslant are silent";
  report.figures.insert(report.figures.end(), {through, contact});
}

ReportTable kindTable(const HybridRuns& runs) {
  ReportTable table{"kinds",
                    "Gaps of 1.3 widths of every kind, sonars only: share of the runs, 95 % intervals",
                    columnsOf("kind:0 noise:0 navigator:0 runs:0 through_percent:1 through_low:1 "
                              "through_high:1 contact_percent:1 contact_low:1 contact_high:1 time_s:1"),
                    {},
                    40};
  for (const KindBlock& block : runs.kinds) {
    const int all = static_cast<int>(block.scores.size());
    const Interval through =
        wilson(count(block.scores, [](const TrialScore& s) { return s.success(); }), all);
    const Interval contact = wilson(count(block.scores, hasContact), all);
    std::vector<double> times;
    for (const TrialScore& score : block.scores)
      if (score.success()) times.push_back(score.time);
    table.rows.push_back({std::string(nameOf(block.kind)),
                          std::string(block.knowledge == Knowledge::kSonars ? "5 mm" : "1.2 mm"),
                          block.navigator, static_cast<double>(all), 100.0 * through.value,
                          100.0 * through.low, 100.0 * through.high, 100.0 * contact.value,
                          100.0 * contact.low, 100.0 * contact.high, mean(times)});
  }
  return table;
}

ReportTable gapTable(const HybridRuns& runs) {
  ReportTable table{"gaps",
                    "Gaps: share of the runs",
                    columnsOf("gap_widths:1 knowledge:0 runs:0 through_percent:1 contact_percent:1 "
                              "stuck_percent:1 late_percent:1 time_s:2"),
                    {},
                    40};
  for (const GapBlock& block : runs.gaps) {
    const auto share = [&](TrialOutcome outcome) {
      return percent(count(block.scores, [&](const TrialScore& s) { return s.outcome == outcome; }),
                     block.scores.size());
    };
    double time = 0.0;
    int arrived = 0;
    for (const TrialScore& score : block.scores)
      if (score.success()) time += score.time, ++arrived;
    table.rows.push_back({block.widths, std::string(nameOf(block.knowledge)),
                          static_cast<double>(block.scores.size()), passed(block), touched(block),
                          share(TrialOutcome::kStuck), share(TrialOutcome::kTimedOut),
                          arrived > 0 ? time / arrived : std::numeric_limits<double>::quiet_NaN()});
  }
  return table;
}

ReportTable rowTable(const HybridRuns& runs) {
  ReportTable table{
      "rows",
      "Layouts like Fig. 8, with and without the nearness diagram",
      columnsOf(
          "layout:0 gap_mm:1 with_outcome:0 with_length_m:3 without_outcome:0 without_length_m:3 shorter:0"),
      {},
      10};
  for (const RowPair& pair : runs.rows) {
    table.rows.push_back({static_cast<double>(pair.index), 1000.0 * pair.gap,
                          std::string(fulbito::nameOf(pair.with.outcome)), pair.with.length,
                          std::string(fulbito::nameOf(pair.without.outcome)), pair.without.length,
                          std::string(pair.isShorter() ? "yes" : "no")});
  }
  return table;
}

/// Every pair that arrives as a point: length without over length with the diagram.
ReportChart lengthChart(const HybridRuns& runs) {
  LineChart chart;
  chart.title = "Layouts like Fig. 8: both ways of each layout";
  chart.caption = "Below the dashed line the way with the nearness diagram is the shorter one.";
  chart.x_axis = "length without the nearness diagram [m]";
  chart.y_axis = "length with the nearness diagram [m]";
  chart.equal_scales = true;
  chart.from_zero = false;
  ChartLine points{"layouts", {}, true, false};
  double least = 1e9, most = 0.0;
  for (const RowPair* pair : arrivedPairs(runs)) {
    points.points.push_back({pair->without.length, pair->with.length});
    least = std::min({least, pair->without.length, pair->with.length});
    most = std::max({most, pair->without.length, pair->with.length});
  }
  if (!points.points.empty())
    chart.lines = {std::move(points), {"equal lengths", {{least, least}, {most, most}}, false, true, true}};
  return {"lengths", std::move(chart)};
}

}  // namespace

void addResults(const HybridRuns& runs, ExperimentReport& report) {
  addRowFigures(runs, report);
  for (const GapBlock& block : runs.gaps) addGapFigures(block, report);
  for (const KindBlock& block : runs.kinds) addKindFigures(block, report);
  report.tables = {kindTable(runs), gapTable(runs), rowTable(runs)};
  ReportChart chart = lengthChart(runs);
  if (!chart.chart.lines.empty()) report.charts.push_back(std::move(chart));
  report.notes.emplace_back(
      "Lengths of the paper are scaled by the ratio of the robots' radii, 53 mm to 220 mm.");
  report.notes.emplace_back(
      "Sonars: eight, cones of 12.5 degrees to either side, 0.36 m, noise of 5 mm, 5 % of drop-outs, echoes "
      "of smooth faces up to 30 degrees, one round per control tick of 1/60 s.");
  report.notes.emplace_back("Through: arrived at the goal behind the gap without any contact.");
  report.notes.emplace_back(
      "The paper states no noise. 5 mm are to this robot what 21 mm are to the paper's; 1.2 mm are to it "
      "what 5 mm are to the paper's.");
  report.notes.emplace_back(
      "The drive is tuned on the kinds of gap of the seeds 11 and 12, the rules of the known map on the "
      "seeds 77, 78, "
      "100 to 107 and 300 to 309.");
  report.notes.emplace_back(
      "hybrid-raw: the paper's rules as printed, on the present readings. hybrid-without-nd: without the "
      "diagram. "
      "The direct way round: the shortest path among the known discs for a robot too wide for the gap.");
}

std::uint64_t typicalRow(const HybridRuns& runs) {
  const auto pairs = arrivedPairs(runs);
  return pairs.empty() ? 0 : pairs[pairs.size() / 2]->index;
}

}  // namespace fulbito::hybrid
