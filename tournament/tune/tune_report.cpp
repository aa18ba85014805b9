#include "tournament/tune/tune_report.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "engine/core/base/text_controls.hpp"
#include "tournament/report/counted_results.hpp"
#include "tournament/report/json_parts.hpp"
#include "tournament/report/sections.hpp"
#include "tournament/statistics/sprt.hpp"

namespace fulbito {
namespace {

/// Bounds of the test "is it stronger?", which a few hundred pairs can decide (docs/statistics.md).
constexpr SprtBounds kStronger{0.0, 50.0, 0.05, 0.05};

/// Version of the object. It increases when a key changes its meaning or disappears.
constexpr int kTuneReportVersion = 1;

std::string finalText(const FinalResult& final) {
  const EloEstimate estimate = estimateElo(final.counts);
  return fmt::format("  {} against {:<9} {} pairs, Elo {}, normalized Elo {}\n", final.first,
                     final.second + ":", final.counts.pairs(), eloText(estimate.elo),
                     eloText(estimate.normalized_elo));
}

/// A sequential test whether the first team is stronger. It takes pairs in order and ends at its verdict.
Sprt testOf(const FinalResult& final) {
  Sprt test(kStronger);
  for (const double points : final.points) test.add(points);
  return test;
}

std::string testText(const Sprt& test) {
  const std::string bounds =
      fmt::format("{:+g} and {:+g} normalized Elo", test.bounds().weak, test.bounds().strong);
  const char* const end = test.verdict() == SprtVerdict::kInconclusive ? "no verdict" : "a verdict";
  return fmt::format("  sequential test between {}: {}, {} after {} pairs\n", bounds, nameOf(test.verdict()),
                     end, test.counts().pairs());
}

/// A specification as one word of a shell, quoted if it contains spaces or other special characters.
std::string shellWord(const std::string& text) {
  if (text.find_first_of(" '\"\\$") == std::string::npos) return text;
  std::string word = "'";
  for (const char c : text) word += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return word + "'";
}

/// The gain of the tuned team over the start team. Both played the same starts, so common effects cancel.
std::string gainText(const Interval& gain) {
  const std::string line = fmt::format(
      "  tuned less start, both against the opponent: {:+.3f} points per match ({:+.3f} to {:+.3f})\n",
      gain.value, gain.low, gain.high);
  switch (improvementOf(gain)) {
    case Improvement::kShown:
      return line +
             "Against the opponent the tuned team does better than the start: its 95 % interval is above "
             "0.\n";
    case Improvement::kNotShown:
      return line + "No improvement against the opponent is shown: the 95 % interval contains 0.\n";
    case Improvement::kWorse:
      break;
  }
  return line +
         "Against the opponent the tuned team does worse than the start: its 95 % interval is below 0.\n";
}

std::string directText(const FinalResult& direct) {
  switch (improvementOf(estimateElo(direct.counts).elo)) {
    case Improvement::kShown:
      return "The tuned team is stronger than the start: its 95 % interval is above 0.\n";
    case Improvement::kNotShown:
      return "No improvement over the start is shown: the 95 % interval contains 0.\n";
    case Improvement::kWorse:
      break;
  }
  return "The tuned team is weaker than the start: its 95 % interval is below 0.\n";
}

std::string parameterTable(const TunePlan& plan, const TunePoint& end) {
  std::size_t width = 9;
  for (const TunedParameter& p : plan.spsa.parameters) width = std::max(width, p.name.size());
  std::string text =
      fmt::format("  {:<{}}  {:>10} -> {:<10}  of the range   limits\n", "parameter", width, "start", "end");
  const TunePoint start = startOf(plan.spsa);
  for (std::size_t i = 0; i < end.size(); ++i) {
    const TunedParameter& p = plan.spsa.parameters[i];
    text += fmt::format("  {:<{}}  {:>10} -> {:<10}  {:.2f} -> {:.2f}   {:g} ... {:g}\n", p.name, width,
                        valueText(p, start[i]), valueText(p, end[i]), start[i], end[i], p.low, p.high);
  }
  return text;
}

Json tunedJson(const TunedParameter& p, double start, double end) {
  const auto number = [&p](double share) { return Json::parse(valueText(p, share)); };
  return {{"name", p.name},          {"type", p.whole ? "integer" : "number"},
          {"minimum", p.low},        {"maximum", p.high},
          {"start", number(start)},  {"end", number(end)},
          {"c_end", p.perturbation}, {"r_end", p.step}};
}

Json finalJson(const FinalResult& final) {
  const EloEstimate estimate = estimateElo(final.counts);
  const Sprt test = testOf(final);
  return {{"first", final.first},
          {"second", final.second},
          {"pairs", final.counts.pairs()},
          {"pair_counts", final.counts.counts},
          {"elo", intervalJson(estimate.elo)},
          {"normalized_elo", intervalJson(estimate.normalized_elo)},
          {"superiority", estimate.superiority},
          {"improvement", nameOf(improvementOf(estimate.elo))},
          {"test",
           {{"bounds", {test.bounds().weak, test.bounds().strong}},
            {"verdict", nameOf(test.verdict())},
            {"pairs", test.counts().pairs()}}}};
}

}  // namespace

std::string_view nameOf(Improvement improvement) {
  constexpr std::string_view kNames[] = {"shown", "not shown", "worse"};
  return kNames[static_cast<std::size_t>(improvement)];
}

Improvement improvementOf(const Interval& difference) {
  if (difference.low > 0.0) return Improvement::kShown;
  return difference.high < 0.0 ? Improvement::kWorse : Improvement::kNotShown;
}

std::optional<Interval> gainOf(const TuneOutcome& outcome) {
  if (outcome.finals.size() < 3) return std::nullopt;
  std::vector<double> gains = outcome.finals[1].points;
  for (std::size_t i = 0; i < gains.size(); ++i) gains[i] -= outcome.finals[2].points[i];
  return meanInterval(gains);
}

std::string tuneText(const TunePlan& plan, const TuneOutcome& outcome) {
  const TunePoint end = pathOf(plan.spsa, outcome.results).back();
  const Entrant& opponent = plan.base.entrants[1];
  std::string text = fmt::format(
      "{}: {} of {} iterations, {} pairs each, {}, seed {}\n", plan.base.entrants[0].team.text,
      outcome.results.size(), plan.spsa.iterations, plan.base.pairs,
      plan.opponent ? "against " + opponent.team.text : "versions against each other", plan.base.seed);
  text += parameterTable(plan, end);
  text += fmt::format("Tuned team:\n  {}\n", shellWord(plan.team.at(plan.spsa.parameters, end)));
  if (outcome.failures > 0) text += fmt::format("A team failed in {} matches.\n", outcome.failures);
  for (const UnplayedMatch& match : outcome.unplayed) {
    text += fmt::format("Not played, as the machine failed: match {}, {}\n",
                        numberOf(match.fixture, match.leg), match.reason);
  }
  if (outcome.finals.empty()) return text;
  text += "On starts that the tuning did not use:\n";
  for (const FinalResult& final : outcome.finals) text += finalText(final);
  text += testText(testOf(outcome.finals.front()));
  text += directText(outcome.finals.front());
  if (const auto gain = gainOf(outcome); gain && plan.final_pairs > 1) text += gainText(*gain);
  return text;
}

std::string tuneJson(const TunePlan& plan, const TuneOutcome& outcome) {
  const std::vector<TunePoint> path = pathOf(plan.spsa, outcome.results);
  Json json{{"schema_version", kTuneReportVersion},
            {"team", plan.base.entrants[0].team.text},
            {"opponent", plan.opponent ? Json(plan.base.entrants[1].team.text) : Json(nullptr)},
            {"tuned", plan.team.at(plan.spsa.parameters, path.back())},
            {"seed", plan.base.seed},
            {"iterations", plan.spsa.iterations},
            {"iterations_done", outcome.results.size()},
            {"pairs", plan.base.pairs},
            {"failures", outcome.failures},
            {"unplayed", unplayedJson(outcome.unplayed)},
            {"parameters", Json::array()},
            {"results", outcome.results},
            {"path", path},
            {"finals", Json::array()}};
  for (std::size_t i = 0; i < plan.spsa.parameters.size(); ++i) {
    json["parameters"].push_back(tunedJson(plan.spsa.parameters[i], path.front()[i], path.back()[i]));
  }
  for (const FinalResult& final : outcome.finals) json["finals"].push_back(finalJson(final));
  const auto gain = gainOf(outcome);
  json["gain"] = gain ? intervalJson(*gain) : Json(nullptr);
  return escapedJson(json.dump(2, ' ', false, Json::error_handler_t::replace)) + '\n';
}

}  // namespace fulbito
