#include "apps/navigation/experiment.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "apps/common/commands.hpp"
#include "apps/common/console.hpp"
#include "apps/common/option_values.hpp"
#include "apps/common/outputs.hpp"
#include "apps/common/progress.hpp"
#include "apps/navigation/experiment_files.hpp"
#include "experiments/papers/paper_experiments.hpp"
#include "fulbito/report.hpp"

namespace fulbito::app {
namespace {

void listExperiments() {
  for (const PaperExperiment& experiment : paperExperiments()) {
    say("{:<14} {}\n{:<14} {}\n", experiment.name, experiment.summary, "", experiment.paper);
    for (const ExperimentSetting& setting : experiment.settings) {
      say("{:<14}   --set {}={}: {}\n", "", setting.name, setting.initial, setting.doc);
    }
  }
}

/// A setting from a text "name=value".
Result<Setting> settingOf(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0) {
    return fail(ErrorCode::kUsage, fmt::format("--set '{}': want NAME=VALUE", text));
  }
  return Setting{text.substr(0, equals), text.substr(equals + 1)};
}

Result<ExperimentRequest> requestOf(const ExperimentCommand& command) {
  ExperimentRequest request;
  request.seed = command.seed;
  request.jobs = command.jobs;
  for (const std::string& text : command.settings) {
    auto setting = settingOf(text);
    if (!setting) return tl::unexpected<Error>(setting.error());
    request.settings.push_back(*setting);
  }
  return request;
}

/// Runs an experiment and writes its files. Returns its report as JSON; prints tables unless --json is given.
Result<std::string> runOne(const ExperimentCommand& command, const PaperExperiment& experiment,
                           ExperimentRequest request) {
  const std::string folder = command.out + "/" + experiment.name;
  const Products products{{"results.json", kObjectBeginning},
                          {experiment.name + std::string(".html"), beginningOf(OutputKind::kPage)}};
  if (auto made = prepareProducts(folder, products); !made) return tl::unexpected<Error>(made.error());
  ProgressBar bar(experiment.name);
  request.progress = [&](std::size_t done, std::size_t total) { return bar.update(done, total); };
  const auto report = runPaperExperiment(experiment, request);
  if (!report) return tl::unexpected<Error>(report.error());
  const auto files = writeExperiment(*report, request, folder);
  if (!command.json) printOut(experimentText(*report));
  flushOut();
  if (!files) return tl::unexpected<Error>(files.error());
  note("\n{} files are in {}: {}\n", files->size(), folder, fmt::join(*files, ", "));
  return experimentJson(*report, request);
}

/// One JSON object, also for several experiments.
std::string jsonOf(const ExperimentCommand& command, const std::vector<std::string>& reports) {
  if (command.name != "all") return reports.front();
  return fmt::format("{{\"schema_version\": 1, \"experiments\": [\n{}]}}\n", fmt::join(reports, ","));
}

Result<std::vector<const PaperExperiment*>> chosen(const std::string& name) {
  std::vector<const PaperExperiment*> experiments;
  if (name == "all") {
    for (const PaperExperiment& experiment : paperExperiments()) experiments.push_back(&experiment);
    return experiments;
  }
  const auto found = findPaperExperiment(paperExperiments(), name);
  if (!found) return tl::unexpected<Error>(found.error());
  return std::vector{*found};
}

Result<void> runChosen(const ExperimentCommand& command) {
  if (command.name == "all" && !command.settings.empty()) {
    return fail(ErrorCode::kUsage,
                "--set: settings belong to one experiment; they cannot be used with 'all'");
  }
  const auto request = requestOf(command);
  if (!request) return tl::unexpected<Error>(request.error());
  const auto experiments = chosen(command.name);
  if (!experiments) return tl::unexpected<Error>(experiments.error());
  std::vector<std::string> reports;
  for (const PaperExperiment* experiment : *experiments) {
    auto ran = runOne(command, *experiment, *request);
    if (!ran) return tl::unexpected<Error>(ran.error());
    reports.push_back(std::move(*ran));
  }
  if (command.json) writeOut(jsonOf(command, reports));
  return {};
}

}  // namespace

int experiment(const ExperimentCommand& command) {
  if (command.name == "list") {
    listExperiments();
    return kOk;
  }
  if (auto ran = runChosen(command); !ran) return report(ran.error());
  return kOk;
}

void addExperiment(CLI::App& app, ExperimentCommand& command) {
  if (paperExperiments().empty()) return;
  CLI::App* sub = app.add_subcommand("experiment", "reproduce the experiments of papers");
  sub->footer(
      "Examples:\n"
      "  fulbito experiment list                     names, papers and settings\n"
      "  fulbito experiment capture --out figures    tables, charts, pictures, an HTML page\n"
      "  fulbito experiment transport --set step=0.1 --json > transport.json\n"
      "  fulbito experiment all --seed 7\n"
      "The exit code is 0 even if a figure is outside its band. docs/papers.md explains the figures.");
  sub->add_option("name", command.name, "experiment, 'list' or 'all'")->required();
  addSeed(*sub, command.seed, "");
  addJobs(*sub, command.jobs, "worker threads");
  sub->add_option("--set", command.settings, "set a setting of the experiment; may be repeated")
      ->type_name("NAME=VALUE")
      ->expected(1)
      ->take_all();
  CLI::Option* out =
      sub->add_option("--out", command.out, "folder; each experiment writes to a folder of its own in it")
          ->capture_default_str();
  markFolder(out, command.out, FolderUse::kProducts);
  addForce(*sub, "replace existing files of other kinds");
  sub->add_flag("--json", command.json, "print JSON instead of tables");
}

}  // namespace fulbito::app
