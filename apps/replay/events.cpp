#include <cstdio>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "apps/common/commands.hpp"
#include "apps/common/console.hpp"
#include "apps/replay/replay.hpp"
#include "engine/core/base/match_clock.hpp"
#include "engine/core/base/text_controls.hpp"
#include "engine/core/system/error_text.hpp"
#include "match/record/recorded_events.hpp"
#include "replays/recording/call_words.hpp"

namespace fulbito::app {
namespace {

std::string whoText(const RecordedEvent& call) {
  if (!call.team) return "";
  return call.robot ? fmt::format("{} {}", nameOf(*call.team), *call.robot) : nameOf(*call.team);
}

/// One row of the table. The columns are wide enough for the longest clause.
std::string rowOf(const std::string& time, const std::string& period, const std::string& clock,
                  const std::string& score, const std::string& what, const std::string& who,
                  const std::string& place, const std::string& law, const std::string& measured) {
  std::string row = fmt::format("{:>7}  {:<9} {:>7}  {:<7} {:<25} {:<9} {:<16} {:<7} {}", time, period, clock,
                                score, what, who, place, law, measured);
  row.erase(row.find_last_not_of(' ') + 1);
  return row + '\n';
}

std::string headText() {
  return rowOf("time", "period", "clock", "score", "call, - restart", "team", "ball [m]", "law", "measured");
}

std::string lineOf(const ReplayEvent& event, double dt) {
  const RecordedEvent& call = event.call;
  return rowOf(clockText(static_cast<double>(call.tick) * dt), periodName(call.period),
               clockText(call.play_time), fmt::format("{} : {}", event.score[0], event.score[1]),
               event.restart ? fmt::format("- {}", nameOf(*event.restart)) : oneLine(call.clause),
               whoText(call), fmt::format("({:+.3f}, {:+.3f})", call.place.x, call.place.y),
               oneLine(call.law), event.restart ? "" : measuredText(call));
}

/// Whether the call repeats the restart before it, as a kick-off does.
bool repeatsRestart(const ReplayEvent& event, const std::optional<RestartKind>& last) {
  return !event.restart && event.call.clause == "kick-off" && last == RestartKind::kKickOff;
}

/// The last row of a recording that does not reach the end of its match; else nothing.
std::string endText(const RecordingReader& recording, double dt) {
  if (recording.finished() && recording.result()->complete) return "";
  const char* what =
      recording.finished() ? "the recording ends before the match" : "the recording is cut off";
  return rowOf(clockText(static_cast<double>(recording.ticks()) * dt), "", "", "", what, "", "", "", "");
}

Result<void> printLines(const RecordingReader& recording) {
  const auto events = eventsOf(recording);
  if (!events) return tl::unexpected<Error>(events.error());
  const double dt = 1.0 / recording.header().control_rate;
  printOut(headText());
  std::optional<RestartKind> last;
  for (const ReplayEvent& event : *events) {
    if (event.restart) last = event.restart;
    if (!repeatsRestart(event, last)) printOut(lineOf(event, dt));
  }
  printOut(endText(recording, dt));
  return {};
}

}  // namespace

CLI::App* addReplayEvents(CLI::App& replay, ReplayEventsCommand& options) {
  CLI::App* command = replay.add_subcommand("events", "list the referee's calls with their measured values");
  command->footer(
      "Columns: time in the recording; period and its clock (minutes:seconds, truncated); score after the "
      "event;\n"
      "call, or restart (-); team and robot that scored, take the restart, or committed the foul;\n"
      "ball position; law; measured value and its limit. A last row tells of a recording that is cut off\n"
      "or ends before its match.\n"
      "Examples:\n"
      "  fulbito replay events game.fbr\n"
      "  fulbito replay events game.fbr --json     the same lines as fulbito match --events");
  command->add_option("file", options.file, "recording (.fbr)")->required();
  command->add_flag("--json", options.json, "print one JSON object per line");
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
