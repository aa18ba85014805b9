#include "tournament/gate/gate.hpp"

#include <cmath>

#include <fmt/format.h>

#include "tournament/statistics/elo.hpp"

namespace fulbito {

Result<void> validate(const SprtBounds& bounds) {
  const double most = std::floor(kMostStrength * kEloPerStrength);
  if (!(bounds.weak < bounds.strong) || std::abs(bounds.weak) > most || std::abs(bounds.strong) > most) {
    return fail(ErrorCode::kUsage,
                fmt::format("bounds: want two rising values within -{0:.0f} ... {0:.0f} normalized Elo, not "
                            "{1:g} and {2:g}",
                            most, bounds.weak, bounds.strong));
  }
  for (const auto& [name, rate] : {std::pair{"alpha", bounds.alpha}, std::pair{"beta", bounds.beta}}) {
    if (!(rate >= 1e-6 && rate <= 0.25)) {
      return fail(ErrorCode::kUsage, fmt::format("{}: {:g} is outside 0.000001 ... 0.25", name, rate));
    }
  }
  return {};
}

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

std::string_view nameOf(SprtVerdict verdict) {
  switch (verdict) {
    case SprtVerdict::kPass:
      return "pass";
    case SprtVerdict::kFail:
      return "fail";
    case SprtVerdict::kInconclusive:
      break;
  }
  return "inconclusive";
}

}  // namespace fulbito
