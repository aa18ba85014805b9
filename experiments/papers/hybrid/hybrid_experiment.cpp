#include "experiments/papers/hybrid/hybrid_figures.hpp"
#include "experiments/papers/hybrid/hybrid_scenes.hpp"
#include "fulbito/report.hpp"

namespace fulbito::hybrid {
namespace {

std::vector<Parameter<HybridSettings>> parameters() {
  using S = HybridSettings;
  return {
      integer("rows", &S::rows, 1, 100000, "layouts like Fig. 8"),
      integer("gaps", &S::gaps, 2, 100000, "layouts with a gap of 1.3 widths, half as many of 1.1 and 1.6"),
      integer("kinds", &S::kinds, 1, 100000,
              "layouts of each kind of gap, by three navigators at two noises"),
      number("speed", &S::speed, 0.05, 1.0, "m/s", "top speed")};
}

Result<ExperimentReport> run(const ExperimentRequest& request) {
  HybridSettings settings;
  if (auto set = applySettings(parameters(), request.settings, "hybrid", settings); !set)
    return tl::unexpected<Error>(set.error());
  const auto runs = runHybrid(settings, request);
  if (!runs) return tl::unexpected<Error>(runs.error());
  ExperimentReport report;
  report.name = "hybrid";
  report.title = "P.-G. Kim et al. (2006): nearness diagram, limit cycle and vector field with eight sonars";
  addResults(*runs, report);
  const std::uint64_t row = typicalRow(*runs);
  auto fig8 = hybridScene("fig-8", "Fig. 8: the gap, and the way round", anyRowLayout(request.seed, row),
                          settings.speed, request.seed, row, true);
  if (!fig8) return tl::unexpected<Error>(fig8.error());
  auto gap = hybridScene("gap", "A gap of 1.3 robot widths", gapLayout(request.seed, 0, 1.3), settings.speed,
                         request.seed, 0, false);
  if (!gap) return tl::unexpected<Error>(gap.error());
  report.scenes = {std::move(*fig8), std::move(*gap)};
  for (ReportScene& picture : hybridPictures()) report.scenes.push_back(std::move(picture));
  return report;
}

}  // namespace

PaperExperiment experiment() {
  return {"hybrid", "eight sonars: narrow gaps by the nearness diagram, Fig. 8, gap rates",
          "P.-G. Kim et al. 2006: A real-time obstacle avoidance of mobile robot using nearness diagram, "
          "limit-cycle and vector field method",
          settingsOf(specsOf(parameters())), run};
}

}  // namespace fulbito::hybrid
