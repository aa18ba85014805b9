#include "apps/tournament/sprt.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "apps/common/commands.hpp"
#include "apps/common/console.hpp"
#include "apps/common/option_values.hpp"
#include "apps/common/progress.hpp"
#include "tournament/gate/gate.hpp"

namespace fulbito::app {
namespace {

constexpr std::uint64_t kMostPairs = 100'000;

Result<GateConfig> gateOf(const SprtCommand& options) {
  auto match = configOf(options.settings);
  if (!match) return tl::unexpected<Error>(match.error());
  GateConfig config;
  config.series.match = std::move(*match);
  config.series.pairs = options.pairs;
  config.series.jobs = options.jobs;
  config.series.clock = now;
  config.bounds = {options.bounds[0], options.bounds[1], options.alpha, options.beta};
  return config;
}

int exitCodeOf(const GateReport& report) {
  if (report.series.interrupted) return interruptedCode();
  switch (report.sprt.verdict()) {
    case SprtVerdict::kPass:
      return kOk;
    case SprtVerdict::kFail:
      return kTestFailed;
    case SprtVerdict::kInconclusive:
      break;
  }
  return kInconclusive;
}

}  // namespace

CLI::App* addSprt(CLI::App& app, SprtCommand& options) {
  CLI::App* command = app.add_subcommand("sprt", "test whether a new team is as strong as its base");
  command->footer(
      "Plays swapped pairs until a sequential test (GSPRT on pairs, normalized Elo) has a verdict. The "
      "verdict\n"
      "does not depend on --jobs. Exit codes: 0 pass, 1 fail, 6 inconclusive after --pairs.\n"
      "Examples:\n"
      "  fulbito sprt ./new.so ./old.so                          is the new version no weaker?\n"
      "  fulbito sprt libero classic --half-seconds 30\n"
      "  fulbito sprt ./new.so ./old.so --bounds 0,25 --pairs 5000   is it stronger?\n"
      "More: docs/tournaments.md.");
  command->add_option("new", options.settings.blue, "the new team")->required();
  command->add_option("base", options.settings.yellow, "the team that it must not be weaker than")
      ->required();
  command
      ->add_option("--bounds", options.bounds,
                   "normalized Elo of the hypotheses: fail at the first, pass at the second")
      ->delimiter(',')
      ->expected(2)
      ->allow_extra_args(false)
      ->type_name("WEAK,STRONG")
      ->capture_default_str();
  command->add_option("--alpha", options.alpha, "probability to pass a team of the first bound")
      ->capture_default_str();
  command->add_option("--beta", options.beta, "probability to fail a team of the second bound")
      ->capture_default_str();
  wholeNumber(command->add_option("-n,--pairs", options.pairs, "most pairs to play"), 1, kMostPairs)
      ->capture_default_str();
  addMatchSettings(*command, options.settings);
  addJobs(*command, options.jobs, "worker threads");
  command->add_flag("--json", options.json, "print JSON");
  return command;
}

int sprt(const SprtCommand& options) {
  const auto config = gateOf(options);
  if (!config) return report(config.error());
  const std::int64_t begin = now();
  ProgressBar bar(fmt::format("{} v {}, at most", options.settings.blue, options.settings.yellow));
  auto gate = runGate(*config, [&](std::size_t done, std::size_t total) { return bar.update(done, total); });
  if (!gate) return report(gate.error());
  gate->wall = static_cast<double>(now() - begin) * 1e-9;
  if (options.json) {
    writeOut(gateJson(*gate));
  } else {
    printOut(gateText(*gate));
  }
  return exitCodeOf(*gate);
}

}  // namespace fulbito::app
