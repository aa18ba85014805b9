#include "apps/tournament/plan_settings.hpp"

#include <algorithm>
#include <limits>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "apps/common/option_values.hpp"
#include "engine/core/config/config_document.hpp"
#include "engine/core/config/suggest.hpp"
#include "engine/core/system/text_file.hpp"

namespace fulbito::app {
namespace {

constexpr std::size_t kLargestPlan = 1 << 20;  // [bytes]
constexpr double kLongText = 4096;
constexpr double kMost = std::numeric_limits<int>::max();

/// Values of a plan file that are stored in another form in the settings.
struct PlanFile {
  PlanSettings settings;
  int seed = static_cast<int>(kDefaultMatchSeed);
  int starts_seed = 1;
  std::string starts = "kick-off";
  double half_seconds = 0.0;  // 0: as in the rules
  int latency = 0;
  double noise = 0.0;
  double dropout = 0.0;
  double weak = -50.0;
  double strong = 0.0;
};

Schema tournamentSchema(PlanFile& p) {
  return {{"name", Label{&p.settings.name}, 1, 100, "", ""},
          {"format", &p.settings.format, 1, kLongText, "", ""},
          {"pairs", &p.settings.pairs, 1, 1e5, "", "per meeting"},
          {"rounds", &p.settings.rounds, 0, 1e5, "", "of swiss and ladder; 0: as many as needed"},
          {"groups", &p.settings.groups, 1, 500, "", "of a round robin"},
          {"seed", &p.seed, 0, kMost, "", ""},
          {"starts", &p.starts, 1, kLongText, "", "kinds, with commas between them"},
          {"starts_seed", &p.starts_seed, 0, kMost, "", ""}};
}

Schema matchSchema(PlanFile& p) {
  MatchSettings& m = p.settings.match;
  return {{"rules", &m.rules, 1, kLongText, "", "profile or file"},
          {"physics", &m.physics, 1, kLongText, "", "profile or file"},
          {"robot", &m.robot, 1, kLongText, "", "preset or file"},
          {"half_seconds", &p.half_seconds, 0.0, 1e5, "s", "0: by the rules"},
          {"start", &m.start, 0, kLongText, "", "file of a start state"},
          {"latency", &p.latency, 0, 60, "ticks", ""},
          {"noise", &p.noise, 0.0, 0.1, "m", ""},
          {"dropout", &p.dropout, 0.0, 0.99, "", ""},
          {"time", &m.time, 0, kLongText, "", "ms per decision, or 'unlimited'"}};
}

Schema testSchema(PlanFile& p) {
  return {{"weak", &p.weak, -1e3, 1e3, "normalized Elo", ""},
          {"strong", &p.strong, -1e3, 1e3, "normalized Elo", ""},
          {"alpha", &p.settings.alpha, 0.0, 1.0, "", ""},
          {"beta", &p.settings.beta, 0.0, 1.0, "", ""}};
}

std::vector<std::string> listOf(const std::string& text) {
  std::vector<std::string> words;
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t comma = std::min(text.find(',', at), text.size());
    const std::string_view word = std::string_view(text).substr(at, comma - at);
    const std::size_t begin = word.find_first_not_of(' ');
    if (begin != std::string_view::npos) {
      words.emplace_back(word.substr(begin, word.find_last_not_of(' ') - begin + 1));
    }
    at = comma + 1;
  }
  return words;
}

Result<void> readEntrants(const ConfigDocument& document, PlanSettings& settings) {
  const auto count = document.count("team");
  if (!count) return tl::unexpected<Error>(count.error());
  for (int i = 0; i < *count; ++i) {
    EntrantSettings entrant;
    std::string files;
    const Schema schema{{"team", &entrant.team, 1, kLongText, "", "specification", true},
                        {"name", &entrant.name, 1, 200, "", ""},
                        {"files", &files, 0, kLongText, "", "with commas between them"}};
    if (auto read = document.readElement("team", i, schema); !read) return read;
    entrant.files = listOf(files);
    settings.entrants.push_back(std::move(entrant));
  }
  return {};
}

PlanSettings settingsOf(PlanFile file, bool test) {
  PlanSettings settings = std::move(file.settings);
  settings.match.seed = static_cast<std::uint64_t>(file.seed);
  settings.starts = listOf(file.starts);
  settings.starts_seed = static_cast<std::uint64_t>(file.starts_seed);
  if (file.half_seconds > 0.0) settings.match.half_seconds = file.half_seconds;
  settings.match.sensors.latency_ticks = {file.latency};
  settings.match.sensors.position_noise = {file.noise};
  settings.match.sensors.dropout = {file.dropout};
  if (test) settings.bounds = {file.weak, file.strong};
  return settings;
}

Result<std::vector<StartKind>> kindsOf(const std::vector<std::string>& names) {
  std::vector<std::string> all;
  all.reserve(kStartKinds);
  for (std::size_t i = 0; i < kStartKinds; ++i) all.emplace_back(nameOf(static_cast<StartKind>(i)));
  std::vector<StartKind> kinds;
  for (const std::string& name : names) {
    const auto kind = startKindOf(name);
    if (!kind) {
      return fail(ErrorCode::kUsage, fmt::format("--starts: there is no start '{}'.{} Starts: {}", name,
                                                 suggestion(name, all), fmt::join(all, ", ")));
    }
    kinds.push_back(*kind);
  }
  return kinds;
}

Result<TournamentFormat> formatNamed(const std::string& name) {
  if (const auto format = formatOf(name)) return *format;
  const std::vector<std::string> all(kFormatNames.begin(), kFormatNames.end());
  return fail(ErrorCode::kUsage, fmt::format("--format: there is no format '{}'.{} Formats: {}", name,
                                             suggestion(name, all), fmt::join(all, ", ")));
}

Result<std::vector<Entrant>> entrantsOf(const PlanSettings& settings) {
  const TeamCatalogue catalogue = catalogueOf(settings.match.outside);
  std::vector<Entrant> entrants;
  for (const EntrantSettings& named : settings.entrants) {
    auto team = catalogue.parse(named.team);
    if (!team) return tl::unexpected<Error>(team.error());
    entrants.push_back({named.name.empty() ? named.team : named.name, std::move(*team), named.files});
  }
  return entrants;
}

}  // namespace

void addStarts(CLI::App& command, PlanSettings& settings) {
  command
      .add_option("--starts", settings.starts,
                  "how matches start, in turn: kick-off, free-ball, penalty, goal-kick, play")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->type_name("KIND[,KIND...]")
      ->capture_default_str();
  wholeNumber(command.add_option("--starts-seed", settings.starts_seed, "seed of the book of starts"))
      ->capture_default_str();
}

void addBounds(CLI::App& command, PlanSettings& settings) {
  command
      .add_option("--bounds", settings.bounds,
                  "normalized Elo of the hypotheses: fail at the first, pass at the second")
      ->delimiter(',')
      ->expected(2)
      ->allow_extra_args(false)
      ->type_name("WEAK,STRONG")
      ->capture_default_str();
  command.add_option("--alpha", settings.alpha, "probability to pass a team of the first bound")
      ->capture_default_str();
  command.add_option("--beta", settings.beta, "probability to fail a team of the second bound")
      ->capture_default_str();
}

Result<PlanSettings> readPlanFile(const std::string& file) {
  const auto text = readTextFile(file, kLargestPlan);
  if (!text) return tl::unexpected<Error>(text.error());
  static const std::vector<std::string> kTables{"tournament", "match", "sprt", "team"};
  const auto document = ConfigDocument::parse(*text, file, kTables);
  if (!document) return tl::unexpected<Error>(document.error());
  PlanFile plan;
  plan.settings.name = document->fallbackName();
  for (const auto& read :
       {document->read("tournament", tournamentSchema(plan), false),
        document->read("match", matchSchema(plan), false), document->read("sprt", testSchema(plan), false),
        readEntrants(*document, plan.settings)}) {
    if (!read) return tl::unexpected<Error>(read.error());
  }
  return settingsOf(std::move(plan), document->has("sprt"));
}

Result<TournamentPlan> planOf(const PlanSettings& settings) {
  TournamentPlan plan;
  plan.name = settings.name;
  plan.pairs = settings.pairs;
  plan.rounds = settings.rounds;
  plan.groups = settings.groups;
  plan.seed = settings.match.seed;
  plan.book.seed = settings.starts_seed;
  auto format = formatNamed(settings.format);
  if (!format) return tl::unexpected<Error>(format.error());
  plan.format = *format;
  auto kinds = kindsOf(settings.starts);
  if (!kinds) return tl::unexpected<Error>(kinds.error());
  plan.book.kinds = std::move(*kinds);
  if (!settings.bounds.empty()) {
    plan.sprt = SprtBounds{settings.bounds[0], settings.bounds[1], settings.alpha, settings.beta};
  }
  auto match = configWithoutTeams(settings.match);
  if (!match) return tl::unexpected<Error>(match.error());
  plan.match = std::move(*match);
  auto entrants = entrantsOf(settings);
  if (!entrants) return tl::unexpected<Error>(entrants.error());
  plan.entrants = std::move(*entrants);
  return plan;
}

}  // namespace fulbito::app
