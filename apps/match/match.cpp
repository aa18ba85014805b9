#include "apps/match/match.hpp"

#include <charconv>
#include <limits>
#include <optional>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "apps/common/commands.hpp"
#include "apps/common/console.hpp"
#include "apps/common/option_values.hpp"
#include "apps/common/output_names.hpp"
#include "apps/common/progress.hpp"
#include "apps/match/live_line.hpp"
#include "apps/match/team_flags.hpp"
#include "engine/core/system/output_file.hpp"
#include "fulbito/match.hpp"
#include "fulbito/recorder.hpp"
#include "fulbito/statistics.hpp"
#include "referee/restarts/check_places.hpp"

namespace fulbito::app {
namespace {

constexpr Tick kTicksBetweenChecks = 64;  // match ticks between looks at the clock and for signals
constexpr std::uint64_t kMostPairs = 100'000;
constexpr std::uint64_t kManyTicks = 1'000'000;  // the match itself checks the range of --latency
constexpr const char* kStdout = "-";
constexpr const char* kUnlimited = "unlimited";

double secondsSince(std::int64_t begin) { return static_cast<double>(now() - begin) * 1e-9; }

/// A file, or stdout, that writes each line at once and keeps the first failure.
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
  /// Ends the file. Errors: the first failed write.
  Result<void> finish() { return file_ ? file_->commit() : Result<void>(); }

 private:
  explicit LineFile(std::optional<OutputFile> file) : file_(std::move(file)) {}
  std::optional<OutputFile> file_;  ///< none: stdout; `finishOutput` reports its failures
};

Result<void> checkFiles(const MatchCommand& options) {
  return mayWriteAll({{"--record", options.record},
                      {"--events", options.events, Dash::kStdout},
                      {"--screenshot", options.window.screenshot}},
                     {{"--rules", options.rules},
                      {"--robot", options.robot},
                      {"--physics", options.physics},
                      {"--start", options.start}},
                     options.force);
}

/// Checks flags that apply to a single match only.
Result<void> checkFlags(const MatchCommand& options) {
  if (options.json && options.events == kStdout) {
    return fail(ErrorCode::kUsage, "--events - and --json both write to stdout; give --events a file");
  }
  if (!options.pairs) return {};
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

Result<void> addStart(const std::string& file, MatchConfig& config) {
  if (file.empty()) return {};
  auto start = loadStartState(file, config);
  if (!start) return tl::unexpected<Error>(start.error());
  config.start = start->placement;
  config.scoreboard = start->scoreboard;
  return {};
}

Result<void> shorten(const MatchCommand& options, Rules& rules) {
  if (!options.half_seconds) return {};
  rules.half_seconds = *options.half_seconds;
  const auto checked = validate(rules);
  if (!checked) return fail(ErrorCode::kUsage, "--half-seconds: " + checked.error().message);
  return {};
}

/// Takes the values of a flag: one value for both teams, or those of blue and yellow.
template <typename T>
Result<void> readPerTeam(const char* flag, const std::vector<T>& values, PerTeam<VisionModel>& vision,
                         T VisionModel::* part) {
  if (values.size() > 2) return fail(ErrorCode::kUsage, fmt::format("{}: takes one or two values", flag));
  for (const TeamId team : kTeams) {
    const bool own = values.size() == 2 && team == TeamId::kYellow;
    vision[indexOf(team)].*part = own ? values.back() : values.front();
  }
  return {};
}

Result<PerTeam<VisionModel>> visionOf(const MatchCommand& options, const RobotModel& robot) {
  PerTeam<VisionModel> vision;
  for (const auto& done :
       {readPerTeam("--latency", options.latency_ticks, vision, &VisionModel::latency_ticks),
        readPerTeam("--noise", options.position_noise, vision, &VisionModel::position_noise),
        readPerTeam("--dropout", options.dropout, vision, &VisionModel::dropout)}) {
    if (!done) return tl::unexpected<Error>(done.error());
  }
  // As in trials: the heading noise that follows from the position noise.
  for (VisionModel& seat : vision) seat.heading_noise = headingNoise(seat.position_noise, robot.length);
  return vision;
}

/// The limit of both teams: that of the rules with another time per decision.
Result<DecisionTime> limitOf(const std::string& text, const Rules& rules) {
  DecisionTime limit = rules.decision_time;
  if (text == kUnlimited) {
    limit.decision = std::numeric_limits<double>::infinity();
    return limit;
  }
  double milliseconds = 0.0;
  const auto parsed = std::from_chars(text.data(), text.data() + text.size(), milliseconds);
  if (parsed.ec != std::errc() || parsed.ptr != text.data() + text.size()) {
    return fail(ErrorCode::kUsage,
                fmt::format("--time: '{}' is neither a number of ms nor '{}'", text, kUnlimited));
  }
  limit.decision = milliseconds * 1e-3;
  return limit;
}

Result<MatchConfig> configOf(const MatchCommand& options) {
  const TeamCatalogue catalogue = catalogueOf(options.outside);
  auto blue = catalogue.parse(options.blue), yellow = catalogue.parse(options.yellow);
  if (!blue) return tl::unexpected<Error>(blue.error());
  if (!yellow) return tl::unexpected<Error>(yellow.error());
  auto rules = loadRules(options.rules);
  if (!rules) return tl::unexpected<Error>(rules.error());
  auto field = loadField(rules->field);
  if (!field) return tl::unexpected<Error>(field.error());
  auto robot = loadRobot(options.robot);
  if (!robot) return tl::unexpected<Error>(robot.error());
  auto physics = loadPhysics(options.physics);
  if (!physics) return tl::unexpected<Error>(physics.error());
  MatchConfig config;
  config.teams = {std::move(*blue), std::move(*yellow)};
  config.rules = std::move(*rules);
  if (auto shortened = shorten(options, config.rules); !shortened) {
    return tl::unexpected<Error>(shortened.error());
  }
  config.field = std::move(*field);
  config.robot = std::move(*robot);
  config.physics = std::move(*physics);
  auto vision = visionOf(options, config.robot.robot);
  if (!vision) return tl::unexpected<Error>(vision.error());
  config.vision = *vision;
  if (!options.time.empty()) {
    auto limit = limitOf(options.time, config.rules);
    if (!limit) return tl::unexpected<Error>(limit.error());
    config.decision_time = *limit;
  }
  config.seed = options.seed;
  if (auto started = addStart(options.start, config); !started) return tl::unexpected<Error>(started.error());
  return config;
}

/// Everything that observes the match for the user.
struct Watchers {
  StatisticsObserver statistics;
  EventLog log;
  std::optional<LineFile> file;
  std::optional<EventLines> lines;
  std::optional<MatchRecorder> recorder;

  Result<void> attach(const MatchCommand& options, Match& match);
  /// Ends all files. Errors: the first failed write.
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

/// Plays until the end or a signal.
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

/// Closing the window early is not a failure.
int exitCode(const MatchReport& report, bool closed) {
  if (report.faults.abandoned) {
    return app::report(
        {ErrorCode::kBadInput, "the match was abandoned: " + report.faults.abandoned->message});
  }
  return report.complete || (closed && !interrupted()) ? kOk : interruptedCode();
}

/// Says which layers a team's containment lacks.
void noteContainment(const MatchConfig& config) {
  for (const TeamChoice& team : config.teams) {
    for (const Setting& entry : team.origin) {
      if (entry.name == "containment_missing") note("note: {} runs without {}\n", team.text, entry.value);
    }
  }
}

int playOne(const MatchCommand& options, const MatchConfig& config) {
  // Opens before any output file, so that a failure leaves no file.
  auto window = windowOf(options);
  if (!window) return report(window.error());
  auto made = Match::create(config, now);
  if (!made) return report(made.error());
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
  print(options, summary);
  if (auto written = watchers.finish(); !written) return report(written.error());
  if (!options.record.empty()) note("recording: {}\n", options.record);
  if (!played) return report(played.error());
  return exitCode(summary, options.view);
}

int playPairs(const MatchCommand& options, const MatchConfig& config) {
  SeriesReport summary{{config, *options.pairs, options.jobs, now}, {}, 0.0};
  const std::int64_t begin = now();
  {
    ProgressBar bar(fmt::format("{} v {}", options.blue, options.yellow));
    auto played = playSeries(summary.config,
                             [&](std::size_t done, std::size_t total) { return bar.update(done, total); });
    if (!played) return report(played.error());
    summary.result = std::move(*played);
  }
  summary.wall = secondsSince(begin);
  if (options.json) {
    writeOut(seriesJson(summary));
  } else {
    printOut(seriesText(summary));
  }
  return summary.result.interrupted ? interruptedCode() : kOk;
}

void addConditions(CLI::App& command, MatchCommand& options) {
  command.add_option("--rules", options.rules, "rules profile or TOML file")->capture_default_str();
  command.add_option("--physics", options.physics, "physics profile or TOML file")->capture_default_str();
  command.add_option("--robot", options.robot, "robot preset or TOML file, for both teams")
      ->capture_default_str();
  wholeNumber(command.add_option("--seed", options.seed,
                                 "random seed (coin tosses, placement error, sensor noise, teams)"))
      ->capture_default_str();
  command.add_option("--half-seconds", options.half_seconds,
                     "length of a half [s] (default: from the rules)");
  command.add_option("--start", options.start, "start state (TOML file) instead of the first kick-off")
      ->type_name("FILE");
  const auto per_team = [](CLI::Option* option) {
    // Only the delimiter makes a list: a word after a space is a team.
    option->delimiter(',')->allow_extra_args(false)->type_name("N[,N]");
  };
  per_team(wholeNumber(
      command.add_option("--latency", options.latency_ticks,
                         "age of observations in ticks, 0 ... 60: for both teams, or BLUE,YELLOW"),
      0, kManyTicks));
  per_team(number(command.add_option("--noise", options.position_noise,
                                     "standard deviation of observed positions [m], 0 ... 0.1")));
  per_team(number(command.add_option("--dropout", options.dropout,
                                     "probability per tick that a body is not seen, 0 ... 0.99")));
  command
      .add_option("--time", options.time,
                  "wall time per decision, or 'unlimited' (default: the rules limit programs only)")
      ->type_name("MS");
}

}  // namespace

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
      "Names: fulbito list teams, fulbito list rules. More: docs/matches.md.");
  command->add_option("blue", options.blue, "team that defends the left goal, e.g. classic:navigator=bezier")
      ->capture_default_str();
  command->add_option("yellow", options.yellow, "team that defends the right goal")->capture_default_str();
  addConditions(*command, options);
  addTeamFlags(*command, options.outside);
  CLI::Option* record =
      command->add_option("--record", options.record, "write a recording")->type_name("FILE");
  CLI::Option* recipe =
      command
          ->add_flag("--recipe", options.record_recipe,
                     "with --record: omit sampled states (recomputed when read); about a third smaller")
          ->needs(record);
  command
      ->add_flag("--drawings", options.drawings,
                 "with --record: also record the teams' drawings, 10 times per second, for pictures")
      ->needs(record)
      ->excludes(recipe);
  command
      ->add_option("--events", options.events, "events as JSON lines, written during the match; - for stdout")
      ->type_name("FILE");
  wholeNumber(
      command->add_option("-n,--pairs", options.pairs, "swapped pairs of a series (teams change colours)"), 1,
      kMostPairs)
      ->type_name("PAIRS");
  addJobs(*command, options.jobs, "worker threads for a series");
  command->add_flag("--force", options.force, "replace existing files");
  CLI::Option* view = command->add_flag("--view", options.view, "show the match in a window");
  addViewOptions(*command, options.window, view);
  command->add_flag("--profile", options.profile, "print the wall time of each stage");
  command->add_flag("--json", options.json, "print JSON");
  return command;
}

int match(const MatchCommand& options) {
  if (auto checked = checkFlags(options); !checked) return report(checked.error());
  if (auto checked = checkFiles(options); !checked) return report(checked.error());
  const auto config = configOf(options);
  if (!config) return report(config.error());
  if (const auto foreign = findForeignPlaces(config->rules, config->field, config->robot.robot)) {
    note("note: {}\n", *foreign);
  }
  return options.pairs ? playPairs(options, *config) : playOne(options, *config);
}

}  // namespace fulbito::app
