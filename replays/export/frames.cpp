#include "replays/export/frames.hpp"

#include <algorithm>
#include <cmath>
#include <condition_variable>
#include <mutex>

#include "engine/core/system/worker_threads.hpp"

namespace fulbito {
namespace {

/// Number of finished pictures per thread that may wait for the sink.
constexpr std::size_t kAhead = 3;

/// Passes pictures from the drawing threads to the sink, in order.
class FrameQueue {
 public:
  FrameQueue(std::size_t count, std::size_t room) : count_(count), slots_(room) {}

  /// The next picture to draw, after waiting for room in the queue. Empty if all are drawn or drawing was
  /// stopped.
  std::optional<std::size_t> take() {
    std::unique_lock lock(mutex_);
    room_.wait(lock, [this] { return stopped_ || next_ >= count_ || next_ < sunk_ + slots_.size(); });
    if (stopped_ || next_ >= count_) return std::nullopt;
    return next_++;
  }
  std::string& bytes(std::size_t index) { return slots_[index % slots_.size()].bytes; }
  void drawn(std::size_t index) {
    const std::lock_guard lock(mutex_);
    slots_[index % slots_.size()].ready = true;
    ready_.notify_one();
  }
  void fail(Error error) {
    const std::lock_guard lock(mutex_);
    if (!error_) error_ = std::move(error);
    ready_.notify_one();
  }
  /// Waits until the picture is drawn. Errors: of the thread that draws it.
  Result<void> await(std::size_t index) {
    std::unique_lock lock(mutex_);
    Slot& slot = slots_[index % slots_.size()];
    ready_.wait(lock, [&] { return error_ || slot.ready; });
    if (error_) return tl::unexpected<Error>(*error_);
    return {};
  }
  void sunk(std::size_t index) {
    const std::lock_guard lock(mutex_);
    slots_[index % slots_.size()].ready = false;
    sunk_ = index + 1;
    room_.notify_all();
  }
  void stop() {
    const std::lock_guard lock(mutex_);
    stopped_ = true;
    room_.notify_all();
  }

 private:
  struct Slot {
    std::string bytes;
    bool ready = false;
  };

  const std::size_t count_;
  std::vector<Slot> slots_;
  std::mutex mutex_;
  std::condition_variable room_, ready_;
  std::size_t next_ = 0, sunk_ = 0;
  bool stopped_ = false;
  std::optional<Error> error_;
};

/// Draws pictures one after the other and packs them.
class FramePainter {
 public:
  static Result<FramePainter> create(const FrameJob& job, FramePacker pack) {
    auto canvas = job.picture->canvas();
    if (!canvas) return tl::unexpected<Error>(canvas.error());
    return FramePainter(job, std::move(pack), std::move(*canvas));
  }
  void draw(std::size_t index, std::string& bytes) {
    job_->timeline->at(job_->times[index], moment_);
    director_.direct(moment_, overlays_);
    job_->picture->drawFrame(canvas_, moment_, overlays_);
    pack_(canvas_, bytes);
  }

 private:
  FramePainter(const FrameJob& job, FramePacker pack, Canvas canvas)
      : job_(&job),
        pack_(std::move(pack)),
        canvas_(std::move(canvas)),
        director_(*job.timeline, job.overlays) {}

  const FrameJob* job_;
  FramePacker pack_;
  Canvas canvas_;
  ReplayDirector director_;
  ReplayMoment moment_;
  MatchOverlays overlays_;
};

/// The loop of a drawing thread. It reports any failure to the queue, so that nobody waits forever.
void drawFrames(const FrameJob& job, const std::function<FramePacker()>& make_packer, FrameQueue& queue) {
  try {
    auto painter = FramePainter::create(job, make_packer());
    if (!painter) return queue.fail(painter.error());
    while (const auto index = queue.take()) {
      painter->draw(*index, queue.bytes(*index));
      queue.drawn(*index);
    }
  } catch (...) {
    queue.fail({ErrorCode::kIo, "cannot draw a picture"});
    throw;
  }
}

/// Draws in the thread of the sink, without other threads.
Result<void> drawAndSink(const FrameJob& job, const std::function<FramePacker()>& make_packer,
                         const FrameSink& sink) {
  auto painter = FramePainter::create(job, make_packer());
  if (!painter) return tl::unexpected<Error>(painter.error());
  std::string bytes;
  for (std::size_t i = 0; i < job.times.size(); ++i) {
    painter->draw(i, bytes);
    if (auto taken = sink(i, bytes); !taken) return taken;
  }
  return {};
}

/// Stops the drawing threads at the end of the scope, also when the sink throws.
class StopAtEnd {
 public:
  explicit StopAtEnd(FrameQueue& queue) : queue_(queue) {}
  StopAtEnd(const StopAtEnd&) = delete;
  StopAtEnd& operator=(const StopAtEnd&) = delete;
  ~StopAtEnd() { queue_.stop(); }

 private:
  FrameQueue& queue_;
};

Result<void> sinkAll(std::size_t count, FrameQueue& queue, const FrameSink& sink) {
  for (std::size_t i = 0; i < count; ++i) {
    if (auto drawn = queue.await(i); !drawn) return drawn;
    if (auto taken = sink(i, queue.bytes(i)); !taken) return taken;
    queue.sunk(i);
  }
  return {};
}

}  // namespace

std::vector<double> filmTimes(std::vector<ReplayRange> ranges, double fps, double speed) {
  std::sort(ranges.begin(), ranges.end(),
            [](const ReplayRange& a, const ReplayRange& b) { return a.from < b.from; });
  std::vector<ReplayRange> joined;
  for (const ReplayRange& range : ranges) {
    if (!joined.empty() && range.from <= joined.back().to) {
      joined.back().to = std::max(joined.back().to, range.to);
    } else {
      joined.push_back(range);
    }
  }
  std::vector<double> times;
  const double step = speed / fps;
  for (const ReplayRange& range : joined) {
    const auto count = static_cast<std::int64_t>(std::floor((range.to - range.from) / step + 1e-6)) + 1;
    for (std::int64_t i = 0; i < count; ++i) times.push_back(range.from + static_cast<double>(i) * step);
  }
  return times;
}

std::vector<ReplayRange> rangesAround(const ReplayTimeline& timeline, const std::vector<Tick>& ticks,
                                      double before, double after) {
  std::vector<ReplayRange> ranges;
  ranges.reserve(ticks.size());
  for (const Tick tick : ticks) {
    const double middle = timeline.secondsAt(tick);
    ranges.push_back({std::max(0.0, middle - before), std::min(timeline.seconds(), middle + after)});
  }
  return ranges;
}

Result<void> forEachFrame(const FrameJob& job, const std::function<FramePacker()>& make_packer,
                          const FrameSink& sink) {
  const auto jobs = static_cast<std::size_t>(std::max(1, job.jobs));
  FrameQueue queue(job.times.size(), kAhead * jobs);
  Result<void> done;
  runBeside(
      static_cast<int>(jobs), [&] { drawFrames(job, make_packer, queue); },
      [&](int running) {
        const StopAtEnd stop(queue);
        done = running > 0 ? sinkAll(job.times.size(), queue, sink) : drawAndSink(job, make_packer, sink);
      });
  return done;
}

}  // namespace fulbito
