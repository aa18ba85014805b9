#include "apps/tournament/tune.hpp"

#include <algorithm>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "apps/common/commands.hpp"
#include "apps/common/console.hpp"
#include "apps/common/option_values.hpp"
#include "apps/common/outputs.hpp"
#include "apps/tournament/progress_line.hpp"
#include "apps/tournament/tune_chart.hpp"
#include "tournament/tune/tune_folder.hpp"
#include "tournament/tune/tune_report.hpp"
#include "tournament/tune/tune_run.hpp"

namespace fulbito::app {
namespace {

constexpr std::uint64_t kMostIterations = 1'000'000;
constexpr int kUsualTunePairs = 8;

/// Default of r_end. With it, a parameter whose one version wins every match would move about four times its
/// range.
double usualStep(double perturbation, int iterations) {
  return std::min(1.0, 2.0 / (perturbation * iterations));
}

/// Without an opponent both versions have the same vision, so a second value is an error. Errors: kUsage.
Result<void> checkSight(const TuneCommand& options) {
  const SeatSensors& seen = options.settings.match.sensors;
  const std::size_t most =
      std::max({seen.latency_ticks.size(), seen.position_noise.size(), seen.dropout.size()});
  if (!options.opponent.empty() || most < 2) return {};
  return fail(ErrorCode::kUsage,
              "two values of what teams see need an --opponent: both versions see the same");
}

/// The plan that all iterations share. Without an opponent the team meets itself.
Result<TournamentPlan> baseOf(const TuneCommand& options) {
  PlanSettings settings = options.settings;
  settings.name = "tune " + options.team;
  settings.format = nameOf(TournamentFormat::kMatch);
  const std::string& other = options.opponent.empty() ? options.team : options.opponent;
  settings.entrants = {{options.team, "team", {}}, {other, "opponent", {}}};
  return planOf(settings);
}

Result<TunePlan> tunePlanOf(const TuneCommand& options) {
  if (auto checked = checkSight(options); !checked) return tl::unexpected<Error>(checked.error());
  auto base = baseOf(options);
  if (!base) return tl::unexpected<Error>(base.error());
  auto team = TunedTeam::of(base->entrants[0].team);
  if (!team) return tl::unexpected<Error>(team.error());
  const double step = options.step > 0.0 ? options.step : usualStep(options.perturbation, options.iterations);
  auto chosen = parametersOf(base->entrants[0].team, *team, options.parameters, options.perturbation, step);
  if (!chosen) return tl::unexpected<Error>(chosen.error());
  if (!chosen->skipped.empty()) {
    note("note: not tuned, as they are no numbers: {}\n", fmt::join(chosen->skipped, ", "));
  }
  TunePlan plan;
  plan.team = std::move(*team);
  plan.spsa = {std::move(chosen->parameters), options.iterations, base->seed};
  plan.final_pairs = options.final_pairs;
  plan.base = std::move(*base);
  plan.opponent = !options.opponent.empty();
  if (auto checked = validate(plan); !checked) return tl::unexpected<Error>(checked.error());
  if (auto checked = checkPlan(plan.base); !checked) return tl::unexpected<Error>(checked.error());
  return plan;
}

/// Where results are stored: in memory or in a folder.
struct Keep {
  MatchMemory memory;
  LogFolder folder;
  MatchStore& log() { return folder.log ? static_cast<MatchStore&>(*folder.log) : memory; }
};

Result<void> openFolder(const TuneCommand& options, const TunePlan& plan, Keep& keep) {
  if (options.out.empty()) return {};
  const auto identity = MatchIdentity::create(plan.base);
  if (!identity) return tl::unexpected<Error>(identity.error());
  auto folder = openTuneFolder(options.out, plan, *identity);
  if (!folder) return tl::unexpected<Error>(folder.error());
  keep.folder = std::move(*folder);
  for (const std::string& change : keep.folder.changed) {
    note("note: {}: what it played is played again\n", change);
  }
  return {};
}

Result<TuneOutcome> playTuning(const TuneCommand& options, const TunePlan& plan) {
  Keep keep;
  if (auto opened = openFolder(options, plan, keep); !opened) return tl::unexpected<Error>(opened.error());
  ProgressLine line(plan.base.name);
  TuneOptions run;
  run.jobs = options.jobs;
  run.clock = now;
  run.log = &keep.log();
  run.progress = [&line](const RunProgress& progress) { return line.update(progress); };
  return runTune(plan, catalogueOf(options.settings.match.outside), run);
}

void noteTuning(const TuneCommand& options, const TuneOutcome& outcome) {
  if (!options.out.empty()) {
    note("{} matches played, {} were there already\n", outcome.played, outcome.taken);
  }
  if (!outcome.mismatches.empty()) {
    note("{} matches differ from those of another run; a team or the machine is not deterministic\n",
         outcome.mismatches.size());
  }
  if (outcome.interrupted || !outcome.unplayed.empty()) {
    note("stopped; {}\n",
         options.out.empty() ? "with --out, the same command could continue" : "the same command continues");
  }
}

int exitCodeOfTuning(const TuneOutcome& outcome) {
  if (!outcome.mismatches.empty()) return kDifferent;
  if (outcome.interrupted) return interruptedCode();
  return outcome.unplayed.empty() ? kOk : kInconclusive;
}

/// Adds the options of the SPSA method.
void addSpsa(CLI::App& command, TuneCommand& options) {
  wholeNumber(command.add_option("--iterations", options.iterations, "moves of the parameters"), 1,
              kMostIterations)
      ->capture_default_str();
  options.settings.pairs = kUsualTunePairs;
  wholeNumber(command.add_option("-n,--pairs", options.settings.pairs, "pairs of matches per iteration"), 1,
              kMostPairs)
      ->capture_default_str();
  number(command.add_option("--c-end", options.perturbation,
                            "last perturbation of all parameters, as a share of their ranges"))
      ->check(CLI::Range(1e-6, 0.5))
      ->capture_default_str();
  number(command.add_option(
             "--r-end", options.step,
             "last move over last perturbation, if a version wins all; 0: 2 / (C_END * iterations)"))
      ->check(CLI::Range(0.0, 100.0))
      ->capture_default_str();
  wholeNumber(command.add_option("--final-pairs", options.final_pairs,
                                 "pairs of the tuned team against the start; 0: none"),
              0, kMostPairs)
      ->capture_default_str();
}

void addTuneOutputs(CLI::App& command, TuneCommand& options) {
  CLI::Option* out =
      command
          .add_option("--out", options.out,
                      "folder that keeps the matches; the same command continues what it holds")
          ->type_name("FOLDER");
  markFolder(out, options.out, FolderUse::kResults);
  addJobs(command, options.jobs, "matches at once");
  markOutput(command.add_option("--png", options.png, "draw the path of the parameters")->type_name("FILE"),
             {OutputKind::kPng, Dash::kRefused, Existing::kReplaced});
  addForce(command, "with --png: replace an existing file of another kind");
}

}  // namespace

CLI::App* addTune(CLI::App& app, TuneCommand& options) {
  CLI::App* command = app.add_subcommand("tune", "tune the parameters of a team by playing matches");
  command->footer(
      "SPSA: each iteration moves all parameters up or down at random, lets both versions play pairs of\n"
      "matches and follows the winner. The path does not depend on --jobs. At the end the tuned team meets\n"
      "the start on starts that the tuning did not use. The exit code is 0 even if nothing got better,\n"
      "and 6 if the machine failed a match.\n"
      "Examples:\n"
      "  fulbito tune classic --half-seconds 20 --png path.png\n"
      "  fulbito tune classic:support=0.8 --parameters support,strike_speed --out tuning\n"
      "  fulbito tune classic --opponent libero --iterations 200 --pairs 16\n"
      "  fulbito tune 'cmd:./team.py' --parameters gain=1:0:5,reach=0.2:0.05:1\n"
      "More: docs/tuning.md.");
  command->add_option("team", options.team, "the team; its specification gives the first values")->required();
  command
      ->add_option("--parameters", options.parameters,
                   "NAME or NAME=START:LOW:HIGH[:C_END[:R_END]] (default: all declared)")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->type_name("NAME[,NAME...]");
  command->add_option("--opponent", options.opponent,
                      "both versions play against this team, on the same starts (default: each other)");
  addSpsa(*command, options);
  addStarts(*command, options.settings);
  addMatchSettings(*command, options.settings.match, "TEAM,OPPONENT");
  addTuneOutputs(*command, options);
  command->add_flag("--json", options.json, "print JSON instead of text");
  return command;
}

int tune(const TuneCommand& options) {
  const auto plan = tunePlanOf(options);
  if (!plan) return report(plan.error());
  const auto outcome = playTuning(options, *plan);
  if (!outcome) return report(outcome.error());
  noteTuning(options, *outcome);
  if (options.json) {
    writeOut(tuneJson(*plan, *outcome));
  } else {
    printOut(tuneText(*plan, *outcome));
  }
  if (!options.png.empty()) {
    if (auto drawn = writeTuneChart(*plan, *outcome, options.png); !drawn) return report(drawn.error());
  }
  return exitCodeOfTuning(*outcome);
}

}  // namespace fulbito::app
