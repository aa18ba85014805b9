#include "replays/verify/expand.hpp"

#include <deque>
#include <limits>

#include <fmt/format.h>

#include "fulbito/recording.hpp"
#include "replays/verify/resimulate.hpp"

namespace fulbito {
namespace {

RecordingHeader fullHeader(RecordingHeader header) {
  header.level = RecordingLevel::kFull;
  return header;
}

/// Writes the visited plays and ticks, and stops at the first that differs from the recording.
class Expander final : public ReplayVisitor {
 public:
  explicit Expander(RecordingWriter writer) : writer_(std::move(writer)) {}

  void chunkBegins(const RecordedChunk& chunk) override {
    events_.insert(events_.end(), chunk.events.begin(), chunk.events.end());
    drawings_.insert(drawings_.end(), chunk.drawings.begin(), chunk.drawings.end());
  }
  bool playBegins(const ReplayedPlay& play) override {
    if (play.number > 0 && play.hash != play.recorded->hash) return stop(play.recorded->tick);
    writer_.beginPlay(*play.recorded);
    return true;
  }
  bool ticked(const ReplayedTick& tick) override {
    if (!asRecorded(tick)) return stop(tick.tick);
    hash_ = tick.hash;
    writer_.add(RecordingTick{tick.state, tick.commands, tick.hash, tick.chunk->playing[tick.row] != 0});
    pass(events_, tick.tick);
    pass(drawings_, tick.tick);
    return true;
  }
  /// The first tick that differs, if any.
  const std::optional<Tick>& differs() const { return differs_; }
  /// Writes the remaining events and the result. If the recording was cut off, the result says that it was
  /// stopped.
  Result<void> finish(const std::optional<RecordingResult>& result) {
    pass(events_, kLastTick);
    pass(drawings_, kLastTick);
    return writer_.finish(result.value_or(RecordingResult{0, false, {}, hash_, "", {}}));
  }

 private:
  static constexpr Tick kLastTick = std::numeric_limits<Tick>::max();

  bool stop(Tick tick) {
    differs_ = tick;
    return false;
  }
  template <typename T>
  void pass(std::deque<T>& waiting, Tick tick) {
    for (; !waiting.empty() && waiting.front().tick <= tick; waiting.pop_front())
      writer_.add(waiting.front());
  }

  RecordingWriter writer_;
  std::deque<RecordedEvent> events_;
  std::deque<RecordedDrawing> drawings_;
  std::optional<Tick> differs_;
  std::uint64_t hash_ = 0;
};

}  // namespace

Result<RecordingReader> expanded(const RecordingReader& recipe) {
  if (recipe.header().level == RecordingLevel::kFull) {
    return RecordingReader::parse(std::string(recipe.bytes()), recipe.origin());
  }
  std::string bytes;
  auto writer = RecordingWriter::create(
      [&bytes](std::string_view more) -> Result<void> {
        bytes.append(more);
        return {};
      },
      fullHeader(recipe.header()));
  if (!writer) return tl::unexpected<Error>(writer.error());
  Expander expander(std::move(*writer));
  if (auto played = resimulate(recipe, expander); !played) return tl::unexpected<Error>(played.error());
  if (expander.differs()) {
    return fail(ErrorCode::kBadInput,
                fmt::format("{}: simulated again, it differs from tick {} on: see fulbito replay verify",
                            recipe.origin(), *expander.differs()));
  }
  if (auto finished = expander.finish(recipe.result()); !finished) {
    return tl::unexpected<Error>(finished.error());
  }
  return RecordingReader::parse(std::move(bytes), recipe.origin());
}

}  // namespace fulbito
