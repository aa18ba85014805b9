#include "apps/drill.hpp"

#include <algorithm>
#include <charconv>
#include <cstdio>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "apps/commands.hpp"
#include "apps/progress.hpp"
#include "engine/core/suggest.hpp"

namespace fulbito::app {
namespace {

/// Numbers of the drills that a word names: a number or a name.
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
  for (const Drill& drill : drills) fmt::print("{:>3}  {:<20} {}\n", drill.number, drill.name, drill.what);
  return kOk;
}

}  // namespace

CLI::App* addDrill(CLI::App& app, DrillCommand& options) {
  CLI::App* command = app.add_subcommand("drill", "put a team through drills and print what it reaches");
  command->footer(
      "Examples:\n"
      "  fulbito drill classic --drill 3,10 --trials 40\n"
      "  fulbito drill libero --json > drills.json\n"
      "  fulbito drill --list\n"
      "Exit codes: 0 ran, 1 a drill was not passed (with --check only).");
  command->add_option("team", options.team, "team, e.g. classic");
  command->add_option("--drill", options.drills, "numbers or names (default: all)")->delimiter(',');
  command->add_option("--trials", options.run.trials, "of each drill (default: as the drill says)")
      ->check(CLI::Range(1, 1000000));
  command->add_option("--seed", options.run.seed, "seed of starts and matches")->capture_default_str();
  command->add_option("--jobs", options.run.jobs, "worker threads (default: all cores)");
  command->add_option("--robot", options.run.robot, "robot preset or TOML file")->capture_default_str();
  command->add_option("--physics", options.run.physics, "physics profile or TOML file")
      ->capture_default_str();
  command->add_option("--drills", options.folder, "take the *.toml files of this folder instead")
      ->type_name("FOLDER");
  command->add_flag("--json", options.json, "print JSON");
  command->add_flag("--check", options.check, "exit code 1 when a drill is not passed");
  command->add_flag("--list", options.list, "list the drills");
  return command;
}

int drill(DrillCommand options) {
  std::vector<Drill> drills = builtInDrills();
  if (!options.folder.empty()) {
    auto loaded = loadDrills(options.folder);
    if (!loaded) return report(loaded.error());
    drills = std::move(*loaded);
  }
  if (options.list) return listDrills(drills);
  if (options.team.empty())
    return report({ErrorCode::kUsage, "drill: which team? See fulbito drill --help."});
  auto team = parseTeam(options.team);
  if (!team) return report(team.error());
  options.run.team = std::move(*team);
  std::vector<int> numbers;
  for (const std::string& word : options.drills) {
    const auto number = drillNumber(drills, word);
    if (!number) return report(number.error());
    numbers.push_back(*number);
  }
  Result<std::vector<DrillReport>> reports;
  {
    ProgressBar bar("drills of " + options.team, options.json);
    reports = runDrills(drills, numbers, options.run,
                        [&](std::size_t done, std::size_t total) { return bar.update(done, total); });
  }
  if (!reports) return report(reports.error());
  const std::string text =
      options.json ? drillJson(*reports, options.run) : drillTable(*reports, options.run);
  std::fputs(text.c_str(), stdout);
  const bool passed =
      std::all_of(reports->begin(), reports->end(), [](const DrillReport& r) { return r.passed(); });
  return options.check && !passed ? kTestFailed : kOk;
}

}  // namespace fulbito::app
