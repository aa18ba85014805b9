#include "apps/match/view.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "apps/common/commands.hpp"
#include "apps/common/console.hpp"
#include "apps/common/option_values.hpp"
#include "apps/common/outputs.hpp"
#include "apps/view/match_stage.hpp"
#include "apps/view/replay_stage.hpp"
#include "bridge/wire/wire_settings.hpp"
#include "engine/core/base/text_controls.hpp"
#include "engine/core/system/error_text.hpp"
#include "replays/verify/expand.hpp"

namespace fulbito::app {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kLeastWidth = 320, kLeastHeight = 240;  // [px]

Result<void> readSize(const std::string& text, WindowOptions& window) {
  if (text.empty()) return {};
  const char* const end = text.data() + text.size();
  const auto width = std::from_chars(text.data(), end, window.width);
  const bool cross = width.ec == std::errc() && width.ptr != end && *width.ptr == 'x';
  const auto height = std::from_chars(cross ? width.ptr + 1 : end, end, window.height);
  const bool whole = cross && height.ec == std::errc() && height.ptr == end;
  if (whole && window.width >= kLeastWidth && window.width <= kLargestWindow &&
      window.height >= kLeastHeight && window.height <= kLargestWindow) {
    return {};
  }
  return fail(ErrorCode::kUsage, fmt::format("--size: '{}' is not a WIDTHxHEIGHT from {}x{} to {}x{}", text,
                                             kLeastWidth, kLeastHeight, kLargestWindow, kLargestWindow));
}

Result<void> checkSpeed(double speed) {
  if (std::find(std::begin(kViewSpeeds), std::end(kViewSpeeds), speed) != std::end(kViewSpeeds)) return {};
  return fail(ErrorCode::kUsage,
              fmt::format("--speed: {:g} must be one of 0.25, 0.5, 1, 2, 4, 8, 16", speed));
}

ViewSettings settingsOf(const ViewOptions& options) {
  ViewSettings settings;
  settings.speed = options.speed;
  settings.paused = options.paused;
  settings.theme = options.theme == "light" ? PictureTheme::kLight : PictureTheme::kDark;
  settings.full_screen = options.full_screen;
  settings.help = options.help;
  return settings;
}

/// The timeline of a recording, which is simulated again if it has no samples.
Result<ReplayTimeline> timelineOf(const std::string& file) {
  auto recording = RecordingReader::open(file);
  if (!recording) return tl::unexpected<Error>(recording.error());
  if (recording->header().level != RecordingLevel::kFull) {
    auto full = expanded(*recording);
    if (!full) return tl::unexpected<Error>(full.error());
    *recording = std::move(*full);
  }
  return ReplayTimeline::read(*recording);
}

Result<std::unique_ptr<ViewStage>> stageOf(const std::string& file, double from) {
  auto timeline = timelineOf(file);
  if (!timeline) {
    const bool named = timeline.error().message.find(file) != std::string::npos;
    return named ? tl::unexpected<Error>(timeline.error()) : inFile(file, timeline.error());
  }
  if (!(from >= 0.0 && from <= timeline->seconds())) {
    return fail(ErrorCode::kUsage,
                fmt::format("--from {}: the recording lasts from 0 to {:.2f} s", from, timeline->seconds()));
  }
  auto stage = ReplayStage::create(std::move(*timeline), file);
  if (!stage) return inFile(file, stage.error());
  (*stage)->seek(from);
  return std::unique_ptr<ViewStage>(std::move(*stage));
}

/// The speed over real time of a match with clients of the league; 0: there are none.
double paceOf(const MatchConfig& config) {
  double pace = 0.0;
  for (const TeamChoice& team : config.teams) {
    if (!wire::isWire(team.text)) continue;
    if (const auto seat = wire::parseWire(team.text)) pace = std::max(pace, seat->settings.speed);
  }
  return pace;
}

void print(const ViewCommand& options, const Viewer& viewer, const ViewWindow& window) {
  const ViewSettings& settings = viewer.settings();
  const Json json{{"schema_version", 1},
                  {"files", options.files},
                  {"file", options.files[viewer.current()]},
                  {"position_s", viewer.stage().seconds()},
                  {"seconds", viewer.stage().look().seconds},
                  {"paused", settings.paused},
                  {"speed", settings.speed},
                  {"theme", settings.theme == PictureTheme::kDark ? "dark" : "light"},
                  {"trails", settings.trails},
                  {"drawings", settings.drawings},
                  {"flipped", settings.flipped},
                  {"help", settings.help},
                  {"full_screen", settings.full_screen},
                  {"edited", viewer.stage().edited()},
                  {"frames", window.frames()}};
  writeOut(escapedJson(json.dump(2, ' ', false, Json::error_handler_t::replace)) + '\n');
}

}  // namespace

void addViewOptions(CLI::App& command, ViewOptions& options, CLI::Option* needed, bool speed) {
  const auto add = [needed](CLI::Option* option) {
    option->group("Window");
    if (needed != nullptr) option->needs(needed);
    return option;
  };
  if (speed) {
    add(command.add_option("--speed", options.speed,
                           "playback speed, 1 = real time: 0.25, 0.5, 1, 2, 4, 8, 16"))
        ->capture_default_str();
  }
  add(command.add_option("--theme", options.theme, "colour theme: dark or light"))
      ->check(CLI::IsMember({"dark", "light"}).description(""))
      ->capture_default_str();
  add(command.add_option("--size", options.size, "window size [px] (default: 900 wide, or what fits)"))
      ->type_name("WxH");
  add(command.add_flag("--paused", options.paused, "start paused"));
  add(command.add_flag("--full-screen", options.full_screen, "fill the screen"));
  add(command.add_flag("--keys", options.help, "show the list of keys at the start"));
  wholeNumber(
      add(command.add_option("--frames", options.frames, "exit after N frames, or when nothing moves")))
      ->type_name("N");
  markOutput(add(command.add_option("--screenshot", options.screenshot, "write the last frame as PNG"))
                 ->type_name("FILE"),
             {OutputKind::kPng});
}

CLI::App* addView(CLI::App& app, ViewCommand& options) {
  CLI::App* command = app.add_subcommand("view", "play recordings in a window");
  command->footer(
      "Press H in the window for the keys: space plays or pauses, arrows seek, + and - change the speed.\n"
      "Examples:\n"
      "  fulbito match libero classic --record game.fbr   make a recording\n"
      "  fulbito view game.fbr\n"
      "  fulbito view game.fbr --from 83 --speed 0.25     a goal in slow motion\n"
      "  fulbito view monday.fbr tuesday.fbr              one after the other\n"
      "  fulbito match libero classic --view              watch a live match\n"
      "More: docs/view.md.");
  command->add_option("files", options.files, "recordings (.fbr)")->required()->type_name("FILE ...");
  command->add_option("--from", options.from, "start at this time of the first recording [s]")
      ->capture_default_str();
  addViewOptions(*command, options.window);
  addForce(*command, "with --screenshot: replace an existing file");
  command->add_flag("--json", options.json, "print the viewer's state as JSON on exit");
  return command;
}

Result<ViewWindow> openWindow(const ViewOptions& options) {
  WindowOptions window;
  if (auto size = readSize(options.size, window); !size) return tl::unexpected<Error>(size.error());
  if (auto speed = checkSpeed(options.speed); !speed) return tl::unexpected<Error>(speed.error());
  window.frames = options.frames;
  window.screenshot = options.screenshot;
  window.now = now;
  window.interrupted = interrupted;
  return ViewWindow::create(window);
}

Result<void> playInWindow(Match& match, ViewWindow& window, const ViewOptions& options) {
  std::vector<std::unique_ptr<ViewStage>> stages;
  stages.push_back(std::make_unique<MatchStage>(match, paceOf(match.config())));
  Viewer viewer(std::move(stages), settingsOf(options));
  auto shown = window.run(viewer);
  match.finish();  // ends the match while the stage that observes it still exists
  return shown;
}

int view(const ViewCommand& options) {
  std::vector<std::unique_ptr<ViewStage>> stages;
  for (const std::string& file : options.files) {
    auto stage = stageOf(file, stages.empty() ? options.from : 0.0);
    if (!stage) return report(stage.error());
    stages.push_back(std::move(*stage));
  }
  auto window = openWindow(options.window);
  if (!window) return report(window.error());
  Viewer viewer(std::move(stages), settingsOf(options.window));
  if (auto shown = window->run(viewer); !shown) return report(shown.error());
  if (options.json) print(options, viewer, *window);
  return interrupted() ? interruptedCode() : kOk;
}

}  // namespace fulbito::app
