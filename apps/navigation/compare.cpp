#include <fmt/format.h>

#include "apps/common/commands.hpp"
#include "apps/common/console.hpp"
#include "apps/common/outputs.hpp"
#include "apps/common/progress.hpp"
#include "apps/navigation/compare_map.hpp"
#include "engine/core/system/output_file.hpp"
#include "experiments/comparison/paper_plan.hpp"
#include "experiments/comparison/tuner.hpp"
#include "experiments/report/pictures.hpp"
#include "experiments/report/race_page.hpp"
#include "fulbito/experiment.hpp"

namespace fulbito::app {
namespace {

double secondsSince(std::int64_t begin) { return static_cast<double>(now() - begin) * 1e-9; }

/// Tunes the navigator at each speed, and adds the results to the navigators to compare.
Result<void> tuneFirst(const CompareOptions& options, ComparisonConfig& config) {
  if (config.suite == kPaperSuite) config.suite = "corner";
  const auto suite = findSuite(config.suite);
  if (!suite) return tl::unexpected<Error>(suite.error());
  if (config.navigators.empty()) config.navigators = {"bezier", options.tune};
  for (double speed : config.speeds.empty() ? (*suite)->speeds : config.speeds) {
    ProgressBar bar(fmt::format("tuning {} at {:.1f} m/s", options.tune, speed));
    const TuneConfig tuning{options.tune, speed, options.tune_evaluations};
    const auto result =
        tune(config, tuning, [&](std::size_t done, std::size_t total) { return bar.update(done, total); });
    if (!result) return tl::unexpected<Error>(result.error());
    note(
        "tuned for {:.1f} m/s: {} (mean T/T* on {} training layouts {:.3f}, with defaults {:.3f}, {} "
        "evaluations)\n",
        speed, result->navigator, result->layouts, result->objective, result->initial, result->evaluations);
    config.navigators.push_back(result->navigator);
  }
  return {};
}

Result<std::vector<std::string>> writeAll(const CompareOptions& options, const Comparison& comparison,
                                          const std::string& json) {
  if (auto written = writeFile(options.out + "/trials.csv", trialsCsv(comparison)); !written) {
    return tl::unexpected<Error>(written.error());
  }
  if (auto written = writeFile(options.out + "/results.json", json); !written) {
    return tl::unexpected<Error>(written.error());
  }
  return writePictures(comparison, options.out);
}

/// Writes the page of races if --html was given.
Result<void> writeRaces(const CompareOptions& options, const Comparison& comparison) {
  if (options.html.empty()) return {};
  const auto page = racePage(comparison);
  if (!page) return tl::unexpected<Error>(page.error());
  const auto html = htmlPage(*page);
  if (!html) return tl::unexpected<Error>(html.error());
  if (auto written = writeFile(options.html, *html); !written) return written;
  note("races: {}\n", options.html);
  return {};
}

}  // namespace

int compare(const CompareOptions& options) {
  if (options.mapped) return compareMap(options);
  const std::int64_t begin = now();
  ComparisonConfig config = options.config;
  // Checks all options before the work starts.
  if (auto planned = planComparison(config); !planned) return report(planned.error());
  const std::string_view png = beginningOf(OutputKind::kPng);
  const Products products{
      {"results.json", kObjectBeginning}, {"trials.csv", "suite,"}, {"time.png", png}, {"distance.png", png}};
  if (auto folder = prepareProducts(options.out, products); !folder) return report(folder.error());
  if (!config.record.empty()) {
    if (auto folder = prepareFolder(config.record); !folder) return report(folder.error());
  }
  if (!options.tune.empty()) {
    if (auto tuned = tuneFirst(options, config); !tuned) return report(tuned.error());
  }
  auto comparison = planComparison(config);
  if (!comparison) return report(comparison.error());
  {
    ProgressBar bar(config.suite);
    const auto progress = [&](std::size_t done, std::size_t total) { return bar.update(done, total); };
    if (auto ran = runComparison(*comparison, now, progress); !ran) return report(ran.error());
  }
  const std::string json = resultsJson(*comparison, secondsSince(begin));
  if (options.json) {
    writeOut(json);
  } else {
    printOut(markdownReport(*comparison));
  }
  flushOut();
  const auto pictures = writeAll(options, *comparison, json);
  if (!pictures) return report(pictures.error());
  if (auto written = writeRaces(options, *comparison); !written) return report(written.error());
  note("\n{} trials in {:.1f} s; results.json, trials.csv and {} pictures are in {}\n",
       comparison->records.size(), secondsSince(begin), pictures->size(), options.out);
  return kOk;
}

}  // namespace fulbito::app
