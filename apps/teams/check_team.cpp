#include "apps/teams/check_team.hpp"

#include <CLI/CLI.hpp>

#include "apps/common/commands.hpp"
#include "apps/common/console.hpp"
#include "apps/common/option_values.hpp"
#include "apps/common/outputs.hpp"
#include "apps/common/progress.hpp"
#include "apps/teams/junit.hpp"
#include "engine/core/system/output_file.hpp"
#include "match/check/team_check.hpp"

namespace fulbito::app {
namespace {

Result<TeamReport> checked(const CheckTeamCommand& command) {
  TeamCheckOptions options;
  options.catalogue = catalogueOf(command.outside);
  auto team = options.catalogue.parse(command.team);
  if (!team) return tl::unexpected<Error>(team.error());
  options.team = std::move(*team);
  options.seed = command.seed;
  options.quick = command.quick;
  options.jobs = command.jobs;
  options.clock = now;
  ProgressBar bar("check of " + options.team.text);
  options.progress = [&](std::size_t done, std::size_t total) { return bar.update(done, total); };
  return fulbito::checkTeam(options);
}

}  // namespace

CLI::App* addCheckTeam(CLI::App& app, CheckTeamCommand& options) {
  CLI::App* command =
      app.add_subcommand("check-team", "check that a team plays by the protocol, in time and repeatably");
  command->footer(
      "Examples:\n"
      "  fulbito check-team classic\n"
      "  fulbito check-team 'cmd:python3 team.py' --quick\n"
      "  fulbito check-team ./team.so --json > check.json\n"
      "  fulbito check-team ./team.so --junit check.xml\n"
      "The team plays scripted situations: all restarts, corners, missing robots, five robots. Then it gets\n"
      "recorded situations twice, in the other seat and mirrored. docs/check-team.md explains each check.\n"
      "Exit codes: 0 no check failed, 1 a check failed, 2 the team does not start, 6 the machine cannot run "
      "it.");
  command->add_option("team", options.team, "team, e.g. classic, ./team.so or 'cmd:python3 team.py'")
      ->required();
  addSeed(*command, options.seed, "situations, drills");
  addJobs(*command, options.jobs, "worker threads of the drills");
  command->add_flag("--quick", options.quick, "shorter situations, fewer drills");
  addTeamFlags(*command, options.outside);
  command->add_flag("--json", options.json, "print JSON");
  markOutput(
      command->add_option("--junit", options.junit, "also write a JUnit report: one test case per check")
          ->type_name("FILE"),
      {OutputKind::kJunit});
  addForce(*command, "with --junit: replace an existing file");
  return command;
}

int checkTeam(const CheckTeamCommand& options) {
  const auto result = checked(options);
  if (!result) return report(result.error());
  if (!options.junit.empty()) {
    if (auto written = writeFile(options.junit, junitOf(*result)); !written) return report(written.error());
  }
  if (options.json) {
    writeOut(teamCheckJson(*result));
  } else {
    printOut(teamCheckTable(*result));
  }
  return result->verdict() == CheckVerdict::kFailed ? kTestFailed : kOk;
}

}  // namespace fulbito::app
