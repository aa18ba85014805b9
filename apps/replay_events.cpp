#include "apps/replay_events.hpp"

#include <cstdio>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "apps/commands.hpp"
#include "apps/console.hpp"
#include "engine/core/error_text.hpp"
#include "match/recorded_events.hpp"
#include "match/resimulate.hpp"
#include "referee/referee_state.hpp"

namespace fulbito::app {
namespace {

std::string clockText(double seconds) {
  const int minutes = static_cast<int>(seconds / 60.0);
  return fmt::format("{:02}:{:04.1f}", minutes, seconds - 60.0 * minutes);
}

std::string periodText(int period) {
  if (period == kShootOutPeriod) return "shoot-out";
  if (period == kOvertimePeriod) return "overtime";
  return period == 1 ? "1st half" : "2nd half";
}

std::string whoText(const RecordedEvent& call) {
  if (!call.team) return "";
  return call.robot ? fmt::format("{} {}", nameOf(*call.team), *call.robot) : nameOf(*call.team);
}

std::string lineOf(const ReplayEvent& event, double dt) {
  const RecordedEvent& call = event.call;
  std::string line =
      fmt::format("{}  {:<9} {}  {} : {}  {:<26}{:<9}", clockText(static_cast<double>(call.tick) * dt),
                  periodText(call.period), clockText(call.play_time), event.score[0], event.score[1],
                  event.restart ? fmt::format("- {}", nameOf(*event.restart)) : call.clause, whoText(call));
  line += fmt::format(" ({:+.3f}, {:+.3f})", call.place.x, call.place.y);
  if (event.restart) return line;
  line += fmt::format("  {:.4g}", call.value);
  if (call.threshold != 0.0) line += fmt::format(" (limit {:.4g})", call.threshold);
  if (!call.law.empty()) line += fmt::format("  law {}", call.law);
  return line;
}

Result<void> printLines(const RecordingReader& recording) {
  const auto events = eventsOf(recording);
  if (!events) return tl::unexpected<Error>(events.error());
  const double dt = 1.0 / recording.header().control_rate;
  for (const ReplayEvent& event : *events) printOut(lineOf(event, dt) + '\n');
  return {};
}

}  // namespace

CLI::App* addReplayEvents(CLI::App& replay, ReplayEventsCommand& options) {
  CLI::App* command = replay.add_subcommand("events", "list what the referee called, with what was measured");
  command->footer(
      "Time in the recording, clock of the period, score, call or (-) restart, team and robot, place [m], "
      "value and limit, law.\n"
      "Examples:\n"
      "  fulbito replay events game.fbr\n"
      "  fulbito replay events game.fbr --json     the lines of fulbito match --events");
  command->add_option("file", options.file, "recording (.fbr)")->required();
  command->add_flag("--json", options.json, "one JSON object a line");
  return command;
}

int replayEvents(const ReplayEventsCommand& options) {
  const auto recording = RecordingReader::open(options.file);
  if (!recording) return report(recording.error());
  const auto written = options.json
                           ? writeEventLines(*recording, [](std::string_view line) { writeOut(line); })
                           : printLines(*recording);
  if (!written) return report(inFile(options.file, written.error()).value());
  return kOk;
}

}  // namespace fulbito::app
