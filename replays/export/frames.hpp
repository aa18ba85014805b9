#pragma once

#include <functional>
#include <string>
#include <vector>

#include "fulbito/picture.hpp"

namespace fulbito {

/// A time range of a recording [s].
struct ReplayRange {
  double from = 0.0;
  double to = 0.0;
};

/// The recording times [s] of a film's frames: `fps` frames per second of film, `speed` seconds of the
/// recording per second of film. Ranges that touch or overlap are joined; each has at least one frame.
std::vector<double> filmTimes(std::vector<ReplayRange> ranges, double fps, double speed);

/// The time ranges around these ticks, clamped to the recording.
std::vector<ReplayRange> rangesAround(const ReplayTimeline& timeline, const std::vector<Tick>& ticks,
                                      double before, double after);

/// Pictures of one recording, drawn by several threads.
struct FrameJob {
  const ReplayTimeline* timeline = nullptr;
  const MatchPicture* picture = nullptr;
  OverlayChoice overlays;
  std::vector<double> times;  ///< recording times of the pictures [s]
  int jobs = 1;               ///< number of drawing threads
};

/// Encodes a picture in the thread that drew it, reusing the string's memory.
using FramePacker = std::function<void(Canvas&, std::string&)>;
/// Receives each picture's bytes in order of time, in the caller's thread. An error stops all.
using FrameSink = std::function<Result<void>(std::size_t, std::string&)>;

/// Draws all pictures. Each thread gets its own packer from `make_packer`, which may keep memory.
/// Errors: as Canvas::create; the sink's.
Result<void> forEachFrame(const FrameJob& job, const std::function<FramePacker()>& make_packer,
                          const FrameSink& sink);

}  // namespace fulbito
