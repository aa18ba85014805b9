#pragma once

#include <memory>
#include <string>

#include "fulbito/detail/values.hpp"

namespace fulbito {

enum class VideoFormat { kMp4, kWebm };

struct VideoSettings {
  VideoFormat format = VideoFormat::kMp4;
  int width = 0;   ///< [px] even
  int height = 0;  ///< [px] even
  double fps = 30.0;
  int quality = 22;  ///< on the scale of x264: 0 (best) ... 51
};

/// A video that ffmpeg encodes from frames on a pipe, as a child process in its own process group. The file
/// appears under its name when it is complete; an unfinished file is removed.
class VideoPipe {
 public:
  /// If `file` is "-", the video goes to stdout. Errors: kIo if ffmpeg is missing or cannot be started; as
  /// `OutputFile::create`.
  static Result<VideoPipe> open(const std::string& file, const VideoSettings& settings);
  VideoPipe(VideoPipe&&) noexcept;
  VideoPipe& operator=(VideoPipe&&) noexcept;
  ~VideoPipe();

  /// Writes a frame from `toYuv420`. Errors: kIo with ffmpeg's last message; kInterrupted if the process is
  /// asked to stop while waiting for ffmpeg.
  Result<void> write(const std::string& frame);
  /// Waits for ffmpeg and completes the file. Errors: as `write`.
  Result<void> finish();

 private:
  struct Impl;
  explicit VideoPipe(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace fulbito
