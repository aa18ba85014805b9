#include "apps/tournament/tournament.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "apps/common/commands.hpp"
#include "apps/common/console.hpp"
#include "apps/common/option_values.hpp"
#include "apps/common/outputs.hpp"
#include "apps/common/team_flags.hpp"
#include "apps/tournament/recordings.hpp"
#include "engine/core/system/output_file.hpp"

namespace fulbito::app {
namespace {

constexpr const char* kFolder = "fulbito-tournament";
constexpr std::size_t kShownFixtures = 20;

/// The names of all formats as a list in words: "match, gauntlet or ladder".
std::string formatWords() {
  const auto last = kFormatNames.end() - 1;
  return fmt::format("{} or {}", fmt::join(kFormatNames.begin(), last, ", "), *last);
}

CLI::App* addRun(CLI::App& tournament, TournamentRun& options) {
  CLI::App* command = tournament.add_subcommand("run", "play a tournament, or the matches that are missing");
  command->footer(
      "Examples:\n"
      "  fulbito tournament run libero classic chaser random --pairs 2 --half-seconds 30\n"
      "  fulbito tournament run plan.toml --out results --html report.html\n"
      "  fulbito tournament run plan.toml --out shard-1 --shard 1/3    then: fulbito tournament merge\n"
      "  fulbito tournament run ./mine.so libero classic --format gauntlet --cache ~/matches\n"
      "Flags replace what the plan file says. More: docs/tournaments.md.");
  command->add_option("plan", options.words, "a plan file (TOML), or teams in the order of their seeding")
      ->type_name("PLAN | TEAM...")
      ->required();
  PlanSettings& settings = options.settings;
  command->add_option("--format", settings.format, formatWords())->capture_default_str();
  wholeNumber(command->add_option("-n,--pairs", settings.pairs, "pairs of matches per meeting"), 1,
              kMostPairs)
      ->capture_default_str();
  wholeNumber(
      command->add_option("--rounds", settings.rounds, "rounds of swiss and ladder; 0: as many as needed"), 0,
      kMostPairs)
      ->capture_default_str();
  wholeNumber(command->add_option("--groups", settings.groups, "groups of a round robin"), 1, kMostPairs)
      ->capture_default_str();
  command->add_option("--name", settings.name, "title of the reports")->capture_default_str();
  addStarts(*command, settings);
  addBounds(*command, settings);
  addMatchSettings(*command, settings.match, "FIRST,OTHERS");
  options.flags.out = kFolder;
  addRunFlags(*command, options.flags);
  addRecordings(*command, options.flags);
  command->add_flag("--dry-run", options.dry, "print the schedule known so far and play nothing");
  addReportFiles(*command, options.files);
  options.command = command;
  return command;
}

void addReport(CLI::App& tournament, TournamentReport& options) {
  CLI::App* command =
      tournament.add_subcommand("report", "report on a folder of results, also while it grows");
  command->footer(
      "Examples:\n"
      "  fulbito tournament report results\n"
      "  fulbito tournament report results --html report.html --junit report.xml\n"
      "  fulbito tournament report results --recordings upsets --html report.html     with matches to watch\n"
      "  fulbito tournament report results --markdown - >> \"$GITHUB_STEP_SUMMARY\"");
  markFolder(command->add_option("folder", options.folder, "folder of `tournament run --out`")->required(),
             options.folder, FolderUse::kResults);
  command
      ->add_option("--recordings", options.recordings,
                   "'upsets': record the matches to look at, by playing them again; 'none'")
      ->check(CLI::IsMember({"none", "upsets"}))
      ->capture_default_str();
  addTeamFlags(*command, options.outside);
  addReportFiles(*command, options.files);
}

void addMerge(CLI::App& tournament, TournamentMerge& options) {
  CLI::App* command = tournament.add_subcommand("merge", "unite the results of shards");
  command->footer(
      "Exit codes: 7 if two runs of one match differ, 6 if matches are missing.\n"
      "Example:\n"
      "  fulbito tournament merge shard-1 shard-2 shard-3 --out results --html report.html");
  markFolders(command->add_option("folders", options.folders, "folders of the shards")->required(),
              options.folders, FolderUse::kResults);
  markFolder(command->add_option("--out", options.out, "folder of the united results")
                 ->required()
                 ->type_name("FOLDER"),
             options.out, FolderUse::kResults);
  addReportFiles(*command, options.files);
}

/// Whether the words name a plan: a single file with the ending of a plan. Otherwise they are teams.
bool namesPlan(const std::vector<std::string>& words) {
  return words.size() == 1 && words.front().ends_with(".toml");
}

/// Applies all given flags again, after a plan file has overwritten their variables.
void applyGivenFlags(CLI::App& command) {
  for (CLI::Option* option : command.get_options()) {
    if (option->count() > 0) option->run_callback();
  }
}

Result<TournamentPlan> planOf(TournamentRun& options) {
  if (namesPlan(options.words)) {
    const TeamFlags outside = options.settings.match.outside;
    auto read = readPlanFile(options.words.front());
    if (!read) return tl::unexpected<Error>(read.error());
    options.settings = std::move(*read);
    options.settings.match.outside = outside;
    applyGivenFlags(*options.command);
  } else {
    for (const std::string& team : options.words) options.settings.entrants.push_back({team, {}, {}});
  }
  return planOf(options.settings);
}

int printSchedule(const TournamentPlan& plan) {
  if (auto checked = checkPlan(plan); !checked) return report(checked.error());
  const Schedule schedule = scheduleOf(plan, {});
  say("{}: {}, {} entrants, {} matches{}\n", plan.name, nameOf(plan.format), plan.entrants.size(),
      2 * schedule.fixtures.size(), schedule.complete ? "" : " in the first round");
  for (std::size_t i = 0; i < schedule.fixtures.size() && i < kShownFixtures; ++i) {
    const Fixture& fixture = schedule.fixtures[i];
    say("  {:>4}  round {}  {} against {}, {}\n", i + 1, fixture.round + 1, plan.entrants[fixture.a].name,
        plan.entrants[fixture.b].name, bookEntry(plan.book, fixture.start).name);
  }
  if (schedule.fixtures.size() > kShownFixtures) {
    say("  and {} more pairs\n", schedule.fixtures.size() - kShownFixtures);
  }
  return kOk;
}

int print(const TournamentState& state, const ReportFiles& files, const std::string& folder) {
  if (auto written = writeReports(state, files, folder); !written) return report(written.error());
  return kOk;
}

/// Plays the notable matches again, with the teams that the plan names, and records them.
Result<void> recordUpsets(TournamentState& state, const TeamFlags& outside, const std::string& folder) {
  const TeamCatalogue catalogue = catalogueOf(outside);
  for (Entrant& entrant : state.plan.entrants) {
    auto team = catalogue.parse(entrant.team.text);
    if (!team) return tl::unexpected<Error>(team.error());
    entrant.team = std::move(*team);
  }
  const std::string recordings = recordingsOf(folder);
  if (auto made = prepareFolder(recordings); !made) return made;
  return recordNotable(state, tableOf(state).notable, recordings);
}

int run(TournamentRun& options) {
  if (auto checked = checkReportFiles(options.files); !checked) return report(checked.error());
  const auto plan = planOf(options);
  if (!plan) return report(plan.error());
  if (options.dry) return printSchedule(*plan);
  note("seed {}, results in {}\n", plan->seed, options.flags.out);
  const auto played = runPlan(*plan, options.flags);
  if (!played) return report(played.error());
  noteOutcome(*played, options.flags);
  if (const int code = print(played->outcome.state, options.files, options.flags.out); code != kOk)
    return code;
  return exitCodeOf(*played, options.flags);
}

int reportFolder(const TournamentReport& options) {
  if (auto checked = checkReportFiles(options.files); !checked) return report(checked.error());
  auto folder = readFolder(options.folder);
  if (!folder) return report(folder.error());
  if (options.recordings == "upsets") {
    if (auto done = recordUpsets(folder->state, options.outside, options.folder); !done) {
      return report(done.error());
    }
  }
  return print(folder->state, options.files, options.folder);
}

int merge(const TournamentMerge& options) {
  if (auto checked = checkReportFiles(options.files); !checked) return report(checked.error());
  const auto merged = mergeFolders(options.folders, options.out);
  if (!merged) return report(merged.error());
  for (const MatchConflict& conflict : merged->conflicts) {
    note("two runs of one match differ: {} against {}, {}, {}:{} in {}, {}:{} in {}\n",
         conflict.first.teams[0], conflict.first.teams[1], conflict.first.start,
         conflict.first.result.score[0], conflict.first.result.score[1], conflict.first_file,
         conflict.second.result.score[0], conflict.second.result.score[1], conflict.second_file);
  }
  if (!merged->conflicts.empty()) return kDifferent;
  note("{} matches in {}\n", merged->matches, options.out);
  const auto folder = readFolder(options.out);
  if (!folder) return report(folder.error());
  if (const int code = print(folder->state, options.files, options.out); code != kOk) return code;
  if (folder->state.finished()) return exitCodeOf(folder->state);
  note("matches are missing: run the shards again, or `fulbito tournament run` with --out {}\n", options.out);
  return kInconclusive;
}

}  // namespace

void addTournament(CLI::App& app, TournamentCommand& options) {
  CLI::App* command = app.add_subcommand("tournament", "play tournaments and report on them");
  command->footer("See fulbito tournament run --help. More: docs/tournaments.md.");
  command->require_subcommand(1);
  addRun(*command, options.run);
  addReport(*command, options.report);
  addMerge(*command, options.merge);
  addNavigators(*command, options.navigators);
}

int tournament(const CLI::App& app, TournamentCommand& options) {
  const CLI::App* command = app.get_subcommand("tournament");
  if (command->got_subcommand("run")) return run(options.run);
  if (command->got_subcommand("report")) return reportFolder(options.report);
  if (command->got_subcommand("merge")) return merge(options.merge);
  return navigators(options.navigators);
}

}  // namespace fulbito::app
