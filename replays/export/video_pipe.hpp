#pragma once

#include <memory>
#include <string>

#include "engine/core/base/result.hpp"

namespace fulbito {

enum class VideoFormat { kMp4, kWebm };

struct VideoSettings {
  VideoFormat format = VideoFormat::kMp4;
  int width = 0;   ///< [px] even
  int height = 0;  ///< [px] even
  double fps = 30.0;
  int quality = 22;  ///< as x264's: 0 (best) ... 51
};

/// A video that ffmpeg, as a child of its own process group, makes of frames on a pipe. The file appears
/// under its name when it is complete; whatever ends this object before removes what there was of it.
class VideoPipe {
 public:
  /// `file` "-" is stdout. Errors: kIo: there is no ffmpeg, or it cannot be started; as OutputFile::create.
  static Result<VideoPipe> open(const std::string& file, const VideoSettings& settings);
  VideoPipe(VideoPipe&&) noexcept;
  VideoPipe& operator=(VideoPipe&&) noexcept;
  ~VideoPipe();

  /// A frame as `toYuv420` gives it. Errors: kIo with what ffmpeg said last; kInterrupted where ffmpeg is
  /// waited for when all work shall end.
  Result<void> write(const std::string& frame);
  /// Waits for ffmpeg and gives the file its name. Errors: as `write`.
  Result<void> finish();

 private:
  struct Impl;
  explicit VideoPipe(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace fulbito
