#include "apps/match/rules_compare.hpp"

#include <cstdio>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "apps/common/commands.hpp"
#include "apps/common/console.hpp"
#include "engine/core/base/text_controls.hpp"
#include "engine/core/system/error_text.hpp"
#include "replays/verify/shadow_referee.hpp"

namespace fulbito::app {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kAgreements[] = {"none",   "same",   "a-earlier", "b-earlier",
                                       "only-a", "only-b", "different"};

const char* nameOfAgreement(VerdictAgreement agreement) {
  return kAgreements[static_cast<std::size_t>(agreement)];
}

bool differs(const PlayVerdicts& play) {
  return play.agreement != VerdictAgreement::kNone && play.agreement != VerdictAgreement::kSame;
}

Json verdictJson(const std::optional<ShadowVerdict>& verdict, Tick begin, double dt) {
  if (!verdict) return nullptr;
  Json json{{"clause", verdict->clause}, {"after_s", static_cast<double>(verdict->tick - begin) * dt}};
  json["team"] = verdict->team ? Json(nameOf(*verdict->team)) : Json(nullptr);
  json["restart"] = nameOf(verdict->restart);
  json["restart_team"] = nameOf(verdict->restart_team);
  json["value"] = verdict->value;
  json["threshold"] = verdict->threshold;
  return json;
}

/// One of the compared recordings, and the length of its tick [s].
struct Source {
  std::string file;
  double dt = 0.0;
};

Json toJson(const RulesComparison& comparison, const std::vector<Source>& sources, bool list) {
  Json json{{"schema_version", 1},
            {"profiles", {comparison.a, comparison.b}},
            {"files", comparison.files},
            {"simulated_s", comparison.seconds},
            {"plays", comparison.plays.size()},
            {"as_recorded", {comparison.recorded_a, comparison.recorded_b}}};
  for (int i = 0; i <= static_cast<int>(VerdictAgreement::kDifferent); ++i) {
    json["agreement"][kAgreements[i]] = countOf(comparison, static_cast<VerdictAgreement>(i));
  }
  json["rules"] = Json::array();
  for (const RuleAgreement& rule : byRule(comparison)) {
    json["rules"].push_back({{"clause", rule.clause},
                             {"a", rule.a},
                             {"b", rule.b},
                             {"same", rule.same},
                             {"a_earlier", rule.a_earlier},
                             {"a_lead_s", rule.a_lead},
                             {"b_earlier", rule.b_earlier},
                             {"b_lead_s", rule.b_lead},
                             {"only_a", rule.only_a},
                             {"only_b", rule.only_b},
                             {"different", rule.different}});
  }
  json["different"] = Json::array();
  for (const VerdictPair& pair : differentPairs(comparison)) {
    json["different"].push_back({{"a", pair.a}, {"b", pair.b}, {"count", pair.count}});
  }
  if (!list) return json;
  json["differing_plays"] = Json::array();
  for (const PlayVerdicts& play : comparison.plays) {
    if (!differs(play)) continue;
    const double dt = sources[play.file].dt;
    json["differing_plays"].push_back({{"file", sources[play.file].file},
                                       {"play", play.play},
                                       {"begin_s", static_cast<double>(play.begin) * dt},
                                       {"end_s", static_cast<double>(play.end) * dt},
                                       {"agreement", nameOfAgreement(play.agreement)},
                                       {"a", verdictJson(play.a, play.begin, dt)},
                                       {"b", verdictJson(play.b, play.begin, dt)}});
  }
  return json;
}

std::string leadText(std::int64_t count, double lead) {
  return count == 0 ? std::string("0") : fmt::format("{} ({:.2f} s)", count, lead);
}

void printTable(const RulesComparison& comparison) {
  say("A = {}, B = {}: {} plays of {} recordings, {:.0f} s\n", comparison.a, comparison.b,
      comparison.plays.size(), comparison.files, comparison.seconds);
  say("plays decided as recorded: A {}, B {}\n\n", comparison.recorded_a, comparison.recorded_b);
  say("{:<26}{:>7}{:>7}{:>7}{:>16}{:>16}{:>8}{:>8}{:>11}\n", "rule", "A", "B", "same", "A earlier",
      "B earlier", "only A", "only B", "different");
  for (const RuleAgreement& rule : byRule(comparison)) {
    say("{:<26}{:>7}{:>7}{:>7}{:>16}{:>16}{:>8}{:>8}{:>11}\n", rule.clause, rule.a, rule.b, rule.same,
        leadText(rule.a_earlier, rule.a_lead), leadText(rule.b_earlier, rule.b_lead), rule.only_a,
        rule.only_b, rule.different);
  }
  const std::vector<VerdictPair> pairs = differentPairs(comparison);
  if (!pairs.empty()) say("\nplays with different calls (A: B):\n");
  for (const VerdictPair& pair : pairs) say("  {:>5}  {}: {}\n", pair.count, pair.a, pair.b);
}

std::string verdictText(const std::optional<ShadowVerdict>& verdict, Tick begin, double dt) {
  if (!verdict) return "nothing";
  return fmt::format("{}{} after {:.2f} s", verdict->clause,
                     verdict->team ? fmt::format(" {}", nameOf(*verdict->team)) : std::string(),
                     static_cast<double>(verdict->tick - begin) * dt);
}

void printList(const RulesComparison& comparison, const std::vector<Source>& sources) {
  say("\nplays with different verdicts:\n");
  for (const PlayVerdicts& play : comparison.plays) {
    if (!differs(play)) continue;
    const Source& source = sources[play.file];
    say("  {} play {} at {:.2f} s: A {}, B {}\n", source.file, play.play + 1,
        static_cast<double>(play.begin) * source.dt, verdictText(play.a, play.begin, source.dt),
        verdictText(play.b, play.begin, source.dt));
  }
}

Result<void> addFile(const std::string& file, const Rules& a, const Rules& b, RulesComparison& comparison,
                     std::vector<Source>& sources) {
  const auto recording = RecordingReader::open(file);
  if (!recording) return tl::unexpected<Error>(recording.error());
  if (auto compared = fulbito::compareRules(*recording, a, b, comparison); !compared) {
    return inFile(file, compared.error());
  }
  sources.push_back({file, 1.0 / recording->header().control_rate});
  return {};
}

}  // namespace

CLI::App* addRulesCompare(CLI::App& rules, RulesCompareOptions& options) {
  CLI::App* command =
      rules.add_subcommand("compare", "judge recorded matches by two profiles and compare the calls");
  command->footer(
      "Both referees judge every recorded play from its start to the tick at which the recorded one stopped "
      "it.\n"
      "Example:\n"
      "  fulbito rules compare vsss-3v3 league-program-2021 game.fbr");
  command->add_option("a", options.a, "first rules profile or TOML file")->required();
  command->add_option("b", options.b, "second rules profile or TOML file")->required();
  command->add_option("files", options.files, "recordings (.fbr)")->required();
  command->add_flag("--list", options.list, "also list every play on which the profiles differ");
  command->add_flag("--json", options.json, "print JSON");
  return command;
}

int compareRules(const RulesCompareOptions& options) {
  const auto a = loadRules(options.a);
  if (!a) return report(a.error());
  const auto b = loadRules(options.b);
  if (!b) return report(b.error());
  RulesComparison comparison;
  std::vector<Source> sources;
  for (const std::string& file : options.files) {
    if (auto added = addFile(file, *a, *b, comparison, sources); !added) return report(added.error());
    if (interrupted()) return interruptedCode();
  }
  if (options.json) {
    writeOut(
        escapedJson(
            toJson(comparison, sources, options.list).dump(2, ' ', false, Json::error_handler_t::replace)) +
        "\n");
    return kOk;
  }
  printTable(comparison);
  if (options.list) printList(comparison, sources);
  return kOk;
}

}  // namespace fulbito::app
