#include "replays/export/video_pipe.hpp"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <optional>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

#include <fmt/format.h>

#include "engine/core/system/io_code.hpp"
#include "engine/core/system/output_file.hpp"
#include "engine/core/system/stop_request.hpp"
#include "engine/core/system/unfinished_work.hpp"

namespace fulbito {
namespace {

constexpr std::size_t kMostSaid = 4000;  // [bytes] longest part of ffmpeg's messages in an error

std::vector<std::string> codecWords(const VideoSettings& settings) {
  const std::string quality = std::to_string(settings.quality);
  if (settings.format == VideoFormat::kMp4) {
    return {"-c:v", "libx264", "-preset", "veryfast", "-crf", quality, "-pix_fmt", "yuv420p"};
  }
  return {"-c:v",      "libvpx-vp9", "-crf",      std::to_string(settings.quality + 9),
          "-b:v",      "0",          "-deadline", "realtime",
          "-cpu-used", "8",          "-row-mt",   "1",
          "-pix_fmt",  "yuv420p"};
}

/// Arguments of ffmpeg. `stream`: the output cannot seek, so the index cannot be written at its start.
std::vector<std::string> ffmpegWords(const std::string& out, bool stream, const VideoSettings& settings) {
  std::vector<std::string> words{"ffmpeg",       "-hide_banner",
                                 "-loglevel",    "error",
                                 "-nostdin",     "-y",
                                 "-f",           "rawvideo",
                                 "-pix_fmt",     "yuv420p",
                                 "-color_range", "tv",
                                 "-s",           fmt::format("{}x{}", settings.width, settings.height),
                                 "-framerate",   fmt::format("{}", settings.fps),
                                 "-i",           "pipe:0",
                                 "-an"};
  for (std::string& word : codecWords(settings)) words.push_back(std::move(word));
  for (const char* word : {"-color_primaries", "bt709", "-color_trc", "bt709", "-colorspace", "bt709"}) {
    words.emplace_back(word);
  }
  const bool mp4 = settings.format == VideoFormat::kMp4;
  if (mp4) words.insert(words.end(), {"-movflags", stream ? "frag_keyframe+empty_moov" : "+faststart"});
  words.insert(words.end(), {"-f", mp4 ? "mp4" : "webm", out == "-" ? "pipe:1" : "file:" + out});
  return words;
}

/// A temporary file that disappears when it is closed. Returns its descriptor.
int temporaryFile() {
  std::FILE* file = std::tmpfile();
  if (file == nullptr) return -1;
  const int descriptor = ::fcntl(::fileno(file), F_DUPFD_CLOEXEC, 3);
  std::fclose(file);
  return descriptor;
}

}  // namespace

struct VideoPipe::Impl {
  Impl() = default;
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;
  ~Impl();

  Result<void> start(const VideoSettings& settings);
  Error complaint(const std::string& what) const;
  /// Waits for ffmpeg once. Returns its exit status, or -1 if there is none. Errors: kInterrupted if this
  /// process is asked to stop while it waits.
  Result<int> wait();
  void kill();

  std::string file;
  std::optional<OutputFile> out;  ///< empty: the video goes to stdout
  pid_t child = -1;
  int in = -1;    ///< pipe to ffmpeg's stdin
  int said = -1;  ///< ffmpeg's stderr: a temporary file without a name
};

VideoPipe::Impl::~Impl() {
  if (in >= 0) ::close(in);
  if (child > 0) kill();
  if (said >= 0) ::close(said);
}

void VideoPipe::Impl::kill() {
  ::kill(child, SIGKILL);
  while (::waitpid(child, nullptr, 0) < 0 && errno == EINTR) {
  }
  child = -1;
  setHelperProcess(0);
}

Result<int> VideoPipe::Impl::wait() {
  int status = -1;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
    if (stopRequested()) return fail(ErrorCode::kInterrupted, "interrupted");
  }
  child = -1;
  setHelperProcess(0);
  return status;
}

Result<void> VideoPipe::Impl::start(const VideoSettings& settings) {
  std::array<int, 2> ends{};
  said = temporaryFile();
  if (said < 0 || ::pipe2(ends.data(), O_CLOEXEC) != 0) {
    const int reason = errno;
    return fail(ioCode(reason), fmt::format("cannot start ffmpeg: {}", std::strerror(reason)));
  }
  in = ends[1];
  posix_spawn_file_actions_t actions;
  posix_spawnattr_t attributes;
  posix_spawn_file_actions_init(&actions);
  posix_spawnattr_init(&attributes);
  posix_spawn_file_actions_adddup2(&actions, ends[0], STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, said, STDERR_FILENO);
  // Own process group and default signals: Ctrl-C reaches only this program, which then ends ffmpeg and
  // removes its file. Signals ignored here (SIGPIPE) must not be ignored by ffmpeg.
  sigset_t defaults;
  sigemptyset(&defaults);
  sigaddset(&defaults, SIGPIPE);
  posix_spawnattr_setsigdefault(&attributes, &defaults);
  posix_spawnattr_setpgroup(&attributes, 0);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGDEF);
  std::vector<std::string> words = ffmpegWords(out ? out->place() : file, !out || out->isStream(), settings);
  std::vector<char*> argv;
  argv.reserve(words.size() + 1);
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  const int wrong = ::posix_spawnp(&child, "ffmpeg", &actions, &attributes, argv.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  posix_spawnattr_destroy(&attributes);
  ::close(ends[0]);
  if (wrong == 0) {
    setHelperProcess(child);
    return {};
  }
  child = -1;
  if (wrong == ENOENT) {
    return fail(
        ErrorCode::kIo,
        "videos need ffmpeg, which is not installed (apt-get install ffmpeg); --gif works without it");
  }
  return fail(ioCode(wrong), fmt::format("cannot start ffmpeg: {}", std::strerror(wrong)));
}

Error VideoPipe::Impl::complaint(const std::string& what) const {
  std::string text(kMostSaid, '\0');
  const ssize_t size = ::pread(said, text.data(), text.size(), 0);
  text.resize(size > 0 ? static_cast<std::size_t>(size) : 0);
  while (!text.empty() && text.back() == '\n') text.pop_back();
  const std::size_t line = text.rfind('\n');
  if (line != std::string::npos) text.erase(0, line + 1);
  return {ErrorCode::kIo, fmt::format("cannot write {}: {}", file, text.empty() ? what : "ffmpeg: " + text)};
}

VideoPipe::VideoPipe(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
VideoPipe::VideoPipe(VideoPipe&&) noexcept = default;
VideoPipe& VideoPipe::operator=(VideoPipe&&) noexcept = default;
VideoPipe::~VideoPipe() = default;

Result<VideoPipe> VideoPipe::open(const std::string& file, const VideoSettings& settings) {
  auto impl = std::make_unique<Impl>();
  impl->file = file;
  if (file != "-") {
    auto out = OutputFile::create(file);
    if (!out) return tl::unexpected<Error>(out.error());
    impl->out.emplace(std::move(*out));
  }
  if (auto started = impl->start(settings); !started) return tl::unexpected<Error>(started.error());
  return VideoPipe(std::move(impl));
}

Result<void> VideoPipe::write(const std::string& frame) {
  std::size_t written = 0;
  while (written < frame.size()) {
    const ssize_t n = ::write(impl_->in, frame.data() + written, frame.size() - written);
    if (n < 0 && errno == EINTR && stopRequested()) return fail(ErrorCode::kInterrupted, "interrupted");
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) {
      if (impl_->child > 0) {
        if (const auto ended = impl_->wait(); !ended) return tl::unexpected<Error>(ended.error());
      }
      return tl::unexpected<Error>(impl_->complaint("ffmpeg exited early"));
    }
    written += static_cast<std::size_t>(n);
  }
  return {};
}

Result<void> VideoPipe::finish() {
  ::close(impl_->in);
  impl_->in = -1;
  const auto status = impl_->wait();
  if (!status) return tl::unexpected<Error>(status.error());
  if (!WIFEXITED(*status) || WEXITSTATUS(*status) != 0) {
    return tl::unexpected<Error>(impl_->complaint("ffmpeg failed"));
  }
  return impl_->out ? impl_->out->commit() : Result<void>();
}

}  // namespace fulbito
