#include <cmath>

#include <fmt/format.h>

#include "experiments/comparison/paper_figures.hpp"
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

void appendFigures(std::string& out, const std::vector<FigureRow>& rows) {
  if (rows.empty()) return;
  out +=
      "\n### The paper's figures\n\n| case | statement of the paper's figure | run | result here | confirmed "
      "|\n|---|---|---|---|---|\n";
  for (const FigureRow& row : rows) {
    out += fmt::format("| {} | {} | `{}` | {} | {} |\n", row.figure->layout, row.figure->sentence,
                       row.figure->method, row.verdict.measured, row.verdict.shown ? "yes" : "no");
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
        "\n### Jung & Lee (2015): the paper's claims and this run\n\n| id | claim | paper | ours (95 %) | "
        "band | "
        "inside | why |\n"
        "|---|---|---|---|---|---|---|\n";
    for (const ReproductionRow& row : comparison.reproduction) {
      out += fmt::format("| {} | {} | {} | {} | {} | {} | {} |\n", row.id, row.claim, row.paper, row.ours,
                         row.band, row.inside_band ? "yes" : "no", row.reason);
    }
  }
  appendFigures(out, judgeFigures(comparison));
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
