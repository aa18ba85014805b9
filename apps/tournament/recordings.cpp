#include "apps/tournament/recordings.hpp"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <string_view>

#include <fmt/format.h>

#include "apps/common/commands.hpp"
#include "apps/common/console.hpp"
#include "apps/replay/export_html.hpp"
#include "engine/core/system/output_file.hpp"
#include "fulbito/recorder.hpp"
#include "tournament/runner/play_match.hpp"

namespace fulbito::app {
namespace {

std::string recordingOf(const std::string& folder, const MatchId& id) {
  return fmt::format("{}/{}.fbr", folder, id.text());
}

bool exists(const std::string& file) {
  std::error_code ignored;
  return std::filesystem::exists(file, ignored);
}

/// A recording whose file appears only when it is complete.
struct WholeRecording {
  OutputFile file;
  std::optional<MatchRecorder> recorder;  ///< writes into the file

  Result<void> finish() { return recorder->written() ? file.commit(false) : recorder->written(); }
};

/// Checks that the path of a recording is not a pipe or device: opening a pipe would wait for its reader.
/// Errors: kIo.
Result<void> checkPlain(const std::string& file) {
  std::error_code ignored;
  if (!exists(file) || std::filesystem::is_regular_file(file, ignored)) return {};
  return fail(ErrorCode::kIo, fmt::format("cannot write '{}': it is not a regular file", file));
}

Result<std::shared_ptr<WholeRecording>> recordInto(const std::string& file, const MatchConfig& match) {
  if (auto plain = checkPlain(file); !plain) return tl::unexpected<Error>(plain.error());
  auto out = OutputFile::create(file);
  if (!out) return tl::unexpected<Error>(out.error());
  auto recording = std::make_shared<WholeRecording>(WholeRecording{std::move(*out), std::nullopt});
  const auto sink = [whole = recording.get()](std::string_view bytes) { return whole->file.write(bytes); };
  auto recorder = MatchRecorder::create(sink, match);
  if (!recorder) return tl::unexpected<Error>(recorder.error());
  recording->recorder.emplace(std::move(*recorder));
  return recording;
}

Result<void> recordAgain(const TournamentState& state, const NotableMatch& match, const std::string& file) {
  const Fixture& fixture = state.schedule.fixtures[match.fixture];
  const auto config = matchOf(state.plan, fixture, match.leg);
  if (!config) return tl::unexpected<Error>(config.error());
  const auto recording = recordInto(file, *config);
  if (!recording) return tl::unexpected<Error>(recording.error());
  const auto result = playMatch(*config, now, [] { return !interrupted(); }, &*(*recording)->recorder);
  if (!result) return tl::unexpected<Error>(result.error());
  if (result->hash == state.results[match.fixture]->legs[match.leg].hash) return (*recording)->finish();
  note("note: the match '{}' does not repeat itself; it is not recorded (--recordings all records at once)\n",
       match.why);
  return {};
}

}  // namespace

Result<KeptRecordings> keptOf(const std::string& name) {
  if (name == "none") return KeptRecordings::kNone;
  if (name == "upsets") return KeptRecordings::kUpsets;
  if (name == "all") return KeptRecordings::kAll;
  return fail(ErrorCode::kUsage, fmt::format("--recordings: want none, upsets or all, not '{}'", name));
}

Result<MatchWatch> recordingWatch(const std::string& folder, const MatchConfig& match, const MatchId& id) {
  auto recording = recordInto(recordingOf(folder, id), match);
  if (!recording) return tl::unexpected<Error>(recording.error());
  return MatchWatch{std::shared_ptr<MatchObserver>(*recording, &*(*recording)->recorder),
                    [recording = *recording] { return recording->finish(); }};
}

Result<void> recordNotable(const TournamentState& state, const std::vector<NotableMatch>& notable,
                           const std::string& folder) {
  for (const NotableMatch& match : notable) {
    const std::string file = recordingOf(folder, match.id);
    if (exists(file)) continue;
    if (auto recorded = recordAgain(state, match, file); !recorded) return recorded;
  }
  return {};
}

bool areRecorded(const std::vector<NotableMatch>& notable, const std::string& folder) {
  return std::all_of(notable.begin(), notable.end(),
                     [&](const NotableMatch& match) { return exists(recordingOf(folder, match.id)); });
}

Result<std::map<std::string, std::string>> writePages(const std::vector<NotableMatch>& notable,
                                                      const std::string& recordings,
                                                      const std::string& report) {
  std::map<std::string, std::string> names;
  const std::filesystem::path page_file(report);
  const std::string folder = page_file.stem().string() + "-matches";
  for (const NotableMatch& match : notable) {
    const std::string recording = recordingOf(recordings, match.id);
    if (!exists(recording)) continue;
    const auto html = replayPage(recording);
    if (!html) return tl::unexpected<Error>(html.error());
    const std::string name = folder + "/" + match.id.text() + ".html";
    if (auto made = prepareFolder((page_file.parent_path() / folder).string()); !made) {
      return tl::unexpected<Error>(made.error());
    }
    const std::string page = (page_file.parent_path() / name).string();
    auto written = checkPlain(page);
    if (written) written = writeFile(page, *html, false);
    if (!written) return tl::unexpected<Error>(written.error());
    names[match.id.text()] = name;
  }
  return names;
}

}  // namespace fulbito::app
