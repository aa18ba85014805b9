#pragma once

#include <functional>
#include <string>
#include <vector>

#include "replays/render/match/match_picture.hpp"
#include "replays/render/match/replay_scene.hpp"

namespace fulbito {

/// A stretch of a recording [s].
struct ReplayRange {
  double from = 0.0;
  double to = 0.0;
};

/// The times [s] of a film's frames: `fps` a second of film, `speed` seconds of the recording a second of
/// film. Ranges that touch or overlap are played as one; each has at least one frame.
std::vector<double> filmTimes(std::vector<ReplayRange> ranges, double fps, double speed);

/// The stretches around each of some ticks, within the recording.
std::vector<ReplayRange> rangesAround(const ReplayTimeline& timeline, const std::vector<Tick>& ticks,
                                      double before, double after);

/// Pictures of one recording, to be drawn in some threads.
struct FrameJob {
  const ReplayTimeline* timeline = nullptr;
  const MatchPicture* picture = nullptr;
  OverlayChoice overlays;
  std::vector<double> times;  ///< [s]
  int jobs = 1;               ///< threads that draw
};

/// Makes bytes of a picture, in the thread that drew it; the string's memory is used again.
using FramePacker = std::function<void(Canvas&, std::string&)>;
/// Takes each picture's bytes in the order of the times, in the caller's thread. An error ends all.
using FrameSink = std::function<Result<void>(std::size_t, std::string&)>;

/// Draws all. A thread's packer is made by `make_packer`, so that it may keep memory of its own.
/// Errors: as Canvas::create; the sink's.
Result<void> forEachFrame(const FrameJob& job, const std::function<FramePacker()>& make_packer,
                          const FrameSink& sink);

}  // namespace fulbito
