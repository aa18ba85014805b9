#include <cmath>

#include <fmt/format.h>

#include "experiments/comparison/paper_bars.hpp"
#include "experiments/comparison/paper_figures.hpp"
#include "experiments/comparison/paper_plan.hpp"
#include "fulbito/experiment.hpp"

namespace fulbito {
namespace {

std::string cell(bool present, double value, int digits) {
  return present ? fmt::format("{:.{}f}", value, digits) : std::string("-");
}

void appendRow(std::string& out, const SummaryRow& row) {
  const bool any = row.success.value > 0.0;
  out += fmt::format(
      "| {}{} | {:.1f} % ({:.1f}-{:.1f}) | {} | {} | {} | {} | {:.3f} | {} | {} | {:.1f} | {:.1f} / {:.1f} / "
      "{:.0f} |\n",
      row.navigator, row.plans_speed ? " *" : "", 100 * row.success.value, 100 * row.success.low,
      100 * row.success.high, row.contacts, row.safe_pairs, cell(any, row.length_ratio, 3),
      cell(any, row.time_ratio, 3), row.time_ratio_all, cell(any, row.path_length, 3), cell(any, row.time, 3),
      1000 * row.min_clearance, row.compute_us_p50, row.compute_us_p99, row.compute_us_max);
}

void appendBlock(std::string& out, const Comparison& comparison, const ComparisonBlock& block,
                 std::size_t& next) {
  const int trials = comparison.config.only ? 1 : block.trials;
  out += fmt::format("\n### {} at {:.1f} m/s, {} layout{}\n\n{}\n\n", block.suite->name, block.speed, trials,
                     trials == 1 ? "" : "s", block.suite->summary);
  out +=
      "| navigator | success (95 %) | contacts | safe pairs | L/L* | T/T* | T/T* all | length m | time s | "
      "least gap mm | "
      "us per tick p50 / p99 / max |\n|---|---|---|---|---|---|---|---|---|---|---|\n";
  for (std::size_t n = 0; n < block.navigators.size(); ++n) appendRow(out, comparison.summary[next++]);
}

const char* yesNo(bool yes) { return yes ? "yes" : "no"; }

/// Appends the verdicts of the figures, then the result of each run.
void appendFigures(std::string& out, const std::vector<FigureRow>& rows) {
  if (rows.empty()) return;
  out +=
      "\n### The paper's figures\n\nThe case files (docs/reproduction.md) name before the run what a run "
      "must "
      "do to show what the paper's figure shows. "
      "partly: some of the judged runs do.\n\n"
      "| case | statement of the paper's figure | to show it, a run | shown |\n|---|---|---|---|\n";
  for (const FigureRow& row : rows) {
    out += fmt::format("| {} | {} | {} | {} |\n", row.figure->layout.name, row.figure->sentence,
                       ruleText(*row.figure), verdictOf(row));
  }
  out += "\n| case | run | judged | result here | does it |\n|---|---|---|---|---|\n";
  for (const FigureRow& row : rows) {
    for (const JudgedRun& run : row.runs) {
      out += fmt::format("| {} | `{}` | {} | {} | {} |\n", row.figure->layout.name, run.run->navigator,
                         yesNo(run.run->judged), run.verdict.measured, yesNo(run.verdict.shown));
    }
  }
}

/// Appends one table per figure: a line per value and a column per speed and run.
void appendSweeps(std::string& out, const std::vector<FigureRow>& rows) {
  for (std::size_t first = 0; first < rows.size();) {
    const FigureCase& figure = *rows[first].figure;
    std::size_t last = first;
    while (last < rows.size() && rows[last].figure == &figure) ++last;
    const auto own = std::span(rows).subspan(first, last - first);
    std::string head = fmt::format("| {} | m/s |", nameOf(figure.sweep.kind)), line = "|---|---|";
    for (const JudgedRun& run : own.front().runs) {
      head += fmt::format(" `{}` |", run.run->navigator);
      line += "---|";
    }
    out += fmt::format("\n### {}: which runs show it?\n\nA run that shows it {}.\n\n{}\n{}\n", figure.title,
                       ruleText(figure), head, line);
    for (const FigureRow& row : own) {
      out += fmt::format("| {} | {:.1f} |", sweepText(figure.sweep, row.value), row.speed);
      for (const JudgedRun& run : row.runs) out += fmt::format(" {} |", yesNo(run.verdict.shown));
      out += '\n';
    }
    first = last;
  }
}

std::string csvText(const std::string& text) {
  return text.find(',') == std::string::npos ? text : '"' + text + '"';
}

}  // namespace

std::string markdownReport(const Comparison& comparison) {
  std::string out = fmt::format("## {} (seed {}, robot {}, physics {})\n", comparison.config.suite,
                                comparison.config.seed, comparison.robot.robot.name, comparison.physics.name);
  std::size_t next = 0;
  for (const ComparisonBlock& block : comparison.blocks) appendBlock(out, comparison, block, next);
  out +=
      "\n\\* plans its own speeds. L*, T*: shortest path and least time. T/T* all: a failure counts as 8. "
      "Safe "
      "pairs: layouts that both the method and the block's reference (bezier, or the first method) solved.\n";
  if (!comparison.reproduction.empty()) {
    out +=
        "\n### Jung & Lee (2015): the paper's claims and this run\n\n"
        "Off the paper: difference from the paper's figure in points. Our band: what these methods give for "
        "a "
        "kinematic robot, or the paper's figure within 2 points where the reason says so.\n\n"
        "| id | claim | paper | ours (95 %) | off the paper | our band | inside our band | why |\n"
        "|---|---|---|---|---|---|---|---|\n";
    for (const ReproductionRow& row : comparison.reproduction) {
      out += fmt::format("| {} | {} | {} | {} | {} | {} | {} | {} |\n", row.id, row.claim, row.paper,
                         row.ours, row.off_paper ? fmt::format("{:+.1f}", *row.off_paper) : "-", row.our_band,
                         yesNo(row.inside_our_band), row.reason);
    }
  }
  if (comparison.config.suite == kPaperSuite) out += barsReport(paperBars(comparison));
  appendFigures(out, judgeFigures(comparison));
  appendSweeps(out, judgeSweeps(comparison));
  return out;
}

std::string trialsCsv(const Comparison& comparison) {
  std::string out =
      "suite,speed,navigator,index,layout,outcome,arrived,time_s,path_length_m,time_limit_s,length_limit_m,"
      "obstacle_contacts,"
      "wall_contacts,own_contacts,contact_impulse_kg_m_s,min_clearance_m,mean_clearance_m,turning_rad,"
      "curvature_"
      "jumps,"
      "wheel_jerk_m_s3,heading_error_rad,longest_stuck_s,final_hash\n";
  for (const TrialRecord& r : comparison.records) {
    const ComparisonBlock& block = comparison.blocks[r.block];
    const TrialScore& s = r.score;
    out += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{:016x}\n",
                       block.suite->name, block.speed, csvText(block.navigators[r.navigator].text), r.index,
                       block.suite->layout(block.seed, r.index).name, nameOf(s.outcome), s.arrived ? 1 : 0,
                       s.time, s.length, s.time_limit, s.length_limit, s.obstacle_contacts, s.wall_contacts,
                       s.own_contacts, s.contact_impulse, s.min_clearance, s.mean_clearance, s.turning,
                       s.curvature_jumps, s.wheel_jerk, s.heading_error, s.longest_stuck, r.final_hash);
  }
  return out;
}

std::string traceCsv(const TrialResult& result) {
  std::string out =
      "tick,time_s,x_m,y_m,heading_rad,vx_m_s,vy_m_s,omega_rad_s,left_rad_s,right_rad_s,left_command_rad_s,"
      "right_command_rad_s\n";
  for (std::size_t i = 0; i < result.trace.size(); ++i) {
    const TraceRow& row = result.trace[i];
    const RobotState& r = row.robot;
    out += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{}\n", i, row.time, r.pose.position.x,
                       r.pose.position.y, r.pose.heading, r.velocity.x, r.velocity.y, r.angular_velocity,
                       r.wheels.left, r.wheels.right, row.command.left, row.command.right);
  }
  return out;
}

}  // namespace fulbito
