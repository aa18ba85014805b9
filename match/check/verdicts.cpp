#include "match/check/verdicts.hpp"

#include <algorithm>
#include <iterator>
#include <sstream>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "fulbito/detail/interval.hpp"

namespace fulbito {
namespace {

// When a motor is at its limit, the robot does not steer as commanded. A warning if that is so more often
// than not.
constexpr double kMostSaturated = 0.5;
// Below this, a choice between equal paths or a rare manoeuvre to one side is no preference.
constexpr double kMostOneSided = 0.1;

double share(std::int64_t part, std::int64_t whole) {
  return whole > 0 ? std::min(1.0, static_cast<double>(part) / static_cast<double>(whole)) : 0.0;
}

std::string foundIn(const char* what, const FoundIn& found) {
  return fmt::format("{} {}, first in '{}'", found.count, what, found.first);
}

double milliseconds(double seconds) { return 1e3 * seconds; }

TeamCheck noAnswers(std::string name, const std::string& failure) {
  return {std::move(name), CheckVerdict::kFailed, "the team stopped answering: " + failure, {}};
}

/// The answers of a team that is not deterministic differ between seats and sides anyway, without any bias.
TeamCheck noComparison(std::string name) {
  return {std::move(name), CheckVerdict::kWarning, "cannot be decided: the team is not deterministic", {}};
}

std::vector<std::pair<std::string, double>> figuresOf(const RepeatFindings& found) {
  return {{"answers", double(found.compared)}, {"different", double(found.different)}};
}

std::string differences(const RepeatFindings& found) {
  return fmt::format("{} of {} answers differ, first {}", found.different, found.compared, found.first);
}

}  // namespace

TeamCheck startVerdict(const PlayFindings& plays) {
  const double limit = plays.limit.start, most = plays.notes.start_seconds;
  TeamCheck check{"start", CheckVerdict::kOk, "", {{"wall_start_seconds", most}, {"limit_seconds", limit}}};
  check.finding = fmt::format("{:.0f} ms at most, of {:g} s allowed", milliseconds(most), limit);
  // Half of the allowance is left for a slower machine.
  if (most > limit / 2) check.verdict = CheckVerdict::kWarning;
  if (most > limit) check.verdict = CheckVerdict::kFailed;
  return check;
}

TeamCheck protocolVerdict(const PlayFindings& plays) {
  TeamCheck check{"protocol",
                  CheckVerdict::kOk,
                  "",
                  {{"situations", double(plays.situations)},
                   {"skipped", double(plays.skipped)},
                   {"failures", double(plays.failures.count)},
                   {"stale", double(plays.stale.count)}}};
  check.finding = fmt::format("no failure in {} situations", plays.situations);
  if (plays.stale.count > 0) {
    check.verdict = CheckVerdict::kWarning;
    check.finding = foundIn("replies to requests that no longer wait", plays.stale);
  }
  if (plays.failures.count > 0) {
    check.verdict = CheckVerdict::kFailed;
    check.finding = fmt::format("{}: {}", foundIn("failures", plays.failures), plays.reason);
    if (plays.forfeited) check.finding += "; it forfeits a match";
  }
  if (plays.skipped > 0) check.finding += fmt::format("; {} situations skipped", plays.skipped);
  return check;
}

TeamCheck valuesVerdict(const PlayFindings& plays) {
  TeamCheck check{
      "values",
      CheckVerdict::kOk,
      "all commands are finite and name navigators that the team has",
      {{"not_finite", double(plays.not_finite.count)}, {"no_navigator", double(plays.no_navigator.count)}}};
  if (plays.not_finite.count + plays.no_navigator.count == 0) return check;
  check.verdict = CheckVerdict::kFailed;
  check.finding = plays.not_finite.count > 0
                      ? foundIn("commands with NaN or infinity", plays.not_finite)
                      : foundIn("commands for a navigator that the team lacks", plays.no_navigator);
  return check;
}

TeamCheck motorsVerdict(const PlayFindings& plays) {
  const double saturated = share(plays.saturated.count, plays.commands);
  TeamCheck check{"motors",
                  saturated > kMostSaturated ? CheckVerdict::kWarning : CheckVerdict::kOk,
                  fmt::format("{:.1f} % of the commands are beyond the motors or the field and are clamped",
                              100.0 * saturated),
                  {{"commands", double(plays.commands)}, {"saturated_share", saturated}}};
  return check;
}

TeamCheck timeVerdict(const PlayFindings& plays) {
  std::vector<double> seconds = plays.notes.seconds;
  const double limit = plays.limit.decision;
  const auto at = [&](double p) { return seconds.empty() ? 0.0 : quantile(seconds, p); };
  const double p50 = at(0.5), p95 = at(0.95), p99 = at(0.99), most = at(1.0);
  TeamCheck check{"time",
                  CheckVerdict::kOk,
                  fmt::format("p50 {:.3f}, p95 {:.3f}, p99 {:.3f}, max {:.3f} ms, of {:g} ms per decision",
                              milliseconds(p50), milliseconds(p95), milliseconds(p99), milliseconds(most),
                              milliseconds(limit)),
                  {{"decisions", double(seconds.size())},
                   {"limit_seconds", limit},
                   {"wall_p50_seconds", p50},
                   {"wall_p95_seconds", p95},
                   {"wall_p99_seconds", p99},
                   {"wall_max_seconds", most},
                   {"wall_late", double(plays.late.count)}}};
  if (most > limit) check.verdict = CheckVerdict::kWarning;  // rare ones are covered by the bank
  if (p99 > limit) check.verdict = CheckVerdict::kFailed;
  if (plays.late.count > 0) {
    check.verdict = CheckVerdict::kFailed;
    check.finding += "; " + foundIn("late", plays.late);
  }
  return check;
}

TeamCheck determinismVerdict(const AllRepeats& repeats) {
  const RepeatFindings& found = repeats.again;
  if (!found.failure.empty()) return noAnswers("determinism", found.failure);
  TeamCheck check{"determinism", CheckVerdict::kOk, "", figuresOf(found)};
  check.finding = fmt::format("two new instances give the same {} answers, bit by bit", found.compared);
  if (found.different == 0) return check;
  check.verdict = CheckVerdict::kFailed;
  check.finding = "same observations, other commands: " + differences(found);
  return check;
}

TeamCheck seatVerdict(const AllRepeats& repeats) {
  const RepeatFindings& found = repeats.seat;
  if (!found.failure.empty()) return noAnswers("seat", found.failure);
  if (repeats.again.different > 0) return noComparison("seat");
  TeamCheck check{"seat", CheckVerdict::kOk, "", figuresOf(found)};
  check.finding = fmt::format("blue and yellow give the same {} answers", found.compared);
  if (found.different == 0) return check;
  check.verdict = CheckVerdict::kFailed;
  check.finding = "blue and yellow play differently: " + differences(found);
  return check;
}

TeamCheck mirrorVerdict(const AllRepeats& repeats) {
  const RepeatFindings& found = repeats.mirror;
  const std::string& failure = found.failure.empty() ? repeats.again.failure : found.failure;
  if (!failure.empty()) return noAnswers("mirror", failure);
  if (repeats.again.different > 0) return noComparison("mirror");
  const double different = share(found.different, found.compared);
  TeamCheck check{"mirror", CheckVerdict::kOk, "", figuresOf(found)};
  check.finding = fmt::format("{:.2f} % of the answers to mirrored situations are not the mirrored ones",
                              100.0 * different);
  if (different <= kMostOneSided) return check;
  check.verdict = CheckVerdict::kWarning;
  check.finding += ": left and right are not equal, first " + found.first;
  return check;
}

TeamCheck placementVerdict(const PlayFindings& plays) {
  TeamCheck check{"placement",
                  CheckVerdict::kOk,
                  "the referee moves no robot that the team places",
                  {{"repaired", double(plays.repaired.count)}}};
  if (plays.repaired.count == 0) return check;
  check.verdict = CheckVerdict::kWarning;
  check.finding = "the referee repairs " + foundIn("places", plays.repaired);
  return check;
}

TeamCheck drawingsVerdict(const PlayFindings& plays) {
  TeamCheck check{"drawings",
                  CheckVerdict::kOk,
                  "no drawings but for those who watch",
                  {{"unasked", double(plays.notes.unasked)}}};
  if (plays.notes.unasked == 0) return check;
  check.verdict = CheckVerdict::kWarning;
  check.finding =
      fmt::format("{} decisions draw although nobody watches: it takes time", plays.notes.unasked);
  return check;
}

TeamCheck rolesVerdict(const PlayFindings& plays) {
  const auto decisions = static_cast<std::int64_t>(plays.notes.seconds.size());
  const double told = share(plays.notes.with_roles, decisions);
  TeamCheck check{"roles", CheckVerdict::kOk, "", {{"told_share", told}}};
  check.finding = told > 0.0 ? fmt::format("reported in {:.0f} % of the decisions", 100.0 * told)
                             : "not reported: recordings and drill 19 cannot show them";
  return check;
}

namespace {

std::string valueOf(const std::vector<Setting>& origin, std::string_view name) {
  for (const Setting& setting : origin) {
    if (setting.name == name) return setting.value;
  }
  return {};
}

}  // namespace

TeamCheck containmentVerdict(const PlayFindings& plays, bool outside) {
  TeamCheck check{"containment", CheckVerdict::kOk, "none: the team runs in this process", {}};
  const std::string reached = valueOf(plays.notes.origin, "containment");
  if (!outside || reached == "none") return check;
  std::istringstream words(reached);
  const std::vector<std::string> layers{std::istream_iterator<std::string>(words), {}};
  check.figures = {{"layers", double(layers.size())}};
  check.finding = layers.empty() ? "none: the team runs without containment"
                                 : fmt::format("{} layers: {}", layers.size(), fmt::join(layers, ", "));
  const std::string missing = valueOf(plays.notes.origin, "containment_missing");
  if (!missing.empty()) check.finding += "; without " + missing;
  if (layers.empty() || !missing.empty()) check.verdict = CheckVerdict::kWarning;
  return check;
}

TeamCheck drillsVerdict(const std::vector<DrillReport>& reports) {
  TeamCheck check{"drills", CheckVerdict::kOk, "", {}};
  for (const DrillReport& report : reports) {
    const auto successes = std::count_if(report.trials.begin(), report.trials.end(),
                                         [](const DrillTrial& trial) { return trial.success; });
    const std::string part =
        report.offered ? fmt::format("{} {} / {}", report.drill.name, successes, report.trials.size())
                       : report.drill.name + " not offered";
    check.finding += (check.finding.empty() ? "" : ", ") + part;
    check.figures.emplace_back(report.drill.name, share(successes, std::int64_t(report.trials.size())));
    if (report.offered && successes == 0) check.verdict = CheckVerdict::kWarning;
  }
  return check;
}

}  // namespace fulbito
