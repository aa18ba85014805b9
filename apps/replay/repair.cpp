#include "replays/verify/repair.hpp"

#include <optional>
#include <utility>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "apps/common/commands.hpp"
#include "apps/common/console.hpp"
#include "apps/common/outputs.hpp"
#include "apps/replay/replay.hpp"
#include "engine/core/base/text_controls.hpp"
#include "engine/core/system/error_text.hpp"
#include "engine/core/system/output_file.hpp"

namespace fulbito::app {
namespace {

using Json = nlohmann::ordered_json;

/// The result as JSON. `repaired` is empty for an undamaged file.
Json toJson(const ReplayRepairCommand& options, const Salvage& found, const std::optional<Repair>& repaired) {
  Json json{{"schema_version", 1}, {"file", options.file}, {"whole", found.whole}};
  json["out"] = repaired ? Json(options.out) : Json(nullptr);
  if (!repaired) return json;
  const double dt = 1.0 / found.header.control_rate;
  json["plays"] = repaired->plays;
  json["ticks"] = repaired->ticks;
  json["simulated_s"] = static_cast<double>(repaired->ticks) * dt;
  json["bytes"] = repaired->bytes.size();
  json["lost"] = {{"bytes", found.lost_bytes},
                  {"gaps", repaired->gaps},
                  {"ticks", repaired->lost_ticks},
                  {"simulated_s", static_cast<double>(repaired->lost_ticks) * dt},
                  {"end", repaired->end_lost}};
  return json;
}

void print(const ReplayRepairCommand& options, const Salvage& found, const std::optional<Repair>& repaired) {
  if (options.json) {
    writeOut(
        escapedJson(toJson(options, found, repaired).dump(2, ' ', false, Json::error_handler_t::replace)) +
        "\n");
    return;
  }
  if (!repaired) {
    say("{}: not damaged; nothing was written\n", options.file);
    return;
  }
  const double dt = 1.0 / found.header.control_rate;
  say("{}: {} plays, {:.3f} s kept\n", options.out, repaired->plays,
      static_cast<double>(repaired->ticks) * dt);
  say("lost: {} bytes in {} gaps, at least {:.3f} s{}\n", found.lost_bytes, repaired->gaps,
      static_cast<double>(repaired->lost_ticks) * dt, repaired->end_lost ? ", and the end" : "");
}

}  // namespace

CLI::App* addReplayRepair(CLI::App& replay, ReplayRepairCommand& options) {
  CLI::App* command = replay.add_subcommand("repair", "recover a valid recording from a damaged one");
  command->footer(
      "Keeps everything before the damage and every play that starts after it.\n"
      "Example:\n"
      "  fulbito replay repair broken.fbr mended.fbr");
  command->add_option("file", options.file, "damaged recording (.fbr)")->required();
  markOutput(command->add_option("out", options.out, "recording to write")->required(),
             {OutputKind::kRecording});
  addForce(*command, "replace an existing file");
  command->add_flag("--json", options.json, "print JSON");
  return command;
}

int replayRepair(const ReplayRepairCommand& options) {
  const auto found = salvage(options.file);
  if (!found) return report(found.error());
  if (found->whole) {
    print(options, *found, std::nullopt);
    return kOk;
  }
  auto repaired = repair(*found);
  if (!repaired) return report(inFile(options.file, repaired.error()).value());
  if (auto written = writeFile(options.out, repaired->bytes); !written) return report(written.error());
  print(options, *found, std::move(*repaired));
  return kOk;
}

}  // namespace fulbito::app
