#include <algorithm>
#include <exception>
#include <new>
#include <span>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "apps/common/commands.hpp"
#include "apps/common/console.hpp"
#include "apps/common/library_ends.hpp"
#include "apps/common/option_values.hpp"
#include "apps/common/outputs.hpp"
#include "apps/common/sensor_options.hpp"
#include "apps/common/stack.hpp"
#include "apps/match/client.hpp"
#include "apps/match/drill.hpp"
#include "apps/match/match.hpp"
#include "apps/match/record.hpp"
#include "apps/match/rules.hpp"
#include "apps/match/serve.hpp"
#include "apps/match/view.hpp"
#include "apps/navigation/experiment.hpp"
#include "apps/replay/replay.hpp"
#include "apps/teams/check_team.hpp"
#include "apps/teams/new_team.hpp"
#include "apps/tournament/sprt.hpp"
#include "apps/tournament/tournament.hpp"
#include "apps/tournament/tune.hpp"
#include "engine/core/base/float_mode.hpp"
#include "engine/core/config/suggest.hpp"
#include "engine/core/system/machine_room.hpp"
#include "fulbito/detail/build_info.hpp"

namespace fulbito::app {
namespace {

constexpr std::uint64_t kMostTrials = 1'000'000;

/// The options of all commands.
struct Options {
  RunOptions run;
  std::string run_png;
  CompareOptions compare;
  std::uint64_t only = 0;
  ListOptions list;
  ShowOptions show;
  BenchCommand bench;
  CheckTeamCommand check_team;
  ClientCommand client;
  DrillCommand drill;
  ExperimentCommand experiment;
  MatchCommand match;
  NewTeamCommand new_team;
  RecordCommand record;
  ReplayCommands replay;
  RulesOptions rules;
  ServeCommand serve;
  SprtCommand sprt;
  TournamentCommand tournament;
  TuneCommand tune;
  ViewCommand view;
  bool version_json = false;
};

CLI::App* addRun(CLI::App& app, Options& options) {
  RunOptions& run = options.run;
  CLI::App* command =
      app.add_subcommand("run", "drive one robot through a navigation trial and print its score");
  command->footer(
      "Examples:\n"
      "  fulbito run --navigator bezier --layout corner:17 --png way.png\n"
      "  fulbito run --navigator limit-cycle:mu=3 --layout fig7-close-obstacle --speed 0.6\n"
      "  fulbito run --layout my-layout.toml --trace trace.csv --json\n"
      "  fulbito run --layout corner:17 --record way.fbr       then: fulbito replay verify way.fbr\n"
      "Names: fulbito list navigators, fulbito list suites, fulbito list cases.");
  command->add_option("--navigator", run.navigator, "navigation method, e.g. bezier:clearance=0.03")
      ->capture_default_str();
  command->add_option("--layout", run.layout, "TOML file, named case or SUITE:NUMBER")->capture_default_str();
  command->add_option("--speed", run.speed, "top speed of the wheels over the ground [m/s], 0.05 ... 10")
      ->capture_default_str();
  addModels(*command, run.robot, run.physics);
  addSeed(*command, run.seed, "layout, sensor noise");
  addSensors(*command, run.sensors);
  markOutput(
      command
          ->add_option("--png", options.run_png, "write a PNG picture (without FILE: named after the layout)")
          ->expected(0, 1)
          ->type_name("[FILE]"),
      {OutputKind::kPng});
  CLI::Option* record = command->add_option("--record", run.record, "write a recording")->type_name("FILE");
  markOutput(record, {OutputKind::kRecording});
  command
      ->add_flag("--drawings", run.drawings,
                 "with --record: also record the planned path or field, 10 times per second")
      ->needs(record);
  markOutput(command->add_option("--trace", run.trace, "write CSV, one line per control tick; - for stdout")
                 ->type_name("FILE"),
             {OutputKind::kCsv, Dash::kStdout});
  command->add_flag("--force", run.force, "replace existing files");
  command->add_flag("--json", run.json, "print the score as JSON");
  return command;
}

/// Adds `--map` and its options. Options that `--map` would ignore exclude it.
void addMap(CLI::App& command, CompareOptions& compare) {
  MapConfig& config = compare.map;
  CLI::Option* map = command.add_flag(
      "--map", compare.mapped, "compare the Bezier method with vector-field rings of many sizes instead");
  for (const char* other : {"--navigators", "--only", "--pictures", "--ways", "--record", "--tune",
                            "--tune-evaluations", "--html"}) {
    map->excludes(command.get_option(other));
  }
  command.add_option("--radii", config.radii, "with --map: radii of the rings [m]")
      ->delimiter(',')
      ->needs(map);
  command.add_option("--widths", config.widths, "with --map: widths of the rings [m]")
      ->delimiter(',')
      ->needs(map);
  command.add_option("--laws", config.laws, "with --map: follower laws: preview, classic (default: both)")
      ->delimiter(',')
      ->needs(map);
  command
      .add_option("--headings", config.headings,
                  "with --map: start headings: goal, random, away (default: all)")
      ->delimiter(',')
      ->needs(map);
  command.add_option("--seeds", config.seeds, "with --map: number of layout seeds, counted up from --seed")
      ->needs(map)
      ->capture_default_str();
  command
      .add_option("--fresh", config.fresh,
                  "layouts of each of three other seeds, for the nearest cells; 0: none")
      ->needs(map)
      ->capture_default_str();
}

void addPictures(CLI::App& command, ComparisonConfig& config) {
  command.add_option("--pictures", config.pictures, "layouts to draw per suite and speed")
      ->capture_default_str();
  command
      .add_option("--ways", config.ways,
                  "ways per picture: the methods of Jung & Lee, then the best of the suite; 0: all")
      ->capture_default_str();
}

void addTuning(CLI::App& command, CompareOptions& compare) {
  CLI::Option* tune =
      command.add_option("--tune", compare.tune, "first tune this method on separate training layouts")
          ->type_name("NAVIGATOR");
  command
      .add_option("--tune-evaluations", compare.tune_evaluations,
                  "with --tune: number of parameter sets to try")
      ->needs(tune)
      ->capture_default_str();
}

void addCompareOutputs(CLI::App& command, CompareOptions& compare) {
  CLI::Option* recordings = command
                                .add_option("--record", compare.config.record,
                                            "write recordings of the drawn layouts to this folder")
                                ->type_name("FOLDER");
  markFolder(recordings, compare.config.record, FolderUse::kProducts);
  CLI::Option* out =
      command.add_option("--out", compare.out, "folder for results.json, trials.csv and the pictures")
          ->capture_default_str();
  markFolder(out, compare.out, FolderUse::kProducts);
  markOutput(command
                 .add_option("--html", compare.html,
                             "write an HTML page in which the methods race on the drawn layouts")
                 ->type_name("FILE"),
             {OutputKind::kPage});
  addForce(command, "replace existing files, of other kinds too");
}

CLI::App* addCompare(CLI::App& app, Options& options) {
  CompareOptions& compare = options.compare;
  ComparisonConfig& config = compare.config;
  CLI::App* command = app.add_subcommand("compare", "compare navigation methods on suites of seeded layouts");
  command->footer(
      "Examples:\n"
      "  fulbito compare                                        the comparison of Jung & Lee (2015)\n"
      "  fulbito compare --suite corner --navigators bezier bspline-time --speeds 1.0 2.6 --out out\n"
      "  fulbito compare --suite moving --trials 300 --json > moving.json\n"
      "  fulbito compare --suite corner --only 17 --out one     one layout, with its picture\n"
      "  fulbito compare --suite moving --trials 8 --html races.html   an HTML page that shows the races\n"
      "  fulbito compare --tune tangent-field --speeds 1.0      tune a method, then compare it\n"
      "  fulbito compare --map                                  search for the paper's ring settings\n"
      "  fulbito compare --map --laws classic --speeds 1.0 --trials 100 --out map\n"
      "The exit code is 0 even if a result is outside its expected band.\n"
      "Names: fulbito list suites, fulbito list navigators.");
  command->add_option("--suite", config.suite, "suite of layouts")->capture_default_str();
  command->add_option("--navigators", config.navigators,
                      "methods, e.g. bezier limit-cycle:mu=3 (default: the suite's)");
  command->add_option("--speeds", config.speeds, "top speeds [m/s] (default: the suite's)")->delimiter(',');
  wholeNumber(
      command->add_option("--trials", config.trials, "layouts per suite and speed (default: the suite's)"), 1,
      kMostTrials);
  addSeed(*command, config.seed, "layouts, sensor noise");
  addJobs(*command, config.jobs, "worker threads");
  wholeNumber(command->add_option("--only", options.only, "run only this layout of the suite"))
      ->type_name("NUMBER");
  addPictures(*command, config);
  addModels(*command, config.robot, config.physics);
  addSensors(*command, config.sensors);
  addTuning(*command, compare);
  addCompareOutputs(*command, compare);
  addMap(*command, compare);
  command->add_flag("--json", compare.json, "print the results as JSON instead of tables");
  return command;
}

void addRest(CLI::App& app, Options& options) {
  CLI::App* list = app.add_subcommand("list", "list the available teams, navigators, suites, presets ...");
  list->footer("Examples:\n  fulbito list teams\n  fulbito list navigators\n  fulbito list suites --json");
  list->add_option("kind", options.list.kind,
                   "teams, navigators, suites, cases, robots, physics, fields or rules")
      ->required();
  list->add_flag("--json", options.list.json, "print JSON");

  CLI::App* show = app.add_subcommand("show", "print a preset as a TOML file");
  show->footer(
      "Examples:\n  fulbito show robot vsss > my-robot.toml\n  fulbito show case fig1-abrupt-turns > "
      "layout.toml");
  show->add_option("kind", options.show.kind, "robot, physics, field, rules or case")->required();
  show->add_option("name", options.show.name, "name of the preset (fulbito list)")->required();

  CLI::App* bench = app.add_subcommand("bench", "measure the engine's speed against a bare Box2D loop");
  bench->footer(
      "Examples:\n  fulbito bench\n  fulbito bench --signature\n  fulbito bench --json > bench.json");
  bench
      ->add_option("--repetitions", options.bench.repetitions,
                   "repetitions per row (median is printed), 1 ... 1000")
      ->capture_default_str();
  bench->add_option("--episodes", options.bench.episodes, "10-second episodes per repetition, 1 ... 100000")
      ->capture_default_str();
  bench->add_flag("--signature", options.bench.signature_only,
                  "print only the signature (hash) of the fixed scenes");
  bench->add_flag("--json", options.bench.json, "print JSON");

  CLI::App* version = app.add_subcommand("version", "print version and build settings");
  version->footer("Example:\n  fulbito version --json");
  version->add_flag("--json", options.version_json, "print JSON");
}

void addLeague(CLI::App& app, Options& options) {
  addServe(app, options.serve);
  addClient(app, options.client);
  addRecord(app, options.record);
}

std::vector<std::string> commandNames(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
  return names;
}

/// An error for an unknown command or subcommand. CLI11 would only report that one is missing.
std::optional<Error> wrongCommand(const CLI::App& app, std::span<char*> words) {
  const std::vector<std::string> names = commandNames(app);
  if (words.empty() || words.front()[0] == '-' || names.empty()) return std::nullopt;
  if (std::find(names.begin(), names.end(), words.front()) != names.end()) {
    return wrongCommand(*app.get_subcommand(words.front()), words.subspan(1));
  }
  const bool part = app.get_parent() != nullptr;
  const std::string whole = part ? "fulbito " + app.get_name() : "fulbito";
  return Error{
      ErrorCode::kUsage,
      fmt::format("{}there is no {} '{}'.{} See {} --help.", part ? app.get_name() + ": " : "",
                  part ? "subcommand" : "command", words.front(), suggestion(words.front(), names), whole)};
}

/// Advice for an unknown option.
std::string remedyFor(const std::string& word, const std::vector<std::string>& flags) {
  const bool takes_rules = std::find(flags.begin(), flags.end(), "--rules") != flags.end();
  if (word == "--field" && takes_rules) {
    return " The field belongs to the rules: set rules.field in a profile (fulbito rules show vsss-5v5 > "
           "mine.toml) "
           "and pass it with --rules.";
  }
  return suggestion(word, flags);
}

/// CLI11's message; for an unknown option, a message with a suggestion.
Error parseError(const CLI::App& app, const CLI::ParseError& error, std::span<char*> words) {
  const CLI::App* last = &app;
  std::string name;
  for (auto used = app.get_subcommands(); !used.empty(); used = last->get_subcommands()) {
    last = used.front();
    name += (name.empty() ? "" : " ") + last->get_name();
  }
  const CLI::App& command = *last;
  std::string message = error.what();
  if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::ExtrasError)) {
    std::vector<std::string> flags;
    for (const CLI::Option* option : command.get_options({})) flags.push_back(option->get_name());
    for (const std::string word : words) {
      const bool known =
          std::any_of(flags.begin(), flags.end(), [&](const std::string& f) { return word == f; });
      if (word.starts_with("--") && !known && word.find('=') == std::string::npos) {
        message = fmt::format("there is no option '{}'.{}", word, remedyFor(word, flags));
      }
    }
  }
  if (!message.ends_with('.') && !message.ends_with('?')) message += '.';
  return {ErrorCode::kUsage, fmt::format("{}{}{} See fulbito {}{}--help.", name, name.empty() ? "" : ": ",
                                         message, name, name.empty() ? "" : " ")};
}

/// The command or subcommand that was given.
const CLI::App& commandOf(const CLI::App& app) {
  const auto named = app.get_subcommands();
  return named.empty() ? app : commandOf(*named.front());
}

int dispatch(const CLI::App& app, const CLI::App& run_command, const CLI::App& compare_command,
             Options& options) {
  const std::string name = app.get_subcommands().front()->get_name();
  if (name == "run") {
    if (run_command.count("--png") > 0) options.run.png = options.run_png;
    return run(options.run);
  }
  if (name == "compare") {
    if (compare_command.count("--only") > 0) options.compare.config.only = options.only;
    return compare(options.compare);
  }
  if (name == "match") return match(options.match);
  if (name == "replay") return replay(options.replay);
  if (name == "view") return view(options.view);
  if (name == "list") return list(options.list);
  if (name == "show") return show(options.show);
  if (name == "bench") return bench(options.bench);
  if (name == "experiment") return experiment(options.experiment);
  if (name == "drill") return drill(options.drill);
  if (name == "check-team") return checkTeam(options.check_team);
  if (name == "new-team") return newTeam(options.new_team);
  if (name == "rules") return rules(options.rules);
  if (name == "serve") return serve(options.serve);
  if (name == "client") return client(options.client);
  if (name == "record") return record(options.record);
  if (name == "sprt") return sprt(options.sprt);
  if (name == "tournament") return tournament(app, options.tournament);
  if (name == "tune") return tune(options.tune);
  return version(options.version_json);
}

int mainWithoutCatch(int argc, char** argv) {
  CLI::App app(
      "Fulbito: a deterministic 2D robot-soccer simulator. It plays matches and\ncompares navigation "
      "methods.",
      "fulbito");
  app.footer(
      "Examples:\n"
      "  fulbito match libero classic --seed 7                  play a match and print its summary\n"
      "  fulbito compare                                        the comparison of Jung & Lee (2015)\n"
      "  fulbito run --navigator bezier --layout corner:17 --png way.png\n"
      "  fulbito list teams\n"
      "Exit codes: 0 success, 1 a check failed, 2 wrong usage, 3 bad input file, 4 a team failed "
      "(--strict),\n"
      "5 cannot read or write, 6 no verdict or not all played, 7 a recording or match differs, 70 internal "
      "error,\n"
      "129, 130, 143 ended by a signal.");
  app.set_version_flag("--version", buildInfo().version);
  app.require_subcommand(1);
  app.get_formatter()->column_width(36);
  Options options;
  addMatch(app, options.match);
  addLeague(app, options);
  addReplay(app, options.replay);
  addView(app, options.view);
  const CLI::App* run_command = addRun(app, options);
  const CLI::App* compare_command = addCompare(app, options);
  addExperiment(app, options.experiment);
  addRest(app, options);
  addDrill(app, options.drill);
  addNewTeam(app, options.new_team);
  addCheckTeam(app, options.check_team);
  addRules(app, options.rules);
  addSprt(app, options.sprt);
  addTournament(app, options.tournament);
  addTune(app, options.tune);
  readNumbers(app);
  const std::span<char*> words{argv + 1, argv + std::max(argc, 1)};
  if (const auto error = emptyWord(words)) return report(*error);
  if (const auto error = wrongCommand(app, words)) return report(*error);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& help) {  // thrown for --help and --version
    return app.exit(help);
  } catch (const CLI::ParseError& error) {
    return report(parseError(app, error, words));
  }
  if (auto checked = checkOutputs(commandOf(app)); !checked) return report(checked.error());
  return dispatch(app, *run_command, *compare_command, options);
}

/// Runs the program. A lack of memory or other resources is not reported as an internal error.
int codeOf(int argc, char** argv) {
  try {
    return mainWithoutCatch(argc, argv);
  } catch (const std::exception&) {
    Error error = machineError();
    error.message += "; try fewer --jobs or a smaller --size";
    return report(error);
  }
}

int codeOrBug(int argc, char** argv) {
  try {
    return codeOf(argc, argv);
  } catch (const std::exception& error) {
    note("fulbito: internal error: {}\n", error.what());
    return kInternal;
  }
}

}  // namespace
}  // namespace fulbito::app

int main(int argc, char** argv) {
  const fulbito::FloatMode floats;
  fulbito::app::openStandardDescriptors();
  fulbito::app::catchSignals();
  fulbito::app::watchLibraries();
  const int code = fulbito::app::finishOutput(
      fulbito::app::withAmpleStack([&] { return fulbito::app::codeOrBug(argc, argv); }));
  fulbito::app::endOfMain(code);
  return code;
}
