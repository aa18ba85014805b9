#include <cstdio>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "apps/common/commands.hpp"
#include "apps/common/console.hpp"
#include "bench/benchmark.hpp"
#include "bench/scenes.hpp"
#include "fulbito/experiment.hpp"
#include "trials/crowd.hpp"

namespace fulbito::app {
namespace {

using Json = nlohmann::ordered_json;

std::string signatureText(std::uint64_t signature) { return fmt::format("{:016x}", signature); }

Json sceneJson(const BenchScene& scene) {
  return {{"name", scene.name},
          {"rate_hz", scene.rate_hz},
          {"load", scene.load},
          {"engine_x_realtime", scene.engine_x_realtime},
          {"bare_x_realtime", scene.bare_x_realtime},
          {"ratio", scene.ratio},
          {"ratio_min", scene.ratio_min},
          {"engine_contacts", scene.engine_contacts},
          {"bare_contacts", scene.bare_contacts}};
}

void printJson(const BenchReport& report, const CrowdResult& crowd) {
  Json json = {{"schema_version", 1},
               {"build", Json::parse(versionJson())},
               {"signature", signatureText(report.signature)},
               {"scenes", Json::array()},
               {"two_threads", Json::array()}};
  json["build"].erase("schema_version");
  for (const BenchScene& scene : report.scenes) json["scenes"].push_back(sceneJson(scene));
  for (const BenchScaling& row : report.scaling) {
    json["two_threads"].push_back({{"rate_hz", row.rate_hz},
                                   {"load", row.load},
                                   {"engine_scaling", row.engine},
                                   {"bare_scaling", row.bare},
                                   {"ratio", row.ratio}});
  }
  json["navigation"] = {{"navigator", kDefaultNavigator},
                        {"robots", 6},
                        {"arrivals", crowd.arrivals},
                        {"contacts", crowd.contacts},
                        {"compute_us_mean", crowd.compute_us_mean},
                        {"compute_us_p99", crowd.compute_us_p99},
                        {"compute_us_max", crowd.compute_us_max}};
  writeOut(json.dump(2) + "\n");
}

}  // namespace

int bench(const BenchCommand& command) {
  if (command.repetitions < 1 || command.repetitions > 1000 || command.episodes < 1 ||
      command.episodes > 100000) {
    return report({ErrorCode::kUsage, "bench: --repetitions must be 1 ... 1000, --episodes 1 ... 100000"});
  }
  if (command.signature_only) {
    writeOut(signatureText(sceneSignature()) + "\n");
    return kOk;
  }
  const auto crowd = runCrowd({}, now);
  if (!crowd) return report(crowd.error());
  const auto benchmark = runBenchmark({command.repetitions, command.episodes, true});
  if (!benchmark) return report(benchmark.error());
  if (command.json) {
    printJson(*benchmark, *crowd);
  } else {
    say("six robots navigated by {}: {:.2f} us per robot and tick on average, p99 {:.1f}, max {:.0f} "
        "({} goals reached in a minute, {} contacts)\n{}",
        kDefaultNavigator, crowd->compute_us_mean, crowd->compute_us_p99, crowd->compute_us_max,
        crowd->arrivals, crowd->contacts, toTable(*benchmark));
  }
  return kOk;
}

}  // namespace fulbito::app
