#include "tournament/gate/gate.hpp"

#include "tournament/plan/plan.hpp"

namespace fulbito {

Result<GateReport> runGate(const GateConfig& config, const SeriesProgress& progress) {
  if (auto checked = validate(config.bounds); !checked) return tl::unexpected<Error>(checked.error());
  GateReport report{config, {}, Sprt(config.bounds), 0.0};
  SeriesConfig series = config.series;
  series.judge = [&](const PairRecord& pair) {
    report.sprt.add(pair.points());
    return report.sprt.verdict() == SprtVerdict::kInconclusive;
  };
  auto played = playSeries(series, progress);
  if (!played) return tl::unexpected<Error>(played.error());
  report.series = std::move(*played);
  return report;
}

}  // namespace fulbito
