#include "apps/tournament/navigators.hpp"

#include <CLI/CLI.hpp>

#include "apps/common/commands.hpp"
#include "apps/common/console.hpp"
#include "apps/common/option_values.hpp"
#include "apps/common/progress.hpp"
#include "apps/common/sensor_options.hpp"

namespace fulbito::app {
namespace {

constexpr std::uint64_t kMostLayouts = 1'000'000;

}  // namespace

CLI::App* addNavigators(CLI::App& tournament, NavigatorsCommand& options) {
  NavigatorTournamentConfig& config = options.config;
  CLI::App* command = tournament.add_subcommand(
      "navigators", "rank navigation methods by their trials on the same seeded layouts");
  command->footer(
      "On each layout a method wins against those that fail or arrive later. Elo, tests and intervals have\n"
      "the layout as their unit.\n"
      "Examples:\n"
      "  fulbito tournament navigators bezier dwa nearness-diagram --trials 50\n"
      "  fulbito tournament navigators bezier bezier:clearance=0.03 --suite corner --speed 2.6 --json\n"
      "Names: fulbito list navigators, fulbito list suites. More: docs/tournaments.md.");
  command->add_option("navigators", config.navigators,
                      "methods, e.g. bezier limit-cycle:mu=3 (default: all built-in ones)");
  command->add_option("--suite", config.suite, "suite of layouts")->capture_default_str();
  command->add_option("--speed", config.speed, "top speed [m/s], 0.05 ... 10 (default: the suite's first)");
  wholeNumber(command->add_option("-n,--trials", config.trials, "layouts (default: the suite's)"), 1,
              kMostLayouts);
  addSeed(*command, config.seed, "layouts, sensor noise, resamples");
  addJobs(*command, config.jobs, "worker threads");
  addModels(*command, config.robot, config.physics);
  addSensors(*command, config.sensors);
  command->add_flag("--json", options.json, "print JSON");
  return command;
}

int navigators(const NavigatorsCommand& options) {
  ProgressBar bar(options.config.suite);
  const auto tournament = runNavigatorTournament(
      options.config, [&](std::size_t done, std::size_t total) { return bar.update(done, total); });
  if (!tournament) return report(tournament.error());
  if (options.json) {
    writeOut(navigatorTournamentJson(*tournament));
  } else {
    printOut(navigatorTournamentText(*tournament));
  }
  return kOk;
}

}  // namespace fulbito::app
