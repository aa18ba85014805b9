#include "replays/verify/copy_plays.hpp"

namespace fulbito {
namespace {

/// The tick after which an event is written. A "placement" belongs to the play that begins at its tick, so it
/// is written after that play's first tick. All other events ended the play before.
Tick dueAt(const RecordedEvent& event) { return event.tick + (event.clause == "placement" ? 1 : 0); }

}  // namespace

void PlayCopier::chunkBegins(const RecordedChunk& chunk) {
  for (const RecordedEvent& event : chunk.events) events_[dueAt(event)].push_back(event);
  drawings_.insert(drawings_.end(), chunk.drawings.begin(), chunk.drawings.end());
}

bool PlayCopier::playBegins(const ReplayedPlay& play) {
  RecordedPlay copy = *play.recorded;
  // The first play has its recorded hash. After a gap, the copy's hash continues from the last copied play.
  if (plays_ == 0) hash_ = StateHash(copy.hash);
  copy.hash = hash_.value();
  writer_.beginPlay(copy);
  ++plays_;
  const Tick began = play.recorded->tick;
  shift_ = writer_.tick() - began;
  events_.erase(events_.begin(), events_.upper_bound(began));
  std::erase_if(drawings_, [began](const RecordedDrawing& d) { return d.tick <= began; });
  return true;
}

bool PlayCopier::ticked(const ReplayedTick& tick) {
  if (!asRecorded(tick)) {
    differs_ = tick.tick;
    return false;
  }
  hash_.add(*tick.state);
  writer_.add(RecordingTick{tick.state, tick.commands, hash_.value(), tick.chunk->playing[tick.row] != 0});
  pass(tick.tick);
  return true;
}

void PlayCopier::pass(Tick until) {
  const auto end = events_.upper_bound(until);
  for (auto due = events_.begin(); due != end; ++due) {
    for (RecordedEvent& event : due->second) {
      event.tick += shift_;
      writer_.add(event);
    }
  }
  events_.erase(events_.begin(), end);
  for (; !drawings_.empty() && drawings_.front().tick <= until; drawings_.pop_front()) {
    drawings_.front().tick += shift_;
    writer_.add(drawings_.front());
  }
}

Result<void> PlayCopier::finish(RecordingResult result) {
  result.final_hash = hash_.value();
  return writer_.finish(result);
}

}  // namespace fulbito
