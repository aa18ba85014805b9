#include <algorithm>
#include <cmath>
#include <unistd.h>

#include <fmt/format.h>

#include "apps/common/progress.hpp"
#include "apps/replay/export_request.hpp"
#include "engine/core/system/output_file.hpp"
#include "fulbito/picture.hpp"
#include "replays/recording/recipe_words.hpp"

namespace fulbito::app {
namespace {

constexpr int kPictureWidth = 900, kSheetWidth = 1600;  // [px]
constexpr int kSheetCells = 12;
constexpr double kStillFps = 10.0;

/// A still picture: the state of all bodies, and its overlays.
struct Still {
  ReplayMoment moment;
  MatchOverlays overlays;
};

Still stillAt(const ExportRequest& request, double seconds) {
  Still still{request.timeline.at(seconds), {}};
  ReplayDirector(request.timeline, request.overlays).direct(still.moment, still.overlays);
  return still;
}

/// The last tick before the restart after an event, with the banner of the event and the new score.
Still stillOf(const ExportRequest& request, const RecordedEvent& event) {
  const ReplayTimeline& timeline = request.timeline;
  Still still = stillAt(request, timeline.secondsAt(std::max<Tick>(0, event.tick - 1)));
  const ReplayMoment after = timeline.at(timeline.secondsAt(event.tick));
  still.moment.score = after.score;
  if (request.overlays.banner) {
    still.overlays.banner = bannerOf(event, timeline.header().recipe);
  }
  return still;
}

/// Inserts a number into a file name: `game.png` becomes `game-0012.png`.
std::string numbered(const std::string& file, std::size_t index) {
  const std::size_t dot = file.rfind('.'), slash = file.rfind('/');
  const std::size_t end =
      dot == std::string::npos || (slash != std::string::npos && dot < slash) ? file.size() : dot;
  return fmt::format("{}-{:04}{}", file.substr(0, end), index, file.substr(end));
}

/// The file names of `count` pictures, numbered if there are several. Errors: as `outputFile`.
Result<std::vector<std::string>> pictureFiles(const ExportRequest& request, const ProductName& product,
                                              const std::string& ending, std::size_t count) {
  const std::string& given = product.given;
  if (count > 1 && given == "-") {
    return fail(ErrorCode::kUsage,
                fmt::format("{} pictures cannot be written to stdout; name a file", count));
  }
  std::vector<std::string> files;
  for (std::size_t i = 1; i <= count; ++i) {
    const bool many = count > 1;
    auto file =
        outputFile(request, {product.flag, product.kind, many && !given.empty() ? numbered(given, i) : given},
                   many ? numbered(ending, i) : ending);
    if (!file) return tl::unexpected<Error>(file.error());
    files.push_back(std::move(*file));
  }
  return files;
}

Result<void> deliverPng(const std::string& file, const Canvas& canvas, PngEffort effort) {
  const std::string bytes = canvas.png(effort);
  if (bytes.empty()) return fail(ErrorCode::kMachine, "not enough memory for " + file);
  return deliver(file, bytes);
}

Result<void> writeStills(const ExportRequest& request, const std::vector<Still>& stills) {
  const auto files =
      pictureFiles(request, {"--png", OutputKind::kPng, *request.options->png}, ".png", stills.size());
  if (!files) return tl::unexpected<Error>(files.error());
  const auto picture = MatchPicture::create(request.specOf(kPictureWidth));
  if (!picture) return tl::unexpected<Error>(picture.error());
  auto canvas = picture->canvas();
  if (!canvas) return tl::unexpected<Error>(canvas.error());
  for (std::size_t i = 0; i < stills.size(); ++i) {
    picture->drawFrame(*canvas, stills[i].moment, stills[i].overlays);
    if (auto written = deliverPng((*files)[i], *canvas, PngEffort::kSmall); !written) return written;
  }
  return {};
}

Result<void> writeSequence(const ExportRequest& request) {
  const ReplayExportCommand& options = *request.options;
  const auto picture = MatchPicture::create(request.specOf(kPictureWidth));
  if (!picture) return tl::unexpected<Error>(picture.error());
  FrameJob job{&request.timeline, &*picture, request.overlays,
               filmTimes({request.whole}, options.fps.value_or(kStillFps), options.speed.value_or(1.0)),
               request.jobs};
  const auto files =
      pictureFiles(request, {"--png", OutputKind::kPng, *options.png}, ".png", job.times.size());
  if (!files) return tl::unexpected<Error>(files.error());
  ProgressBar progress("pictures", ::isatty(STDERR_FILENO) == 0);
  const auto packer = [] {
    return [](Canvas& canvas, std::string& out) { out = canvas.png(PngEffort::kFast); };
  };
  auto drawn = forEachFrame(job, packer, [&](std::size_t index, std::string& bytes) -> Result<void> {
    if (!progress.update(index, job.times.size())) return fail(ErrorCode::kInterrupted, "interrupted");
    return (*files)[index] == "-" ? deliver("-", bytes) : writeFile((*files)[index], bytes, false);
  });
  if (!drawn) return drawn;
  announce(files->front(), fmt::format("first of {} pictures", files->size()));
  return {};
}

/// The stills at the times of --at and at the events. Empty if neither was given.
std::vector<Still> stillsOf(const ExportRequest& request) {
  std::vector<Still> stills;
  stills.reserve(request.options->at.size() + request.events.size());
  for (const double at : request.options->at) stills.push_back(stillAt(request, at));
  for (const RecordedEvent& event : request.events) stills.push_back(stillOf(request, event));
  return stills;
}

}  // namespace

Result<void> exportPng(const ExportRequest& request) {
  const ReplayExportCommand& options = *request.options;
  std::vector<Still> stills = stillsOf(request);
  if (stills.empty() && (options.from || options.to || options.fps)) return writeSequence(request);
  if (stills.empty()) stills.push_back(stillAt(request, request.timeline.seconds()));
  return writeStills(request, stills);
}

Result<void> exportContactSheet(const ExportRequest& request) {
  const auto file = outputFile(
      request, {"--contact-sheet", OutputKind::kPng, *request.options->contact_sheet}, "-sheet.png");
  if (!file) return tl::unexpected<Error>(file.error());
  std::vector<double> times = request.options->at;
  for (const RecordedEvent& event : request.events) {
    times.push_back(request.timeline.secondsAt(std::max<Tick>(0, event.tick - 1)));
  }
  if (times.empty()) {
    const ReplayRange range = request.whole;
    for (int i = 0; i < kSheetCells; ++i) {
      times.push_back(range.from + (range.to - range.from) * (i + 0.5) / kSheetCells);
    }
  }
  const auto sheet = drawContactSheet(request.timeline, request.specOf(kSheetWidth), times, request.overlays);
  if (!sheet) return tl::unexpected<Error>(sheet.error());
  return deliverPng(*file, *sheet, PngEffort::kSmall);
}

Result<void> exportTrails(const ExportRequest& request) {
  const std::vector<ReplayRange> ranges = request.ranges();
  const auto files = pictureFiles(request, {"--trails", OutputKind::kPng, *request.options->trails},
                                  "-trails.png", ranges.size());
  if (!files) return tl::unexpected<Error>(files.error());
  const auto picture = MatchPicture::create(request.specOf(kPictureWidth));
  if (!picture) return tl::unexpected<Error>(picture.error());
  auto canvas = picture->canvas();
  if (!canvas) return tl::unexpected<Error>(canvas.error());
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    // For an event, shows the paths up to it, not those after the restart.
    const bool event = !request.events.empty();
    Still still = event ? stillOf(request, request.events[i]) : stillAt(request, ranges[i].to);
    still.overlays.trails = pathsBetween(request.timeline, ranges[i].from, still.moment.seconds);
    picture->drawFrame(*canvas, still.moment, still.overlays);
    if (auto written = deliverPng((*files)[i], *canvas, PngEffort::kSmall); !written) return written;
  }
  return {};
}

Result<void> exportSvg(const ExportRequest& request) {
  std::vector<Still> stills = stillsOf(request);
  if (stills.empty()) stills.push_back(stillAt(request, request.timeline.seconds()));
  const auto files =
      pictureFiles(request, {"--svg", OutputKind::kSvg, *request.options->svg}, ".svg", stills.size());
  if (!files) return tl::unexpected<Error>(files.error());
  for (std::size_t i = 0; i < stills.size(); ++i) {
    const auto svg = matchSvg(request.specOf(kPictureWidth), stills[i].moment, stills[i].overlays);
    if (!svg) return tl::unexpected<Error>(svg.error());
    if (auto written = deliver((*files)[i], *svg); !written) return written;
  }
  return {};
}

namespace {

/// The bodies that a word selects: ball, blue, yellow, blue:1; in a trial also robot.
Result<HeatMapChoice> heatChoice(const ExportRequest& request, const std::string& word) {
  HeatMapChoice choice;
  choice.from = request.whole.from;
  choice.to = request.whole.to;
  const RecordingHeader& header = request.timeline.header();
  const std::string team = word.substr(0, word.find(':'));
  for (std::size_t i = 0; i < header.bodies.size(); ++i) {
    const RecordedBody& body = header.bodies[i];
    const bool ball = body.kind == BodyKind::kBall && word == "ball";
    const bool lone = body.kind == BodyKind::kRobot && !body.id && word == "robot";
    const bool member = body.id && team == nameOf(body.id->team) &&
                        (word == team || word == fmt::format("{}:{}", team, body.id->number));
    if (ball || lone || member) choice.bodies.push_back(i);
  }
  if (choice.bodies.empty()) {
    return fail(
        ErrorCode::kUsage,
        fmt::format("--heatmap '{}': must be ball, blue, yellow or a recorded robot such as blue:0", word));
  }
  choice.label = word == "ball" ? "the ball" : word == "robot" ? "the robot" : word;
  const std::size_t index = team == "yellow" ? 1 : 0;
  if (header.bodies[choice.bodies.front()].id && index < header.recipe.teams.size()) {
    choice.label = fmt::format("{} ({})", teamNames(header.recipe)[index], word);
  }
  return choice;
}

}  // namespace

Result<void> exportHeatMap(const ExportRequest& request) {
  const std::string& word = request.options->heatmap.front();
  const auto choice = heatChoice(request, word);
  if (!choice) return tl::unexpected<Error>(choice.error());
  std::string ending = "-heatmap-" + word + ".png";
  std::replace(ending.begin(), ending.end(), ':', '-');
  const std::string given = request.options->heatmap.size() > 1 ? request.options->heatmap[1] : std::string();
  const auto file = outputFile(request, {"--heatmap", OutputKind::kPng, given}, ending);
  if (!file) return tl::unexpected<Error>(file.error());
  const auto map = drawHeatMap(request.timeline, request.specOf(kPictureWidth), *choice);
  if (!map) return tl::unexpected<Error>(map.error());
  return deliverPng(*file, *map, PngEffort::kSmall);
}

}  // namespace fulbito::app
