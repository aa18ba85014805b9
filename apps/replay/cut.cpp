#include "replays/verify/cut.hpp"

#include <charconv>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "apps/common/commands.hpp"
#include "apps/common/console.hpp"
#include "apps/common/option_values.hpp"
#include "apps/common/outputs.hpp"
#include "apps/replay/replay.hpp"
#include "engine/core/base/text_controls.hpp"
#include "engine/core/system/output_file.hpp"

namespace fulbito::app {
namespace {

using Json = nlohmann::ordered_json;

/// Parses `3-5` or `3`; plays count from 1.
Result<PlayRange> parsePlays(const std::string& text) {
  PlayRange range;
  const char *at = text.data(), *end = at + text.size();
  auto read = std::from_chars(at, end, range.first);
  bool good = read.ec == std::errc();
  range.last = range.first;
  if (good && read.ptr != end) {
    good = *read.ptr == '-';
    if (good) read = std::from_chars(read.ptr + 1, end, range.last);
    good = good && read.ec == std::errc() && read.ptr == end;
  }
  if (!good || range.first < 1 || range.last < range.first) {
    return fail(ErrorCode::kUsage,
                fmt::format("--plays: '{}' is not a range of plays such as 3-5, counted from 1", text));
  }
  return PlayRange{range.first - 1, range.last - 1};
}

Result<PlayRange> rangeOf(const ReplayCutCommand& options, const RecordingReader& recording) {
  const bool timed = options.from || options.to;
  if (timed == !options.plays.empty()) {
    return fail(ErrorCode::kUsage, "replay cut: needs either --plays A-B, or --from and --to in seconds");
  }
  if (!timed) return parsePlays(options.plays);
  if (options.from && options.to && *options.from > *options.to) {
    return fail(ErrorCode::kUsage, fmt::format("--from {} is after --to {}", *options.from, *options.to));
  }
  const double length = static_cast<double>(recording.ticks()) / recording.header().control_rate;
  return playsBetween(recording, options.from.value_or(0.0), options.to.value_or(length));
}

void print(const ReplayCutCommand& options, const PlayRange& plays, const RecordingReader& cut) {
  const double seconds = static_cast<double>(cut.ticks()) / cut.header().control_rate;
  if (!options.json) {
    say("{}: plays {} to {}, {:.3f} s\n", options.out, plays.first + 1, plays.last + 1, seconds);
    return;
  }
  const Json json{{"schema_version", 1},           {"file", options.file},        {"out", options.out},
                  {"first_play", plays.first + 1}, {"last_play", plays.last + 1}, {"ticks", cut.ticks()},
                  {"simulated_s", seconds},        {"bytes", cut.sizeInBytes()}};
  writeOut(escapedJson(json.dump(2, ' ', false, Json::error_handler_t::replace)) + "\n");
}

}  // namespace

CLI::App* addReplayCut(CLI::App& replay, ReplayCutCommand& options) {
  CLI::App* command = replay.add_subcommand("cut", "copy some plays of a recording to a new one");
  command->footer(
      "Plays are kept whole, from restart to restart, so the copy verifies like any recording.\n"
      "Examples:\n"
      "  fulbito replay cut game.fbr goal.fbr --from 40 --to 50    all plays that overlap these seconds\n"
      "  fulbito replay cut game.fbr some.fbr --plays 3-5");
  command->add_option("file", options.file, "recording (.fbr)")->required();
  markOutput(command->add_option("out", options.out, "recording to write")->required(),
             {OutputKind::kRecording});
  number(command->add_option("--from", options.from, "keep plays from this time on [s] (default: the start)"))
      ->type_name("S");
  number(command->add_option("--to", options.to, "keep plays up to this time [s] (default: the end)"))
      ->type_name("S");
  command->add_option("--plays", options.plays, "keep plays A to B, counted from 1")->type_name("A-B");
  addForce(*command, "replace an existing file");
  command->add_flag("--json", options.json, "print JSON");
  return command;
}

int replayCut(const ReplayCutCommand& options) {
  const auto recording = RecordingReader::open(options.file);
  if (!recording) return report(recording.error());
  const auto range = rangeOf(options, *recording);
  if (!range) return report(range.error());
  const auto bytes = cutPlays(*recording, *range);
  if (!bytes) return report(bytes.error());
  if (auto written = writeFile(options.out, *bytes); !written) return report(written.error());
  const auto cut = RecordingReader::parse(*bytes, options.out);
  if (!cut) return report(cut.error());
  print(options, *range, *cut);
  return kOk;
}

}  // namespace fulbito::app
