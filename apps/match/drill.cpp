#include "apps/match/drill.hpp"

#include <algorithm>
#include <charconv>
#include <cstdio>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "apps/common/commands.hpp"
#include "apps/common/console.hpp"
#include "apps/common/option_values.hpp"
#include "apps/common/progress.hpp"
#include "engine/core/config/suggest.hpp"
#include "match/drills/worth.hpp"

namespace fulbito::app {
namespace {

constexpr std::uint64_t kMostTrials = 1'000'000;

/// The number of the drill that `word` means, which is a number or a name.
Result<int> drillNumber(const std::vector<Drill>& drills, const std::string& word) {
  int number = 0;
  const auto parsed = std::from_chars(word.data(), word.data() + word.size(), number);
  const bool is_number = parsed.ec == std::errc() && parsed.ptr == word.data() + word.size();
  std::vector<std::string> names;
  for (const Drill& drill : drills) {
    if (is_number ? drill.number == number : drill.name == word) return drill.number;
    names.push_back(drill.name);
  }
  return fail(ErrorCode::kUsage, fmt::format("--drill: there is no drill '{}'.{} See fulbito drill --list.",
                                             word, suggestion(word, names)));
}

int listDrills(const std::vector<Drill>& drills) {
  for (const Drill& drill : drills) say("{:>3}  {:<20} {}\n", drill.number, drill.name, drill.what);
  return kOk;
}

}  // namespace

CLI::App* addDrill(CLI::App& app, DrillCommand& options) {
  CLI::App* command = app.add_subcommand("drill", "run standard drills with a team and print its results");
  command->footer(
      "Examples:\n"
      "  fulbito drill classic --drill 3,10 --trials 40\n"
      "  fulbito drill libero --json > drills.json\n"
      "  fulbito drill chaser classic --drill 3,10,13 --trials 80\n"
      "  fulbito drill libero --without race,spin    what these skills are worth on the same trials\n"
      "  fulbito drill --list\n"
      "All drills take about five minutes on one core; drills 18 and 21, which are whole matches, take most "
      "of\n"
      "it. stderr shows the progress. --drill and --trials shorten the run.\n"
      "Exit codes: 0 success, 1 with --check: a drill failed, 6 the machine cannot run a team.");
  command->add_option("team", options.teams, "team, e.g. classic; several teams print one table");
  command
      ->add_option("--drill", options.drills, "drills by number or name, separated by commas (default: all)")
      ->delimiter(',');
  CLI::Option* without = command
                             ->add_option("--without", options.without,
                                          "skills, separated by commas, or all: what each is worth")
                             ->delimiter(',')
                             ->type_name("SKILLS");
  wholeNumber(
      command->add_option("--trials", options.run.trials, "trials per drill (default: from the drill file)"),
      1, kMostTrials);
  addSeed(*command, options.run.seed, "start positions, matches");
  addJobs(*command, options.run.jobs, "worker threads");
  addModels(*command, options.run.robot, options.run.physics);
  command
      ->add_option("--drills", options.folder,
                   "use the *.toml files in this folder instead of the built-in drills")
      ->type_name("FOLDER");
  addTeamFlags(*command, options.outside);
  command->add_flag("--json", options.json, "print JSON");
  command->add_flag("--check", options.check, "return exit code 1 if a drill fails")->excludes(without);
  command->add_flag("--list", options.list, "list the drills and exit");
  return command;
}

namespace {

/// The built-in drills, or those in the folder of --drills.
Result<std::vector<Drill>> chosenDrills(const DrillCommand& options) {
  if (options.folder.empty()) return builtInDrills();
  return loadDrills(options.folder);
}

Result<std::vector<DrillReport>> runTeam(const std::vector<Drill>& drills, const std::vector<int>& numbers,
                                         const DrillOptions& options) {
  ProgressBar bar("drills of " + options.team.text);
  return runDrills(drills, numbers, options,
                   [&](std::size_t done, std::size_t total) { return bar.update(done, total); });
}

/// The teams to test. Errors: kUsage.
Result<std::vector<TeamChoice>> chosenTeams(const DrillCommand& options) {
  if (options.teams.empty()) return fail(ErrorCode::kUsage, "drill: name a team. See fulbito drill --help.");
  if (options.json && options.teams.size() > 1) {
    return fail(ErrorCode::kUsage, "--json: works with one team only");
  }
  if (!options.without.empty() && options.teams.size() > 1) {
    return fail(ErrorCode::kUsage, "--without: works with one team only");
  }
  std::vector<TeamChoice> teams;
  for (const std::string& name : options.teams) {
    auto team = options.run.catalogue.parse(name);
    if (!team) return tl::unexpected<Error>(team.error());
    teams.push_back(std::move(*team));
  }
  return teams;
}

int worth(const std::vector<Drill>& drills, const std::vector<int>& numbers, const TeamChoice& team,
          DrillCommand& options) {
  const auto left_out = withoutEach(team, options.without, options.run.catalogue);
  if (!left_out) return report(left_out.error());
  options.run.team = team;
  std::optional<ProgressBar> bar;
  const auto measured =
      measureWorth(drills, numbers, options.run, *left_out, [&](const std::string& name) -> DrillProgress {
        bar.emplace("drills of " + name);
        return [&](std::size_t done, std::size_t total) { return bar->update(done, total); };
      });
  bar.reset();
  if (!measured) return report(measured.error());
  options.json ? writeOut(worthJson(*measured, options.run)) : printOut(worthTable(*measured, options.run));
  return kOk;
}

}  // namespace

int drill(DrillCommand options) {
  const auto drills = chosenDrills(options);
  if (!drills) return report(drills.error());
  if (options.list) return listDrills(*drills);
  options.run.catalogue = catalogueOf(options.outside);
  const auto teams = chosenTeams(options);
  if (!teams) return report(teams.error());
  std::vector<int> numbers;
  for (const std::string& word : options.drills) {
    const auto number = drillNumber(*drills, word);
    if (!number) return report(number.error());
    numbers.push_back(*number);
  }
  if (!options.without.empty()) return worth(*drills, numbers, teams->front(), options);
  std::vector<std::vector<DrillReport>> reports;
  bool passed = true;
  for (const TeamChoice& team : *teams) {
    options.run.team = team;
    auto ran = runTeam(*drills, numbers, options.run);
    if (!ran) return report(ran.error());
    passed = passed && std::all_of(ran->begin(), ran->end(), [](const DrillReport& r) { return r.passed(); });
    reports.push_back(std::move(*ran));
  }
  const std::string text = options.json         ? drillJson(reports.front(), options.run)
                           : teams->size() == 1 ? drillTable(reports.front(), options.run)
                                                : drillOverview(options.teams, reports);
  if (options.json) {
    writeOut(text);
  } else {
    printOut(text);
  }
  return options.check && !passed ? kTestFailed : kOk;
}

}  // namespace fulbito::app
