#include "apps/match/match.hpp"

#include <optional>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "apps/common/commands.hpp"
#include "apps/common/console.hpp"
#include "apps/common/option_values.hpp"
#include "apps/common/outputs.hpp"
#include "apps/common/team_flags.hpp"
#include "apps/match/live_line.hpp"
#include "apps/tournament/two_teams.hpp"
#include "engine/core/system/machine_room.hpp"
#include "engine/core/system/output_file.hpp"
#include "fulbito/match.hpp"
#include "fulbito/recorder.hpp"
#include "fulbito/statistics.hpp"
#include "referee/restarts/check_places.hpp"

namespace fulbito::app {
namespace {

constexpr Tick kTicksBetweenChecks = 64;  // ticks between checks of the clock and for signals
constexpr const char* kStdout = "-";
constexpr int kMostAttempts = 3;  // attempts at a match that the machine interrupts

double secondsSince(std::int64_t begin) { return static_cast<double>(now() - begin) * 1e-9; }

/// A file, or stdout, to which each line is written immediately. Keeps the first failure.
class LineFile {
 public:
  static Result<LineFile> open(const std::string& name, bool replace) {
    if (name == kStdout) return LineFile(std::nullopt);
    auto file = OutputFile::grow(name, replace);
    if (!file) return tl::unexpected<Error>(file.error());
    return LineFile(std::move(*file));
  }
  void write(std::string_view line) {
    if (file_) {
      (void)file_->write(line);
    } else {
      writeOut(line);
      flushOut();
    }
  }
  /// Completes the file. Errors: the first failed write.
  Result<void> finish() { return file_ ? file_->commit() : Result<void>(); }

 private:
  explicit LineFile(std::optional<OutputFile> file) : file_(std::move(file)) {}
  std::optional<OutputFile> file_;  ///< empty: stdout; `finishOutput` reports its failures
};

/// Checks the combination of flags for a single match.
Result<void> checkFlags(const MatchCommand& options) {
  if (options.json && options.events == kStdout) {
    return fail(ErrorCode::kUsage, "--events - and --json both write to stdout; give --events a file");
  }
  if (!options.pairs) {
    return options.series.out.empty() ? Result<void>()
                                      : fail(ErrorCode::kUsage, "--out keeps a series: give -n/--pairs too");
  }
  for (const auto& [flag, given] :
       {std::pair{"--record", !options.record.empty()}, std::pair{"--events", !options.events.empty()},
        std::pair{"--profile", options.profile}, std::pair{"--view", options.view}}) {
    if (given) {
      return fail(ErrorCode::kUsage,
                  fmt::format("{} records a single match and cannot be used with -n/--pairs", flag));
    }
  }
  return {};
}

/// Everything that observes the match for the user.
struct Watchers {
  StatisticsObserver statistics;
  EventLog log;
  std::optional<LineFile> file;
  std::optional<EventLines> lines;
  std::optional<MatchRecorder> recorder;

  Result<void> attach(const MatchCommand& options, Match& match);
  /// Completes all files. Errors: the first failed write.
  Result<void> finish();
};

Result<void> Watchers::attach(const MatchCommand& options, Match& match) {
  match.watch(statistics);
  match.watch(log);
  if (!options.events.empty()) {
    auto opened = LineFile::open(options.events, options.force);
    if (!opened) return tl::unexpected<Error>(opened.error());
    file.emplace(std::move(*opened));
    lines.emplace([this](std::string_view line) { file->write(line); });
    match.watch(*lines);
  }
  if (!options.record.empty()) {
    auto created = MatchRecorder::create(
        options.record, match.config(),
        options.record_recipe ? RecordingLevel::kRecipe : RecordingLevel::kFull, options.force);
    if (!created) return tl::unexpected<Error>(created.error());
    recorder.emplace(std::move(*created));
    if (options.drawings) recorder->keepDrawings();
    match.watch(*recorder);
  }
  return {};
}

Result<void> Watchers::finish() {
  if (file) {
    if (auto finished = file->finish(); !finished) return finished;
  }
  if (recorder && !recorder->written()) return recorder->written();
  return {};
}

/// Plays the match until its end or a signal.
void play(Match& match) {
  LiveLine live(match.config());
  while (match.step()) {
    if (match.tick() % kTicksBetweenChecks != 0) continue;
    if (interrupted()) break;
    live.update(match);
  }
  match.finish();
}

void print(const MatchCommand& options, const MatchReport& report) {
  if (options.json) {
    writeOut(matchJson(report));
  } else {
    const std::string text = matchText(report);
    options.events == kStdout ? printNote(text) : printOut(text);
  }
  flushOut();
}

/// The window of `--view`, if the flag is set. Errors: as `openWindow`.
Result<std::optional<ViewWindow>> windowOf(const MatchCommand& options) {
  if (!options.view) return std::nullopt;
  auto opened = openWindow(options.window);
  if (!opened) return tl::unexpected<Error>(opened.error());
  return std::optional(std::move(*opened));
}

Result<void> play(Match& match, std::optional<ViewWindow>& window, const MatchCommand& options) {
  if (window) return playInWindow(match, *window, options.window);
  play(match);
  return {};
}

/// The exit code of a match. A window that is closed early is not a failure.
int exitCode(const MatchReport& report, bool closed) {
  if (report.faults.abandoned) {
    return app::report(
        {report.faults.abandoned->code, "the match was abandoned: " + report.faults.abandoned->message});
  }
  return report.complete || (closed && !interrupted()) ? kOk : interruptedCode();
}

/// Prints which layers of containment a team lacks on this machine.
void noteContainment(const MatchConfig& config) {
  for (const TeamChoice& team : config.teams) {
    for (const Setting& entry : team.origin) {
      if (entry.name == "containment_missing") note("note: {} runs without {}\n", team.text, entry.value);
    }
  }
}

int reportUnplayed(Error error) {
  if (error.code == ErrorCode::kMachine) error.message = "the match was not played: " + error.message;
  return report(error);
}

/// Whether to repeat a match that the machine interrupted. Output on stdout or in a window cannot be taken
/// back.
bool worthAnother(const MatchCommand& options, const MatchReport& report) {
  return report.faults.abandoned && report.faults.abandoned->code == ErrorCode::kMachine && !options.view &&
         options.events != kStdout;
}

/// @param last  whether this attempt counts even if the machine interrupts the match
/// @return the exit code; empty: the match has to be repeated
std::optional<int> attempt(const MatchCommand& options, const MatchConfig& config, bool last) {
  // Opens the window before any output file, so that a failure leaves no file.
  auto window = windowOf(options);
  if (!window) return report(window.error());
  auto made = MachineRoom().run([&] { return Match::create(config, now); });
  if (!made) return reportUnplayed(made.error());
  noteContainment(made->config());
  Watchers watchers;
  if (auto attached = watchers.attach(options, *made); !attached) return report(attached.error());
  MatchProfile profile;
  if (options.profile) made->measure(now, profile);
  const std::int64_t begin = now();
  const auto played = play(*made, *window, options);
  MatchReport summary = reportOf(*made, watchers.statistics, watchers.log);
  summary.wall = secondsSince(begin);
  if (options.profile) summary.profile = profile;
  if (!last && worthAnother(options, summary)) {
    note("note: the match was abandoned: {}; it is played again\n", summary.faults.abandoned->message);
    return std::nullopt;
  }
  print(options, summary);
  if (auto written = watchers.finish(); !written) return report(written.error());
  if (!options.record.empty()) note("recording: {}\n", options.record);
  if (!played) return report(played.error());
  return exitCode(summary, options.view);
}

int playOne(MatchCommand options, const MatchConfig& config) {
  for (int attempts = 1;; ++attempts) {
    if (const auto code = attempt(options, config, attempts == kMostAttempts)) return *code;
    options.force = true;  // replaces the files of the last attempt
  }
}

int playPairs(const MatchCommand& options) {
  PlanSettings settings;
  settings.match = options.settings;
  settings.pairs = *options.pairs;
  ReportFiles files;
  files.json = options.json;
  return playTwoTeams(options.settings.blue, options.settings.yellow, settings, options.series, files);
}

void addSeries(CLI::App& command, MatchCommand& options) {
  wholeNumber(
      command.add_option("-n,--pairs", options.pairs, "swapped pairs of a series (teams change colours)"), 1,
      kMostPairs)
      ->type_name("PAIRS");
  addJobs(command, options.series.jobs, "matches of a series at once");
  CLI::Option* out =
      command
          .add_option("--out", options.series.out,
                      "with -n: folder that keeps the results; the same command continues what it holds")
          ->type_name("FOLDER");
  markFolder(out, options.series.out, FolderUse::kResults);
}

}  // namespace

void addMatchOutputs(CLI::App& command, MatchCommand& options) {
  CLI::Option* record =
      command.add_option("--record", options.record, "write a recording")->type_name("FILE");
  markOutput(record, {OutputKind::kRecording});
  CLI::Option* recipe =
      command
          .add_flag("--recipe", options.record_recipe,
                    "with --record: omit sampled states (recomputed when read); about a third smaller")
          ->needs(record);
  command
      .add_flag("--drawings", options.drawings,
                "with --record: also record the teams' drawings, 10 times per second, for pictures")
      ->needs(record)
      ->excludes(recipe);
  markOutput(command
                 .add_option("--events", options.events,
                             "events as JSON lines, written during the match; - for stdout")
                 ->type_name("FILE"),
             {OutputKind::kJsonLines, Dash::kStdout});
}

CLI::App* addMatch(CLI::App& app, MatchCommand& options) {
  CLI::App* command = app.add_subcommand("match", "play a match, or a series of swapped pairs");
  command->footer(
      "Examples:\n"
      "  fulbito match                                  libero against classic, two halves of five minutes\n"
      "  fulbito match libero chaser --seed 7 --record game.fbr\n"
      "  fulbito match classic:navigator=bezier classic:navigator=limit-cycle -n 20   20 pairs, 2 matches "
      "each\n"
      "  fulbito match libero classic --rules vsss-5v5 --half-seconds 60 --json > result.json\n"
      "  fulbito match libero idle --start corner.toml --events -\n"
      "  fulbito match libero classic --view --record game.fbr   watch it, drag the ball and robots\n"
      "  fulbito match libero wire:yellow --robot firasim   against a client of the league: docs/league.md\n"
      "Names: fulbito list teams, fulbito list rules. More: docs/matches.md.");
  command
      ->add_option("blue", options.settings.blue,
                   "team that defends the left goal, e.g. classic:navigator=bezier")
      ->capture_default_str();
  command->add_option("yellow", options.settings.yellow, "team that defends the right goal")
      ->capture_default_str();
  addMatchSettings(*command, options.settings);
  addMatchOutputs(*command, options);
  addSeries(*command, options);
  command->add_flag("--force", options.force, "replace existing files");
  CLI::Option* view = command->add_flag("--view", options.view, "show the match in a window");
  addViewOptions(*command, options.window, view);
  command->add_flag("--profile", options.profile, "print the wall time of each stage");
  command->add_flag("--json", options.json, "print JSON");
  return command;
}

int match(const MatchCommand& options) {
  if (auto checked = checkFlags(options); !checked) return report(checked.error());
  if (options.pairs) return playPairs(options);
  const auto config = configOf(options.settings);
  if (!config) return report(config.error());
  if (const auto foreign = findForeignPlaces(config->rules, config->field, config->robot.robot)) {
    note("note: {}\n", *foreign);
  }
  return playOne(options, *config);
}

}  // namespace fulbito::app
