#include <algorithm>
#include <cmath>
#include <filesystem>
#include <unistd.h>

#include <fmt/format.h>

#include "apps/common/console.hpp"
#include "apps/common/progress.hpp"
#include "apps/replay/export_request.hpp"
#include "replays/export/gif.hpp"
#include "replays/export/tables.hpp"
#include "replays/export/video_pipe.hpp"
#include "replays/export/yuv.hpp"

namespace fulbito::app {
namespace {

constexpr int kVideoWidth = 900, kGifWidth = 480;  // [px]
constexpr double kVideoFps = 30.0, kGifFps = 12.5;
constexpr double kHurried = 4.0;    // default speed of longer films, relative to real time
constexpr double kPatience = 30.0;  // [s] films up to this length are shown in real time
constexpr std::size_t kPaletteSamples = 12;

bool quiet() { return ::isatty(STDERR_FILENO) == 0; }

/// The speed of a film: real time for events and short ranges, otherwise `kHurried`.
double speedOf(const ExportRequest& request) {
  const bool scene = !request.events.empty() || request.whole.to - request.whole.from <= kPatience;
  return request.options->speed.value_or(scene ? 1.0 : kHurried);
}

FrameJob jobOf(const ExportRequest& request, const MatchPicture& picture, double fps) {
  return {&request.timeline, &picture, request.overlays, filmTimes(request.ranges(), fps, speedOf(request)),
          request.jobs};
}

std::string lengthText(std::size_t frames, double fps) {
  return fmt::format("{} frames, {:.1f} s", frames, static_cast<double>(frames) / fps);
}

/// Draws all frames and passes them to `sink`, with a progress bar.
Result<void> film(const FrameJob& job, const char* what, const std::function<FramePacker()>& packer,
                  const FrameSink& sink) {
  ProgressBar progress(what, quiet());
  return forEachFrame(job, packer, [&](std::size_t index, std::string& bytes) -> Result<void> {
    if (!progress.update(index, job.times.size())) return fail(ErrorCode::kInterrupted, "interrupted");
    return sink(index, bytes);
  });
}

Result<void> exportVideo(const ExportRequest& request, VideoFormat format, const std::string& given) {
  const bool mp4 = format == VideoFormat::kMp4;
  const ProductName name =
      mp4 ? ProductName{"--mp4", OutputKind::kMp4, given} : ProductName{"--webm", OutputKind::kWebm, given};
  const auto file = outputFile(request, name, mp4 ? ".mp4" : ".webm");
  if (!file) return tl::unexpected<Error>(file.error());
  const auto picture = MatchPicture::create(request.specOf(kVideoWidth));
  if (!picture) return tl::unexpected<Error>(picture.error());
  const MatchPictureSpec& spec = picture->spec();
  if (spec.width % 2 != 0 || spec.height % 2 != 0) {
    return fail(ErrorCode::kUsage, fmt::format("--size {}x{}: width and height of a video must be even",
                                               spec.width, spec.height));
  }
  const double fps = request.options->fps.value_or(kVideoFps);
  auto video = VideoPipe::open(*file, {format, spec.width, spec.height, fps, request.options->quality});
  if (!video) return tl::unexpected<Error>(video.error());
  const FrameJob job = jobOf(request, *picture, fps);
  auto done = film(
      job, mp4 ? "mp4" : "webm",
      [] { return [](Canvas& canvas, std::string& out) { toYuv420(canvas, out); }; },
      [&](std::size_t, std::string& bytes) { return video->write(bytes); });
  if (!done) return done;
  if (auto finished = video->finish(); !finished) return finished;
  announce(*file, lengthText(job.times.size(), fps));
  return {};
}

/// The palette for a film, from a few frames spread over it.
Result<GifPalette> paletteOf(const FrameJob& job) {
  FrameJob samples = job;
  samples.times.clear();
  const std::size_t count = std::min(kPaletteSamples, job.times.size());
  for (std::size_t i = 0; i < count; ++i) samples.times.push_back(job.times[i * job.times.size() / count]);
  std::vector<Canvas> canvases;
  ReplayDirector director(*job.timeline, job.overlays);
  for (const double seconds : samples.times) {
    auto canvas = job.picture->canvas();
    if (!canvas) return tl::unexpected<Error>(canvas.error());
    const ReplayMoment moment = job.timeline->at(seconds);
    MatchOverlays overlays;
    director.direct(moment, overlays);
    // Not every sample shows the banner, but its colours must be in the palette.
    if (overlays.banner.title.empty()) overlays.banner = {"Goal!", "Penalty", TeamId::kBlue};
    job.picture->drawFrame(*canvas, moment, overlays);
    canvases.push_back(std::move(*canvas));
  }
  std::vector<const Canvas*> all;
  all.reserve(canvases.size());
  for (const Canvas& canvas : canvases) all.push_back(&canvas);
  return GifPalette(all);
}

/// Number of parts of a film from which its size is estimated, and frames per part.
constexpr std::size_t kStretches = 3, kStretch = 8;

/// The frames of a job as a GIF. `shown`: whether to show a progress bar.
Result<std::string> gifOf(const FrameJob& job, const GifPalette& palette, int delay, bool shown) {
  auto gif = GifWriter::create(job.picture->spec().width, job.picture->spec().height, palette, delay);
  if (!gif) return tl::unexpected<Error>(gif.error());
  const auto packer = [&palette] {
    return [indexer = GifIndexer(palette)](Canvas& canvas, std::string& out) mutable {
      indexer.index(canvas, out);
    };
  };
  const FrameSink add = [&](std::size_t, std::string& bytes) { return gif->add(bytes); };
  if (auto done = shown ? film(job, "gif", packer, add) : forEachFrame(job, packer, add); !done) {
    return tl::unexpected<Error>(done.error());
  }
  return gif->finish();
}

/// Prints the estimated size of a long GIF, and how to make a shorter one.
Result<void> noteWeight(const ExportRequest& request, const FrameJob& job, const GifPalette& palette,
                        int delay) {
  const std::size_t frames = job.times.size();
  const double fps = 100.0 / delay;
  if (static_cast<double>(frames) <= kPatience * fps) return {};
  double first = 0.0, all = 0.0;  // bytes of a first frame, and of a whole part
  for (std::size_t i = 0; i < kStretches; ++i) {
    FrameJob stretch = job;
    const auto begin =
        job.times.begin() + static_cast<std::ptrdiff_t>((2 * i + 1) * frames / (2 * kStretches));
    for (const std::size_t length : {std::size_t{1}, kStretch + 1}) {
      stretch.times.assign(begin, begin + static_cast<std::ptrdiff_t>(length));
      const auto bytes = gifOf(stretch, palette, delay, false);
      if (!bytes) return tl::unexpected<Error>(bytes.error());
      (length == 1 ? first : all) += static_cast<double>(bytes->size()) / kStretches;
    }
  }
  const double bytes = first + (all - first) / kStretch * static_cast<double>(frames - 1);
  const auto events = request.timeline.events();
  const bool goals = std::any_of(events.begin(), events.end(),
                                 [](const RecordedEvent& event) { return event.clause == "goal"; });
  note("--gif: {}, about {:.1f} MB; {} shows less\n", lengthText(frames, fps), bytes / 1e6,
       goals ? "--around goals:1, or --from and --to," : "--from and --to");
  return {};
}

}  // namespace

Result<void> exportMp4(const ExportRequest& request) {
  return exportVideo(request, VideoFormat::kMp4, *request.options->mp4);
}

Result<void> exportWebm(const ExportRequest& request) {
  return exportVideo(request, VideoFormat::kWebm, *request.options->webm);
}

Result<void> exportGif(const ExportRequest& request) {
  const auto file = outputFile(request, {"--gif", OutputKind::kGif, *request.options->gif}, ".gif");
  if (!file) return tl::unexpected<Error>(file.error());
  // The delay of GIF frames is a whole number of hundredths of a second.
  const int delay =
      std::max(2, static_cast<int>(std::floor(100.0 / request.options->fps.value_or(kGifFps) + 0.5)));
  const double fps = 100.0 / delay;
  const auto picture = MatchPicture::create(request.specOf(kGifWidth));
  if (!picture) return tl::unexpected<Error>(picture.error());
  const FrameJob job = jobOf(request, *picture, fps);
  const auto palette = paletteOf(job);
  if (!palette) return tl::unexpected<Error>(palette.error());
  if (auto said = noteWeight(request, job, *palette, delay); !said) return said;
  const auto bytes = gifOf(job, *palette, delay, true);
  if (!bytes) return tl::unexpected<Error>(bytes.error());
  return deliver(*file, *bytes);
}

Result<void> exportCsv(const ExportRequest& request) {
  const auto file = outputFile(request, {"--csv", OutputKind::kCsv, *request.options->csv}, ".csv");
  if (!file) return tl::unexpected<Error>(file.error());
  std::string text;
  writeCsv(request.timeline, request.whole.from, request.whole.to,
           [&](const std::string& line) { text += line; });
  return deliver(*file, text);
}

Result<void> exportJsonLines(const ExportRequest& request) {
  const auto file =
      outputFile(request, {"--jsonl", OutputKind::kJsonLines, *request.options->jsonl}, ".jsonl");
  if (!file) return tl::unexpected<Error>(file.error());
  std::string text;
  writeJsonLines(request.timeline, request.whole.from, request.whole.to,
                 [&](const std::string& line) { text += line; });
  return deliver(*file, text);
}

}  // namespace fulbito::app
